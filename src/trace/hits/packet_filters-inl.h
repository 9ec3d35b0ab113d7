// SPDX-License-Identifier: Apache-2.0
// The shapes' single-precision filters for a packet.
#if defined(GLINT_TRACE_PACKET_FILTERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_PACKET_FILTERS_INL_H_
#undef GLINT_TRACE_PACKET_FILTERS_INL_H_
#else
#define GLINT_TRACE_PACKET_FILTERS_INL_H_
#endif

#include "bvh/ray_packet-inl.h"
#include "geometry/kinds-inl.h"
#include "trace/hits/quick_rays-inl.h"
#include "world/geometry/packed_values-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The filters of a vector of triangles for a packet whose rays have a common origin. They are computed once
/// per leaf instead of once per ray. Empty for kinds that do not share filters, except spheres.
template <class Geometry> class SharedFilters {
  public:
    /// Computes the filters of slots [first, first + count), count <= lanes. Returns a bit for each shape
    /// that a ray of the packet may hit.
    HWY_INLINE std::uint32_t prepare(const ShapeClass& shapes, const RayPacket& packet, const Vec3& origin,
                                     std::uint32_t first, int count) {
        int i = 0;
        do {
            Doubles p[Geometry::k_bounds_values];
            load_values<Geometry::k_bounds_values>(shapes, first + static_cast<std::uint32_t>(i), p);
            const auto f = TriangleGeometry::Filter<Doubles>::from_one_origin(p, lanes_of(origin));
            const Doubles values[10] = {f.ab.x, f.ab.y, f.ab.z, f.bc.x, f.bc.y,
                                        f.bc.z, f.ca.x, f.ca.y, f.ca.z, f.slack};
            for (int k = 0; k < 10; ++k) store_narrow(values[k], value_[k] + i);
            i += lane_count<double>();
        } while (i < count);
        Floats v[10];
        for (int k = 0; k < 10; ++k) v[k] = load(value_[k]);
        const TriangleGeometry::Filter<Floats> all{
            {v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}, v[9]};
        const float *lo = packet.min_direction, *hi = packet.max_direction;
        return to_bits(all.some_may_hit({Floats(lo[0]), Floats(lo[1]), Floats(lo[2])},
                                        {Floats(hi[0]), Floats(hi[1]), Floats(hi[2])})) &
               first_bits(count);
    }
    /// The filter of one triangle, in all lanes.
    HWY_INLINE TriangleGeometry::Filter<Floats> one(int lane) const {
        const auto at = [&](int k) HWY_ATTR { return Floats(value_[k][lane]); };
        return {{at(0), at(1), at(2)}, {at(3), at(4), at(5)}, {at(6), at(7), at(8)}, at(9)};
    }

  private:
    alignas(64) float value_[10][Geometry::k_shares_filter ? lane_count<float>() : 1];
};

/// The filters of a vector of spheres for parallel rays.
template <> class SharedFilters<SphereGeometry> {
  public:
    using Test = SphereGeometry::ParallelTest<Floats>;

    /// Computes the filters of slots [first, first + count), count <= lanes.
    HWY_INLINE void prepare(const ShapeClass& shapes, const QuickRays& rays, std::uint32_t first, int count) {
        for (int i = 0; i < count; i += lane_count<double>()) {
            Doubles p[SphereGeometry::k_values];
            load_values<SphereGeometry::k_values>(shapes, first + static_cast<std::uint32_t>(i), p);
            const auto f = SphereGeometry::ParallelTest<Doubles>::of(p, rays.frame(), Test::k_single_slack,
                                                                     Doubles(rays.start_along()));
            const Doubles values[6] = {f.center.x, f.center.y, f.center.z, f.reach_2, f.inner_2, f.ahead};
            for (int k = 0; k < 6; ++k) store_narrow(values[k], value_[k] + i);
        }
    }
    /// The filter of one sphere, in all lanes.
    HWY_INLINE Test one(int lane) const {
        const auto at = [&](int k) HWY_ATTR { return Floats(value_[k][lane]); };
        return {{at(0), at(1), at(2)}, at(3), at(4), at(5)};
    }

  private:
    // Initialised only because the compiler does not see that prepare() was called.
    alignas(64) float value_[6][lane_count<float>()] = {};
};

/// Sets of rays.
struct FilteredRays {
    std::uint64_t may_hit = 0, hit = 0;
};

/// The rays among `active` that may hit the shape in a slot, or that certainly do. lane: the shape's index in
/// `shared`.
template <class Geometry>
HWY_INLINE FilteredRays filter_rays(const ShapeClass& shapes, const RayPacket& packet,
                                    [[maybe_unused]] QuickRays& quick, std::uint64_t active,
                                    [[maybe_unused]] const SharedFilters<Geometry>& shared,
                                    std::uint32_t slot, [[maybe_unused]] int lane) {
    constexpr int lanes = lane_count<float>();
    using Filter = typename Geometry::template Filter<Floats>;
    const auto columns = [&](const float(*c)[SlabRays::k_size], int i) HWY_ATTR {
        return Vector3<Floats>{load(c[0] + i), load(c[1] + i), load(c[2] + i)};
    };
    FilteredRays passed;
    const auto pass = [&](const Filter& filter, const Vector3<Floats>& direction, int r) HWY_ATTR {
        passed.may_hit |= active & std::uint64_t{to_bits(filter.may_hit(direction))} << r;
    };
    const auto direction = [&](int r) HWY_ATTR { return columns(packet.rays.direction, packet.first + r); };
    if constexpr (Geometry::k_shares_filter) {
        if (packet.common_origin) {
            const Filter filter = shared.one(lane);
            for (int r = 0; r < packet.count; r += lanes) pass(filter, direction(r), r);
            return passed;
        }
    }
    if constexpr (Geometry::k_quick) {
        if (quick.parallel()) {
            const auto filter = shared.one(lane);
            for (int r = 0; r < packet.count; r += lanes) {
                const auto result = filter.test(quick.narrow(packet.first + r));
                passed.hit |= active & std::uint64_t{to_bits(result.is_hit)} << r;
                passed.may_hit |= active & std::uint64_t{to_bits(result.may_hit)} << r;
            }
            passed.may_hit &= ~passed.hit;
            return passed;
        }
    }
    Floats q[Geometry::k_values];
    broadcast_values<Geometry::k_values, float>(shapes, slot, q);
    const auto& origin = packet.rays.origin;
    if (packet.common_origin) {
        const int i = packet.first;
        const Filter filter =
            Filter::of(q, {Floats(origin[0][i]), Floats(origin[1][i]), Floats(origin[2][i])});
        for (int r = 0; r < packet.count; r += lanes) pass(filter, direction(r), r);
    } else {
        for (int r = 0; r < packet.count; r += lanes)
            pass(Filter::of(q, columns(origin, packet.first + r)), direction(r), r);
    }
    return passed;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
