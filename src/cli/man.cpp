// SPDX-License-Identifier: Apache-2.0
// glint man: manual pages, from the same texts as --help.
#include <fmt/format.h>

#include <array>
#include <cctype>
#include <memory>
#include <sstream>

#include "cli/commands.h"
#include "cli/drop_in.h"
#include "cli/failure.h"
#include "cli/usage.h"

namespace glint::cli {
namespace {

// Escapes text for roff: no line becomes a request, and hyphens can be copied to a command line.
std::string roff(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if ((i == 0 || text[i - 1] == '\n') && (c == '.' || c == '\'')) out += "\\&";
        if (c == '-') {
            out += "\\-";
        } else if (c == '\\') {
            out += "\\e";
        } else {
            out += c;
        }
    }
    return out;
}

std::string bold(const std::string& text) { return "\\fB" + roff(text) + "\\fR"; }
std::string italic(const std::string& text) { return "\\fI" + roff(text) + "\\fR"; }

// The text after "Examples:" in the footer, without its indentation.
std::string examples_of(const std::string& footer) {
    constexpr std::string_view head = "Examples:\n";
    const std::size_t at = footer.find(head);
    if (at == std::string::npos) return {};
    std::string text;
    std::istringstream lines(footer.substr(at + head.size()));
    for (std::string line; std::getline(lines, line);)
        text += (line.starts_with("  ") ? line.substr(2) : line) + "\n";
    return text;
}

std::string argument_text(const CLI::Option& option) {
    const std::string text = italic(option.get_name()) + (option.get_items_expected_max() > 1 ? "..." : "");
    return option.get_required() ? text : "[" + text + "]";
}

std::string option_heading(const CLI::Option& option) {
    if (option.get_positional()) return argument_text(option);
    std::string names;
    for (const std::string& name : option.get_snames())
        names += (names.empty() ? "" : ", ") + bold("-" + name);
    for (const std::string& name : option.get_lnames())
        names += (names.empty() ? "" : ", ") + bold("--" + name);
    const bool is_flag = option.get_items_expected_max() == 0;
    return is_flag ? names : names + " " + italic(option.get_option_text());
}

std::string first_lower(std::string text) {
    if (!text.empty()) text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    return text;
}

std::string page_name(const CLI::App& command) { return "glint-" + command.get_name(); }

std::string head(const std::string& name, const std::string& purpose) {
    std::string title = name;
    for (char& c : title) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    // Without date and version, so that the page changes only when the options change.
    return fmt::format(".TH {} 1 \"\" glint \"glint manual\"\n.SH NAME\n{} \\- {}\n", title, roff(name),
                       roff(purpose));
}

std::string options_text(const CLI::App& command) {
    std::string text = ".SH OPTIONS\n";
    for (const CLI::Option* option : command.get_options())
        text += fmt::format(".TP\n{}\n{}\n", option_heading(*option), roff(option->get_description()));
    return text;
}

std::string end(const CLI::App& command, const std::string& see_also) {
    std::string text = ".SH EXIT STATUS\n";
    for (const auto& [code, meaning] : k_exit_codes)
        text += fmt::format(".TP\n{}\n{}\n", code, roff(meaning));
    return text + fmt::format(".SH EXAMPLES\n.nf\n{}.fi\n.SH SEE ALSO\n{}\n",
                              roff(examples_of(command.get_footer())), see_also);
}

std::string glint_page(const CLI::App& app) {
    std::string text =
        head("glint", "ray tracer for Phong and Blinn-Phong lighting") +
        fmt::format(".SH SYNOPSIS\n{} {} [{}]\n.SH DESCRIPTION\n{}\n.SH COMMANDS\n", bold("glint"),
                    italic("COMMAND"), italic("ARGUMENTS"), roff(app.get_description()));
    std::string see_also;
    for (const CLI::App* command : shown_commands(app)) {
        text +=
            fmt::format(".TP\n.BR {} (1)\n{}\n", roff(page_name(*command)), roff(command->get_description()));
        see_also += fmt::format("{}.BR {} (1)", see_also.empty() ? "" : ",\n", roff(page_name(*command)));
    }
    text += ".SH PROGRAMS\n";
    for (const DropInProgram* program : drop_in_programs()) {
        const std::string name = roff(std::string(program->name));
        text += fmt::format(".TP\n.BR {} (1)\n{}\n", name, roff(std::string(program->purpose)));
        see_also += fmt::format(",\n.BR {} (1)", name);
    }
    return text + options_text(app) + end(app, see_also);
}

std::string command_page(const CLI::App& command) {
    std::string arguments;
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_positional()) arguments += " " + argument_text(*option);
    }
    return head(page_name(command), first_lower(command.get_description())) +
           fmt::format(".SH SYNOPSIS\n{} [{}]{}\n.SH DESCRIPTION\n{}.\n", bold("glint " + command.get_name()),
                       italic("OPTIONS"), arguments, roff(command.get_description())) +
           options_text(command) + end(command, ".BR glint (1)");
}

std::string program_page(const DropInProgram& program) {
    const std::string name(program.name), purpose(program.purpose);
    std::string text = head(name, first_lower(purpose)) +
                       fmt::format(".SH SYNOPSIS\n{} {}\n.SH DESCRIPTION\n{}.\n", bold(name),
                                   roff(std::string(program.usage)), roff(purpose));
    if (!program.notes.empty()) text += fmt::format("{}\n", roff(std::string(program.notes)));
    text += ".SH OPTIONS\n";
    for (const DropInOption& option : program.options) {
        text += fmt::format(".TP\n{}\n{}\n", bold(std::string(option.names)), roff(std::string(option.text)));
    }
    return text + fmt::format(
                      ".SH EXIT STATUS\n.TP\n0\ndone\n.TP\n{}\n{}\n.SH EXAMPLES\n.nf\n{}.fi\n"
                      ".SH SEE ALSO\n.BR glint (1)\n",
                      program.failure, roff(k_drop_in_failure), roff(std::string(program.examples)));
}

}  // namespace

Run add_man(CLI::App& app) {
    CLI::App& command = *app.add_subcommand("man", "Print a manual page as roff");
    command.group("");  // for packaging; users read `man glint`
    const auto name = std::make_shared<std::string>();
    command
        .add_option("COMMAND", *name, "The command, or glint-povray or glint-tachyon; default: glint itself")
        ->option_text(" ");
    command.footer("Examples:\n  glint man | man -l -\n  glint man render > glint-render.1");
    return [&app, name] {
        if (const DropInProgram* program = find_drop_in(*name)) {
            fmt::print("{}", program_page(*program));
            return k_done;
        }
        const CLI::App* wanted = name->empty() ? &app : find_command(app, *name);
        if (wanted == nullptr) throw Failure(k_usage, command_message(app, std::array{*name}));
        fmt::print("{}", name->empty() ? glint_page(app) : command_page(*wanted));
        return k_done;
    };
}

}  // namespace glint::cli
