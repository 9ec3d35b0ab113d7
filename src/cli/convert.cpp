// SPDX-License-Identifier: Apache-2.0
// glint convert: converts a scene of any format to .glint, or to another one that glint writes.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/mesh_files.h"
#include "cli/output_file.h"
#include "cli/print_error.h"
#include "cli/scene_arguments.h"
#include "cli/text.h"

namespace glint::cli {
namespace {

constexpr auto k_convert_examples = R"(Examples:
  glint convert castle.json castle.glint
  glint convert spheres.cgfs lights.cgfs both.glint     two listings as one scene
  glint convert castle.json -o - | less                 to standard output
  glint convert gears.nff gears.glint --profile glint   the same shapes with glint's own conventions
  glint convert castle.json castle.glb                  for Blender and other programs)";

constexpr std::string_view k_whole_format = "glint";  // the one that keeps all of a scene

// "OUT.glint|glb|gltf", ".glint, .glb or .gltf"
std::string out_names() {
    std::string names;
    for (const WrittenFormat& format : written_formats())
        names += fmt::format("{}{}", names.empty() ? "OUT." : "|", format.extension.substr(1));
    return names;
}
std::string endings() {
    std::string text;
    const auto all = written_formats();
    for (std::size_t i = 0; i < all.size(); ++i)
        text += fmt::format("{}{}", i == 0 ? "" : i + 1 < all.size() ? ", " : " or ", all[i].extension);
    return text;
}

// By the name of the output; standard output and devices are .glint.
std::string_view format_of(const OutputFile& output, const std::string& path) {
    if (output.is_stream()) return k_whole_format;
    for (const WrittenFormat& format : written_formats()) {
        if (format.extension == extension(path)) return format.name;
    }
    throw Failure(k_usage, fmt::format("OUT '{}': glint writes scenes as {} only", path, endings()));
}

struct ConvertArguments {
    SceneArguments scene;
    std::string output;
    bool quiet = false;
};

// Without -o the last file is OUT.
void take_output(ConvertArguments& arguments) {
    auto& files = arguments.scene.files;
    if (arguments.output.empty()) {
        if (files.size() < 2)
            throw Failure(k_usage, fmt::format("expected SCENE... and {0}, or --output {0}", out_names()));
        arguments.output = std::move(files.back());
        files.pop_back();
    }
}

// By the format of a file, or its name.
bool may_depend_on_size(std::string_view name) {
    return std::any_of(formats().begin(), formats().end(), [&](const FormatInfo& format) {
        return format.uses_size &&
               (name == fmt::format(".{}", format.name) || format.extensions == extension(name));
    });
}

// A scene may depend on the picture's size: the camera of Tachyon does, and what a scene of POV-Ray makes of
// image_width. A .glint file has no such rules, so it holds what they give for one size.
void warn_of_size(const ConvertArguments& arguments, const LoadedScene& loaded) {
    const Scene& scene = *loaded.scene;
    const bool may_depend = std::any_of(scene.files.begin(), scene.files.end(), may_depend_on_size) ||
                            may_depend_on_size("." + arguments.scene.format);
    if (!may_depend) return;
    const std::int32_t width = scene.settings.width, height = scene.settings.height;
    std::optional<Scene> other = load_with_size(arguments.scene, loaded, width, std::max(height / 2, 1));
    if (other) {
        other->settings.height = height;
        const Result<std::string> a = write_glint(scene), b = write_glint(*other);
        if (a && b && *a == *b) return;
    }
    print_error(
        "{}: warning: the scene depends on the picture's shape: the output is that for {}x{}. Render it at "
        "this size, or at one of the same shape\n",
        arguments.scene.files.front(), width, height);
}

// With the comments of its texts, and with the names of the files of its meshes and textures.
std::string to_glint(const ConvertArguments& arguments, const LoadedScene& loaded, const OutputFile& output) {
    const auto is_of_file = [](const Texture& texture) { return !texture.file.empty(); };
    std::optional<Scene> renamed;  // a copy only where needed: there may be millions of shapes
    if (!output.is_stream() &&
        std::any_of(loaded.scene->textures.begin(), loaded.scene->textures.end(), is_of_file))
        name_texture_files(renamed.emplace(*loaded.scene), output);
    const Scene& scene = renamed ? *renamed : *loaded.scene;
    std::vector<SceneText> texts = loaded.texts;
    const std::vector<InputFile> included = open_included(loaded, texts);
    const std::vector<std::string> mesh_files = output.is_stream()
                                                    ? known_mesh_files(scene, arguments.scene.format)
                                                    : write_mesh_files(scene, arguments.scene.format, output);
    Result<std::string> written = write_glint(scene, texts, mesh_files);
    if (!written) throw_failure(written);
    return std::move(*written);
}

int convert_command(ConvertArguments& arguments) {
    take_output(arguments);
    const std::string& path = arguments.output;
    const OutputFile output("OUT", path);
    const std::string_view format = format_of(output, path);
    const LoadedScene loaded = load_scene(arguments.scene);
    if (!arguments.quiet) print(loaded.warnings);
    const Scene& scene = *loaded.scene;
    std::string bytes;
    std::size_t warnings = count_warnings(loaded.warnings);
    if (format == k_whole_format) {
        bytes = to_glint(arguments, loaded, output);
    } else {
        Result<std::string> written = write_scene(scene, format);
        if (!written) throw_failure(written);
        bytes = std::move(*written);
        if (!arguments.quiet) print(written.diagnostics);
        warnings += count_warnings(written.diagnostics);
    }
    output.write({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    if (!arguments.quiet) {
        warn_of_size(arguments, loaded);
        print_error("{}  {}  {}, {}, {}  ({})\n", path, bytes_text(static_cast<double>(bytes.size())),
                    counted(scene.shapes.size(), "shape"), counted(scene.materials.size(), "material"),
                    counted(scene.lights.size(), "light"), counted(warnings, "warning"));
    }
    return k_done;
}

}  // namespace

Run add_convert(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "convert",
        "Convert a scene of any format to .glint, whose picture stays the same, bit for bit, or to glTF");
    const auto arguments = std::make_shared<ConvertArguments>();
    add_scene_arguments(command, arguments->scene);
    command.get_option("SCENE")->description(
        fmt::format("Scene files, read together as one scene, then {} unless --output is given; - is "
                    "standard input (needs --format)",
                    out_names()));
    command
        .add_option("-o,--output", arguments->output,
                    fmt::format("The output file: a name that ends in {}; - is standard output, as .glint",
                                endings()))
        ->option_text("OUT");
    command.add_flag("-q,--quiet", arguments->quiet, "Print only errors");
    command.footer(k_convert_examples);
    return [arguments] { return convert_command(*arguments); };
}

}  // namespace glint::cli
