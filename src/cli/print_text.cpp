// SPDX-License-Identifier: Apache-2.0
#include "cli/print_text.h"

#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "base/text.h"

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

}  // namespace

void print_text(std::string_view text) { write_out(printable_lines(text)); }

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
