// SPDX-License-Identifier: Apache-2.0
// The layers of a tile (glint/layers.h): stores the first hits, and writes the layers from them and the film.
#if defined(GLINT_TRACE_LAYERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_LAYERS_INL_H_
#undef GLINT_TRACE_LAYERS_INL_H_
#else
#define GLINT_TRACE_LAYERS_INL_H_
#endif

#include "trace/film/film-inl.h"
#include "trace/lighting/direct_lighting-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Sets the values of pixels without a hit, at the start of a tile.
inline void clear_first_hits(FirstHits& first_hits) {
    const auto clear = [](std::vector<double>& column, double value) { column.assign(k_tile_pixels, value); };
    for (auto* vector : {first_hits.normal, first_hits.position, first_hits.albedo}) {
        for (int c = 0; c < 3; ++c) clear(vector[c], 0);
    }
    for (auto* column : {&first_hits.object, &first_hits.material, &first_hits.tested, &first_hits.occluded,
                         &first_hits.sky_tested, &first_hits.sky_blocked})
        clear(*column, 0);
    clear(first_hits.depth, k_infinity);
}

/// Stores the surfaces of a range of camera rays, by pixel, if this is the middle sample.
inline void store_first_hits(const WorldParts& world, const RayBatch& rays, const HitBatch& hits,
                             RayRange range, const SurfaceBatch& surfaces, FirstHits& first_hits) {
    if (!first_hits.is_middle) return;
    std::size_t h = 0;
    for (int i = range.begin; i < range.end; ++i) {
        const double t = hits.t[static_cast<std::size_t>(i)];
        if (!(t < k_infinity)) continue;
        const auto p = static_cast<std::size_t>(hits.first + i);
        const auto& d = rays.direction;
        const double* material = surfaces.rows + std::size_t{surfaces.row[h]} * k_material_values;
        for (int c = 0; c < 3; ++c) {
            first_hits.normal[c][p] = surfaces.normal[c][h];
            first_hits.position[c][p] = surfaces.point[c][h];
            first_hits.albedo[c][p] = material[k_diffuse + c];
        }
        first_hits.depth[p] = t * length(Vector3<double>{d[0][p], d[1][p], d[2][p]});
        first_hits.object[p] =
            static_cast<double>(world.geometry->shape_of(surfaces.surface(static_cast<int>(h)))) + 1;
        first_hits.material[p] = static_cast<double>(surfaces.material[h]) + 1;
        ++h;
    }
}

/// Adds `by` to a pixel's count for each of its surfaces that the light may light.
inline void count_lit(const SurfaceBatch& surfaces, const LightSampleBatch& samples,
                      std::vector<double>& counts, double by) {
    for (int h = 0; h < surfaces.count; ++h) {
        const std::uint32_t lit = lit_bits(samples, h);
        if ((lit >> (h % lane_count<double>()) & 1) != 0)
            counts[static_cast<std::size_t>(surfaces.target[static_cast<std::size_t>(h)])] += by;
    }
}
/// For the layer `shadow`: counts the lights with a shadow ray to the surface of a camera ray. All count as
/// occluded until apply_shadows() has run; count_unoccluded() then subtracts the others.
inline void count_tested(const SurfaceBatch& surfaces, const LightSampleBatch& samples,
                         FirstHits& first_hits) {
    count_lit(surfaces, samples, first_hits.tested, 1);
    count_lit(surfaces, samples, first_hits.occluded, 1);
}
/// Light that transparent surfaces color is blocked by the mean over its channels.
inline void count_unoccluded(const WorldParts& world, const SurfaceBatch& surfaces,
                             const LightSampleBatch& samples, FirstHits& first_hits) {
    if (!world.colors_shadows()) return count_lit(surfaces, samples, first_hits.occluded, -1);
    for (int h = 0; h < surfaces.count; ++h) {
        const auto at = static_cast<std::size_t>(h);
        if ((lit_bits(samples, h) >> (h % lane_count<double>()) & 1) == 0) continue;
        const double seen = (samples.filter[0][at] + samples.filter[1][at] + samples.filter[2][at]) / 3;
        first_hits.occluded[static_cast<std::size_t>(surfaces.target[at])] -= number::min(seen, 1.0);
    }
}

/// For the layer `occlusion`: counts the samples of the surfaces of camera rays, and those that are blocked.
inline void count_sky(const WorldParts& world, const SurfaceBatch& surfaces, const SkyBatch& sky,
                      FirstHits& first_hits) {
    for (std::size_t h = 0; h < static_cast<std::size_t>(surfaces.count); ++h) {
        const auto p = static_cast<std::size_t>(surfaces.target[h]);
        first_hits.sky_tested[p] += world.occlusion->samples;
        first_hits.sky_blocked[p] += sky.blocked_of(h);
    }
}

/// In place of count_unoccluded(): subtracts the visible part of an area light.
inline void count_visible(const SurfaceBatch& surfaces, const LightSampleBatch& samples,
                          const AreaShadowBatch& shadow, FirstHits& first_hits) {
    for (int h = 0; h < surfaces.count; ++h) {
        const auto at = static_cast<std::size_t>(h);
        if ((lit_bits(samples, h) >> (h % lane_count<double>()) & 1) != 0)
            first_hits.occluded[static_cast<std::size_t>(surfaces.target[at])] -= shadow.fraction[at];
    }
}

/// Value c of a layer at a pixel of the tile.
inline float layer_value(const Film& film, const FirstHits& first_hits, Layer layer, int c, std::size_t p,
                         double samples) {
    switch (layer) {
        case Layer::normal:
            return static_cast<float>(first_hits.normal[c][p]);
        case Layer::position:
            return static_cast<float>(first_hits.position[c][p]);
        case Layer::albedo:
            return static_cast<float>(first_hits.albedo[c][p]);
        case Layer::depth:
            return static_cast<float>(first_hits.depth[p]);
        case Layer::object:
            return static_cast<float>(first_hits.object[p]);
        case Layer::material:
            return static_cast<float>(first_hits.material[p]);
        case Layer::shadow:
            return first_hits.tested[p] > 0
                       ? static_cast<float>(first_hits.occluded[p] / first_hits.tested[p])
                       : 0.0f;
        case Layer::occlusion:
            return first_hits.sky_tested[p] > 0
                       ? static_cast<float>(first_hits.sky_blocked[p] / first_hits.sky_tested[p])
                       : 0.0f;
        case Layer::alpha:
            return alpha_value(film, p, samples);
        default:
            break;
    }
    if (!film.touched[static_cast<std::size_t>(layer)]) return 0;
    // As in resolve().
    const double sum = film.of(layer, c)[p];
    return static_cast<float>(film_value(samples > 1 ? sum / samples : sum));
}

/// Writes the layers of pixels with n x n samples. for_each_pixel calls visit(x, y, p) with the place of each
/// in the tile and its number in the film.
template <class ForEachPixel>
GLINT_SMALL void write_layers(const TileJob& job, const Film& film, const FirstHits& first_hits, int n,
                              const ForEachPixel& for_each_pixel) {
    const double samples = static_cast<double>(n) * n;
    for (const LayerInfo& info : layer_infos()) {
        float* const to = job.layers->of(info.layer);
        if (to == nullptr) continue;
        const auto channels = static_cast<int>(info.channels.size());
        for_each_pixel([&](int x, int y, int p) {
            float* at = pixel_in(to, job.layers->row_pixels, channels, x, y);
            for (int c = 0; c < channels; ++c)
                at[c] = layer_value(film, first_hits, info.layer, c, static_cast<std::size_t>(p), samples);
        });
    }
}
/// The same for all pixels of the tile.
GLINT_SMALL void write_layers(const TileJob& job, const Film& film, const FirstHits& first_hits, int n) {
    write_layers(job, film, first_hits, n, [&](const auto& visit) {
        for_each_row(job, [&](int x, int y, int first, int width) {
            for (int p = 0; p < width; ++p) visit(x + p, y, first + p);
        });
    });
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
