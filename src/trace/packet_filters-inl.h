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
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The filters of a vector of triangles for a packet whose rays have a common origin. They are computed once
/// per leaf instead of once per ray. Empty for other shapes.
template <class Geometry> class SharedFilters {
  public:
    /// Computes the filters of slots [first, first + count), count <= lanes. Returns a bit for each shape
    /// that a ray of the packet may hit.
    HWY_INLINE std::uint32_t prepare(const ShapeClass& shapes, const RayPacket& packet, const Vec3& origin,
                                     std::uint32_t first, int count) {
        int i = 0;
        do {
            Doubles p[9];
            for (int k = 0; k < 9; ++k)
                p[k] = load(shapes.column(k) + (first - shapes.first) + static_cast<std::uint32_t>(i));
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
    alignas(64) float value_[10][k_is_triangle<Geometry> ? lane_count<float>() : 1];
};

/// The rays among `active` that may hit the shape in a slot. lane: the shape's index in `shared`.
template <class Geometry>
HWY_INLINE std::uint64_t filter_rays(const ShapeClass& shapes, const RayPacket& packet, std::uint64_t active,
                                     [[maybe_unused]] const SharedFilters<Geometry>& shared,
                                     std::uint32_t slot, [[maybe_unused]] int lane) {
    constexpr int lanes = lane_count<float>();
    using Filter = typename Geometry::template Filter<Floats>;
    const auto columns = [&](const float(*c)[SlabRays::k_size], int i) HWY_ATTR {
        return Vector3<Floats>{load(c[0] + i), load(c[1] + i), load(c[2] + i)};
    };
    std::uint64_t passed = 0;
    const auto pass = [&](const Filter& filter, int r) HWY_ATTR {
        const std::uint32_t here = static_cast<std::uint32_t>(active >> r) & first_bits(lanes);
        if (here == 0) return;
        const auto may = filter.may_hit(columns(packet.rays.direction, packet.first + r));
        passed |= std::uint64_t{to_bits(may) & here} << r;
    };
    if constexpr (k_is_triangle<Geometry>) {
        if (packet.common_origin) {
            const Filter filter = shared.one(lane);
            for (int r = 0; r < packet.count; r += lanes) pass(filter, r);
            return passed;
        }
    }
    Floats q[Geometry::k_values];
    for (int k = 0; k < Geometry::k_values; ++k)
        q[k] = Floats(static_cast<float>(shapes.column(k)[slot - shapes.first]));
    const auto& origin = packet.rays.origin;
    if (packet.common_origin) {
        const int i = packet.first;
        const Filter filter =
            Filter::of(q, {Floats(origin[0][i]), Floats(origin[1][i]), Floats(origin[2][i])});
        for (int r = 0; r < packet.count; r += lanes) pass(filter, r);
    } else {
        for (int r = 0; r < packet.count; r += lanes)
            pass(Filter::of(q, columns(origin, packet.first + r)), r);
    }
    return passed;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
