// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "image/decoders.h"

namespace glint {

/// OpenEXR allocates the memory that a header asks for before it checks the file's length, and for some types
/// it ignores the attribute's length. Therefore the lengths, the picture's size and the number of tiles are
/// checked first. Throws Undecodable if the library must not read this file. bytes: a file of
/// more than 8 bytes.
void check_exr_header(ByteSpan bytes, const DecodeOptions& options);

}  // namespace glint
