// SPDX-License-Identifier: Apache-2.0
// The values of glint's own language: colors, names, words.
#include <fmt/format.h>

#include "formats/glint_text.h"

namespace glint {
namespace {

constexpr Range k_byte_channel{0, 255, false, false, "a number from 0 to 255"};
constexpr std::string_view k_color_forms = "a color: (r, g, b) from 0 to 1, rgb255(r, g, b) or \"#rrggbb\"";

// "#rrggbb" or "#rgb", without its quotes.
bool parse_hex(std::string_view text, Color& color) {
    if (!text.starts_with('#') || (text.size() != 7 && text.size() != 4)) return false;
    const std::size_t digits = text.size() == 7 ? 2 : 1;
    double channels[3];
    for (std::size_t i = 0; i < 3; ++i) {
        int value = 0;
        for (std::size_t k = 0; k < 2; ++k) {
            const int digit = hex_digit(text[1 + i * digits + (digits == 2 ? k : 0)]);
            if (digit < 0) return false;
            value = value * 16 + digit;
        }
        channels[i] = value / 255.0;
    }
    color = {channels[0], channels[1], channels[2]};
    return true;
}

// An unquoted #c8a028 is a comment, so the next token is the one after it.
bool follows_bare_hex(const GlintText& t) {
    const auto before = t.text.place.text.substr(0, t.p.token().offset);
    const auto equals = before.rfind('=');
    if (equals == std::string_view::npos) return false;
    const auto rest = before.substr(equals + 1);
    const auto first = rest.find_first_not_of(" \t");
    return first != std::string_view::npos && rest[first] == '#';
}

double largest(Color c) {
    const double rg = c.r > c.g ? c.r : c.g;
    return rg > c.b ? rg : c.b;
}

void warn_of_bytes(GlintText& t, const Token& at, Color color, ColorUse use) {
    const double limit = use == ColorUse::surface ? 1 : use == ColorUse::coefficient ? 4 : 10;
    if (largest(color) <= limit) return;
    t.p.warn(at,
             "colors go from 0 to 1, and this one is used unchanged; for 0 to 255 write "
             "rgb255(r, g, b)");
}

}  // namespace

bool read_color(GlintText& t, Color& color, const Range& range, ColorUse use) {
    const Token at = t.p.token();
    double v[3] = {};
    if (at.is('(')) {
        if (!t.p.triple(v, range, '(', ')')) return false;
        color = {v[0], v[1], v[2]};
        warn_of_bytes(t, at, color, use);
        return true;
    }
    if (at.kind == TokenKind::word && t.p.text(at) == "rgb255") {
        t.p.take();
        if (!t.p.triple(v, k_byte_channel, '(', ')')) return false;
        color = {v[0] / 255, v[1] / 255, v[2] / 255};
        return true;
    }
    if (at.kind == TokenKind::string && parse_hex(t.p.name(at), color)) {
        t.p.take();
        return true;
    }
    if (follows_bare_hex(t)) {
        t.p.error(at,
                  fmt::format("expected a color, found {}: `#` begins a comment; write \"#rrggbb\" in quotes",
                              t.p.describe(at)));
    } else {
        t.p.expected(k_color_forms);
    }
    return false;
}

bool read_direction(GlintText& t, Vec3& direction) {
    const Token at = t.p.token();
    const auto errors = t.reading.diagnostics.error_count();
    if (!read_point(t, direction)) return false;
    if (direction == Vec3{0, 0, 0} && errors == t.reading.diagnostics.error_count()) {
        t.p.error(at, "expected a direction other than (0, 0, 0)");
    }
    return true;
}

bool ValueReader::operator()(AttenuationType, Attenuation& attenuation) const {
    double c[3] = {};
    if (!t.p.triple(c, k_attenuation, '(', ')')) return false;
    attenuation = {c[0], c[1], c[2]};
    return true;
}

bool read_whole(GlintText& t, std::int32_t& value, const Range& range) {
    const Token at = t.p.token();
    double number = 0;
    if (!t.p.number(number, range)) return false;
    if (!range.contains(number)) return true;  // number() has reported it
    value = static_cast<std::int32_t>(number);
    if (value != number) t.p.error(at, fmt::format("expected {}, found {}", range.text, t.p.describe(at)));
    return true;
}

bool read_bool(GlintText& t, bool& value) {
    static constexpr std::string_view words[] = {"false", "true"};
    int index = 0;
    if (!t.p.choice(words, "`true` or `false`", index)) return false;
    value = index == 1;
    return true;
}

bool read_name(GlintText& t, std::string_view what, Token& name) {
    const TokenKind kind = t.p.token().kind;
    if ((kind != TokenKind::word && kind != TokenKind::string) || t.p.name(t.p.token()).empty()) {
        t.p.expected(what);
        return false;
    }
    name = t.p.take();
    return true;
}

bool read_setting_text(GlintText& t, std::string& value) {
    const Token first = t.p.token();
    if (first.kind == TokenKind::string) {
        value = t.p.name(t.p.take());
        return true;
    }
    if (first.kind != TokenKind::word && first.kind != TokenKind::number &&
        first.kind != TokenKind::malformed) {
        t.p.expected("a value");
        return false;
    }
    std::size_t end = first.offset;
    const auto take = [&] {
        const Token token = t.p.take();
        end = token.offset + token.length;
    };
    const auto is_value = [&] {
        const TokenKind kind = t.p.token().kind;
        return kind == TokenKind::word || kind == TokenKind::number || kind == TokenKind::malformed;
    };
    const auto times = [&] {
        return t.p.token().kind == TokenKind::word && t.p.text(t.p.token()).starts_with('x');
    };
    take();
    while (is_value() && t.p.token().offset == end) take();
    if (first.kind != TokenKind::word && times() && !t.p.peek().is('=')) {
        take();
        if (t.p.token().kind == TokenKind::number) take();
    }
    value = t.text.place.text.substr(first.offset, end - first.offset);
    return true;
}

std::string block_name(const GlintText& t) {
    return t.blocks.label() ? t.p.name(*t.blocks.label()) : std::string();
}

}  // namespace glint
