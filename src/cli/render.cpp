// SPDX-License-Identifier: Apache-2.0
// glint render: renders a scene to a picture file.
#include <fmt/format.h>

#include <memory>

#include "base/text.h"
#include "cli/clock.h"
#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/half_blocks.h"
#include "cli/journal_header.h"
#include "cli/layer_files.h"
#include "cli/output_plan.h"
#include "cli/picture_endings.h"
#include "cli/progress.h"
#include "cli/render_arguments.h"
#include "cli/render_output.h"
#include "cli/render_report.h"
#include "cli/submissions.h"
#include "cli/text.h"
#include "os/files.h"
#include "os/process.h"
#include "world/prepare.h"

namespace glint::cli {
namespace {

constexpr auto k_render_examples = R"(Examples:
  glint render castle.json                              castle.png in the current folder
  glint render spheres.cgfs lights.cgfs -s 600x600      two listings as one scene
  glint render castle.json -o castle.exr --aa 3         9 samples per pixel, linear floats
  glint render castle.json --shading phong --no-shadows --reflections 0
  glint render castle.json -o castle.exr --aov all      normals, depth, shadows ... as parts of the file
  glint render molecule.glint --alpha                   a transparent background
  glint render castle.json --crop 100x80+320+200        a part, as in the whole picture
  glint render castle.json --convention limit=drop      one convention changed
  glint render - --format cgfs -o - < a.cgfs > a.png    from standard input to standard output
  glint render castle.json --resume                     continues an interrupted run
  glint render castle.json --part 2/4 -o 2.tiles        a quarter of the tiles, for `glint join`
  glint render castle.json --show                       also show it in the terminal)";

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

std::span<const std::uint8_t> bytes_of(const std::string& text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
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

// The world of a scene whose warnings are printed. Throws Failure.
World prepare_scene(RenderArguments& arguments, LoadedScene& loaded) {
    Result<World> prepared = prepare(loaded.scene, {.threads = arguments.threads});
    add_warnings(loaded.warnings, prepared.diagnostics);
    const std::size_t warnings = count_warnings(loaded.warnings);
    const bool refused = arguments.strict && warnings > 0;
    if (!(arguments.quiet || arguments.hides_warnings) || !prepared || refused) print(loaded.warnings);
    if (!prepared) throw_failure(prepared);
    if (refused) fail_strict(warnings);
    return *std::move(prepared);
}

int render_command(RenderArguments& arguments, const RenderHooks& hooks) {
    const auto start = Clock::now();
    check_scenes(arguments.scene);
    parse_layers(arguments.aov, nullptr);  // wrong names are reported before the scene is read
    RenderOptions options;
    options.threads = arguments.threads;
    options.isa = arguments.isa;
    std::optional<OutputRequest> request;
    if (hooks.is_writer) {
        request = request_output(arguments);
    } else {
        arguments.quiet = true;
    }
    check_isa(arguments.isa);
    add_settings(arguments.picture, PictureMemory::rows, arguments.scene);

    Times times;
    TextReader disk;
    LoadedScene loaded = load_scene(arguments.scene, hooks.reader != nullptr ? *hooks.reader : disk);
    times.load = seconds_since(start);
    options.layers = parse_layers(arguments.aov, &*loaded.scene);
    if (loaded.scene->settings.alpha) put_alpha_last(options.layers);
    options.crop = crop_of(arguments, loaded.scene->settings);
    const Crop area =
        options.crop ? *options.crop : Crop{loaded.scene->settings.width, loaded.scene->settings.height};
    std::optional<OutputPlan> plan;
    if (request) {
        plan.emplace(plan_output(*std::move(request), arguments, loaded, area, options.layers,
                                 static_cast<bool>(hooks.render)));
    }
    if (hooks.loaded) hooks.loaded();

    auto stage = Clock::now();
    const World world = prepare_scene(arguments, loaded);
    times.prepare = seconds_since(stage);

    if (!plan) {
        const JournalHeader header = journal_header(arguments.scene, loaded, area, options.layers);
        const Result<Rendering> helped = hooks.render(world, std::move(options), header, nullptr);
        if (!helped) throw_failure(helped);
        return k_done;
    }

    const std::unique_ptr<RenderOutput> output = open_output(*plan);
    if (output == nullptr) return k_done;
    stage = Clock::now();
    Rendering result = [&] {
        ProgressBar bar(!arguments.quiet);
        options.progress = [&](double fraction) { bar.update(fraction); };
        Result<Rendering> rendering = output->render(world, std::move(options), hooks);
        if (!rendering) throw_failure(rendering);
        return *std::move(rendering);
    }();
    times.trace = seconds_since(stage);
    report_cut_rays(arguments, result.rays);

    times.encode = output->write(result);
    if (plan->stats) plan->stats->write(bytes_of(stats_text(result, times)));
    if (arguments.show)
        fmt::print("{}", half_blocks(result.image, os::terminal_columns(os::k_standard_output),
                                     plan->picture->rule()));
    print_result(arguments, plan->path, plan->size_text(), result, times, seconds_since(start),
                 loaded.warnings);
    return k_done;
}

}  // namespace

Run add_render(CLI::App& app, const RenderHooks& hooks) {
    CLI::App& command = *app.add_subcommand("render", "Render a scene");
    const auto arguments = std::make_shared<RenderArguments>();
    RenderArguments& a = *arguments;
    add_scene_arguments(command, a.scene);
    command
        .add_option(
            "-o,--output", a.output,
            fmt::format(
                "The picture: {}; - is standard output (PNG). Default: SCENE's name with .png, in the "
                "current folder",
                k_picture_endings_text))
        ->option_text("OUT");
    add_picture_arguments(command, a.picture);
    add_alpha_argument(command, a.picture);
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
    command.add_flag(
        "--resume", a.resume,
        "Keep finished tiles in OUT.journal, and go on with it if it is there; it is removed when "
        "the picture is written");
    command
        .add_option("--part", a.part,
                    "Render only every Nth tile, beginning with the Kth, to OUT.tiles; `glint join` makes a "
                    "picture of all parts")
        ->option_text("K/N");
    command.add_option("--stats", a.stats, "Write times, rays and memory as JSON")->option_text("FILE.json");
    command.add_flag("--strict", a.strict,
                     "Treat warnings as errors: exit code 1, and no picture is written");
    command.add_flag("--show", a.show, "Also show the picture in the terminal, in 24-bit colors");
    command.add_flag("-q,--quiet", a.quiet, "Print only errors");
    command.footer(k_render_examples);
    return [arguments, &hooks] { return render_command(*arguments, hooks); };
}

int render_picture(RenderArguments& arguments) {
    static const RenderHooks none;
    return render_command(arguments, none);
}

Run add_render(CLI::App& app) {
    static const RenderHooks none;
    return add_render(app, none);
}

}  // namespace glint::cli
