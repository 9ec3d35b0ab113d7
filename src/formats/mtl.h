// SPDX-License-Identifier: Apache-2.0
#pragma once
// .mtl: the materials of .obj files. docs/formats/obj.md.
#include <string>
#include <string_view>
#include <vector>

#include "formats/mtl_texture.h"

namespace glint {

struct MtlMaterial {
    Material material;  ///< without its texture
    std::optional<MtlMap> color_map, opacity_map;
    SourcePlace place;
};
using MtlMaterials = CountedMap<std::string, MtlMaterial>;  ///< by name

/// The names in an `mtllib` statement: they end in .mtl, and may have blanks inside. What remains is the last
/// one.
inline constexpr std::string_view k_mtl_extension = ".mtl";
std::vector<std::string_view> library_names(std::string_view names);

/// Adds the materials of a text.
void read_mtl(LoadState& reading, const ReadText& text, MtlMaterials& materials);

}  // namespace glint
