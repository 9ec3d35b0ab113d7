// SPDX-License-Identifier: Apache-2.0
// Parallel lights: POV-Ray's shine from a plane, glint's from an infinite distance.
#include <algorithm>

#include "formats/povray/reach.h"
#include "formats/povray/scene_builder.h"
#include "math/number.h"

namespace glint::povray {
namespace {

constexpr std::uint64_t k_max_light_tests = 100'000'000;

}  // namespace

// Warns of parallel lights beyond whose planes are shapes: in POV-Ray these cast no shadows.
void SceneBuilder::check_parallel_lights() {
    // The first of them is named; texts of very many shapes and lights are not searched to the end.
    std::uint64_t tests = 0, tests_of_light = 0;
    if (parallel_lights_.empty()) return;
    for (const Shape& shape : scene_.shapes) tests_of_light += reach_steps(scene_, shape);
    for (const ParallelLight& light : parallel_lights_) {
        if ((tests += tests_of_light) > k_max_light_tests) return;
        const auto is_beyond = [&](const Shape& shape) {
            if (shape.material < scene_.materials.size() && !scene_.materials[shape.material].casts_shadow) {
                return false;
            }
            const Vec3 d = light.to_light, at = light.position;
            if (shape.kind == ShapeKind::plane) {
                // On the eye's side the plane is beyond the light, and the light comes through it.
                const Plane& plane = scene_.get<Plane>()[shape.index];
                const double eye = dot(plane.normal, scene_.camera.position - plane.point);
                const double own = dot(plane.normal, at - plane.point), way = dot(plane.normal, d);
                return eye * way < 0 && eye * own > 0;
            }
            const double limit = dot(d, at) + 1e-9 * (1 + number::abs(dot(d, at)));
            return reach(scene_, shape, d).value_or(limit) > limit;
        };
        const auto& shapes = scene_.shapes;
        if (std::any_of(shapes.begin(), shapes.end(), is_beyond)) {
            return report({"parallel", "a light whose plane does not have all shapes on one side", light.at});
        }
    }
}

}  // namespace glint::povray
