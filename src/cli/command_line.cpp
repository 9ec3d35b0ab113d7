// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.h"

#include <fmt/format.h>

#include <sstream>

#include "cli/commands.h"
#include "cli/usage.h"

namespace glint::cli {

CommandLine parse_command_line(CLI::App& app, const std::vector<std::string>& arguments) {
    CommandLine line;
    if (arguments.empty()) {
        line.error = "expected a command";
        return line;
    }
    const CLI::App* command = find_command(app, arguments.front());
    if (command != nullptr) {
        line.command = command->get_name();
    } else {
        line.error = command_message(app, arguments);
        if (!line.error.empty()) return line;
        command = &app;
    }
    try {
        app.parse(std::vector<std::string>(arguments.rbegin(),
                                           arguments.rend()));  // the parser takes them from the end
        line.error = line.command.empty() ? "expected a command" : empty_value_message(*command);
    } catch (const CLI::Success& e) {  // --help and --version
        std::ostringstream out;
        app.exit(e, out, out);
        line.answer = out.str();
    } catch (const CLI::ParseError& e) {
        line.error = usage_message(*command, e);
    }
    return line;
}

std::string usage_error_text(std::string_view program, std::string_view command, std::string_view message) {
    const std::string words = command.empty() ? std::string(program) : fmt::format("{} {}", program, command);
    return fmt::format("{0}: {1}\nsee '{0} --help'\n", words, message);
}

}  // namespace glint::cli
