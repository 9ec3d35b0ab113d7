// SPDX-License-Identifier: Apache-2.0
// glint convert: converts a scene of any format to .glint.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
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
  glint convert gears.nff gears.glint --profile glint   the same shapes with glint's own conventions)";

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
            throw Failure(k_usage, "expected SCENE... and OUT.glint, or --output OUT.glint");
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

int convert_command(ConvertArguments& arguments) {
    take_output(arguments);
    const std::string& path = arguments.output;
    const OutputFile output("OUT", path);
    if (!output.is_stream() && extension(path) != ".glint")
        throw Failure(k_usage, fmt::format("OUT '{}': glint writes scenes as .glint only", path));
    const LoadedScene loaded = load_scene(arguments.scene);
    if (!arguments.quiet) print(loaded.warnings);
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
    const Result<std::string> written = write_glint(scene, texts, mesh_files);
    if (!written) throw_failure(written);
    const std::string& text = *written;
    output.write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    if (!arguments.quiet) {
        warn_of_size(arguments, loaded);
        print_error("{}  {}  {}, {}, {}  ({})\n", path, bytes_text(static_cast<double>(text.size())),
                    counted(scene.shapes.size(), "shape"), counted(scene.materials.size(), "material"),
                    counted(scene.lights.size(), "light"),
                    counted(count_warnings(loaded.warnings), "warning"));
    }
    return k_done;
}

}  // namespace

Run add_convert(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "convert", "Convert a scene of any format to .glint; its picture stays the same, bit for bit");
    const auto arguments = std::make_shared<ConvertArguments>();
    add_scene_arguments(command, arguments->scene);
    command.get_option("SCENE")->description(
        "Scene files, read together as one scene, then OUT.glint unless --output is given; - is standard "
        "input (needs --format)");
    command
        .add_option("-o,--output", arguments->output,
                    "The output file: a name that ends in .glint; - is standard output")
        ->option_text("OUT");
    command.add_flag("-q,--quiet", arguments->quiet, "Print only errors");
    command.footer(k_convert_examples);
    return [arguments] { return convert_command(*arguments); };
}

}  // namespace glint::cli
