// SPDX-License-Identifier: Apache-2.0
#include "check/visible_hits.h"

#include <algorithm>
#include <iterator>

#include "math/elementary.h"
#include "math/transform.h"
#include "trace/lighting/shadow_rays-inl.h"
#include "world/geometry/contains.h"

namespace glint {
namespace {

using namespace HWY_NAMESPACE;

constexpr std::size_t k_max_followed = 65536;  // pixels

Vector3<double> triple_of(Vec3 v) { return {v.x, v.y, v.z}; }
Vec3 vec_of(Vector3<double> v) { return {v.x, v.y, v.z}; }

SurfacePoint<double> surface_point(const SurfaceHit& h) {
    return {triple_of(h.point), triple_of(h.normal), triple_of(h.incoming), h.magnitude};
}

// Whether the light gives light in the direction of a point: that of a spot, or of a one-sided area light.
bool shines_towards(const Light& light, Vec3 point) {
    const Vec3 way = point - light.position;
    if (light.has_emitter_cosine()) {
        const Vec3 normal = light.is_disc() ? light.axis : glint::cross(light.side_u, light.side_v);
        return glint::dot(way, normal) > 0;
    }
    if (!light.is_spot()) return true;
    return glint::dot(way, glint::normalize(light.axis)) >
           glint::length(way) * cos_degrees(light.outer_angle);
}

PixelPositions pixels_of(SmallSize size, double x, double y) {
    PixelPositions pixels;
    for (std::int32_t row = 0; row < size.height; ++row)
        for (std::int32_t column = 0; column < size.width; ++column) pixels.add(column + x, row + y);
    return pixels;
}

bool has_secondary_rays(const WorldParts& world, const SurfaceHit& h) {
    return world.is_mirror(h.material) || world.material(h.material)[k_transmission] > 0 ||
           world.is_transparent(h.material);
}

// The parts of the secondary rays in front of their hits; at most k_max_followed of a generation.
void add_ways(const std::vector<SurfaceHit>& hits, RayList& rays) {
    const std::size_t step = hits.size() / k_max_followed + 1;
    for (std::size_t i = 0; i < hits.size(); i += step) {
        const SurfaceHit& h = hits[i];
        if (h.t > 0) rays.add(h.origin, (h.point - h.origin) / h.t, 0, h.t);
    }
}

// VisibleHits::passed
std::vector<std::size_t> count_passed(const WorldParts& world, SmallSize size, const SurfaceRecord& found,
                                      int threads) {
    if (!world.has_holes) return {};
    std::vector<std::size_t> passed(world.geometry->scene_shapes);
    RayList rays = camera_rays(world, size);
    for (std::size_t generation = 1; generation < found.size(); ++generation)
        add_ways(found[generation], rays);
    nearest_surfaces(world, rays, threads, [&](std::size_t, SurfaceId surface, double) {
        ++passed[world.geometry->shape_of(surface)];
    });
    return passed;
}

}  // namespace

RayList camera_rays(const WorldParts& world, SmallSize size) {
    WorldParts of_size = world;
    set_size(of_size, size);
    return camera_rays(of_size, pixels_of(size, 0, 0));
}

SurfaceRecord follow_picture(const WorldParts& world, SmallSize size, double x, double y, int threads) {
    WorldParts of_size = world;
    set_size(of_size, size);
    const PixelPositions pixels = pixels_of(size, x, y);
    SurfaceRecord found = follow_pixels(of_size, pixels, 1, threads);
    std::vector<std::size_t> with_rays;
    for (const SurfaceHit& h : found[0])
        if (has_secondary_rays(world, h)) with_rays.push_back(h.ray);
    const std::size_t step = with_rays.size() / k_max_followed + 1;
    PixelPositions followed;
    for (std::size_t i = 0; i < with_rays.size(); i += step)
        followed.add(pixels.x[with_rays[i]], pixels.y[with_rays[i]]);
    SurfaceRecord later = follow_pixels(of_size, followed, 1 + k_max_generations, threads);
    while (later.size() > 1 && later.back().empty()) later.pop_back();
    found.insert(found.end(), std::make_move_iterator(later.begin() + 1),
                 std::make_move_iterator(later.end()));
    return found;
}

VisibleHits::VisibleHits(const CheckContext& context)
    : size(context.grid(k_longest)),
      generations(follow_picture(context.world(), size, 0, 0, context.threads())),
      passed(count_passed(context.world(), size, generations, context.threads())) {}

std::vector<bool> VisibleHits::hit_shapes(const Scene& scene) const {
    std::vector<bool> hit(scene.shapes.size());
    for (const std::vector<SurfaceHit>& hits : generations)
        for (const SurfaceHit& h : hits) hit[h.shape] = true;
    return hit;
}

ShadowRays shadow_rays(const WorldParts& world, const VisibleHits& visible, const Light& light,
                       std::size_t most) {
    const Conventions& rules = world.conventions;
    ShadowRays found;
    found.from_light = comes_from_light(light, rules);
    for (const std::vector<SurfaceHit>& hits : visible.generations) {
        const std::size_t step = hits.size() / most + 1;
        for (std::size_t i = 0; i < hits.size(); i += step) {
            const SurfaceHit& h = hits[i];
            const Vec3 to_light = light.way_from(h.point);
            ++found.points;
            if (!(glint::dot(h.normal, to_light) > 0)) continue;
            found.in_cone += shines_towards(light, h.point) ? 1 : 0;
            found.surface.push_back(h.surface);
            const auto ray = shadow_ray(surface_point(h), light, triple_of(to_light), rules);
            found.rays.add(vec_of(ray.origin), vec_of(ray.direction), ray.t_min, ray.t_max);
        }
    }
    return found;
}

std::vector<std::uint32_t> shapes_around(const CheckContext& context, Vec3 point) {
    const PackedGeometry& geometry = *context.world().geometry;
    std::vector<std::uint32_t> around;
    for (std::uint32_t slot = 0; slot < geometry.bounded; ++slot)
        if (contains(geometry, slot, point)) around.push_back(geometry.shape_index[slot]);
    std::sort(around.begin(), around.end());
    return around;
}

}  // namespace glint
