// SPDX-License-Identifier: Apache-2.0
#pragma once
// Reading picture files.
#include <cstdint>
#include <string>

#include "image/decoders.h"

namespace glint::cli {

/// The picture of a file and what decode() says about it. Throws Failure: of input, if there is none.
DecodedImage read_picture(const std::string& path);

/// The same, with the numbers of the file. max_memory: DecodeOptions::max_memory.
DecodedPicture read_stored_picture(const std::string& path, std::uint64_t max_memory = 0);

/// The picture of a submission, without a Failure: "no such file". Not of a link that leaves the picture's
/// folder.
Result<DecodedImage> try_handed_in(const std::string& path);

}  // namespace glint::cli
