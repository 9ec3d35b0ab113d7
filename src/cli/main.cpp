// The command: choosing what runs, and what is said when it cannot.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/foreign_flags.h"
#include "cli/interrupt.h"
#include "cli/tell.h"
#include "cli/text.h"
#include "glint/glint.h"

namespace glint::cli {
namespace {

constexpr auto k_short_help =
    R"(glint draws classically lit scenes: Phong and Blinn-Phong, hard shadows, mirrors, glass.

  glint render SCENE...       draw a scene to a picture
  glint info SCENE            say what a scene holds
  glint convert SCENE OUT     write it in glint's own language
  glint check SCENE           name its likely mistakes
  glint explain SCENE -p X,Y  say why a pixel has its colour
  glint compare A.png B.png   hold a picture against a reference: where and why they differ
  glint --help                all commands

Example: glint render castle.json -o castle.png
)";

int say_usage(const std::string& command, const std::string& message) {
    tell("glint{}{}: {}\nsee 'glint{}{} --help'\n", command.empty() ? "" : " ", command, message,
         command.empty() ? "" : " ", command);
    return k_usage;
}

// `glint scene.cgfs`: a file where a command belongs.
std::string command_fault(const CLI::App& app, const std::vector<std::string>& arguments) {
    const std::string& word = arguments.front();
    const std::string ending = extension(word);
    bool is_scene = word == "-" || ::access(word.c_str(), F_OK) == 0;
    for (const FormatInfo& format : formats()) {
        is_scene = is_scene ||
                   (!ending.empty() &&
                    fmt::format(" {} ", format.extensions).find(" " + ending + " ") != std::string::npos);
    }
    if (is_scene)
        return fmt::format("'{}' is no command; did you mean 'glint render {}'?", word,
                           fmt::join(arguments, " "));
    std::vector<std::string> names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    const std::vector<std::string_view> views(names.begin(), names.end());
    return fmt::format("there is no command '{}'; there are {}", word, joined(views));
}

int run(const std::vector<std::string>& arguments) {
    CLI::App app("glint draws classically lit scenes: Phong and Blinn-Phong, hard shadows, mirrors, glass.",
                 "glint");
    app.set_version_flag("--version", "glint " GLINT_VERSION);
    app.footer(
        "Every command answers --help.\nExamples:\n  glint render castle.json\n  glint info castle.json\n"
        "  glint --version");
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
        {"grade", add_grade(app)},
        {"completion", add_completion(app)},
    };
    // clang-format on

    if (arguments.empty()) {
        fmt::print("{}", k_short_help);
        return k_done;
    }
    const std::string& word = arguments.front();
    const auto* command = std::find_if(std::begin(commands), std::end(commands),
                                       [&](const Command& c) { return c.name == word; });
    if (const auto answer = answer_foreign_flags(arguments)) {
        tell("{}\n", *answer);
        return k_usage;
    }
    if (command == std::end(commands) && (word == "-" || !word.starts_with('-'))) {
        return say_usage("", command_fault(app, arguments));
    }
    const std::string name = command == std::end(commands) ? "" : command->name;
    try {
        app.parse(
            std::vector<std::string>(arguments.rbegin(), arguments.rend()));  // it takes them from the end
        return command == std::end(commands) ? say_usage("", "expected a command") : command->run();
    } catch (const CLI::Success& e) {  // --help and --version
        return app.exit(e);
    } catch (const CLI::ParseError& e) {
        return say_usage(name, e.what());
    } catch (const Failure& e) {
        const std::string message = e.what();
        if (e.code() == k_usage) return say_usage(name, message);
        if (!message.empty()) tell("glint: {}\n", message);
        return e.code();
    }
}

}  // namespace
}  // namespace glint::cli

int main(int count, char** values) {
    glint::cli::handle_signals();
    int code = glint::cli::k_bad_input;
    try {
        code = glint::cli::run({values + std::min(count, 1), values + count});
    } catch (const std::bad_alloc&) {
        std::fputs("glint: out of memory\n", stderr);
    } catch (const std::exception& e) {
        glint::cli::tell("glint: {}\n", e.what());
    }
    if (std::fflush(stdout) != 0) {
        std::fputs("glint: cannot write to standard output\n", stderr);
        if (code == 0) code = glint::cli::k_bad_input;
    }
    return code;
}
