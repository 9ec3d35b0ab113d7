// SPDX-License-Identifier: Apache-2.0
// The light of a tile's hits: for each light the cosines, the shadow rays of those it may reach, and the
// terms of those it does.
#if defined(GLINT_TRACE_DIRECT_LIGHTING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_DIRECT_LIGHTING_INL_H_
#undef GLINT_TRACE_DIRECT_LIGHTING_INL_H_
#else
#define GLINT_TRACE_DIRECT_LIGHTING_INL_H_
#endif

#include <bit>
#include <cstring>

#include "lighting/phong-inl.h"
#include "trace/material-inl.h"
#include "trace/secondary_rays-inl.h"
#include "trace/tile.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

HWY_INLINE LightingRules lighting_rules(const WorldParts& world) {
    const Conventions& c = world.conventions;
    return {world.settings.shading, c.specular_gate, c.clamp_cosines, c.normalize};
}

HWY_INLINE SurfacePoint<Doubles> surface_at(const TileScratch& s, int h) {
    return {load_triple(s.point, h), load_triple(s.normal, h), load_triple(s.incoming, h),
            load(s.magnitude.data() + h)};
}

/// Whether the light is as strong at any distance: c0 <= 1 alone gives exactly 1.
HWY_INLINE bool has_no_attenuation(const Light& light) {
    const Attenuation& a = light.attenuation;
    return light.kind == LightKind::directional || (a.c0 <= 1 && a.c1 == 0 && a.c2 == 0);
}

/// A light as a vector of hits sees it.
struct LightLanes {
    Triple<Doubles> to_light;
    Doubles distance;  // its length
    Doubles attenuation;
    Cosines<Doubles> cosines;
    LaneMask<double> lit;  // it may add something there
};
HWY_INLINE LightLanes light_at(const WorldParts& world, const Light& light, const LightingRules& rules,
                               const TileScratch& s, int i) {
    const Doubles zero(0);
    const auto adds = [&](Triple<Doubles> a, Triple<Doubles> b)
                          HWY_ATTR { return !(a.x * b.x == zero && a.y * b.y == zero && a.z * b.z == zero); };
    const bool is_point = light.kind == LightKind::point;
    const Triple<Doubles> to_light =
        is_point ? lanes_of(light.position) - load_triple(s.point, i) : lanes_of(light.to_light);
    const Doubles distance = length(to_light);
    const Triple<Doubles> l = rules.normalize ? to_light / distance : to_light;
    const auto c = cosines(load_triple(s.normal, i), l, load_triple(s.to_eye, i), rules);
    // A light in the surface itself has no direction.
    auto lit = first_lanes<double>(s.hits - i) && distance > zero;
    Doubles f_att(1);
    if (!has_no_attenuation(light)) {
        const Attenuation& a = light.attenuation;
        f_att = attenuation(Doubles(a.c0), Doubles(a.c1), Doubles(a.c2), distance);
        lit = lit && f_att > zero;
    }
    const MaterialLanes material(world, s.material.data() + i);
    const auto faces = rules.clamp_cosines ? c.n_l > zero : !(c.n_l == zero);
    lit = lit &&
          ((faces && adds(material.color(k_diffuse), lanes_of(light.color))) ||
           (has_highlight(c, rules) && adds(material.color(k_specular), lanes_of(light.specular_color))));
    return {to_light, distance, f_att, c, lit};
}

/// Writes shadow rays number `at`... of the set lanes.
HWY_INLINE void store_shadow_rays(const WorldParts& world, const Light& light,
                                  const SurfacePoint<Doubles>& surface, Triple<Doubles> to_light,
                                  LaneMask<double> set, TileScratch& s, int at) {
    const ShadowRay<Doubles> ray = shadow_ray(surface, light, to_light, world.conventions);
    if (comes_from_light(light, world.conventions)) {
        store_triple(ray.origin, s.shadow, at);  // of all lanes the same
    } else {
        compress_triple(ray.origin, set, s.shadow, at);
    }
    compress_triple(ray.direction, set, s.shadow + 3, at);
    compress_store(ray.t_min, set, s.shadow[6].data() + at);
    store(Doubles(ray.t_max), s.shadow[7].data() + at);
}

/// The first half of a light: cosines, attenuation, who may be lit, and their shadow rays. Returns how many
/// of those.
inline int make_shadow_rays(const WorldParts& world, const Light& light, TileScratch& s) {
    const LightingRules rules = lighting_rules(world);
    const bool constant = has_no_attenuation(light);
    int rays = 0;
    for (int i = 0; i < s.hits; i += lane_count<double>()) {
        const LightLanes at = light_at(world, light, rules, s, i);
        s.lit[static_cast<std::size_t>(i / lane_count<double>())] =
            static_cast<std::uint8_t>(to_bits(at.lit));
        if (!any(at.lit)) continue;
        if (!constant) store(at.attenuation, s.attenuation.data() + i);
        store(at.cosines.n_l, s.n_l.data() + i);
        store(at.cosines.s, s.s.data() + i);
        if (!world.settings.shadows) continue;
        store_shadow_rays(world, light, surface_at(s, i), at.to_light, at.lit, s, rays);
        rays += count(at.lit);
    }
    return rays;
}

/// Takes from the lit hits those whose shadow ray is occluded.
inline void apply_occlusion(TileScratch& s) {
    const std::uint8_t* occluded = s.occluded.data();
    for (int i = 0; i < s.hits; i += lane_count<double>()) {
        std::uint8_t& lit = s.lit[static_cast<std::size_t>(i / lane_count<double>())];
        const int rays = std::popcount(lit);
        if (rays == 0) continue;
        std::uint64_t flags = 0;  // of all rays of the vector, in the order of memory
        std::memcpy(&flags, occluded, sizeof(flags));
        if (flags << (64 - 8 * rays) == 0) {
            occluded += rays;
            continue;
        }
        std::uint32_t dark = 0;
        for (std::uint32_t bits = lit; bits != 0; bits &= bits - 1) {
            dark |= bits & (0 - bits) & (0u - *occluded++);  // no branch: shadows are not foreseen
        }
        lit = static_cast<std::uint8_t>(lit & ~dark);
    }
}

/// Which hits of a vector have a highlight to be computed.
HWY_INLINE LaneMask<double> highlights(const TileScratch& s, const LightingRules& rules, int i) {
    const auto lit = from_bits<double>(s.lit[static_cast<std::size_t>(i / lane_count<double>())]);
    return lit && has_highlight(Cosines<Doubles>{load(s.n_l.data() + i), load(s.s.data() + i)}, rules);
}

/// S^n of the highlights that are lit, one after the other: few of a vector's hits are, and it costs more
/// than all else.
inline void compute_powers(const WorldParts& world, const LightingRules& rules, TileScratch& s) {
    int powers = 0;
    for (int i = 0; i < s.hits; i += lane_count<double>()) {
        if (s.lit[static_cast<std::size_t>(i / lane_count<double>())] == 0) continue;
        const auto bright = highlights(s, rules, i);
        if (!any(bright)) continue;
        const MaterialLanes material(world, s.material.data() + i);
        compress_store(load(s.s.data() + i), bright, s.power.data() + powers);
        compress_store(material.value(k_shininess), bright, s.shininess.data() + powers);
        powers += count(bright);
    }
    for (int i = 0; i < powers; i += lane_count<double>()) {
        double* at = s.power.data() + i;
        store(highlight_power(load(at), load(s.shininess.data() + i), rules), at);
    }
}

/// k_d I_l,d N·L f_att, or k_s I_l,s S^n f_att.
HWY_INLINE Triple<Doubles> contribution(Triple<Doubles> k, Color light, Doubles term, Doubles attenuation) {
    return (k * lanes_of(light) * term) * attenuation;
}

/// The second half: adds the terms of the hits that are still lit.
inline void add_terms(const WorldParts& world, const Light& light, TileScratch& s) {
    const LightingRules rules = lighting_rules(world);
    const bool constant = has_no_attenuation(light);
    compute_powers(world, rules, s);
    const double* power = s.power.data();
    for (int i = 0; i < s.hits; i += lane_count<double>()) {
        const std::uint32_t bits = s.lit[static_cast<std::size_t>(i / lane_count<double>())];
        if (bits == 0) continue;
        const auto lit = from_bits<double>(bits);
        const MaterialLanes material(world, s.material.data() + i);
        const Doubles f_att = constant ? Doubles(1) : load(s.attenuation.data() + i);
        const auto add = [&](TileScratch::Column* to, Triple<Doubles> more) HWY_ATTR {
            const Triple<Doubles> sum = load_triple(to, i);
            store_triple(select_triple(lit, sum + more, sum), to, i);
        };
        add(s.diffuse, contribution(material.color(k_diffuse), light.color,
                                    diffuse_term(load(s.n_l.data() + i), rules), f_att));
        const auto bright = highlights(s, rules, i);
        if (!any(bright)) continue;
        const Doubles specular = expand_load(power, bright);
        power += count(bright);
        add(s.specular, contribution(material.color(k_specular), light.specular_color, specular, f_att));
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
