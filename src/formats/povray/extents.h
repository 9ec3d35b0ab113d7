// SPDX-License-Identifier: Apache-2.0
#pragma once
// The values of min_extent() and max_extent(): POV-Ray's boxes around objects, which are not always the
// smallest.
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

#include "formats/povray/object.h"

namespace glint::povray {

struct Extent {
    Vec3 low{1e10, 1e10, 1e10}, high{-1e10, -1e10, -1e10};
};

/// Nothing, and `why`, for objects whose box is not known. spend: counts steps, and returns false to stop.
std::optional<Extent> extent_of(const Object& object, const std::function<bool(std::uint64_t)>& spend,
                                std::string_view& why);

/// Whether POV-Ray's box around `bounds` is smaller than that around the object, which reaches out of it:
/// POV-Ray takes the box that has less volume. False where one of them is not known.
bool leaves_bounds(const Object& object, const Object& bounds,
                   const std::function<bool(std::uint64_t)>& spend);

}  // namespace glint::povray
