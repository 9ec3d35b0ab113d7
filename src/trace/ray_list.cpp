// SPDX-License-Identifier: Apache-2.0
#include "trace/ray_list.h"

#include <algorithm>
#include <numeric>

#include "base/parallel_for.h"
#include "trace/kernels.h"
#include "world/appearance/appearance.h"

namespace glint {
namespace {

constexpr std::size_t k_chunk = 4096;  // rays per task

}  // namespace

void RayList::add(Vec3 o, Vec3 d, double t_min, double t_max) {
    const double values[8] = {o.x, o.y, o.z, d.x, d.y, d.z, t_min, t_max};
    for (int c = 0; c < 8; ++c) {
        columns_[c][columns_[c].size() - k_ray_padding] = values[c];
        columns_[c].push_back(0);
    }
}

RaySpan RayList::from(std::size_t i) const {
    return {columns_[0].data() + i, columns_[1].data() + i, columns_[2].data() + i, columns_[3].data() + i,
            columns_[4].data() + i, columns_[5].data() + i, columns_[6].data() + i, columns_[7].data() + i};
}

HitList nearest_hits(const WorldParts& world, const RayList& rays, int threads) {
    const Kernels& kernels = available_kernels().front();
    HitList hits{std::vector<double>(rays.size()), std::vector<SurfaceId>(rays.size())};
    parallel_for((rays.size() + k_chunk - 1) / k_chunk, threads, [&](std::size_t chunk) {
        // The kernels write whole vectors: results of one chunk must not overwrite those of the next.
        double t[k_chunk + k_ray_padding];
        std::uint32_t slot[k_chunk + k_ray_padding], element[k_chunk + k_ray_padding];
        const HitColumns columns{t, slot, element};
        const std::size_t first = chunk * k_chunk, count = std::min(k_chunk, rays.size() - first);
        kernels.nearest_hit(world, rays.from(first), static_cast<int>(count), k_packet_size, columns);
        std::copy_n(t, count, hits.t.begin() + static_cast<std::ptrdiff_t>(first));
        for (std::size_t i = 0; i < count; ++i)
            hits.surface[first + i] = columns.surface(static_cast<int>(i));
    });
    return hits;
}

namespace {

// The nearest hits behind those of which passes(ray, surface, t) is true.
template <class Passes>
HitList hits_behind(const WorldParts& world, const RayList& rays, int threads, const Passes& passes) {
    HitList hits = nearest_hits(world, rays, threads);
    std::vector<std::size_t> numbers(rays.size());
    std::iota(numbers.begin(), numbers.end(), std::size_t{0});
    for (;;) {
        RayList on;
        std::vector<std::size_t> left;
        for (const std::size_t i : numbers) {
            if (!hits.surface[i].exists() || !passes(i, hits.surface[i], hits.t[i])) continue;
            on.add(rays.origin(i), rays.direction(i), hits.t[i], rays.t_max(i));
            left.push_back(i);
        }
        if (left.empty()) return hits;
        numbers = std::move(left);
        const HitList next = nearest_hits(world, on, threads);
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            hits.t[numbers[k]] = next.t[k];
            hits.surface[numbers[k]] = next.surface[k];
        }
    }
}

}  // namespace

HitList nearest_occluders(const WorldParts& world, const RayList& rays, int threads) {
    return hits_behind(world, rays, threads, [&](std::size_t i, SurfaceId id, double t) {
        return !blocks_light(world, id, rays.origin(i) + rays.direction(i) * t);
    });
}

HitList nearest_surfaces(const WorldParts& world, const RayList& rays, int threads, const VisitHole& visit) {
    if (!world.has_holes) return nearest_hits(world, rays, threads);
    return hits_behind(world, rays, threads, [&](std::size_t i, SurfaceId id, double t) {
        if (!is_hole(world, id, rays.origin(i) + rays.direction(i) * t, rays.direction(i))) return false;
        if (visit) visit(i, id, t);
        return true;
    });
}

}  // namespace glint
