// SPDX-License-Identifier: Apache-2.0
// Memory past the current rays and hits: the kernels read no further than the padding, and the contents of
// earlier pictures have no effect.
#include <gtest/gtest.h>

#include <memory>

#include "trace/pictures.h"
#include "trace/rays.h"

namespace glint::test {
namespace {

/// Columns with exactly the guaranteed padding.
class ExactRays {
  public:
    explicit ExactRays(const Rays& rays) {
        const RaySpan s = rays.span();
        const double* from[8] = {s.ox, s.oy, s.oz, s.dx, s.dy, s.dz, s.t_min, s.t_max};
        const auto padded = static_cast<std::size_t>(rays.size() + k_ray_padding);
        for (int c = 0; c < 8; ++c) {
            column_[c] = std::make_unique<double[]>(padded);
            std::copy_n(from[c], padded, column_[c].get());
        }
    }
    RaySpan span() const {
        const auto at = [&](int c) { return column_[c].get(); };
        return {at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
    }

  private:
    std::unique_ptr<double[]> column_[8];
};

TEST(Scratch, NothingIsReadPastTheRaysPadding) {  // reported by the address sanitizer
    Scene scene;
    scene.add(Triangle{{Vec3{-5, -5, -5}, Vec3{5, -5, -5}, Vec3{0, 5, -5}}});
    scene.add(Sphere{{0, 0, -7}, 1});
    const std::optional<World> world = make_world(scene);
    ASSERT_TRUE(world);
    for (int count = 1; count < 60; ++count) {
        for (int aside = 0; aside < std::min(count, 20); ++aside) {
            Rays rays;  // the first ones have other directions, so that the packet of the others starts at
                        // any index
            for (int i = 0; i < count; ++i)
                rays.push({0, 0, 0},
                          i < aside ? Vec3{0, i % 2 != 0 ? 1.0 : -1.0, 0} : Vec3{0.003 * i, 0, -1});
            const ExactRays exact(rays);
            const auto padded = static_cast<std::size_t>(count + k_ray_padding);
            for (const Kernels& kernels : available_kernels()) {
                const auto t = std::make_unique<double[]>(padded);
                const auto slot = std::make_unique<std::uint32_t[]>(padded);
                const auto element = std::make_unique<std::uint32_t[]>(padded);
                const auto occluded = std::make_unique<std::uint8_t[]>(padded);
                kernels.nearest_hit(world->parts(), exact.span(), count, k_packet_size,
                                    {t.get(), slot.get(), element.get()});
                kernels.any_hit(world->parts(), exact.span(), count, k_packet_size, occluded.get());
                int hit = 0, dark = 0;
                for (int i = 0; i < count; ++i) {
                    hit += slot[static_cast<std::size_t>(i)] != k_none;
                    dark += occluded[static_cast<std::size_t>(i)];
                }
                EXPECT_EQ(hit, count - aside) << kernels.isa;
                EXPECT_EQ(dark, count - aside) << kernels.isa;
            }
        }
    }
}

/// Glass whose material is the last of `count`.
Scene glass_scene(std::uint32_t materials) {
    Scene scene;
    Material glass;
    glass.mirror = 0.4, glass.transmission = 0.5, glass.ior = 1.3;
    glass.mirror_tint = glass.transmission_tint = {1, 1, 1};
    scene.materials.assign(materials, glass);
    scene.lights.emplace_back();
    scene.settings.width = scene.settings.height = 32;
    scene.settings.reflections = 5;
    return scene;
}

TEST(Scratch, EarlierPicturesWithMoreMaterialsHaveNoEffect) {
    constexpr std::uint32_t many = 400000;
    Scene big = glass_scene(many);
    big.add(Sphere{{0, 0, 0}, 100}, many - 1);  // fills the picture
    Random random(7);
    Scene small = glass_scene(1);
    for (int i = 0; i < 24; ++i)
        small.add(Sphere{point_in_cube(random, 0.3) + Vec3{0, 0, i % 2 == 0 ? -8.0 : 8.0}, 0.3}, 0);
    for (const std::string& isa : isa_names()) {
        RenderOptions options;
        options.isa = isa;
        options.threads = 1;
        {
            const std::optional<World> world = make_world(big);
            ASSERT_TRUE(world);
            render_world(*world, options);
        }
        const std::optional<World> world = make_world(small);
        ASSERT_TRUE(world);
        const Result<Rendering> result = render(*world, options);  // a regression: read past the materials
        ASSERT_TRUE(result);
        EXPECT_GT(result->rays.transmitted, 100u);
    }
}

}  // namespace
}  // namespace glint::test
