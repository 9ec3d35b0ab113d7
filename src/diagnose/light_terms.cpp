// SPDX-License-Identifier: Apache-2.0
// The diffuse and the specular term of a light (docs/lighting.md).
#include "diagnose/ray_model.h"

namespace glint {
namespace {

// Whether the terms below are all that the material does with a light.
bool is_plain(const Material& m) {
    return m.brilliance == 1 && m.metallic == 0 && m.phong == Color{} && m.outline == 0 &&
           !m.is_transparent();
}

}  // namespace

// The diffuse or the specular term.
Maybe RayModel::term(Quantity quantity, std::uint32_t index) const {
    const Light& light = model_.scene.lights[index];
    const Conventions& rules = model_.scene.conventions;
    const std::optional<Material> surface = material();
    if (!surface || !model_.is_simple) return std::nullopt;
    if (light.is_area() || !is_plain(*surface)) {
        // As glint has it, where the log agrees so far.
        if (trial_.mistake != TracerMistake::none || !is_reference() || !reference_->hit ||
            shape() != reference_->hit->shape)
            return std::nullopt;
        const Maybe n = value(Quantity::normal);
        if (!n || !agree(unit(*n), ApproxVec(reference_->hit->normal), 1e-4)) return std::nullopt;
        Color sum;
        for (const LightTerms& terms : reference_->hit->lights)
            if (terms.light == index)
                sum = sum + (quantity == Quantity::diffuse ? terms.diffuse : terms.specular);
        ApproxVec result(sum);
        result.x.e = result.y.e = result.z.e = 2e-3;
        return result;
    }
    Maybe n_l = value(Quantity::n_l, index);
    const Maybe blocked = value(Quantity::blocked, index);
    // N.L may be logged after it was clamped.
    if ((is(TracerMistake::diffuse_not_clamped) || is(TracerMistake::diffuse_absolute)) && n_l &&
        n_l->x.v == 0)
        n_l = expected(Quantity::n_l, index);
    const Maybe att = value(Quantity::attenuation, index), cone = value(Quantity::spot, index);
    if (!n_l || !blocked || !att || !cone) return std::nullopt;
    const ApproxVec black;
    const Approx cosine = n_l->x;
    const bool is_faint =
        rules.light_threshold > 0 && !(cosine.v * att->x.v * cone->x.v > rules.light_threshold);
    if (is_faint) return black;
    const Approx faded = att->x * cone->x;
    if (quantity == Quantity::diffuse) {
        if (blocked->x.v != 0 && !is(TracerMistake::diffuse_shadow_ignored)) return black;
        Approx factor =
            is(TracerMistake::diffuse_not_clamped) || !rules.clamp_cosines ? cosine : max(cosine, Approx(0));
        if (is(TracerMistake::diffuse_absolute)) factor = abs(cosine);
        if (is(TracerMistake::diffuse_cosine_missing)) factor = cosine.v > 0 ? 1 : 0;
        if (is(TracerMistake::diffuse_cosine_squared)) factor = factor * factor;
        if (!is(TracerMistake::diffuse_attenuation_missing)) factor = factor * faded;
        ApproxVec result = ApproxVec(Color{1, 1, 1}) * factor;
        if (!is(TracerMistake::diffuse_color_missing)) {
            result = result * ApproxVec(surface->diffuse);
        } else if (trial_.variant == 1) {
            // The coefficient alone, without the color that it multiplies.
            const double color = std::max({surface->color.r, surface->color.g, surface->color.b});
            const double most = std::max({surface->diffuse.r, surface->diffuse.g, surface->diffuse.b});
            result = result * Approx(color > 0 ? most / color : 1);
        }
        if (is(TracerMistake::diffuse_color_squared)) result = result * ApproxVec(surface->diffuse);
        if (!is(TracerMistake::diffuse_light_missing)) result = result * ApproxVec(light.color);
        if (is(TracerMistake::diffuse_divided_by_pi)) result = result / Approx(k_pi);
        if (is(TracerMistake::diffuse_divided_by_lights)) result = result / Approx(lights_with_direction());
        return result;
    }
    if (blocked->x.v != 0 && !is(TracerMistake::specular_shadow_ignored)) return black;
    const Shading shading = model_.scene.settings.shading;
    if (shading != Shading::phong && shading != Shading::blinn_phong) return black;
    const ApproxVec strength = ApproxVec(surface->specular);
    const bool gates = is(TracerMistake::specular_gate_missing) ? false
                       : is(TracerMistake::specular_gate_added) ? true
                                                                : rules.specular_gate;
    if (gates && cosine.v <= 0) {
        // At the edge rounding decides.
        if (std::fabs(cosine.v) > cosine.e) return black;
        return std::nullopt;
    }
    const Maybe power = value(Quantity::power, index);
    if (!power) return std::nullopt;
    Approx factor = power->x;
    if (is(TracerMistake::specular_times_cosine)) factor = factor * max(cosine, Approx(0));
    if (rules.attenuate_highlights && !is(TracerMistake::specular_attenuation_missing))
        factor = factor * faded;
    ApproxVec result = ApproxVec(Color{1, 1, 1}) * factor;
    if (is(TracerMistake::specular_surface_color)) {
        result = result * ApproxVec(surface->diffuse);
    } else if (!is(TracerMistake::specular_color_missing)) {
        result = result * strength;
    } else if (surface->specular == Color{}) {
        return black;
    } else if (trial_.variant == 1) {
        result = result * Approx(std::max({surface->specular.r, surface->specular.g, surface->specular.b}));
    }
    if (surface->tinted_highlight && !is(TracerMistake::specular_light_missing))
        result = result * ApproxVec(light.specular_color);
    return result;
}

int RayModel::lights_with_direction() const {
    int count = 0;
    for (const Light& light : model_.scene.lights)
        if (!light.is_ambient()) ++count;
    return std::max(count, 1);
}

}  // namespace glint
