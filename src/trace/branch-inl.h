// Mirrors and glass: how a surface divides the light between itself and the rays that go on, and those rays.
#if defined(GLINT_TRACE_BRANCH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_BRANCH_INL_H_
#undef GLINT_TRACE_BRANCH_INL_H_
#else
#define GLINT_TRACE_BRANCH_INL_H_
#endif

#include "geometry/leave-inl.h"
#include "lighting/glass-inl.h"
#include "lighting/phong-inl.h"
#include "trace/tile.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

HWY_INLINE Color material_color(const double* m, int value) { return {m[value], m[value + 1], m[value + 2]}; }
HWY_INLINE const double* material_of(const World& world, std::uint32_t index) {
    return world.materials.data() + static_cast<std::size_t>(index) * k_material_values;
}

/// What the surface's own light counts for. a: mirror, f: transmission. blend: (1-f)(1-a); add: 1. At the
/// last generation the limit may keep it whole.
HWY_INLINE double local_share(const World& world, const double* material, int generation) {
    const Conventions& rules = world.conventions;
    const bool at_limit = generation >= world.settings.reflections;
    if (rules.mirror == MirrorRule::add || (at_limit && rules.limit == LimitRule::keep)) return 1;
    return (1 - material[k_transmission]) * (1 - material[k_mirror]);
}

/// The two rays that leave a hit, as far as there are any. F is what glass reflects (Fresnel; all of it where
/// no ray gets through).
///   reflected: tint ((1-f) a + f F) with blend, tint (a + f F) with add; transmitted: tint f (1-F).
struct Branches {
    Color reflected{0, 0, 0}, transmitted{0, 0, 0};  // weights
    Triple<double> through;                          // direction of the transmitted ray
};
HWY_INLINE Branches branches_of(const World& world, const double* material, Triple<double> incoming,
                                Triple<double> normal, bool from_inside, Color weight) {
    const Conventions& rules = world.conventions;
    const double a = material[k_mirror], f = material[k_transmission], ior = material[k_ior];
    Branches b;
    double mirror = rules.mirror == MirrorRule::blend ? (1 - f) * a : a, through = 0;
    if (f > 0) {
        const Triple<double> facing = dot(normal, incoming) > 0 ? -normal : normal;
        const auto refraction = refracted(incoming, facing, from_inside ? ior : 1 / ior);
        b.through = refraction.direction;
        double fresnel = 0;
        if (rules.fresnel == Fresnel::schlick)
            fresnel = schlick(-dot(facing, incoming) / length(incoming), ior);
        if (refraction.total) fresnel = 1;
        mirror += f * fresnel;
        through = f * (1 - fresnel);
    }
    b.reflected = weight * mirror * material_color(material, k_mirror_tint);
    b.transmitted = weight * through;
    // Without Beer's law the way through glass is tinted once, where it begins.
    if (!(rules.beer > 0) && !from_inside)
        b.transmitted = b.transmitted * material_color(material, k_transmission_tint);
    return b;
}

/// Queues the mirror and glass rays of the hits: of each group of rays first all reflected, then all
/// transmitted ones, so that rays of one kind walk together and a pixel's keep their order.
inline void queue_branches(const World& world, TileScratch& s, int first, int generation) {
    if (generation >= world.settings.reflections) return;
    const Conventions& rules = world.conventions;
    const double infinity = std::numeric_limits<double>::infinity();
    const auto end_group = [&] {
        s.next_rays.end_group();
        s.next_rays.take_group(s.transmitted_rays);
    };
    const auto counts = [&](Color w, std::uint32_t pixel) {
        const double most = number::max(number::max(w.r, w.g), w.b);
        if (!(most > 0) || !(most >= rules.min_weight)) return false;
        if (s.sample_rays[pixel] >= k_max_sample_rays) {
            ++s.counts.cut;
            return false;
        }
        ++s.sample_rays[pixel];
        return true;
    };
    std::size_t group = s.rays.group_of(first);
    for (int h = 0; h < s.hits; ++h) {
        const double* material = material_of(world, s.material[h]);
        const bool glass = material[k_transmission] > 0;
        if (!(material[k_mirror] > 0) && !glass) continue;
        const int ray = first + s.ray[h];
        for (; ray >= s.rays.group_end(group); ++group) end_group();

        const RayPath& path = s.rays.path(ray);
        const bool behind = s.behind[h] != 0, from_inside = glass && behind;
        const SurfacePoint<double> surface{{s.point[0][h], s.point[1][h], s.point[2][h]},
                                           {s.normal[0][h], s.normal[1][h], s.normal[2][h]},
                                           {s.incoming[0][h], s.incoming[1][h], s.incoming[2][h]},
                                           s.magnitude[h]};
        const Branches b =
            branches_of(world, material, surface.incoming, surface.normal, from_inside, path.weight);
        // Glass has two sides to leave to, whatever the convention does with the one of an opaque surface.
        const Offset offset = glass && rules.offset == Offset::normal ? Offset::facing : rules.offset;
        const double t_min = leave_t_min(offset, rules.epsilon);
        if (counts(b.reflected, path.pixel)) {
            const Triple<double> d = mirrored(-surface.incoming, surface.normal);
            const Triple<double> o = leave(surface, d, offset, rules.epsilon);
            RayPath next = path;
            next.weight = b.reflected;
            if (rules.beer > 0 && from_inside) next.medium = s.material[h];
            if (path.branch == Branch::camera) next.branch = Branch::reflected;
            s.next_rays.push({o.x, o.y, o.z}, {d.x, d.y, d.z}, t_min, infinity, next);
            ++s.counts.mirror;
        }
        if (counts(b.transmitted, path.pixel)) {
            const Triple<double> d = b.through;
            const Triple<double> o = leave_through(surface, d, offset, rules.epsilon);
            RayPath next = path;
            next.weight = b.transmitted;
            if (path.branch == Branch::camera) next.branch = Branch::transmitted;
            next.medium = rules.beer > 0 && !from_inside ? s.material[h] : k_none;
            s.transmitted_rays.push({o.x, o.y, o.z}, {d.x, d.y, d.z}, t_min, infinity, next);
            ++s.counts.transmitted;
        }
    }
    end_group();
}

/// Beer's law: what a ray found in glass counts for, by the way it went there. It went through the glass
/// whose inner side it hits; else through that which it entered. A ray that hits nothing has left through an
/// open surface: nobody knows where.
inline void absorb(const World& world, TileScratch& s, int first) {
    if (!(world.conventions.beer > 0)) return;
    for (int h = 0; h < s.hits; ++h) {
        RayPath& path = s.rays.path(first + s.ray[h]);
        const bool from_inside = s.behind[h] != 0 && material_of(world, s.material[h])[k_transmission] > 0;
        const std::uint32_t medium = from_inside ? s.material[h] : path.medium;
        if (medium == k_none) continue;
        const Color tint = material_color(material_of(world, medium), k_transmission_tint);
        const Triple<double> d{s.incoming[0][h], s.incoming[1][h], s.incoming[2][h]};
        const double way = s.t[s.ray[h]] * length(d), k = world.conventions.beer;
        path.weight = path.weight * Color{beer(tint.r, k, way), beer(tint.g, k, way), beer(tint.b, k, way)};
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
