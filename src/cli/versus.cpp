// SPDX-License-Identifier: Apache-2.0
// glint versus: renders a scene with two sets of conventions and explains the difference.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "base/text.h"
#include "cli/commands.h"
#include "cli/compare_report.h"
#include "cli/explain_text.h"
#include "cli/failure.h"
#include "cli/picture_arguments.h"
#include "cli/print_text.h"
#include "cli/render_or_fail.h"
#include "cli/repeated_option.h"
#include "cli/scene_arguments.h"
#include "cli/text.h"
#include "image/quantize.h"

namespace glint::cli {
namespace {

constexpr auto k_versus_examples = R"(Examples:
  glint versus castle.json --a profile=epfl --b profile=cgfs
  glint versus castle.json --a shading=phong --b shading=blinn-phong
  glint versus castle.json --a shading=phong --b shading=blinn-phong --match-exponents
  glint versus castle.json --a reflections=0 --b reflections=3 -o mirrors.png)";

constexpr double k_matching_factor = 4;  // see docs/lighting.md
constexpr std::int32_t k_line = 4;       // pixels between the pictures

struct VersusArguments {
    SceneArguments scene;
    PictureArguments picture;
    std::vector<std::string> a, b;
    std::string output;
    bool match_exponents = false, json = false;
};

struct Side {
    std::string name;
    Scene scene;
    std::vector<Diagnostic> warnings;
    World world;
    Image image;
};

// Applies the KEY=VALUE of --a and --b: any setting, or the profile to start from.
SceneArguments with_settings(SceneArguments scene, const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) {
        if (setting.starts_with("profile=")) {
            scene.profile = setting.substr(setting.find('=') + 1);
        } else {
            scene.conventions.push_back(setting);
        }
    }
    return scene;
}

// The name of a side. Errors in its settings are reported for its own option.
std::string name_of(const std::vector<std::string>& settings, const char* option) {
    for (const std::string& setting : settings) {
        const std::size_t equals = setting.find('=');
        if (equals == std::string::npos)
            throw Failure(k_usage, fmt::format("{}: expected KEY=VALUE, found '{}'", option, setting));
        const std::string key = setting.substr(0, equals);
        if (key != "profile" && !find_setting(key))
            throw Failure(k_usage, fmt::format("{}: there is no setting {}{}", option, glint::quoted(key),
                                               suggestion(key, setting_names())));
    }
    return settings.empty() ? "as it is" : fmt::format("{}", fmt::join(settings, " "));
}

// A profile may change the size. Pictures can be compared only at one size: that of the first.
Side render_side(const VersusArguments& arguments, const std::vector<std::string>& settings,
                 const char* option, const std::optional<RenderSettings>& same_size) {
    Side side;
    side.name = name_of(settings, option);
    LoadedScene loaded = load_scene(with_settings(arguments.scene, settings));
    side.warnings = std::move(loaded.warnings);
    side.scene = std::move(loaded.scene).release();
    Scene& scene = side.scene;
    const bool has_size = std::any_of(settings.begin(), settings.end(),
                                      [](const std::string& s) { return s.starts_with("size="); });
    if (same_size && !has_size) {
        scene.settings.width = same_size->width;
        scene.settings.height = same_size->height;
    }
    if (arguments.match_exponents && scene.settings.shading == Shading::blinn_phong) {
        for (Material& material : scene.materials) material.shininess *= k_matching_factor;
        side.name += fmt::format(", exponents times {}", k_matching_factor);
    }
    side.world = prepare_or_fail(scene);
    side.image = as_written(render_or_fail(side.world), side.scene.conventions.byte_rule());
    return side;
}

// The size of the scene, if the first picture's profile may have another.
std::optional<RenderSettings> size_of_scene(const VersusArguments& arguments) {
    const bool has_profile = std::any_of(arguments.a.begin(), arguments.a.end(),
                                         [](const std::string& s) { return s.starts_with("profile="); });
    if (!has_profile) return std::nullopt;
    return load_scene(arguments.scene).scene->settings;
}

// A, B and their difference side by side, separated by a light line.
Image side_by_side(const Image& a, const Image& b, const Image& difference) {
    const std::ptrdiff_t row = std::ptrdiff_t{3} * a.width, step = row + 3 * k_line;
    Image all{3 * a.width + 2 * k_line, a.height, {}};
    all.rgb.assign(static_cast<std::size_t>(3) * all.width * all.height, 1);
    for (std::ptrdiff_t y = 0; y < a.height; ++y) {
        auto to = all.rgb.begin() + y * 3 * all.width;
        for (const Image* image : {&a, &b, &difference}) {
            std::copy_n(image->rgb.begin() + y * row, row, to);
            if (image != &difference) to += step;
        }
    }
    return all;
}

std::string explained(const Side& side, const LargestDifference& pixel, ExplainStyle style) {
    const int n = side.scene.settings.samples;
    style.sample = n / 2 * n + n / 2;
    style.file.set_rule(side.scene.conventions.byte_rule());
    ExplainOptions options;
    options.sample = style.sample;
    const auto explanation = explain(side.scene, side.world, pixel.x, pixel.y, options);
    if (!explanation) throw_failure(explanation);
    return explanation_text(*explanation, side.scene, style);
}

std::string explained_json(const Side& side, const LargestDifference& pixel) {
    const auto explanation = explain(side.scene, side.world, pixel.x, pixel.y);
    if (!explanation) throw_failure(explanation);
    EncodeOptions file;
    file.set_rule(side.scene.conventions.byte_rule());
    return explanation_json(*explanation, side.scene, file).value();
}

// Whether the pixel's neighbours have nearly its color in the displayed picture.
bool is_inside(const Image& image, std::int32_t x, std::int32_t y) {
    const auto at = [&](std::int32_t u, std::int32_t v) {
        return &image.rgb[3 * (static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) +
                               static_cast<std::size_t>(u))];
    };
    const float* here = at(x, y);
    for (std::int32_t v = std::max(y - 1, 0); v <= std::min(y + 1, image.height - 1); ++v) {
        for (std::int32_t u = std::max(x - 1, 0); u <= std::min(x + 1, image.width - 1); ++u) {
            for (int c = 0; c < 3; ++c) {
                const int step = int{to_byte(at(u, v)[c])} - int{to_byte(here[c])};
                if (std::abs(step) > static_cast<int>(k_edge_step)) return false;
            }
        }
    }
    return true;
}

// The pixel to explain: the one that differs most inside an object. At an edge the two pictures may show
// different objects, which does not explain the rules.
LargestDifference largest_inside(const Image& a, const Image& b, const LargestDifference& largest) {
    LargestDifference found;
    for (std::int32_t y = 0; y < a.height; ++y) {
        for (std::int32_t x = 0; x < a.width; ++x) {
            const std::size_t i = 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(a.width) +
                                       static_cast<std::size_t>(x));
            int most = 0;
            for (std::size_t c = i; c < i + 3; ++c)
                most = std::max(most, std::abs(int{to_byte(a.rgb[c])} - int{to_byte(b.rgb[c])}));
            if (most <= found.value || !is_inside(a, x, y) || !is_inside(b, x, y)) continue;
            found.value = most;
            found.x = x;
            found.y = y;
        }
    }
    return found.value > 0 ? found : largest;
}

int versus_command(VersusArguments& arguments) {
    std::optional<OutputFile> output;
    if (!arguments.output.empty()) {
        output.emplace(png_output("--output", arguments.output));
        if (output->is_standard_output())
            throw Failure(k_usage, "the pictures and the report cannot both go to standard output");
    }
    if (arguments.a.empty() && arguments.b.empty())
        throw Failure(k_usage,
                      "expected --a KEY=VALUE or --b KEY=VALUE: the difference between the pictures");
    add_settings(arguments.picture, PictureMemory::whole, arguments.scene);
    const Side a = render_side(arguments, arguments.a, "--a", size_of_scene(arguments));
    const Side b = render_side(arguments, arguments.b, "--b", a.scene.settings);
    print(a.warnings);
    const Result<PictureDifference> compared = compare(a.image, b.image);
    if (!compared) throw_failure(compared);
    const PictureDifference& difference = *compared;
    CompareReport report;
    report.a = a.name;
    report.b = b.name;
    report.width = a.image.width;
    report.height = a.image.height;
    report.within = CompareOptions{}.within;
    report.difference = difference;
    const LargestDifference inside = largest_inside(a.image, b.image, difference.largest);
    report.explained = inside;
    const bool same = difference.all.equal == difference.all.pixels;
    report.passes = same;
    report.reference = "B";
    if (arguments.json) {
        if (!same) report.explanations = {explained_json(a, inside), explained_json(b, inside)};
        print_json(json_report(report));
    } else {
        print_text(text_report(report));
        ExplainStyle style;
        style.colors = prints_colors();
        if (!same)
            print_text_with_swatches(fmt::format("\nA: {}\n{}\nB: {}\n{}", a.name,
                                                 explained(a, inside, style), b.name,
                                                 explained(b, inside, style)));
    }
    if (output)
        write_png(side_by_side(a.image, b.image, difference_image(a.image, b.image).value()), *output);
    return k_done;
}

}  // namespace

Run add_versus(CLI::App& app) {
    CLI::App& command = *app.add_subcommand(
        "versus", "Render a scene with two sets of conventions, and explain the pixel that differs most");
    const auto arguments = std::make_shared<VersusArguments>();
    VersusArguments& v = *arguments;
    add_scene_arguments(command, v.scene);
    const auto side = [&](const char* option, std::vector<std::string>& settings, const char* description) {
        repeated(command.add_option(option, settings, description))->option_text("KEY=VALUE");
    };
    side("--a", v.a,
         "A setting of the first picture: a convention, a render setting, or profile=NAME; may be repeated");
    side("--b", v.b,
         "The same for the second picture; without --a or --b, that picture shows the scene as it is");
    command.add_flag(
        "--match-exponents", v.match_exponents,
        "With Blinn-Phong, multiply exponents by 4: highlights are then about as wide as Phong's");
    command.add_option("-o,--output", v.output, "Write both pictures and their difference side by side")
        ->option_text("OUT.png");
    command.add_flag("--json", v.json, "Print JSON");
    add_picture_arguments(command, v.picture);
    command.footer(k_versus_examples);
    return [arguments] { return versus_command(*arguments); };
}

}  // namespace glint::cli
