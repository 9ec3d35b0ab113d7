// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fog on the ground (Fog::falloff).

namespace glint {

/// A line in fog on the ground. Heights above Fog::height are in units of its falloff.
struct FogLine {
    double height = 0;  ///< at t = 0
    double slope = 0;   ///< the change of the height by t
};

/// The integral over t, from `begin` to `end`, of the fog's density as a part of the whole density. Negative
/// if end < begin. end may be infinite: the result is then at most 1e200.
double fog_along(FogLine line, double begin, double end);

}  // namespace glint
