// SPDX-License-Identifier: Apache-2.0
// The kernels do not record holes, so that they lose no time: the rays are followed again.
#include "explain/holes.h"

#include "trace/ray_list.h"
#include "trace/record_texture.h"
#include "world/appearance/appearance.h"

namespace glint {
namespace {

void find_holes_of_ray(const WorldParts& world, ExplainedRay& ray) {
    double t = ray.t_min;
    // The surfaces on the way are holes, and transparent ones that the conventions do not shade.
    for (;;) {
        RayList line;
        line.add(ray.origin, ray.direction, t);
        const HitList hit = nearest_hits(world, line, 1);
        const SurfaceId id = hit.surface[0];
        t = hit.t[0];
        if (!id.exists() || !(t < ray.t)) return;
        const Vec3 point = ray.origin + ray.direction * t;
        if (!is_hole(world, id, point, ray.direction)) continue;
        ++ray.hole_count;
        if (ray.holes.size() >= k_max_explained_holes) continue;
        ExplainedHole& hole = ray.holes.emplace_back();
        hole.shape = world.geometry->shape_of(id);
        hole.t = t;
        hole.back = is_seen_through(world, id, point, ray.direction);
        if (hole.back) continue;
        hole.texture = recorded_texture(world, id, point);
        if (hole.texture) hole.cutoff = (*world.textures)[hole.texture->texture].alpha_cutoff;
    }
}

}  // namespace

void find_holes(const WorldParts& world, Explanation& explanation) {
    if (!world.has_holes) return;
    for (ExplainedRay& ray : explanation.rays) {
        if (!ray.beyond_limit) find_holes_of_ray(world, ray);
    }
}

}  // namespace glint
