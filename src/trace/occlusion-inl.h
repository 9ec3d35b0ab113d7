// SPDX-License-Identifier: Apache-2.0
// Light from all directions (Occlusion of glint/scene.h): the part that arrives at the surfaces, by any-hit
// rays, and what the surfaces reflect of it. All surfaces of a batch trace the rays of one sample together.
#if defined(GLINT_TRACE_OCCLUSION_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_OCCLUSION_INL_H_
#undef GLINT_TRACE_OCCLUSION_INL_H_
#else
#define GLINT_TRACE_OCCLUSION_INL_H_
#endif

#include <algorithm>

#include "simd/elementary-inl.h"
#include "simd/sample_hash-inl.h"
#include "trace/intersect-inl.h"
#include "trace/material-inl.h"
#include "trace/surface-inl.h"
#include "world/prepare_sky.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The grid of cells, rows x columns = samples, in which hashed directions are: rows is the largest divisor
/// of the number of samples that is at most its square root.
struct SampleGrid {
    int rows, columns;
    HWY_INLINE explicit SampleGrid(int samples) : rows(1), columns(samples) {
        for (int r = 2; r * r <= samples; ++r) {
            if (samples % r == 0) rows = r, columns = samples / r;
        }
    }
};

/// The direction of hashed sample number `sample` in the hemisphere of N: N plus a point of the unit sphere
/// in the sample's cell, which is distributed in proportion to the cosine.
HWY_INLINE Vector3<Doubles> hashed_direction(Words ray_hash, SampleGrid grid, int sample,
                                             Vector3<Doubles> normal) {
    const Words own = hash_with(hash_with(ray_hash, Words(purpose_word(SamplePurpose::occlusion, 0))),
                                Words(static_cast<std::uint32_t>(sample)));
    const Doubles u = unit_number(hash_with(own, Words(0u))), v = unit_number(hash_with(own, Words(1u)));
    const Doubles row(static_cast<double>(sample / grid.columns)),
        column(static_cast<double>(sample % grid.columns));
    const Doubles z = Doubles(1) - (row + u) * Doubles(2.0 / grid.rows);
    const Doubles angle = (column + v) * Doubles(360.0 / grid.columns);
    const Doubles radius = sqrt(max(Doubles(1) - z * z, Doubles(0)));
    const Vector3<Doubles> d =
        normal + Vector3<Doubles>{radius * cos_degrees(angle), radius * sin_degrees(angle), z};
    // Opposite to N, within rounding.
    return select_vector3(dot(d, d) < Doubles(1e-12), normal, d);
}

/// Starts the samples of the surfaces.
inline void sort_surfaces(const SurfaceBatch& surfaces, SkyBatch& to) {
    to.count = surfaces.count;
    const auto count = static_cast<std::size_t>(surfaces.count);
    for (std::size_t h = 0; h < count; ++h) to.order[h] = static_cast<std::uint32_t>(h);
    std::sort(to.order.begin(), to.order.begin() + surfaces.count, [&](std::uint32_t a, std::uint32_t b) {
        return surfaces.slot[a] != surfaces.slot[b] ? surfaces.slot[a] < surfaces.slot[b] : a < b;
    });
    const auto copy = [&](const BatchColumn<double>& from, BatchColumn<double>& column) {
        for (std::size_t i = 0; i < count; ++i) column[i] = from[to.order[i]];
    };
    for (int c = 0; c < 3; ++c) {
        copy(surfaces.point[c], to.point[c]);
        copy(surfaces.normal[c], to.normal[c]);
        copy(surfaces.incoming[c], to.incoming[c]);
    }
    copy(surfaces.magnitude, to.magnitude);
    if (surfaces.hashed) copy(surfaces.hash, to.hash);
    std::fill_n(to.arrived.begin(), count, 0.0);
    std::fill_n(to.blocked.begin(), count, 0.0);
}

/// The rays of a vector of entries for one sample, to be stored by store_sky_rays().
struct SkyRays {
    Vector3<Doubles> direction;
    Doubles cosine;
};
HWY_INLINE SkyRays sky_rays(const SkyBatch& sky, SampleGrid grid, const Vec3* fixed, int sample, int i) {
    const Vector3<Doubles> normal = load_vector3(sky.normal, i);
    if (fixed == nullptr) {
        const Words hash = to_words(load(sky.hash.data() + i));
        return {normalize(hashed_direction(hash, grid, sample, normal)), Doubles(1)};
    }
    const Vector3<Doubles> direction = lanes_of(fixed[sample]);
    const Doubles n_d = dot(normal, direction);
    const auto below = n_d < Doubles(0);
    return {select_vector3(below, -direction, direction), select(below, -n_d, n_d)};
}

/// Stores the rays of the lanes in `set` from entry `at` on. Returns their number.
HWY_INLINE int store_sky_rays(const WorldParts& world, SkyBatch& sky, const SkyRays& made, int i,
                              LaneMask<double> set, ShadowRayBatch& rays, int at) {
    const Conventions& rules = world.conventions;
    const SurfacePoint<Doubles> surface{load_vector3(sky.point, i), load_vector3(sky.normal, i),
                                        load_vector3(sky.incoming, i), load(sky.magnitude.data() + i)};
    const Vector3<Doubles> origin = offset_ray_origin(surface, made.direction, rules.offset, rules.epsilon);
    compress_vector3(origin, set, rays.origin, at);
    compress_vector3(made.direction, set, rays.direction, at);
    store(Doubles(offset_t_min(rules.offset, rules.epsilon)), rays.t_min.data() + at);
    store(Doubles(world.occlusion->reach), rays.t_max.data() + at);
    compress_store(Doubles(static_cast<double>(i)) + iota(), set, sky.entry.data() + at);
    compress_store(made.cosine, set, sky.cosine.data() + at);
    return count(set);
}

/// Makes the rays of one sample. Fixed directions: first those with the direction itself, then those with its
/// opposite, so that the packets are coherent.
inline void make_sky_rays(const WorldParts& world, SampleGrid grid, const Vec3* fixed, int sample,
                          SkyBatch& sky, ShadowRayBatch& rays) {
    rays.count = 0;
    for (int side = 0; side < (fixed == nullptr ? 1 : 2); ++side) {
        for (int i = 0; i < sky.count; i += lane_count<double>()) {
            auto set = first_lanes<double>(sky.count - i);
            if (fixed != nullptr) {
                const auto below = dot(load_vector3(sky.normal, i), lanes_of(fixed[sample])) < Doubles(0);
                set = set && (side == 0 ? !below : below);
                if (!any(set)) continue;
            }
            rays.count +=
                store_sky_rays(world, sky, sky_rays(sky, grid, fixed, sample, i), i, set, rays, rays.count);
        }
    }
}

/// Adds one sample to the sums. The order of the samples is fixed.
inline void add_sky_sample(const ShadowRayBatch& rays, SkyBatch& sky) {
    for (std::size_t r = 0; r < static_cast<std::size_t>(rays.count); ++r) {
        const auto i = static_cast<std::size_t>(sky.entry[r]);
        const double blocked = rays.occluded[r];
        sky.arrived[i] += sky.cosine[r] * (1 - blocked);
        sky.blocked[i] += blocked;
    }
}

/// Puts the sums into the order of the surfaces.
inline void unsort_sky(SkyBatch& sky) {
    const auto count = static_cast<std::size_t>(sky.count);
    for (BatchColumn<double>* sums : {&sky.arrived, &sky.blocked}) {
        std::copy_n(sums->begin(), count, sky.cosine.begin());
        for (std::size_t i = 0; i < count; ++i) (*sums)[sky.order[i]] = sky.cosine[i];
    }
}

/// The block of fixed directions of a batch. In Tachyon, each further surface of a pixel takes the next ones.
inline const Vec3* fixed_block(const WorldParts& world, const SurfaceBatch& surfaces, int pixel_sample) {
    if (world.occlusion->method != OcclusionMethod::fixed) return nullptr;
    const int block = (pixel_sample + surfaces.generation) % k_occlusion_blocks;
    return world.occlusion_directions->data() +
           static_cast<std::size_t>(block) * static_cast<std::size_t>(world.occlusion->samples);
}

/// f of a vector of surfaces.
HWY_INLINE Doubles sky_factor(const Occlusion& occlusion, const SkyBatch& sky, int h) {
    const double scale = occlusion.method == OcclusionMethod::fixed ? 2 : 1;
    return load(sky.arrived.data() + h) * Doubles(scale / occlusion.samples);
}

/// k_d color f.
inline void add_sky(const WorldParts& world, const SurfaceBatch& surfaces, const SkyBatch& sky,
                    RadianceBatch& radiance) {
    for (int h = 0; h < surfaces.count; h += lane_count<double>()) {
        const MaterialLanes material(surfaces, h);
        store_vector3(material.color(k_diffuse) * lanes_of(world.occlusion->color) *
                          sky_factor(*world.occlusion, sky, h),
                      radiance.sky, h);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
