// SPDX-License-Identifier: Apache-2.0
#pragma once
// The camera's visible hits, ray by ray, traced with the renderer's kernels.
#include <cstdint>
#include <vector>

#include "check/context.h"
#include "trace/ray_list.h"
#include "world/appearance.h"

namespace glint {

/// A point of a surface that a ray hit.
struct SurfaceHit {
    Vec3 point, normal;  // unit normal, flipped towards the ray if the conventions say so
    Vec3 incoming;       // the ray's direction
    SurfaceId surface;
    std::uint32_t shape = 0, material = 0;
    std::size_t ray = 0;   // the index of the ray
    bool turned = false;   // the conventions flip this shape's normal
    double magnitude = 0;  // as in SurfacePoint
    bool behind = false;   // the ray came from the back of the shape
};
SurfaceHit surface_hit(const WorldParts& world, const RayList& rays, const HitList& hits, std::size_t ray);

/// The hits of one generation of rays.
struct Generation {
    std::vector<SurfaceHit> hits;
};

/// The secondary rays that leave some hits as the renderer traces them, without their weights. Of more than
/// 65536 hits, evenly spaced ones.
enum class Followed : std::uint8_t { mirrors, mirrors_and_glass };
RayList secondary_rays(const WorldParts& world, const std::vector<SurfaceHit>& hits, Followed followed);

/// Generations of secondary rays that the checks trace.
inline constexpr int k_max_generations = 4;

/// The camera rays at `size`, each moved by (x, y) pixels from the renderer's.
RayList camera_rays(const WorldParts& world, SmallSize size, double x, double y);

/// The first generations of rays of the picture.
class VisibleHits {
  public:
    /// Traces one ray per pixel, or fewer for a large picture, and the secondary rays.
    explicit VisibleHits(const CheckContext& context);

    static constexpr std::int32_t k_longest = 640;  // maximum camera rays per side

    SmallSize size;                       // of the grid of camera rays
    std::vector<Generation> generations;  // [0]: directly visible
    const std::vector<SurfaceHit>& seen() const { return generations[0].hits; }
    std::size_t rays() const {
        return static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    }
};

/// The shadow rays of a light for the visible points, as the renderer traces them, for at most `most` hits
/// per generation.
struct ShadowRays {
    RayList rays;                    // of the points that face the light
    std::vector<SurfaceId> surface;  // of the point of each ray
    std::size_t in_cone = 0;         // of these points: those in whose direction it shines
    bool from_light = false;         // otherwise from the point (t = 0) to the light (t = 1)
    std::size_t points = 0;          // number of points examined
};
ShadowRays shadow_rays(const WorldParts& world, const VisibleHits& visible, const Light& light,
                       std::size_t most);

/// Every hit of a ray from `point` in one fixed direction, in order of distance, including repeated hits of a
/// shape. At most a thousand.
std::vector<std::uint32_t> shapes_along(const WorldParts& world, Vec3 point, Vec3 direction);

/// The closed shapes that contain the point.
std::vector<std::uint32_t> shapes_around(const CheckContext& context, Vec3 point);

/// The approximate number of shapes tested per camera ray: those whose boxes it intersects before its hit.
double shapes_per_ray(const WorldParts& world, int threads);

}  // namespace glint
