// SPDX-License-Identifier: Apache-2.0
#include "cli/usage.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "cli/commands.h"
#include "cli/text.h"
#include "glint/glint.h"
#include "os/files.h"

namespace glint::cli {
namespace {

using Options = std::vector<const CLI::Option*>;

// "--size" of "--size=9x9".
std::string option_word(const std::string& argument) { return argument.substr(0, argument.find('=')); }

// The long option of `command` that an unknown one resembles, or an empty text.
std::string nearest_option(const CLI::App& command, const std::string& argument) {
    if (!argument.starts_with("--")) return {};
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    const std::vector<std::string_view> views(names.begin(), names.end());
    return std::string(nearest_word(option_word(argument), views));
}

std::string unknown_arguments(const CLI::App& command, const std::vector<std::string>& unknown) {
    std::vector<std::string> texts;
    texts.reserve(unknown.size());
    for (const std::string& argument : unknown) {
        const std::string near = nearest_option(command, argument);
        texts.push_back(glint::quoted(argument) +
                        (near.empty() ? "" : fmt::format(" (did you mean `{}`?)", near)));
    }
    const bool are_options = std::all_of(unknown.begin(), unknown.end(), [](const std::string& argument) {
        return argument.starts_with('-');
    });
    return fmt::format("{}{} {}", are_options ? "unknown option" : "unexpected argument",
                       unknown.size() == 1 ? "" : "s", fmt::join(texts, ", "));
}

// "--size WxH", "SCENE".
std::string with_value(const CLI::Option& option) {
    const std::string& value = option.get_option_text();
    return option.get_name() + (option.get_positional() || value.empty() ? "" : " " + value);
}

// The option that a message of the parser is about. The message begins with its name, or with "Could not
// convert: " and the name.
const CLI::Option* option_of(const Options& options, std::string_view message) {
    constexpr std::string_view before = "Could not convert: ";
    if (message.starts_with(before)) message.remove_prefix(before.size());
    for (const CLI::Option* option : options) {
        const std::string& name = option->get_name();
        const std::string_view rest = message.substr(std::min(name.size(), message.size()));
        if (message.starts_with(name) && (rest.starts_with(':') || rest.starts_with(' '))) return option;
    }
    return nullptr;
}

// The command line that an option in front of all words was meant for: that of the command which follows, or
// of the first that has the option.
std::string option_message(const CLI::App& app, std::span<const std::string> arguments) {
    const std::string& first = arguments.front();
    const std::string word = option_word(first);
    if (app.get_option_no_throw(word) != nullptr || !nearest_option(app, first).empty()) return {};
    std::vector<std::string> rest(arguments.begin() + 1, arguments.end());
    std::vector<const CLI::App*> commands = shown_commands(app);
    const auto named = std::find_if(rest.begin(), rest.end(), [&](const std::string& argument) {
        const CLI::App* command = find_command(app, argument);
        return command != nullptr && !command->get_group().empty();
    });
    if (named != rest.end()) {
        commands = {find_command(app, *named)};
        rest.erase(named);
    }
    const auto proposal = [&](const CLI::App& command, const std::string& option) {
        rest.insert(rest.begin(), option + first.substr(word.size()));
        return fmt::format("did you mean '{} {} {}'?", app.get_name(), command.get_name(),
                           fmt::join(rest, " "));
    };
    for (const CLI::App* command : commands) {
        if (command->get_option_no_throw(word) != nullptr)
            return fmt::format("{} belongs after a command; {}", glint::quoted(word),
                               proposal(*command, word));
    }
    for (const CLI::App* command : commands) {
        if (const std::string near = nearest_option(*command, first); !near.empty())
            return fmt::format("unknown option {}; {}", glint::quoted(word), proposal(*command, near));
    }
    return {};
}

}  // namespace

std::string usage_message(const CLI::App& command, const CLI::ParseError& error) {
    std::vector<std::string> unknown = command.remaining();
    std::erase(unknown, "--");  // ends the options
    if (!unknown.empty()) return unknown_arguments(command, unknown);
    const Options options = command.get_options();
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) {
        std::vector<std::string> missing;
        for (const CLI::Option* option : options) {
            if (option->get_required() && option->count() == 0) missing.push_back(with_value(*option));
        }
        return missing.empty() ? "expected a command"
                               : fmt::format("expected {}", fmt::join(missing, " and "));
    }
    const CLI::Option* option = option_of(options, error.what());
    if (option == nullptr) return error.what();
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
        if (option->count() > 1 && option->get_multi_option_policy() == CLI::MultiOptionPolicy::Throw)
            return fmt::format("{} is given {} times: expected once", option->get_name(), option->count());
        return fmt::format("{}: expected {}, found nothing", option->get_name(), option->get_option_text());
    }
    if (dynamic_cast<const CLI::ConversionError*>(&error) != nullptr && option->get_items_expected_max() == 0)
        return fmt::format("{} takes no value", option->get_name());
    return error.what();
}

std::string empty_value_message(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        const auto& values = option->results();
        if (option->get_items_expected_max() == 0 ||
            std::find(values.begin(), values.end(), "") == values.end())
            continue;
        return fmt::format("{}: expected {}, found nothing", option->get_name(),
                           option->get_positional() ? "a name" : option->get_option_text());
    }
    return {};
}

std::string command_message(const CLI::App& app, std::span<const std::string> arguments) {
    const std::string& word = arguments.front();
    if (word != "-" && word.starts_with('-')) return option_message(app, arguments);
    const std::string ending = extension(word);
    bool is_scene = word == "-" || os::exists(word);
    for (const FormatInfo& format : formats()) {
        is_scene = is_scene ||
                   (!ending.empty() &&
                    fmt::format(" {} ", format.extensions).find(" " + ending + " ") != std::string::npos);
    }
    if (is_scene)
        return fmt::format("'{}' is not a command; did you mean '{} render {}'?", word, app.get_name(),
                           fmt::join(arguments, " "));
    std::vector<std::string_view> names;
    for (const CLI::App* command : shown_commands(app)) names.push_back(command->get_name());
    return fmt::format("there is no command {}{}", glint::quoted(word), suggestion(word, names));
}

}  // namespace glint::cli
