// SPDX-License-Identifier: Apache-2.0
// glint help and glint version: other spellings of --help and --version.
#include <fmt/format.h>

#include <array>
#include <memory>

#include "cli/commands.h"
#include "cli/failure.h"
#include "cli/usage.h"

namespace glint::cli {

const CLI::App* find_command(const CLI::App& app, std::string_view name) {
    const auto found = app.get_subcommands([&](const CLI::App* c) { return c->get_name() == name; });
    return found.empty() ? nullptr : found.front();
}

std::vector<const CLI::App*> shown_commands(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

Run add_help(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("help", "Print the help of a command, like its --help");
    const auto name = std::make_shared<std::string>();
    command.add_option("COMMAND", *name, "The command; default: glint itself")->option_text(" ");
    command.footer("Examples:\n  glint help\n  glint help render");
    return [&app, name] {
        if (name->empty()) {
            app.clear();  // otherwise the help of what was parsed would be printed
            fmt::print("{}", app.help());
            return k_done;
        }
        const CLI::App* wanted = find_command(app, *name);
        if (wanted == nullptr) throw Failure(k_usage, command_message(app, std::array{*name}));
        fmt::print("{}", wanted->help("glint"));
        return k_done;
    };
}

Run add_version(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("version", "Print the version, like --version");
    command.footer("Examples:\n  glint version");
    return [] {
        fmt::print("{}\n", k_version);
        return k_done;
    };
}

}  // namespace glint::cli
