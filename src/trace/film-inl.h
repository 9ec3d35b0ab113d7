// SPDX-License-Identifier: Apache-2.0
// From the light of rays to the pixels of a tile: what misses and hits add, and a pixel's fold.
#if defined(GLINT_TRACE_FILM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_FILM_INL_H_
#undef GLINT_TRACE_FILM_INL_H_
#else
#define GLINT_TRACE_FILM_INL_H_
#endif

#include "trace/camera_rays-inl.h"
#include "trace/material-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The pixels of up to a vector of rays. No pixel is named twice.
struct PixelLanes {
    const double* pixels;
    LaneMask<double> set;
    bool are_adjacent;  // neighbours in memory

    HWY_INLINE PixelLanes(const double* numbers, LaneMask<double> m)
        : pixels(numbers), set(m), are_adjacent(all(load(numbers) == Doubles(numbers[0]) + iota() || !m)) {}

    /// Adds colours to the pixels' sums of a layer, one after the other.
    template <class... Colors> HWY_INLINE void add(Film& film, Layer layer, const Colors&... colors) const {
        double* sums[3] = {film.of(layer, 0), film.of(layer, 1), film.of(layer, 2)};
        if (are_adjacent) {
            const int first = static_cast<int>(pixels[0]);
            const Triple<Doubles> before = load_triple(sums, first);
            Triple<Doubles> sum = before;
            ((sum = sum + colors), ...);
            store_triple(select_triple(set, sum, before), sums, first);
            return;
        }
        alignas(k_ray_alignment) double lanes[sizeof...(colors)][3][lane_count<double>()];
        int stored = 0;
        (store_triple(colors, lanes[stored++], 0), ...);
        for (std::uint32_t bits = to_bits(set); bits != 0; bits &= bits - 1) {
            const int k = __builtin_ctz(bits), p = static_cast<int>(pixels[k]);
            for (int c = 0; c < 3; ++c) {
                double sum = sums[c][p];
                for (const auto& color : lanes) sum += color[c][k];
                sums[c][p] = sum;
            }
        }
    }
};

/// What rays that hit nothing see.
HWY_INLINE Color miss_color(const WorldParts& world) {
    return world.settings.shading == Shading::normals ? Color{0, 0, 1} : world.background;
}

/// Adds what rays [from, to) of the stream see where they hit nothing.
inline void add_misses(const WorldParts& world, TileScratch& s, int first, int from, int to, int generation) {
    const bool camera = generation == 0;
    if (!camera && world.conventions.mirror_miss == MissRule::black) return;
    const Triple<Doubles> first_hits = lanes_of(miss_color(world));
    const double* weights[3] = {s.rays.column(k_ray_weight) + first, s.rays.column(k_ray_weight + 1) + first,
                                s.rays.column(k_ray_weight + 2) + first};
    for (int i = from; i < to; i += lane_count<double>()) {
        const auto missed = !(load(s.t.data() + i) < Doubles(k_infinity)) && first_lanes<double>(to - i);
        if (!any(missed)) continue;
        if (camera) {
            alignas(k_ray_alignment) double pixels[lane_count<double>()];
            store(Doubles(static_cast<double>(first + i)) + iota(), pixels);
            s.film.touch(Layer::background);
            PixelLanes(pixels, missed).add(s.film, Layer::background, first_hits);
        } else {
            const PixelLanes pixels(s.rays.column(k_ray_target) + first + i, missed);
            pixels.add(s.film, Layer::reflection, load_triple(weights, i) * first_hits);
        }
    }
}

/// What a vector of hits shows where shading looks no further.
HWY_INLINE Triple<Doubles> unlit_color(const WorldParts& world, const TileScratch& s, int h) {
    if (world.settings.shading == Shading::normals)
        return (load_triple(s.normal, h) + lanes_of(Vec3{1, 1, 1})) * Doubles(0.5);
    return MaterialLanes(world, s.material.data() + h).color(k_color);
}

/// Adds the surfaces of hits to their pixels: shading modes that look no further.
inline void add_unlit(const WorldParts& world, TileScratch& s) {
    s.film.touch(Layer::ambient);
    for (int h = 0; h < s.hits; h += lane_count<double>()) {
        PixelLanes(s.target.data() + h, first_lanes<double>(s.hits - h))
            .add(s.film, Layer::ambient, unlit_color(world, s, h));
    }
}

/// k_a I_a.
HWY_INLINE Triple<Doubles> ambient_of(const WorldParts& world, const MaterialLanes& material) {
    return material.color(k_ambient) * lanes_of(world.ambient);
}

/// The light of a vector of hits as their pixels get it, weighted.
struct HitLight {
    Triple<Doubles> ambient, diffuse, specular;
};
HWY_INLINE HitLight light_of(const WorldParts& world, const TileScratch& s, const MaterialLanes& material,
                             int h, int generation) {
    const Triple<Doubles> weight = load_triple(s.weight, h) * local_share(world, material, generation);
    return {weight * ambient_of(world, material), weight * load_triple(s.diffuse, h),
            weight * load_triple(s.specular, h)};
}

/// Adds the light of hits [from, to) to their pixels.
inline void add_hits(const WorldParts& world, TileScratch& s, int from, int to, int generation) {
    if (from == to) return;
    const bool camera = generation == 0;
    if (camera) {
        for (const Layer layer : {Layer::ambient, Layer::diffuse, Layer::specular}) s.film.touch(layer);
    }
    for (int h = from; h < to; h += lane_count<double>()) {
        const MaterialLanes material(world, s.material.data() + h);
        const HitLight light = light_of(world, s, material, h, generation);
        const PixelLanes pixels(s.target.data() + h, first_lanes<double>(to - h));
        if (camera) {
            pixels.add(s.film, Layer::ambient, light.ambient);
            pixels.add(s.film, Layer::diffuse, light.diffuse);
            pixels.add(s.film, Layer::specular, light.specular);
        } else {
            pixels.add(s.film, Layer::reflection, light.ambient, light.diffuse, light.specular);
        }
    }
}

/// A part of a pixel as the film keeps it.
template <class T> HWY_INLINE T film_value(T value) {
    value = select(value == value, value, T(0));  // no NaN reaches the film
    return min(max(value, T(-1e30)), T(1e30));
}

/// The pixel's fold (docs/architecture.md): each layer averaged over the samples and rounded to float, then
/// background + ambient + diffuse + specular + reflected + transmitted, in that order.
inline void resolve(const WorldParts& world, const TileJob& job, const Film& film) {
    const double samples = static_cast<double>(world.settings.samples) * world.settings.samples;
    Layer layers[k_light_layers];
    int touched = 0;
    for (int layer = 0; layer < k_light_layers; ++layer) {
        if (film.touched[static_cast<std::size_t>(layer)]) layers[touched++] = static_cast<Layer>(layer);
    }
    const auto add = [&](NarrowFloats& to, const double* from) HWY_ATTR {
        const Doubles sum = load(from);
        to.add(film_value(samples > 1 ? sum / Doubles(samples) : sum));
    };
    for_each_row(job, [&](int x, int y, int first, int width) HWY_ATTR {
        float* to = job.rgb + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(job.row_pixels) +
                                   static_cast<std::size_t>(x));
        for (int i = 0; i < width; i += lane_count<double>(), to += 3 * lane_count<double>()) {
            NarrowFloats rgb[3];
            for (int layer = 0; layer < touched; ++layer) {
                for (int c = 0; c < 3; ++c) add(rgb[c], film.of(layers[layer], c) + first + i);
            }
            if (i + lane_count<double>() <= width) {
                store_interleaved(rgb[0], rgb[1], rgb[2], to);
            } else {
                float lanes[3 * lane_count<double>()];
                store_interleaved(rgb[0], rgb[1], rgb[2], lanes);
                std::copy_n(lanes, 3 * (width - i), to);
            }
        }
    });
}

/// A tile whose rays all hit nothing: the fold of one sum.
inline void fill_background(const WorldParts& world, const TileJob& job) {
    const int samples = world.settings.samples * world.settings.samples;
    const Triple<Doubles> first_hits = lanes_of(miss_color(world));
    Triple<Doubles> sum = lanes_of(Vec3{});
    for (int i = 0; i < samples; ++i) sum = sum + first_hits;
    if (samples > 1) sum = sum / Doubles(static_cast<double>(samples));
    NarrowFloats r, g, b;
    r.add(film_value(sum.x));
    g.add(film_value(sum.y));
    b.add(film_value(sum.z));
    float rgb[3 * lane_count<double>()];
    store_interleaved(r, g, b, rgb);
    for (int y = 0; y < job.height; ++y) {
        float* to = job.rgb + 3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(job.row_pixels);
        for (int x = 0; x < job.width; ++x) to = std::copy_n(rgb, 3, to);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
