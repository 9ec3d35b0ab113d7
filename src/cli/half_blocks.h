// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>

#include "glint/image.h"

namespace glint::cli {

/// The picture as text for a terminal: 24-bit colors, two pixels per character ("▀": the upper half block).
/// It is scaled down by averaging if it is wider than `columns`.
std::string half_blocks(const Image& image, int columns, const ByteRule& rule);

}  // namespace glint::cli
