// From the light of rays to the pixels of a tile: what misses and hits add, and a pixel's fold.
#if defined(GLINT_TRACE_PIXEL_SUMS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_PIXEL_SUMS_INL_H_
#undef GLINT_TRACE_PIXEL_SUMS_INL_H_
#else
#define GLINT_TRACE_PIXEL_SUMS_INL_H_
#endif

#include "trace/camera_rays-inl.h"
#include "trace/material-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Adds colours of up to a vector of rays to the pixels of a layer. No pixel is named twice.
HWY_INLINE void add_to(TileScratch& s, int layer, const double* pixels, LaneMask<double> m,
                       Triple<Doubles> c) {
    double* sums[3] = {s.sums.of(layer, 0), s.sums.of(layer, 1), s.sums.of(layer, 2)};
    const Doubles pixel = load(pixels);
    const int first = static_cast<int>(pixels[0]);
    if (all(pixel == Doubles(pixels[0]) + iota() || !m)) {
        const Triple<Doubles> sum = load_triple(sums, first);
        store_triple(select_triple(m, sum + c, sum), sums, first);
        return;
    }
    alignas(64) double lanes[3][lane_count<double>()];
    store_triple(c, lanes, 0);
    for (std::uint32_t bits = to_bits(m); bits != 0; bits &= bits - 1) {
        const int k = __builtin_ctz(bits), p = static_cast<int>(pixels[k]);
        for (int a = 0; a < 3; ++a) sums[a][p] += lanes[a][k];
    }
}

/// What rays that hit nothing see.
HWY_INLINE Color seen_in_the_void(const World& world) {
    return world.settings.shading == Shading::normals ? Color{0, 0, 1} : world.background;
}

/// Adds what rays [from, to) of the stream see where they hit nothing.
inline void add_misses(const World& world, TileScratch& s, int first, int from, int to, int generation) {
    const bool camera = generation == 0;
    if (!camera && world.conventions.mirror_miss == MissRule::black) return;
    const Triple<Doubles> seen = lanes_of(seen_in_the_void(world));
    const double* weights[3] = {s.rays.column(k_ray_weight) + first, s.rays.column(k_ray_weight + 1) + first,
                                s.rays.column(k_ray_weight + 2) + first};
    for (int i = from; i < to; i += lane_count<double>()) {
        const auto missed = !(load(s.t.data() + i) < Doubles(k_infinity)) && first_lanes(to - i);
        if (!any(missed)) continue;
        if (camera) {
            alignas(64) double pixels[lane_count<double>()];
            store(Doubles(static_cast<double>(first + i)) + iota(), pixels);
            s.sums.touch(k_layer_background);
            add_to(s, k_layer_background, pixels, missed, seen);
        } else {
            add_to(s, k_layer_reflected, s.rays.column(k_ray_target) + first + i, missed,
                   load_triple(weights, i) * seen);
        }
    }
}

/// Adds the surfaces of hits to their pixels: shading modes that look no further.
inline void add_unlit(const World& world, TileScratch& s) {
    s.sums.touch(k_layer_ambient);
    for (int h = 0; h < s.hits; h += lane_count<double>()) {
        const MaterialLanes material(world, s.material.data() + h);
        Triple<Doubles> c = material.color(k_color);
        if (world.settings.shading == Shading::normals) {
            c = (load_triple(s.normal, h) + lanes_of(Vec3{1, 1, 1})) * Doubles(0.5);
        }
        add_to(s, k_layer_ambient, s.target.data() + h, first_lanes(s.hits - h), c);
    }
}

/// Adds the light of hits [from, to) to their pixels, weighted.
inline void add_hits(const World& world, TileScratch& s, int from, int to, int generation) {
    if (from == to) return;
    const bool camera = generation == 0;
    const int layers[3] = {camera ? k_layer_ambient : k_layer_reflected,
                           camera ? k_layer_diffuse : k_layer_reflected,
                           camera ? k_layer_specular : k_layer_reflected};
    for (const int layer : layers) s.sums.touch(layer);
    for (int h = from; h < to; h += lane_count<double>()) {
        const MaterialLanes material(world, s.material.data() + h);
        const Triple<Doubles> weight = load_triple(s.weight, h) * local_share(world, material, generation);
        const Triple<Doubles> ambient = material.color(k_ambient) * lanes_of(world.ambient);
        const auto hit = first_lanes(to - h);
        const double* pixels = s.target.data() + h;
        add_to(s, layers[0], pixels, hit, weight * ambient);
        add_to(s, layers[1], pixels, hit, weight * load_triple(s.diffuse, h));
        add_to(s, layers[2], pixels, hit, weight * load_triple(s.specular, h));
    }
}

/// A part of a pixel as the film keeps it.
HWY_INLINE Doubles film_part(Doubles part) {
    part = select(part == part, part, Doubles(0));  // no NaN reaches the film
    return min(max(part, Doubles(-1e30)), Doubles(1e30));
}

/// The pixel's fold (docs/architecture.md): each layer averaged over the samples and rounded to float, then
/// background + ambient + diffuse + specular + reflected + transmitted, in that order.
inline void fold_pixels(const World& world, const TileJob& job, const PixelSums& sums) {
    const double samples = static_cast<double>(world.settings.samples) * world.settings.samples;
    for_each_row(job, [&](int x, int y, int first, int width) HWY_ATTR {
        alignas(64) float rgb[3][k_tile_block] = {};
        for (int layer = 0; layer < k_layers; ++layer) {
            if (!sums.touched[static_cast<std::size_t>(layer)]) continue;
            for (int c = 0; c < 3; ++c) {
                for (int i = 0; i < k_tile_block; i += lane_count<double>()) {
                    Doubles part = load(sums.of(layer, c) + first + i);
                    if (samples > 1) part = part / Doubles(samples);
                    add_narrow(film_part(part), &rgb[c][i]);
                }
            }
        }
        float* to = job.rgb + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(job.row_pixels) +
                                   static_cast<std::size_t>(x));
        for (int i = 0; i < width; ++i) {
            for (int c = 0; c < 3; ++c) *to++ = rgb[c][i];
        }
    });
}

/// A tile whose rays all hit nothing: the fold of one sum.
inline void fill_with_void(const World& world, const TileJob& job) {
    const Color seen = seen_in_the_void(world);
    alignas(64) float rgb[3][lane_count<double>()] = {};
    const Triple<Doubles> lanes = lanes_of(seen);
    add_narrow(film_part(lanes.x), rgb[0]);
    add_narrow(film_part(lanes.y), rgb[1]);
    add_narrow(film_part(lanes.z), rgb[2]);
    for (int y = 0; y < job.height; ++y) {
        float* to = job.rgb + 3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(job.row_pixels);
        for (int x = 0; x < job.width; ++x) {
            for (int c = 0; c < 3; ++c) *to++ = rgb[c][0];
        }
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
