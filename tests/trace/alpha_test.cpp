// SPDX-License-Identifier: Apache-2.0
// Alpha: the part of a pixel that shows the background directly or through glass.
#include <gtest/gtest.h>

#include "glint/explain.h"
#include "trace/pictures.h"

namespace glint::test {
namespace {

RenderOptions with_layers() {
    RenderOptions options;
    for (const LayerInfo& info : layer_infos()) options.layers.push_back(info.layer);
    return options;
}
const std::vector<float>& of(const Rendering& r, Layer layer) {
    return r.layers[static_cast<std::size_t>(layer)].values;
}
Rendering rendering(Scene scene, bool alpha, RenderOptions options = with_layers()) {
    scene.settings.alpha = alpha;
    return render(*make_world(scene), options).value();
}

// A pane of glass in front of a part of the background, a mirror in front of another part.
Scene panes() {
    Scene scene;
    set_size(scene, 64, 33);
    scene.background = {0.25, 0.5, 1};
    scene.camera.projection = Projection::orthographic;
    scene.camera.width = 4;
    Material glass;
    glass.ambient = glass.diffuse = {0, 0, 0};
    glass.transmission = 0.5;
    glass.transmission_tint = {1, 0.5, 0.3};
    Material mirror;
    mirror.ambient = mirror.diffuse = {0, 0, 0};
    mirror.mirror = 0.5;
    add_material(scene, glass);
    add_material(scene, mirror);
    scene.lights = {ambient_light({1, 1, 1})};
    // Columns 0 to 15: glass; 16 to 31: nothing; 32 to 47: a mirror; from 48 on: glass before the mirror.
    scene.polygon_vertices = {{-2, -2, -3}, {-1, -2, -3}, {-1, 2, -3}, {-2, 2, -3}, {0, -2, -4}, {2, -2, -4},
                              {2, 2, -4},   {0, 2, -4},   {1, -2, -3}, {2, -2, -3}, {2, 2, -3},  {1, 2, -3}};
    scene.add(Polygon{0, 4}, 0);
    scene.add(Polygon{4, 4}, 1);
    scene.add(Polygon{8, 4}, 0);
    return scene;
}

TEST(Alpha, KnownValues) {
    const Scene scene = panes();
    const Rendering plain = rendering(scene, false), alpha = rendering(scene, true);
    const auto at = [](const Rendering& r, int x) {
        return of(r, Layer::alpha)[static_cast<std::size_t>(x)];
    };
    for (const Rendering* r : {&plain, &alpha}) {
        EXPECT_FLOAT_EQ(at(*r, 3), static_cast<float>(1 - 0.5 * (1 + 0.5 + 0.3) / 3));
        EXPECT_EQ(at(*r, 20), 0);
        EXPECT_EQ(at(*r, 40), 1);
        EXPECT_EQ(at(*r, 60), 1);
    }
    const auto picture = [](const Rendering& r, int x) { return r.image.pixel(x, 0); };
    EXPECT_EQ(picture(alpha, 3), (Color{0, 0, 0}));
    EXPECT_FLOAT_EQ(static_cast<float>(picture(plain, 3).g), 0.5f * 0.5f * 0.5f);
    EXPECT_EQ(picture(alpha, 20), (Color{0, 0, 0}));
    EXPECT_EQ(picture(plain, 20), (Color{0.25, 0.5, 1}));
    for (const int x : {40, 60}) {
        EXPECT_EQ(picture(alpha, x), picture(plain, x)) << x;
        EXPECT_GT(picture(alpha, x).b, 0.03) << x;  // 60: twice through the glass
    }
    EXPECT_FALSE(plain.has_alpha);
    EXPECT_TRUE(alpha.has_alpha);
}

// POV-Ray 3.7: an opaque background stays, one with transmit loses a part.
TEST(Alpha, ABackgroundWithAlphaStays) {
    Scene scene = panes();
    const Rendering plain = rendering(scene, false), left_out = rendering(scene, true);
    for (const double opacity : {1.0, 0.25}) {
        scene.conventions.background_alpha = opacity;
        const Rendering kept = rendering(scene, true);
        EXPECT_EQ(kept.image.rgb, plain.image.rgb) << "the background has its color as it is";
        for (std::size_t p = 0; p < of(kept, Layer::alpha).size(); ++p) {
            const double lost = 1 - of(left_out, Layer::alpha)[p];
            ASSERT_FLOAT_EQ(of(kept, Layer::alpha)[p], static_cast<float>(1 - lost * (1 - opacity))) << p;
        }
        // Adaptive sampling and tiles without hits follow the same rule.
        scene.shapes.clear();
        EXPECT_EQ(rendering(scene, true).image.rgb, rendering(scene, false).image.rgb);
        scene = panes();
    }
}

TEST(Alpha, BlackBehindGlassIsOpaque) {
    Scene scene = panes();
    scene.conventions.mirror_miss = MissRule::black;
    const Rendering alpha = rendering(scene, true);
    EXPECT_EQ(of(alpha, Layer::alpha)[3], 1);
    EXPECT_EQ(of(alpha, Layer::alpha)[20], 0);
}

// Shapes of all kinds: opaque, mirrors, and glass without a color.
Scene mixture() {
    Random random(23);
    Scene scene = random_scene(random, 40, 6);
    std::erase_if(scene.shapes, [](const Shape& shape) { return shape.kind == ShapeKind::plane; });
    set_size(scene, 75, 50);
    scene.settings.samples = 2;
    scene.settings.reflections = 5;
    scene.background = {0.2, 0.3, 0.9};
    scene.camera.position = {0, 2, 22};
    scene.camera.look_at = {0, 0, 0};
    mix_mirrors_and_glass(scene);
    scene.lights = {ambient_light({0.3, 0.3, 0.3}), point_light({5, 9, 19})};
    return scene;
}

TEST(Alpha, ComposedOverItsBackgroundItIsThePicture) {
    const Scene scene = mixture();
    const Rendering plain = rendering(scene, false), alpha = rendering(scene, true);
    EXPECT_EQ(of(plain, Layer::alpha), of(alpha, Layer::alpha));
    int partly = 0, clear = 0;
    const double background[3] = {scene.background.r, scene.background.g, scene.background.b};
    for (std::size_t p = 0; p < of(alpha, Layer::alpha).size(); ++p) {
        const float a = of(alpha, Layer::alpha)[p];
        ASSERT_GE(a, 0);
        ASSERT_LE(a, 1);
        partly += a > 0.01f && a < 0.99f ? 1 : 0;
        clear += a == 0 ? 1 : 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t i = 3 * p + c;
            ASSERT_NEAR(alpha.image.rgb[i] + (1 - a) * background[c], plain.image.rgb[i], 1e-6) << p;
            // The other layers keep their bits.
            for (const Layer layer : {Layer::ambient, Layer::diffuse, Layer::specular, Layer::reflection})
                ASSERT_EQ(of(alpha, layer)[i], of(plain, layer)[i]);
            ASSERT_EQ(of(alpha, Layer::background)[i], 0);
        }
    }
    EXPECT_GT(partly, 200);
    EXPECT_GT(clear, 200);
}

TEST(Alpha, CropsThreadsAndInstructionSets) {
    for (const std::optional<double> threshold : {std::optional<double>(), std::optional<double>(0.05)}) {
        Scene scene = mixture();
        scene.settings.aa_threshold = threshold;
        const Rendering whole = rendering(scene, true);
        EXPECT_EQ(rendering(scene, true, {}).image.rgb, whole.image.rgb) << "layers change the picture";
        Random random(5);
        for (int i = 0; i < 20; ++i) {
            RenderOptions options = with_layers();
            Crop crop{1 + below(random, 50), 1 + below(random, 40), 0, 0};
            crop.x = below(random, scene.settings.width - crop.width + 1);
            crop.y = below(random, scene.settings.height - crop.height + 1);
            options.crop = crop;
            const auto isas = isa_names();
            options.isa = isas[static_cast<std::size_t>(i) % isas.size()];
            options.threads = 1 + below(random, 3);
            const Rendering part = rendering(scene, true, options);
            for (int y = 0; y < crop.height; ++y) {
                for (int x = 0; x < crop.width; ++x) {
                    ASSERT_EQ(part.image.pixel(x, y), whole.image.pixel(crop.x + x, crop.y + y));
                    ASSERT_EQ(of(part, Layer::alpha)[static_cast<std::size_t>(y * crop.width + x)],
                              of(whole, Layer::alpha)[static_cast<std::size_t>(
                                  (crop.y + y) * scene.settings.width + crop.x + x)]);
                }
            }
        }
    }
}

TEST(Alpha, AdaptiveSamplingComparesIt) {
    // A black ball before a black background: only alpha has an edge.
    Scene scene;
    set_size(scene, 40, 40);
    scene.add(Sphere{{0, 0, -5}, 1});
    scene.settings.samples = 4;
    const Rendering all = rendering(scene, true);
    scene.settings.aa_threshold = 0.1;
    const Rendering adaptive = rendering(scene, true);
    EXPECT_EQ(of(adaptive, Layer::alpha), of(all, Layer::alpha));
    EXPECT_LT(adaptive.rays.camera, all.rays.camera / 2);
}

TEST(Alpha, ExplainedAsDrawn) {
    Scene scene = mixture();
    scene.settings.alpha = true;
    const std::optional<World> world = make_world(scene);
    const Rendering whole = rendering(scene, true);
    int partly = 0;
    for (int y = 0; y < 50; y += 2) {
        for (int x = 0; x < 75; x += 3) {
            const Explanation e = explain(scene, *world, x, y).value();
            const float alpha = of(whole, Layer::alpha)[static_cast<std::size_t>(y * 75 + x)];
            ASSERT_EQ(e.alpha, alpha);
            ASSERT_EQ((Color{e.value[0], e.value[1], e.value[2]}), whole.image.pixel(x, y));
            double sum = 0;
            for (const ExplainedRay& ray : e.rays) {
                if (!ray.transparent) continue;
                ASSERT_FALSE(ray.hit);
                ASSERT_EQ(ray.background, (Color{0, 0, 0}));
                sum += (ray.weight.r + ray.weight.g + ray.weight.b) / 3;
            }
            ASSERT_EQ(static_cast<float>(1 - sum / 4), alpha) << x << ',' << y;
            partly += alpha > 0 && alpha < 1 ? 1 : 0;
        }
    }
    EXPECT_GT(partly, 30);
}

TEST(Alpha, UnlitShading) {
    for (const Shading shading : {Shading::color, Shading::normals}) {
        Scene scene = mixture();
        scene.settings.shading = shading;
        const Rendering alpha = rendering(scene, true), plain = rendering(scene, false);
        for (std::size_t p = 0; p < of(alpha, Layer::alpha).size(); ++p) {
            const float a = of(alpha, Layer::alpha)[p];
            if (a == 1) {
                ASSERT_EQ(alpha.image.rgb[3 * p + 2], plain.image.rgb[3 * p + 2]);
            }
            if (a == 0) {
                ASSERT_EQ(alpha.image.rgb[3 * p + 2], 0);
            }
        }
    }
}

}  // namespace
}  // namespace glint::test
