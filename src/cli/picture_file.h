// SPDX-License-Identifier: Apache-2.0
#pragma once
// Reading picture files.
#include <string>

#include "image/decoders.h"

namespace glint::cli {

/// The picture of a file and what decode() says about it. max_memory: DecodeOptions::max_memory. Throws
/// Failure: of input, if there is none.
DecodedImage read_picture(const std::string& path, std::uint64_t max_memory = 0);

/// The same, without a Failure: "no such file".
Result<DecodedImage> try_picture(const std::string& path, std::uint64_t max_memory = 0);

/// As read_picture(), with the numbers of the file.
DecodedPicture read_stored_picture(const std::string& path, std::uint64_t max_memory = 0);

}  // namespace glint::cli
