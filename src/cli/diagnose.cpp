// SPDX-License-Identifier: Apache-2.0
// glint diagnose: compares the log of another ray tracer with a scene, quantity by quantity.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/commands.h"
#include "cli/diagnosis_text.h"
#include "cli/failure.h"
#include "cli/input_file.h"
#include "cli/picture_arguments.h"
#include "cli/picture_file.h"
#include "cli/print_text.h"
#include "cli/scene_arguments.h"
#include "cli/text.h"
#include "glint/diagnose.h"
#include "world/prepare.h"

namespace glint::cli {
namespace {

constexpr auto k_diagnose_examples = R"(Examples:
  glint diagnose castle.json glint.log                 the first quantity that differs, and its cause
  glint diagnose castle.json glint.log --size 320x240  the log is of a picture of this size
  glint diagnose castle.json glint.log --tree 120,80   all quantities of a pixel: yours and what they should be
  glint diagnose castle.json glint.log --picture mine.png   what else differs in the picture
  glint diagnose castle.json glint.log --json)";

struct DiagnoseArguments {
    SceneArguments scene;
    PictureArguments picture;
    std::string tree, own_picture;
    bool json = false;
    int threads = 0;
};

int diagnose_command(DiagnoseArguments& arguments) {
    if (arguments.scene.files.size() < 2) throw Failure(k_usage, "expected the scene and the log");
    const std::string name = arguments.scene.files.back();
    arguments.scene.files.pop_back();
    std::optional<Pair> tree;
    if (!arguments.tree.empty()) {
        tree = parse_pair(arguments.tree);
        if (!tree)
            throw Failure(k_usage,
                          fmt::format("--tree: expected X,Y, as 320,200, found '{}'", arguments.tree));
    }
    std::optional<DecodedImage> picture;
    if (!arguments.own_picture.empty()) {
        picture = read_picture(arguments.own_picture);
        if (arguments.picture.size.empty())
            arguments.picture.size = fmt::format("{}x{}", picture->image.width, picture->image.height);
    }
    add_settings(arguments.picture, picture ? PictureMemory::whole : PictureMemory::some, arguments.scene);
    LoadedScene loaded = load_scene(arguments.scene);
    std::string why;
    const std::optional<InputFile> log = InputFile::open(name, why);
    if (!log) throw Failure(k_bad_input, fmt::format("{}: {}", name, why));
    const Result<World> prepared = prepare(loaded.scene);
    add_warnings(loaded.warnings, prepared.diagnostics);
    print(loaded.warnings);
    if (!prepared) throw_failure(prepared);
    const Scene& scene = *loaded.scene;
    DiagnoseOptions options;
    options.name = name;
    options.threads = arguments.threads;
    if (tree || picture) options.max_rows = 10'000'000;
    const Result<Diagnosis> diagnosis = diagnose(scene, *prepared, log->text(), options);
    print(diagnosis.diagnostics);
    if (!diagnosis) throw_failure(diagnosis);
    std::vector<ProposedPixel> proposed;
    if (picture) {
        Result<std::vector<ProposedPixel>> found =
            propose_pixels(scene, *prepared, picture->image, arguments.threads);
        if (!found) throw_failure(found);
        proposed = *std::move(found);
    }
    if (arguments.json) {
        print_json(diagnosis_json(*diagnosis, scene).value() + "\n");
    } else if (tree) {
        const std::string text = diagnosis_tree_text(*diagnosis, scene, tree->x, tree->y);
        if (text.empty())
            throw Failure(k_bad_input, fmt::format("{}: the log has no pixel {},{}", name, tree->x, tree->y));
        print_text(text);
    } else {
        print_text(diagnosis_text(*diagnosis, scene) +
                   (picture ? picture_text(*diagnosis, picture->image, proposed) : ""));
    }
    return diagnosis->findings.empty() && diagnosis->judged > 0 ? k_done : k_bad_input;
}

}  // namespace

Run add_diagnose(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("diagnose", "Find the mistake in another ray tracer by its log");
    const auto arguments = std::make_shared<DiagnoseArguments>();
    add_scene_arguments(command, arguments->scene);
    add_picture_arguments(command, arguments->picture);
    command
        .add_option("--tree", arguments->tree,
                    "Print all quantities of a pixel of the log, beside what they should be")
        ->option_text("X,Y");
    command
        .add_option(
            "--picture", arguments->own_picture,
            "Your program's picture: print which of its differences the log has no pixel of, and whether "
            "it has the log's bytes")
        ->option_text("FILE");
    add_threads_argument(command, arguments->threads, ". The answer does not depend on it");
    command.add_flag("--json", arguments->json, "Print the answer as JSON (docs/diagnose.md)");
    command.footer(k_diagnose_examples);
    return [arguments] { return diagnose_command(*arguments); };
}

}  // namespace glint::cli
