// SPDX-License-Identifier: Apache-2.0
// Direct lighting, one light at a time: the surfaces that the light may light, and the diffuse and specular
// terms of those that it lights.
#if defined(GLINT_TRACE_DIRECT_LIGHTING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_DIRECT_LIGHTING_INL_H_
#undef GLINT_TRACE_DIRECT_LIGHTING_INL_H_
#else
#define GLINT_TRACE_DIRECT_LIGHTING_INL_H_
#endif

#include "lighting/area_light-inl.h"
#include "lighting/phong-inl.h"
#include "simd/sample_hash-inl.h"
#include "trace/lighting/faulty_lighting-inl.h"
#include "trace/lighting/shadow_rays-inl.h"
#include "trace/surface/finish-inl.h"
#include "trace/surface/material-inl.h"
#include "trace/surface/surface-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

HWY_INLINE LightingRules lighting_rules(const WorldParts& world) {
    const Conventions& c = world.conventions;
    return {world.settings.shading, c.specular_gate, c.clamp_cosines,        c.normalize,
            c.clamp_attenuation,    c.spot_falloff,  c.attenuate_highlights, c.light_threshold};
}

/// The rules for one light, with what its stages would otherwise have to find out for each vector.
struct LightRules : LightingRules {
    static constexpr bool is_faulty = false;
    bool attenuated = false;  // its strength depends on the distance
    bool is_spot = false;
    bool has_emitter_cosine = false;
    bool from_center = false;      // an area light that shines from its centre
    bool has_shadow_rays = false;  // one for each surface
    bool samples_shadow = false;   // shadow rays to the samples of the area light (area_shadow-inl.h)
    bool is_moved = false;         // at another point for each surface
    Color color, specular_color;   // the light's, times WorldParts::direct
    FinishRules finish;

    /// Whether the light has the same strength everywhere.
    bool is_constant() const { return !attenuated && !is_spot && !has_emitter_cosine && !from_center; }
    /// Whether PlainLightRules are the same.
    bool is_plain() const {
        return !is_spot && !has_emitter_cosine && !from_center && !is_moved && attenuate_highlights &&
               !(light_threshold > 0) && !finish.brilliance && !finish.highlights;
    }
};
/// The rules for a light of the same strength in all directions on surfaces without finishes, which most are:
/// known when the stages are compiled.
struct PlainLightRules : LightingRules {
    static constexpr bool is_faulty = false, is_spot = false, has_emitter_cosine = false, is_moved = false,
                          attenuate_highlights = true, samples_shadow = false;
    static constexpr double light_threshold = 0;
    static constexpr FinishRules finish{};
    bool attenuated, has_shadow_rays;
    Color color, specular_color;

    explicit PlainLightRules(const LightRules& rules)
        : LightingRules(rules),
          attenuated(rules.attenuated),
          has_shadow_rays(rules.has_shadow_rays),
          color(rules.color),
          specular_color(rules.specular_color) {}
    bool is_constant() const { return !attenuated; }
};
/// The rules in a world with a fault.
struct FaultyLightRules : LightRules {
    static constexpr bool is_faulty = true;
};
HWY_INLINE LightRules light_rules(const WorldParts& world, const PreparedLight& light) {
    const Conventions& c = world.conventions;
    LightRules rules;
    static_cast<LightingRules&>(rules) = lighting_rules(world);
    rules.attenuated =
        light.falls_off() || (!c.clamp_attenuation && light.has_attenuation() && light.attenuation.c0 != 1);
    rules.is_spot = light.is_spot();
    rules.has_emitter_cosine = light.has_emitter_cosine();
    rules.from_center = light.is_area() && light.sample < 0;
    const bool shadows = world.settings.shadows && light.casts_shadows;
    rules.has_shadow_rays = shadows && !rules.from_center;
    rules.samples_shadow = shadows && rules.from_center;
    rules.is_moved = light.sample >= 0 && light.moves_samples();
    rules.color = light.color * world.direct;
    rules.specular_color = light.specular_color * world.direct;
    rules.finish = finish_rules(world);
    return rules;
}

/// The spot's factor at the end of a vector of this length from a surface to the light.
HWY_INLINE Doubles spot_at(const PreparedLight& light, Vector3<Doubles> to_light, Doubles distance,
                           const LightingRules& rules) {
    const Doubles cosine = -dot(to_light, lanes_of(light.unit_axis)) / distance;
    return spot_factor(cosine, light.spot_cone, rules.spot_falloff);
}

/// The factor of a one-sided area light: the cosine off its normal, 0 behind it.
HWY_INLINE Doubles emitter_cosine(const PreparedLight& light, Vector3<Doubles> to_light, Doubles distance) {
    return max(-dot(to_light, lanes_of(light.unit_axis)) / distance, Doubles(0));
}

/// The rule for the places of an area light's samples.
HWY_INLINE AreaShading placing_rule(const WorldParts& world, const AreaGrid& area) {
    return area.is_parallelogram ? world.conventions.area_shading : AreaShading::samples;
}
/// A sample of an area light whose samples are not moved.
inline Vec3 fixed_sample(const WorldParts& world, const AreaGrid& area, int sample) {
    const AreaShading rule = placing_rule(world, area);
    const Vector3<double> at =
        area_point(area, sample_coordinate(sample % area.columns, area.columns, 0.5, rule),
                   sample_coordinate(sample / area.columns, area.rows, 0.5, rule), Vector3<double>{0, 0, 0});
    return {at.x, at.y, at.z};
}
/// The place of a moved sample in its cell, from 0 to 1, for a vector of surfaces.
inline void hash_place(const PreparedLight& light, int sample, const SurfaceBatch& surfaces, int i,
                       Doubles& u, Doubles& v) {
    const Words of_light = hash_with(to_words(load(surfaces.hash.data() + i)),
                                     Words(purpose_word(SamplePurpose::light, light.index)));
    const Words of_sample = hash_with(of_light, Words(static_cast<std::uint32_t>(sample)));
    u = unit_number(hash_with(of_sample, Words(0u)));
    v = unit_number(hash_with(of_sample, Words(1u)));
}
/// A sample whose place differs from surface to surface (Light::moves_samples), for a vector of them.
inline Vector3<Doubles> moved_sample(const WorldParts& world, const PreparedLight& light, int sample,
                                     const SurfaceBatch& surfaces, int i) {
    const AreaGrid& area = light.area;
    const AreaShading rule = placing_rule(world, area);
    Doubles u(0.5), v(0.5);
    if (area.jitter) hash_place(light, sample, surfaces, i, u, v);
    return area_point(area, sample_coordinate(sample % area.columns, area.columns, u, rule),
                      sample_coordinate(sample / area.columns, area.rows, v, rule),
                      load_vector3(surfaces.point, i));
}
/// The values of a light at a vector of surfaces.
struct LightLanes {
    Vector3<Doubles> to_light;
    Doubles distance;     // the length of to_light
    Doubles attenuation;  // by the distance
    Doubles spot;         // by the direction: of a spot or a one-sided area light; else 1
    Cosines<Doubles> cosines;
    Doubles phong_s;       // R·V of the second highlight; 0 without one
    LaneMask<double> lit;  // surfaces where it may add light

    /// The factor of both terms.
    HWY_INLINE Doubles strength() const { return attenuation * spot; }
};
template <class Rules>
HWY_INLINE LightLanes light_at(const WorldParts& world, const PreparedLight& light, const Rules& rules,
                               const SurfaceBatch& surfaces, int i) {
    const Doubles zero(0);
    Vector3<Doubles> to_light = lanes_of(light.to_light);
    if (rules.is_moved) {
        to_light = moved_sample(world, light, light.sample, surfaces, i) - load_vector3(surfaces.point, i);
    } else if (light.has_position()) {
        to_light = lanes_of(light.position) - load_vector3(surfaces.point, i);
    }
    const Doubles distance = length(to_light);
    const Vector3<Doubles> l = rules.normalize ? to_light / distance : to_light;
    const Vector3<Doubles> normal = load_vector3(surfaces.normal, i),
                           to_eye = load_vector3(surfaces.to_eye, i);
    auto c = cosines(normal, l, to_eye, rules);
    if constexpr (Rules::is_faulty) c = faulty_cosines(world, surfaces, i, to_light, l, rules, c);
    // A light at the surface point has no direction.
    auto lit = first_lanes<double>(surfaces.count - i) && distance > zero;
    Doubles f_att(1);
    if (rules.attenuated) {
        const Attenuation& a = light.attenuation;
        f_att = attenuation(Doubles(a.c0), Doubles(a.c1), Doubles(a.c2), distance,
                            Doubles(rules.clamp_attenuation ? 1 : 1e30));
        if (light.fades())
            f_att = f_att * fading(Doubles(light.fade_distance), Doubles(light.fade_power), distance);
        lit = lit && f_att > zero;
    }
    Doubles spot(1);
    if (rules.is_spot) {
        spot = spot_at(light, to_light, distance, rules);
        lit = lit && spot > zero;
    } else if (rules.has_emitter_cosine) {
        spot = emitter_cosine(light, to_light, distance);
        lit = lit && spot > zero;
    }
    const MaterialLanes material(surfaces, i);
    const auto faces = rules.clamp_cosines ? c.n_l > zero : !(c.n_l == zero);
    auto adds = faces && is_colored(material.color(k_diffuse), lanes_of(light.color));
    Doubles phong_s = zero;
    if (!rules.finish.highlights) {
        adds = adds || (has_highlight(c, rules) &&
                        is_colored(material.color(k_specular), lanes_of(light.specular_color)));
    } else {
        if (rules.finish.phong) phong_s = dot(mirrored(l, normal), to_eye);
        adds =
            adds || finished_highlight_adds(world, material, light, rules.finish, c, {c.n_l, phong_s}, rules);
    }
    lit = lit && adds;
    if (rules.light_threshold > 0) lit = lit && c.n_l * (f_att * spot) > Doubles(rules.light_threshold);
    return {to_light, distance, f_att, spot, c, phong_s, lit};
}

/// The lit bits of the vector of surfaces at index i.
HWY_INLINE std::uint8_t lit_bits(const LightSampleBatch& samples, int i) {
    return samples.lit[static_cast<std::size_t>(i / lane_count<double>())];
}

/// Sets the sums over the lights to 0.
inline void clear_radiance(const SurfaceBatch& surfaces, RadianceBatch& radiance) {
    for (int c = 0; c < 3; ++c) {
        std::fill_n(radiance.diffuse[c].begin(), surfaces.count, 0.0);
        std::fill_n(radiance.specular[c].begin(), surfaces.count, 0.0);
    }
}

template <class Rules>
HWY_INLINE ShadowRay<Doubles> shadow_ray_at(const WorldParts& world, const PreparedLight& light,
                                            const Rules& rules, const SurfacePoint<Doubles>& surface,
                                            Vector3<Doubles> to_light) {
    if (rules.is_moved)
        return shadow_ray_from(surface, surface.point + to_light, to_light, world.conventions);
    return shadow_ray(surface, light, to_light, world.conventions);
}

template <class Rules>
inline void sample_light_by(const Rules& rules, const WorldParts& world, const PreparedLight& light,
                            const SurfaceBatch& surfaces, LightSampleBatch& samples,
                            ShadowRayBatch& shadow_rays) {
    const bool constant = rules.is_constant();
    int rays = 0;
    for (int i = 0; i < surfaces.count; i += lane_count<double>()) {
        const LightLanes at = light_at(world, light, rules, surfaces, i);
        samples.lit[static_cast<std::size_t>(i / lane_count<double>())] =
            static_cast<std::uint8_t>(to_bits(at.lit));
        if (!any(at.lit)) continue;
        if (!constant) store(at.strength(), samples.strength.data() + i);
        store(at.cosines.n_l, samples.n_l.data() + i);
        store(at.cosines.s, samples.s.data() + i);
        if (rules.finish.phong) store(at.phong_s, samples.phong_s.data() + i);
        if (!rules.has_shadow_rays) continue;
        auto ray = shadow_ray_at(world, light, rules, surface_at(surfaces, i), at.to_light);
        if constexpr (Rules::is_faulty) ray = faulty_shadow_ray(world, light, at.distance, ray);
        store_shadow_rays(ray, comes_from_light(light, world.conventions) && !rules.is_moved, at.lit,
                          shadow_rays, rays);
        rays += count(at.lit);
    }
    shadow_rays.count = rays;
    shadow_rays.from_light = comes_from_light(light, world.conventions);
}

/// sample_light() and add_light() of a world with a fault; compiled separately, in trace/faults.cpp.
void sample_light_with_fault(const WorldParts& world, const PreparedLight& light, const LightRules& rules,
                             const SurfaceBatch& surfaces, LightSampleBatch& samples,
                             ShadowRayBatch& shadow_rays);
void add_light_with_fault(const WorldParts& world, const PreparedLight& light, const LightRules& rules,
                          const SurfaceBatch& surfaces, const LightSampleBatch& samples,
                          const HighlightBatch& highlights, RadianceBatch& radiance);

/// Samples a light at all surfaces: its cosines, its attenuation, the surfaces that it may light, and, if
/// shadows are on, their shadow rays.
inline void sample_light(const WorldParts& world, const PreparedLight& light, const LightRules& rules,
                         const SurfaceBatch& surfaces, LightSampleBatch& samples,
                         ShadowRayBatch& shadow_rays) {
    if (world.fault != TracerFault::none) {
        sample_light_with_fault(world, light, rules, surfaces, samples, shadow_rays);
    } else if (rules.is_plain()) {
        sample_light_by(PlainLightRules(rules), world, light, surfaces, samples, shadow_rays);
    } else {
        sample_light_by(rules, world, light, surfaces, samples, shadow_rays);
    }
}

/// The surfaces of a vector whose highlight has to be computed.
HWY_INLINE LaneMask<double> highlights_at(const LightSampleBatch& samples, const LightingRules& rules,
                                          int i) {
    const Cosines<Doubles> cosines{load(samples.n_l.data() + i), load(samples.s.data() + i)};
    return from_bits<double>(lit_bits(samples, i)) && has_highlight(cosines, rules);
}

/// Computes S^n for the surfaces that are lit and have a highlight. They are compacted first, because few
/// surfaces of a vector have one and the power costs more than all other terms.
inline void compute_highlights(const LightingRules& rules, const SurfaceBatch& surfaces,
                               const LightSampleBatch& samples, HighlightBatch& highlights) {
    int powers = 0;
    for (int i = 0; i < surfaces.count; i += lane_count<double>()) {
        if (lit_bits(samples, i) == 0) continue;
        const auto bright = highlights_at(samples, rules, i);
        if (!any(bright)) continue;
        const MaterialLanes material(surfaces, i);
        compress_store(load(samples.s.data() + i), bright, highlights.power.data() + powers);
        compress_store(material.value(k_shininess), bright, highlights.shininess.data() + powers);
        powers += count(bright);
    }
    for (int i = 0; i < powers; i += lane_count<double>()) {
        double* at = highlights.power.data() + i;
        store(highlight_power(load(at), load(highlights.shininess.data() + i), rules), at);
    }
}

/// k_d I_l,d (N·L)^brilliance f_att. strength: f_att, times the factor by the
/// direction and the visible part of an area light.
template <class Rules>
HWY_INLINE Vector3<Doubles> diffuse_of(const MaterialLanes& material, const Rules& rules, Doubles n_l,
                                       Doubles strength) {
    return contribution(material.color(k_diffuse), lanes_of(rules.color),
                        diffuse_factor(material, rules.finish, n_l, rules), strength);
}

/// k_s I_l,s S^n f_att, with the second highlight and the tint of metals. power: S^n, or 0.
template <class Rules>
HWY_INLINE Vector3<Doubles> specular_of(const WorldParts& world, const MaterialLanes& material,
                                        const Light& light, const Rules& rules, Doubles power,
                                        Cosines<Doubles> phong, Doubles strength) {
    const Doubles seen = rules.attenuate_highlights ? strength : Doubles(1);
    if (!rules.finish.highlights)
        return contribution(material.color(k_specular), lanes_of(rules.specular_color), power, seen);
    return finished_highlight(world, material, light, rules.finish, power, phong, seen, rules);
}

template <class Rules>
inline void add_light_by(const Rules& rules, const WorldParts& world, const PreparedLight& light,
                         const SurfaceBatch& surfaces, const LightSampleBatch& samples,
                         const HighlightBatch& highlights, RadianceBatch& radiance) {
    const bool constant = rules.is_constant();
    const bool filtered = world.colors_shadows() && (rules.has_shadow_rays || rules.samples_shadow);
    const double* power = highlights.power.data();
    for (int i = 0; i < surfaces.count; i += lane_count<double>()) {
        const std::uint32_t bits = lit_bits(samples, i);
        if (bits == 0) continue;
        const auto lit = from_bits<double>(bits);
        const MaterialLanes material(surfaces, i);
        const Doubles strength = constant ? Doubles(1) : load(samples.strength.data() + i);
        const auto add = [&](BatchColumn<double>* to, Vector3<Doubles> more, bool colored) HWY_ATTR {
            if (colored) more = more * load_vector3(samples.filter, i);
            const Vector3<Doubles> sum = load_vector3(to, i);
            store_vector3(select_vector3(lit, sum + more, sum), to, i);
        };
        const Doubles n_l = load(samples.n_l.data() + i);
        Doubles diffuse_n_l = n_l;
        if constexpr (Rules::is_faulty) diffuse_n_l = faulty_diffuse(world, material, n_l);
        add(radiance.diffuse, diffuse_of(material, rules, diffuse_n_l, strength), filtered);
        const auto bright = highlights_at(samples, rules, i);
        if (!any(bright) && !rules.finish.phong) continue;
        Doubles highlight = expand_load(power, bright);
        if constexpr (Rules::is_faulty) highlight = faulty_power(world, n_l, highlight);
        power += count(bright);
        const Doubles phong_s = rules.finish.phong ? load(samples.phong_s.data() + i) : Doubles(0);
        add(radiance.specular,
            specular_of(world, material, light, rules, highlight, {n_l, phong_s}, strength),
            filtered && rules.attenuate_highlights);
    }
}

/// Adds the light's terms to the surfaces that are lit.
inline void add_light(const WorldParts& world, const PreparedLight& light, const LightRules& rules,
                      const SurfaceBatch& surfaces, const LightSampleBatch& samples,
                      const HighlightBatch& highlights, RadianceBatch& radiance) {
    if (world.fault != TracerFault::none) {
        add_light_with_fault(world, light, rules, surfaces, samples, highlights, radiance);
    } else if (rules.is_plain()) {
        add_light_by(PlainLightRules(rules), world, light, surfaces, samples, highlights, radiance);
    } else {
        add_light_by(rules, world, light, surfaces, samples, highlights, radiance);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
