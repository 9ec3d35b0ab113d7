// SPDX-License-Identifier: Apache-2.0
// glint explain: explains the color of a pixel.
#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "cli/explain_text.h"
#include "cli/failure.h"
#include "cli/light_argument.h"
#include "cli/output_file.h"
#include "cli/picture_arguments.h"
#include "cli/print_text.h"
#include "cli/render_or_fail.h"
#include "cli/scene_arguments.h"
#include "cli/text.h"
#include "cli/validators.h"
#include "world/prepare.h"

namespace glint::cli {
namespace {

constexpr auto k_explain_examples = R"(Examples:
  glint explain castle.json -p 320,200                        the pixel's rays, lights and sums
  glint explain castle.json -p 320,200 --why-not 2            why the second light adds nothing there
  glint explain castle.json -p 320,200 --overlay rays.png     the rays drawn over the picture
  glint explain castle.json -p 320,200 --as json | jq .value
  glint explain spheres.pov -p 315,185 --origin bottom-left --as printrays)";

struct ExplainArguments {
    SceneArguments scene;
    PictureArguments picture;
    NumberArguments numbers;
    double fold = k_default_fold;
    bool all = false;
    std::string pixel, sample, form = "text", origin = "top-left", why_not, overlay, isa;
};

// Parses a pair such as "320,200".
Pair parse_or_fail(std::string_view option, const std::string& text, std::string_view example) {
    const std::optional<Pair> pair = parse_pair(text);
    if (!pair) throw Failure(k_usage, fmt::format("{}: expected {}, found '{}'", option, example, text));
    return *pair;
}

Pair pixel_of(const ExplainArguments& arguments, const RenderSettings& settings) {
    Pair pixel = parse_or_fail("--pixel", arguments.pixel, "X,Y, as 320,200");
    const auto [x, y] = pixel;
    if (x < 0 || y < 0 || x >= settings.width || y >= settings.height) {
        throw Failure(k_usage,
                      fmt::format("--pixel {}: the picture has {}x{} pixels, the first is 0,0 at the {}",
                                  arguments.pixel, settings.width, settings.height, arguments.origin));
    }
    if (arguments.origin == "bottom-left") pixel.y = settings.height - 1 - y;
    return pixel;
}

int sample_of(const ExplainArguments& arguments, int n) {
    if (arguments.sample.empty()) return n / 2 * n + n / 2;
    const Pair sample = parse_or_fail("--sample", arguments.sample, "I,J, as 0,1");
    if (sample.x < 0 || sample.y < 0 || sample.x >= n || sample.y >= n)
        throw Failure(k_usage, fmt::format("--sample {}: a pixel has {}x{} samples, the first is 0,0",
                                           arguments.sample, n, n));
    return sample.y * n + sample.x;
}

int explain_command(ExplainArguments& arguments) {
    if (!arguments.why_not.empty() && arguments.form != "text")
        throw Failure(k_usage, fmt::format("--why-not prints text only, not {}", arguments.form));
    std::optional<OutputFile> overlay;
    if (!arguments.overlay.empty()) {
        overlay.emplace(png_output("--overlay", arguments.overlay));
        if (overlay->is_standard_output())
            throw Failure(k_usage, "--overlay and the explanation cannot both go to standard output");
    }
    check_isa(arguments.isa);
    add_settings(arguments.picture, PictureMemory::some, arguments.scene);
    LoadedScene loaded = load_scene(arguments.scene);
    const Scene& scene = *loaded.scene;
    const Pair pixel = pixel_of(arguments, scene.settings);
    ExplainStyle style;
    style.colors = prints_colors();
    style.from_below = arguments.origin == "bottom-left";
    style.file = encoding_of(arguments.numbers, scene.conventions.byte_rule());
    style.sample = sample_of(arguments, scene.settings.samples);
    style.fold = arguments.all ? 0 : arguments.fold;
    std::optional<std::uint32_t> light;
    if (!arguments.why_not.empty()) light = find_light("--why-not", arguments.why_not, scene);

    const Result<World> prepared = prepare(loaded.scene);
    add_warnings(loaded.warnings, prepared.diagnostics);
    print(loaded.warnings);
    if (!prepared) throw_failure(prepared);
    ExplainOptions options;
    options.isa = arguments.isa;
    // Text explains one sample; JSON explains all, unless --sample is given.
    if (arguments.form != "json" || !arguments.sample.empty()) options.sample = style.sample;
    const Result<Explanation> explained = explain(scene, *prepared, pixel.x, pixel.y, options);
    if (!explained) throw_failure(explained);
    const Explanation& explanation = *explained;

    if (light) {
        print_text_with_swatches(why_not_text(explanation, scene, *light, style));
    } else if (arguments.form == "json") {
        print_json(explanation_json(explanation, scene, style.file).value() + "\n");
    } else if (arguments.form == "printrays") {
        const int row = arguments.origin == "bottom-left" ? scene.settings.height - 1 - pixel.y : pixel.y;
        print_text(print_rays(explanation, scene, row, style));
    } else {
        print_text_with_swatches(explanation_text(explanation, scene, style));
        const int samples = explanation.samples;
        if (samples > 1 && samples <= k_max_listed_samples) {
            options.sample = -1;
            const Result<Explanation> all = explain(scene, *prepared, pixel.x, pixel.y, options);
            if (all) print_text_with_swatches(samples_text(*all, scene, style));
        }
    }
    if (overlay) {
        check_memory(scene.settings.width, scene.settings.height);
        Image picture = render_or_fail(*prepared, 0, arguments.isa);
        const Status drawn = render_overlay(picture, explanation, scene, *prepared);
        if (!drawn) throw_failure(drawn);
        write_png(picture, *overlay, style.file);
    }
    return k_done;
}

}  // namespace

Run add_explain(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("explain", "Explain the color of a pixel");
    const auto arguments = std::make_shared<ExplainArguments>();
    ExplainArguments& a = *arguments;
    add_scene_arguments(command, a.scene);
    command.add_option("-p,--pixel", a.pixel, "The pixel, counted from 0 at the top left")
        ->required()
        ->option_text("X,Y");
    command
        .add_option(
            "--sample", a.sample,
            "The sample whose rays are printed: its column and row in the pixel; default: the middle one")
        ->option_text("I,J");
    command
        .add_option(
            "--fold", a.fold,
            "Print secondary rays that add less than N of 255, with those that follow them, as one line; "
            "default: 0.5")
        ->check(number_between(0, 255))
        ->option_text("N");
    command.add_flag("--all", a.all, "Print every ray, as --fold 0 does");
    command
        .add_option("--as", a.form,
                    "text (default); json (schema in docs/explain.md); printrays: the layout of CSC 473")
        ->check(one_of({"text", "json", "printrays"}))
        ->option_text("text|json|printrays");
    command.add_option("--origin", a.origin, "Where pixel 0,0 is; default: top-left")
        ->check(one_of({"top-left", "bottom-left"}))
        ->option_text("top-left|bottom-left");
    command
        .add_option("--why-not", a.why_not,
                    "Explain only this light's effect; LIGHT is its name, or its number from 1")
        ->option_text("LIGHT");
    command
        .add_option("--overlay", a.overlay, "Also render the picture, with the pixel's rays drawn over it")
        ->option_text("OUT.png");
    add_picture_arguments(command, a.picture);
    add_alpha_argument(command, a.picture);
    add_number_arguments(command, a.numbers);
    command.add_option("--isa", a.isa, "Instruction set (`glint info --isa` lists them)")
        ->option_text("NAME");
    command.footer(k_explain_examples);
    return [arguments] { return explain_command(*arguments); };
}

}  // namespace glint::cli
