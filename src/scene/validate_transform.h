// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a transform must be.
#include <string_view>

#include "glint/vec.h"

namespace glint {

/// What is wrong, to follow the name of the transform; empty if nothing is.
std::string_view mistake_in(const Affine& map);

}  // namespace glint
