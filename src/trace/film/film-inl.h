// SPDX-License-Identifier: Apache-2.0
// The film: the light that hits and misses add to the pixels of a tile, and the values of the pixels.
#if defined(GLINT_TRACE_FILM_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_FILM_INL_H_
#undef GLINT_TRACE_FILM_INL_H_
#else
#define GLINT_TRACE_FILM_INL_H_
#endif

#include "trace/film/background-inl.h"
#include "trace/lighting/fog-inl.h"
#include "trace/rays/camera_rays-inl.h"
#include "trace/secondary/ray_weights-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The pixels of at most a vector of rays, all different.
struct PixelLanes {
    const double* pixels;
    LaneMask<double> set;
    bool are_adjacent;  // in memory

    HWY_INLINE PixelLanes(const double* numbers, LaneMask<double> m)
        : pixels(numbers), set(m), are_adjacent(all(load(numbers) == Doubles(numbers[0]) + iota() || !m)) {}

    /// Adds colors, one after the other, to the pixels' sums in a layer.
    template <class... Colors> HWY_INLINE void add(Film& film, Layer layer, const Colors&... colors) const {
        double* sums[3] = {film.of(layer, 0), film.of(layer, 1), film.of(layer, 2)};
        if (are_adjacent) {
            const int first = static_cast<int>(pixels[0]);
            const Vector3<Doubles> before = load_vector3(sums, first);
            Vector3<Doubles> sum = before;
            ((sum = sum + colors), ...);
            store_vector3(select_vector3(set, sum, before), sums, first);
            return;
        }
        alignas(k_ray_alignment) double lanes[sizeof...(colors)][3][lane_count<double>()];
        int stored = 0;
        (store_vector3(colors, lanes[stored++], 0), ...);
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

/// The rays that show the background directly or through glass, of those that miss.
HWY_INLINE LaneMask<double> see_through(const RayBatch& rays, int ray, LaneMask<double> missed) {
    return rays.generation == 0 ? missed : missed && load(rays.straight.data() + ray) > Doubles(0);
}

/// Whether pixels show the background where rays see it directly or through glass.
HWY_INLINE bool shows_background(const WorldParts& world) {
    return !world.settings.alpha || world.conventions.background_alpha > 0;
}

/// For alpha: adds the weights of rays that show the background; of a colored weight, the mean.
inline void add_transparency(const RayBatch& rays, int ray, LaneMask<double> seen, Doubles visibility,
                             Film& film) {
    alignas(k_ray_alignment) double parts[lane_count<double>()];
    store(visibility, parts);
    for (std::uint32_t bits = to_bits(seen); bits != 0; bits &= bits - 1) {
        const int lane = __builtin_ctz(bits);
        const auto k = static_cast<std::size_t>(ray + lane);
        if (rays.generation == 0) {
            film.transparency[k] += parts[lane];
        } else {
            const auto pixel = static_cast<std::size_t>(rays.target[k]) % std::size_t{k_layer_stride};
            film.transparency[pixel] +=
                (rays.weight[0][k] + rays.weight[1][k] + rays.weight[2][k]) / 3 * parts[lane];
        }
    }
}

/// Adds a color that rays see to their pixels. layer: that of camera rays.
HWY_INLINE void add_seen(const RayBatch& rays, int ray, LaneMask<double> set, Layer layer,
                         const Vector3<Doubles>& color, Film& film) {
    if (!any(set)) return;
    if (rays.generation == 0) {
        alignas(k_ray_alignment) double pixels[lane_count<double>()];
        store(Doubles(static_cast<double>(ray)) + iota(), pixels);
        film.touch(layer);
        PixelLanes(pixels, set).add(film, layer, color);
    } else {
        const PixelLanes pixels(rays.target.data() + ray, set);
        pixels.add(film, Layer::reflection, load_vector3(rays.weight, ray) * color);
    }
}

/// Calls visit(ray, missed) for each vector of a range in which rays hit nothing.
template <class Visit>
HWY_INLINE void for_each_miss(const HitBatch& hits, RayRange range, const Visit& visit) {
    for (int i = range.begin; i < range.end; i += lane_count<double>()) {
        const auto missed =
            !(load(hits.t.data() + i) < Doubles(k_infinity)) && first_lanes<double>(range.end - i);
        if (any(missed)) visit(hits.first + i, missed);
    }
}

/// Adds the light of those rays of a range that hit nothing.
inline void add_misses(const WorldParts& world, const RayBatch& rays, const HitBatch& hits, RayRange range,
                       Film& film) {
    if (rays.generation > 0 && world.conventions.mirror_miss == MissRule::black) return;
    const bool gradient = has_gradient(world), fog = has_fog_on_background(world);
    const Vector3<Doubles> color = lanes_of(miss_color(world));
    if (!rays.alpha && !gradient && !fog) {
        return for_each_miss(hits, range, [&](int ray, LaneMask<double> missed) HWY_ATTR {
            add_seen(rays, ray, missed, Layer::background, color, film);
        });
    }
    const bool has_blind = rays.generation > 0 && world.conventions.limit == LimitRule::background;
    for_each_miss(hits, range, [&](int ray, LaneMask<double> missed) HWY_ATTR {
        Doubles visibility = background_visibility(world, rays, ray);
        if (fog && rays.tracked)
            visibility = select(are_outside_fog(world, rays.interiors.data() + ray), Doubles(1), visibility);
        if (fog && has_blind)
            visibility =
                select(load(rays.t_min.data() + ray) >= Doubles(k_blind_t_min), Doubles(1), visibility);
        auto opaque = missed;
        if (rays.alpha) {
            const auto transparent = see_through(rays, ray, missed);
            add_transparency(rays, ray, transparent,
                             visibility * Doubles(1 - world.conventions.background_alpha), film);
            if (!shows_background(world)) opaque = missed && !transparent;
        }
        const Vector3<Doubles> shown = gradient ? gradient_color(*world.gradient, rays, ray) : color;
        add_seen(rays, ray, opaque, Layer::background, through_fog(world, shown, visibility), film);
        const auto fogged = missed && visibility < Doubles(1);
        if (any(fogged))
            add_seen(rays, ray, fogged, Layer::fog, lanes_of(world.fog->color) * (Doubles(1) - visibility),
                     film);
    });
}

/// The colors of a vector of surfaces in the unlit shading modes.
HWY_INLINE Vector3<Doubles> unlit_color(const WorldParts& world, const SurfaceBatch& surfaces, int h) {
    if (world.settings.shading == Shading::normals)
        return (load_vector3(surfaces.normal, h) + lanes_of(Vec3{1, 1, 1})) * Doubles(0.5);
    return MaterialLanes(surfaces, h).color(k_color);
}

/// Adds the colors of surfaces to their pixels, in the unlit shading modes.
inline void add_unlit(const WorldParts& world, const SurfaceBatch& surfaces, Film& film) {
    film.touch(Layer::ambient);
    for (int h = 0; h < surfaces.count; h += lane_count<double>()) {
        PixelLanes(surfaces.target.data() + h, first_lanes<double>(surfaces.count - h))
            .add(film, Layer::ambient, unlit_color(world, surfaces, h));
    }
}

/// k_a I_a.
HWY_INLINE Vector3<Doubles> ambient_of(const WorldParts& world, const MaterialLanes& material) {
    return material.color(k_ambient) * lanes_of(world.ambient);
}

/// k_e, if the world uses it; else 0.
HWY_INLINE Vector3<Doubles> emission_of(const WorldParts& world, const MaterialLanes& material) {
    if (!world.uses<&Material::emission>()) return lanes_of(Vec3{});
    return ExtendedLanes(material).color<&Material::emission>();
}

/// The diffuse light of a vector of surfaces, with their outlines.
template <bool plain = false>
HWY_INLINE Vector3<Doubles> outlined_diffuse(const WorldParts& world, const SurfaceBatch& surfaces,
                                             const RadianceBatch& radiance, const MaterialLanes& material,
                                             int h) {
    const Vector3<Doubles> diffuse = load_vector3(radiance.diffuse, h);
    if (plain || !world.uses<&Material::outline>()) return diffuse;
    return diffuse * outline_of(world, material, surfaces, h);
}

/// The light from all directions of a vector of surfaces, with their outlines.
HWY_INLINE Vector3<Doubles> outlined_sky(const WorldParts& world, const SurfaceBatch& surfaces,
                                         const RadianceBatch& radiance, const MaterialLanes& material,
                                         int h) {
    const Vector3<Doubles> sky = load_vector3(radiance.sky, h);
    return world.uses<&Material::outline>() ? sky * outline_of(world, material, surfaces, h) : sky;
}

/// The weighted light of a vector of surfaces, as it is added to the pixels. emission and sky: 0 if the world
/// has none, as if plain.
struct HitLight {
    Vector3<Doubles> ambient, diffuse, specular, emission, sky;
};
template <bool plain = false>
HWY_INLINE HitLight light_of(const WorldParts& world, const SurfaceBatch& surfaces,
                             const RadianceBatch& radiance, const MaterialLanes& material, int h) {
    const LocalShares shares = local_shares<plain>(world, material, surfaces, h);
    const Vector3<Doubles> weight = load_vector3(surfaces.weight, h), matte = weight * shares.matte;
    const Vector3<Doubles> emission =
        !plain && world.uses<&Material::emission>() ? matte * emission_of(world, material) : lanes_of(Vec3{});
    const Vector3<Doubles> sky = !plain && world.occlusion
                                     ? matte * outlined_sky(world, surfaces, radiance, material, h)
                                     : lanes_of(Vec3{});
    const Vector3<Doubles> highlight = plain ? matte : weight * shares.highlight;
    return {matte * ambient_of(world, material),
            matte * outlined_diffuse<plain>(world, surfaces, radiance, material, h),
            highlight * load_vector3(radiance.specular, h), emission, sky};
}

/// Adds the light of surfaces [begin, end) to their pixels. plain: the world has no extended fields,
/// occlusion or fog, as most.
template <bool plain>
inline void add_hits(const WorldParts& world, const SurfaceBatch& surfaces, const RadianceBatch& radiance,
                     int begin, int end, Film& film) {
    if (begin == end) return;
    const bool camera = surfaces.generation == 0, emits = !plain && world.uses<&Material::emission>(),
               sky = !plain && world.occlusion, fog = !plain && world.fog;
    if (camera) {
        for (const Layer layer : {Layer::ambient, Layer::diffuse, Layer::specular}) film.touch(layer);
        if (emits) film.touch(Layer::emission);
        if (sky) film.touch(Layer::sky);
        if (fog) film.touch(Layer::fog);
    }
    for (int h = begin; h < end; h += lane_count<double>()) {
        const MaterialLanes material(surfaces, h);
        const HitLight light = light_of<plain>(world, surfaces, radiance, material, h);
        const PixelLanes pixels(surfaces.target.data() + h, first_lanes<double>(end - h));
        if (camera) {
            pixels.add(film, Layer::ambient, light.ambient);
            pixels.add(film, Layer::diffuse, light.diffuse);
            pixels.add(film, Layer::specular, light.specular);
            if (emits) pixels.add(film, Layer::emission, light.emission);
        } else {
            pixels.add(film, Layer::reflection, light.ambient, light.diffuse, light.specular);
            if (emits) pixels.add(film, Layer::reflection, light.emission);
        }
        if (sky) pixels.add(film, camera ? Layer::sky : Layer::reflection, light.sky);
        if (fog) pixels.add(film, camera ? Layer::fog : Layer::reflection, load_vector3(surfaces.fog, h));
    }
}

/// Adds the light of a range of rays to their pixels, group by group, so that the order of summation in a
/// pixel is fixed.
inline void add_to_film(const WorldParts& world, const RayBatch& rays, const HitBatch& hits, int first_ray,
                        const SurfaceBatch& surfaces, const RadianceBatch& radiance, Film& film) {
    const bool plain = world.extended_uses == 0 && !world.occlusion && !world.fog;
    SurfaceBatch::GroupEnd begin{first_ray, 0};
    for (int i = 0; i < surfaces.groups; ++i) {
        const SurfaceBatch::GroupEnd end = surfaces.group_end[static_cast<std::size_t>(i)];
        add_misses(world, rays, hits, {begin.rays, end.rays}, film);
        if (plain) {
            add_hits<true>(world, surfaces, radiance, begin.hits, end.hits, film);
        } else {
            add_hits<false>(world, surfaces, radiance, begin.hits, end.hits, film);
        }
        begin = end;
    }
}

/// The value of a layer of a pixel, without NaN and infinity.
template <class T> HWY_INLINE T film_value(T value) {
    value = select(value == value, value, T(0));  // NaN becomes 0
    return min(max(value, T(-1e30)), T(1e30));
}

/// The alpha of a pixel with this number of samples.
HWY_INLINE float alpha_value(const Film& film, std::size_t p, double samples) {
    const double alpha = 1 - (samples > 1 ? film.transparency[p] / samples : film.transparency[p]);
    return static_cast<float>(number::min(number::max(alpha, 0.0), 1.0));
}

/// Computes `count` pixels from number `first` on (docs/architecture.md): each layer is averaged over the
/// samples and rounded to float; then background + ambient + diffuse + specular + reflected + transmitted +
/// emission + sky + fog are added in this order.
inline void resolve_row(const Film& film, double samples, int first, int count, float* to) {
    Layer layers[k_light_layers];
    int touched = 0;
    for (int layer = 0; layer < k_light_layers; ++layer) {
        if (film.touched[static_cast<std::size_t>(layer)]) layers[touched++] = static_cast<Layer>(layer);
    }
    const auto add = [&](NarrowFloats& sum_of_layers, const double* from) HWY_ATTR {
        const Doubles sum = load(from);
        sum_of_layers.add(film_value(samples > 1 ? sum / Doubles(samples) : sum));
    };
    for (int i = 0; i < count; i += lane_count<double>(), to += 3 * lane_count<double>()) {
        NarrowFloats rgb[3];
        for (int layer = 0; layer < touched; ++layer) {
            for (int c = 0; c < 3; ++c) add(rgb[c], film.of(layers[layer], c) + first + i);
        }
        if (i + lane_count<double>() <= count) {
            store_interleaved(rgb[0], rgb[1], rgb[2], to);
        } else {
            float lanes[3 * lane_count<double>()];
            store_interleaved(rgb[0], rgb[1], rgb[2], lanes);
            std::copy_n(lanes, 3 * (count - i), to);
        }
    }
}

/// A pixel of the tile in the memory of the picture, or of a layer with this number of channels.
HWY_INLINE float* pixel_in(float* memory, int row_pixels, int channels, int x, int y) {
    return memory + static_cast<std::size_t>(channels) *
                        (static_cast<std::size_t>(y) * static_cast<std::size_t>(row_pixels) +
                         static_cast<std::size_t>(x));
}

/// Computes the pixels of the tile, which have n x n samples.
inline void resolve(const TileJob& job, const Film& film, int n) {
    const double samples = static_cast<double>(n) * n;
    for_each_row(job, [&](int x, int y, int first, int width) HWY_ATTR {
        resolve_row(film, samples, first, width, pixel_in(job.rgb, job.row_pixels, 3, x, y));
    });
}

/// Fills a tile whose rays all hit nothing. The pixels are the same as those of resolve().
GLINT_SMALL void fill_background(const WorldParts& world, const TileJob& job, int n) {
    const int samples = n * n;
    const bool in_fog =
        has_fog_on_background(world) && !is_outside_fog(world, static_cast<double>(world.interiors.camera));
    const FoggedBackground seen =
        fogged_background(world, miss_color(world), in_fog ? world.fog->transmit : 1);
    NarrowFloats r, g, b;
    const auto add = [&](Color layer) HWY_ATTR {
        const Vector3<Doubles> color = lanes_of(layer);
        Vector3<Doubles> sum = lanes_of(Vec3{});
        for (int i = 0; i < samples; ++i) sum = sum + color;
        if (samples > 1) sum = sum / Doubles(static_cast<double>(samples));
        r.add(film_value(sum.x));
        g.add(film_value(sum.y));
        b.add(film_value(sum.z));
    };
    if (shows_background(world)) add(seen.background);
    if (seen.visibility < 1) add(seen.fog);
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
