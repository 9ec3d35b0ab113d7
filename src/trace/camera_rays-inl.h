// The first stage: one camera ray a pixel of the tile, in blocks of 8 x 8 so that neighbours walk together.
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

/// The rows of at most 8 pixels that a tile's pixels are numbered by: block after block, row after row.
/// visit(x, y, first, width): the row's first pixel in the tile, its number, and how many there are.
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

/// Where in a pixel, or in a part of it, the ray passes: from its top-left corner.
HWY_INLINE double offset_x(PixelSample where) { return where == PixelSample::center ? 0.5 : 0; }
HWY_INLINE double offset_y(PixelSample where) {
    return where == PixelSample::center ? 0.5 : where == PixelSample::corner ? 1 : 0;
}
/// The picture's middle along an axis.
HWY_INLINE double middle(PixelSample where, int size) {
    return where == PixelSample::whole ? size / 2 : size * 0.5;
}

/// The viewport point of sample i of n in column x, as a fraction of the picture's width from its middle.
template <class T> HWY_INLINE T viewport_x(const RenderSettings& settings, PixelSample where, T x, int i) {
    return (x + T((i + offset_x(where)) / settings.samples) - T(middle(where, settings.width))) /
           T(settings.width);
}
/// The same of sample j in row y, upwards.
HWY_INLINE double viewport_y(const RenderSettings& settings, PixelSample where, int y, int j) {
    return (middle(where, settings.height) - (y + (j + offset_y(where)) / settings.samples)) /
           settings.height;
}

inline void make_camera_rays(const World& world, const TileJob& job, int i, int j, RayQueue& rays) {
    const PreparedCamera& camera = world.camera;
    const PixelSample where = world.conventions.pixel_sample;
    const bool orthographic = camera.projection == Projection::orthographic;
    const bool unit = world.conventions.ray_direction == RayDirection::unit;
    const Triple<Doubles> position = lanes_of(camera.position), right = lanes_of(camera.right),
                          forward = lanes_of(camera.forward);
    const int count = job.width * job.height;
    rays.clear();
    rays.reserve(count);
    double *o[3], *d[3];
    for (int a = 0; a < 3; ++a) {
        o[a] = rays.column(k_ray_origin + a);
        d[a] = rays.column(k_ray_direction + a);
    }
    for_each_row(job, [&](int x, int y, int first, int width) HWY_ATTR {
        const Triple<Doubles> above = lanes_of(camera.up * viewport_y(world.settings, where, job.y + y, j));
        for (int c = 0; c < width; c += lane_count<double>()) {
            const Doubles column = Doubles(static_cast<double>(job.x + x + c)) + iota();
            const Triple<Doubles> across = right * viewport_x(world.settings, where, column, i) + above;
            const Triple<Doubles> origin = orthographic ? position + across : position;
            Triple<Doubles> direction = orthographic ? forward : forward + across;
            if (unit) direction = normalize(direction);
            store_triple(origin, o, first + c);
            store_triple(direction, d, first + c);
        }
    });
    std::fill_n(rays.column(k_ray_t_min), count, world.conventions.camera_t_min);
    std::fill_n(rays.column(k_ray_t_max), count, std::numeric_limits<double>::infinity());
    rays.grow(count);
    rays.end_group();
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
