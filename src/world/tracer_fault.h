// SPDX-License-Identifier: Apache-2.0
#pragma once
// Faults of ray tracers that no convention describes: a World with one is rendered by kernels of its own.
#include <cstdint>

namespace glint {

enum class TracerFault : std::uint8_t {
    none,
    light_not_unit,            ///< L has the length of the distance
    half_not_unit,             ///< H = L + V
    half_of_difference,        ///< H is the direction of L - V
    half_of_sum,               ///< H = (L + V) / 2
    half_lambert,              ///< (N.L + 1) / 2 in the diffuse term
    shadow_negated,            ///< shadow rays, which have no end then, go away from the light
    shadow_to_one,             ///< shapes further away than 1 cast no shadow
    normal_not_unit,           ///< a sphere's N is P - C
    normal_not_unit_anywhere,  ///< the same, and in mirror rays
    normals_reversed,          ///< -N in place of N, for the lighting only
    sphere_normals_reversed,   ///< the same, of spheres only
    face_normals_reversed,     ///< the same, of triangles and meshes only
    normal_from_origin,        ///< a sphere's N is the direction of P
    diffuse_of_view,           ///< N.V in place of N.L, in both terms' tests and in the diffuse term
    diffuse_squared,           ///< (N.L)^2 in the diffuse term
    specular_of_normal,        ///< N.R in place of R.V, in Phong's model
    specular_of_light,         ///< R.L in place of R.V, in Phong's model
    specular_of_half,          ///< H.V in place of N.H, in Blinn's model
    view_not_unit,             ///< V has the length of the distance to the camera, for camera rays
    eye_everywhere,            ///< Camera::lighting_eye is used in mirrors and glass, too
    reflection_negated,        ///< -R in place of R, in Phong's model
    specular_times_n_l,        ///< the specular term is multiplied by N.L
    diffuse_to_power,          ///< (N.L)^n in the diffuse term
    mirror_into_surface,       ///< mirror rays: D + 2 N (N.D) in place of D - 2 N (N.D)
    mirror_negated,            ///< mirror rays: 2 N (N.D) - D
    mirror_along_surface,      ///< mirror rays: D - N (N.D)
    last_shape,    ///< the hit is that of the last shape in the scene that is hit, not the nearest
    first_shape,   ///< the same, of the first shape
    behind_start,  ///< hits with t < 0 count
};

constexpr bool is_of_hits(TracerFault fault) { return fault >= TracerFault::last_shape; }

}  // namespace glint
