// SPDX-License-Identifier: Apache-2.0
// The table of the quantities of a log.
#include "diagnose/trace_log.h"

namespace glint {

const QuantityInfo& info_of(Quantity quantity) {
    using enum Quantity;
    using Kind = QuantityKind;
    using Of = QuantityOf;
    static constexpr QuantityInfo infos[] = {
        {origin, "origin", Kind::vector, Of::ray, "the origin",
         "the camera's position, or P of the surface before", "LIGHT-1"},
        {direction, "direction", Kind::direction, Of::ray, "the direction D",
         "of a camera ray: forward + x right + y up; of a mirror ray: D - 2 N (N.D)",
         "docs/lighting.md#mirrors-as-a-sum"},
        {hit, "shape", Kind::label, Of::ray, "the shape that is hit",
         "the nearest hit in front of the origin", ""},
        {t, "t", Kind::number, Of::ray, "t", "the least t > 0 at which O + t D is on a shape", ""},
        {point, "P", Kind::vector, Of::ray, "P", "O + t D", ""},
        {normal, "N", Kind::direction, Of::ray, "N",
         "of a sphere: (P - C) / r; turned as the scene's rules say", "docs/conventions.md"},
        {view, "V", Kind::direction, Of::ray, "V", "-D / |D|", "docs/lighting.md"},
        {inside, "inside", Kind::flag, Of::ray, "whether the ray is inside", "N.D > 0 for the shape's own N",
         ""},
        {to_light, "L", Kind::direction, Of::light, "L", "light's position - P, or the light's direction",
         "docs/lighting.md"},
        {distance, "distance", Kind::number, Of::light, "the distance to the light", "|light's position - P|",
         "docs/lighting.md"},
        {attenuation, "attenuation", Kind::number, Of::light, "the attenuation",
         "min(1 / (c0 + c1 d + c2 d^2), 1)", "LIGHT-12, docs/lighting.md"},
        {spot, "spot", Kind::number, Of::light, "the spot's factor",
         "1 inside the inner angle, 0 outside the outer one", "docs/conventions.md"},
        {n_l, "N.L", Kind::number, Of::light, "N.L", "the cosine of the unit vectors N and L",
         "LIGHT-5, docs/lighting.md"},
        {reflected, "R", Kind::direction, Of::light, "R", "2 N (N.L) - L", "LIGHT-6, docs/lighting.md"},
        {half, "H", Kind::direction, Of::light, "H", "(L + V) / |L + V|", "docs/lighting.md"},
        {r_v, "R.V", Kind::number, Of::light, "R.V", "the cosine of R and V", "LIGHT-7, docs/lighting.md"},
        {n_h, "N.H", Kind::number, Of::light, "N.H", "the cosine of N and H", "docs/lighting.md"},
        {power, "power", Kind::number, Of::light, "the power", "(R.V)^n or (N.H)^n, 0 for a cosine below 0",
         "docs/lighting.md#the-exponent"},
        {blocked, "blocked", Kind::flag, Of::light, "whether the light is blocked",
         "a shape between P and the light", "docs/lighting.md"},
        {diffuse, "diffuse", Kind::color, Of::light, "the diffuse term",
         "k_d I f_att spot max(0, N.L), 0 if blocked", "LIGHT-5, docs/lighting.md"},
        {specular, "specular", Kind::color, Of::light, "the specular term",
         "k_s I f_att spot S^n, 0 if blocked", "LIGHT-8, docs/lighting.md"},
        {diffuse_sum, "diffuse", Kind::color, Of::ray, "the sum of the diffuse terms",
         "the sum over the lights", "docs/lighting.md"},
        {specular_sum, "specular", Kind::color, Of::ray, "the sum of the specular terms",
         "the sum over the lights", "docs/lighting.md"},
        {ambient, "ambient", Kind::color, Of::ray, "the ambient term", "k_a I_a, once",
         "LIGHT-2, docs/lighting.md"},
        {emission, "emission", Kind::color, Of::ray, "the emission", "k_e", "docs/lighting.md#finishes"},
        {local, "local", Kind::color, Of::ray, "the surface's own light",
         "ambient + emission + the diffuse and specular terms of all lights", "docs/lighting.md"},
        {children, "children", Kind::flag, Of::ray, "the next mirror or glass ray",
         "while the limit of reflections is not reached", "docs/lighting.md#mirrors-as-a-sum"},
        {weight, "weight", Kind::color, Of::ray, "the weight of the ray",
         "a, the surface's mirror coefficient", "docs/lighting.md#mirrors-as-a-sum"},
        {color, "color", Kind::color, Of::ray, "the color of the ray",
         "(1 - a) local + a color of the mirror ray", "docs/lighting.md#mirrors-as-a-sum"},
        {pixel_color, "color", Kind::color, Of::pixel, "the pixel's color", "that of its camera ray", ""},
        {clamped, "clamped", Kind::color, Of::pixel, "the clamped color", "each channel between 0 and 1", ""},
        {bytes, "bytes", Kind::color, Of::pixel, "the bytes", "255 times the clamped color, rounded",
         "docs/lighting.md#term-by-term"},
    };
    static_assert(std::size(infos) == k_quantities);
    return infos[static_cast<std::size_t>(quantity)];
}

}  // namespace glint
