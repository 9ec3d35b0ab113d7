// SPDX-License-Identifier: Apache-2.0
#include "cli/foreign_flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

#include "cli/foreign_table.h"
#include "cli/picture_endings.h"

namespace glint::cli {
namespace {

// The answer, collected flag by flag.
struct Answer {
    std::string_view name;  // of the command
    const HasOption& has_option;
    std::string lines{};                 // "+A: use --aa 3"
    std::vector<std::string> command{};  // glint's own arguments
    std::string size_flags{}, width{}, height{};

    void add_line(std::string_view flag, std::string_view what) {
        lines += fmt::format("{}: {}\n", flag, what);
    }
    // False, and a line that says so, if the command has no such option.
    bool can_use(std::string_view flag, const std::string& ours) {
        const std::string option = ours.substr(0, ours.find(' '));
        if (!option.starts_with("--") || has_option(option)) return true;
        add_line(flag, fmt::format("`glint {}` has no {}; leave it out", name, option));
        return false;
    }
    void use(std::string_view flag, const std::string& ours) {
        if (!can_use(flag, ours)) return;
        add_line(flag, "use " + ours);
        command.push_back(ours);
    }
    void dimension(const std::string& flag, std::string& which, std::string value) {
        if (!can_use(flag, "--size")) return;
        size_flags += (size_flags.empty() ? "" : " ") + flag;
        which = std::move(value);
    }
};

using Value = ForeignValue;

bool is_number(std::string_view text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string or_else(std::string_view text, std::string_view otherwise) {
    return std::string(text.empty() ? otherwise : text);
}

// A POV-Ray flag: a sign, a letter and the value without a space. Case does not matter.
void answer_povray(const std::string& flag, Answer& answer) {
    const PovraySwitch* known = find_povray_switch(std::string_view(flag).substr(1));
    if (known == nullptr)
        return answer.add_line(flag, "glint's options begin with - or --; see 'glint render --help'");
    const std::string value = flag.substr(1 + known->letters.size());
    const bool off = flag[0] == '-';
    switch (known->id) {
        case PovrayKey::threads:
            return answer.use(flag, "--threads " + or_else(value, "0"));
        case PovrayKey::width:
            return answer.dimension(flag, answer.width, value);
        case PovrayKey::height:
            return answer.dimension(flag, answer.height, value);
        case PovrayKey::input:
            return answer.use(flag, or_else(value, "SCENE"));
        case PovrayKey::output:
            return answer.use(flag, "--output " + or_else(value, "OUT"));
        case PovrayKey::antialias:
            if (off) return answer.add_line(flag, "one sample per pixel is glint's default");
            return answer.use(flag, "--aa 3");
        case PovrayKey::antialias_depth:
            return answer.use(flag, fmt::format("--aa {}", is_number(value) ? value : "3"));
        case PovrayKey::display:
            if (off) return answer.add_line(flag, "glint opens no window; leave it out");
            return answer.use(flag, "--show");
        case PovrayKey::quality:
            if (is_number(value) && value.size() == 1 && value[0] <= '1')
                return answer.use(flag, "--shading color");
            if (is_number(value) && value.size() == 1 && value[0] <= '3')
                return answer.use(flag, "--no-shadows");
            return answer.add_line(
                flag,
                "full quality is the default; for less: --no-shadows, --reflections 0, --shading color");
        case PovrayKey::first_column:
        case PovrayKey::last_column:
        case PovrayKey::first_row:
        case PovrayKey::last_row:
            return answer.add_line(flag, "--crop WxH+X+Y renders a part of the picture");
        case PovrayKey::file_type:
            return answer.add_line(
                flag, fmt::format("OUT's extension chooses the file type: {}; --bits 16 writes 16 bits",
                                  k_picture_endings_text));
        case PovrayKey::verbose:
            if (off) return answer.use(flag, "--quiet");
            return answer.add_line(
                flag, "glint shows its progress on a terminal; --stats FILE.json writes figures");
        case PovrayKey::console:
            return answer.add_line(flag, "messages go to standard error; --stats FILE.json writes figures");
        case PovrayKey::library:
            return answer.add_line(
                flag,
                "included files are searched in the folder of the file that includes them; leave it out");
        case PovrayKey::alpha:
            if (off) return answer.add_line(flag, "pictures have no alpha by default; leave it out");
            return answer.use(flag, "--alpha");
        case PovrayKey::clock:
        case PovrayKey::first_frame:
        case PovrayKey::last_frame:
        case PovrayKey::first_clock:
        case PovrayKey::last_clock:
        case PovrayKey::cycle:
        case PovrayKey::subset_first_frame:
        case PovrayKey::subset_last_frame:
        case PovrayKey::frame_step:
            return answer.add_line(flag, "glint has no animation clock; glint-povray takes it");
        case PovrayKey::fields:
            return answer.add_line(flag, "glint renders whole frames; leave it out");
        default:
            return answer.add_line(flag, "glint does not need it; leave it out");
    }
}

// Converts samples per pixel to glint's samples along a side, rounded up.
std::string side_of(const std::string& samples, int besides) {
    if (!is_number(samples) || samples.size() > 5) return "N";
    const int wanted = std::stoi(samples) + besides;
    int side = 1;
    while (side * side < wanted) ++side;
    return std::to_string(side);
}

void answer_known(const ForeignFlag& known, std::span<const std::string> values, Answer& answer) {
    const auto flag = fmt::format("{}{}{}", known.flag, values.empty() ? "" : " ", fmt::join(values, " "));
    const std::string value = values.empty() ? "" : values[0];
    const std::string ours(known.ours);
    switch (known.value) {
        default:
            return ours[0] == '-' ? answer.use(flag, ours) : answer.add_line(flag, ours);
        case Value::same:
        case Value::depth:
            return answer.use(flag, ours + " " + or_else(value, "VALUE"));
        case Value::size:
            return answer.use(flag, ours + " " + (values.size() == 2 ? values[0] + "x" + values[1] : "WxH"));
        case Value::width:
            return answer.dimension(flag, answer.width, value);
        case Value::height:
            return answer.dimension(flag, answer.height, value);
        case Value::samples:
            return answer.use(flag, ours + " " + side_of(value, 0));
        case Value::samples_besides:
            return answer.use(flag, ours + " " + side_of(value, 1));
        case Value::scene:
            return answer.use(flag, or_else(value, ours));
    }
}

// A flag of the table, and its values: words that follow it, or the end of its own word.
struct FoundFlag {
    const ForeignFlag* flag = nullptr;
    std::string own_value;  // of --width=640 and -j4
};

FoundFlag find_flag(const std::string& argument) {
    const auto named = [](std::string_view word) { return find_foreign_flag(word); };
    const std::size_t equals = argument.starts_with("--") ? argument.find('=') : std::string::npos;
    if (equals != std::string::npos)
        return {named(std::string_view(argument).substr(0, equals)), argument.substr(equals + 1)};
    if (argument.size() > 2 && is_number(std::string_view(argument).substr(2)))
        return {named(std::string_view(argument).substr(0, 2)), argument.substr(2)};
    return {named(argument), {}};
}

bool is_sentence(const ForeignFlag& flag) {
    return flag.value != Value::width && flag.value != Value::height && flag.value != Value::scene &&
           !flag.ours.starts_with('-');
}

bool is_povray(const std::string& argument) {
    if (argument.size() < 2) return false;
    if (argument[0] == '+') return std::isalpha(static_cast<unsigned char>(argument[1])) != 0;
    return argument[0] == '-' && argument[1] >= 'A' && argument[1] <= 'Z';
}

}  // namespace

std::optional<std::string> answer_foreign_flags(std::span<const std::string> arguments,
                                                std::string_view command, const HasOption& has_option) {
    const bool renders = has_option("--size");
    if (!renders && !has_option("SCENE")) return std::nullopt;
    Answer answer{command, has_option};
    bool any = false;
    for (std::size_t i = 0; i < arguments.size() && arguments[i] != "--"; ++i) {
        const std::string& argument = arguments[i];
        const auto [known, own_value] = find_flag(argument);
        // The sentences are about pictures.
        const bool is_known = known != nullptr && (renders || !is_sentence(*known));
        if (renders && is_povray(argument)) {
            answer_povray(argument, answer);
        } else if (is_known && !own_value.empty()) {
            answer_known(*known, std::array{own_value}, answer);
        } else if (is_known) {
            const std::size_t count = std::min<std::size_t>(known->values, arguments.size() - i - 1);
            answer_known(*known, arguments.subspan(i + 1, count), answer);
            i += count;
        } else {
            answer.command.push_back(argument);
            continue;
        }
        any = true;
    }
    if (!any) return std::nullopt;
    if (!answer.size_flags.empty()) {
        // glint's own pictures are square; the missing side is an example that the user may change.
        const std::string width = or_else(answer.width, or_else(answer.height, "640")),
                          height = or_else(answer.height, width);
        const std::string size = fmt::format("--size {}x{}", width, height);
        const bool is_whole = !answer.width.empty() && !answer.height.empty();
        answer.lines.insert(0, fmt::format("{}: use {}{}\n", answer.size_flags, size,
                                           is_whole ? "" : ", which has both width and height"));
        answer.command.push_back(size);
    }
    if (answer.command.empty()) answer.command.emplace_back("SCENE");
    return fmt::format("{}command: glint {} {}", answer.lines, command, fmt::join(answer.command, " "));
}

}  // namespace glint::cli
