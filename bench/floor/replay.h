// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "frame_rays.h"

namespace glint_floor {

inline bool is_shadow(int ray_class) { return ray_class == k_first_shadow || ray_class == k_later_shadow; }

/// Traces the rays with Embree in packets of 16: nearest hits, or occlusion for shadow rays.
/// Returns the seconds on `threads` threads.
double replay(RTCScene scene, const RayList& rays, RayClass ray_class, int threads);

/// The number of rays that hit anything.
std::size_t count_hits(RTCScene scene, const RayList& rays, RayClass ray_class);

}  // namespace glint_floor
