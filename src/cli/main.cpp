// SPDX-License-Identifier: Apache-2.0
// The command: selects the subcommand, and prints errors of usage. By other names it is glint-povray and
// glint-tachyon.
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/drop_in.h"
#include "cli/failure.h"
#include "cli/foreign_flags.h"
#include "cli/print_error.h"
#include "cli/program.h"
#include "os/process.h"

namespace glint::cli {
namespace {

constexpr auto k_short_help =
    R"(glint renders scenes with Phong and Blinn-Phong lighting, shadows, mirrors and glass.

  glint render SCENE...       draw a scene to a picture
  glint info SCENE            say what a scene holds
  glint convert SCENE OUT     write it in glint's own language
  glint check SCENE           name its likely mistakes
  glint explain SCENE -p X,Y  say why a pixel has its color
  glint compare A.png B.png   compare a picture with a reference: where and why they differ
  glint --help                all commands

Example: glint render castle.json -o castle.png
)";

int print_usage_error(const std::string& command, const std::string& message) {
    print_error("{}", usage_error_text("glint", command, message));
    return k_usage;
}

int run(const std::vector<std::string>& arguments) {
    // Alone, other programs' -v is their version; beside other words it is --verbose.
    if (arguments == std::vector<std::string>{"-v"}) return run({"--version"});
    CLI::App app("glint renders scenes with Phong and Blinn-Phong lighting, shadows, mirrors and glass.",
                 "glint");
    app.allow_windows_style_options(false);  // CLI11's default on Windows: /a.json would be an option
    app.set_version_flag("-V,--version", k_version, "Print the version and exit");
    std::string footer = "Every command has --help.\n\nExit codes:\n";
    for (const auto& [code, meaning] : k_exit_codes) footer += fmt::format("  {:<26}{}\n", code, meaning);
    app.footer(footer +
               "\nExamples:\n  glint render castle.json\n  glint info castle.json\n  glint help render");
    app.require_subcommand(0, 1);
    struct Command {
        std::string name;
        Run run;
    };
    // clang-format off
    const Command commands[] = {
        {"render", add_render(app)},
        {"info", add_info(app)},
        {"convert", add_convert(app)},
        {"check", add_check(app)},
        {"explain", add_explain(app)},
        {"compare", add_compare(app)},
        {"versus", add_versus(app)},
        {"pixels", add_pixels(app)},
        {"diagnose", add_diagnose(app)},
        {"grade", add_grade(app)},
        {"join", add_join(app)},
        {"install-drop-ins", add_install_drop_ins(app)},
        {"completion", add_completion(app)},
        {"help", add_help(app)},
        {"version", add_version(app)},
        {"man", add_man(app)},
    };
    // clang-format on

    if (arguments.empty()) {
        fmt::print("{}", k_short_help);
        return k_done;
    }
    const std::string& word = arguments.front();
    const CLI::App* named = find_command(app, word);
    if (named != nullptr || word != "-V") {  // POV-Ray's -V is --quiet
        const std::string renderer = named == nullptr ? "render" : named->get_name();
        const CLI::App& asked = *find_command(app, renderer);
        const auto answer = answer_foreign_flags(
            std::span(arguments).subspan(named == nullptr ? 0 : 1), renderer,
            [&](const std::string& option) { return asked.get_option_no_throw(option) != nullptr; });
        if (answer) {
            print_error("{}\n", *answer);
            return k_usage;
        }
    }
    const CommandLine line = parse_command_line(app, arguments);
    if (!line.error.empty()) return print_usage_error(line.command, line.error);
    if (!line.answer.empty()) {
        fmt::print("{}", line.answer);
        return k_done;
    }
    try {
        const auto* command = std::find_if(std::begin(commands), std::end(commands),
                                           [&](const Command& c) { return c.name == line.command; });
        return command->run();
    } catch (const Failure& e) {
        const std::string message = e.what();
        if (e.code() == k_usage) return print_usage_error(line.command, message);
        if (!message.empty()) print_error("glint: {}\n", message);
        return e.code();
    }
}

}  // namespace
}  // namespace glint::cli

int main(int count, char** values) {
    using namespace glint::cli;
    std::vector<std::string> words = glint::os::arguments(count, values);
    const std::string called = words.empty() ? "glint" : words.front();
    if (!words.empty()) words.erase(words.begin());
    if (const DropInProgram* program = called_drop_in(called)) return run_drop_in(*program, called, words);
    return run_program("glint", k_bad_input, [&] { return run(words); });
}
