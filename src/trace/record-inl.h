// SPDX-License-Identifier: Apache-2.0
// Records the results of the stages (trace/record.h). Each function runs directly after its stage and calls
// the same functions as the stage, so that the recorded numbers have the same bits.
#if defined(GLINT_TRACE_RECORD_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_RECORD_INL_H_
#undef GLINT_TRACE_RECORD_INL_H_
#else
#define GLINT_TRACE_RECORD_INL_H_
#endif

#include "trace/film/film-inl.h"
#include "trace/lighting/ambient_occlusion-inl.h"
#include "trace/lighting/area_shadow-inl.h"
#include "trace/lighting/direct_lighting-inl.h"
#include "trace/record.h"
#include "trace/record_texture.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

template <class Column> inline Color color_at(const Column* from, int i) {
    return {(&from[0][0])[i], (&from[1][0])[i], (&from[2][0])[i]};
}

/// The elements of a vector of Vector3.
struct Vector3Elements {
    alignas(k_ray_alignment) double lanes[3][lane_count<double>()];
    explicit Vector3Elements(const Vector3<Doubles>& v) { store_vector3(v, lanes, 0); }
    Color color(int k) const { return {lanes[0][k], lanes[1][k], lanes[2][k]}; }
    Vec3 vec3(int k) const { return {lanes[0][k], lanes[1][k], lanes[2][k]}; }
};
/// The elements of a vector.
struct LaneElements {
    alignas(k_ray_alignment) double lanes[lane_count<double>()];
    explicit LaneElements(Doubles v) { store(v, lanes); }
    double operator[](int k) const { return lanes[k]; }
};

/// Calls visit(h, lanes) for each vector of hits: its first hit and the number of its hits.
template <class Visit> inline void for_each_hit(const SurfaceBatch& surfaces, const Visit& visit) {
    for (int h = 0; h < surfaces.count; h += lane_count<double>()) {
        visit(h, number::min(lane_count<double>(), surfaces.count - h));
    }
}

/// The surface of a hit.
GLINT_SMALL ExplainedHit recorded_hit(const WorldParts& world, const SurfaceBatch& surfaces, std::size_t h) {
    const auto i = static_cast<int>(h);
    ExplainedHit hit;
    const SurfaceId id = surfaces.surface(i);
    hit.shape = world.geometry->shape_of(id);
    hit.element = world.geometry->part_of(id);
    hit.material = surfaces.material[h];
    hit.point = vec3_at(surfaces.point, i);
    if (const std::optional<MeshPlace> place = mesh_place(*world.geometry, id, hit.point)) {
        hit.triangle = static_cast<int>(id.element);
        hit.corner_weights = place->weights;
        hit.mesh_point = place->point;
    }
    if (const ShapeColor color = own_color(world, id, &hit.point); color.is_set()) hit.color = color.color();
    hit.texture = recorded_texture(world, id, hit.point);
    hit.normal = vec3_at(surfaces.normal, i);
    hit.to_eye = vec3_at(surfaces.to_eye, i);
    hit.behind = surfaces.behind[h] > 0;
    hit.turned = hit.behind && flips_normal(world, id);
    hit.weight = color_at(surfaces.weight, i);
    return hit;
}

/// Records a range of rays and their hits, after color_surfaces() and apply_beer_law().
GLINT_SMALL void record_rays(const WorldParts& world, const RayBatch& rays, const HitBatch& hits,
                             RayRange range, const SurfaceBatch& surfaces, TileRecord& record) {
    record.batch.clear();
    const bool camera = rays.generation == 0;
    for (int i = range.begin; i < range.end; ++i) {
        const int number = hits.first + i;
        ExplainedRay ray;
        ray.sample = record.sample;
        ray.generation = rays.generation;
        if (!camera) {
            const TileRecord::SpawnedRay& spawned = record.spawned[record.arrived++];
            ray.parent = spawned.ray;
            ray.transmitted = spawned.transmitted;
            ray.straight = spawned.straight;
            ExplainedHit& hit = *record.rays[static_cast<std::size_t>(spawned.ray)].hit;
            (ray.transmitted ? hit.transmitted : hit.reflected).ray = static_cast<int>(record.rays.size());
        }
        ray.origin = vec3_at(rays.origin, number);
        ray.direction = vec3_at(rays.direction, number);
        ray.t_min = rays.t_min[static_cast<std::size_t>(number)];
        ray.beyond_limit = ray.t_min >= k_blind_t_min;
        ray.t = hits.t[static_cast<std::size_t>(i)];
        ray.weight = camera ? Color{1, 1, 1} : color_at(rays.weight, number);
        ray.inside_object = rays.tracked && world.has_lighting() &&
                            is_outside_fog(world, rays.interiors[static_cast<std::size_t>(number)]);
        if (ray.t < k_infinity) {
            if (world.fog && world.has_lighting()) {
                const auto h = static_cast<int>(record.batch.size());
                ray.visibility = surfaces.visibility[record.batch.size()];
                ray.fog = color_at(surfaces.fog, h);
            }
            ray.hit = recorded_hit(world, surfaces, record.batch.size());
            record.batch.push_back(record.rays.size());
        } else if (camera || world.conventions.mirror_miss != MissRule::black) {
            ray.transparent = rays.alpha && (camera || rays.straight[static_cast<std::size_t>(number)] > 0);
            const bool is_outside = !ray.inside_object && !ray.beyond_limit;
            FoggedBackground seen = fogged_background(
                world, miss_color(world),
                is_outside ? LaneElements(background_visibility(world, rays, number))[0] : 1);
            if (has_gradient(world))
                seen.background =
                    Vector3Elements(through_fog(world, gradient_color(*world.gradient, rays, number),
                                                Doubles(seen.visibility)))
                        .color(0);
            if (!ray.transparent || shows_background(world)) ray.background = ray.weight * seen.background;
            ray.visibility = seen.visibility;
            ray.fog = ray.weight * seen.fog;
        }
        record.rays.push_back(std::move(ray));
    }
}

/// Records the colors of the unlit shading modes, after add_unlit().
GLINT_SMALL void record_unlit(const WorldParts& world, const SurfaceBatch& surfaces, TileRecord& record) {
    for_each_hit(surfaces, [&](int h, int lanes) HWY_ATTR {
        const Vector3Elements shown(unlit_color(world, surfaces, h));
        for (int k = 0; k < lanes; ++k) {
            ExplainedHit& hit = record.hit(h + k);
            hit.ambient = hit.parts[0] = shown.color(k);
        }
    });
}

/// The transparent surface that a shadow ray passes in a step. terms: LightTerms or a ShadowSample.
template <class Terms>
inline ShadowFilter recorded_filter(const WorldParts& world, const TileRecord::ShadowStep& step,
                                    const Terms& terms, Vec3 shaded) {
    const Vec3 at = terms.origin + terms.direction * step.t;
    return {world.geometry->shape_of(step.surface), glint::length(at - shaded), at, step.factor, step.fade};
}
/// The transparent surfaces on the way of a shadow ray, from P.
inline std::vector<ShadowFilter> recorded_filters(const WorldParts& world, const Light& light, int ray,
                                                  const LightTerms& terms, Vec3 shaded,
                                                  const TileRecord& record) {
    std::vector<ShadowFilter> filters;
    for (const TileRecord::ShadowStep& step : record.shadow_steps) {
        if (step.ray == ray) filters.push_back(recorded_filter(world, step, terms, shaded));
    }
    if (comes_from_light(light, world.conventions)) std::reverse(filters.begin(), filters.end());
    return filters;
}
/// The same for the shadow ray of a sample of a light that shines from its centre.
inline std::vector<ShadowFilter> recorded_filters(const WorldParts& world, const Light& light, int surface,
                                                  const ShadowSample& traced, Vec3 shaded,
                                                  const TileRecord& record) {
    std::vector<ShadowFilter> filters;
    for (const TileRecord::SampleStep& of : record.sample_steps) {
        if (of.sample == traced.sample && of.surface == surface)
            filters.push_back(recorded_filter(world, of.step, traced, shaded));
    }
    if (comes_from_light(light, world.conventions)) std::reverse(filters.begin(), filters.end());
    return filters;
}

/// The factors with which the samples of an area light count in its visible part, by sample. strength: of the
/// light at the surface, without its shadow.
inline std::vector<double> sample_weights(const WorldParts& world, const PreparedLight& light,
                                          AreaShadowBatch& shadow, int surface, double strength) {
    std::vector<double> weights(static_cast<std::size_t>(light.area.count()));
    const LightDifference difference(light.color, strength);
    if (world.colors_shadows())
        VisiblePart<Color>(light.area, shadow, surface, difference).add_weights(weights);
    else
        VisiblePart<double>(light.area, shadow, surface, difference).add_weights(weights);
    return weights;
}

/// The samples of an area light whose shadow rays were traced for the surface at index h + k.
GLINT_SMALL std::vector<ShadowSample> recorded_samples(const WorldParts& world, const PreparedLight& light,
                                                       const SurfaceBatch& surfaces, AreaShadowBatch& shadow,
                                                       int h, int k, double strength,
                                                       const TileRecord& record) {
    const std::vector<double> weights = sample_weights(world, light, shadow, h + k, strength);
    std::vector<ShadowSample> list;
    for (int sample = 0; sample < light.area.count(); ++sample) {
        if (!shadow.is_traced(sample, h + k)) continue;
        const Vec3 fixed = fixed_sample(world, light.area, sample);
        const ShadowRay<Doubles> ray = sample_ray(world, light, sample, fixed, surfaces, h);
        const Vector3<Doubles> at =
            light.moves_samples() ? moved_sample(world, light, sample, surfaces, h) : lanes_of(fixed);
        ShadowSample& traced = list.emplace_back();
        traced.sample = sample;
        traced.weight = weights[static_cast<std::size_t>(sample)];
        traced.position = Vector3Elements(at).vec3(k);
        traced.blocked = !shadow.is_visible(sample, h + k);
        traced.origin = Vector3Elements(ray.origin).vec3(k);
        traced.direction = Vector3Elements(ray.direction).vec3(k);
        traced.t_min = LaneElements(ray.t_min)[k];
        traced.t_max = ray.t_max;
        if (!world.colors_shadows()) continue;
        if (!traced.blocked) traced.filter = shadow.filter_of(sample, h + k);
        traced.filters =
            recorded_filters(world, light, h + k, traced, vec3_at(surfaces.point, h + k), record);
    }
    return list;
}

/// Records one light, after its terms have been added.
GLINT_SMALL void record_light(const WorldParts& world, const PreparedLight& light, const LightRules& rules,
                              const SurfaceBatch& surfaces, const LightSampleBatch& samples,
                              const ShadowRayBatch& shadow_rays, AreaShadowBatch& area_shadow,
                              TileRecord& record) {
    int rays = 0;
    for_each_hit(surfaces, [&](int h, int lanes) HWY_ATTR {
        const MaterialLanes material(surfaces, h);
        const LightLanes at = light_at(world, light, rules, surfaces, h);
        const auto bright = has_highlight(at.cosines, rules);
        const Doubles power =
            select(bright, highlight_power(at.cosines.s, material.value(k_shininess), rules), Doubles(0));
        const Doubles strength =
            rules.samples_shadow && any(at.lit) ? load(samples.strength.data() + h) : at.strength();
        const Cosines<Doubles> phong{at.cosines.n_l, at.phong_s};
        const Vector3Elements to_light(at.to_light),
            diffuse(diffuse_of(material, rules, at.cosines.n_l, strength)),
            specular(specular_of(world, material, light, rules, power, phong, strength)),
            tint(highlight_tint(material, rules.finish, at.cosines.n_l));
        const LaneElements distance(at.distance), f_att(at.attenuation), spot(at.spot), n_l(at.cosines.n_l),
            cosine(at.cosines.s), powers(power), phong_s(at.phong_s),
            phong_power(phong_power_of(material, rules.finish, phong, rules)),
            factor(diffuse_factor(material, rules.finish, at.cosines.n_l, rules)), unshadowed(at.strength());
        const std::uint32_t may_add = to_bits(at.lit), lit = lit_bits(samples, h);
        for (int k = 0; k < lanes; ++k) {
            LightTerms r;
            r.light = light.index;
            r.sample = light.sample;
            r.to_light = to_light.vec3(k);
            r.distance = distance[k];
            r.attenuation = f_att[k];
            (light.is_spot() ? r.spot : r.emitter) = spot[k];
            r.n_l = n_l[k];
            r.s = cosine[k];
            r.power = powers[k];
            r.diffuse_factor = factor[k];
            r.phong_s = phong_s[k];
            r.phong_power = phong_power[k];
            r.highlight_tint = tint.color(k);
            r.threshold = rules.light_threshold;
            r.may_add = (may_add >> k & 1) != 0;
            r.blocked = r.may_add && (lit >> k & 1) == 0;
            if (r.may_add && rules.has_shadow_rays) {
                r.has_ray = true;
                r.origin = vec3_at(shadow_rays.origin, rays);
                r.direction = vec3_at(shadow_rays.direction, rays);
                r.t_min = shadow_rays.t_min[static_cast<std::size_t>(rays)];
                r.t_max = shadow_rays.t_max[static_cast<std::size_t>(rays)];
                if (world.colors_shadows()) {
                    r.filter = color_at(shadow_rays.filter, rays);
                    r.filters = recorded_filters(world, light, rays, r, record.hit(h + k).point, record);
                }
                ++rays;
            }
            if (r.may_add && rules.samples_shadow) {
                r.samples =
                    recorded_samples(world, light, surfaces, area_shadow, h, k, unshadowed[k], record);
                r.visible = area_shadow.fraction[static_cast<std::size_t>(h + k)];
                if (world.colors_shadows()) r.filter = color_at(samples.filter, h + k);
            }
            if (r.may_add && !r.blocked) {
                r.diffuse = diffuse.color(k) * r.filter;
                r.specular = rules.attenuate_highlights ? specular.color(k) * r.filter : specular.color(k);
            }
            record.hit(h + k).lights.push_back(std::move(r));
        }
    });
    record.shadow_steps.clear();
    record.sample_steps.clear();
}

/// Records the rays of one occlusion sample that are blocked.
GLINT_SMALL void record_sky_rays(const ShadowRayBatch& rays, const SkyBatch& sky, TileRecord& record) {
    for (std::size_t r = 0; r < static_cast<std::size_t>(rays.count); ++r) {
        if (rays.occluded[r] == 0) continue;
        const auto i = static_cast<int>(r);
        record.sky_rays.push_back({sky.order[static_cast<std::size_t>(sky.entry[r])], vec3_at(rays.origin, i),
                                   vec3_at(rays.direction, i), rays.t_min[r], rays.t_max[r]});
    }
}

/// Records the light from all directions, after its terms have been computed.
GLINT_SMALL void record_sky(const WorldParts& world, const SurfaceBatch& surfaces, const SkyBatch& sky,
                            const RadianceBatch& radiance, TileRecord& record) {
    for_each_hit(surfaces, [&](int h, int lanes) HWY_ATTR {
        const Vector3Elements factors(sky_factor(world, sky, h));
        for (int k = 0; k < lanes; ++k) {
            ExplainedOcclusion& to = record.hit(h + k).occlusion.emplace();
            to.samples = world.occlusion->samples;
            to.blocked = static_cast<int>(sky.blocked_of(static_cast<std::size_t>(h + k)));
            to.factors = factors.color(k);
            to.factor = colors_sky(world) ? (to.factors.r + to.factors.g + to.factors.b) / 3 : to.factors.r;
            to.light = color_at(radiance.sky, h + k);
        }
    });
    const auto first = static_cast<std::size_t>(sky.first), count = static_cast<std::size_t>(surfaces.count);
    for (TileRecord::SkyRay ray : record.sky_rays) {
        if (ray.ray < first || ray.ray >= first + count) continue;
        ray.ray = record.batch[ray.ray - first];
        record.blocked_sky.push_back(ray);
    }
}

/// The hits of a vector that have secondary rays, that are glass or transparent, that are transparent, whose
/// rays are traced, and whose rays the limit of reflections stops.
struct SecondaryMasks {
    LaneMask<double> has_secondary, glass, through, reflected, transmitted, at_limit;
};

/// Records the secondary rays of a vector of hits, when they are queued.
GLINT_SMALL void record_secondary_rays(const WorldParts& world, TileRecord& record, int h,
                                       const SecondaryMasks& masks, const Vector3<Doubles>& reflected,
                                       const Vector3<Doubles>& transmitted, const Doubles& fresnel) {
    const double min_weight = world.conventions.min_weight;
    const Vector3Elements weights[2] = {Vector3Elements(reflected), Vector3Elements(transmitted)};
    const LaneElements f(fresnel);
    const std::uint32_t has[2] = {to_bits(masks.has_secondary), to_bits(masks.glass)},
                        traced[2] = {to_bits(masks.reflected), to_bits(masks.transmitted)},
                        through = to_bits(masks.through), at_limit = to_bits(masks.at_limit);
    for (int k = 0; k < lane_count<double>(); ++k) {
        if ((has[0] >> k & 1) == 0) continue;
        const int number = h + k;
        ExplainedHit& hit = record.hit(number);
        hit.fresnel = (has[1] >> k & 1) != 0 ? f[k] : 0;
        ExplainedSecondaryRay* rays[2] = {&hit.reflected, &hit.transmitted};
        for (int side = 0; side < 2; ++side) {
            if ((has[side] >> k & 1) == 0) continue;
            const Color weight = weights[side].color(k);
            const double most = max(max(weight.r, weight.g), weight.b);
            // Glass may reflect without a mirror; a transparent surface does not.
            const bool may_reflect = (through >> k & 1) == 0 || world.is_mirror(hit.material);
            if (side == 0 && !may_reflect) continue;
            if ((at_limit >> k & 1) != 0) {
                const bool starts = side == 1 || world.is_mirror(hit.material);
                rays[side]->state = starts ? SecondaryRayState::limit : SecondaryRayState::none;
                continue;
            }
            const bool went = (traced[side] >> k & 1) != 0;
            *rays[side] = {went                             ? SecondaryRayState::traced
                           : most > 0 && most >= min_weight ? SecondaryRayState::cut
                                                            : SecondaryRayState::faint,
                           weight, -1};
            if (went)
                record.spawned.push_back({static_cast<int>(record.batch[static_cast<std::size_t>(number)]),
                                          side == 1, side == 1 && (through >> k & 1) != 0});
        }
    }
}

/// Records that the limit of reflections has stopped the secondary rays.
GLINT_SMALL void record_limit(const WorldParts& world, const SurfaceBatch& surfaces, TileRecord& record) {
    for (int h = 0; h < surfaces.count; ++h) {
        ExplainedHit& hit = record.hit(h);
        const double* material = world.material(hit.material);
        if (world.is_mirror(hit.material)) hit.reflected.state = SecondaryRayState::limit;
        if (material[k_transmission] > 0) hit.transmitted.state = SecondaryRayState::limit;
    }
}

/// Records the light that the hits add to their pixels, after add_to_film().
GLINT_SMALL void record_sums(const WorldParts& world, const SurfaceBatch& surfaces,
                             const RadianceBatch& radiance, TileRecord& record) {
    for_each_hit(surfaces, [&](int h, int lanes) HWY_ATTR {
        const MaterialLanes material(surfaces, h);
        const Doubles a = mirror_of(world, material, surfaces, h);
        const LaneElements mirror(a);
        const HitLight light = light_of(world, surfaces, radiance, material, h);
        const Vector3Elements ambient(ambient_of(world, material)), emission(emission_of(world, material)),
            parts[4] = {Vector3Elements(light.ambient), Vector3Elements(light.diffuse),
                        Vector3Elements(light.specular), Vector3Elements(light.emission)};
        const LocalShares shares = local_shares(world, material, surfaces, h);
        const LaneElements share(shares.matte), highlight_share(shares.highlight);
        const Vector3Elements sky(light.sky),
            diffuse(outlined_diffuse(world, surfaces, radiance, material, h));
        const LaneElements outline(outline_of(world, material, surfaces, h));
        for (int k = 0; k < lanes; ++k) {
            ExplainedHit& hit = record.hit(h + k);
            hit.ambient = ambient.color(k);
            hit.diffuse = diffuse.color(k);
            hit.outline = outline[k];
            hit.specular = color_at(radiance.specular, h + k);
            hit.emission = emission.color(k);
            hit.mirror = mirror[k];
            hit.local_share = share[k];
            hit.highlight_share = highlight_share[k];
            if (world.is_transparent(hit.material)) {
                const Vector3Elements left(left_by_mirror(world, material, surfaces, h, a));
                hit.transparent = true;
                const TransparencyLanes transparency = transparency_of(world, material, surfaces, h);
                const Vector3Elements through(seen_through(world, material, transparency, surfaces, h, a));
                hit.opacity = LaneElements(transparency.opacity(world.conventions.opacity))[k];
                hit.through = through.color(k);
                hit.fade = surface_fade(world, surfaces, h + k, left.color(k));
            }
            for (int part = 0; part < 4; ++part) hit.parts[part] = parts[part].color(k);
            if (hit.occlusion) hit.occlusion->part = sky.color(k);
        }
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
