// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "glint/glint.h"

namespace glint::cli {

/// Puts a rendering of `part` into a picture of the size of `whole`, black and opaque around it.
void put_in_whole(Rendering& rendering, const Crop& whole, const Crop& part);

}  // namespace glint::cli
