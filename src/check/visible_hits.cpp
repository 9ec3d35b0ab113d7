// SPDX-License-Identifier: Apache-2.0
#include "check/visible_hits.h"

#include <algorithm>
#include <limits>

#include "geometry/kinds-inl.h"
#include "math/elementary.h"
#include "math/transform.h"
#include "trace/lighting/shadow_rays-inl.h"
#include "trace/rays/camera_rays-inl.h"
#include "trace/secondary/secondary_rays-inl.h"
#include "world/primitive_bounds-inl.h"
#include "world/primitives.h"

namespace glint {
namespace {

using namespace HWY_NAMESPACE;

constexpr std::size_t k_max_followed = 65536;  // mirror and glass rays of a generation

Vector3<double> triple_of(Vec3 v) { return {v.x, v.y, v.z}; }
Vec3 vec_of(Vector3<double> v) { return {v.x, v.y, v.z}; }

double largest(Vec3 v) { return max_abs(triple_of(v)); }

SurfacePoint<double> surface_point(const SurfaceHit& h) {
    return {triple_of(h.point), triple_of(h.normal), triple_of(h.incoming), h.magnitude};
}

std::vector<SurfaceHit> surface_hits(const WorldParts& world, const RayList& rays, int threads) {
    const HitList found = nearest_hits(world, rays, threads);
    std::vector<SurfaceHit> hits;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (found.surface[i].exists()) hits.push_back(surface_hit(world, rays, found, i));
    }
    return hits;
}

// Whether the point is nearer to the spot's axis than its outer angle; true for other lights.
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

}  // namespace

SurfaceHit surface_hit(const WorldParts& world, const RayList& rays, const HitList& hits, std::size_t ray) {
    SurfaceHit h;
    h.ray = ray;
    h.surface = hits.surface[ray];
    h.shape = world.geometry->shape_of(h.surface);
    h.material = material_row(world, h.surface);
    h.turned = flips_normal(world, h.surface);
    h.incoming = rays.direction(ray);
    h.point = rays.origin(ray) + h.incoming * hits.t[ray];
    const SurfaceNormals normals = surface_normals(*world.geometry, h.surface, h.point);
    h.normal = normals.shading;
    h.behind = hits_from_behind(world, normals, h.incoming);
    if (h.behind && h.turned) h.normal = -h.normal;
    h.magnitude = largest(rays.origin(ray)) + largest(h.point);
    if (world.geometry->is_bounded(h.surface)) {
        const Bounds box = to_bounds(primitive_bounds(*world.geometry, h.surface.slot));
        h.magnitude += std::max(largest(box.min), largest(box.max));
    }
    return h;
}

RayList secondary_rays(const WorldParts& world, const std::vector<SurfaceHit>& hits, Followed followed) {
    const Conventions& rules = world.conventions;
    const auto leaves = [&](const SurfaceHit& h) {
        const double* m = world.material(h.material);
        const bool glass = m[k_transmission] > 0 || world.is_transparent(h.material);
        return followed == Followed::mirrors ? std::pair{m[k_mirror] > 0 && !glass, false}
                                             : std::pair{m[k_mirror] > 0, glass};
    };
    std::size_t count = 0;
    for (const SurfaceHit& h : hits) count += leaves(h).first || leaves(h).second ? 1 : 0;
    const std::size_t step = count / k_max_followed + 1;
    RayList rays;
    std::size_t number = 0;
    for (const SurfaceHit& h : hits) {
        const auto [mirror, glass] = leaves(h);
        if ((!mirror && !glass) || number++ % step != 0) continue;
        const SurfacePoint<double> surface = surface_point(h);
        const auto add = [&](Vector3<double> origin, Vector3<double> direction) {
            rays.add(vec_of(origin), vec_of(direction), offset_t_min(rules.offset, rules.epsilon));
        };
        bool reflects = mirror;
        if (glass && world.is_transparent(h.material)) {
            const Vector3<double> ahead = triple_of(h.incoming);
            add(offset_transmitted_origin(surface, ahead, rules.offset, rules.epsilon), ahead);
        } else if (glass) {
            const double ior = world.material(h.material)[k_ior];
            const auto on = refracted_ray(surface, h.behind, ior, rules);
            if (on.fresnel < 1)
                add(offset_transmitted_origin(surface, on.direction, rules.offset, rules.epsilon),
                    on.direction);
            reflects = mirror || on.fresnel > 0;
        }
        if (reflects) {
            const auto back = mirrored_ray(surface, glass, rules);
            add(back.origin, back.direction);
        }
    }
    return rays;
}

RayList camera_rays(const WorldParts& world, SmallSize size, double x, double y) {
    const PreparedCamera& camera = world.camera;
    const PixelSample where = world.conventions.pixel_sample;
    RenderSettings settings;
    settings.width = size.width;
    settings.height = size.height;
    RayList rays;
    for (std::int32_t row = 0; row < size.height; ++row) {
        const double up = viewport_y(settings, where, row + y, offset_y(where));
        for (std::int32_t column = 0; column < size.width; ++column) {
            const auto ray =
                viewport_ray(camera, viewport_x(settings, where, column + x, offset_x(where)), up);
            const bool unit = world.conventions.ray_direction == RayDirection::unit;
            rays.add(ray.origin, unit ? glint::normalize(ray.direction) : ray.direction,
                     world.conventions.camera_t_min);
        }
    }
    return rays;
}

VisibleHits::VisibleHits(const CheckContext& context) : size(context.grid(k_longest)) {
    const WorldParts& world = context.world();
    const int threads = context.threads();
    RayList rays = camera_rays(world, size, 0, 0);
    generations.push_back({surface_hits(world, rays, threads)});
    const int most = std::min(world.settings.reflections, k_max_generations);
    for (int g = 0; g < most; ++g) {
        rays = secondary_rays(world, generations.back().hits, Followed::mirrors_and_glass);
        if (rays.size() == 0) break;
        generations.push_back({surface_hits(world, rays, threads)});
    }
}

ShadowRays shadow_rays(const WorldParts& world, const VisibleHits& visible, const Light& light,
                       std::size_t most) {
    const Conventions& rules = world.conventions;
    ShadowRays found;
    found.from_light = comes_from_light(light, rules);
    for (const Generation& g : visible.generations) {
        const std::size_t step = g.hits.size() / most + 1;
        for (std::size_t i = 0; i < g.hits.size(); i += step) {
            const SurfaceHit& h = g.hits[i];
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

std::vector<std::uint32_t> shapes_along(const WorldParts& world, Vec3 point, Vec3 direction) {
    constexpr int k_max = 1000;
    std::vector<std::uint32_t> shapes;
    double t_min = 0;
    for (int i = 0; i < k_max; ++i) {
        RayList ray;
        ray.add(point, direction, t_min);
        const HitList hit = nearest_hits(world, ray, 1);
        if (!hit.surface[0].exists()) break;
        shapes.push_back(world.geometry->shape_of(hit.surface[0]));
        t_min = hit.t[0];
    }
    return shapes;
}

std::vector<std::uint32_t> shapes_around(const CheckContext& context, Vec3 point) {
    // A ray from inside a closed shape meets it an odd number of times, in any direction.
    const Vec3 way{0.5773, 0.6211, 0.5301};
    const auto around = [&](Vec3 direction) {
        std::vector<std::uint32_t> met = shapes_along(context.world(), point, direction), odd;
        std::sort(met.begin(), met.end());
        for (auto at = met.begin(); at != met.end();) {
            const auto next = std::upper_bound(at, met.end(), *at);
            if ((next - at) % 2 != 0 && is_closed(context.scene(), *at)) odd.push_back(*at);
            at = next;
        }
        return odd;
    };
    const std::vector<std::uint32_t> one = around(way), other = around(-way);
    std::vector<std::uint32_t> both;
    std::set_intersection(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(both));
    return both;
}

}  // namespace glint
