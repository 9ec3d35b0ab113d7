// SPDX-License-Identifier: Apache-2.0
// What the extended fields of a material (world/appearance/extended_materials.h) make of a light's terms and
// of its mirror.
#if defined(GLINT_TRACE_FINISH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_FINISH_INL_H_
#undef GLINT_TRACE_FINISH_INL_H_
#else
#define GLINT_TRACE_FINISH_INL_H_
#endif

#include "lighting/finish-inl.h"
#include "trace/surface/material-inl.h"
#include "trace/surface/passage-inl.h"
#include "world/appearance/fade.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The extended fields that the world's highlights and diffuse terms use.
struct FinishRules {
    bool brilliance = false, metallic = false, phong = false, tinted = false;
    bool highlights = false;  // one of them changes highlights
};
HWY_INLINE FinishRules finish_rules(const WorldParts& world) {
    if (world.extended_uses == 0) return {};
    const Shading shading = world.settings.shading;
    const bool shown = shading == Shading::phong || shading == Shading::blinn_phong;
    FinishRules rules{world.uses<&Material::brilliance>(), shown && world.uses<&Material::metallic>(),
                      shown && world.uses<&Material::phong>(),
                      shown && world.uses<&Material::tinted_highlight>()};
    rules.highlights = rules.metallic || rules.phong || rules.tinted;
    return rules;
}

/// Whether a light of this color adds something to a surface of that color.
HWY_INLINE LaneMask<double> is_colored(Vector3<Doubles> a, Vector3<Doubles> b) {
    const Doubles zero(0);
    return !(a.x * b.x == zero && a.y * b.y == zero && a.z * b.z == zero);
}

/// k I term f_att. strength: f_att, times the spot's factor.
HWY_INLINE Vector3<Doubles> contribution(Vector3<Doubles> k, Vector3<Doubles> light, Doubles term,
                                         Doubles strength) {
    return (k * light * term) * strength;
}

/// The factor of k_d I_l,d: N·L, to the power of the brilliance.
HWY_INLINE Doubles diffuse_factor(const MaterialLanes& material, const FinishRules& finish, Doubles n_l,
                                  const LightingRules& rules) {
    if (!finish.brilliance) return diffuse_term(n_l, rules);
    return brilliant_term(n_l, ExtendedLanes(material).value<&Material::brilliance>(), rules);
}

/// The light's color in highlights: I_l,s, or 1 for materials that leave it out.
HWY_INLINE Vector3<Doubles> highlight_light(const WorldParts& world, const MaterialLanes& material,
                                            const Light& light, const FinishRules& finish) {
    const Vector3<Doubles> color = lanes_of(light.specular_color * world.direct);
    if (!finish.tinted) return color;
    const auto tinted = ExtendedLanes(material).value<&Material::tinted_highlight>() > Doubles(0);
    return select_vector3(tinted, color, lanes_of(Color{1, 1, 1} * world.direct));
}

/// The factor of metals' highlights.
HWY_INLINE Vector3<Doubles> highlight_tint(const MaterialLanes& material, const FinishRules& finish,
                                           Doubles n_l) {
    if (!finish.metallic) return lanes_of(Vec3{1, 1, 1});
    return metal_tint(material.color(k_color), ExtendedLanes(material).value<&Material::metallic>(), n_l);
}

/// S^n of the second highlight, or 0.
inline HWY_NOINLINE Doubles phong_power_of(const MaterialLanes& material, const FinishRules& finish,
                                           Cosines<Doubles> phong, const LightingRules& rules) noexcept {
    const Doubles zero(0);
    if (!finish.phong) return zero;
    const auto bright = has_highlight(phong, rules);
    if (!any(bright)) return zero;
    const Doubles n = ExtendedLanes(material).value<&Material::phong_shininess>();
    return select(bright, highlight_power(phong.s, n, rules), zero);
}

/// The surfaces to which one of the highlights may add something. phong: N·L, and R·V.
HWY_INLINE LaneMask<double> finished_highlight_adds(const WorldParts& world, const MaterialLanes& material,
                                                    const Light& light, const FinishRules& finish,
                                                    Cosines<Doubles> c, Cosines<Doubles> phong,
                                                    const LightingRules& rules) {
    const Vector3<Doubles> color = highlight_light(world, material, light, finish);
    auto adds = has_highlight(c, rules) && is_colored(material.color(k_specular), color);
    if (finish.phong)
        adds = adds || (has_highlight(phong, rules) &&
                        is_colored(ExtendedLanes(material).color<&Material::phong>(), color));
    return adds;
}

/// The light of both highlights. power: S^n of the first one, or 0.
HWY_INLINE Vector3<Doubles> finished_highlight(const WorldParts& world, const MaterialLanes& material,
                                               const Light& light, const FinishRules& finish, Doubles power,
                                               Cosines<Doubles> phong, Doubles strength,
                                               const LightingRules& rules) {
    const Vector3<Doubles> color = highlight_light(world, material, light, finish);
    Vector3<Doubles> sum = contribution(material.color(k_specular), color, power, strength);
    if (finish.phong)
        sum = sum + contribution(ExtendedLanes(material).color<&Material::phong>(), color,
                                 phong_power_of(material, finish, phong, rules), strength);
    return finish.metallic ? sum * highlight_tint(material, finish, phong.n_l) : sum;
}

/// The cosine of the angle between the normal and the ray, on either side.
HWY_INLINE Doubles incidence(Vector3<Doubles> normal, Vector3<Doubles> incoming) {
    return min(abs(dot(normal, incoming)) / length(incoming), Doubles(1));
}

/// a, the part of the light that the mirror reflects towards the ray. plain: the world uses no extended
/// fields.
template <bool plain = false>
HWY_INLINE Doubles mirror_of(const WorldParts& world, const MaterialLanes& material,
                             const SurfaceBatch& surfaces, int h) {
    const Doubles a = material.value(k_mirror);
    if (plain) return a;
    const bool fresnel = world.uses<&Material::mirror_fresnel>();
    if (!fresnel && !world.uses<&Material::mirror_falloff>()) return a;
    const ExtendedLanes extended(material);
    const Doubles least = extended.value<&Material::mirror_min>(),
                  cosine = incidence(load_vector3(surfaces.normal, h), load_vector3(surfaces.incoming, h));
    const Doubles angled = angled_mirror(least, a, extended.value<&Material::mirror_falloff>(), cosine);
    if (!fresnel) return angled;
    const Doubles part = surface_reflectance(world, material, surfaces, h, cosine);
    return select(extended.value<&Material::mirror_fresnel>() > Doubles(0), least + (a - least) * part,
                  angled);
}

/// The factor of diffuse light and of the light from all directions, if the world uses outlines; else 1.
HWY_INLINE Doubles outline_of(const WorldParts& world, const MaterialLanes& material,
                              const SurfaceBatch& surfaces, int h) {
    if (!world.uses<&Material::outline>()) return Doubles(1);
    const ExtendedLanes extended(material);
    return outline_factor(extended.value<&Material::outline>(), extended.value<&Material::outline_width>(),
                          incidence(load_vector3(surfaces.normal, h), load_vector3(surfaces.incoming, h)));
}

/// The transparency of the surfaces at h, for rays that see them.
HWY_INLINE TransparencyLanes transparency_of(const WorldParts& world, const MaterialLanes& material,
                                             const SurfaceBatch& surfaces, int h) {
    TransparencyLanes transparency(material);
    if (!world.uses<&Material::angled_opacity>()) return transparency;
    const Doubles angled = ExtendedLanes(material).value<&Material::angled_opacity>();
    const Doubles cosine = incidence(load_vector3(surfaces.normal, h), load_vector3(surfaces.incoming, h));
    transparency.transmit =
        select(angled > Doubles(0), angled_transmit(transparency.transmit, cosine), transparency.transmit);
    return transparency;
}

/// The factor of the light that leaves an object through surface h (Material::fade_distance). left: of
/// left_by_mirror(). If it is nothing, light does not fade on its way to the surface, as on the way to an
/// opaque one; the mirror then reflects all (POV-Ray, measured).
inline Color surface_fade(const WorldParts& world, const SurfaceBatch& surfaces, int h, Color left) {
    if (!world.uses<&Material::fade_distance>() || left == Color{0, 0, 0}) return {1, 1, 1};
    const SurfaceId id = surfaces.surface(h);
    const Vec3 incoming = vec3_at(surfaces.incoming, h);
    const double distance = surfaces.hit_t[static_cast<std::size_t>(h)] * glint::length(incoming);
    return fade_at(world, id, vec3_at(surfaces.point, h), incoming, distance);
}

/// The color of what the mirror shows.
template <bool plain = false>
HWY_INLINE Vector3<Doubles> mirror_tint_of(const WorldParts& world, const MaterialLanes& material,
                                           Vector3<Doubles> normal, Vector3<Doubles> incoming) {
    const Vector3<Doubles> tint = material.color(k_mirror_tint);
    if (plain || !world.uses<&Material::mirror_metallic>()) return tint;
    return tint * metal_tint(material.color(k_color),
                             ExtendedLanes(material).value<&Material::mirror_metallic>(),
                             incidence(normal, incoming));
}

/// What the mirrors of the surfaces at h leave of the light that passes them (Material::conserve_energy).
/// a: mirror_of().
HWY_INLINE Vector3<Doubles> left_by_mirror(const WorldParts& world, const MaterialLanes& material,
                                           const SurfaceBatch& surfaces, int h, Doubles a) {
    const Vector3<Doubles> all = lanes_of(Vec3{1, 1, 1});
    if (!world.uses<&Material::conserve_energy>()) return all;
    const Doubles conserves = ExtendedLanes(material).value<&Material::conserve_energy>();
    const Vector3<Doubles> mirror = mirror_tint_of(world, material, load_vector3(surfaces.normal, h),
                                                   load_vector3(surfaces.incoming, h)) *
                                    a;
    return all - mirror * conserves;
}

/// The factor of what the eye sees through the surfaces at h. a: mirror_of().
HWY_INLINE Vector3<Doubles> seen_through(const WorldParts& world, const MaterialLanes& material,
                                         const TransparencyLanes& transparency, const SurfaceBatch& surfaces,
                                         int h, Doubles a) {
    const Vector3<Doubles> through = transparency.through();
    if (!world.uses<&Material::conserve_energy>()) return through;
    return through * left_by_mirror(world, material, surfaces, h, a);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
