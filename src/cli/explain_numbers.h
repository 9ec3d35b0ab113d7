// SPDX-License-Identifier: Apache-2.0
#pragma once
// Numbers, vectors and colors in an explanation, and its indented lines.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "cli/explain_text.h"
#include "glint/image.h"

namespace glint::cli {

inline std::string number(double x) { return fmt::format("{:.6g}", x == 0 ? 0.0 : x); }
inline std::string vec(Vec3 v) { return fmt::format("({}, {}, {})", number(v.x), number(v.y), number(v.z)); }
inline std::string color(Color c) {
    return c.r == c.g && c.g == c.b ? number(c.r)
                                    : fmt::format("({}, {}, {})", number(c.r), number(c.g), number(c.b));
}
// The shortest decimal form that gives the same floats.
inline std::string color(const float (&c)[3]) {
    return c[0] == c[1] && c[1] == c[2] ? fmt::format("{}", c[0])
                                        : fmt::format("({}, {}, {})", c[0], c[1], c[2]);
}

// A colored block to print after the numbers of a color.
inline std::string swatch(const ExplainStyle& style, double r, double g, double b) {
    if (!style.colors) return {};
    return fmt::format("  \x1b[48;2;{};{};{}m    \x1b[0m", to_byte(static_cast<float>(r)),
                       to_byte(static_cast<float>(g)), to_byte(static_cast<float>(b)));
}

/// Lines of text, each indented by its depth.
struct IndentedText {
    void line(int depth, const std::string& content) {
        text.append(2 * static_cast<std::size_t>(std::min(depth, 40)), ' ');
        text += content;
        text += '\n';
    }

    std::string text;
};

}  // namespace glint::cli
