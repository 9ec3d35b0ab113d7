// The light of a tile's hits: for each light the cosines, the shadow rays of those it may reach, and the
// terms of those it does.
#if defined(GLINT_TRACE_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_LIGHT_INL_H_
#undef GLINT_TRACE_LIGHT_INL_H_
#else
#define GLINT_TRACE_LIGHT_INL_H_
#endif

#include <bit>
#include <cstring>

#include "geometry/leave-inl.h"
#include "lighting/phong-inl.h"
#include "trace/hit_declarations-inl.h"
#include "trace/material-inl.h"
#include "trace/tile.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

HWY_INLINE LightingRules lighting_rules(const World& world) {
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

/// Writes shadow rays number `at`... of the set lanes. A point light's ray is traced from the light to the
/// surface, so that a light's rays share their origin.
HWY_INLINE void put_shadow_rays(const World& world, const Light& light, const SurfacePoint<Doubles>& surface,
                                Triple<Doubles> to_light, LaneMask<double> set, TileScratch& s, int at) {
    const Conventions& c = world.conventions;
    TileScratch::Column *origin = s.shadow, *direction = s.shadow + 3;
    double *t_min = s.shadow[6].data() + at, *t_max = s.shadow[7].data() + at;
    const Triple<Doubles> start = leave(surface, to_light, c.offset, c.epsilon);
    if (light.kind == LightKind::directional || !c.shadow_stops_at_light) {
        compress_triple(start, set, origin, at);
        compress_triple(to_light, set, direction, at);
        store(Doubles(leave_t_min(c.offset, c.epsilon)), t_min);
        store(Doubles(k_infinity), t_max);
        return;
    }
    const Triple<Doubles> from = lanes_of(light.position), way = start - from;
    store_triple(from, origin, at);
    compress_triple(way, set, direction, at);
    // Its distance is compared with the light's from P itself: it sees epsilon past the light.
    const Doubles least = c.offset == Offset::direction ? Doubles(-c.epsilon) / length(way) : Doubles(0);
    compress_store(least, set, t_min);
    store(Doubles(c.offset == Offset::ray ? 1 - c.epsilon : 1.0), t_max);
}

/// The first half of a light: cosines, attenuation, who may be lit, and their shadow rays. Returns how many
/// of those.
inline int reach_hits(const World& world, const Light& light, TileScratch& s) {
    const LightingRules rules = lighting_rules(world);
    const Triple<Doubles> diffuse_light = lanes_of(light.color),
                          specular_light = lanes_of(light.specular_color);
    const Triple<Doubles> position = lanes_of(light.position), towards = lanes_of(light.to_light);
    const bool is_point = light.kind == LightKind::point, constant = has_no_attenuation(light);
    const Doubles c0(light.attenuation.c0), c1(light.attenuation.c1), c2(light.attenuation.c2);
    const Doubles zero(0);
    const auto adds = [&](Triple<Doubles> a, Triple<Doubles> b)
                          HWY_ATTR { return !(a.x * b.x == zero && a.y * b.y == zero && a.z * b.z == zero); };
    int rays = 0;
    for (int i = 0; i < s.hits; i += lane_count<double>()) {
        const SurfacePoint<Doubles> surface = surface_at(s, i);
        const Triple<Doubles> to_light = is_point ? position - surface.point : towards;
        const Doubles distance = length(to_light);
        const Triple<Doubles> l = rules.normalize ? to_light / distance : to_light;
        const auto c = cosines(surface.normal, l, load_triple(s.to_eye, i), rules);
        // A light in the surface itself has no direction.
        auto lit = first_lanes<double>(s.hits - i) && distance > zero;
        if (!constant) {
            const Doubles f_att = attenuation(c0, c1, c2, distance);
            store(f_att, s.attenuation.data() + i);
            lit = lit && f_att > zero;
        }
        const MaterialLanes material(world, s.material.data() + i);
        const auto faces = rules.clamp_cosines ? c.n_l > zero : !(c.n_l == zero);
        lit = lit && ((faces && adds(material.color(k_diffuse), diffuse_light)) ||
                      (has_highlight(c, rules) && adds(material.color(k_specular), specular_light)));
        s.lit[static_cast<std::size_t>(i / lane_count<double>())] = static_cast<std::uint8_t>(to_bits(lit));
        if (!any(lit)) continue;
        store(c.n_l, s.n_l.data() + i);
        store(c.s, s.s.data() + i);
        if (!world.settings.shadows) continue;
        put_shadow_rays(world, light, surface, to_light, lit, s, rays);
        rays += count(lit);
    }
    return rays;
}

/// Takes from the lit hits those whose shadow ray is occluded.
inline void take_shadows(TileScratch& s) {
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
inline void compute_powers(const World& world, const LightingRules& rules, TileScratch& s) {
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

/// The second half: adds the terms of the hits that are still lit.
inline void add_terms(const World& world, const Light& light, TileScratch& s) {
    const LightingRules rules = lighting_rules(world);
    const Triple<Doubles> diffuse_light = lanes_of(light.color),
                          specular_light = lanes_of(light.specular_color);
    const bool constant = has_no_attenuation(light);
    compute_powers(world, rules, s);
    const double* power = s.power.data();
    for (int i = 0; i < s.hits; i += lane_count<double>()) {
        const std::uint32_t bits = s.lit[static_cast<std::size_t>(i / lane_count<double>())];
        if (bits == 0) continue;
        const auto lit = from_bits<double>(bits);
        const MaterialLanes material(world, s.material.data() + i);
        const Doubles f_att = constant ? Doubles(1) : load(s.attenuation.data() + i);
        const auto add = [&](TileScratch::Column* to, Triple<Doubles> k, Triple<Doubles> color, Doubles term)
                             HWY_ATTR {
                                 const Triple<Doubles> sum = load_triple(to, i);
                                 const Triple<Doubles> more = (k * color * term) * f_att;
                                 store_triple(select_triple(lit, sum + more, sum), to, i);
                             };
        add(s.diffuse, material.color(k_diffuse), diffuse_light, diffuse_term(load(s.n_l.data() + i), rules));
        const auto bright = highlights(s, rules, i);
        if (!any(bright)) continue;
        const Doubles specular = expand_load(power, bright);
        power += count(bright);
        add(s.specular, material.color(k_specular), specular_light, specular);
    }
}

/// Sums diffuse and specular of all hits over the lights, in the scene's order.
inline void light_hits(const World& world, TileScratch& s) {
    for (int c = 0; c < 3; ++c) {
        std::fill_n(s.diffuse[c].begin(), s.hits, 0.0);
        std::fill_n(s.specular[c].begin(), s.hits, 0.0);
    }
    for (const Light& light : world.lights) {
        const int rays = reach_hits(world, light, s);
        if (rays > 0) {
            any_hit(world, s.shadow_rays(), rays, k_beam, s.occluded.data());
            take_shadows(s);
            s.counts.shadow += static_cast<std::uint64_t>(rays);
        }
        add_terms(world, light, s);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
