// SPDX-License-Identifier: Apache-2.0
#pragma once
// A tile: a fixed number of pixels whose rays pass the stages together.
#include <array>
#include <cstdint>
#include <vector>

#include "bvh/rays.h"
#include "glint/layers.h"
#include "glint/render.h"
#include "trace/ray_queue.h"

namespace glint {

inline constexpr int k_tile_side = 32;
inline constexpr int k_tile_block = 8;  // camera rays go in blocks of 8 x 8, so that neighbours walk together
inline constexpr int k_tile_pixels = k_tile_side * k_tile_side;
inline constexpr int k_stream_size = k_tile_pixels;  // rays that are traced together, at most
/// Rays of a stream whose hits pass the stages together, at most: their columns stay in the first cache.
inline constexpr int k_batch_size = 256;

struct TileRecord;

/// Where the layers of a tile go, as its rgb does; null: not asked for.
struct LayerTargets {
    std::array<float*, k_layers> data{};
    float* of(Layer layer) const { return data[static_cast<std::size_t>(layer)]; }
};

/// What layers tell of the first surfaces, by pixel of the tile. Empty unless asked for.
struct FirstHits {
    std::vector<double> normal[3], position[3], albedo[3], depth, object, material;
    std::vector<double> asked, blocked;  // lights, over the samples
    bool wanted = false;
    bool is_middle = false;  // the sample at hand is the middle one
};

struct TileJob {
    int x = 0, y = 0, width = 0, height = 0;  // pixels of the picture
    float* rgb = nullptr;  // pixel (x, y) of the tile goes to rgb[3 (row * row_pixels + column)]
    int row_pixels = 0;
    const LayerTargets* layers = nullptr;  // what else is asked for
};

/// From a pixel of a layer to that of the next one.
inline constexpr int k_layer_stride = k_tile_pixels + k_ray_padding;

/// Sums over the samples, by light layer and pixel. Pixels are numbered as the camera rays go, without gaps.
struct Film {
    alignas(k_ray_alignment) std::array<double, k_light_layers * k_layer_stride> channel[3];
    std::array<bool, k_light_layers> touched;  // others count as 0, whatever they hold

    void clear() { touched.fill(false); }
    /// To be called before anything is added to a layer.
    void touch(Layer layer) {
        if (touched[static_cast<std::size_t>(layer)]) return;
        touched[static_cast<std::size_t>(layer)] = true;
        for (auto& sums : channel) {
            const auto first = sums.begin() + static_cast<int>(layer) * k_layer_stride;
            std::fill(first, first + k_layer_stride, 0.0);
        }
    }
    double* of(Layer layer, int c) { return channel[c].data() + static_cast<int>(layer) * k_layer_stride; }
    const double* of(Layer layer, int c) const {
        return channel[c].data() + static_cast<int>(layer) * k_layer_stride;
    }
};

/// What a tile's stages write, reused from tile to tile by one thread. Columns are by hit unless said
/// otherwise.
struct TileScratch {
    // Vectors that straddle the lines of the cache cost twice.
    template <class T, std::size_t n> struct alignas(k_ray_alignment) Aligned : std::array<T, n> {};
    template <class T> using PerRay = Aligned<T, k_stream_size + k_ray_padding>;
    template <class T> using PerHit = Aligned<T, k_batch_size + k_ray_padding>;
    using Column = PerHit<double>;

    RayQueue rays, next_rays;   // this generation, and the one after
    RayQueue transmitted_rays;  // of the group at hand
    Film film;

    std::array<std::int32_t, k_tile_pixels> sample_rays;  // mirror and glass rays of the sample, by pixel

    PerRay<double> t;            // by ray of the stream
    PerRay<std::uint32_t> slot;  // by ray of the stream

    /// What of a batch belongs to one group: it ends before these rays of the stream and these hits.
    struct GroupEnd {
        int rays, hits;
    };
    std::array<GroupEnd, k_batch_size> group_end;
    int groups = 0;

    int hits = 0;
    PerHit<std::uint32_t> hit_slot, material;
    Column behind;                     // 1: the ray came from behind the shape's own normal; else 0
    Column hit_t;                      // with Beer's law
    Column weight[3], target, medium;  // of the ray (RayColumn)
    Column point[3], normal[3], incoming[3], to_eye[3], magnitude;
    Column diffuse[3], specular[3];  // sums over the lights
    Column n_l, s, attenuation;      // of the light at hand
    PerHit<std::uint8_t> lit;        // by vector, a bit a hit: the light at hand may add something

    Column power, shininess;  // of the highlights of the light at hand, one after the other

    Column shadow[8];               // by shadow ray: the columns of a RaySpan
    PerHit<std::uint8_t> occluded;  // by shadow ray
    RaySpan shadow_rays() const {
        return {shadow[0].data(), shadow[1].data(), shadow[2].data(), shadow[3].data(),
                shadow[4].data(), shadow[5].data(), shadow[6].data(), shadow[7].data()};
    }

    RayCounts counts;
    FirstHits first_hits;
    TileRecord* record = nullptr;  // where a tile of one pixel writes down what it does (trace/record.h)
    /// Whether the stages are to be gone through even where nothing is hit.
    bool needs_every_stage() const { return record != nullptr || first_hits.wanted; }
};

}  // namespace glint
