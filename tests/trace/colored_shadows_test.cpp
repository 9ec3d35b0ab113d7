// SPDX-License-Identifier: Apache-2.0
// Shadows of surfaces with filter and transmit, with values known in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "glint/explain.h"
#include "math/number.h"
#include "trace/pictures.h"
#include "trace/sheets.h"

namespace glint::test {
namespace {

// A white floor under a light from above, seen from the side, with panes between them.
Scene floor_below(const std::vector<Material>& panes) {
    Scene scene;
    set_size(scene, 3, 3);
    Material white = sheet({1, 1, 1}, 0, 0);
    white.ambient = {0, 0, 0};
    white.diffuse = {1, 1, 1};
    scene.add(Plane{{0, 0, 0}, {0, 1, 0}}, add_material(scene, white));
    double height = 1;
    for (const Material& m : panes) {
        scene.add(Plane{{0, height, 0}, {0, 1, 0}}, add_material(scene, m));
        height += 0.25;
    }
    scene.lights = {directional_light({0, 1, 0})};
    scene.camera.position = {0, 0.5, 4};
    scene.camera.look_at = {0, 0, 0};
    return scene;
}
Color floor_color(const Scene& scene) { return render_scene(scene).pixel(1, 1); }

TEST(ColoredShadows, ShadowsAreColoredByEachSurface) {
    const Material red = sheet({1, 0.5, 0.25}, 0.5, 0.25), clear = sheet({0, 0, 0}, 0, 0.5);
    EXPECT_EQ(floor_color(floor_below({red})), (Color{0.75, 0.5, 0.375}));
    EXPECT_EQ(floor_color(floor_below({red, clear})), (Color{0.375, 0.25, 0.1875}));
    EXPECT_EQ(floor_color(floor_below({red, clear, sheet({1, 1, 1}, 0, 0)})), (Color{0, 0, 0}));
    for (const Vec3 position : {Vec3{0, 50, 0}, Vec3{3, 50, -2}}) {
        Scene scene = floor_below({red, clear});
        scene.lights = {point_light(position)};
        const Color c = floor_color(scene);
        EXPECT_NEAR(c.r / c.g, 1.5, 1e-6);
        EXPECT_NEAR(c.g / c.b, 4.0 / 3, 1e-6);
    }
    Scene scene = floor_below({red, clear});
    scene.conventions.transparent_shadow = TransparentShadow::none;
    EXPECT_EQ(floor_color(scene), (Color{1, 1, 1}));
    scene.conventions.transparent_shadow = TransparentShadow::opaque;
    EXPECT_EQ(floor_color(scene), (Color{0, 0, 0}));
    scene.settings.shadows = false;
    EXPECT_EQ(floor_color(scene), (Color{1, 1, 1}));
    scene = floor_below({red, clear});
    scene.materials[1].casts_shadow = false;
    EXPECT_EQ(floor_color(scene), (Color{0.5, 0.5, 0.5}));
}

TEST(ColoredShadows, ASphereHasTwoSurfaces) {
    Scene scene = floor_below({});
    scene.add(Sphere{{0, 2, 0}, 0.5}, add_material(scene, sheet({0, 0, 0}, 0, 0.4)));
    EXPECT_NEAR(floor_color(scene).r, 0.16, 1e-7);
}

TEST(ColoredShadows, SurfacesAtEqualTCountOnce) {
    const Material half = sheet({0, 0, 0}, 0, 0.5), quarter = sheet({0, 0, 0}, 0, 0.25);
    Scene scene = floor_below({half});
    scene.add(Plane{{0, 1, 0}, {0, 1, 0}}, add_material(scene, quarter));
    EXPECT_EQ(floor_color(scene), (Color{0.5, 0.5, 0.5})) << "the first in the scene";
    scene = floor_below({quarter});
    scene.add(Plane{{0, 1, 0}, {0, 1, 0}}, add_material(scene, half));
    EXPECT_EQ(floor_color(scene), (Color{0.25, 0.25, 0.25}));
}

// With a power of 2, the factor is 1 + cos^2.
TEST(ColoredShadows, CausticsMakeLightBrighterThatComesAlongTheNormal) {
    Material red = sheet({1, 0.5, 0.25}, 0.25, 0.125), clear = sheet({0, 0, 0}, 0, 0.5);
    red.caustics = 2;
    EXPECT_EQ(floor_color(floor_below({red})), (Color{0.75, 0.5, 0.375}));
    EXPECT_EQ(floor_color(floor_below({red, clear})), (Color{0.375, 0.25, 0.1875}));
    EXPECT_EQ(floor_color(floor_below({red, red})), (Color{0.5625, 0.25, 0.140625}));
    // A tilted pane, with its normal up or down.
    for (const double side : {1.0, -1.0}) {
        Scene scene = floor_below({});
        scene.add(Plane{{0, 1, 0}, Vec3{0.6, 0.8, 0} * side}, add_material(scene, red));
        EXPECT_NEAR(floor_color(scene).r, 0.375 * 1.64, 1e-7);
        scene.lights = {point_light({0, 50, 0})};
        EXPECT_NEAR(floor_color(scene).r, 0.375 * 1.64, 1e-4)
            << "the shadow ray's direction has another length";
    }
    // A sphere, 0.6 of its radius beside the centre: two surfaces with the cosine 0.8.
    Scene scene = floor_below({});
    clear.caustics = 3;
    scene.add(Sphere{{0.3, 2, 0}, 0.5}, add_material(scene, clear));
    EXPECT_NEAR(floor_color(scene).r, 0.25 * 1.512 * 1.512, 1e-7);
}

TEST(ColoredShadows, CausticsDoNotChangeLightFromAllDirections) {
    Material pane = sheet({1, 1, 1}, 0, 0.5);
    Scene scene = floor_below({pane});
    scene.lights.clear();
    scene.occlusion = Occlusion{};
    const Color before = floor_color(scene);
    EXPECT_GT(before.r, 0);
    scene.materials[1].caustics = 2;
    EXPECT_EQ(floor_color(scene), before);
}

TEST(ColoredShadows, CausticsAreExplained) {
    Material pane = sheet({1, 0.5, 0.25}, 0.25, 0.125);
    pane.caustics = 5;
    for (const bool at_a_point : {false, true}) {
        Scene scene = floor_below({pane, pane});
        if (at_a_point) scene.lights = {point_light({3, 4, -2})};
        const std::optional<World> world = make_world(scene);
        const Explanation e = explain(scene, *world, 1, 1).value();
        const LightTerms& terms = e.rays.at(0).hit->lights.at(0);
        ASSERT_EQ(terms.filters.size(), 2u);
        for (const ShadowFilter& filter : terms.filters) {
            const double cosine = number::abs(terms.to_light.y) / length(terms.to_light);
            EXPECT_NEAR(filter.factor.r, 0.375 * (1 + std::pow(cosine, 5)), 1e-8);
        }
        EXPECT_NEAR(terms.filter.r, terms.filters[0].factor.r * terms.filters[1].factor.r, 1e-12);
        const Color pixel = render(*world).value().image.pixel(1, 1);
        EXPECT_EQ(static_cast<float>(e.rays.at(0).hit->parts[1].r), static_cast<float>(pixel.r));
    }
}

TEST(ColoredShadows, LittleLightCountsAsBlocked) {
    const Material half = sheet({0, 0, 0}, 0, 0.5);
    EXPECT_EQ(floor_color(floor_below(std::vector<Material>(10, half))).r, 0x1p-10);
    EXPECT_EQ(floor_color(floor_below(std::vector<Material>(11, half))).r, 0);
    const Scene scene = floor_below(std::vector<Material>(11, half));
    const std::optional<World> world = make_world(scene);
    const Explanation e = explain(scene, *world, 1, 1).value();
    const LightTerms& terms = e.rays.at(0).hit->lights.at(0);
    EXPECT_EQ(reason(terms), LightReason::blocked);
    EXPECT_FALSE(terms.blocker);
    EXPECT_EQ(terms.filters.size(), 11u);
}

TEST(ColoredShadows, TheShadowLayerHasTheBlockedShare) {
    Scene scene = floor_below({sheet({1, 0.5, 0.25}, 0.5, 0.25)});
    RenderOptions options;
    options.layers = {Layer::shadow};
    const Rendering all = render(*make_world(scene), options).value();
    EXPECT_FLOAT_EQ(all.layers[0].values[4], 1 - (0.75f + 0.5f + 0.375f) / 3);
}

}  // namespace
}  // namespace glint::test
