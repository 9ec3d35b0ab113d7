// SPDX-License-Identifier: Apache-2.0
#pragma once
// Do two pictures show the same things?
#include <optional>

#include "compare/byte_picture.h"

namespace glint {

/// How well two pictures' steps of colour, from a pixel to the next in a row, agree: 1 if all of one's are
/// within a pixel of the other's, about 0 by chance.
struct StepAgreement {
    double one_way = 0;  ///< the steps of one picture, whichever agrees better: the other may have more
    double both_ways = 0;
};
/// Of these rows. Nothing if a picture has hardly any steps.
std::optional<StepAgreement> step_agreement(const BytePicture& a, const BytePicture& b, const Rows& rows);

/// From here on two pictures show the same things.
inline constexpr double k_same_view = 0.4;

}  // namespace glint
