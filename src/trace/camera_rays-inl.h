// The first stage: one camera ray a pixel of the tile, in blocks of 8 x 8 so that neighbours walk together.
#if defined(GLINT_TRACE_CAMERA_RAYS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_CAMERA_RAYS_INL_H_
#undef GLINT_TRACE_CAMERA_RAYS_INL_H_
#else
#define GLINT_TRACE_CAMERA_RAYS_INL_H_
#endif

#include "simd/lanes-inl.h"
#include "trace/tile.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The viewport point of sample (i, j) of n x n in pixel (x, y), as fractions of the picture's width and
/// height from its middle.
struct ViewportPoint {
    double x, y;
};
HWY_INLINE ViewportPoint viewport_point(const RenderSettings& settings, PixelSample where, int x, int y,
                                        int i, int j) {
    const double w = settings.width, h = settings.height, n = settings.samples;
    double in_x = 0.5, in_y = 0.5;  // from the (sub)pixel's top-left corner
    double middle_x = w * 0.5, middle_y = h * 0.5;
    if (where == PixelSample::corner) in_x = 0, in_y = 1;
    if (where == PixelSample::whole) {
        in_x = in_y = 0;
        middle_x = settings.width / 2;   // NOLINT(bugprone-integer-division): whole pixels
        middle_y = settings.height / 2;  // NOLINT(bugprone-integer-division)
    }
    return {(x + (i + in_x) / n - middle_x) / w, (middle_y - (y + (j + in_y) / n)) / h};
}

HWY_INLINE void camera_ray(const World& world, ViewportPoint at, Vec3& origin, Vec3& direction) {
    const PreparedCamera& camera = world.camera;
    const Vec3 across = camera.right * at.x + camera.up * at.y;
    if (camera.projection == Projection::orthographic) {
        origin = camera.position + across;
        direction = camera.forward;
    } else {
        origin = camera.position;
        direction = camera.forward + across;
    }
    if (world.conventions.ray_direction == RayDirection::unit) {
        direction = direction / number::sqrt(glint::dot(direction, direction));
    }
}

inline void make_camera_rays(const World& world, const TileJob& job, int i, int j, RayQueue& rays) {
    constexpr int block = 8;
    rays.clear();
    for (int by = 0; by < job.height; by += block) {
        for (int bx = 0; bx < job.width; bx += block) {
            for (int y = by; y < number::min(by + block, job.height); ++y) {
                for (int x = bx; x < number::min(bx + block, job.width); ++x) {
                    const auto at = viewport_point(world.settings, world.conventions.pixel_sample, job.x + x,
                                                   job.y + y, i, j);
                    Vec3 origin, direction;
                    camera_ray(world, at, origin, direction);
                    RayPath path;
                    path.pixel = static_cast<std::uint32_t>(y * k_tile_side + x);
                    rays.push(origin, direction, world.conventions.camera_t_min,
                              std::numeric_limits<double>::infinity(), path);
                }
            }
        }
    }
    rays.end_group();
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
