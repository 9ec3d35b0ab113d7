// SPDX-License-Identifier: Apache-2.0
#pragma once
// The textures of .mtl files: map_Kd and map_d.
#include <cstdint>
#include <optional>
#include <string>

#include "formats/line_words.h"
#include "formats/load_state.h"
#include "glint/texture.h"

namespace glint {

/// A statement `map_Kd` or `map_d`: the name of the picture, and where it is on the surface.
struct MtlMap {
    std::string name;
    Token at;                ///< the name
    std::uint16_t file = 0;  ///< the .mtl, in LoadState::texts
    bool clamps = false;     ///< -clamp on
    UvMap uv_map{};          ///< -s, then -o
};

/// Reads the options and the name. What was expected instead, or an empty string.
std::string read_mtl_map(LineWords& words, std::uint16_t file, MtlMap& map);

/// The texture of a material's map_Kd, its map_d, or both. Nothing if no picture can be read, which is a
/// warning.
std::optional<Texture> mtl_texture(LoadState& reading, const std::optional<MtlMap>& color,
                                   const std::optional<MtlMap>& opacity);

}  // namespace glint
