// SPDX-License-Identifier: Apache-2.0
#pragma once
// The valid ranges of a scene's numbers, for the readers, which report the number's place, and for
// validate().
#include <limits>
#include <string_view>

#include "glint/scene.h"
#include "glint/vec.h"

namespace glint {

/// The numbers from min to max. `open`: excluding min (and, if both_open, max).
struct Range {
    double min, max;
    bool open, both_open;
    std::string_view text;  ///< "a number > 0"

    /// False for NaN and infinity.
    constexpr bool contains(double x) const {
        return (open ? x > min : x >= min) && (both_open ? x < max : x <= max);
    }
};

// Outside these ranges a double has too few digits for the shapes, or a square overflows in the
// formulas.
inline constexpr Range k_coordinate{-1e12, 1e12, false, false, "a number from -1e12 to 1e12"};
inline constexpr Range k_length{0, 1e12, true, false, "a number > 0 and at most 1e12"};
/// Channels of lights and materials. Negative ones are rendered as written.
inline constexpr Range k_channel{-1e6, 1e6, false, false, "a number from -1e6 to 1e6"};
inline constexpr Range k_tint{0, 1e6, false, false, "a number from 0 to 1e6"};
inline constexpr Range k_fraction{0, 1, false, false, "a number from 0 to 1"};
inline constexpr Range k_exponent{0, 1e9, false, false, "a number from 0 to 1e9"};
inline constexpr Range k_angle{0, 180, true, true, "an angle between 0 and 180 degrees"};
/// Of a spot's cone, off its axis.
inline constexpr Range k_cone_angle{0, 180, false, false, "an angle from 0 to 180 degrees"};
inline constexpr Range k_cone_limit{0, 180, true, false, "an angle > 0 and at most 180 degrees"};
inline constexpr Range k_gamma{0, 100, true, false, "a number > 0 and at most 100"};
inline constexpr Range k_index_of_refraction{0, 1e6, true, false, "a number > 0 and at most 1e6"};
inline constexpr Range k_attenuation{0, 1e12, false, false, "a number from 0 to 1e12"};
inline constexpr Range k_not_negative{0, 1e12, false, false, "a number from 0 to 1e12"};
inline constexpr Range k_threshold{0, 1e6, false, false, "a number from 0 to 1e6"};
/// Of occlusion: the greatest distance of a shape that blocks.
inline constexpr Range k_reach{0, std::numeric_limits<double>::infinity(), true, false, "a number > 0"};
inline constexpr Range k_occlusion_samples{1, 4096, false, false, "a whole number from 1 to 4096"};

inline constexpr Range k_light_samples{1, 64, false, false, "a whole number from 1 to 64"};
inline constexpr Range k_interior{0, k_max_interior, false, false, "a whole number from 0 to 1000000000"};
static_assert(k_interior.max == 1000000000, "its text names k_max_interior");
inline constexpr Range k_level{0, 16, false, false, "a whole number from 0 to 16"};

inline bool is_coordinate(Vec3 p) {
    return k_coordinate.contains(p.x) && k_coordinate.contains(p.y) && k_coordinate.contains(p.z);
}
inline bool is_zero(Vec3 v) { return v == Vec3{0, 0, 0}; }

}  // namespace glint
