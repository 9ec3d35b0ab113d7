// SPDX-License-Identifier: Apache-2.0
// The frustum of a tile contains its camera rays, for every position of a ray in its pixel.
#include "trace/rays/tile_culling-inl.h"

#include <gtest/gtest.h>

#include "math/transform.h"
#include "world/prepare_camera.h"

namespace glint::test {
namespace {

namespace plain = HWY_NAMESPACE;

WorldParts view(PixelSample where, int samples) {
    WorldParts world;
    world.settings.width = 101;  // odd: the centre for PixelSample::whole differs by half a pixel
    world.settings.height = 67;
    world.settings.samples = samples;
    world.conventions.pixel_sample = where;
    Camera camera;
    camera.position = {1, 2, 3};
    camera.look_at = {-2, 1, -5};
    world.camera = prepare_camera(camera, world.settings);
    return world;
}

// The largest signed cosine between a plane's outward normal and a ray. Below 0: all rays are inside.
double greatest_cosine(const WorldParts& world, const TileJob& job) {
    const plain::TileFrustum frustum = plain::tile_frustum(world, job);
    EXPECT_TRUE(frustum.exists);
    double greatest = -1;
    for (int j = 0; j < world.settings.samples; ++j) {
        for (int i = 0; i < world.settings.samples; ++i) {
            RayBatch rays;
            plain::make_camera_rays(world, job, SampleIndex{i, j, world.settings.samples}, rays);
            for (std::size_t r = 0; r < static_cast<std::size_t>(rays.count); ++r) {
                const Vec3 d{rays.direction[0][r], rays.direction[1][r], rays.direction[2][r]};
                for (const Vec3& n : frustum.outward)
                    greatest = std::max(greatest, dot(n, d) / (length(n) * length(d)));
            }
        }
    }
    return greatest;
}

TEST(TileCulling, FrustumContainsTheRaysByAPixel) {
    for (const PixelSample where :
         {PixelSample::center, PixelSample::corner, PixelSample::whole, PixelSample::top_right}) {
        for (const int samples : {1, 3}) {
            const WorldParts world = view(where, samples);
            const double pixel = length(world.camera.right) / world.settings.width;
            for (const auto& [x, y] : {std::pair{0, 0}, std::pair{32, 32}, std::pair{96, 64}}) {
                TileJob job;
                job.x = x;
                job.y = y;
                job.width = std::min(k_tile_side, world.settings.width - x);
                job.height = std::min(k_tile_side, world.settings.height - y);
                // Pixels at the picture's edge subtend smaller angles than in the centre.
                EXPECT_LT(greatest_cosine(world, job), -0.5 * pixel)
                    << static_cast<int>(where) << ' ' << samples << ' ' << x << ',' << y;
            }
        }
    }
}

}  // namespace
}  // namespace glint::test
