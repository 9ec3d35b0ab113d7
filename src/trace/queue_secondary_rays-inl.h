// SPDX-License-Identifier: Apache-2.0
// The rays that leave a hit: mirrored, and through glass. Each carries on with its path's weight times what
// it counts for (docs/lighting.md: a recursion unrolled into a sum).
#if defined(GLINT_TRACE_QUEUE_SECONDARY_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_QUEUE_SECONDARY_RAYS_INL_H_
#undef GLINT_TRACE_QUEUE_SECONDARY_RAYS_INL_H_
#else
#define GLINT_TRACE_QUEUE_SECONDARY_RAYS_INL_H_
#endif

#include "trace/direct_lighting-inl.h"
#include "trace/record-inl.h"
#include "trace/secondary_rays-inl.h"
#include "trace/surface-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The two rays that leave a hit, as far as there are any. F is what glass reflects.
///   reflected: tint ((1-f) a + f F) with blend, tint (a + f F) with add; transmitted: tint f (1-F).
struct SecondaryWeights {
    Triple<Doubles> reflected, transmitted;  // weights
    Triple<Doubles> refracted_direction;     // direction of the transmitted ray
    Doubles fresnel;                         // F
};
HWY_INLINE SecondaryWeights secondary_weights(const WorldParts& world, const MaterialLanes& material,
                                              const SurfacePoint<Doubles>& surface, LaneMask<double> glass,
                                              LaneMask<double> from_inside, Triple<Doubles> weight) {
    const Conventions& rules = world.conventions;
    const Doubles a = material.value(k_mirror), f = material.value(k_transmission), one(1);
    SecondaryWeights b{weight, weight, weight, Doubles(0)};
    Doubles mirror = rules.mirror == MirrorRule::blend ? (one - f) * a : a;
    if (any(glass)) {  // otherwise nothing is asked of the transmitted ray
        const Doubles ior = material.value(k_ior);
        const RefractedRay<Doubles> ray = refracted_ray(surface, from_inside, ior, rules);
        const Doubles fresnel = ray.fresnel;
        b.refracted_direction = ray.direction;
        b.fresnel = fresnel;
        mirror = select(glass, mirror + f * fresnel, mirror);
        b.transmitted = weight * select(glass, f * (one - fresnel), Doubles(0));
        // Without Beer's law the way through glass is tinted once, where it begins.
        if (!(rules.beer > 0)) {
            const Triple<Doubles> tinted = b.transmitted * material.color(k_transmission_tint);
            b.transmitted = select_triple(from_inside, b.transmitted, tinted);
        }
    }
    b.reflected = weight * mirror * material.color(k_mirror_tint);
    return b;
}

/// Rays of hits [h, h + lanes) as a queue takes them.
struct SecondaryRays {
    Triple<Doubles> origin, direction, weight;
    Doubles target, medium;
    double t_min;
};
HWY_INLINE void push(RayQueue& queue, const SecondaryRays& rays, LaneMask<double> set, bool medium) {
    double* at[k_ray_columns];
    for (int c = 0; c < k_ray_columns; ++c) at[c] = queue.column(c) + queue.size();
    compress_triple(rays.origin, set, at + k_ray_origin, 0);
    compress_triple(rays.direction, set, at + k_ray_direction, 0);
    compress_triple(rays.weight, set, at + k_ray_weight, 0);
    compress_store(rays.target, set, at[k_ray_target]);
    if (medium) compress_store(rays.medium, set, at[k_ray_medium]);
    store(Doubles(rays.t_min), at[k_ray_t_min]);
    store(Doubles(k_infinity), at[k_ray_t_max]);
    queue.grow(count(set));
}

/// Whether a sample of a pixel could come to k_max_sample_rays at all: rays double at most from one
/// generation to the next.
HWY_INLINE bool is_limited(const WorldParts& world) {
    const int generations = world.settings.reflections;
    return generations > 30 || (2 << generations) - 2 > k_max_sample_rays;
}

/// Of the set rays, those that a sample of their pixel may still have. Counts them.
inline LaneMask<double> limit_rays(TileScratch& s, const double* targets, LaneMask<double> set) {
    std::uint32_t kept = 0;
    for (std::uint32_t bits = to_bits(set); bits != 0; bits &= bits - 1) {
        const int target = static_cast<int>(targets[__builtin_ctz(bits)]);
        std::int32_t& rays = s.sample_rays[static_cast<std::size_t>(target % k_layer_stride)];
        if (rays >= k_max_sample_rays) {
            ++s.counts.cut;
        } else {
            ++rays;
            kept |= bits & (0 - bits);
        }
    }
    return from_bits<double>(kept);
}

/// The material's number in each lane, as a queue keeps it.
HWY_INLINE Doubles material_numbers(const std::uint32_t* material) {
    alignas(64) double lanes[lane_count<double>()];
    for (int k = 0; k < lane_count<double>(); ++k) lanes[k] = static_cast<double>(material[k]);
    return load(lanes);
}

/// Queues the mirror and glass rays of a vector of hits.
HWY_INLINE void queue_hit_vector(const WorldParts& world, TileScratch& s, int h, LaneMask<double> hit,
                                 int generation, bool limited) {
    const Conventions& rules = world.conventions;
    const Doubles zero(0);
    const MaterialLanes material(world, s.material.data() + h);
    const auto glass = hit && material.value(k_transmission) > zero;
    const auto has_secondary = glass || (hit && material.value(k_mirror) > zero);
    if (!any(has_secondary)) return;
    const bool beer = rules.beer > 0;
    const SurfacePoint<Doubles> surface = surface_at(s, h);
    const auto from_inside = glass && load(s.behind.data() + h) > zero;
    const SecondaryWeights b =
        secondary_weights(world, material, surface, glass, from_inside, load_triple(s.weight, h));
    const auto counts = [&](Triple<Doubles> w) HWY_ATTR {
        const Doubles most = max(max(w.x, w.y), w.z);
        const auto kept = has_secondary && most > zero && most >= Doubles(rules.min_weight);
        return limited ? limit_rays(s, s.target.data() + h, kept) : kept;
    };
    SecondaryRays rays{surface.point, surface.incoming,
                       b.reflected,   load(s.target.data() + h),
                       zero,          offset_t_min(rules.offset, rules.epsilon)};
    const Doubles own = beer ? material_numbers(s.material.data() + h) : zero,
                  none(static_cast<double>(k_none));

    const auto reflected = counts(b.reflected);
    if (any(reflected)) {
        const SecondaryRay<Doubles> ray = mirrored_ray(surface, glass, rules);
        rays.direction = ray.direction;
        rays.origin = ray.origin;
        if (beer) rays.medium = select(from_inside, own, load(s.medium.data() + h));
        push(s.next_rays, rays, reflected, beer);
        s.counts.mirror += static_cast<std::uint64_t>(count(reflected));
    }
    const auto transmitted = any(glass) ? counts(b.transmitted) && glass : glass;
    if (s.record != nullptr)
        record_secondary_rays(s, h, {has_secondary, glass, reflected, transmitted}, b.reflected,
                              b.transmitted, b.fresnel, rules.min_weight);
    if (!any(transmitted)) return;
    rays.direction = b.refracted_direction;
    rays.origin = offset_transmitted_origin(surface, rays.direction, rules.offset, rules.epsilon);
    rays.weight = b.transmitted;
    if (generation == 0) rays.target = rays.target + Doubles(k_layer_stride);
    if (beer) rays.medium = select(from_inside, none, own);
    push(s.transmitted_rays, rays, transmitted, beer);
    s.counts.transmitted += static_cast<std::uint64_t>(count(transmitted));
}

/// Queues the mirror and glass rays of the hits: of each group of rays first all reflected, then all
/// transmitted ones, so that rays of one kind walk together and a pixel's keep their order.
inline void queue_secondary_rays(const WorldParts& world, TileScratch& s, int generation) {
    if (generation >= world.settings.reflections) {
        if (s.record != nullptr) record_limit(world, s);
        return;
    }
    const bool limited = is_limited(world);
    int h = 0;
    for (int group = 0; group < s.groups; ++group) {
        const int end = s.group_end[static_cast<std::size_t>(group)].hits;
        s.next_rays.reserve(s.next_rays.size() + (end - h));
        s.transmitted_rays.reserve(end - h);
        for (; h < end; h += lane_count<double>()) {
            queue_hit_vector(world, s, h, first_lanes<double>(end - h), generation, limited);
        }
        h = end;
        s.next_rays.end_group();
        if (generation == 0 && s.next_rays.size() > 0) s.film.touch(Layer::reflection);
        if (generation == 0 && s.transmitted_rays.size() > 0) s.film.touch(Layer::transmission);
        s.next_rays.append_group(s.transmitted_rays);
    }
}

/// Beer's law: what a ray found in glass counts for, by the way it went there. It went through the glass
/// whose inner side it hits; else through that which it entered. A ray that hits nothing has left through an
/// open surface: nobody knows where.
inline void apply_beer_law(const WorldParts& world, TileScratch& s) {
    const double k = world.conventions.beer;
    if (!(k > 0)) return;
    const auto value = [&](std::uint32_t material, int which) { return world.material(material)[which]; };
    for (int i = 0; i < s.hits; ++i) {
        const auto h = static_cast<std::size_t>(i);
        const bool from_inside = s.behind[h] > 0 && value(s.material[h], k_transmission) > 0;
        const std::uint32_t medium = from_inside ? s.material[h] : static_cast<std::uint32_t>(s.medium[h]);
        if (medium == k_none) continue;
        const Triple<double> d{s.incoming[0][h], s.incoming[1][h], s.incoming[2][h]};
        const double way = s.hit_t[h] * length(d);
        for (int c = 0; c < 3; ++c) s.weight[c][h] *= beer(value(medium, k_transmission_tint + c), k, way);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
