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

/// factor_of(class, slot) of a vector of surfaces.
template <class FactorOf>
HWY_INLINE Doubles normal_factors(const WorldParts& world, const SurfaceBatch& surfaces, int i,
                                  FactorOf factor_of) {
    alignas(k_ray_alignment) double factors[lane_count<double>()];
    for (int k = 0; k < lane_count<double>(); ++k) {
        const std::uint32_t slot = surfaces.slot[static_cast<std::size_t>(i + k)];
        factors[k] = factor_of(world.geometry->class_of(slot), slot);
    }
    return load(factors);
}

inline bool is_plain_sphere(const ShapeClass& shapes) {
    return shapes.kind == ShapeKind::sphere && !shapes.transformed;
}

/// |P - C| of spheres.
HWY_INLINE Doubles normal_lengths(const WorldParts& world, const SurfaceBatch& surfaces, int i) {
    return normal_factors(world, surfaces, i, [](const ShapeClass& shapes, std::uint32_t slot) {
        return is_plain_sphere(shapes) ? shapes.column(3)[slot - shapes.first] : 1.0;
    });
}

/// -1 of spheres.
HWY_INLINE Doubles normal_signs(const WorldParts& world, const SurfaceBatch& surfaces, int i) {
    return normal_factors(world, surfaces, i, [](const ShapeClass& shapes, std::uint32_t) {
        return is_plain_sphere(shapes) ? -1.0 : 1.0;
    });
}

/// -1 of triangles and meshes.
HWY_INLINE Doubles face_normal_signs(const WorldParts& world, const SurfaceBatch& surfaces, int i) {
    return normal_factors(world, surfaces, i, [](const ShapeClass& shapes, std::uint32_t) {
        const bool is_face = shapes.kind == ShapeKind::triangle ||
                             shapes.kind == ShapeKind::smooth_triangle || shapes.kind == ShapeKind::mesh;
        return is_face ? -1.0 : 1.0;
    });
}

/// The direction of P for spheres, else N.
HWY_INLINE Vector3<Doubles> normals_from_origin(const WorldParts& world, const SurfaceBatch& surfaces,
                                                int i) {
    const Vector3<Doubles> point = load_vector3(surfaces.point, i);
    const auto is_sphere = normal_signs(world, surfaces, i) < Doubles(0);
    return select_vector3(is_sphere, point / max(length(point), Doubles(1e-300)),
                          load_vector3(surfaces.normal, i));
}

/// From surfaces to the camera.
HWY_INLINE Vector3<Doubles> camera_vectors(const WorldParts& world, const SurfaceBatch& surfaces, int i) {
    return lanes_of(world.camera.position) - load_vector3(surfaces.point, i);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
