// SPDX-License-Identifier: Apache-2.0
// The sums: of a surface's light, and of a ray with those that start at its hit.
#include <algorithm>
#include <array>

#include "diagnose/ray_model.h"
#include "math/elementary.h"

namespace glint {
namespace {

// The light that a ray of an explanation and those after it add to the pixel.
Color light_of_subtree(const Explanation& e, std::size_t ray) {
    Color sum;
    std::vector<char> inside(e.rays.size(), 0);
    inside[ray] = 1;
    for (std::size_t i = ray; i < e.rays.size(); ++i) {
        const ExplainedRay& one = e.rays[i];
        if (i != ray && (one.parent < 0 || !inside[static_cast<std::size_t>(one.parent)])) continue;
        inside[i] = 1;
        sum = sum + (one.hit ? one.hit->own_light() : one.background) + one.fog;
    }
    return sum;
}

Maybe divided(Color a, Color b) {
    if (!(b.r > 0 && b.g > 0 && b.b > 0)) return std::nullopt;
    return ApproxVec(Color{a.r / b.r, a.g / b.g, a.b / b.b});
}

}  // namespace

Maybe RayModel::sum(Quantity quantity) const {
    switch (quantity) {
        case Quantity::weight:
            return weight();
        case Quantity::color:
            return color();
        default:
            break;
    }
    const std::optional<Material> surface = material();
    if (!surface) return std::nullopt;
    Color ambient_light;
    for (const Light& light : model_.scene.lights)
        if (light.is_ambient()) ambient_light = ambient_light + light.color;
    switch (quantity) {
        case Quantity::ambient:
            if (is(TracerMistake::ambient_missing)) return ApproxVec(Color{});
            if (is(TracerMistake::ambient_without_light)) return ApproxVec(surface->ambient);
            if (is(TracerMistake::ambient_without_surface)) return ApproxVec(ambient_light);
            return ApproxVec(is(TracerMistake::ambient_is_diffuse) ? surface->diffuse : surface->ambient) *
                   ApproxVec(ambient_light);
        case Quantity::emission:
            return ApproxVec(surface->emission);
        case Quantity::diffuse_sum:
        case Quantity::specular_sum: {
            ApproxVec all;
            for (std::uint32_t i = 0; i < model_.scene.lights.size(); ++i) {
                if (model_.scene.lights[i].is_ambient()) continue;
                const Maybe one =
                    value(quantity == Quantity::diffuse_sum ? Quantity::diffuse : Quantity::specular, i);
                if (!one) return std::nullopt;
                all = all + *one;
            }
            return all;
        }
        case Quantity::local:
            return local();
        default:
            return std::nullopt;
    }
}

Maybe RayModel::local() const {
    const Maybe ambient = value(Quantity::ambient), emission = value(Quantity::emission);
    if (!ambient || !emission) return std::nullopt;
    const int count = lights_with_direction();
    if (is(TracerMistake::local_last_light) || is(TracerMistake::local_first_light)) {
        std::optional<std::uint32_t> chosen;
        for (std::uint32_t i = 0; i < model_.scene.lights.size(); ++i) {
            if (model_.scene.lights[i].is_ambient()) continue;
            if (!chosen || is(TracerMistake::local_last_light)) chosen = i;
        }
        if (!chosen) return std::nullopt;
        const Maybe d = value(Quantity::diffuse, *chosen), s = value(Quantity::specular, *chosen);
        return d && s ? Maybe(*ambient + *emission + *d + *s) : std::nullopt;
    }
    if (is(TracerMistake::local_logged_only)) {
        ApproxVec all = *ambient + *emission;
        for (std::uint32_t i = 0; i < model_.scene.lights.size(); ++i) {
            if (logged_light(i) == nullptr) continue;
            const Maybe d = value(Quantity::diffuse, i), s = value(Quantity::specular, i);
            if (!d || !s) return std::nullopt;
            all = all + *d + *s;
        }
        return ray_.lights.empty() ? std::nullopt : Maybe(all);
    }
    const Maybe diffuse = value(Quantity::diffuse_sum), specular = value(Quantity::specular_sum);
    if (!diffuse || !specular) return std::nullopt;
    ApproxVec all;
    if (!is(TracerMistake::local_without_diffuse)) all = all + *diffuse;
    if (!is(TracerMistake::local_without_specular)) all = all + *specular;
    if (is(TracerMistake::local_mean)) all = all / Approx(count);
    if (!is(TracerMistake::local_without_ambient))
        all = all +
              *ambient * Approx(is(TracerMistake::ambient_per_light)
                                    ? std::array{count, count + 1,
                                                 static_cast<int>(
                                                     model_.scene.lights
                                                         .size())}[static_cast<std::size_t>(trial_.variant)]
                                    : 1);
    if (!is(TracerMistake::local_without_emission)) all = all + *emission;
    if (is(TracerMistake::local_black_in_shadow)) {
        for (std::uint32_t i = 0; i < model_.scene.lights.size(); ++i) {
            const Maybe blocked =
                model_.scene.lights[i].is_ambient() ? std::nullopt : value(Quantity::blocked, i);
            if (blocked && blocked->x.v != 0) return ApproxVec(Color{});
        }
    }
    return is(TracerMistake::local_clamped) ? clamped(all) : all;
}

std::optional<bool> RayModel::has_child(LoggedRayKind kind) const {
    const std::optional<Material> surface = material();
    if (!surface || surface->is_transparent() || surface->has_angled_mirror()) return std::nullopt;
    int limit = model_.scene.settings.reflections;
    if (is(TracerMistake::depth_one_more)) limit += trial_.variant < 3 ? 1 + trial_.variant : 1000;
    if (is(TracerMistake::depth_one_less)) --limit;
    if (is(TracerMistake::depth_none)) limit = 0;
    const bool may = ray_.generation < limit;
    if (kind == LoggedRayKind::glass) {
        if (!may || !(surface->transmission > 0)) return false;
        if (is(TracerMistake::total_reflection_ignored)) return true;
        const std::optional<bool> refracts = is_refracted();
        return model_.scene.conventions.min_weight > 0 && refracts != false ? std::nullopt : refracts;
    }
    if (surface->transmission > 0) return std::nullopt;  // by Fresnel's rule
    if (may && surface->mirror > 0 && model_.scene.conventions.min_weight > 0) return std::nullopt;
    return may && surface->mirror > 0;
}

Maybe RayModel::weight() const {
    const Maybe own = relative_weight();
    if (!model_.rules.weight_is_product || !own || !parent_->parent_) return own;
    const Maybe before = parent_->value(Quantity::weight);
    return before ? Maybe(*own * *before) : std::nullopt;
}

Maybe RayModel::relative_weight() const {
    if (!parent_) return std::nullopt;
    const std::optional<Material> surface = parent_->material();
    if (!surface || surface->has_angled_mirror()) return std::nullopt;
    if (ray_.kind == LoggedRayKind::mirror && surface->transmission == 0 && surface->mirror_metallic == 0) {
        if (is(TracerMistake::weight_missing)) return ApproxVec(Color{1, 1, 1});
        if (is(TracerMistake::weight_untinted)) return ApproxVec(Color{1, 1, 1}) * Approx(surface->mirror);
        const double a = is(TracerMistake::weight_complement) ? 1 - surface->mirror : surface->mirror;
        return ApproxVec(surface->mirror_tint) * Approx(a);
    }
    if (!is_reference() || parent_->reference()->hit == std::nullopt) return std::nullopt;
    Maybe weight = divided(reference_->weight, parent_->reference()->hit->weight);
    // Fresnel's part changes much with the angle.
    const ExplainedHit& hit = *parent_->reference()->hit;
    if (weight && ray_.kind == LoggedRayKind::glass) {
        const ApproxVec tint(surface->transmission_tint);
        if (is(TracerMistake::fresnel_missing) && hit.fresnel < 1) weight = *weight / Approx(1 - hit.fresnel);
        if (is(TracerMistake::glass_tint_missing))
            weight =
                hit.behind ? weight : ApproxVec(weight->x / tint.x, weight->y / tint.y, weight->z / tint.z);
        if (is(TracerMistake::glass_tint_twice)) weight = hit.behind ? *weight * tint : *weight;
    }
    if (weight) weight->x.e = weight->y.e = weight->z.e = 1e-3;
    return weight;
}

// The factor of the surface's own light, where the model knows it.
std::optional<double> RayModel::local_share() const {
    const std::optional<Material> surface = material();
    if (!surface || surface->is_transparent() || surface->has_angled_mirror() || surface->transmission > 0) {
        if (!is_reference() || !reference_->hit || shape() != reference_->hit->shape) return std::nullopt;
        if (is(TracerMistake::glass_own_light) && surface && surface->transmission > 0 &&
            surface->transmission < 1)
            return reference_->hit->local_share / (1 - surface->transmission);
        if (trial_.mistake != TracerMistake::none && info_of(trial_.mistake).at == Quantity::color)
            return std::nullopt;
        return reference_->hit->local_share;
    }
    const Conventions& rules = model_.scene.conventions;
    bool is_blend = rules.mirror == MirrorRule::blend;
    if (is(TracerMistake::mirror_added)) is_blend = false;
    if (is(TracerMistake::mirror_blended)) is_blend = true;
    if (is(TracerMistake::mirror_without_local) && surface->mirror > 0) return 0;
    bool keeps = rules.limit == LimitRule::keep;
    if (is(TracerMistake::limit_dropped)) keeps = false;
    if (is(TracerMistake::limit_kept)) keeps = true;
    if (ray_.generation >= model_.scene.settings.reflections && keeps) return 1;
    if (is(TracerMistake::mirror_swapped) && surface->mirror > 0) return surface->mirror;
    return is_blend ? 1 - surface->mirror : 1;
}

// The sum over a chain of mirrors, in which each weight is that of the last mirror alone.
Maybe RayModel::chain_color() const {
    if (ray_.generation != 0) return std::nullopt;
    ApproxVec all;
    Maybe weight = ApproxVec(Color{1, 1, 1});
    std::int32_t at = ray_index_;
    while (at >= 0) {
        const RayModel one(model_, pixel_index_, at, trial_);
        if (at != ray_index_) weight = one.relative_weight();
        const std::optional<std::uint32_t> of = one.shape();
        if (!of || !weight) return std::nullopt;
        if (*of == k_none) {
            const Maybe background = one.color();
            return background ? Maybe(all + *weight * *background) : std::nullopt;
        }
        const Maybe own = one.value(Quantity::local);
        const std::optional<double> share = one.local_share();
        if (!own || !share) return std::nullopt;
        all = all + *weight * *own * Approx(*share);
        const std::int32_t parent = at;
        at = -1;
        for (std::size_t i = static_cast<std::size_t>(parent) + 1; i < pixel_.rays.size(); ++i)
            if (pixel_.rays[i].parent == parent) at = static_cast<std::int32_t>(i);
    }
    return all;
}

Maybe RayModel::color() const {
    if (!model_.is_simple) return std::nullopt;
    const std::optional<std::uint32_t> of = shape();
    if (!of) return std::nullopt;
    const Color background = model_.scene.background;
    if (*of == k_none) {
        if (model_.scene.gradient) return std::nullopt;
        const bool is_black =
            ray_.kind == LoggedRayKind::mirror && model_.scene.conventions.mirror_miss == MissRule::black;
        return ApproxVec(is_black ? Color{} : background);
    }
    const Maybe own = value(Quantity::local);
    const std::optional<double> share = local_share();
    // Transparent surfaces have another share for highlights.
    if (!own || !share || material()->is_transparent()) return std::nullopt;
    if (is(TracerMistake::weight_not_multiplied)) return chain_color();
    const bool clamps = is(TracerMistake::color_clamped_before);
    ApproxVec all = (clamps ? clamped(*own) : *own) * Approx(*share);
    bool has_mirror = false, has_glass = false;
    for (std::size_t i = static_cast<std::size_t>(ray_index_) + 1; i < pixel_.rays.size(); ++i) {
        if (pixel_.rays[i].parent != ray_index_) continue;
        (pixel_.rays[i].kind == LoggedRayKind::mirror ? has_mirror : has_glass) = true;
        const RayModel child(model_, pixel_index_, static_cast<std::int32_t>(i), trial_);
        const Maybe color = child.value(Quantity::color);
        Maybe weight =
            model_.rules.weight_is_product ? child.relative_weight() : child.value(Quantity::weight);
        if (!color || !weight) return std::nullopt;
        if (is(TracerMistake::mirror_swapped)) weight = ApproxVec(Color{1, 1, 1}) - *weight;
        if (is(TracerMistake::mirror_unweighted)) weight = ApproxVec(Color{1, 1, 1});
        if (!is(TracerMistake::mirror_color_missing))
            all = all + *weight * (clamps ? clamped(*color) : *color);
    }
    // Rays that the log does not have.
    const std::optional<Material> surface = material();
    const auto add_missing = [&](const ExplainedSecondaryRay& missing) {
        if (missing.state != SecondaryRayState::traced) return true;
        const Explanation& e = *model_.references[pixel_index_].explanation;
        const Maybe light =
            divided(light_of_subtree(e, static_cast<std::size_t>(missing.ray)), reference_->weight);
        if (!light) return false;
        if (!is(TracerMistake::mirror_color_missing)) {
            ApproxVec added = *light;
            added.x.e = added.y.e = added.z.e = 1e-3;
            all = all + added;
        }
        return true;
    };
    const bool may_reflect = surface->mirror > 0 || surface->has_angled_mirror() || surface->transmission > 0;
    if (may_reflect && (!has_mirror || !has_glass) && ray_.generation < model_.scene.settings.reflections) {
        const bool knows = is_reference() && reference_->hit && shape() == reference_->hit->shape &&
                           !is(TracerMistake::mirror_unweighted);
        const bool has_absorption = model_.scene.conventions.beer > 0;
        if (!knows || has_absorption)
            return has_mirror && surface->transmission == 0 ? Maybe(all) : std::nullopt;
        if (!has_mirror && !add_missing(reference_->hit->reflected)) return std::nullopt;
        if (!has_glass && !add_missing(reference_->hit->transmitted)) return std::nullopt;
    }
    if (is(TracerMistake::color_scaled)) {
        const Approx most = max(max(all.x, all.y), all.z);
        if (most.v > 1) return all / most;
    }
    return all;
}

}  // namespace glint
