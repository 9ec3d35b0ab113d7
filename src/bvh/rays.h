// SPDX-License-Identifier: Apache-2.0
#pragma once
// Streams of rays, as structure of arrays.

namespace glint {

inline constexpr int k_packet_size = 64;  // maximum rays that traverse the hierarchy together
inline constexpr int k_ray_padding = 16;  // arrays of rays may be read (not used) this far past the end

/// Rays as columns: points (ox, oy, oz) + t (dx, dy, dz) for t_min < t < t_max. Directions have any length
/// except 0.
struct RaySpan {
    const double *ox, *oy, *oz, *dx, *dy, *dz, *t_min, *t_max;
};

}  // namespace glint
