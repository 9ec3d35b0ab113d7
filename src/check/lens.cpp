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
constexpr double k_degrees_each = 57.29577951308232;
constexpr std::int32_t k_view_side = 160;  // rays a side

// The number of different things in the picture: shapes, and the background. 3: three or more.
std::size_t things_seen(const CheckContext& context, const WorldParts& world) {
    const RayList rays = camera_rays(world, small_size(world.settings, k_view_side), 0, 0);
    const HitList hits = nearest_hits(world, rays, context.threads());
    std::set<std::uint32_t> seen;
    for (std::size_t i = 0; i < rays.size() && seen.size() < 3; ++i)
        seen.insert(hits.slot[i] == k_none ? k_none : world.geometry->shape_index[hits.slot[i]]);
    return seen.size();
}

// The camera with its angle of `radians` instead of degrees.
Camera in_radians(Camera camera, double degrees) {
    if (!camera.frame) {
        camera.fov_degrees *= k_degrees_each;
        return camera;
    }
    const double wider = tan_degrees(degrees * k_degrees_each / 2) / tan_degrees(degrees / 2);
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
    const double widest = 2 * atan2(0.5 * std::max(width, height), focal) * k_degrees_each;
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
        camera.has_fov() ? camera.fov_degrees : 2 * atan2(0.5 * width, focal) * k_degrees_each;
    if (angle > k_radian_view || context.world().geometry->count == 0) return true;
    const std::size_t now = things_seen(context, context.world());
    if (now > 1) return true;
    const Result<World> wide = with_camera(context.prepared(), in_radians(camera, angle));
    if (!wide || things_seen(context, wide->parts()) <= now) return true;
    context.report(
        "camera-angle-in-radians", context.at_camera(),
        fmt::format("the camera sees an angle of only {:.4g} degrees, in which there is one thing: is the "
                    "angle in radians? {:.4g} radians are {:.3g} degrees",
                    angle, angle, angle * k_degrees_each),
        fmt::format("write the angle in degrees: {:.3g}", angle * k_degrees_each));
    return false;
}

}  // namespace glint
