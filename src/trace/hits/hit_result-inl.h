// SPDX-License-Identifier: Apache-2.0
// The nearest hits, or the occlusions, found so far.
#if defined(GLINT_TRACE_HIT_RESULT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_HIT_RESULT_INL_H_
#undef GLINT_TRACE_HIT_RESULT_INL_H_
#else
#define GLINT_TRACE_HIT_RESULT_INL_H_
#endif

#include "bvh/slab-inl.h"
#include "trace/hits/hit_columns.h"
#include "world/appearance/appearance.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The rays of a chunk in the world: the chunk's, or for a mesh those from which they were mapped.
struct WorldRays {
    const RaySpan& rays;
    const int* number;  // of a ray of the chunk in `rays`; null: they are the chunk's

    HWY_INLINE int number_of(int ray) const { return number == nullptr ? ray : number[ray]; }
};

/// The present results of nearest_hit or any_hit for a chunk of rays.
struct HitResult {
    const WorldParts& world;
    SlabRays& slab_rays;
    HitColumns nearest;       // t: the smallest so far, initially t_max; the others for nearest_hit only
    std::uint8_t* occluded;   // any_hit only; null for nearest_hit
    std::uint32_t* occluder;  // any_hit: the slot of the last occluder found
    WorldRays world_rays;

    /// Whether the ray passes the surface, which it meets at t.
    HWY_NOINLINE bool passes(int ray, double t, SurfaceId id) const {
        const RaySpan& rays = world_rays.rays;
        const int i = world_rays.number_of(ray);
        const Vec3 direction{rays.dx[i], rays.dy[i], rays.dz[i]};
        return is_hole(world, id, Vec3{rays.ox[i], rays.oy[i], rays.oz[i]} + direction * t, direction);
    }
    /// Whether surface a precedes b, which the ray meets at the same t. A surface that is seen precedes one
    /// that the ray passes: of two triangles back to back, the front.
    HWY_INLINE bool precedes(int ray, double t, SurfaceId a, SurfaceId b) const {
        if (world.has_holes) {
            const bool passes_a = passes(ray, t, a);
            if (passes_a != passes(ray, t, b)) return !passes_a;
        }
        const PackedGeometry& geometry = *world.geometry;
        const bool first = geometry.precedes(a, b);
        return world.ties == TieRule::first || geometry.shape_of(a) == geometry.shape_of(b) ? first : !first;
    }

    /// Stores a hit at new_t <= t of the ray. That may still be t_max.
    HWY_INLINE void accept(int ray, double new_t, SurfaceId id) const {
        if (occluded != nullptr) {
            if (new_t != nearest.t[ray]) occlude(ray, id);
            return;
        }
        const SurfaceId present = nearest.surface(ray);
        if (new_t == nearest.t[ray] && (!present.exists() || precedes(ray, new_t, present, id))) return;
        nearest.set(ray, new_t, id);
        slab_rays.t_max[ray] = float_above(new_t);
    }
    /// any_hit: stores a hit at a t below t_max.
    HWY_INLINE void occlude(int ray, SurfaceId id) const {
        if (!casts_shadow(world, id)) return;
        occluded[ray] = 1;
        *occluder = id.slot;
        slab_rays.t_max[ray] = -std::numeric_limits<float>::infinity();
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
