// SPDX-License-Identifier: Apache-2.0
#include "formats/glint_color_map.h"

#include <fmt/format.h>

namespace glint {
namespace {

// place, color) or place, color, alpha). False after an error.
bool read_rest_of_color(GlintText& t, bool has_alpha, TextureColor& color) {
    const ValueReader read{t};
    if (!t.p.number(color.at, k_fraction) || !t.p.expect(',')) return false;
    if (!read(ColorType{k_channel, ColorUse::surface}, color.color)) return false;
    if (has_alpha && t.p.accept(',') && !t.p.token().is(')') && !t.p.number(color.alpha, k_fraction))
        return false;
    return t.p.expect(')');
}

bool read_map_color(GlintText& t, bool has_alpha, TextureColor& color) {
    if (!t.p.accept('(')) {
        t.p.expected("a place and a color: `(0, (1, 1, 1))`");
        return false;
    }
    const bool is_whole = read_rest_of_color(t, has_alpha, color);
    if (!is_whole) t.p.skip_to_close(')');
    return is_whole;
}

}  // namespace

bool read_color_map(GlintText& t, const Token& at, bool has_alpha, std::vector<TextureColor>& colors) {
    const auto errors = t.reading.diagnostics.error_count();
    read_list(t, "places and colors `(0, (1, 1, 1))`", [&] {
        const Token begin = t.p.token();
        TextureColor color;
        if (!read_map_color(t, has_alpha, color)) return false;
        if (colors.size() == k_max_texture_colors) {
            t.p.error(begin, fmt::format("expected at most {} colors", k_max_texture_colors));
            return false;
        }
        if (!colors.empty() && color.at < colors.back().at) {
            t.p.error(begin,
                      fmt::format("expected a place of at least {}, that of the color before, found {}",
                                  colors.back().at, color.at));
            return false;
        }
        colors.push_back(color);
        return true;
    });
    if (errors != t.reading.diagnostics.error_count()) return false;
    if (!colors.empty()) return true;
    t.p.error(at, "expected at least one color in `color_map`");
    return false;
}

}  // namespace glint
