// The hierarchy's slab expression, for single rays in lanes and, by intervals, for a beam of them.
//
// Every decision about a box uses one expression of a ray and the box's planes, in single precision:
//   entry = max over axes of (near plane - origin) * inverse,   exit = min over axes of (far plane - origin)
//   * inverse
// with the origin and the inverse direction rounded so that entry is never too late and exit never too early.
// IEEE rounding is monotone: the entry of a box is at most that of any box inside it, and an interval
// evaluation of the same expression bounds every ray of a beam. So grouping rays, or the shape of the tree,
// cannot change what is hit.
#if defined(GLINT_BVH_BEAM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_BVH_BEAM_INL_H_
#undef GLINT_BVH_BEAM_INL_H_
#else
#define GLINT_BVH_BEAM_INL_H_
#endif

#include <limits>

#include "bvh/bvh.h"
#include "bvh/rays.h"
#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Up to k_beam rays that walk the hierarchy together.
struct Beam {
    static constexpr int k_size = k_beam + 16;  // a full vector of padding
    // By axis and ray: the rounded origins and inverse directions for the near and for the far plane.
    alignas(64) float near_origin[3][k_size], far_origin[3][k_size];
    alignas(64) float near_inverse[3][k_size], far_inverse[3][k_size];
    alignas(64) float origin[3][k_size], direction[3][k_size];  // rounded to nearest, for the shapes' filters
    alignas(64) float t_min[k_size];                            // rounded down
    alignas(64) float t_max[k_size];  // rounded up; shrinks to the nearest hit so far; -infinity once a ray
                                      // needs no more
    int count = 0;

    // Over all rays: which way they go along an axis (0: both), and the intervals of the above.
    struct Axis {
        int sign = 0;
        float near_origin = 0,
              far_origin = 0;  // the end of the interval that gives the earliest entry, the latest exit
        float near_least = 0, near_most = 0, far_least = 0, far_most = 0;
    };
    Axis axis[3];
    float least_t_min = 0, most_t_max = 0;

    /// After rays' t_max have shrunk.
    HWY_INLINE void update_t_max() {
        Floats most(-std::numeric_limits<float>::infinity());
        for (int i = 0; i < count; i += lane_count<float>()) most = max(most, load(t_max + i));
        alignas(64) float lanes[lane_count<float>()];
        store(most, lanes);
        most_t_max = lanes[0];
        for (int i = 1; i < lane_count<float>(); ++i) most_t_max = number::max(most_t_max, lanes[i]);
    }
};

/// A float at most x, at least x less two units in the last place.
HWY_INLINE float float_below(double x) {
    const float f = static_cast<float>(x);
    return f - ((f < 0 ? -f : f) * 0x1p-23f + 1e-37f);
}
HWY_INLINE float float_above(double x) { return -float_below(-x); }

/// False for a ray with a NaN or an infinite number in it, or one beyond single precision: it meets no box.
HWY_INLINE bool is_usable(const RaySpan& rays, int i) {
    const double all[6] = {rays.ox[i], rays.oy[i], rays.oz[i], rays.dx[i], rays.dy[i], rays.dz[i]};
    bool usable = true;
    for (const double x : all) usable &= number::abs(x) < 1e37;
    return usable;
}

/// Prepares the beam of rays [first, first + count) of the stream, count <= k_beam.
inline void make_beam(const RaySpan& rays, int first, int count, Beam& beam) {
    beam.count = count;
    const double* origins[3] = {rays.ox + first, rays.oy + first, rays.oz + first};
    const double* directions[3] = {rays.dx + first, rays.dy + first, rays.dz + first};
    bool usable[k_beam];
    for (int i = 0; i < count; ++i) usable[i] = is_usable(rays, first + i);
    for (int a = 0; a < 3; ++a) {
        Beam::Axis& axis = beam.axis[a];
        int forward = 0;
        for (int i = 0; i < count; ++i) {
            const double o = usable[i] ? origins[a][i] : 0;
            double d = usable[i] ? directions[a][i] : 1;
            // A direction of 0 along an axis becomes tiny: the slab then covers all t, or none.
            if (number::abs(d) < 1e-30) d = d < 0 ? -1e-30 : 1e-30;
            const bool ahead = d > 0;
            forward += ahead;
            beam.origin[a][i] = static_cast<float>(o);
            beam.direction[a][i] = static_cast<float>(d);
            const float below = float_below(o), above = float_above(o);
            beam.near_origin[a][i] = ahead ? above : below;
            beam.far_origin[a][i] = ahead ? below : above;
            const auto inverse = static_cast<float>(1 / d);
            beam.near_inverse[a][i] = inverse * (1 - 0x1p-21f);
            beam.far_inverse[a][i] = inverse * (1 + 0x1p-21f);
        }
        axis.sign = forward == count ? 1 : forward == 0 ? -1 : 0;
        axis.near_origin = beam.near_origin[a][0], axis.far_origin = beam.far_origin[a][0];
        axis.near_least = axis.near_most = beam.near_inverse[a][0];
        axis.far_least = axis.far_most = beam.far_inverse[a][0];
        for (int i = 1; i < count; ++i) {
            const float n = beam.near_origin[a][i], f = beam.far_origin[a][i];
            axis.near_origin =
                axis.sign > 0 ? number::max(axis.near_origin, n) : number::min(axis.near_origin, n);
            axis.far_origin =
                axis.sign > 0 ? number::min(axis.far_origin, f) : number::max(axis.far_origin, f);
            axis.near_least = number::min(axis.near_least, beam.near_inverse[a][i]);
            axis.near_most = number::max(axis.near_most, beam.near_inverse[a][i]);
            axis.far_least = number::min(axis.far_least, beam.far_inverse[a][i]);
            axis.far_most = number::max(axis.far_most, beam.far_inverse[a][i]);
        }
        for (int i = count; i < Beam::k_size; ++i) {
            beam.near_origin[a][i] = beam.far_origin[a][i] = 0;
            beam.near_inverse[a][i] = beam.far_inverse[a][i] = 1;
            beam.origin[a][i] = beam.direction[a][i] = 0;
        }
    }
    beam.least_t_min = std::numeric_limits<float>::infinity();
    for (int i = 0; i < count; ++i) {
        beam.t_min[i] = float_below(rays.t_min[first + i]);
        const double t_max = rays.t_max[first + i];
        beam.t_max[i] = t_max < 1e37 ? float_above(t_max) : std::numeric_limits<float>::infinity();
        if (!usable[i]) beam.t_max[i] = -std::numeric_limits<float>::infinity();
        beam.least_t_min = number::min(beam.least_t_min, beam.t_min[i]);
    }
    for (int i = count; i < Beam::k_size; ++i)
        beam.t_min[i] = 0, beam.t_max[i] = -std::numeric_limits<float>::infinity();
    beam.update_t_max();
}

/// A vector of slab intervals.
struct Slab {
    Floats entry, exit;
};

/// The slab expression for rays [i, i + lanes) of the beam and one box.
HWY_INLINE Slab box_slab(const Beam& beam, int i, const float* lo, const float* hi) {
    Slab slab{Floats(-std::numeric_limits<float>::infinity()),
              Floats(std::numeric_limits<float>::infinity())};
    for (int a = 0; a < 3; ++a) {
        const Floats near_inverse = load(beam.near_inverse[a] + i),
                     far_inverse = load(beam.far_inverse[a] + i);
        const Floats lower(lo[a]), upper(hi[a]);
        const auto ahead = near_inverse > Floats(0);
        const Floats near = select(ahead, lower, upper), far = select(ahead, upper, lower);
        slab.entry = max(slab.entry, (near - load(beam.near_origin[a] + i)) * near_inverse);
        slab.exit = min(slab.exit, (far - load(beam.far_origin[a] + i)) * far_inverse);
    }
    return slab;
}

/// The slab expression for ray i of the beam and a vector of boxes, given as their planes' columns.
HWY_INLINE Slab boxes_slab(const Beam& beam, int i, const float* const lo[3], const float* const hi[3]) {
    Slab slab{Floats(-std::numeric_limits<float>::infinity()),
              Floats(std::numeric_limits<float>::infinity())};
    for (int a = 0; a < 3; ++a) {
        const bool ahead = beam.near_inverse[a][i] > 0;
        const Floats near = load(ahead ? lo[a] : hi[a]), far = load(ahead ? hi[a] : lo[a]);
        slab.entry =
            max(slab.entry, (near - Floats(beam.near_origin[a][i])) * Floats(beam.near_inverse[a][i]));
        slab.exit = min(slab.exit, (far - Floats(beam.far_origin[a][i])) * Floats(beam.far_inverse[a][i]));
    }
    return slab;
}

/// Bounds of the slab expression over all rays of the beam, for a vector of a node's children from `child`
/// on.
HWY_INLINE Slab node_slab(const Beam& beam, const BvhNode& node, int child) {
    Slab slab{Floats(-std::numeric_limits<float>::infinity()),
              Floats(std::numeric_limits<float>::infinity())};
    for (int a = 0; a < 3; ++a) {
        const Beam::Axis& axis = beam.axis[a];
        if (axis.sign == 0) continue;
        const float* near = axis.sign > 0 ? node.lo[a] : node.hi[a];
        const float* far = axis.sign > 0 ? node.hi[a] : node.lo[a];
        const Floats to_near = load(near + child) - Floats(axis.near_origin);
        const Floats to_far = load(far + child) - Floats(axis.far_origin);
        const Floats entry =
            to_near * select(to_near >= Floats(0), Floats(axis.near_least), Floats(axis.near_most));
        const Floats exit =
            to_far * select(to_far >= Floats(0), Floats(axis.far_most), Floats(axis.far_least));
        slab.entry = max(slab.entry, entry);
        slab.exit = min(slab.exit, exit);
    }
    return slab;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
