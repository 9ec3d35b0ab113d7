// SPDX-License-Identifier: Apache-2.0
#pragma once
// Reading picture files.
#include <string>

#include "glint/image.h"

namespace glint::cli {

/// The picture of a file and what decode() says about it. Throws Failure: of input, if there is none.
DecodedImage read_picture(const std::string& path);

/// The same, without a Failure: "no such file".
Result<DecodedImage> try_picture(const std::string& path);

}  // namespace glint::cli
