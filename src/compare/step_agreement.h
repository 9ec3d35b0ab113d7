// SPDX-License-Identifier: Apache-2.0
#pragma once
// Whether two pictures show the same things.
#include <optional>

#include "compare/byte_picture.h"

namespace glint {

/// How well the steps of color between neighbours in a row agree in two pictures: 1 if all steps of one are
/// within a pixel of the other's, about 0 by chance.
struct StepAgreement {
    double one_way = 0;  ///< the steps of the picture that agrees better: the other may have more
    double both_ways = 0;
};
/// For these rows. Nothing if a picture has hardly any steps.
std::optional<StepAgreement> step_agreement(const BytePicture& a, const BytePicture& b, const Rows& rows);

/// Two pictures with at least this agreement show the same things.
inline constexpr double k_same_view = 0.4;

}  // namespace glint
