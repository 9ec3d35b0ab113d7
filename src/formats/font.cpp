// SPDX-License-Identifier: Apache-2.0
// All numbers are those of the file, without scaling or hints, so that they are the same with each FreeType.
#include "formats/font.h"

#include <fmt/format.h>
#include <ft2build.h>

#include <algorithm>
#include FT_FREETYPE_H
#include FT_TRUETYPE_TABLES_H
#include FT_TRUETYPE_TAGS_H

namespace glint {
namespace {

// Of Windows' fonts of symbols, the characters begin here.
constexpr FT_ULong k_symbols = 0xf000;

// FreeType itself chooses a table of Unicode, if there is one.
void choose_characters(FT_Face face) {
    const auto choose = [&](int platform, int encoding) {
        for (int i = 0; i < face->num_charmaps && face->charmap == nullptr; ++i) {
            FT_CharMap map = face->charmaps[i];
            if (map->platform_id == platform && map->encoding_id == encoding) FT_Set_Charmap(face, map);
        }
    };
    choose(3, 0);
    choose(1, 0);
}

FT_UInt glyph_number(FT_Face face, FT_ULong character) {
    const FT_UInt number = FT_Get_Char_Index(face, character);
    const bool is_symbol = face->charmap != nullptr && face->charmap->platform_id == 3 &&
                           face->charmap->encoding_id == 0 && character < 256;
    return number == 0 && is_symbol ? FT_Get_Char_Index(face, k_symbols + character) : number;
}

bool read_contours(const FT_Outline& outline, Glyph& glyph) {
    int first = 0;
    for (int i = 0; i < outline.n_contours; ++i) {
        const int last = outline.contours[i];
        if (last < first || last >= outline.n_points) return false;
        std::vector<GlyphPoint> contour;
        contour.reserve(static_cast<std::size_t>(last - first + 1));
        for (int k = first; k <= last; ++k) {
            const int tag = FT_CURVE_TAG(outline.tags[k]);
            if (tag == FT_CURVE_TAG_CUBIC) return false;
            contour.push_back({static_cast<double>(outline.points[k].x),
                               static_cast<double>(outline.points[k].y), tag == FT_CURVE_TAG_ON});
        }
        glyph.contours.push_back(std::move(contour));
        first = last + 1;
    }
    return true;
}

// As the file says it, which need not be where the outline begins; that of the outline if it says nothing.
double left_side(FT_Face face, FT_UInt glyph, double otherwise) {
    const auto* head = static_cast<const TT_HoriHeader*>(FT_Get_Sfnt_Table(face, FT_SFNT_HHEA));
    if (head == nullptr) return otherwise;
    const FT_UInt full = head->number_Of_HMetrics;
    const FT_UInt at = glyph < full ? 4 * glyph + 2 : 4 * full + 2 * (glyph - full);
    FT_Byte bytes[2] = {0, 0};
    FT_ULong length = 2;
    if (FT_Load_Sfnt_Table(face, TTAG_hmtx, static_cast<FT_Long>(at), bytes, &length) != 0) return otherwise;
    return static_cast<std::int16_t>(bytes[0] << 8 | bytes[1]);
}

void measure(Glyph& glyph) {
    bool is_first = true;
    for (const auto& contour : glyph.contours) {
        for (const GlyphPoint& p : contour) {
            glyph.left = is_first ? p.x : std::min(glyph.left, p.x);
            glyph.right = is_first ? p.x : std::max(glyph.right, p.x);
            glyph.bottom = is_first ? p.y : std::min(glyph.bottom, p.y);
            glyph.top = is_first ? p.y : std::max(glyph.top, p.y);
            is_first = false;
        }
    }
}

}  // namespace

struct Font::Handles {
    FT_Library library = nullptr;
    FT_Face face = nullptr;

    Handles() = default;
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;
    ~Handles() {
        if (face != nullptr) FT_Done_Face(face);
        if (library != nullptr) FT_Done_FreeType(library);
    }
};

Font::Font(std::unique_ptr<Handles> handles) : handles_(std::move(handles)) {}
Font::~Font() = default;

std::unique_ptr<Font> Font::open(std::string_view bytes, std::string& why) {
    using namespace std::string_view_literals;
    // FreeType knows many formats.
    if (!bytes.starts_with("\0\1\0\0"sv) && !bytes.starts_with("true")) {
        why = bytes.starts_with("OTTO") ? "expected a font of TrueType's outlines, found those of PostScript"
                                        : "expected a TrueType font";
        return nullptr;
    }
    auto handles = std::make_unique<Handles>();
    if (FT_Init_FreeType(&handles->library) != 0) {
        why = "FreeType cannot be used";
        return nullptr;
    }
    const int error = FT_New_Memory_Face(handles->library, reinterpret_cast<const FT_Byte*>(bytes.data()),
                                         static_cast<FT_Long>(bytes.size()), 0, &handles->face);
    if (error != 0 || handles->face->units_per_EM == 0 || !FT_IS_SCALABLE(handles->face)) {
        why = fmt::format("the font is damaged (FreeType's error {})", error);
        return nullptr;
    }
    choose_characters(handles->face);
    return std::unique_ptr<Font>(new Font(std::move(handles)));
}

double Font::units_per_em() const { return handles_->face->units_per_EM; }

bool Font::read(std::uint32_t character, Glyph& glyph, std::string& why) {
    const FT_Face face = handles_->face;
    glyph = {};
    glyph.number = glyph_number(face, character);
    int error = FT_Load_Glyph(face, glyph.number, FT_LOAD_NO_RECURSE);
    if (error == 0 && face->glyph->format == FT_GLYPH_FORMAT_COMPOSITE)
        glyph.composed_left = std::max(0.0, static_cast<double>(face->glyph->metrics.horiBearingX));
    if (error == 0) error = FT_Load_Glyph(face, glyph.number, FT_LOAD_NO_SCALE);
    const bool is_outline = error == 0 && face->glyph->format == FT_GLYPH_FORMAT_OUTLINE;
    if (!is_outline || !read_contours(face->glyph->outline, glyph)) {
        why = fmt::format("the font's glyph {} is damaged (FreeType's error {})", glyph.number, error);
        return false;
    }
    glyph.advance = static_cast<double>(face->glyph->metrics.horiAdvance);
    measure(glyph);
    if (!glyph.contours.empty()) glyph.left = left_side(face, glyph.number, glyph.left);
    return true;
}

double Font::kerning(std::uint32_t left, std::uint32_t right) {
    FT_Vector kerning{};
    if (FT_Get_Kerning(handles_->face, left, right, FT_KERNING_UNSCALED, &kerning) != 0) return 0;
    return static_cast<double>(kerning.x);
}

}  // namespace glint
