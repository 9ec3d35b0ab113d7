// SPDX-License-Identifier: Apache-2.0
#include "cli/print_text.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "base/text.h"
#include "os/files.h"
#include "os/process.h"

namespace glint::cli {
namespace {

void write_out(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

// Of a well-formed character of at most three bytes: those that do not print have no more.
unsigned code_of(std::string_view character) {
    const auto byte = [&](std::size_t i) {
        return static_cast<unsigned>(static_cast<unsigned char>(character[i]));
    };
    if (character.size() == 1) return byte(0);
    if (character.size() == 2) return (byte(0) & 0x1f) << 6 | (byte(1) & 0x3f);
    return (byte(0) & 0x0f) << 12 | (byte(1) & 0x3f) << 6 | (byte(2) & 0x3f);
}

// The length of the swatch that the text begins with; 0: none. It can change the color of four blanks only.
std::size_t swatch_length(std::string_view text) {
    constexpr std::string_view begin = "\x1b[48;2;", longest = "255;255;255", end = "m    \x1b[0m";
    if (!text.starts_with(begin)) return 0;
    const std::size_t numbers_end = text.find_first_not_of("0123456789;", begin.size());
    if (numbers_end == std::string_view::npos || numbers_end > begin.size() + longest.size()) return 0;
    return text.substr(numbers_end).starts_with(end) ? numbers_end + end.size() : 0;
}

}  // namespace

void print_text(std::string_view text) { write_out(printable_lines(text)); }

void print_text_with_swatches(std::string_view text) {
    if (!prints_colors()) return print_text(text);
    std::string out;
    while (!text.empty()) {
        const std::size_t swatch = swatch_length(text);
        out += text.substr(0, swatch);
        text.remove_prefix(swatch);
        const std::size_t next = swatch > 0 ? 0 : 1;  // an escape character that begins no swatch
        const std::string_view plain = text.substr(0, text.find('\x1b', next));
        out += printable_lines(plain);
        text.remove_prefix(plain.size());
    }
    write_out(out);
}

bool prints_colors() {
    const char* const no_color = std::getenv("NO_COLOR");
    return os::is_terminal(os::k_standard_output) && (no_color == nullptr || *no_color == '\0');
}

void print_json(std::string_view json) {
    std::string out;
    while (!json.empty()) {
        const Character c = first_character(json);
        const std::string_view bytes = json.substr(0, c.length);
        json.remove_prefix(c.length);
        // Between the values there are newlines; in strings, JSON has none.
        out +=
            c.is_printable || bytes == "\n" ? std::string(bytes) : fmt::format("\\u{:04x}", code_of(bytes));
    }
    write_out(out);
}

}  // namespace glint::cli
