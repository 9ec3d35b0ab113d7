// SPDX-License-Identifier: Apache-2.0
#pragma once
// The surfaces that the camera sees, directly and in mirrors and glass, as the renderer's kernels find them.
#include <cstdint>
#include <vector>

#include "check/context.h"
#include "trace/surface_record.h"
#include "world/appearance/appearance.h"

namespace glint {

/// The generations of secondary rays that the checks trace.
inline constexpr std::size_t k_max_generations = 4;

/// The camera rays of a picture of this size.
RayList camera_rays(const WorldParts& world, SmallSize size);

/// The hits of the camera rays of a picture of this size, each moved by (x, y) pixels, and those of the
/// secondary rays: at most k_max_generations, without empty ones at the end. If more than 65536 pixels have
/// secondary rays, those of evenly spaced ones are traced.
SurfaceRecord follow_picture(const WorldParts& world, SmallSize size, double x, double y, int threads);

/// The first generations of rays of the picture.
class VisibleHits {
  public:
    /// Traces one ray per pixel, or fewer for a large picture, and the secondary rays.
    explicit VisibleHits(const CheckContext& context);

    static constexpr std::int32_t k_longest = 640;  // maximum camera rays per side

    SmallSize size;             // of the grid of camera rays
    SurfaceRecord generations;  // [0]: directly visible
    // By shape: how often rays pass it (is_hole()). Empty: no shape has holes.
    std::vector<std::size_t> passed;
    const std::vector<SurfaceHit>& seen() const { return generations[0]; }
    bool is_passed(std::uint32_t shape) const { return !passed.empty() && passed[shape] > 0; }
    /// By shape: whether a ray hits it.
    std::vector<bool> hit_shapes(const Scene& scene) const;
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

/// The bounded shapes and solids that contain the point.
std::vector<std::uint32_t> shapes_around(const CheckContext& context, Vec3 point);

/// Whether the ray intersects the box before t.
bool meets(const Bounds& box, Vec3 origin, Vec3 direction, double t);

/// The approximate number of shapes tested per camera ray: those whose boxes it intersects before its hit.
double shapes_per_ray(const WorldParts& world, int threads);

}  // namespace glint
