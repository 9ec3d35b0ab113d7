// SPDX-License-Identifier: Apache-2.0
#include "cli/foreign_flags.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

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

bool is_number(std::string_view text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::string or_else(std::string_view text, std::string_view otherwise) {
    return std::string(text.empty() ? otherwise : text);
}

// A POV-Ray flag: a sign, a letter and the value without a space. Case does not matter.
void answer_povray(const std::string& flag, Answer& answer) {
    const char letter =
        flag.size() > 1 ? static_cast<char>(std::toupper(static_cast<unsigned char>(flag[1]))) : '\0';
    const std::string value = flag.size() > 2 ? flag.substr(2) : "";
    const char second =
        value.empty() ? '\0' : static_cast<char>(std::toupper(static_cast<unsigned char>(value[0])));
    const bool off = flag[0] == '-';
    switch (letter) {
        case 'W':
            if (second == 'T') return answer.use(flag, "--threads " + or_else(value.substr(1), "0"));
            return answer.dimension(flag, answer.width, value);
        case 'H':
            return answer.dimension(flag, answer.height, value);
        case 'I':
            return answer.use(flag, or_else(value, "SCENE"));
        case 'O':
            return answer.use(flag, "--output " + or_else(value, "OUT"));
        case 'A':
            if (off) return answer.add_line(flag, "one sample per pixel is glint's default");
            return answer.use(flag, "--aa 3");
        case 'R':
            return answer.use(flag, fmt::format("--aa {}", is_number(value) ? value : "3"));
        case 'D':
            if (off) return answer.add_line(flag, "glint opens no window; leave it out");
            return answer.use(flag, "--show");
        case 'Q':
            if (is_number(value) && value.size() == 1 && value[0] <= '1')
                return answer.use(flag, "--shading color");
            if (is_number(value) && value.size() == 1 && value[0] <= '3')
                return answer.use(flag, "--no-shadows");
            return answer.add_line(
                flag,
                "full quality is the default; for less: --no-shadows, --reflections 0, --shading color");
        case 'S':
        case 'E':
            return answer.add_line(flag, "--crop WxH+X+Y renders a part of the picture");
        case 'F':
            return answer.add_line(
                flag, "OUT's extension chooses the file type: .png .ppm .exr; --bits 16 writes 16 bits");
        case 'V':
            if (off) return answer.use(flag, "--quiet");
            return answer.add_line(
                flag, "glint shows its progress on a terminal; --stats FILE.json writes figures");
        case 'G':
            return answer.add_line(flag, "messages go to standard error; --stats FILE.json writes figures");
        case 'L':
            return answer.add_line(
                flag,
                "included files are searched in the folder of the file that includes them; leave it out");
        case 'K':
            return answer.add_line(flag, "glint has no animation clock");
        case 'P':
        case 'C':
        case 'B':
        case 'M':
        case 'U':
        case 'J':
            return answer.add_line(flag, "glint does not need it; leave it out");
        default:
            return answer.add_line(flag, "glint's options begin with - or --; see 'glint render --help'");
    }
}

// How a flag's value is translated.
enum class Value {
    none,   // no value, or glint does not use it
    same,   // unchanged, after glint's option
    size,   // two values: WxH
    width,  // combined with the height of another flag
    height,
    samples,          // samples per pixel; glint counts them along a side
    samples_besides,  // the same, in addition to the first one
    scene,            // an argument without an option
};

struct ForeignFlag {
    std::string_view flag;
    int values;             // how many arguments it takes
    std::string_view ours;  // an option, or a sentence if it does not begin with -
    Value value = Value::none;
};
constexpr ForeignFlag k_flags[] = {
    // Tachyon
    {"-res", 2, "--size", Value::size},
    {"-numthreads", 1, "--threads", Value::same},
    {"-aasamples", 1, "--aa", Value::samples_besides},
    {"-format", 1, "OUT's extension chooses the file type: .png .ppm .exr; --bits 16 writes 16 bits"},
    {"-fullshade", 0, "shadows and mirrors are glint's default; leave it out"},
    {"-mediumshade", 0, "--no-shadows"},
    {"-lowshade", 0, "--no-shadows --reflections 0"},
    {"-lowestshade", 0, "--shading color"},
    {"-shade_phong", 0, "--shading phong"},
    {"-shade_blinn", 0, "--shading blinn-phong"},
    {"-shade_blinn_fast", 0, "--shading blinn-phong"},
    {"-shade_nullphong", 0, "--shading diffuse"},
    {"-raydepth", 1, "--reflections", Value::same},
    {"-verbose", 0, "--stats FILE.json writes figures"},
    {"-nosave", 0, "--output /dev/null"},
    {"-gamma", 1, "--transfer srgb"},
    {"-crop", 4, "--crop WxH+X+Y renders a part of the picture"},
    {"-clamp", 0, "glint clamps colours; leave it out"},
    {"-nobounding", 0, "glint does not need it; leave it out"},
    {"-boundthresh", 1, "glint does not need it; leave it out"},
    {"-normalize", 0, "glint does not scale colours; an .exr picture keeps their full range"},
    {"-rescale_lights", 1, "glint uses the lights as they are in the scene"},
    {"-auto_skylight", 1, "glint has hard shadows and no sky light"},
    {"-add_skylight", 1, "glint has hard shadows and no sky light"},
    {"-skylight_samples", 1, "glint has hard shadows and no sky light"},
    {"-camfile", 1, "glint renders one picture of a scene"},
    {"-trans_max_surfaces", 1, "glint has no such limit; see --reflections N"},
    {"-trans_raster3d", 0, "see --convention in 'glint render --help'"},
    {"-trans_vmd", 0, "see --convention in 'glint render --help'"},
    // pbrt, Mitsuba, Yocto/GL, Blender and programs of courses
    {"-i", 1, "SCENE", Value::scene},
    {"--input", 1, "SCENE", Value::scene},
    {"--scene-file", 1, "SCENE", Value::scene},
    {"--out", 1, "--output", Value::same},
    {"--outfile", 1, "--output", Value::same},
    {"--output-file", 1, "--output", Value::same},
    {"-w", 1, "", Value::width},
    {"--width", 1, "", Value::width},
    {"--height", 1, "", Value::height},
    {"--res", 1, "--size", Value::same},
    {"--resolution", 1, "--size", Value::same},
    {"--samples", 1, "--aa", Value::samples},
    {"--spp", 1, "--aa", Value::samples},
    {"--pixelsamples", 1, "--aa", Value::samples},
    {"--antialias", 1, "--aa", Value::same},
    {"-j", 1, "--threads", Value::same},
    {"--jobs", 1, "--threads", Value::same},
    {"--nthreads", 1, "--threads", Value::same},
    {"--num-threads", 1, "--threads", Value::same},
    {"--depth", 1, "--reflections", Value::same},
    {"--max-depth", 1, "--reflections", Value::same},
    {"--bounces", 1, "--reflections", Value::same},
    {"--seed", 1, "glint's samples are regular, and every run gives the same picture; leave it out"},
    {"--gamma", 1, "--transfer srgb"},
    {"--preview", 0, "--show"},
    {"-v", 0, "glint shows its progress on a terminal; --stats FILE.json writes figures"},
    {"--verbose", 0, "glint shows its progress on a terminal; --stats FILE.json writes figures"},
    {"--silent", 0, "--quiet"},
};

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
        case Value::none:
            return ours[0] == '-' ? answer.use(flag, ours) : answer.add_line(flag, ours);
        case Value::same:
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
    const auto named = [](std::string_view word) -> const ForeignFlag* {
        const auto* at = std::find_if(std::begin(k_flags), std::end(k_flags),
                                      [&](const ForeignFlag& f) { return f.flag == word; });
        return at == std::end(k_flags) ? nullptr : at;
    };
    const std::size_t equals = argument.starts_with("--") ? argument.find('=') : std::string::npos;
    if (equals != std::string::npos)
        return {named(std::string_view(argument).substr(0, equals)), argument.substr(equals + 1)};
    if (argument.size() > 2 && is_number(std::string_view(argument).substr(2)))
        return {named(std::string_view(argument).substr(0, 2)), argument.substr(2)};
    return {named(argument), {}};
}

bool is_sentence(const ForeignFlag& flag) { return flag.value == Value::none && !flag.ours.starts_with('-'); }

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
        const std::string size = "--size " + or_else(answer.width, "W") + "x" + or_else(answer.height, "H");
        answer.lines.insert(0, fmt::format("{}: use {}\n", answer.size_flags, size));
        answer.command.push_back(size);
    }
    if (answer.command.empty()) answer.command.emplace_back("SCENE");
    return fmt::format("{}command: glint {} {}", answer.lines, command, fmt::join(answer.command, " "));
}

}  // namespace glint::cli
