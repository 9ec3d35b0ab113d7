// SPDX-License-Identifier: Apache-2.0
// Colors: rgb, rgbft, srgb, components by name, identifiers.
#include "formats/povray/value_parser.h"
#include "math/elementary.h"

namespace glint::povray {
namespace {

// The inverse of sRGB's transfer function (IEC 61966-2-1).
double decoded(double c) { return c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4); }

}  // namespace

// The number whose byte in the picture is that of sRGB (measured with numbers of assumed_gamma).
double ValueParser::of_srgb(double c) const {
    if (is_gamma_srgb_) return c;
    const double linear = decoded(c);
    return gamma_ && *gamma_ > 0 && linear > 0 ? pow(linear, 1 / *gamma_) : linear;
}

bool ValueParser::begins_color(const Token& token) {
    if (token.kind != TokenKind::word) return false;
    switch (token.word()) {
#define GLINT_POV_WORD(word) case Word::k_##word:
        GLINT_POV_COLOR_WORDS(GLINT_POV_WORD)
#undef GLINT_POV_WORD
        return true;
        default:
            return false;
    }
}

// A color; a number or a vector of three counts as one if `from_numbers`.
std::array<double, 5> ValueParser::color(bool from_numbers) {
    std::array<double, 5> out{0, 0, 0, 0, 0};
    if (peek().word() == Word::k_color || peek().word() == Word::k_colour) {
        take();
        from_numbers = true;
    }
    const Token first = peek();
    bool is_any = false;
    while (!failed()) {
        const Word word = peek().word();
        std::size_t component = 5;
        switch (word) {
            case Word::k_rgb:
            case Word::k_rgbf:
            case Word::k_rgbt:
            case Word::k_rgbft:
            case Word::k_srgb:
            case Word::k_srgbf:
            case Word::k_srgbt:
            case Word::k_srgbft: {
                if (is_any) return out;  // the next color of a list
                take();
                Numbers value = expression();
                const bool has_filter = word == Word::k_rgbf || word == Word::k_srgbf;
                const bool has_transmit = word == Word::k_rgbt || word == Word::k_srgbt;
                const bool has_both = word == Word::k_rgbft || word == Word::k_srgbft;
                const int terms = has_both ? 5 : has_filter || has_transmit ? 4 : 3;
                if (!value.is_color()) {
                    value = promoted(value, terms);
                    if (has_transmit) std::swap(value.v[3], value.v[4]);
                    if (terms == 3) value.v[3] = value.v[4] = 0;
                }
                if (word >= Word::k_srgb && word <= Word::k_srgbt) {
                    for (std::size_t i = 0; i < 3; ++i) value.v[i] = of_srgb(value.v[i]);
                }
                out = value.v;
                break;
            }
            case Word::k_red:
                component = 0;
                break;
            case Word::k_green:
                component = 1;
                break;
            case Word::k_blue:
                component = 2;
                break;
            case Word::k_filter:
                component = 3;
                break;
            case Word::k_transmit:
                component = 4;
                break;
            default: {
                if (is_any || !begins_number(peek())) {
                    if (!is_any) expected("a color");
                    return out;
                }
                Numbers value = expression();
                if (!value.is_color()) {
                    if (!from_numbers && !failed()) {
                        error(first, "expected a color (`rgb` before the numbers)");
                        return out;
                    }
                    value = promoted(value, value.terms < 3 ? 3 : value.terms);
                }
                out = value.v;
            }
        }
        if (component < 5) {
            take();
            out[component] = number();
        }
        is_any = true;
    }
    return out;
}

Numbers ValueParser::color_value() {
    Numbers value;
    value.v = color(true);
    value.terms = 5;
    return value;
}

}  // namespace glint::povray
