// SPDX-License-Identifier: Apache-2.0
// Nearest-hit and occlusion queries for the caller's rays, with the kernels of the renderer.
#include <algorithm>

#include "base/parallel_for.h"
#include "base/status.h"
#include "glint/world.h"
#include "trace/kernels.h"
#include "world/world.h"

namespace glint {
namespace {

constexpr std::size_t k_rays_at_once = 256;  // rays per task; the columns are on the stack

// Rays as columns, with the padding that the kernels require.
struct RayColumns {
    double columns[8][k_rays_at_once + k_ray_padding] = {};

    explicit RayColumns(std::span<const Ray> rays) {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Ray& r = rays[i];
            const double values[8] = {r.origin.x,    r.origin.y,    r.origin.z, r.direction.x,
                                      r.direction.y, r.direction.z, r.t_min,    r.t_max};
            for (int c = 0; c < 8; ++c) columns[c][i] = values[c];
        }
    }
    RaySpan span() const {
        const auto& c = columns;
        return {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]};
    }
};

// Calls visit(first, rays) for each chunk of the list. first: the index of the chunk's first ray.
template <class Visit> void for_chunks(std::span<const Ray> rays, int threads, const Visit& visit) {
    parallel_for((rays.size() + k_rays_at_once - 1) / k_rays_at_once, threads, [&](std::size_t chunk) {
        const std::size_t first = chunk * k_rays_at_once;
        visit(first, rays.subspan(first, std::min(k_rays_at_once, rays.size() - first)));
    });
}

}  // namespace

Result<std::vector<RayHit>> nearest_hits(const World& world, std::span<const Ray> rays, int threads) {
    return result_of([&]() -> Result<std::vector<RayHit>> {
        const WorldParts& parts = world.parts();
        const PackedGeometry& geometry = *parts.geometry;
        const Kernels& kernels = available_kernels().front();
        std::vector<RayHit> hits(rays.size());
        for_chunks(rays, threads, [&](std::size_t first, std::span<const Ray> some) {
            const RayColumns columns(some);
            double t[k_rays_at_once + k_ray_padding];
            std::uint32_t slot[k_rays_at_once + k_ray_padding], element[k_rays_at_once + k_ray_padding];
            const HitColumns found{t, slot, element};
            kernels.nearest_hit(parts, columns.span(), static_cast<int>(some.size()), k_packet_size, found);
            for (std::size_t i = 0; i < some.size(); ++i) {
                RayHit& hit = hits[first + i];
                hit.t = t[i];
                const SurfaceId id = found.surface(static_cast<int>(i));
                if (!id.exists()) continue;
                hit.shape = geometry.shape_of(id);
                hit.normal = surface_normals(geometry, id, some[i].origin + some[i].direction * t[i]).shading;
            }
        });
        return hits;
    });
}

Result<std::vector<std::uint8_t>> occluded(const World& world, std::span<const Ray> rays, int threads) {
    return result_of([&]() -> Result<std::vector<std::uint8_t>> {
        const Kernels& kernels = available_kernels().front();
        std::vector<std::uint8_t> occlusions(rays.size());
        for_chunks(rays, threads, [&](std::size_t first, std::span<const Ray> some) {
            const RayColumns columns(some);
            std::uint8_t flags[k_rays_at_once + k_ray_padding];
            kernels.any_hit(world.parts(), columns.span(), static_cast<int>(some.size()), k_packet_size,
                            flags);
            std::copy_n(flags, some.size(), occlusions.begin() + static_cast<std::ptrdiff_t>(first));
        });
        return occlusions;
    });
}

}  // namespace glint
