// SPDX-License-Identifier: Apache-2.0
#pragma once
// Differences of floats that a picture of bytes does not show.
#include "glint/compare.h"

namespace glint {

/// If hardly anything of the difference of two pictures of one size is between 0 and 1, or none of it is
/// large enough for a byte (`same_bytes`): fills in the report, by a factor if one explains it, else by a
/// remark. Numbers that are not finite are passed over. False if causes are to be looked for in the bytes.
bool is_beyond_bytes(const Image& a, const Image& b, bool same_bytes, CauseReport& report);

}  // namespace glint
