// SPDX-License-Identifier: Apache-2.0
// Faults that no setting of a scene makes (world/tracer_fault.h).
#include "compare/scene_faults.h"

namespace glint {
namespace {

bool has_phong(const Scene& s) { return has_highlights(s) && s.settings.shading == Shading::phong; }
bool has_blinn(const Scene& s) { return has_highlights(s) && s.settings.shading == Shading::blinn_phong; }
bool has_eye(const Scene& s) {
    return s.camera.projection == Projection::perspective && !s.camera.lighting_eye;
}
bool is_normalized(const Scene& s) { return is_lit(s) && s.conventions.normalize; }

constexpr SceneFault k_kernel[] = {
    {.name = "light-vector-not-normalized",
     .applies = is_normalized,
     .explanation = "L is not of unit length: normalise the vector to the light before taking N.L and R.V.",
     .fault = TracerFault::light_not_unit},
    {.name = "half-vector-not-normalized",
     .applies = [](const Scene& s) { return is_normalized(s) && has_blinn(s); },
     .explanation = "H is not of unit length: normalise L + V before taking N.H.",
     .fault = TracerFault::half_not_unit},
    {.name = "half-vector-not-normalized",
     .applies = [](const Scene& s) { return is_normalized(s) && has_blinn(s); },
     .explanation = "H is (L + V) / 2, which is not of unit length: normalise L + V before taking N.H.",
     .fault = TracerFault::half_of_sum},
    {.name = "half-vector-wrong",
     .applies = has_blinn,
     .explanation = "H is the direction of L - V: it is that of L + V, where V goes from P to the eye.",
     .fault = TracerFault::half_of_difference},
    {.name = "normal-not-normalized",
     .applies = is_normalized,
     .explanation = "The normal of a sphere is not of unit length: divide P - C by the radius.",
     .fault = TracerFault::normal_not_unit},
    {.name = "normal-not-normalized",
     .applies = [](const Scene& s) { return is_normalized(s) && has_mirrors(s); },
     .explanation = "The normal of a sphere is not of unit length, also in mirror rays: divide P - C by the "
                    "radius.",
     .fault = TracerFault::normal_not_unit_anywhere},
    {.name = "normals-reversed",
     .applies = is_lit,
     .explanation = "N is reversed where surfaces are lit: a sphere's N is P - C, not C - P. The highlight "
                    "does not show it, because R is the same.",
     .fault = TracerFault::normals_reversed},
    {.name = "normals-reversed",
     .applies = is_lit,
     .explanation =
         "The normals of spheres are reversed: N is P - C, not C - P. (Or spheres shade themselves: a shadow "
         "ray starts at P, not in the sphere, and only hits with t > 0 count; or the farther of the two hits "
         "is taken, not the nearer.)",
     .fault = TracerFault::sphere_normals_reversed},
    {.name = "normals-reversed",
     .applies = [](const Scene& s) { return is_lit(s) && s.conventions.facing != Facing::all; },
     .explanation = "The normals of triangles are reversed: exchange the two vectors of their cross product.",
     .fault = TracerFault::face_normals_reversed},
    {.name = "normal-from-origin",
     .applies = is_lit,
     .explanation = "The normal of a sphere is the direction of P: subtract the centre, N = (P - C) / r.",
     .fault = TracerFault::normal_from_origin},
    {.name = "view-vector-not-normalized",
     .applies = [](const Scene& s) { return is_normalized(s) && has_highlights(s) && has_eye(s); },
     .explanation = "V is not of unit length: normalise the vector to the eye before taking R.V or L + V.",
     .fault = TracerFault::view_not_unit},
    {.name = "cosine-of-other-vectors",
     .applies = is_lit,
     .explanation = "The diffuse term is of N.V: it is k_d (N.L).",
     .fault = TracerFault::diffuse_of_view},
    {.name = "cosine-of-other-vectors",
     .applies = has_phong,
     .explanation = "The highlight is of N.R: it is k_s (R.V)^n.",
     .fault = TracerFault::specular_of_normal},
    {.name = "cosine-of-other-vectors",
     .applies = has_phong,
     .explanation = "The highlight is of R.L: it is k_s (R.V)^n.",
     .fault = TracerFault::specular_of_light},
    {.name = "cosine-of-other-vectors",
     .applies = has_blinn,
     .explanation = "The highlight is of H.V: it is k_s (N.H)^n.",
     .fault = TracerFault::specular_of_half},
    {.name = "diffuse-squared",
     .applies = is_lit,
     .explanation = "The diffuse term has (N.L)^2: it is k_d (N.L).",
     .fault = TracerFault::diffuse_squared},
    {.name = "half-lambert",
     .applies = is_lit,
     .explanation = "The diffuse term has (N.L + 1) / 2: it is k_d max(0, N.L).",
     .fault = TracerFault::half_lambert},
    {.name = "shadow-ray-short",
     .applies = has_shadows,
     .explanation =
         "Only hits with t < 1 cast shadows: L is of unit length, so t goes to the distance of the "
         "light.",
     .fault = TracerFault::shadow_to_one},
    {.name = "shadow-ray-negated",
     .applies = has_shadows,
     .put =
         [](Scene& s) {
             s.conventions.shadow_stops_at_light = false;
             s.conventions.offset = Offset::ray;
         },
     .explanation = "Shadow rays go away from the light: their direction is L, from P to the light. "
                    "(Or their hits with t < 0 count.)",
     .fault = TracerFault::shadow_negated},
    {.name = "reflection-vector-negated",
     .applies = has_phong,
     .explanation = "R points the wrong way: it is 2 N (N.L) - L, where L points to the light.",
     .fault = TracerFault::reflection_negated},
    {.name = "highlight-times-cosine",
     .applies = has_highlights,
     .explanation = "The specular term is multiplied by N.L: it is k_s (R.V)^n, or (N.H)^n, alone.",
     .fault = TracerFault::specular_times_n_l},
    {.name = "diffuse-exponent",
     .applies = has_highlights,
     .explanation = "The exponent is applied to the diffuse term: it is k_d (N.L), not k_d (N.L)^n.",
     .fault = TracerFault::diffuse_to_power},
    {.name = "mirror-direction",
     .applies = has_mirrors,
     .explanation = "Mirror rays go into the surface: their direction is D - 2 N (N.D), not D + 2 N (N.D).",
     .fault = TracerFault::mirror_into_surface},
    {.name = "mirror-direction",
     .applies = has_mirrors,
     .explanation = "Mirror rays go backwards: their direction is D - 2 N (N.D), not its opposite.",
     .fault = TracerFault::mirror_negated},
    {.name = "mirror-direction",
     .applies = has_mirrors,
     .explanation = "Mirror rays go along the surface: their direction is D - 2 N (N.D), not D - N (N.D).",
     .fault = TracerFault::mirror_along_surface},
    {.name = "last-shape-hit",
     .applies = [](const Scene&) { return true; },
     .explanation = "The last shape that a ray hits is drawn, not the nearest: keep a hit only if its t is "
                    "below the least so far.",
     .fault = TracerFault::last_shape},
    {.name = "first-shape-hit",
     .applies = [](const Scene&) { return true; },
     .explanation = "The first shape in the scene that a ray hits is drawn, not the nearest: test all shapes "
                    "and keep the least t.",
     .fault = TracerFault::first_shape},
    {.name = "hits-behind-camera",
     .applies = [](const Scene&) { return true; },
     .explanation = "Shapes behind the start of a ray are hit: ignore hits with t < 0.",
     .fault = TracerFault::behind_start},
};

}  // namespace

std::span<const SceneFault> kernel_faults() { return k_kernel; }

}  // namespace glint
