// SPDX-License-Identifier: Apache-2.0
// The hashes of rays (math/sample_hash.h), from which the numbers come that are sampled at their surfaces.
#if defined(GLINT_TRACE_RAY_HASH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_RAY_HASH_INL_H_
#undef GLINT_TRACE_RAY_HASH_INL_H_
#else
#define GLINT_TRACE_RAY_HASH_INL_H_
#endif

#include <algorithm>

#include "simd/sample_hash-inl.h"
#include "trace/rays/camera_rays-inl.h"
#include "trace/tile.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Whether the World samples anything at surfaces.
inline bool needs_hashes(const WorldParts& world) {
    const bool occlusion = world.occlusion && world.occlusion->method == OcclusionMethod::hashed;
    return occlusion ||
           std::any_of(world.lights->begin(), world.lights->end(),
                       [](const PreparedLight& light) { return light.is_area() && light.jitter; });
}

/// Computes the hash of each pixel of the tile, or of the list if there is one: of the words up to the
/// sample.
inline void hash_pixels(const WorldParts& world, const TileJob& job, const PixelList* list,
                        SampleIndex sample, StreamColumn<std::uint32_t>& to) {
    const std::uint32_t seed = seed_hash(world.settings.seed),
                        number = static_cast<std::uint32_t>(sample.number());
    const auto hash = [&](std::uint32_t x, std::uint32_t y)
                          HWY_ATTR { return hash_with(hash_with(hash_with(seed, x), y), number); };
    if (list != nullptr) {
        for (std::size_t p = 0; p < static_cast<std::size_t>(list->count); ++p)
            to[p] = hash(static_cast<std::uint32_t>(list->x[p]), static_cast<std::uint32_t>(list->y[p]));
        return;
    }
    for_each_row(job, [&](int x, int y, int first, int width) HWY_ATTR {
        for (int i = 0; i < width; ++i)
            to[static_cast<std::size_t>(first + i)] =
                hash(static_cast<std::uint32_t>(job.x + x + i), static_cast<std::uint32_t>(job.y + y));
    });
}

/// Computes the hashes of the rays that hit the surfaces, from their paths.
inline void hash_rays(const StreamColumn<std::uint32_t>& pixel_hash, SurfaceBatch& surfaces) {
    for (std::size_t h = 0; h < static_cast<std::size_t>(surfaces.count); ++h) {
        const auto pixel = static_cast<std::size_t>(surfaces.target[h]) % std::size_t{k_layer_stride};
        surfaces.hash[h] = hash_with(pixel_hash[pixel], static_cast<std::uint32_t>(surfaces.path[h]));
    }
}

/// The paths of the mirror rays, or the transmitted rays, of a vector of surfaces.
HWY_INLINE Doubles child_paths(const SurfaceBatch& surfaces, int h, bool transmitted) {
    const Words doubled = to_words(load(surfaces.path.data() + h)) * 2u;
    return to_doubles(lowbias32(doubled ^ (transmitted ? 1u : 0u)));
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
