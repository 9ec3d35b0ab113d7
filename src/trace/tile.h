#pragma once
// A tile: a fixed number of pixels whose rays pass the stages together.
#include <array>
#include <cstdint>
#include <vector>

#include "bvh/rays.h"
#include "glint/render.h"
#include "trace/ray_queue.h"

namespace glint {

inline constexpr int k_tile_side = 32;
inline constexpr int k_tile_pixels = k_tile_side * k_tile_side;
inline constexpr int k_stream = 1024;  // rays that pass a stage together, at most

/// The parts of a pixel, in the order in which they are added up. Light found after the first mirror or glass
/// surface belongs to the branch taken there.
enum Layer : int {
    k_layer_background,
    k_layer_ambient,
    k_layer_diffuse,
    k_layer_specular,
    k_layer_reflected,
    k_layer_transmitted,
    k_layers
};

struct TileJob {
    int x = 0, y = 0, width = 0, height = 0;  // pixels of the picture
    float* rgb = nullptr;  // pixel (x, y) of the tile goes to rgb[3 (row * row_pixels + column)]
    int row_pixels = 0;
};

/// What a tile's stages write, reused from tile to tile by one thread. Columns are by hit unless said
/// otherwise.
struct TileScratch {
    static constexpr int k_size = k_stream + k_ray_padding;
    using Column = std::array<double, k_size>;

    RayQueue rays, next_rays;                                            // this generation, and the one after
    RayQueue transmitted_rays;                                           // of the group at hand
    std::array<std::array<double, 3 * k_layers>, k_tile_pixels> pixels;  // sums over the samples, by pixel

    std::array<std::int32_t, k_tile_pixels> sample_rays;  // mirror and glass rays of the sample, by pixel

    Column t;                                // by ray
    std::array<std::uint32_t, k_size> slot;  // by ray

    int hits = 0;
    std::array<std::int32_t, k_size> ray;  // which ray of the stream it is
    std::array<std::uint32_t, k_size> material;
    std::array<std::uint8_t, k_size> behind;  // the ray came from behind the shape's own normal
    Column point[3], normal[3], incoming[3], to_eye[3], magnitude;
    Column diffuse[3], specular[3];        // sums over the lights
    Column n_l, s, attenuation;            // of the light at hand
    std::array<std::uint8_t, k_size> lit;  // 0: the light at hand adds nothing

    Column shadow[8];                             // by shadow ray: the columns of a RaySpan
    std::array<std::int32_t, k_size> shadow_hit;  // by shadow ray: for which hit
    std::array<std::uint8_t, k_size> occluded;    // by shadow ray
    RaySpan shadow_rays() const {
        return {shadow[0].data(), shadow[1].data(), shadow[2].data(), shadow[3].data(),
                shadow[4].data(), shadow[5].data(), shadow[6].data(), shadow[7].data()};
    }

    RayCounts counts;
};

}  // namespace glint
