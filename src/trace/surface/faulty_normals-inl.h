// SPDX-License-Identifier: Apache-2.0
// The normals of spheres with a fault (world/tracer_fault.h), for instantiations of the stages of its own.
#if defined(GLINT_TRACE_FAULTY_NORMALS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_FAULTY_NORMALS_INL_H_
#undef GLINT_TRACE_FAULTY_NORMALS_INL_H_
#else
#define GLINT_TRACE_FAULTY_NORMALS_INL_H_
#endif

#include "trace/batches.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// of_sphere(radius) of the spheres among a vector of surfaces, 1 of other shapes.
template <class OfSphere>
HWY_INLINE Doubles normal_factors(const WorldParts& world, const SurfaceBatch& surfaces, int i,
                                  OfSphere of_sphere) {
    alignas(k_ray_alignment) double factors[lane_count<double>()];
    for (int k = 0; k < lane_count<double>(); ++k) {
        const std::uint32_t slot = surfaces.slot[static_cast<std::size_t>(i + k)];
        const ShapeClass& shapes = world.geometry->class_of(slot);
        const bool is_sphere = shapes.kind == ShapeKind::sphere && !shapes.transformed;
        factors[k] = is_sphere ? of_sphere(shapes.column(3)[slot - shapes.first]) : 1;
    }
    return load(factors);
}

/// |P - C| of spheres.
HWY_INLINE Doubles normal_lengths(const WorldParts& world, const SurfaceBatch& surfaces, int i) {
    return normal_factors(world, surfaces, i, [](double radius) { return radius; });
}

/// -1 of spheres.
HWY_INLINE Doubles normal_signs(const WorldParts& world, const SurfaceBatch& surfaces, int i) {
    return normal_factors(world, surfaces, i, [](double) { return -1.0; });
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
