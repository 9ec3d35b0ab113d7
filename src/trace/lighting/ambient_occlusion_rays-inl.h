// SPDX-License-Identifier: Apache-2.0
// The rays of the light from all directions: their directions, and the order in which they are traced. With
// fixed directions, all surfaces of a block trace the rays of one sample together. Hashed directions differ
// from surface to surface, so the rays of many samples are sorted by direction first.
#if defined(GLINT_TRACE_AMBIENT_OCCLUSION_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_AMBIENT_OCCLUSION_RAYS_INL_H_
#undef GLINT_TRACE_AMBIENT_OCCLUSION_RAYS_INL_H_
#else
#define GLINT_TRACE_AMBIENT_OCCLUSION_RAYS_INL_H_
#endif

#include <algorithm>
#include <array>

#include "simd/elementary-inl.h"
#include "simd/sample_hash-inl.h"
#include "trace/hits/intersect-inl.h"
#include "trace/surface/surface-inl.h"
#include "world/appearance/prepare_sky.h"

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

/// Rays from a vector of surfaces. column(c): the vector of that column of SkyBatch::surface.
template <class Column>
HWY_INLINE SpawnedRay<Doubles> sky_ray(const WorldParts& world, const Column& column,
                                       const Vector3<Doubles>& direction) {
    const SurfacePoint<Doubles> surface{{column(0), column(1), column(2)},
                                        {column(3), column(4), column(5)},
                                        {column(6), column(7), column(8)},
                                        column(9)};
    return spawn_ray(surface, direction, world.conventions);
}

/// The block of fixed directions of a generation. In Tachyon, each further surface of a pixel takes the next
/// ones.
inline const Vec3* fixed_block(const WorldParts& world, int generation, int pixel_sample) {
    const int block = (pixel_sample + generation) % k_occlusion_blocks;
    return world.occlusion_directions->data() +
           static_cast<std::size_t>(block) * static_cast<std::size_t>(world.occlusion->samples);
}

/// Sets the limits of all rays.
inline void set_sky_limits(const WorldParts& world, double t_min, ShadowRayBatch& rays) {
    std::fill_n(rays.t_min.begin(), rays.count, t_min);
    std::fill_n(rays.t_max.begin(), rays.count, world.occlusion->reach);
}

/// Makes the rays of one fixed direction for entries [begin, end): first those with the direction itself,
/// then those with its opposite, so that the packets are coherent.
inline void make_fixed_rays(const WorldParts& world, Vec3 fixed, int begin, int end, SkyBatch& sky,
                            ShadowRayBatch& rays) {
    rays.count = 0;
    double t_min = 0;  // the same for all rays
    const Vector3<Doubles> ahead = lanes_of(fixed);
    for (int side = 0; side < 2; ++side) {
        const Vector3<Doubles> direction = side == 0 ? ahead : -ahead;
        for (int i = begin; i < end; i += lane_count<double>()) {
            const Doubles n_d = dot(load_vector3(sky.surface + SkyBatch::k_normal, i), ahead);
            const auto below = n_d < Doubles(0);
            const auto set = first_lanes<double>(end - i) && (side == 0 ? !below : below);
            if (!any(set)) continue;
            const int at = rays.count;
            const auto column = [&](std::size_t c) HWY_ATTR { return load(sky.surface[c].data() + i); };
            const SpawnedRay<Doubles> ray = sky_ray(world, column, direction);
            t_min = ray.t_min;
            compress_vector3(ray.origin, set, rays.origin, at);
            store_vector3(ray.direction, rays.direction, at);
            compress_store(Doubles(static_cast<double>(i)) + iota(), set, sky.entry.data() + at);
            compress_store(select(below, -n_d, n_d), set, sky.cosine.data() + at);
            rays.count += count(set);
        }
    }
    set_sky_limits(world, t_min, rays);
}

/// The cell of a vector of directions, 0 to k_sky_cells - 1: a grid over the octahedron that is unfolded to a
/// square.
HWY_INLINE Doubles direction_cell(const Vector3<Doubles>& d) {
    const Doubles zero(0), one(1), last(k_sky_cell_rows - 1);
    const Doubles inverse = one / (abs(d.x) + abs(d.y) + abs(d.z));
    const Doubles x = d.x * inverse, y = d.y * inverse;
    const auto below = d.z < zero;
    const Doubles u = select(below, with_sign_of(one - abs(y), x), x),
                  v = select(below, with_sign_of(one - abs(x), y), y);
    const Doubles half = last * Doubles(0.5);
    const Doubles cell =
        round_to_integer(u * half + half) + round_to_integer(v * half + half) * Doubles(k_sky_cell_rows);
    // Not a number: any cell.
    return select(cell >= zero && cell < Doubles(k_sky_cells), cell, zero);
}

/// Positions of the cells along a curve on which neighbours are near each other.
struct CellOrder {
    std::array<std::uint8_t, k_sky_cells> position{};
    constexpr CellOrder() {
        for (int cell = 0; cell < k_sky_cells; ++cell) {
            int place = 0;
            for (int bit = 0; (1 << bit) < k_sky_cell_rows; ++bit) {
                place |= (cell % k_sky_cell_rows >> bit & 1) << (2 * bit);
                place |= (cell / k_sky_cell_rows >> bit & 1) << (2 * bit + 1);
            }
            position[static_cast<std::size_t>(cell)] = static_cast<std::uint8_t>(place);
        }
    }
};
inline constexpr CellOrder k_cell_order;

/// Makes the directions of hashed samples [first, end), at most k_sky_group_samples, of the block of `block`
/// entries from `begin` on, and sorts them by direction; those of a cell by entry.
inline void make_hashed_rays(SampleGrid grid, int first, int end, int begin, int block, const SkyBatch& sky,
                             SkyGroup& group) {
    group.start();
    const auto entries = static_cast<std::size_t>(block);
    for (int sample = first; sample < end; ++sample) {
        const std::size_t row = static_cast<std::size_t>(sample - first) * k_batch_size;
        for (int i = 0; i < block; i += lane_count<double>()) {
            const Vector3<Doubles> direction =
                normalize(hashed_direction(to_words(load(sky.hash.data() + begin + i)), grid, sample,
                                           load_vector3(sky.surface + SkyBatch::k_normal, begin + i)));
            alignas(64) double cells[lane_count<double>()];
            store(direction_cell(direction), cells);
            const std::size_t at = row + static_cast<std::size_t>(i);
            store(direction.x, group.direction[0].data() + at);
            store(direction.y, group.direction[1].data() + at);
            store(direction.z, group.direction[2].data() + at);
            const auto lanes = static_cast<std::size_t>(number::min(lane_count<double>(), block - i));
            for (std::size_t k = 0; k < lanes; ++k)
                group.cell[at + k] = k_cell_order.position[static_cast<std::size_t>(cells[k])];
        }
        for (std::size_t i = 0; i < entries; ++i) ++group.end[group.cell[row + i]];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& end_of_cell : group.end) end_of_cell = sum += end_of_cell;
    group.count = static_cast<int>(sum);
    for (std::size_t i = entries; i-- > 0;) {
        for (int sample = end; sample-- > first;) {
            const std::size_t at = static_cast<std::size_t>(sample - first) * k_batch_size + i;
            group.sorted[--group.end[group.cell[at]]] = static_cast<std::uint32_t>(at);
        }
    }
}

/// Copies the rays of a group from place `first` on, at most k_batch_size. begin: the block's first entry.
inline void take_hashed_rays(const WorldParts& world, const SkyGroup& group, int first, int begin,
                             SkyBatch& sky, ShadowRayBatch& rays) {
    rays.count = number::min(k_batch_size, group.count - first);
    double t_min = 0;  // the same for all rays
    for (int r = 0; r < rays.count; r += lane_count<double>()) {
        const std::uint32_t* const sorted = group.sorted.data() + first + r;
        std::uint32_t entries[lane_count<double>()];
        for (int k = 0; k < lane_count<double>(); ++k) {
            entries[k] = static_cast<std::uint32_t>(begin) + sorted[k] % k_batch_size;
            sky.entry[static_cast<std::size_t>(r + k)] = static_cast<double>(entries[k]);
        }
        const GatherIndices from_group(sorted), from_sky(entries);
        const Vector3<Doubles> direction{gather(group.direction[0].data(), from_group),
                                         gather(group.direction[1].data(), from_group),
                                         gather(group.direction[2].data(), from_group)};
        const auto column = [&](std::size_t c) HWY_ATTR { return gather(sky.surface[c].data(), from_sky); };
        const SpawnedRay<Doubles> ray = sky_ray(world, column, direction);
        t_min = ray.t_min;
        store_vector3(ray.origin, rays.origin, r);
        store_vector3(ray.direction, rays.direction, r);
    }
    std::fill_n(sky.cosine.begin(), rays.count, 1.0);
    set_sky_limits(world, t_min, rays);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
