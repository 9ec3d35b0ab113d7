// SPDX-License-Identifier: Apache-2.0
// glint info: prints a scene's contents and the values in force when it is rendered.
#include <fmt/format.h>

#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/print_text.h"
#include "cli/scene_arguments.h"
#include "cli/scene_report.h"
#include "world/prepare.h"

namespace glint::cli {
namespace {

struct InfoArguments {
    SceneArguments scene;
    bool json = false, isa = false;
};

int info_command(const InfoArguments& arguments) {
    if (arguments.isa) {
        for (const std::string& name : isa_names()) fmt::print("{}\n", name);
        return k_done;
    }
    if (arguments.scene.files.empty()) throw Failure(k_usage, "expected SCENE, or --isa");
    LoadedScene loaded = load_scene(arguments.scene);
    const Result<World> prepared = prepare(loaded.scene);
    add_warnings(loaded.warnings, prepared.diagnostics);
    if (!prepared) {
        print(loaded.warnings);
        throw_failure(prepared);
    }
    const SceneReport report{*loaded.scene, *prepared, loaded.warnings, loaded.texts};
    arguments.json ? print_json(json_report(report)) : print_text(text_report(report));
    return k_done;
}

}  // namespace

Run add_info(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("info", "Print a scene's contents and the conventions in force");
    const auto arguments = std::make_shared<InfoArguments>();
    add_scene_arguments(command, arguments->scene);
    command.get_option("SCENE")->required(false);
    command.add_flag("--json", arguments->json, "Print JSON");
    command.add_flag("--isa", arguments->isa, "List the instruction sets of this machine, the best first");
    command.footer(
        "Examples:\n"
        "  glint info castle.json\n"
        "  glint info castle.json --profile cgfs --json\n"
        "  glint info --isa");
    return [arguments] { return info_command(*arguments); };
}

}  // namespace glint::cli
