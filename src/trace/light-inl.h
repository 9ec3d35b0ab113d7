// The light of a tile's hits: for each light the cosines, the shadow rays of those it may reach, and the
// terms of those it does.
#if defined(GLINT_TRACE_LIGHT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_LIGHT_INL_H_
#undef GLINT_TRACE_LIGHT_INL_H_
#else
#define GLINT_TRACE_LIGHT_INL_H_
#endif

#include "geometry/leave-inl.h"
#include "lighting/phong-inl.h"
#include "trace/hit_declarations-inl.h"
#include "trace/tile.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

HWY_INLINE Triple<Doubles> load_triple(const TileScratch::Column* from, int i) {
    return {load(from[0].data() + i), load(from[1].data() + i), load(from[2].data() + i)};
}
HWY_INLINE Triple<Doubles> lanes_of(Vec3 v) { return {Doubles(v.x), Doubles(v.y), Doubles(v.z)}; }

/// A colour of each lane's material.
HWY_INLINE Triple<Doubles> gather_color(const World& world, const std::uint32_t* material, int value) {
    std::uint32_t index[lane_count<double>()];
    for (int i = 0; i < lane_count<double>(); ++i) index[i] = material[i] * k_material_values;
    const double* base = world.materials.data() + value;
    return {gather(base, index), gather(base + 1, index), gather(base + 2, index)};
}

HWY_INLINE LightingRules lighting_rules(const World& world) {
    const Conventions& c = world.conventions;
    return {world.settings.shading, c.specular_gate, c.clamp_cosines, c.normalize};
}

/// A vector of shadow rays, to be compacted.
struct ShadowRays {
    Triple<Doubles> origin, direction;
    Doubles t_min, t_max;
};

/// A point light's ray is traced from the light to the surface, so that a light's rays share their origin.
HWY_INLINE ShadowRays shadow_rays(const World& world, const Light& light,
                                  const SurfacePoint<Doubles>& surface, Triple<Doubles> to_light) {
    const Conventions& c = world.conventions;
    const Doubles infinity(std::numeric_limits<double>::infinity());
    const Triple<Doubles> start = leave(surface, to_light, c.offset, c.epsilon);
    if (light.kind == LightKind::directional || !c.shadow_stops_at_light) {
        return {start, to_light, Doubles(leave_t_min(c.offset, c.epsilon)), infinity};
    }
    const Triple<Doubles> from = lanes_of(light.position), direction = start - from;
    Doubles t_min(0);
    // Its distance is compared with the light's from P itself: it sees epsilon past the light.
    if (c.offset == Offset::direction) t_min = Doubles(-c.epsilon) / length(direction);
    return {from, direction, t_min, Doubles(c.offset == Offset::ray ? 1 - c.epsilon : 1.0)};
}

/// The first half of a light: cosines, attenuation, who may be lit, and their shadow rays. Returns how many
/// of those.
inline int reach_hits(const World& world, const Light& light, TileScratch& s) {
    const LightingRules rules = lighting_rules(world);
    const Triple<Doubles> diffuse_light{Doubles(light.color.r), Doubles(light.color.g),
                                        Doubles(light.color.b)};
    const Triple<Doubles> specular_light{Doubles(light.specular_color.r), Doubles(light.specular_color.g),
                                         Doubles(light.specular_color.b)};
    const auto adds = [](Triple<Doubles> a, Triple<Doubles> b) HWY_ATTR {
        return !(a.x * b.x == Doubles(0)) || !(a.y * b.y == Doubles(0)) || !(a.z * b.z == Doubles(0));
    };
    int rays = 0;
    for (int i = 0; i < s.hits; i += lane_count<double>()) {
        const SurfacePoint<Doubles> surface{load_triple(s.point, i), load_triple(s.normal, i),
                                            load_triple(s.incoming, i), load(s.magnitude.data() + i)};
        const Triple<Doubles> to_light = light.kind == LightKind::point
                                             ? lanes_of(light.position) - surface.point
                                             : lanes_of(light.to_light);
        const Doubles distance = length(to_light);
        const Triple<Doubles> l = rules.normalize ? to_light / distance : to_light;
        const auto c = cosines(surface.normal, l, load_triple(s.to_eye, i), rules);
        Doubles f_att(1);
        if (light.kind == LightKind::point) {
            const Attenuation& a = light.attenuation;
            f_att = attenuation(Doubles(a.c0), Doubles(a.c1), Doubles(a.c2), distance);
        }
        const auto faces = rules.clamp_cosines ? c.n_l > Doubles(0) : !(c.n_l == Doubles(0));
        const auto diffuse =
            faces && adds(gather_color(world, s.material.data() + i, k_diffuse), diffuse_light);
        const auto specular = has_highlight(c, rules) &&
                              adds(gather_color(world, s.material.data() + i, k_specular), specular_light);
        // A light in the surface itself has no direction.
        std::uint32_t lit = to_bits((diffuse || specular) && distance > Doubles(0) && f_att > Doubles(0));
        const int lanes = number::min(s.hits - i, lane_count<double>());
        lit &= (1u << lanes) - 1;
        store(c.n_l, s.n_l.data() + i);
        store(c.s, s.s.data() + i);
        store(f_att, s.attenuation.data() + i);
        for (int k = 0; k < lanes; ++k) s.lit[i + k] = lit >> k & 1;
        if (lit == 0 || !world.settings.shadows) continue;
        const ShadowRays shadow = shadow_rays(world, light, surface, to_light);
        const Doubles columns[8] = {shadow.origin.x,    shadow.origin.y,    shadow.origin.z,
                                    shadow.direction.x, shadow.direction.y, shadow.direction.z,
                                    shadow.t_min,       shadow.t_max};
        alignas(64) double lane[8][lane_count<double>()];
        for (int k = 0; k < 8; ++k) store(columns[k], lane[k]);
        for (; lit != 0; lit &= lit - 1) {
            const int k = __builtin_ctz(lit);
            for (int column = 0; column < 8; ++column) s.shadow[column][rays] = lane[column][k];
            s.shadow_hit[rays++] = i + k;
        }
    }
    return rays;
}

/// The second half: adds the terms of the hits that are still lit.
inline void add_terms(const World& world, const Light& light, TileScratch& s) {
    const LightingRules rules = lighting_rules(world);
    for (int i = 0; i < s.hits; i += lane_count<double>()) {
        std::uint32_t lit = 0;
        for (int k = 0; k < number::min(s.hits - i, lane_count<double>()); ++k)
            lit |= static_cast<std::uint32_t>(s.lit[i + k]) << k;
        if (lit == 0) continue;
        const auto mask = from_bits<double>(lit);
        const Cosines<Doubles> c{load(s.n_l.data() + i), load(s.s.data() + i)};
        std::uint32_t index[lane_count<double>()];
        for (int k = 0; k < lane_count<double>(); ++k) index[k] = s.material[i + k] * k_material_values;
        const Doubles shininess = gather(world.materials.data() + k_shininess, index);
        const auto t = terms(c, shininess, rules);
        const Doubles f_att = load(s.attenuation.data() + i);
        const Triple<Doubles> k_d = gather_color(world, s.material.data() + i, k_diffuse);
        const Triple<Doubles> k_s = gather_color(world, s.material.data() + i, k_specular);
        const auto add = [&](TileScratch::Column& to, Doubles k, Doubles light_color, Doubles term) HWY_ATTR {
            const Doubles sum = load(to.data() + i);
            store(select(mask, sum + f_att * (k * light_color * term), sum), to.data() + i);
        };
        add(s.diffuse[0], k_d.x, Doubles(light.color.r), t.diffuse);
        add(s.diffuse[1], k_d.y, Doubles(light.color.g), t.diffuse);
        add(s.diffuse[2], k_d.z, Doubles(light.color.b), t.diffuse);
        add(s.specular[0], k_s.x, Doubles(light.specular_color.r), t.specular);
        add(s.specular[1], k_s.y, Doubles(light.specular_color.g), t.specular);
        add(s.specular[2], k_s.z, Doubles(light.specular_color.b), t.specular);
    }
}

/// Sums diffuse and specular of all hits over the lights, in the scene's order.
inline void light_hits(const World& world, TileScratch& s) {
    for (int c = 0; c < 3; ++c) {
        for (int i = 0; i < s.hits; ++i) s.diffuse[c][i] = s.specular[c][i] = 0;
    }
    // Lanes past the last hit are computed with, though nothing of them is kept.
    for (int i = s.hits; i < s.hits + k_ray_padding; ++i) s.material[i] = 0;
    for (const Light& light : world.lights) {
        const int rays = reach_hits(world, light, s);
        if (rays > 0) {
            any_hit(world, s.shadow_rays(), rays, k_beam, s.occluded.data());
            for (int i = 0; i < rays; ++i) {
                if (s.occluded[i]) s.lit[s.shadow_hit[i]] = 0;
            }
            s.counts.shadow += static_cast<std::uint64_t>(rays);
        }
        add_terms(world, light, s);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
