// SPDX-License-Identifier: Apache-2.0
#pragma once
// The rays of a frame, by class, in the order in which tiles trace them.
#include <cstddef>
#include <vector>

#include "embree_scene.h"

namespace glint_floor {

enum RayClass : int { k_camera, k_first_shadow, k_mirror, k_later_shadow, k_ray_classes };
inline constexpr const char* k_class_names[k_ray_classes] = {"camera", "first shadow", "mirror and glass",
                                                             "later shadow"};

/// origin + t direction for 0 < t < t_max, as columns of floats for Embree. Directions are unit, because
/// Embree's cones otherwise report hits beyond t_max.
struct RayList {
    std::vector<float> ox, oy, oz, dx, dy, dz, t_max;
    std::size_t size() const { return t_max.size(); }
    void add(Vec3 origin, Vec3 direction, float most);
};

struct FrameRays {
    RayList lists[k_ray_classes];
};

/// The unit direction of the ray through the middle of a pixel of size x size.
Vec3 camera_direction(const glint::Camera& camera, int size, int x, int y);

/// Follows the profile nff: a shadow ray from each point light on the ray's side of a surface to every hit;
/// mirror and glass rays for `generations` generations if their weight is at least 0.01.
FrameRays frame_rays(const glint::Scene& scene, const EmbreeScene& embree, int size, int generations);

}  // namespace glint_floor
