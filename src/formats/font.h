// SPDX-License-Identifier: Apache-2.0
#pragma once
// The outlines of a TrueType font, by FreeType (builds with GLINT_WITH_FREETYPE).
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

struct GlyphPoint {
    double x = 0, y = 0;
    bool is_on = true;  ///< on the contour; else it controls a parabola
};

/// All lengths are in units of the font; y is up.
struct Glyph {
    std::uint32_t number = 0;
    double advance = 0;
    double left = 0, bottom = 0, right = 0, top = 0;  ///< of all points; left as the file says it
    /// Of a glyph that is made of others, the left side of its box as the file says it, if it is above 0;
    /// else 0.
    double composed_left = 0;
    std::vector<std::vector<GlyphPoint>> contours;  ///< closed
};

class Font {
  public:
    /// The bytes must outlive the font. Null, and `why`, if they are no TrueType font.
    static std::unique_ptr<Font> open(std::string_view bytes, std::string& why);
    ~Font();
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;

    double units_per_em() const;
    /// The font's glyph for missing characters if it has none for this one. False, and `why`, if the file is
    /// damaged.
    bool read(std::uint32_t character, Glyph& glyph, std::string& why);
    /// What the file's table of kerning adds to the advance of `left` before `right`, both numbers of glyphs.
    double kerning(std::uint32_t left, std::uint32_t right);

  private:
    struct Handles;
    explicit Font(std::unique_ptr<Handles> handles);
    std::unique_ptr<Handles> handles_;
};

}  // namespace glint
