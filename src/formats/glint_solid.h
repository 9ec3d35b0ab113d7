// SPDX-License-Identifier: Apache-2.0
#pragma once
// The solids of .glint: blocks of shapes, `difference { ... }`.
#include <optional>
#include <string_view>

#include "formats/glint_item.h"

namespace glint {

/// The keys of a solid: those of groups, and a color.
inline constexpr auto k_solid_fields = [] {
    std::array<Field, std::size(k_item_fields) + 1> all{};
    std::copy(std::begin(k_item_fields), std::end(k_item_fields), all.begin());
    all.back() = {"shape_color"};
    return all;
}();

/// A block that is open.
struct GlintSolid {
    SolidOperation operation = SolidOperation::merge;
    std::size_t first_shape = 0;  ///< its parts are the scene's shapes from this one on
    GlintContext around;
    std::optional<Color> color;
    std::string name;
};

/// Makes the solid of the shapes that the block holds. word: the block's; item: its keys.
void close_glint_solid(GlintText& t, const Token& word, GlintSolid& solid, const GlintItem& item);

}  // namespace glint
