// SPDX-License-Identifier: Apache-2.0
// glint check: a scene's likely mistakes.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/picture_arguments.h"
#include "cli/print_text.h"
#include "cli/progress.h"
#include "cli/scene_arguments.h"
#include "cli/text.h"

namespace glint::cli {
namespace {

constexpr auto k_check_examples = R"(Examples:
  glint check castle.json                              the likely mistakes, each with its line and remedy
  glint check castle.json --strict                     exit code 1 if there is any finding or warning
  glint check spheres.cgfs lights.cgfs --json          two listings as one scene; an array of findings
  glint check homework.pov --reflections 1             as rendered with one reflection)";

struct CheckArguments {
    SceneArguments scene;
    PictureArguments picture;
    bool strict = false, json = false, quiet = false;
    int threads = 0;
};

// Includes the reader's warnings: --strict counts them like findings.
std::string json_text(const std::vector<Diagnostic>& messages, const std::vector<Finding>& findings) {
    using Json = nlohmann::ordered_json;
    Json list = Json::array();
    const auto add = [&](std::string_view id, const Diagnostic& d, std::string_view remedy) {
        Json item = {{"id", id}, {"severity", d.severity == Severity::note ? "note" : "warning"}};
        if (d.line != 0) {
            item["file"] = d.file;
            item["line"] = d.line;
            item["column"] = d.column;
        }
        item["message"] = d.message;
        item["remedy"] = remedy;
        list.push_back(std::move(item));
    };
    for (const Diagnostic& d : messages)
        if (d.severity == Severity::warning) add("reading", d, "");
    for (const Finding& f : findings) add(f.id, f.diagnostic, f.remedy);
    // File names need not be UTF-8.
    return list.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

int check_command(CheckArguments& arguments) {
    add_settings(arguments.picture, PictureMemory::some, arguments.scene);
    LoadedScene loaded = load_scene(arguments.scene);
    std::vector<SceneText> texts = loaded.texts;
    const std::vector<InputFile> included = open_included(loaded, texts);
    CheckOptions options;
    options.threads = arguments.threads;
    options.texts = texts;
    auto bar = std::make_unique<ProgressBar>(!arguments.quiet);
    options.progress = [&](double fraction) { bar->update(fraction); };
    const Result<std::vector<Finding>> result = check(*loaded.scene, options);
    bar.reset();  // its line is free again
    add_warnings(loaded.warnings, result.diagnostics);
    print(loaded.warnings);
    if (!result) throw_failure(result);
    const std::vector<Finding>& findings = *result;
    const std::size_t warnings = count_warnings(loaded.warnings);
    const auto mistakes =
        static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(), [](const Finding& f) {
            return f.diagnostic.severity == Severity::warning;
        }));
    const std::size_t notes = findings.size() - mistakes;
    if (arguments.json) {
        print_json(json_text(loaded.warnings, findings));
    } else {
        for (const Finding& finding : findings) print_text(to_string(finding));
        print_text(
            fmt::format("{}: {}{}{}\n", fmt::join(arguments.scene.files, " "),
                        mistakes == 0 ? "no likely mistakes found" : counted(mistakes, "likely mistake"),
                        notes == 0 ? "" : ", " + counted(notes, "note"),
                        warnings == 0 ? "" : ", " + counted(warnings, "warning")));
    }
    const bool clean = mistakes == 0 && warnings == 0;
    return arguments.strict && !clean ? k_bad_input : k_done;
}

}  // namespace

Run add_check(CLI::App& app) {
    CLI::App& command =
        *app.add_subcommand("check", "List a scene's likely mistakes, each with its line and remedy");
    const auto arguments = std::make_shared<CheckArguments>();
    add_scene_arguments(command, arguments->scene);
    add_picture_arguments(command, arguments->picture);
    add_threads_argument(command, arguments->threads, ". The findings do not depend on it");
    command.add_flag("--strict", arguments->strict,
                     "Exit code 1 if there is any finding or warning; notes do not count");
    command.add_flag("--json", arguments->json, "Print the findings as a JSON array");
    command.add_flag("-q,--quiet", arguments->quiet, "No progress");
    command.footer(k_check_examples);
    return [arguments] { return check_command(*arguments); };
}

}  // namespace glint::cli
