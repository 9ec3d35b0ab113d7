// SPDX-License-Identifier: Apache-2.0
#pragma once
// Differences of floats that a picture of bytes does not show.
#include "glint/compare.h"
#include "image/stored_picture.h"

namespace glint {

/// If hardly any of the difference between two pictures of the same size is between 0 and 1, or all of it is
/// too small for a byte (`same_bytes`): fills in the report, with a factor if one explains it, else with a
/// remark. Ignores numbers that are not finite. False if causes must be searched in the bytes.
bool is_beyond_bytes(const PictureView& a, const PictureView& b, bool same_bytes, CauseReport& report);

}  // namespace glint
