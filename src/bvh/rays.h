// SPDX-License-Identifier: Apache-2.0
#pragma once
// Rays in streams: structure of arrays.

namespace glint {

inline constexpr int k_packet_size = 64;  // rays that walk the hierarchy together, at most
inline constexpr int k_ray_padding = 16;  // arrays of rays may be read (not used) this far past their end

/// Rays as columns: points (ox, oy, oz) + t (dx, dy, dz) for t_min < t < t_max. Directions have any length
/// but 0.
struct RaySpan {
    const double *ox, *oy, *oz, *dx, *dy, *dz, *t_min, *t_max;
};

}  // namespace glint
