// SPDX-License-Identifier: Apache-2.0
// The hierarchy's slab expression: for several rays, or for several boxes, in the lanes of a vector.
//
// Every test of a box uses one expression of the ray and the box's planes, in single precision:
//   entry = max over axes of (near plane - origin) * inverse,   exit = min over axes of (far plane - origin)
//   * inverse
// The origin and the inverse direction are rounded so that entry is never too late and exit never too early.
// IEEE rounding is monotone: the entry of a box is at most that of any box inside it, and an interval
// evaluation of the same expression bounds every ray of a packet. Therefore neither the grouping of rays nor
// the shape of the tree can change a hit.
#if defined(GLINT_BVH_SLAB_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_BVH_SLAB_INL_H_
#undef GLINT_BVH_SLAB_INL_H_
#else
#define GLINT_BVH_SLAB_INL_H_
#endif

#include <limits>

#include "bvh/bvh.h"
#include "bvh/rays.h"
#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Rays in single precision, for the slab expression and the shapes' filters.
struct SlabRays {
    static constexpr int k_max_rays = 256;
    static constexpr int k_size = k_max_rays + k_ray_padding;
    // By axis and ray: the rounded origins and inverse directions for the near plane and for the far plane.
    alignas(64) float near_origin[3][k_size], far_origin[3][k_size];
    alignas(64) float near_inverse[3][k_size], far_inverse[3][k_size];
    // Rounded to nearest, for the shapes' filters. A direction's largest component is about 1, or all are 0.
    alignas(64) float origin[3][k_size], direction[3][k_size];
    alignas(64) float t_min[k_size];  // rounded down
    alignas(64) float t_max[k_size];  // rounded up; decreases to the nearest hit so far; -infinity once a
                                      // ray is finished
    bool common_origin;               // all rays have the same origin, in double
};

/// A float at most x, and at least x minus two ulp.
HWY_INLINE float float_below(double x) {
    const float f = static_cast<float>(x);
    return f - ((f < 0 ? -f : f) * 0x1p-23f + 1e-37f);
}
HWY_INLINE float float_above(double x) { return -float_below(-x); }

/// The padding for a vector of numbers of the slab expression; see SlabRays::t_min and t_max.
HWY_INLINE Floats rounding_margin(Floats f) { return abs(f) * Floats(0x1p-23f) + Floats(1e-37f); }

/// At least the doubles that f was rounded from, like float_above.
HWY_INLINE Floats floats_above(Floats f) { return f + rounding_margin(f); }

/// Rounds rays [i, i + lanes) to single precision: origins, directions and t. A ray with a NaN or an infinite
/// number, or with a number outside the range of float, intersects no box.
HWY_INLINE void narrow_rays(const RaySpan& rays, int i, SlabRays& to) {
    const double* origins[3] = {rays.ox + i, rays.oy + i, rays.oz + i};
    const double* directions[3] = {rays.dx + i, rays.dy + i, rays.dz + i};
    const Doubles limit(1e37), never(-std::numeric_limits<double>::infinity());
    auto usable = abs(load(origins[0])) < limit;
    for (int a = 0; a < 3; ++a)
        usable = usable && abs(load(origins[a])) < limit && abs(load(directions[a])) < limit;
    for (int a = 0; a < 3; ++a) {
        store_narrow(select(usable, load(origins[a]), Doubles(0)), to.origin[a] + i);
        store_narrow(select(usable, load(directions[a]), Doubles(1)), to.direction[a] + i);
    }
    store_narrow(load(rays.t_min + i), to.t_min + i);
    store_narrow(select(usable, load(rays.t_max + i), never), to.t_max + i);
}

/// Whether rays [0, count) have a common origin.
inline bool have_common_origin(const RaySpan& rays, int count) {
    const Doubles x(rays.ox[0]), y(rays.oy[0]), z(rays.oz[0]);
    for (int i = 0; i < count; i += lane_count<double>()) {
        const auto same = load(rays.ox + i) == x && load(rays.oy + i) == y && load(rays.oz + i) == z;
        if (any(and_not(first_lanes<double>(count - i), same))) return false;
    }
    return true;
}

/// Pads with rays that intersect no box. A vector may start at any ray; uninitialised lanes would not change
/// the result, but branches would depend on them.
inline void pad_rays(int count, SlabRays& to) {
    const auto fill = [&](float* column, float number) HWY_ATTR {
        for (int i = count; i < count + k_ray_padding; i += lane_count<float>())
            store(Floats(number), column + i);
    };
    for (int a = 0; a < 3; ++a) {
        for (auto* column : {to.near_origin[a], to.far_origin[a], to.near_inverse[a], to.far_inverse[a],
                             to.origin[a], to.direction[a]})
            fill(column, 0);
    }
    fill(to.t_min, 0);
    fill(to.t_max, -std::numeric_limits<float>::infinity());
}

/// Prepares rays [0, count) of the stream, 1 <= count <= SlabRays::k_max_rays, and the padding after them.
inline void prepare_rays(const RaySpan& rays, int count, SlabRays& to) {
    to.common_origin = have_common_origin(rays, count);
    for (int i = 0; i < count; i += lane_count<double>()) narrow_rays(rays, i, to);
    // The relative error of an inverse is 2^-23, that of the slab's difference and product 2^-24 each.
    const Floats zero(0), tiny(1e-30f), shrink(1 - 0x1p-21f), grow(1 + 0x1p-21f);
    for (int i = 0; i < count; i += lane_count<float>()) {
        Floats direction[3], min_inverse(std::numeric_limits<float>::infinity());
        for (int a = 0; a < 3; ++a) {
            const Floats o = load(to.origin[a] + i), d = load(to.direction[a] + i);
            // A direction of 0 along an axis becomes tiny: the slab then contains all t, or none.
            direction[a] = select(abs(d) < tiny, select(d < zero, -tiny, tiny), d);
            const Floats inverse = Floats(1) / direction[a];
            min_inverse = min(min_inverse, abs(inverse));
            const Floats margin = rounding_margin(o), below = o - margin, above = o + margin;
            const auto ahead = inverse > zero;
            store(select(ahead, above, below), to.near_origin[a] + i);
            store(select(ahead, below, above), to.far_origin[a] + i);
            store(inverse * shrink, to.near_inverse[a] + i);
            store(inverse * grow, to.far_inverse[a] + i);
        }
        // Scales the largest component to about 1, so that its square is a float, too. If the direction is so
        // short that the tiny components above matter, it becomes 0: filters do not reject a direction of 0.
        const Floats stretch = select(min_inverse > Floats(1e22f), zero, min_inverse);
        for (int a = 0; a < 3; ++a) store(direction[a] * stretch, to.direction[a] + i);
        const Floats t_min = load(to.t_min + i), t_max = load(to.t_max + i);
        store(t_min - rounding_margin(t_min), to.t_min + i);
        store(select(t_max < Floats(-1e37f), t_max, t_max + rounding_margin(t_max)), to.t_max + i);
    }
    pad_rays(count, to);
}

/// A vector of slab intervals.
struct Slab {
    Floats entry, exit;
};

/// Whether an interval contains a t between t_min and t_max.
HWY_INLINE LaneMask<float> meets(const Slab& slab, Floats t_min, Floats t_max) {
    return max(slab.entry, t_min) <= min(slab.exit, t_max);
}

/// One ray, for the slab expression with boxes in lanes.
struct SlabRay {
    Floats near_origin[3], far_origin[3], near_inverse[3], far_inverse[3];
    bool ahead[3];

    HWY_INLINE SlabRay(const SlabRays& rays, int i) {
        for (int a = 0; a < 3; ++a) {
            near_origin[a] = Floats(rays.near_origin[a][i]), far_origin[a] = Floats(rays.far_origin[a][i]);
            near_inverse[a] = Floats(rays.near_inverse[a][i]),
            far_inverse[a] = Floats(rays.far_inverse[a][i]);
            ahead[a] = rays.near_inverse[a][i] > 0;
        }
    }
    /// near and far: the boxes' columns by axis, of the planes that this ray intersects first and last.
    HWY_INLINE Slab meet(const float* const near[3], const float* const far[3]) const {
        Slab slab{(load(near[0]) - near_origin[0]) * near_inverse[0],
                  (load(far[0]) - far_origin[0]) * far_inverse[0]};
        for (int a = 1; a < 3; ++a) {
            slab.entry = max(slab.entry, (load(near[a]) - near_origin[a]) * near_inverse[a]);
            slab.exit = min(slab.exit, (load(far[a]) - far_origin[a]) * far_inverse[a]);
        }
        return slab;
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
