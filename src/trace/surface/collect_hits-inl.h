// SPDX-License-Identifier: Apache-2.0
// The stage that collects the hits of a range of rays: surface and ray of each, compacted.
#if defined(GLINT_TRACE_COLLECT_HITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_COLLECT_HITS_INL_H_
#undef GLINT_TRACE_COLLECT_HITS_INL_H_
#else
#define GLINT_TRACE_COLLECT_HITS_INL_H_
#endif

#include "math/sample_hash.h"
#include "simd/compress-inl.h"
#include "simd/vec3-inl.h"
#include "trace/batches.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The columns of append_hits() that only scenes with transparent surfaces have.
inline void append_transparent_hits(const RayBatch& rays, int ray, Doubles t, LaneMask<double> hit,
                                    const Vector3<Doubles>& origin, SurfaceBatch& surfaces) {
    const bool camera = rays.generation == 0;
    const int h = surfaces.count;
    compress_vector3(origin, hit, surfaces.origin, h);
    compress_store(t, hit, surfaces.t.data() + h);
    compress_store(camera ? Doubles(0) : load(rays.level.data() + ray), hit, surfaces.level.data() + h);
    compress_store(camera ? Doubles(0) : load(rays.passed.data() + ray), hit, surfaces.passed.data() + h);
}

/// Appends the hits among entries [i, end) of the HitBatch, at most a vector of them. plain: the surfaces
/// have no columns for alpha, transparent surfaces, hashes or fog.
template <bool plain>
HWY_INLINE void append_hits(const WorldParts& world, const RayBatch& rays, const HitBatch& hits, int i,
                            int end, SurfaceBatch& surfaces) {
    const Doubles t = load(hits.t.data() + i);
    const auto hit = t < Doubles(k_infinity) && first_lanes<double>(end - i);  // a miss has t == t_max
    const int count_here = count(hit);
    if (count_here == 0) return;
    const bool camera = rays.generation == 0;
    const int ray = hits.first + i, h = surfaces.count;
    const Vector3<Doubles> origin = load_vector3(rays.origin, ray),
                           direction = load_vector3(rays.direction, ray);
    const Vector3<Doubles> point = origin + direction * t;
    compress_vector3(point, hit, surfaces.point, h);
    compress_vector3(direction, hit, surfaces.incoming, h);
    compress_store(max_abs(origin) + max_abs(point), hit, surfaces.magnitude.data() + h);
    compress_store(hits.slot.data() + i, hit, surfaces.slot.data() + h);
    if (world.geometry->has_elements())
        compress_store(hits.element.data() + i, hit, surfaces.element.data() + h);
    if (camera) {
        store_vector3(lanes_of(Vec3{1, 1, 1}), surfaces.weight, h);
        compress_store(Doubles(static_cast<double>(ray)) + iota(), hit, surfaces.target.data() + h);
    } else {
        compress_vector3(load_vector3(rays.weight, ray), hit, surfaces.weight, h);
        compress_store(load(rays.target.data() + ray), hit, surfaces.target.data() + h);
    }
    const bool beer = world.conventions.beer > 0, transparent = !plain && rays.transparent;
    if (!plain && rays.hashed) {
        const Doubles path =
            camera ? Doubles(static_cast<double>(k_camera_path)) : load(rays.path.data() + ray);
        compress_store(path, hit, surfaces.path.data() + h);
    }
    if (!plain && rays.alpha) {
        const Doubles straight = camera ? Doubles(1) : load(rays.straight.data() + ray);
        compress_store(straight, hit, surfaces.straight.data() + h);
    }
    if (!plain && rays.tracked)
        compress_store(load(rays.interiors.data() + ray), hit, surfaces.interiors.data() + h);
    if (transparent) append_transparent_hits(rays, ray, t, hit, origin, surfaces);
    const bool fades = transparent && world.uses<&Material::fade_distance>();
    if (beer || fades || (!plain && (world.fog || sees_back(world)))) {
        const Doubles start = transparent && !camera ? load(rays.start.data() + ray) : Doubles(0);
        compress_store(t - start, hit, surfaces.hit_t.data() + h);
    }
    if (beer) {
        const Doubles medium = camera ? Doubles(static_cast<double>(k_none)) : load(rays.medium.data() + ray);
        compress_store(medium, hit, surfaces.medium.data() + h);
    }
    surfaces.count += count_here;
}

/// Compacts the hits of a range of rays, group by group.
inline void collect_hits(const WorldParts& world, const RayBatch& rays, const HitBatch& hits, RayRange range,
                         SurfaceBatch& surfaces) {
    surfaces.generation = rays.generation;
    surfaces.alpha = rays.alpha;
    surfaces.transparent = rays.transparent;
    surfaces.hashed = rays.hashed;
    surfaces.tracked = rays.tracked;
    surfaces.count = surfaces.groups = 0;
    const bool plain = !rays.alpha && !rays.transparent && !rays.hashed && !world.fog && !sees_back(world);
    std::size_t group = rays.group_of(hits.first + range.begin);
    for (int i = range.begin; i < range.end; ++group) {
        const int end = number::min(rays.group_end(group) - hits.first, range.end);
        for (; i < end; i += lane_count<double>()) {
            if (plain) {
                append_hits<true>(world, rays, hits, i, end, surfaces);
            } else {
                append_hits<false>(world, rays, hits, i, end, surfaces);
            }
        }
        i = end;
        surfaces.group_end[static_cast<std::size_t>(surfaces.groups++)] = {end, surfaces.count};
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
