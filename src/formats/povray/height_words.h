// SPDX-License-Identifier: Apache-2.0
#pragma once
// The heights that the pixels of a picture stand for in a height_field.
#include <cstdint>
#include <string_view>

#include "base/memory_budget.h"
#include "glint/texture.h"

namespace glint::povray {

/// The heights of a picture in parts of 65536, rows from the bottom. file: the bytes of its file. False for
/// kinds of pictures that were not compared with POV-Ray: TGA with a palette or 5 bits a channel, and PPM and
/// PGM with a greatest number other than 255 and 65535. A PNG file with a palette: its
/// png_of_palette_numbers().
bool read_heights(const TextureImage& image, std::string_view file, CountedVector<std::uint16_t>& heights);

}  // namespace glint::povray
