// SPDX-License-Identifier: Apache-2.0
// The layers of a tile (glint/layers.h): what is noted of the first surfaces, and what the film gets.
#if defined(GLINT_TRACE_LAYERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_LAYERS_INL_H_
#undef GLINT_TRACE_LAYERS_INL_H_
#else
#define GLINT_TRACE_LAYERS_INL_H_
#endif

#include "trace/pixel_sums-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Begins a tile: nothing is seen yet.
inline void clear_seen(SeenSurfaces& seen) {
    const auto clear = [](std::vector<double>& column, double value) { column.assign(k_tile_pixels, value); };
    for (auto* triple : {seen.normal, seen.position, seen.albedo}) {
        for (int c = 0; c < 3; ++c) clear(triple[c], 0);
    }
    for (auto* column : {&seen.object, &seen.material, &seen.asked, &seen.blocked}) clear(*column, 0);
    clear(seen.depth, k_infinity);
}

/// Notes the surfaces of camera rays [from, to) of the stream: after find_surfaces.
inline void see_surfaces(const WorldParts& world, TileScratch& s, int first, int from, int to) {
    SeenSurfaces& seen = s.seen;
    if (!seen.is_middle) return;
    std::size_t h = 0;
    for (int i = from; i < to; ++i) {
        const double t = s.t[static_cast<std::size_t>(i)];
        if (!(t < k_infinity)) continue;
        const auto p = static_cast<std::size_t>(first + i);
        const auto direction = [&](int c) { return s.rays.column(k_ray_direction + c)[p]; };
        const double* material = world.material(s.material[h]);
        for (int c = 0; c < 3; ++c) {
            seen.normal[c][p] = s.normal[c][h];
            seen.position[c][p] = s.point[c][h];
            seen.albedo[c][p] = material[k_diffuse + c];
        }
        seen.depth[p] = t * length(Triple<double>{direction(0), direction(1), direction(2)});
        seen.object[p] = static_cast<double>(world.geometry->shape_index[s.hit_slot[h]]) + 1;
        seen.material[p] = static_cast<double>(s.material[h]) + 1;
        ++h;
    }
}

/// Counts the lights that may add something at the camera rays' hits: before their shadows are taken, and
/// those that still do after.
inline void count_lit(const TileScratch& s, std::vector<double>& counts, double by) {
    for (int h = 0; h < s.hits; ++h) {
        const std::uint32_t lit = s.lit[static_cast<std::size_t>(h / lane_count<double>())];
        if ((lit >> (h % lane_count<double>()) & 1) != 0)
            counts[static_cast<std::size_t>(s.target[static_cast<std::size_t>(h)])] += by;
    }
}

/// Value c of a layer at a pixel of the tile.
inline float layer_value(const TileScratch& s, Layer layer, int c, std::size_t p, double samples) {
    const SeenSurfaces& seen = s.seen;
    switch (layer) {
        case Layer::normal:
            return static_cast<float>(seen.normal[c][p]);
        case Layer::position:
            return static_cast<float>(seen.position[c][p]);
        case Layer::albedo:
            return static_cast<float>(seen.albedo[c][p]);
        case Layer::depth:
            return static_cast<float>(seen.depth[p]);
        case Layer::object:
            return static_cast<float>(seen.object[p]);
        case Layer::material:
            return static_cast<float>(seen.material[p]);
        case Layer::shadow:
            return seen.asked[p] > 0 ? static_cast<float>(seen.blocked[p] / seen.asked[p]) : 0.0f;
        default:
            break;
    }
    if (!s.sums.touched[static_cast<std::size_t>(layer)]) return 0;
    // As fold_pixels does.
    const double sum = s.sums.of(layer, c)[p];
    return static_cast<float>(film_part(samples > 1 ? sum / samples : sum));
}

/// Writes the layers of the tile: beside fold_pixels.
inline void write_layers(const WorldParts& world, const TileJob& job, const TileScratch& s) {
    const double samples = static_cast<double>(world.settings.samples) * world.settings.samples;
    for (const LayerInfo& info : layer_infos()) {
        float* const to = job.layers->of(info.layer);
        if (to == nullptr) continue;
        const auto channels = static_cast<int>(info.channels.size());
        for_each_row(job, [&](int x, int y, int first, int width) {
            float* at = to + static_cast<std::size_t>(channels) *
                                 (static_cast<std::size_t>(y) * static_cast<std::size_t>(job.row_pixels) +
                                  static_cast<std::size_t>(x));
            for (int p = first; p < first + width; ++p) {
                for (int c = 0; c < channels; ++c)
                    *at++ = layer_value(s, info.layer, c, static_cast<std::size_t>(p), samples);
            }
        });
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
