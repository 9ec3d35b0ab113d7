// SPDX-License-Identifier: Apache-2.0
// Rays that traverse the mesh of a shape, in the mesh's coordinates. They extend the hit rule:
//   A ray hits a triangle of a shape's mesh at t if it meets the shape's own padded box, in the world, and
//   the mapped ray hits the triangle by the hit rule, within the interval of that box. The direction is not
//   normalised, so that t is the same.
#if defined(GLINT_TRACE_INSTANCES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_INSTANCES_INL_H_
#undef GLINT_TRACE_INSTANCES_INL_H_
#else
#define GLINT_TRACE_INSTANCES_INL_H_
#endif

#include <bit>

#include "trace/hits/trace_chunk-inl.h"
#include "world/geometry/mesh_triangle-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Rays of a packet in the coordinates of a mesh, and their nearest hits or occlusions.
struct MappedRays {
    static constexpr int k_size = k_packet_size + k_ray_padding;
    int count = 0;
    int ray[k_packet_size];  // in the chunk
    alignas(64) double origin[3][k_size], direction[3][k_size], t_min[k_size], t_max[k_size];
    alignas(64) double t[k_size];
    std::uint32_t slot[k_size], element[k_size];
    std::uint8_t occluded[k_size];

    RaySpan span() const {
        return {origin[0], origin[1], origin[2], direction[0], direction[1], direction[2], t_min, t_max};
    }
    HitColumns hits() { return {t, slot, element}; }

    /// The packet's rays `active`, which meet the box, within their intervals in it, whose ends belong to
    /// them. any: else a hit at the t of the nearest one so far is found, too: HitResult decides between
    /// them.
    template <bool any>
    HWY_INLINE void map(const RayPacket& packet, std::uint64_t active, const RaySpan& rays,
                        const double* nearest, const float* lo, const float* hi,
                        const double* object_from_world) {
        for (std::uint64_t rest = active; rest != 0; rest &= rest - 1) {
            const int i = packet.first + __builtin_ctzll(rest);
            const Slab slab = box_slab(packet, i, lo, hi);
            alignas(64) float entry[lane_count<float>()], exit[lane_count<float>()];
            store(slab.entry, entry);
            store(slab.exit, exit);
            const double begin = static_cast<double>(entry[0]), end = static_cast<double>(exit[0]);
            if (!(number::max(rays.t_min[i], begin) <= number::min(nearest[i], end))) continue;
            // Hits are above t_min and below t_max.
            const double first = rays.t_min[i] < begin ? -next_above(-begin) : rays.t_min[i],
                         last = end < nearest[i] ? next_above(end)
                                : any            ? nearest[i]
                                                 : next_above(nearest[i]);
            const Ray<double> mapped = AffineMap::to_object(
                object_from_world,
                Ray<double>{{rays.ox[i], rays.oy[i], rays.oz[i]}, {rays.dx[i], rays.dy[i], rays.dz[i]}});
            set(count, mapped, first, last);
            ray[count++] = i;
        }
        if (count == 0) return;
        // Padding that may be read: rays that hit nothing.
        for (int k = count; k < count + k_ray_padding; ++k) {
            for (int a = 0; a < 3; ++a)
                origin[a][k] = origin[a][count - 1], direction[a][k] = direction[a][count - 1];
            t_min[k] = t_min[count - 1];
            t[k] = t_max[k] = -k_infinity;
            slot[k] = k_none;
            element[k] = 0;
            occluded[k] = 0;
        }
    }

  private:
    /// The least number above x, which is not NaN.
    static HWY_INLINE double next_above(double x) {
        if (x == k_infinity) return x;
        const auto bits = std::bit_cast<std::int64_t>(x + 0.0);
        return std::bit_cast<double>(bits + (bits < 0 ? -1 : 1));
    }
    HWY_INLINE void set(int k, const Ray<double>& mapped, double first, double last) {
        origin[0][k] = mapped.origin.x, origin[1][k] = mapped.origin.y, origin[2][k] = mapped.origin.z;
        direction[0][k] = mapped.direction.x, direction[1][k] = mapped.direction.y,
        direction[2][k] = mapped.direction.z;
        t_min[k] = first;
        t[k] = t_max[k] = last;
        slot[k] = k_none;
        element[k] = 0;
        occluded[k] = 0;
    }
};

void ShapeTests::instances_leaf(const ShapeClass& shapes, const RayPacket& packet, std::uint64_t active,
                                std::uint32_t first, std::uint32_t count) {
    for (std::uint32_t shape = first; shape < first + count; ++shape) {
        const float lo[3] = {geometry.box_lo[0][shape], geometry.box_lo[1][shape], geometry.box_lo[2][shape]};
        const float hi[3] = {geometry.box_hi[0][shape], geometry.box_hi[1][shape], geometry.box_hi[2][shape]};
        const std::uint64_t met = rays_that_meet(packet, active, lo, hi);
        if (met == 0) continue;
        double p[MeshGeometry::k_values];
        broadcast_values<MeshGeometry::k_values>(shapes, shape, p);
        const PackedGeometry& mesh = mesh_of(geometry, shapes, shape).geometry;
        if (mesh.bvh.nodes.empty()) continue;
        MappedRays mapped;
        if (result.occluded != nullptr)
            mapped.map<true>(packet, met, rays, result.nearest.t, lo, hi, p);
        else
            mapped.map<false>(packet, met, rays, result.nearest.t, lo, hi, p);
        if (mapped.count == 0) continue;
        const WorldRays world_rays{rays, mapped.ray};
        if (result.occluded != nullptr) {
            trace_chunk<true>(result.world, mesh, shape, mapped.span(), mapped.count, k_packet_size,
                              mapped.hits(), mapped.occluded, false, world_rays);
            for (int k = 0; k < mapped.count; ++k) {
                if (mapped.occluded[k] != 0) result.occlude(mapped.ray[k], {shape, 0});
            }
        } else {
            trace_chunk<false>(result.world, mesh, shape, mapped.span(), mapped.count, k_packet_size,
                               mapped.hits(), nullptr, false, world_rays);
            for (int k = 0; k < mapped.count; ++k) {
                if (mapped.slot[k] != k_none)
                    result.accept(mapped.ray[k], mapped.t[k], {shape, mapped.element[k]});
            }
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
