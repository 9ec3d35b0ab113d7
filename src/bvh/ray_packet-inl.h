// SPDX-License-Identifier: Apache-2.0
// A packet of coherent rays, which traverse the hierarchy together by interval arithmetic over the slab
// expression.
#if defined(GLINT_BVH_RAY_PACKET_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_BVH_RAY_PACKET_INL_H_
#undef GLINT_BVH_RAY_PACKET_INL_H_
#else
#define GLINT_BVH_RAY_PACKET_INL_H_
#endif

#include "bvh/slab-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Intervals of the numbers in the slab expression over several rays.
struct Intervals {
    struct Axis {
        int sign = 0;  // the sign of all directions; 0: mixed
        float near_origin = 0,
              far_origin = 0;  // the ends with the earliest entry and the latest exit
        float near_min = 0, near_max = 0, far_min = 0, far_max = 0;

        /// Bounds the numbers of every ray whose origin and inverse direction are in these ranges:
        /// narrow_rays() moves origins by a rounding margin, and shrinks or grows inverses by 2^-21.
        HWY_INLINE void set(float min_origin, float max_origin, float min_inverse, float max_inverse) {
            sign = min_inverse > 0 ? 1 : max_inverse < 0 ? -1 : 0;
            const float below = slightly_below(min_origin), above = slightly_above(max_origin);
            near_origin = sign > 0 ? above : below;
            far_origin = sign > 0 ? below : above;
            near_min = min_inverse * (sign > 0 ? k_shrink : k_grow);
            near_max = max_inverse * (sign > 0 ? k_grow : k_shrink);
            far_min = near_min, far_max = near_max;
        }

      private:
        static constexpr float k_grow = 1 + 0x1p-19f, k_shrink = 1 - 0x1p-19f;
        static HWY_INLINE float slightly_below(float f) { return f - ((f < 0 ? -f : f) * 0x1p-21f + 1e-36f); }
        static HWY_INLINE float slightly_above(float f) { return -slightly_below(-f); }
    };
    Axis axis[3];
    float min_t_min = -std::numeric_limits<float>::infinity(),
          max_t_max = std::numeric_limits<float>::infinity();
};

/// The prepared rays [first, first + count).
struct RayPacket : Intervals {
    SlabRays& rays;
    int first, count;
    bool common_origin;                        // in double, for the usable rays
    float min_direction[3], max_direction[3];  // if the origin is common

    /// A mask of all rays; ray `first` is the lowest bit.
    HWY_INLINE std::uint64_t all() const { return ~std::uint64_t{0} >> (64 - count); }

    HWY_INLINE RayPacket(SlabRays& prepared, int from, int rays_count)
        : rays(prepared), first(from), count(rays_count), common_origin(prepared.common_origin) {
        for (int a = 0; a < 3; ++a) {
            const Range inverse = range(rays.near_inverse[a]), origin = range(rays.origin[a]);
            common_origin = common_origin && origin.least == origin.most;
            axis[a].set(origin.least, origin.most, inverse.least, inverse.most);
        }
        for (int a = 0; common_origin && a < 3; ++a) {
            const Range direction = range(rays.direction[a]);
            min_direction[a] = direction.least, max_direction[a] = direction.most;
        }
        min_t_min = range(rays.t_min).least;
        update_t_max();
    }

    /// The rays that are not finished.
    HWY_INLINE std::uint64_t unfinished() const {
        std::uint64_t bits = 0;
        for (int r = 0; r < count; r += lane_count<float>()) {
            const int i = first + r;
            bits |= std::uint64_t{to_bits(load(rays.t_max + i) >= load(rays.t_min + i))} << r;
        }
        return bits & all();
    }

    /// Must be called after a ray's t_max has been reduced.
    HWY_INLINE void update_t_max() { max_t_max = range(rays.t_max).most; }

  private:
    struct Range {
        float least, most;
    };
    // A t_min that overflows its margin is NaN: the order of the arguments ignores it.
    HWY_INLINE Range range(const float* column) const {
        const Floats infinity(std::numeric_limits<float>::infinity());
        Floats least = infinity, most = -infinity;
        int i = first;
        for (; i + lane_count<float>() <= first + count; i += lane_count<float>()) {
            const Floats x = load(column + i);
            least = min(x, least), most = max(most, x);
        }
        if (i < first + count) {
            const auto active = first_lanes<float>(first + count - i);
            const Floats x = load(column + i);
            least = min(select(active, x, infinity), least), most = max(most, select(active, x, -infinity));
        }
        return {min_of_lanes(least), max_of_lanes(most)};
    }
};

/// Bounds of the slab expression over all rays, for a vector of boxes given by columns of their lower and
/// upper planes.
HWY_INLINE Slab packet_slab(const Intervals& packet, const float* const lo[3], const float* const hi[3]) {
    Slab slab{Floats(-std::numeric_limits<float>::infinity()),
              Floats(std::numeric_limits<float>::infinity())};
    for (int a = 0; a < 3; ++a) {
        const Intervals::Axis& axis = packet.axis[a];
        if (axis.sign == 0) continue;
        const Floats to_near = load(axis.sign > 0 ? lo[a] : hi[a]) - Floats(axis.near_origin);
        const Floats to_far = load(axis.sign > 0 ? hi[a] : lo[a]) - Floats(axis.far_origin);
        // Rounding is monotone: the smallest product is the product of the smallest factors.
        const Floats entry =
            to_near * select(to_near >= Floats(0), Floats(axis.near_min), Floats(axis.near_max));
        const Floats exit = to_far * select(to_far >= Floats(0), Floats(axis.far_max), Floats(axis.far_min));
        slab.entry = max(slab.entry, entry);
        slab.exit = min(slab.exit, exit);
    }
    return slab;
}

/// The slab expression for rays [i, i + lanes) of the packet and one box.
HWY_INLINE Slab box_slab(const RayPacket& packet, int i, const float* lo, const float* hi) {
    const SlabRays& rays = packet.rays;
    Slab slab{Floats(-std::numeric_limits<float>::infinity()),
              Floats(std::numeric_limits<float>::infinity())};
    for (int a = 0; a < 3; ++a) {
        const Floats near_inverse = load(rays.near_inverse[a] + i),
                     far_inverse = load(rays.far_inverse[a] + i);
        const Floats lower(lo[a]), upper(hi[a]);
        Floats near = lower, far = upper;
        if (packet.axis[a].sign < 0) near = upper, far = lower;
        if (packet.axis[a].sign == 0) {
            const auto ahead = near_inverse > Floats(0);
            near = select(ahead, lower, upper), far = select(ahead, upper, lower);
        }
        slab.entry = max(slab.entry, (near - load(rays.near_origin[a] + i)) * near_inverse);
        slab.exit = min(slab.exit, (far - load(rays.far_origin[a] + i)) * far_inverse);
    }
    return slab;
}
HWY_INLINE LaneMask<float> meets(const SlabRays& rays, int i, const Slab& slab) {
    return meets(slab, load(rays.t_min + i), load(rays.t_max + i));
}

/// Which rays of a subset intersect a box before their t_max.
HWY_INLINE std::uint64_t rays_that_meet(const RayPacket& packet, std::uint64_t some, const float* lo,
                                        const float* hi) {
    constexpr int lanes = lane_count<float>();
    std::uint64_t met = 0;
    for (int r = 0; r < packet.count; r += lanes) {
        const std::uint32_t here = static_cast<std::uint32_t>(some >> r) & first_bits(lanes);
        if (here == 0) continue;
        const int i = packet.first + r;
        met |= std::uint64_t{to_bits(meets(packet.rays, i, box_slab(packet, i, lo, hi))) & here} << r;
    }
    return met;
}

/// A mask of the boxes that any ray may intersect before its t_max.
HWY_INLINE std::uint32_t meets(const Intervals& packet, const Slab& slab) {
    return to_bits(meets(slab, Floats(packet.min_t_min), Floats(packet.max_t_max)));
}

/// A mask of the children that any ray may intersect; writes the earliest entries to `entries`.
HWY_INLINE std::uint32_t children_met(const Intervals& packet, const BvhNode& node, float* entries) {
    std::uint32_t met = 0;
    for (int c = 0; c < k_bvh_width; c += lane_count<float>()) {
        const float* lo[3] = {node.lo[0] + c, node.lo[1] + c, node.lo[2] + c};
        const float* hi[3] = {node.hi[0] + c, node.hi[1] + c, node.hi[2] + c};
        const Slab slab = packet_slab(packet, lo, hi);
        store(slab.entry, entries + c);
        met |= meets(packet, slab) << c;
    }
    return met;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
