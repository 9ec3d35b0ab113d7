// SPDX-License-Identifier: Apache-2.0
// From the picture to the world and back: viewport_ray and CameraProjection.
#include "world/camera_projection.h"

#include <gtest/gtest.h>

#include "trace/rays/camera_rays-inl.h"
#include "world/prepare_camera.h"

namespace glint::test {
namespace {

PreparedCamera tilted_camera(Projection projection) {
    Camera camera;
    camera.projection = projection;
    camera.position = {3, -2, 5};
    camera.look_at = {-1, 0.5, -4};
    camera.up = {0.1, 1, 0.3};
    camera.width = 7;
    RenderSettings settings;
    settings.width = 160;
    settings.height = 90;
    return prepare_camera(camera, settings);
}

TEST(CameraProjection, FindsTheViewportPointOfARay) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const PreparedCamera camera = tilted_camera(projection);
        const CameraProjection inverse(camera);
        for (const double sx : {-0.5, -0.2, 0.0, 0.5}) {
            for (const double sy : {-0.5, 0.1, 0.5}) {
                const auto ray = HWY_NAMESPACE::viewport_ray(camera, sx, sy);
                for (const double t : {0.25, 1.0, 40.0}) {
                    const CameraCoordinates found = inverse.coordinates(ray.origin + ray.direction * t);
                    const double size = projection == Projection::perspective ? found.depth : 1;
                    EXPECT_NEAR(found.x / size, sx, 1e-12);
                    EXPECT_NEAR(found.y / size, sy, 1e-12);
                    EXPECT_NEAR(found.depth, t, 1e-12 * t);
                }
            }
        }
    }
}

}  // namespace
}  // namespace glint::test
