// SPDX-License-Identifier: Apache-2.0
// The first stage: one camera ray per pixel of the tile, in blocks of 8 x 8, so that packets are coherent; or
// per pixel of a list.
#if defined(GLINT_TRACE_CAMERA_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_CAMERA_RAYS_INL_H_
#undef GLINT_TRACE_CAMERA_RAYS_INL_H_
#else
#define GLINT_TRACE_CAMERA_RAYS_INL_H_
#endif

#include <algorithm>

#include "simd/sample_hash-inl.h"
#include "simd/vec3-inl.h"
#include "trace/tile.h"
#include "world/appearance/interiors.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// Visits the pixels of a tile in the order of their numbers: block by block, and in a block row by row.
/// visit(x, y, first, width) gets the first pixel of a row, its number, and the number of pixels, at most 8.
template <class Visit> HWY_INLINE void for_each_row(const TileJob& job, const Visit& visit) {
    int first = 0;
    for (int by = 0; by < job.height; by += k_tile_block) {
        for (int bx = 0; bx < job.width; bx += k_tile_block) {
            const int width = number::min(k_tile_block, job.width - bx);
            for (int y = by; y < number::min(by + k_tile_block, job.height); ++y) {
                visit(bx, y, first, width);
                first += width;
            }
        }
    }
}

/// The ray's position in its pixel or subpixel, from the top-left corner.
HWY_INLINE double offset_x(PixelSample where) {
    return where == PixelSample::center ? 0.5 : where == PixelSample::top_right ? 1 : 0;
}
HWY_INLINE double offset_y(PixelSample where) {
    return where == PixelSample::center ? 0.5 : where == PixelSample::corner ? 1 : 0;
}
/// The centre of the picture along an axis.
HWY_INLINE double middle(PixelSample where, int size) {
    return where == PixelSample::whole ? size / 2 : size * 0.5;
}

/// The position of a sample in its pixel, from the top-left corner, in pixels.
HWY_INLINE double sample_x(PixelSample where, SampleIndex s) { return (s.i + offset_x(where)) / s.n; }
HWY_INLINE double sample_y(PixelSample where, SampleIndex s) { return (s.j + offset_y(where)) / s.n; }

/// Whether the samples of pixels with n x n are jittered.
HWY_INLINE bool is_jittered(const WorldParts& world, int n) { return world.settings.jitter && n > 1; }

/// The viewport coordinate of a position in pixel column x, relative to the centre, in picture widths.
template <class T>
HWY_INLINE T viewport_x(const RenderSettings& settings, PixelSample where, T x, T in_pixel) {
    return (x + in_pixel - T(middle(where, settings.width))) / T(settings.width);
}
/// The same in pixel row y, upwards, in picture heights.
template <class T>
HWY_INLINE T viewport_y(const RenderSettings& settings, PixelSample where, T y, T in_pixel) {
    return (T(middle(where, settings.height)) - (y + in_pixel)) / T(settings.height);
}

/// The ray through a point of the viewport. V: Vec3, or Vector3 of lanes. across: the vector from the centre
/// of the viewport to the point, right sx + up sy with sx and sy from -1/2 to 1/2.
template <class V> struct ViewportRay { V origin, direction; };
template <class V>
HWY_INLINE ViewportRay<V> viewport_ray(Projection projection, const V& position, const V& forward,
                                       const V& across) {
    if (projection == Projection::orthographic) return {position + across, forward};
    return {position, forward + across};
}
inline ViewportRay<Vec3> viewport_ray(const PreparedCamera& camera, double sx, double sy) {
    return viewport_ray(camera.projection, camera.position, camera.forward,
                        camera.right * sx + camera.up * sy);
}

/// Starts a batch of camera rays.
inline RayFields<double*> start_camera_rays(const WorldParts& world, int count, RayBatch& rays) {
    rays.start_uniform(count, world.camera.position, world.conventions.camera_t_min, k_infinity);
    // The common origin is overwritten.
    if (world.camera.projection == Projection::orthographic) rays.reserve(count);
    return rays.end();
}

/// Stores the rays of a vector of pixels.
HWY_INLINE void store_camera_rays(const WorldParts& world, Vector3<Doubles> across,
                                  const RayFields<double*>& to, int first) {
    const PreparedCamera& camera = world.camera;
    const auto ray =
        viewport_ray(camera.projection, lanes_of(camera.position), lanes_of(camera.forward), across);
    if (camera.projection == Projection::orthographic) store_vector3(ray.origin, to.origin, first);
    const bool unit = world.conventions.ray_direction == RayDirection::unit;
    store_vector3(unit ? normalize(ray.direction) : ray.direction, to.direction, first);
}

inline void end_camera_rays(int count, RayBatch& rays) {
    rays.generation = 0;
    rays.count = count;
    rays.end_group();
}

/// Makes one ray for each pixel of the tile, through a sample. The terms that are the same for a column or a
/// row of pixels are computed once.
inline void make_camera_rays(const WorldParts& world, const TileJob& job, SampleIndex sample,
                             RayBatch& rays) {
    const PreparedCamera& camera = world.camera;
    const PixelSample where = world.conventions.pixel_sample;
    const int count = job.width * job.height;
    const RayFields<double*> to = start_camera_rays(world, count, rays);

    alignas(k_ray_alignment) double column_offset[3][k_tile_side];  // by column of the tile
    const Doubles in_column(sample_x(where, sample));
    for (int x = 0; x < k_tile_side; x += lane_count<double>()) {
        const Doubles column = Doubles(static_cast<double>(job.x + x)) + iota();
        store_vector3(lanes_of(camera.right) * viewport_x(world.settings, where, column, in_column),
                      column_offset, x);
    }
    Vec3 row_offset[k_tile_side];
    for (int y = 0; y < job.height; ++y) {
        row_offset[y] = camera.up * viewport_y(world.settings, where, static_cast<double>(job.y + y),
                                               sample_y(where, sample));
    }
    for_each_row(job, [&](int x, int y, int first, int width) HWY_ATTR {
        for (int c = 0; c < width; c += lane_count<double>()) {
            store_camera_rays(world, load_vector3(column_offset, x + c) + lanes_of(row_offset[y]), to,
                              first + c);
        }
    });
    end_camera_rays(count, rays);
}

/// The positions of a jittered sample in its pixels: in its square of the n x n, at two numbers from 0 to 1
/// of the hash (math/sample_hash.h).
struct JitteredSample {
    Doubles x, y;

    HWY_INLINE JitteredSample(std::uint32_t seed, Doubles pixel_x, Doubles pixel_y, SampleIndex s) {
        Words hash = hash_with(Words(seed_hash(seed)), to_words(pixel_x));
        hash = hash_with(hash, to_words(pixel_y));
        hash = hash_with(hash, Words(static_cast<std::uint32_t>(s.number())));
        hash = hash_with(hash_with(hash, Words(k_camera_path)), Words(purpose_word(SamplePurpose::pixel, 0)));
        x = (Doubles(s.i) + unit_number(hash_with(hash, Words(0u)))) / Doubles(s.n);
        y = (Doubles(s.j) + unit_number(hash_with(hash, Words(1u)))) / Doubles(s.n);
    }
};

/// Makes one ray for each pixel of a list, through a sample: the same rays as for a tile, or jittered.
inline void make_listed_camera_rays(const WorldParts& world, const PixelList& pixels, SampleIndex sample,
                                    RayBatch& rays) {
    const PreparedCamera& camera = world.camera;
    const PixelSample where = world.conventions.pixel_sample;
    const bool jitter = is_jittered(world, sample.n);
    const RayFields<double*> to = start_camera_rays(world, pixels.count, rays);
    Doubles in_column(sample_x(where, sample)), in_row(sample_y(where, sample));
    for (int p = 0; p < pixels.count; p += lane_count<double>()) {
        const Doubles column = load(pixels.x.data() + p), row = load(pixels.y.data() + p);
        if (jitter) {
            const JitteredSample at(world.settings.seed, column, row, sample);
            in_column = at.x;
            in_row = at.y;
        }
        const Doubles x = viewport_x(world.settings, where, column, in_column);
        const Doubles y = viewport_y(world.settings, where, row, in_row);
        store_camera_rays(world, lanes_of(camera.right) * x + lanes_of(camera.up) * y, to, p);
    }
    end_camera_rays(pixels.count, rays);
}

/// Sets the objects that camera rays are inside.
inline void set_camera_interiors(const WorldParts& world, RayBatch& rays) {
    std::fill_n(rays.interiors.begin(), rays.count + k_ray_padding,
                static_cast<double>(world.interiors.camera));
    if (world.interiors.cutting.empty()) return;
    for (std::size_t i = 0; i < static_cast<std::size_t>(rays.count); ++i) {
        const Vec3 origin{rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]};
        rays.interiors[i] = static_cast<double>(camera_interiors_at(world, origin));
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
