// SPDX-License-Identifier: Apache-2.0
// glint render: renders a scene to a picture file.
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/half_blocks.h"
#include "cli/layer_files.h"
#include "cli/output_file.h"
#include "cli/picture_arguments.h"
#include "cli/print_error.h"
#include "cli/progress.h"
#include "cli/scene_arguments.h"
#include "cli/submissions.h"
#include "cli/terminal.h"
#include "cli/text.h"

namespace glint::cli {
namespace {

constexpr auto k_examples = R"(Examples:
  glint render castle.json                              castle.png in the current folder
  glint render spheres.cgfs lights.cgfs -s 600x600      two listings as one scene
  glint render castle.json -o castle.exr --aa 3         9 samples per pixel, linear floats
  glint render castle.json --shading phong --no-shadows --reflections 0
  glint render castle.json -o castle.exr --aov all      normals, depth, shadows ... as parts of the file
  glint render castle.json --crop 100x80+320+200        a part, as in the whole picture
  glint render castle.json --convention limit=drop      one convention changed
  glint render - --format cgfs -o - < a.cgfs > a.png    from standard input to standard output
  glint render castle.json --show                       also show it in the terminal)";

struct RenderArguments {
    SceneArguments scene;
    PictureArguments picture;
    NumberArguments numbers;
    std::optional<std::string> aov;
    std::string output, crop, isa, stats;
    bool strict = false, show = false, quiet = false;
    int threads = 0;
};

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Times {
    double load = 0, prepare = 0, trace = 0, encode = 0;
};

FileFormat format_of(const std::string& path, const OutputFile& output) {
    const std::string ending = extension(path);
    if (ending == ".png") return FileFormat::png;
    if (ending == ".ppm") return FileFormat::ppm;
    if (ending == ".exr") return FileFormat::exr;
    if (output.is_stream()) return FileFormat::png;
    throw Failure(k_usage, fmt::format("--output '{}': glint writes .png, .ppm and .exr", path));
}

std::string default_output(const std::string& scene_file) {
    return scene_file == "-" ? "picture.png" : stem(scene_file) + ".png";
}

std::optional<Crop> crop_of(const RenderArguments& arguments, const RenderSettings& settings) {
    if (arguments.crop.empty()) return std::nullopt;
    const auto crop = parse_crop(arguments.crop);
    if (!crop) {
        throw Failure(k_usage,
                      fmt::format("--crop: expected WxH+X+Y, as 320x240+10+20, found '{}'", arguments.crop));
    }
    if (crop->width > settings.width - crop->x || crop->height > settings.height - crop->y) {
        throw Failure(k_usage, fmt::format("--crop {}: the picture has only {}x{} pixels", arguments.crop,
                                           settings.width, settings.height));
    }
    return crop;
}

std::string stats_text(const Rendering& rendering, const Times& times) {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    nlohmann::ordered_json stats = {
        {"load_s", times.load},
        {"prepare_s", times.prepare},
        {"trace_s", times.trace},
        {"encode_s", times.encode},
        {"threads", rendering.threads},
        {"isa", rendering.isa},
        {"rays",
         {{"camera", rendering.rays.camera},
          {"shadow", rendering.rays.shadow},
          {"mirror", rendering.rays.mirror},
          {"transmitted", rendering.rays.transmitted},
          {"cut", rendering.rays.cut}}},
        {"peak_rss_bytes", std::uint64_t(usage.ru_maxrss) * 1024},
    };
    return stats.dump(2) + "\n";
}

std::span<const std::uint8_t> bytes_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

[[noreturn]] void fail_strict(std::size_t warnings) {
    throw Failure(k_bad_input,
                  fmt::format("--strict: {}, so no picture is written", counted(warnings, "warning")));
}

// Detects `glint render castle.json out.png`, where a picture is given as a scene.
void check_scenes(const SceneArguments& scene) {
    if (!scene.format.empty()) return;  // with --format, any file name is possible
    std::vector<std::string> scenes = scene.files, pictures;
    std::erase_if(scenes, [&](const std::string& file) {
        if (is_picture_name(file)) pictures.push_back(file);
        return is_picture_name(file);
    });
    if (pictures.empty()) return;
    if (scenes.empty()) scenes = {"SCENE"};
    throw Failure(k_usage,
                  fmt::format("{} is a picture, not a scene; -o names the output: glint "
                              "render {} -o {}",
                              glint::quoted(pictures.front()), fmt::join(scenes, " "), pictures.front()));
}

int render_command(RenderArguments& arguments) {
    const auto start = Clock::now();
    check_scenes(arguments.scene);
    const std::string path =
        arguments.output.empty() ? default_output(arguments.scene.files.front()) : arguments.output;
    const OutputFile output("--output", path);
    EncodeOptions encoding = encoding_of(arguments.numbers);
    encoding.format = format_of(path, output);
    encoding.threads = arguments.threads;
    if (output.is_standard_output()) {
        if (arguments.show)
            throw Failure(k_usage, "--show and the picture cannot both go to standard output");
        if (is_terminal(STDOUT_FILENO)) {
            throw Failure(k_usage, "standard output is a terminal: redirect it to a file, or use --show");
        }
    }
    std::optional<OutputFile> stats;
    if (!arguments.stats.empty()) stats.emplace("--stats", arguments.stats);
    check_isa(arguments.isa);
    const LayerFiles layers(arguments.aov, path, encoding.format, output.is_stream());
    add_settings(arguments.picture, arguments.crop.empty(), arguments.scene);

    Times times;
    LoadedScene loaded = load_scene(arguments.scene);
    times.load = seconds_since(start);
    RenderOptions options;
    options.crop = crop_of(arguments, loaded.scene.settings);
    const Crop rendered =
        options.crop ? *options.crop : Crop{loaded.scene.settings.width, loaded.scene.settings.height};
    check_memory(rendered.width, rendered.height, layers.bytes_a_pixel());

    auto stage = Clock::now();
    const Result<World> prepared = prepare(loaded.scene, {.threads = arguments.threads});
    times.prepare = seconds_since(stage);
    add_warnings(loaded.warnings, prepared.diagnostics);
    const std::size_t warnings = count_warnings(loaded.warnings);
    const bool refused = arguments.strict && warnings > 0;
    if (!arguments.quiet || !prepared || refused) print(loaded.warnings);
    if (!prepared) throw_failure(prepared);
    if (refused) fail_strict(warnings);

    stage = Clock::now();
    Result<Rendering> result;
    {
        ProgressBar bar(!arguments.quiet);
        options.threads = arguments.threads;
        options.isa = arguments.isa;
        options.layers = layers.wanted();
        options.progress = [&](double fraction) { bar.update(fraction); };
        result = render(*prepared, options);
    }
    times.trace = seconds_since(stage);
    if (!result) throw_failure(result);

    if (result->rays.cut > 0 && (!arguments.quiet || arguments.strict)) {
        print_error(
            "warning: {} mirror and glass rays were not traced: a sample of a pixel has at most {}; "
            "a lower --reflections or a higher min_weight omits the faintest first\n",
            with_commas(result->rays.cut), k_max_sample_rays);
        if (arguments.strict) fail_strict(1);
    }

    stage = Clock::now();
    const auto encoded = encoding.format == FileFormat::exr && !result->layers.empty()
                             ? encode_layers(result->image, result->layers)
                             : encode(result->image, encoding);
    times.encode = seconds_since(stage);
    if (!encoded) throw Failure(k_bad_input, fmt::format("cannot encode the picture: {}", encoded.message));
    output.write(*encoded);
    layers.write(result->layers, encoding);
    if (stats) stats->write(bytes_of(stats_text(*result, times)));
    if (arguments.show) {
        fmt::print("{}", half_blocks(result->image, terminal_columns(STDOUT_FILENO), encoding.transfer));
    }
    if (!arguments.quiet) {
        print_error("{}  {}x{}  {} rays  {:.3f} s  {:.1f} Mray/s  (total {:.3f} s, {}, {}, {})\n", path,
                    result->image.width, result->image.height, with_commas(result->rays.total()), times.trace,
                    static_cast<double>(result->rays.total()) / times.trace / 1e6, seconds_since(start),
                    counted(std::uint64_t(result->threads), "thread"), result->isa,
                    counted(warnings, "warning"));
    }
    return k_done;
}

}  // namespace

Run add_render(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("render", "Render a scene");
    const auto arguments = std::make_shared<RenderArguments>();
    RenderArguments& a = *arguments;
    add_scene_arguments(command, a.scene);
    command
        .add_option("-o,--output", a.output,
                    "The picture: .png, .ppm or .exr; - is standard output (PNG). Default: SCENE's name with "
                    ".png, in the "
                    "current folder")
        ->option_text("OUT");
    add_picture_arguments(command, a.picture);
    add_layer_argument(command, a.aov);
    command
        .add_option("--crop", a.crop, "Render only this part of the picture; X and Y count from the top left")
        ->option_text("WxH+X+Y");
    add_number_arguments(command, a.numbers);
    add_threads_argument(command, a.threads, ". The picture does not depend on it");
    command
        .add_option("--isa", a.isa,
                    "Instruction set (`glint info --isa` lists them). The picture does not depend on it")
        ->option_text("NAME");
    command.add_option("--stats", a.stats, "Write times, rays and memory as JSON")->option_text("FILE.json");
    command.add_flag("--strict", a.strict,
                     "Treat warnings as errors: exit code 1, and no picture is written");
    command.add_flag("--show", a.show, "Also show the picture in the terminal, in 24-bit colours");
    command.add_flag("-q,--quiet", a.quiet, "Print only errors");
    command.footer(k_examples);
    return [arguments] { return render_command(*arguments); };
}

}  // namespace glint::cli
