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
    // Rounded to nearest, for the shapes' filters; a direction's largest component is about 1.
    alignas(64) float origin[3][k_size], direction[3][k_size];
    alignas(64) float t_min[k_size];  // rounded down
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
        most_t_max = max_of_lanes(most);
    }
};

/// A float at most x, at least x less two units in the last place.
HWY_INLINE float float_below(double x) {
    const float f = static_cast<float>(x);
    return f - ((f < 0 ? -f : f) * 0x1p-23f + 1e-37f);
}
HWY_INLINE float float_above(double x) { return -float_below(-x); }

/// A vector of padding of the slab expression's numbers: see Beam::t_min and t_max.
HWY_INLINE Floats rounding_margin(Floats f) { return abs(f) * Floats(0x1p-23f) + Floats(1e-37f); }

/// The three coordinates of a vector of rays, rounded to single precision, and their inverse directions, into
/// the beam. A ray with a NaN or an infinite number in it, or one beyond single precision, meets no box.
/// Returns who may.
HWY_INLINE auto narrow_rays(const RaySpan& rays, int from, int to, Beam& beam) {
    const double* origins[3] = {rays.ox + from, rays.oy + from, rays.oz + from};
    const double* directions[3] = {rays.dx + from, rays.dy + from, rays.dz + from};
    const Doubles limit(1e37), tiny(1e-30);
    auto usable = abs(load(origins[0])) < limit;
    for (int a = 0; a < 3; ++a)
        usable = usable && abs(load(origins[a])) < limit && abs(load(directions[a])) < limit;
    Doubles direction[3], least_inverse(std::numeric_limits<double>::infinity());
    for (int a = 0; a < 3; ++a) {
        Doubles d = select(usable, load(directions[a]), Doubles(1));
        // A direction of 0 along an axis becomes tiny: the slab then covers all t, or none.
        d = select(abs(d) < tiny, select(d < Doubles(0), -tiny, tiny), d);
        const Doubles inverse = Doubles(1) / d;
        direction[a] = d;
        least_inverse = min(least_inverse, abs(inverse));
        store_narrow(select(usable, load(origins[a]), Doubles(0)), beam.origin[a] + to);
        store_narrow(inverse, beam.near_inverse[a] + to);
    }
    // Its largest component is about 1, so that its square is a float too.
    for (int a = 0; a < 3; ++a) store_narrow(direction[a] * least_inverse, beam.direction[a] + to);
    return usable;
}

/// The slab expression's numbers of an axis from its rounded origins and inverse directions, and their
/// intervals.
HWY_INLINE void make_axis(Beam& beam, int a, int padded) {
    const Floats infinity(std::numeric_limits<float>::infinity());
    Floats least_origin = infinity, most_origin = -infinity, least_inverse = infinity,
           most_inverse = -infinity;
    const Floats shrink(1 - 0x1p-21f), grow(1 + 0x1p-21f);
    for (int i = 0; i < padded; i += lane_count<float>()) {
        const Floats o = load(beam.origin[a] + i), inverse = load(beam.near_inverse[a] + i);
        const Floats below = o - rounding_margin(o), above = o + rounding_margin(o);
        const auto ahead = inverse > Floats(0);
        store(select(ahead, above, below), beam.near_origin[a] + i);
        store(select(ahead, below, above), beam.far_origin[a] + i);
        store(inverse * shrink, beam.near_inverse[a] + i);
        store(inverse * grow, beam.far_inverse[a] + i);
        least_origin = min(least_origin, below), most_origin = max(most_origin, above);
        least_inverse = min(least_inverse, inverse), most_inverse = max(most_inverse, inverse);
    }
    Beam::Axis& axis = beam.axis[a];
    const float least = min_of_lanes(least_inverse), most = max_of_lanes(most_inverse);
    axis.sign = least > 0 ? 1 : most < 0 ? -1 : 0;
    axis.near_origin = axis.sign > 0 ? max_of_lanes(most_origin) : min_of_lanes(least_origin);
    axis.far_origin = axis.sign > 0 ? min_of_lanes(least_origin) : max_of_lanes(most_origin);
    // Rounding is monotone: the least product is the product of the least.
    axis.near_least = least * (1 - 0x1p-21f), axis.near_most = most * (1 - 0x1p-21f);
    axis.far_least = least * (1 + 0x1p-21f), axis.far_most = most * (1 + 0x1p-21f);
}

/// Prepares the beam of rays [first, first + count) of the stream, 1 <= count <= k_beam.
inline void make_beam(const RaySpan& rays, int first, int count, Beam& beam) {
    beam.count = count;
    const int padded = (count + k_ray_padding - 1) / k_ray_padding * k_ray_padding;
    const Doubles never(-std::numeric_limits<double>::infinity());
    for (int i = 0; i < count; i += lane_count<double>()) {
        const auto usable = narrow_rays(rays, first + i, i, beam);
        store_narrow(load(rays.t_min + first + i), beam.t_min + i);
        store_narrow(select(usable, load(rays.t_max + first + i), never), beam.t_max + i);
    }
    for (int i = count; i < padded;
         ++i) {  // the last vector's other lanes repeat the first ray, and never hit
        for (int a = 0; a < 3; ++a) {
            beam.origin[a][i] = beam.origin[a][0];
            beam.direction[a][i] = beam.direction[a][0];
            beam.near_inverse[a][i] = beam.near_inverse[a][0];
        }
        beam.t_min[i] = beam.t_min[0];
        beam.t_max[i] = -std::numeric_limits<float>::infinity();
    }
    for (int a = 0; a < 3; ++a) make_axis(beam, a, padded);
    Floats least(std::numeric_limits<float>::infinity());
    for (int i = 0; i < padded; i += lane_count<float>()) {
        const Floats t_min = load(beam.t_min + i), t_max = load(beam.t_max + i);
        const Floats below = t_min - rounding_margin(t_min);
        store(below, beam.t_min + i);
        store(select(t_max < Floats(-1e37f), t_max, t_max + rounding_margin(t_max)), beam.t_max + i);
        least = min(least, below);
    }
    beam.least_t_min = min_of_lanes(least);
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
