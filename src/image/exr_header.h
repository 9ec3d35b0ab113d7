// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "image/decoders.h"

namespace glint {

/// What OpenEXR allocates to read a file, besides the picture: upper bounds.
struct ExrMemory {
    std::uint64_t bytes = 0;
    /// For each sample of a file whose pixels have several ("deep"); 0 for other files.
    std::uint64_t sample_bytes = 0;
    std::uint64_t pixels = 0;  ///< of the data windows
};

/// OpenEXR allocates the memory that a header asks for before it checks the file's length, and for some types
/// it ignores the attribute's length. Therefore the lengths, the picture's size and the number of tiles are
/// checked first. Throws Undecodable if the library must not read this file. bytes: a file of
/// more than 8 bytes.
ExrMemory check_exr_header(ByteSpan bytes, const DecodeOptions& options);

}  // namespace glint
