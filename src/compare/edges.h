// SPDX-License-Identifier: Apache-2.0
#pragma once
// Faults whose exact picture is not known, but within which limits every pixel lies.
#include <string>

#include "compare/byte_picture.h"

namespace glint {

/// "to the right and down".
std::string direction_text(int dx, int dy);

/// Every channel of `faulty`, moved no further than into the range that the reference has in the
/// neighbourhood [x + left, x + right] x [y + up, y + down]. What a picture with other samples in its pixels
/// can be: where two colours meet, anything between them, and elsewhere what it was.
/// Fills these rows of `out`.
void nearest_between(const BytePicture& reference, const BytePicture& faulty, int left, int right, int up,
                     int down, const Rows& rows, int threads, BytePicture& out);

/// The reference, with those pixels of `faulty` that are specks: clearly darker, away from edges, among
/// neighbours that are as in the reference. Fills these rows of `out`.
void put_dark_specks(const BytePicture& reference, const BytePicture& faulty, const Rows& rows, int threads,
                     BytePicture& out);

}  // namespace glint
