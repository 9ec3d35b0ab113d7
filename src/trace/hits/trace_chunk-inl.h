// SPDX-License-Identifier: Apache-2.0
// The traversal of a hierarchy by a chunk of rays.
#if defined(GLINT_TRACE_TRACE_CHUNK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_TRACE_CHUNK_INL_H_
#undef GLINT_TRACE_TRACE_CHUNK_INL_H_
#else
#define GLINT_TRACE_TRACE_CHUNK_INL_H_
#endif

#include "bvh/traverse-inl.h"
#include "bvh/traverse_any-inl.h"
#include "trace/hits/hit_rule-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The maximum difference of directions within a packet, relative to their size, for nearest hits. Measured:
/// values from 0.05 to 1 differ in speed by 10%, and 0.5 is fastest.
inline constexpr double k_nearest_spread = 0.5;

/// The number of coherent rays from `first` on, at most `most`: those with nearly the direction of the first.
/// They form a packet. A packet with more different directions would intersect all boxes between them.
HWY_INLINE int count_coherent(const SlabRays& rays, int first, int most) {
    const auto& d = rays.direction;
    const Floats x(d[0][first]), y(d[1][first]), z(d[2][first]);
    const Floats near = Floats(static_cast<float>(k_nearest_spread)) * (abs(x) + abs(y) + abs(z));
    for (int n = 0; n < most; n += lane_count<float>()) {
        const int i = first + n;
        const auto far = abs(load(d[0] + i) - x) + abs(load(d[1] + i) - y) + abs(load(d[2] + i) - z) > near;
        if (any(far)) return number::min(most, n + __builtin_ctz(to_bits(far)));
    }
    return most;
}

/// Traces packets of coherent rays, and the others one by one.
HWY_INLINE void trace_nearest(const Bvh& bvh, SlabRays& slab_rays, int count, int max_packet,
                              ShapeTests& tests) {
    for (int first = 0, n = 0; first < count; first += n) {
        n = count_coherent(slab_rays, first, number::min(max_packet, count - first));
        if (n >= k_min_packet_size) {
            RayPacket packet(slab_rays, first, n);
            traverse_packet(bvh, packet, tests);
            continue;
        }
        for (int i = first; i < first + n; ++i) {
            if (slab_rays.t_max[i] >= slab_rays.t_min[i])
                traverse_ray(bvh, slab_rays, i, BvhChild::node(0), tests);
        }
    }
}

/// Traces packets. They need not be coherent.
HWY_INLINE void trace_any(const Bvh& bvh, SlabRays& slab_rays, int count, int max_packet, ShapeTests& tests) {
    for (int first = 0; first < count; first += max_packet) {
        RayPacket packet(slab_rays, first, number::min(max_packet, count - first));
        // Neighbouring rays often have the same occluder.
        if (*tests.result.occluder != k_none) tests.visit_shape(packet, *tests.result.occluder);
        traverse_any(bvh, packet, tests);
    }
}

/// Traces rays [0, count) of the span, count <= SlabRays::k_max_rays. geometry: the world's, or that of a
/// mesh, which the shape in slot `instance` of the world has. world_rays: the same rays in the world.
/// parallel: all rays have one direction (any_hit only).
template <bool any>
HWY_NOINLINE void trace_chunk(const WorldParts& world, const PackedGeometry& geometry, std::uint32_t instance,
                              const RaySpan& rays, int count, int max_packet, HitColumns nearest,
                              std::uint8_t* occluded, bool parallel, const WorldRays& world_rays) {
    SlabRays slab_rays;
    prepare_rays(rays, count, slab_rays);
    std::uint32_t occluder = k_none;
    const HitResult result{world, slab_rays, nearest, occluded, &occluder, world_rays};
    ShearedRays sheared_rays(rays);
    QuickRays quick_rays(rays, count, parallel);
    ShapeTests tests{geometry, rays, slab_rays, result, sheared_rays, quick_rays, instance};
    for (const ShapeClass& shapes : geometry.classes) {
        if (shapes.first >= geometry.bounded && shapes.first < geometry.first_operand())
            tests.visit_unbounded(shapes, count);
    }
    if (geometry.bvh.nodes.empty()) return;
    if constexpr (any)
        trace_any(geometry.bvh, slab_rays, count, max_packet, tests);
    else
        trace_nearest(geometry.bvh, slab_rays, count, max_packet, tests);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
