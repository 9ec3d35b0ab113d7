// SPDX-License-Identifier: Apache-2.0
// The nearest hits, or the occlusions, found so far.
#if defined(GLINT_TRACE_HIT_RESULT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_HIT_RESULT_INL_H_
#undef GLINT_TRACE_HIT_RESULT_INL_H_
#else
#define GLINT_TRACE_HIT_RESULT_INL_H_
#endif

#include "bvh/slab-inl.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The present results of nearest_hit or any_hit for a chunk of rays.
struct HitResult {
    const WorldParts& world;
    SlabRays& slab_rays;
    double* t;                // by ray: the smallest t so far; initially t_max
    std::uint32_t* slot;      // nearest_hit: initially k_none
    std::uint8_t* occluded;   // any_hit only; null for nearest_hit
    std::uint32_t* occluder;  // any_hit: the slot of the last occluder found

    /// Whether slot a precedes slot b in a tie: by the order in the scene, then by the order of the polygon's
    /// triangles.
    HWY_INLINE bool precedes(std::uint32_t a, std::uint32_t b) const {
        const PackedGeometry& geometry = *world.geometry;
        const std::uint32_t shape_a = geometry.shape_index[a], shape_b = geometry.shape_index[b];
        if (shape_a == shape_b) return geometry.piece[a] < geometry.piece[b];
        return (shape_a < shape_b) != world.last_of_equals;
    }

    /// Stores a hit at new_t <= t[ray]. t[ray] may still be t_max.
    HWY_INLINE void accept(int ray, double new_t, std::uint32_t new_slot) const {
        if (occluded != nullptr) {
            if (new_t != t[ray]) occlude(ray, new_slot);
            return;
        }
        if (new_t == t[ray] && (slot[ray] == k_none || precedes(slot[ray], new_slot))) return;
        t[ray] = new_t;
        slot[ray] = new_slot;
        slab_rays.t_max[ray] = float_above(new_t);
    }
    /// any_hit: stores a hit at a t below t_max.
    HWY_INLINE void occlude(int ray, std::uint32_t new_slot) const {
        if (!world.casts_shadow(new_slot)) return;
        occluded[ray] = 1;
        *occluder = new_slot;
        slab_rays.t_max[ray] = -std::numeric_limits<float>::infinity();
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
