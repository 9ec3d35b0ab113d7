// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the properties of vertices and faces in a PLY file become.
#include <algorithm>
#include <string_view>
#include <vector>

#include "formats/ply_header.h"

namespace glint {

/// What a property of a vertex becomes: a coordinate of the position or of the normal, a channel of the
/// color, a texture coordinate, or nothing. Of a face, only the color is used.
inline constexpr int k_normal_column = 3, k_color_column = 6, k_texture_column = 9, k_ply_columns = 11;
inline int ply_column(std::string_view name) {
    constexpr std::string_view names[k_ply_columns] = {"x",   "y",     "z",    "nx", "ny", "nz",
                                                       "red", "green", "blue", "s",  "t"};
    if (name.starts_with("diffuse_")) name.remove_prefix(8);
    if (name == "u" || name == "texture_u") name = "s";
    if (name == "v" || name == "texture_v") name = "t";
    const auto found = std::find(std::begin(names), std::end(names), name);
    return found == std::end(names) ? -1 : static_cast<int>(found - names);
}

/// The columns of an element's properties.
inline std::vector<int> columns_of(const PlyElement& element) {
    std::vector<int> columns;
    for (const PlyProperty& p : element.properties) columns.push_back(p.count_type ? -1 : ply_column(p.name));
    return columns;
}

/// Whether an element has all columns from `first` up to `end`.
inline bool has_columns(const PlyElement& element, int first, int end) {
    const std::vector<int> columns = columns_of(element);
    for (; first < end; ++first) {
        if (std::find(columns.begin(), columns.end(), first) == columns.end()) return false;
    }
    return true;
}
inline bool has_colors(const PlyElement& element) {
    return has_columns(element, k_color_column, k_texture_column);
}

/// The number that stands for a full channel: files have whole numbers of bytes, even in larger types.
inline double full_channel(PlyType type) {
    switch (type) {
        case PlyType::float32:
        case PlyType::float64:
            return 1;
        case PlyType::uint16:
            return 65535;
        case PlyType::int8:
        case PlyType::uint8:
        case PlyType::int16:
        case PlyType::int32:
        case PlyType::uint32:
            return 255;
    }
    return 255;
}

}  // namespace glint
