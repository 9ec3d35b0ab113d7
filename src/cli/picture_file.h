// SPDX-License-Identifier: Apache-2.0
#pragma once
// Reading picture files.
#include <string>

#include "glint/image.h"

namespace glint::cli {

/// The picture of a file and what decode() says about it. Throws Failure: of input, if there is none.
DecodeResult read_picture(const std::string& path);

/// The same, with `error` set in place of a Failure: "no such file".
DecodeResult try_picture(const std::string& path);

}  // namespace glint::cli
