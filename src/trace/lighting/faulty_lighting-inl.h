// SPDX-License-Identifier: Apache-2.0
// The lighting equation with a fault (world/tracer_fault.h), in instantiations of the stages of its own.
#if defined(GLINT_TRACE_FAULTY_LIGHTING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_FAULTY_LIGHTING_INL_H_
#undef GLINT_TRACE_FAULTY_LIGHTING_INL_H_
#else
#define GLINT_TRACE_FAULTY_LIGHTING_INL_H_
#endif

#include "lighting/phong-inl.h"
#include "trace/lighting/shadow_rays-inl.h"
#include "trace/surface/faulty_normals-inl.h"
#include "trace/surface/material-inl.h"
#include "trace/surface/surface-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// cosines() with the world's fault. to_light: from the surface to the light, of any length. c: without it.
HWY_INLINE Cosines<Doubles> faulty_cosines(const WorldParts& world, const SurfaceBatch& surfaces, int i,
                                           Vector3<Doubles> to_light, Vector3<Doubles> l,
                                           const LightingRules& rules, Cosines<Doubles> c) {
    const Vector3<Doubles> normal = load_vector3(surfaces.normal, i), v = load_vector3(surfaces.to_eye, i);
    switch (world.fault) {
        case TracerFault::light_not_unit:
            return cosines(normal, to_light, v, rules);
        case TracerFault::half_not_unit:
            return rules.shading == Shading::blinn_phong ? Cosines<Doubles>{c.n_l, dot(normal, l + v)} : c;
        case TracerFault::half_of_sum:
            return rules.shading == Shading::blinn_phong
                       ? Cosines<Doubles>{c.n_l, dot(normal, (l + v) * Doubles(0.5))}
                       : c;
        case TracerFault::half_lambert:  // there is no highlight behind, all the same
            return {c.n_l * Doubles(0.5) + Doubles(0.5), select(c.n_l > Doubles(0), c.s, Doubles(0))};
        case TracerFault::half_of_difference:
            return rules.shading == Shading::blinn_phong
                       ? Cosines<Doubles>{c.n_l, dot(normal, normalize(l - v))}
                       : c;
        case TracerFault::normal_not_unit:
        case TracerFault::normal_not_unit_anywhere:
            return cosines(normal * normal_lengths(world, surfaces, i), l, v, rules);
        case TracerFault::sphere_normals_reversed:
            return cosines(normal * normal_signs(world, surfaces, i), l, v, rules);
        case TracerFault::face_normals_reversed:
            return cosines(normal * face_normal_signs(world, surfaces, i), l, v, rules);
        case TracerFault::normals_reversed:
            return cosines(-normal, l, v, rules);
        case TracerFault::normal_from_origin:
            return cosines(normals_from_origin(world, surfaces, i), l, v, rules);
        case TracerFault::diffuse_of_view:
            return {dot(normal, v), c.s};
        case TracerFault::view_not_unit:
            return surfaces.generation == 0 ? cosines(normal, l, camera_vectors(world, surfaces, i), rules)
                                            : c;
        case TracerFault::reflection_negated:
            return rules.shading == Shading::phong ? Cosines<Doubles>{c.n_l, -c.s} : c;
        case TracerFault::specular_of_normal:
            return rules.shading == Shading::phong ? Cosines<Doubles>{c.n_l, c.n_l} : c;
        case TracerFault::specular_of_light:
            return rules.shading == Shading::phong
                       ? Cosines<Doubles>{c.n_l, Doubles(2) * c.n_l * c.n_l - Doubles(1)}
                       : c;
        case TracerFault::specular_of_half:
            return rules.shading == Shading::blinn_phong ? Cosines<Doubles>{c.n_l, dot(normalize(l + v), v)}
                                                         : c;
        default:
            return c;
    }
}

/// The shadow ray to a light at this distance.
HWY_INLINE ShadowRay<Doubles> faulty_shadow_ray(const WorldParts& world, const PreparedLight& light,
                                                Doubles distance, ShadowRay<Doubles> ray) {
    if (world.fault == TracerFault::shadow_negated) ray.direction = -ray.direction;
    if (world.fault != TracerFault::shadow_to_one) return ray;
    if (comes_from_light(light, world.conventions)) {
        ray.t_min = max(ray.t_min, Doubles(1) - Doubles(1) / distance);
    } else if (!light.has_position()) {
        ray.t_max = 1 / length(light.to_light);
    }
    return ray;
}

/// The cosine of the diffuse term.
HWY_INLINE Doubles faulty_diffuse(const WorldParts& world, const MaterialLanes& material, Doubles n_l) {
    if (world.fault == TracerFault::diffuse_squared) return n_l * max(n_l, Doubles(0));
    if (world.fault != TracerFault::diffuse_to_power) return n_l;
    return pow(max(n_l, Doubles(0)), material.value(k_shininess));
}

/// The power of the specular term.
HWY_INLINE Doubles faulty_power(const WorldParts& world, Doubles n_l, Doubles power) {
    return world.fault == TracerFault::specular_times_n_l ? power * max(n_l, Doubles(0)) : power;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
