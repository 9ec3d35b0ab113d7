// SPDX-License-Identifier: Apache-2.0
// Transparent surfaces before area lights that shine from their centre, and in the light from all directions.
#include <gtest/gtest.h>

#include "glint/explain.h"
#include "trace/pictures.h"
#include "trace/sheets.h"

namespace glint::test {
namespace {

constexpr double k_infinite = std::numeric_limits<double>::infinity();

// A white floor under a panel of columns x rows samples, seen from below the shapes between them.
Scene floor_under_panel(std::int32_t columns, std::int32_t rows) {
    Scene scene;
    set_size(scene, 41, 31);
    scene.conventions.area_shading = AreaShading::center;
    Material white = sheet({1, 1, 1}, 0, 0);
    white.ambient = {0, 0, 0};
    white.diffuse = {1, 1, 1};
    scene.add(Plane{{0, 0, 0}, {0, 1, 0}}, add_material(scene, white));
    Light light = point_light({0, 6, 0}, {0.9, 0.8, 0.7});
    light.kind = LightKind::parallelogram;
    light.side_u = {3, 0, 0};
    light.side_v = {0, 0, 2};
    light.samples_u = columns;
    light.samples_v = rows;
    scene.lights = {light};
    scene.camera.position = {0, 1, 6};
    scene.camera.look_at = {0, 0, 0};
    return scene;
}

TEST(ColoredAreaShadows, APaneBeforeAllSamplesColorsTheLight) {
    Scene scene = floor_under_panel(3, 4);
    const Image clear = render_scene(scene);
    scene.add(Plane{{0, 2, 0}, {0, 1, 0}}, add_material(scene, sheet({1, 0.5, 0.25}, 0.5, 0.25)));
    for (const std::int32_t adaptive : {0, k_all_levels}) {
        scene.lights[0].adaptive = adaptive;
        const Image colored = render_scene(scene);
        for (int x = 0; x < 41; x += 4) {
            const Color a = clear.pixel(x, 25), b = colored.pixel(x, 25);
            ASSERT_GT(a.r, 0.1);
            EXPECT_NEAR(b.r, a.r * 0.75, 1e-6);
            EXPECT_NEAR(b.g, a.g * 0.5, 1e-6);
            EXPECT_NEAR(b.b, a.b * 0.375, 1e-6);
        }
    }
    scene.conventions.transparent_shadow = TransparentShadow::none;
    EXPECT_EQ(render_scene(scene).pixel(20, 25), clear.pixel(20, 25));
    scene.conventions.transparent_shadow = TransparentShadow::opaque;
    EXPECT_EQ(render_scene(scene).pixel(20, 25), (Color{0, 0, 0}));
}

// A transparent disc and an opaque one, each before some of the samples.
Scene panel_and_discs(std::int32_t columns, std::int32_t rows) {
    Scene scene = floor_under_panel(columns, rows);
    const std::uint32_t pane = add_material(scene, sheet({0.9, 0.5, 0.2}, 0.6, 0.3));
    scene.add(Disc{.center = {0.3, 3, 0.2}, .normal = {0, 1, 0}, .radius = 0.8}, pane);
    scene.add(Sphere{.center = {-0.7, 2, 0.4}, .radius = 0.4}, pane);
    scene.add(Disc{.center = {-0.4, 3.5, -0.3}, .normal = {0, 1, 0}, .radius = 0.5}, 0);
    return scene;
}

TEST(ColoredAreaShadows, AreTheMeanOfTheSamples) {
    int partly = 0;
    for (const bool jitter : {false, true}) {
        Scene scene = panel_and_discs(2, 2);
        scene.lights[0].jitter = jitter;
        const std::optional<World> world = make_world(scene);
        for (int y = 14; y < 31; y += 2) {
            for (int x = 0; x < 41; ++x) {
                const Explanation e = explain(scene, *world, x, y).value();
                if (!e.rays[0].hit || e.rays[0].hit->shape != 0) continue;
                const LightTerms& terms = e.rays[0].hit->lights.at(0);
                ASSERT_EQ(terms.samples.size(), 4u);
                Color mean;
                for (const ShadowSample& sample : terms.samples) {
                    Color product{1, 1, 1};
                    double before = -1;
                    for (const ShadowFilter& filter : sample.filters) {
                        product = product * filter.factor;
                        ASSERT_GE(filter.distance, before);
                        before = filter.distance;
                    }
                    if (sample.blocked) continue;
                    ASSERT_NEAR(product.r, sample.filter.r, 1e-12);
                    ASSERT_NEAR(product.b, sample.filter.b, 1e-12);
                    mean = mean + product * 0.25;
                    partly += !sample.filters.empty() && !terms.samples[0].blocked;
                }
                ASSERT_NEAR(terms.filter.r, mean.r, 1e-12);
                ASSERT_NEAR(terms.filter.b, mean.b, 1e-12);
                ASSERT_NEAR(terms.visible, (mean.r + mean.g + mean.b) / 3, 1e-12);
                ASSERT_EQ(terms.blocked, mean.r == 0);
            }
        }
    }
    EXPECT_GT(partly, 100);
}

// POV-Ray divides where the colored light of two corners differs by more than 0.1.
TEST(ColoredAreaShadows, QuarteringDependsOnTheColor) {
    const auto rays = [](double transmit) {
        Scene scene = floor_under_panel(5, 5);
        scene.lights[0].color = {1, 1, 1};
        scene.lights[0].adaptive = 0;
        scene.add(Disc{.center = {2, 3, 0}, .normal = {0, 1, 0}, .radius = 2},
                  add_material(scene, sheet({0, 0, 0}, 0, transmit)));
        scene.camera.position = {0, 1.5, 6};
        return render(*make_world(scene)).value().rays.shadow;
    };
    EXPECT_EQ(rays(0.97) % 4, 0u);  // differs by 0.09
    EXPECT_EQ(rays(0.98), rays(0.97));
    EXPECT_GT(rays(0.96), rays(0.97));  // by 0.12
}

bool nearly(Color a, Color b) {
    return std::abs(a.r - b.r) < 1e-12 && std::abs(a.g - b.g) < 1e-12 && std::abs(a.b - b.b) < 1e-12;
}

TEST(ColoredAreaShadows, ExplainedAsDrawn) {
    for (const std::int32_t adaptive : {0, k_all_levels}) {
        Scene scene = panel_and_discs(5, 4);
        scene.lights[0].adaptive = adaptive;
        scene.settings.samples = 2;
        const std::optional<World> world = make_world(scene);
        RenderOptions options;
        options.layers = {Layer::shadow};
        const Rendering whole = render(*world, options).value();
        for (int y = 0; y < 31; y += 2) {
            for (int x = 0; x < 41; x += 3) {
                const Explanation e = explain(scene, *world, x, y).value();
                ASSERT_EQ((Color{e.value[0], e.value[1], e.value[2]}), whole.image.pixel(x, y));
                double seen = 0;
                int tested = 0;
                for (const ExplainedRay& ray : e.rays) {
                    if (!ray.hit) continue;
                    const LightTerms& terms = ray.hit->lights.at(0);
                    ASSERT_EQ(terms.diffuse, ray.hit->diffuse);
                    Color part;
                    for (const ShadowSample& sample : terms.samples) {
                        if (!sample.blocked) part = part + sample.filter * sample.weight;
                    }
                    ASSERT_TRUE(!terms.may_add || nearly(part, terms.filter)) << x << ',' << y;
                    if (ray.generation > 0 || !terms.may_add) continue;
                    seen += terms.visible;
                    ++tested;
                }
                const float shadow = whole.layers[0].values[static_cast<std::size_t>(41 * y + x)];
                ASSERT_NEAR(shadow, tested > 0 ? 1 - seen / tested : 0, 1e-6);
            }
        }
    }
}

TEST(ColoredAreaShadows, CropsAndInstructionSets) {
    const Scene scene = panel_and_discs(6, 5);
    const std::optional<World> world = make_world(scene);
    const Image whole = render_world(*world);
    for (const std::string& isa : isa_names()) {
        RenderOptions options;
        options.isa = isa;
        options.crop = Crop{15, 11, 9, 17};
        const Image part = render_world(*world, options);
        for (int y = 0; y < 11; ++y)
            for (int x = 0; x < 15; ++x) ASSERT_EQ(part.pixel(x, y), whole.pixel(9 + x, 17 + y)) << isa;
    }
}

TEST(ColoredSky, PanesColorTheLightFromAllDirections) {
    for (const OcclusionMethod method : {OcclusionMethod::hashed, OcclusionMethod::fixed}) {
        Scene scene = floor_under_panel(1, 1);
        scene.lights.clear();
        scene.occlusion = Occlusion{method, 70, {1, 1, 1}, k_infinite, 1};
        const Color open = render_scene(scene).pixel(20, 25);
        scene.add(Plane{{0, 2, 0}, {0, 1, 0}}, add_material(scene, sheet({1, 0.5, 0.25}, 0.5, 0.25)));
        const auto color = [&]() { return render_scene(scene).pixel(20, 25); };
        const auto expect = [&](Color factor) {
            const Color c = color();
            EXPECT_NEAR(c.r, open.r * factor.r, 1e-6);
            EXPECT_NEAR(c.g, open.g * factor.g, 1e-6);
            EXPECT_NEAR(c.b, open.b * factor.b, 1e-6);
        };
        expect({0.75, 0.5, 0.375});
        const std::optional<World> world = make_world(scene);
        const Explanation e = explain(scene, *world, 20, 25).value();
        const ExplainedOcclusion& o = e.rays.at(0).hit->occlusion.value();
        EXPECT_EQ(o.blocked, 0);
        EXPECT_NEAR(o.factors.g / o.factors.r, 0.5 / 0.75, 1e-12);
        EXPECT_EQ(o.factor, (o.factors.r + o.factors.g + o.factors.b) / 3);
        scene.settings.shadows = false;
        expect({1, 1, 1});
        scene.settings.shadows = true;
        scene.conventions.transparent_shadow = TransparentShadow::none;
        expect({1, 1, 1});
        scene.conventions.transparent_shadow = TransparentShadow::opaque;
        expect({0, 0, 0});
    }
}

}  // namespace
}  // namespace glint::test
