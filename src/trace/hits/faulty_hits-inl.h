// SPDX-License-Identifier: Apache-2.0
// The hits of camera, mirror and glass rays with a fault (world/tracer_fault.h): every shape is tested with
// every ray.
#if defined(GLINT_TRACE_FAULTY_HITS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_FAULTY_HITS_INL_H_
#undef GLINT_TRACE_FAULTY_HITS_INL_H_
#else
#define GLINT_TRACE_FAULTY_HITS_INL_H_
#endif

#include "geometry/kinds-inl.h"
#include "trace/hits/intersect-inl.h"
#include "world/geometry/packed_values-inl.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Scenes of more shapes are rendered without the fault, and so are meshes and solids: it takes the product
/// of shapes and rays.
inline constexpr std::uint32_t k_max_faulty_shapes = 256;

/// Tests one shape with the rays of a stream, and replaces the hits that the fault prefers.
struct FaultyTest {
    const WorldParts& world;
    const RayBatch& rays;
    HitBatch& hits;
    const ShapeClass& shapes;
    std::uint32_t slot;

    bool is_preferred(double t, int i) const {
        const std::size_t at = static_cast<std::size_t>(i);
        const SurfaceId other = hits.surface(i);
        if (!other.exists() || world.fault == TracerFault::behind_start) return t < hits.t[at];
        const std::uint32_t mine = world.geometry->shape_index[slot],
                            theirs = world.geometry->shape_of(other);
        if (mine == theirs) return t < hits.t[at];
        return (mine > theirs) == (world.fault == TracerFault::last_shape);
    }
    template <class Geometry> HWY_INLINE void visit() {
        if constexpr (Geometry::k_has_formula && !Geometry::k_only_operand) test<Geometry>();
    }
    template <class Geometry> HWY_INLINE void test() {
        Doubles p[Geometry::k_values];
        broadcast_values<Geometry::k_values>(shapes, slot, p);
        const bool behind = world.fault == TracerFault::behind_start;
        for (int i = 0; i < hits.count; i += lane_count<double>()) {
            const int ray = hits.first + i;
            const Ray<Doubles> lanes{load_vector3(rays.origin, ray), load_vector3(rays.direction, ray)};
            const Doubles t_min = behind ? Doubles(-k_infinity) : load(rays.t_min.data() + ray);
            const Hit<Doubles> hit = Geometry::hit(p, lanes, t_min);
            alignas(k_ray_alignment) double t[lane_count<double>()];
            store(hit.t, t);
            std::uint32_t bits = to_bits(hit.valid && hit.t > t_min && first_lanes<double>(hits.count - i));
            for (; bits != 0; bits &= bits - 1) {
                const int k = __builtin_ctz(bits);
                if (!is_preferred(t[k], i + k)) continue;
                hits.columns().set(i + k, t[k], world.geometry->surface_of(slot));
            }
        }
    }
};

void put_faulty_hits(const WorldParts& world, const RayBatch& rays, HitBatch& hits) {
    const PackedGeometry& geometry = *world.geometry;
    if (geometry.count > k_max_faulty_shapes) return;
    for (std::uint32_t slot = 0; slot < geometry.first_operand(); ++slot) {
        const ShapeClass& shapes = geometry.class_of(slot);
        visit_geometry(shapes.kind, shapes.transformed, FaultyTest{world, rays, hits, shapes, slot});
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
