// SPDX-License-Identifier: Apache-2.0
// The camera's angle of view: too wide, or written in radians.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "check/checks.h"
#include "math/elementary.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint {
namespace {

constexpr double k_widest = 150;       // degrees; at the edge, shapes are stretched by a factor of 15
constexpr double k_radian_view = 2.1;  // degrees; in radians, 120 degrees
constexpr std::size_t k_max_things = 2;
constexpr double k_min_bounded = 0.03;     // of the wide picture
constexpr std::int32_t k_view_side = 160;  // rays a side

struct View {
    std::size_t things = 0;  // different ones in the picture: shapes, and the background
    double bounded = 0;      // the share of the picture that shows bounded shapes
};

View view_of(const CheckContext& context, const WorldParts& world) {
    const RayList rays = camera_rays(world, small_size(world.settings, k_view_side));
    const HitList hits = nearest_surfaces(world, rays, context.threads());
    std::set<std::uint32_t> seen;
    std::size_t bounded = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const SurfaceId id = hits.surface[i];
        bounded += world.geometry->is_bounded(id) ? 1 : 0;
        if (seen.size() <= k_max_things) seen.insert(id.exists() ? world.geometry->shape_of(id) : k_none);
    }
    return {seen.size(), static_cast<double>(bounded) / static_cast<double>(rays.size())};
}

// The camera with its angle of `radians` instead of degrees.
Camera in_radians(Camera camera, double degrees) {
    if (!camera.frame) {
        camera.fov_degrees *= k_degrees_per_radian;
        return camera;
    }
    const double wider = tan_degrees(degrees * k_degrees_per_radian / 2) / tan_degrees(degrees / 2);
    camera.frame->right = camera.frame->right * wider;
    camera.frame->up = camera.frame->up * wider;
    return camera;
}

}  // namespace

bool check_view_angle(CheckContext& context) {
    const Camera& camera = context.scene().camera;
    if (camera.projection != Projection::perspective) return true;
    const PreparedCamera& c = context.world().camera;
    const double width = length(c.right), height = length(c.up), focal = length(c.forward);
    const bool across = width >= height;
    const double widest = 2 * atan2(0.5 * std::max(width, height), focal) * k_degrees_per_radian;
    if (widest >= k_widest) {
        const double tangent = 0.5 * std::max(width, height) / focal;
        context.report(
            "camera-view-too-wide", context.at_camera(),
            fmt::format("the camera sees {:.4g} degrees from {}: at the edge of the picture shapes are "
                        "stretched {:.0f} times as much as in its middle",
                        widest, across ? "left to right" : "top to bottom", 1 + tangent * tangent),
            "use an angle of view from 30 to 90 degrees, and move the camera back if it sees too little");
        return true;
    }
    const double angle =
        camera.has_fov() ? camera.fov_degrees : 2 * atan2(0.5 * width, focal) * k_degrees_per_radian;
    if (angle > k_radian_view || context.world().geometry->count == 0) return true;
    const View now = view_of(context, context.world());
    if (now.things > k_max_things) return true;
    const Result<World> wide = with_camera(context.prepared(), in_radians(camera, angle));
    if (!wide) return true;
    const View then = view_of(context, wide->parts());
    // From so far away that it needs a telescope, a wide view shows almost nothing.
    if (then.things <= now.things || then.bounded < k_min_bounded) return true;
    context.report("camera-angle-in-radians", context.at_camera(),
                   fmt::format("the camera sees an angle of only {:.4g} degrees, in which there {}: is the "
                               "angle in radians? {:.4g} radians are {:.3g} degrees",
                               angle, now.things == 1 ? "is one thing" : "are two things", angle,
                               angle * k_degrees_per_radian),
                   fmt::format("write the angle in degrees: {:.3g}", angle * k_degrees_per_radian));
    return false;
}

}  // namespace glint
