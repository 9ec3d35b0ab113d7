// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the camera sees, ray by ray, by the renderer's own kernels.
#include <cstdint>
#include <vector>

#include "check/context.h"
#include "trace/ray_list.h"

namespace glint {

/// A point of a surface that a ray met.
struct SurfaceHit {
    Vec3 point, normal;  // unit normal, turned to the ray where the conventions say so
    Vec3 incoming;       // the ray's direction
    std::uint32_t slot = 0, shape = 0, material = 0;
    std::size_t ray = 0;   // the number of the ray
    bool turned = false;   // the conventions turn this shape's normal
    double magnitude = 0;  // as SurfacePoint's
    bool behind = false;   // the ray came from behind the shape's own normal
};
SurfaceHit surface_hit(const WorldParts& world, const RayList& rays, const HitList& hits, std::size_t ray);

/// What the rays of one generation met.
struct Generation {
    std::vector<SurfaceHit> hits;
};

/// The camera's rays at `size`, each through the place where the renderer's passes plus (x, y) pixels.
RayList camera_rays(const WorldParts& world, SmallSize size, double x, double y);

/// The first generations of rays through the picture.
class VisibleHits {
  public:
    /// Traces a ray a pixel, or fewer where the picture is large, and follows them into mirrors and glass.
    explicit VisibleHits(const CheckContext& context);

    static constexpr std::int32_t k_longest = 640;  // camera rays a side, at most

    SmallSize size;                       // of the grid of camera rays
    std::vector<Generation> generations;  // [0]: directly seen
    const std::vector<SurfaceHit>& seen() const { return generations[0].hits; }
    std::size_t rays() const {
        return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    }
};

/// The shadow rays of a light from what is seen, as the renderer traces them, of at most `most` hits a
/// generation.
struct ShadowRays {
    RayList rays;                         // of the points that face the light
    std::vector<std::uint32_t> material;  // of each ray's point
    bool from_light = false;              // or from the point, which is at t = 0; the light is at t = 1
    std::size_t points = 0;               // all that were looked at
};
ShadowRays shadow_rays(const WorldParts& world, const VisibleHits& visible, const Light& light,
                       std::size_t most);

/// Every shape that a ray from `point` meets in a direction chosen once, in order of distance, as often as it
/// is met. At most a thousand.
std::vector<std::uint32_t> shapes_along(const WorldParts& world, Vec3 point, Vec3 direction);

/// The closed shapes that hold the point.
std::vector<std::uint32_t> shapes_around(const CheckContext& context, Vec3 point);

/// How many shapes a camera ray is tested against, about: those whose boxes it meets before it hits one.
double shapes_per_ray(const WorldParts& world, int threads);

}  // namespace glint
