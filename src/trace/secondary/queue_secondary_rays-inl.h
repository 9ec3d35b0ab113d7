// SPDX-License-Identifier: Apache-2.0
// The stage that queues the mirror and glass rays of the surfaces, as the next generation of rays.
#if defined(GLINT_TRACE_QUEUE_SECONDARY_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_QUEUE_SECONDARY_RAYS_INL_H_
#undef GLINT_TRACE_QUEUE_SECONDARY_RAYS_INL_H_
#else
#define GLINT_TRACE_QUEUE_SECONDARY_RAYS_INL_H_
#endif

#include "trace/film/background-inl.h"
#include "trace/rays/ray_hash-inl.h"
#include "trace/record-inl.h"
#include "trace/secondary/ray_weights-inl.h"
#include "trace/secondary/secondary_rays-inl.h"
#include "trace/secondary/transparent_refraction-inl.h"
#include "trace/surface/faulty_normals-inl.h"
#include "trace/surface/surface-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Whether the rays of the surfaces have no more than the columns of RayFields that all rays have (and the
/// medium), start at one t, and no surface uses an extended field. The stage is compiled for this case, too,
/// because it is the usual one.
HWY_INLINE bool are_plain(const WorldParts& world, const SurfaceBatch& surfaces) {
    return world.extended_uses == 0 && world.conventions.limit != LimitRule::background && !surfaces.alpha &&
           !surfaces.hashed && !surfaces.tracked;
}

/// The secondary rays of a vector of surfaces, to be stored by push().
struct SecondaryRays {
    Vector3<Doubles> origin, direction, weight;
    Doubles target, straight, medium, path, t_min;
    Doubles start, level, passed;
    Doubles interiors;
};
template <bool plain>
HWY_INLINE void push(RayBatch& batch, const SecondaryRays& rays, LaneMask<double> set,
                     const SurfaceBatch& surfaces, bool medium) {
    const RayFields<double*> to = batch.end();
    compress_vector3(rays.origin, set, to.origin, 0);
    compress_vector3(rays.direction, set, to.direction, 0);
    compress_vector3(rays.weight, set, to.weight, 0);
    compress_store(rays.target, set, to.target);
    if (medium) compress_store(rays.medium, set, to.medium);
    if (plain) {
        store(rays.t_min, to.t_min);
    } else {
        compress_store(rays.t_min, set, to.t_min);
        if (surfaces.alpha) compress_store(rays.straight, set, to.straight);
        if (surfaces.hashed) compress_store(rays.path, set, to.path);
        if (surfaces.tracked) compress_store(rays.interiors, set, to.interiors);
        if (surfaces.transparent) {
            compress_store(rays.start, set, to.start);
            compress_store(rays.level, set, to.level);
            compress_store(rays.passed, set, to.passed);
        }
    }
    store(Doubles(k_infinity), to.t_max);
    batch.count += count(set);
}

/// Whether a sample of a pixel can reach k_max_sample_rays. The number of rays at most doubles in each
/// generation; there may be any number of transparent surfaces.
HWY_INLINE bool is_limited(const WorldParts& world) {
    if (world.has_transparency()) return true;
    const int generations = world.settings.reflections;
    return generations > 30 || (2 << generations) - 2 > k_max_sample_rays;
}

/// Returns the rays of the set that do not exceed the limit of their pixel's sample. Counts both kinds.
GLINT_SMALL LaneMask<double> limit_rays(const double* targets, LaneMask<double> set,
                                        SecondaryRayBatch& secondary, RayCounts& counts) noexcept {
    std::uint32_t kept = 0;
    for (std::uint32_t bits = to_bits(set); bits != 0; bits &= bits - 1) {
        const int target = static_cast<int>(targets[__builtin_ctz(bits)]);
        std::int32_t& rays = secondary.of_pixel[static_cast<std::size_t>(target % k_layer_stride)];
        if (rays >= k_max_sample_rays) {
            ++counts.cut;
        } else {
            ++rays;
            kept |= bits & (0 - bits);
        }
    }
    return from_bits<double>(kept);
}

/// The material index of each lane, as stored in RayFields::medium.
HWY_INLINE Doubles material_numbers(const std::uint32_t* material) {
    alignas(64) double lanes[lane_count<double>()];
    for (int k = 0; k < lane_count<double>(); ++k) lanes[k] = static_cast<double>(material[k]);
    return load(lanes);
}

/// Sets the rays straight through the transparent surfaces `through`: they go on along the same line.
HWY_INLINE void go_straight(const WorldParts& world, const SurfaceBatch& surfaces, int h,
                            LaneMask<double> through, LaneMask<double> at_limit, SecondaryRays& rays) {
    const Doubles t = load(surfaces.t.data() + h), one(1), zero(0);
    const Vector3<Doubles> incoming = load_vector3(surfaces.incoming, h);
    const double gap = world.conventions.transparent_epsilon;
    rays.origin = select_vector3(through, load_vector3(surfaces.origin, h), rays.origin);
    rays.direction = select_vector3(through, incoming, rays.direction);
    rays.t_min = select(through && !at_limit, gap > 0 ? t + Doubles(gap) / length(incoming) : t, rays.t_min);
    rays.start = select(through, t, zero);
    if (!world.conventions.transparency_counts) rays.level = rays.level - select(through, one, zero);
    rays.passed = rays.passed + select(through, one, zero);
}

/// Sets the start of the refracted rays `bent`: with `transparent_epsilon` they meet what is at least that
/// far behind the surface, as those that go straight on.
HWY_INLINE void start_at_surface(const WorldParts& world, const SurfacePoint<Doubles>& surface,
                                 LaneMask<double> bent, SecondaryRays& rays) {
    const double gap = world.conventions.transparent_epsilon;
    if (!(gap > 0)) return;
    rays.origin = select_vector3(bent, surface.point, rays.origin);
    rays.t_min = select(bent, Doubles(gap) / length(rays.direction), rays.t_min);
}

/// Sets the rays at the limit of reflections where sees_back(): they are the rays before them.
HWY_INLINE void go_back(const SurfaceBatch& surfaces, int h, LaneMask<double> at_limit, SecondaryRays& rays) {
    const Vector3<Doubles> incoming = load_vector3(surfaces.incoming, h);
    const Vector3<Doubles> start =
        load_vector3(surfaces.point, h) - incoming * load(surfaces.hit_t.data() + h);
    rays.origin = select_vector3(at_limit, start, rays.origin);
    rays.direction = select_vector3(at_limit, incoming, rays.direction);
    rays.start = select(at_limit, Doubles(0), rays.start);
}

/// Queues the mirror and glass rays of the vector of surfaces at index h. plain: are_plain(), without a
/// fault.
template <bool plain>
HWY_INLINE void queue_vector(const WorldParts& world, const SurfaceBatch& surfaces, int h,
                             LaneMask<double> hit, bool limited, SecondaryRayBatch& secondary,
                             RayCounts& counts, TileRecord* record) {
    const Conventions& rules = world.conventions;
    const Doubles zero(0);
    const bool transparent = !plain && surfaces.transparent, hashed = !plain && surfaces.hashed,
               tracked = !plain && surfaces.tracked;
    const MaterialLanes material(surfaces, h);
    const auto refracts = hit && material.value(k_transmission) > zero;
    auto through = first_lanes<double>(0);
    if (transparent) through = hit && TransparencyLanes(material).is_transparent();
    const auto glass = refracts || through;
    const Doubles a = mirror_of<plain>(world, material, surfaces, h);
    const auto has_secondary = glass || (hit && a > zero);
    if (!any(has_secondary)) return;
    const bool beer = rules.beer > 0;
    const SurfacePoint<Doubles> surface = surface_at(surfaces, h);
    const auto from_inside = refracts && load(surfaces.behind.data() + h) > zero;
    const Vector3<Doubles> weight = load_vector3(surfaces.weight, h);
    SecondaryWeights b = secondary_weights<plain>(world, material, surface, a, refracts, from_inside, weight);
    auto straight = through, bent = first_lanes<double>(0);
    if (transparent && any(through)) {
        weight_straight_rays(world, material, surfaces, h, a, through, weight, b);
        Vector3<Doubles> fade = lanes_of(Vec3{1, 1, 1});
        if (world.uses<&Material::fade_distance>()) {
            fade = fades_at(world, surfaces, h, to_bits(through),
                            left_by_mirror(world, material, surfaces, h, a));
            b.transmitted = select_vector3(through, b.transmitted * fade, b.transmitted);
        }
        if (world.uses<&Material::refracts>()) {
            bent = refract_straight_rays(world, surfaces, h, surface, through, fade, b);
            straight = and_not(through, bent);
        }
    }
    // If plain, none are: queue_secondary_rays() has returned.
    const auto at_limit = plain ? through : are_at_limit(world, surfaces, h);
    const bool back = !plain && sees_back(world) && any(at_limit);
    if (!plain && any(at_limit))
        weight_rays_at_limit(world, material, surfaces, h, a, at_limit, through, weight, b);
    const auto may_start =
        plain || rules.limit == LimitRule::background ? has_secondary : and_not(has_secondary, at_limit);
    const auto kept = [&](Vector3<Doubles> w, LaneMask<double> of) HWY_ATTR {
        const Doubles most = max(max(w.x, w.y), w.z);
        const auto set = of && most > zero && most >= Doubles(rules.min_weight);
        return limited ? limit_rays(surfaces.target.data() + h, set, secondary, counts) : set;
    };
    SecondaryRays rays{surface.point, surface.incoming,
                       b.reflected,   load(surfaces.target.data() + h),
                       zero,          zero,
                       zero,          zero,
                       zero,          zero,
                       zero,          zero};
    const auto start = [&](const SpawnedRay<Doubles>& ray) HWY_ATTR {
        rays.origin = ray.origin;
        rays.direction = ray.direction;
        rays.t_min = Doubles(ray.t_min);
        if (!plain) rays.t_min = select(at_limit, Doubles(k_blind_t_min), rays.t_min);
    };
    if (transparent) {
        rays.level = load(surfaces.level.data() + h) + Doubles(1);
        rays.passed = load(surfaces.passed.data() + h);
    }
    if (tracked) rays.interiors = load(surfaces.interiors.data() + h);
    const Doubles own = beer ? material_numbers(surfaces.material.data() + h) : zero,
                  none(static_cast<double>(k_none));

    const auto reflected = kept(b.reflected, may_start);
    if (any(reflected)) {
        SpawnedRay<Doubles> ray = mirrored_ray(surface, glass, rules);
        if (!plain && world.fault != TracerFault::none)
            ray = faulty_mirror_ray(surface, ray, normal_lengths(world, surfaces, h), world.fault, rules);
        start(ray);
        if (back) go_back(surfaces, h, at_limit, rays);
        if (beer) rays.medium = select(from_inside, own, load(surfaces.medium.data() + h));
        if (hashed) rays.path = child_paths(surfaces, h, false);
        push<plain>(secondary.rays, rays, reflected, surfaces, beer);
        counts.mirror += static_cast<std::uint64_t>(count(reflected));
    }
    const auto transmitted = any(glass) ? kept(b.transmitted, may_start && glass) : glass;
    if (record != nullptr)
        record_secondary_rays(
            world, *record, h,
            {has_secondary, glass, straight, reflected, transmitted, and_not(has_secondary, may_start)},
            b.reflected, b.transmitted, b.fresnel);
    if (!any(transmitted)) return;
    start(spawn_transmitted_ray(surface, b.refracted_direction, rules));
    if (transparent && any(bent)) start_at_surface(world, surface, bent, rays);
    rays.weight = b.transmitted;
    if (surfaces.generation == 0) rays.target = rays.target + Doubles(k_layer_stride);
    if (!plain && surfaces.alpha) rays.straight = load(surfaces.straight.data() + h);
    if (beer) {
        rays.medium = select(from_inside, none, own);
        if (transparent) rays.medium = select(through, load(surfaces.medium.data() + h), rays.medium);
    }
    if (transparent && any(straight)) go_straight(world, surfaces, h, straight, at_limit, rays);
    if (back) go_back(surfaces, h, at_limit, rays);
    if (tracked) rays.interiors = passed_interiors(world, surfaces, h, transmitted);
    if (hashed) rays.path = child_paths(surfaces, h, true);
    push<plain>(secondary.transmitted, rays, transmitted, surfaces, beer);
    counts.transmitted += static_cast<std::uint64_t>(count(transmitted));
}

/// Queues the mirror and glass rays of the surfaces. Each group of rays gives first its mirror rays, then its
/// glass rays, so that coherent rays are traced together and the rays of a pixel keep their order. Touches
/// the layers of the film to which their light will be added.
inline void queue_secondary_rays(const WorldParts& world, const SurfaceBatch& surfaces,
                                 SecondaryRayBatch& secondary, Film& film, RayCounts& counts,
                                 TileRecord* record) {
    if (!surfaces.transparent && world.conventions.limit != LimitRule::background &&
        surfaces.generation >= world.settings.reflections) {
        if (record != nullptr) record_limit(world, surfaces, *record);
        return;
    }
    const bool limited = is_limited(world),
               plain = are_plain(world, surfaces) && world.fault == TracerFault::none;
    int h = 0;
    for (int group = 0; group < surfaces.groups; ++group) {
        const int end = surfaces.group_end[static_cast<std::size_t>(group)].hits;
        secondary.rays.reserve(secondary.rays.count + (end - h));
        secondary.transmitted.reserve(end - h);
        for (; h < end; h += lane_count<double>()) {
            const auto hit = first_lanes<double>(end - h);
            if (plain) {
                queue_vector<true>(world, surfaces, h, hit, limited, secondary, counts, record);
            } else {
                queue_vector<false>(world, surfaces, h, hit, limited, secondary, counts, record);
            }
        }
        h = end;
        secondary.rays.end_group();
        if (surfaces.generation == 0) {
            if (secondary.rays.count > 0) film.touch(Layer::reflection);
            if (secondary.transmitted.count > 0) film.touch(Layer::transmission);
        }
        secondary.rays.append_group(secondary.transmitted);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
