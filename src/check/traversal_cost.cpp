// SPDX-License-Identifier: Apache-2.0
// The cost of a camera ray.
#include <algorithm>

#include "check/visible_hits.h"
#include "world/geometry/primitive_bounds-inl.h"

namespace glint {
namespace {

constexpr std::int32_t k_rays_a_side = 16;    // rays a side
constexpr std::uint32_t k_max_boxes = 20000;  // of more, evenly spaced ones are tested

}  // namespace

bool meets(const Bounds& box, Vec3 origin, Vec3 direction, double t) {
    double from = 0, to = t;
    const auto narrow = [&](double lo, double hi, double o, double d) {
        if (d == 0) {
            if (o < lo || o > hi) to = -1;
            return;
        }
        const double a = (lo - o) / d, b = (hi - o) / d;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    };
    narrow(box.min.x, box.max.x, origin.x, direction.x);
    narrow(box.min.y, box.max.y, origin.y, direction.y);
    narrow(box.min.z, box.max.z, origin.z, direction.z);
    return from <= to;
}

double shapes_per_ray(const WorldParts& world, int threads) {
    const RayList rays = camera_rays(world, small_size(world.settings, k_rays_a_side));
    const HitList hits = nearest_hits(world, rays, threads);
    const std::uint32_t step = world.geometry->bounded / k_max_boxes + 1;
    std::uint64_t met = 0;
    for (std::uint32_t slot = 0; slot < world.geometry->bounded; slot += step) {
        const Bounds box = to_bounds(HWY_NAMESPACE::primitive_bounds(*world.geometry, slot));
        for (std::size_t i = 0; i < rays.size(); ++i)
            met += meets(box, rays.origin(i), rays.direction(i), hits.t[i]);
    }
    return static_cast<double>(met) * step / static_cast<double>(rays.size());
}

}  // namespace glint
