// SPDX-License-Identifier: Apache-2.0
// The first stage: one camera ray per pixel of the tile, in blocks of 8 x 8, so that packets are coherent.
#if defined(GLINT_TRACE_CAMERA_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_CAMERA_RAYS_INL_H_
#undef GLINT_TRACE_CAMERA_RAYS_INL_H_
#else
#define GLINT_TRACE_CAMERA_RAYS_INL_H_
#endif

#include "simd/vec3-inl.h"
#include "trace/tile.h"
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
HWY_INLINE double offset_x(PixelSample where) { return where == PixelSample::center ? 0.5 : 0; }
HWY_INLINE double offset_y(PixelSample where) {
    return where == PixelSample::center ? 0.5 : where == PixelSample::corner ? 1 : 0;
}
/// The centre of the picture along an axis.
HWY_INLINE double middle(PixelSample where, int size) {
    return where == PixelSample::whole ? size / 2 : size * 0.5;
}

/// The viewport coordinate of sample i in pixel column x, relative to the centre, in picture widths.
template <class T> HWY_INLINE T viewport_x(const RenderSettings& settings, PixelSample where, T x, int i) {
    return (x + T((i + offset_x(where)) / settings.samples) - T(middle(where, settings.width))) /
           T(settings.width);
}
/// The same for sample j in pixel row y, upwards, in picture heights.
HWY_INLINE double viewport_y(const RenderSettings& settings, PixelSample where, double y, int j) {
    return (middle(where, settings.height) - (y + (j + offset_y(where)) / settings.samples)) /
           settings.height;
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

/// Makes one ray for each pixel of the tile, through sample (i, j). The terms that are the same for a column
/// or a row of pixels are computed once.
inline void make_camera_rays(const WorldParts& world, const TileJob& job, int i, int j, RayBatch& rays) {
    const PreparedCamera& camera = world.camera;
    const PixelSample where = world.conventions.pixel_sample;
    const bool orthographic = camera.projection == Projection::orthographic;
    const bool unit = world.conventions.ray_direction == RayDirection::unit;
    const int count = job.width * job.height;
    rays.start_uniform(count, camera.position, world.conventions.camera_t_min, k_infinity);
    if (orthographic) rays.reserve(count);  // the common origin is overwritten
    const RayFields<double*> to = rays.end();

    alignas(k_ray_alignment) double column_offset[3][k_tile_side];  // by column of the tile
    for (int x = 0; x < k_tile_side; x += lane_count<double>()) {
        const Doubles column = Doubles(static_cast<double>(job.x + x)) + iota();
        store_vector3(lanes_of(camera.right) * viewport_x(world.settings, where, column, i), column_offset,
                      x);
    }
    Vec3 row_offset[k_tile_side];
    for (int y = 0; y < job.height; ++y) {
        row_offset[y] = camera.up * viewport_y(world.settings, where, job.y + y, j);
    }
    for_each_row(job, [&](int x, int y, int first, int width) HWY_ATTR {
        for (int c = 0; c < width; c += lane_count<double>()) {
            const Vector3<Doubles> across = load_vector3(column_offset, x + c) + lanes_of(row_offset[y]);
            const auto ray =
                viewport_ray(camera.projection, lanes_of(camera.position), lanes_of(camera.forward), across);
            if (orthographic) store_vector3(ray.origin, to.origin, first + c);
            store_vector3(unit ? normalize(ray.direction) : ray.direction, to.direction, first + c);
        }
    });
    rays.generation = 0;
    rays.count = count;
    rays.end_group();
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
