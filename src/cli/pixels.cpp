// SPDX-License-Identifier: Apache-2.0
// glint pixels: proposes the pixels of a picture that are worth logging for `glint diagnose`.
#include <fmt/format.h>

#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/picture_arguments.h"
#include "cli/picture_file.h"
#include "cli/print_text.h"
#include "cli/scene_arguments.h"
#include "glint/diagnose.h"
#include "world/prepare.h"

namespace glint::cli {
namespace {

constexpr auto k_pixels_examples = R"(Examples:
  glint pixels castle.json mine.png              up to twelve pixels, one of each kind of difference
  glint pixels castle.json mine.png --quiet      the line alone: 320,350;12,40
  GLINT_PIXELS=$(glint pixels castle.json mine.png -q) ./my-ray-tracer)";

struct PixelsArguments {
    SceneArguments scene;
    PictureArguments picture;
    bool json = false, quiet = false;
    int threads = 0;
};

int pixels_command(PixelsArguments& arguments) {
    if (arguments.scene.files.size() < 2)
        throw Failure(k_usage, "expected the scene and your program's picture of it");
    if (!arguments.picture.size.empty()) throw Failure(k_usage, "--size: the picture's own size is taken");
    const std::string name = arguments.scene.files.back();
    arguments.scene.files.pop_back();
    const DecodedImage picture = read_picture(name);
    arguments.picture.size = fmt::format("{}x{}", picture.image.width, picture.image.height);
    add_settings(arguments.picture, PictureMemory::whole, arguments.scene);
    LoadedScene loaded = load_scene(arguments.scene);
    const Result<World> prepared = prepare(loaded.scene);
    add_warnings(loaded.warnings, prepared.diagnostics);
    if (!arguments.quiet) print(loaded.warnings);
    if (!prepared) throw_failure(prepared);
    const Result<std::vector<ProposedPixel>> proposed =
        propose_pixels(*loaded.scene, *prepared, picture.image, arguments.threads);
    if (!proposed) throw_failure(proposed);
    std::string line;
    for (const ProposedPixel& p : *proposed)
        line += fmt::format("{}{},{}", line.empty() ? "" : ";", p.x, p.y);
    if (arguments.json) {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (const ProposedPixel& p : *proposed)
            list.push_back({{"pixel", {p.x, p.y}}, {"kind", p.kind}, {"difference", p.difference}});
        print_json(list.dump(2) + "\n");
    } else if (arguments.quiet) {
        print_text(line + "\n");
    } else if (proposed->empty()) {
        print_text("The pictures are equal but for rounding: there is nothing to log.\n");
    } else {
        std::string text;
        for (const ProposedPixel& p : *proposed)
            fmt::format_to(std::back_inserter(text), "{:>5},{:<5} {}{}\n", p.x, p.y, p.kind,
                           p.kind == "equal" ? "" : fmt::format(", differs by {:.0f} of 255", p.difference));
        print_text(
            text +
            fmt::format("Log these pixels, then run `glint diagnose`:\n  GLINT_PIXELS=\"{}\" YOUR-PROGRAM\n",
                        line));
    }
    return k_done;
}

}  // namespace

Run add_pixels(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("pixels", "Propose pixels to log for `glint diagnose`");
    const auto arguments = std::make_shared<PixelsArguments>();
    add_scene_arguments(command, arguments->scene);
    add_picture_arguments(command, arguments->picture);
    add_threads_argument(command, arguments->threads, ". The pixels do not depend on it");
    command.add_flag("--json", arguments->json, "Print the pixels as a JSON array");
    command.add_flag("-q,--quiet", arguments->quiet, "Print the value of GLINT_PIXELS alone");
    command.footer(k_pixels_examples);
    return [arguments] { return pixels_command(*arguments); };
}

}  // namespace glint::cli
