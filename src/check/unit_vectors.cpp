// SPDX-License-Identifier: Apache-2.0
// Vectors that are used as unit vectors and are not, and camera frames that distort.
#include <fmt/format.h>

#include "check/checks.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint {
namespace {

constexpr double k_slack = 0.01;  // files round: (0.62, -0.78, 0)

bool is_unit(Vec3 v) { return number::abs(length(v) - 1) <= k_slack; }

void check_shape_normals(CheckContext& context) {
    const Scene& scene = context.scene();
    const UnitNormals& source = scene.unit_normals;
    if (!source.of_planes && !source.of_vertices) return;
    std::vector<std::uint32_t> found;
    Vec3 example;
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
        const Shape& shape = scene.shapes[i];
        const auto look = [&](Vec3 n) {
            if (is_unit(n) || (!found.empty() && found.back() == i)) return;
            if (found.empty()) example = n;
            found.push_back(i);
        };
        if (source.of_planes && shape.kind == ShapeKind::plane) look(scene.get<Plane>()[shape.index].normal);
        if (source.of_vertices && shape.kind == ShapeKind::smooth_triangle)
            for (const Vec3& n : scene.get<SmoothTriangle>()[shape.index].normals) look(n);
    }
    if (found.empty()) return;
    const Vec3 unit = normalize(example);
    context.report(
        "normal-not-unit", context.at_shape(found.front()),
        fmt::format("the normal {} of {} has the length {:.4g}: {}{}", vector_text(example),
                    context.shape(found.front()), length(example), source.reason,
                    found.size() == 1 ? "" : fmt::format("; {} shapes have such normals", found.size())),
        fmt::format("write {}", vector_text(unit)));
}

void check_light_directions(CheckContext& context) {
    const Scene& scene = context.scene();
    if (scene.conventions.normalize) return;
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        if (!light.has_direction() || is_unit(light.to_light)) continue;
        context.report(
            "direction-not-unit", context.at_light(i),
            fmt::format(
                "the direction {} of {} has the length {:.4g}, and normalize = false does not change it: "
                "the light is {:.4g} times as strong",
                vector_text(light.to_light), context.light(i), length(light.to_light),
                length(light.to_light)),
            fmt::format("write {}", vector_text(normalize(light.to_light))));
    }
}

void check_frame(CheckContext& context) {
    const Scene& scene = context.scene();
    if (!scene.camera.frame) return;
    const CameraFrame& f = *scene.camera.frame;
    const double skew = number::abs(dot(normalize(f.right), normalize(f.up)));
    // Where the viewport's point gives the length of a ray, the frame must be a rotation of the viewport.
    const bool rotation = scene.conventions.ray_direction == RayDirection::viewport;
    const Vec3 lengths =
        scene.unit_normals.frame_lengths.value_or(Vec3{length(f.right), length(f.up), length(f.forward)});
    const bool turned = rotation && (number::abs(dot(normalize(f.right), normalize(f.forward))) > k_slack ||
                                     number::abs(dot(normalize(f.up), normalize(f.forward))) > k_slack ||
                                     !is_unit(f.right / lengths.x) || !is_unit(f.up / lengths.y) ||
                                     !is_unit(f.forward / lengths.z));
    if (skew <= k_slack && !turned) return;
    context.report("camera-frame-skewed", context.at_camera(),
                   fmt::format("the camera's right {}, up {} and forward {} {}: the picture is distorted",
                               vector_text(f.right), vector_text(f.up), vector_text(f.forward),
                               skew > k_slack ? "are not at right angles" : "are not a rotation"),
                   rotation ? "give a rotation of three unit vectors at right angles to each other"
                            : "make up perpendicular to right");
}

}  // namespace

void check_vectors(CheckContext& context) {
    check_shape_normals(context);
    check_light_directions(context);
    check_frame(context);
}

}  // namespace glint
