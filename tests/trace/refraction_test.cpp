// SPDX-License-Identifier: Apache-2.0
// Refraction of transparent surfaces (Material::refracts): compared with glass (Material::transmission), and
// with solids that have no inner surfaces.
#include <gtest/gtest.h>

#include "explain/added_up.h"
#include "formats/load_text.h"
#include "glint/explain.h"
#include "trace/pictures.h"

namespace glint::test {
namespace {

constexpr const char* k_room = R"(
conventions { transparency = highlights  mirror = add }
render { size = 60 x 45  shading = phong  reflections = 8 }
background = (0.3, 0.4, 0.6)
camera { position = (0.1, 1.2, 5)  look_at = (0, 0.6, 0)  fov_x = 45 }
light { type = ambient }
light { type = point  position = (2, 5, 4) }
texture floor { color_map = ((0, (0.9, 0.9, 0.8)), (0.5, (0.3, 0.2, 0.2)))  mapping = checker  filter = nearest  scale = 0.4 }
plane { point = (0, -0.3, 0)  normal = (0, 1, 0)  color = (1, 1, 1)  texture = floor }
sphere { center = (0.4, 0.6, -2)  radius = 0.7  color = (0.9, 0.3, 0.2) }
)";
const std::string k_clear = "color = (1, 1, 1)  ambient = 0  diffuse = 0  casts_shadow = false  ";
const std::string k_refracts = k_clear + "transmit = 1  refracts = true  ior = ";

Scene room(const std::string& shapes) {
    auto scene = load_text(k_room + shapes, "room.glint");
    EXPECT_TRUE(scene.has_value()) << scene.message;
    return scene ? std::move(*scene) : Scene{};
}
Image picture(const std::string& shapes) { return render_scene(room(shapes)); }

// The part of the pixels that differ by more than 1e-5.
double differing(const Image& a, const Image& b) {
    EXPECT_EQ(a.rgb.size(), b.rgb.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        bool differs = false;
        for (std::size_t c = 0; c < 3; ++c)
            differs = differs || std::abs(a.rgb[i + c] - b.rgb[i + c]) > 1e-5f;
        count += differs;
    }
    return 3 * static_cast<double>(count) / static_cast<double>(a.rgb.size());
}

// Of closed shapes by themselves, glass has the same rays.
TEST(Refraction, HasTheBitsOfGlass) {
    for (const std::string shape :
         {"sphere { center = (0, 0.5, 0)  radius = 0.7 ",
          "box { min = (-0.7, 0, -0.4)  max = (0.5, 0.9, 0.6) ",
          "cylinder { from = (-0.6, 0.4, 0)  to = (0.6, 0.7, 0.3)  radius = 0.4 ",
          "torus { center = (0, 0.5, 0)  axis = (0.2, 0.4, 1)  radius = 0.6  tube = 0.25 "}) {
        for (const std::string ior : {"1.5", "0.8"}) {
            const Image refracted = picture(shape + k_refracts + ior + " }");
            EXPECT_EQ(refracted.rgb, picture(shape + k_clear + "transmission = 1  ior = " + ior + " }").rgb)
                << shape;
            EXPECT_GT(differing(refracted, picture(shape + k_clear + "transmit = 1 }")), 0.02);
        }
    }
}

// Objects of one index that overlap have no surface inside.
TEST(Refraction, OfObjectsThatOverlapKnowsBoth) {
    const std::string balls =
        "sphere { center = (-0.25, 0.5, 0)  radius = 0.55 } sphere { center = (0.3, 0.6, 0.1)  radius = 0.45 "
        "}";
    const std::string material = "material glass { " + k_refracts + "1.4 }\n";
    const std::string each =
        "sphere { center = (-0.25, 0.5, 0)  radius = 0.55  material = glass }\n"
        "sphere { center = (0.3, 0.6, 0.1)  radius = 0.45  material = glass }";
    const Image merged = picture(material + "merge { material = glass " + balls + " }");
    EXPECT_LT(differing(picture(material + each), merged), 0.005);
    // As one object they have inner surfaces.
    const std::string one = "material glass { interior = 1  " + k_refracts + "1.4 }\n";
    EXPECT_GT(differing(picture(one + each), merged), 0.02);
}

TEST(Refraction, OfAirInGlassIsThatOfAHole) {
    const std::string outer = "sphere { center = (0, 0.5, 0)  radius = 0.7 ",
                      inner = "sphere { center = (0.1, 0.5, 0.1)  radius = 0.4 ";
    const Image hollow = picture("difference { " + k_refracts + "1.5 " + outer + "} " + inner + "} }");
    EXPECT_LT(differing(picture(outer + k_refracts + "1.5 } " + inner + k_refracts + "1 }"), hollow), 0.005);
    // Without an index of its own, it is not a medium.
    EXPECT_GT(differing(picture(outer + k_refracts + "1.5 } " + inner + k_clear + "transmit = 1 }"), hollow),
              0.02);
}

// Total reflection takes the weight of the ray, whatever the surface lets through; the terms add up to the
// pixel.
TEST(Refraction, IsExplained) {
    const Scene scene = room(
        "box { min = (-0.8, -0.2, -0.5)  max = (0.7, 0.9, 0.6)  color = (0.5, 0.9, 0.7)  ambient = 0.1 "
        "diffuse = 0.2  mirror = 0.2  filter = 0.8  refracts = true  ior = 1.7 }");
    const auto world = make_world(scene);
    ASSERT_TRUE(world);
    int total = 0;
    for (int y = 1; y < scene.settings.height; y += 4) {
        for (int x = 1; x < scene.settings.width; x += 4) {
            const Result<Explanation> e = explain(scene, *world, x, y);
            ASSERT_TRUE(e) << e.message;
            expect_added_up(*e, x, y);
            for (const ExplainedRay& ray : e->rays) {
                if (!ray.hit || ray.hit->fresnel != 1) continue;
                ++total;
                if (ray.hit->reflected.state != SecondaryRayState::traced) continue;
                EXPECT_EQ(ray.hit->reflected.weight, ray.hit->weight);
                EXPECT_NE(ray.hit->transmitted.state, SecondaryRayState::traced);
            }
        }
    }
    EXPECT_GT(total, 20);
}

// Seen along the axis of a box of depth 1.2: what is behind it is multiplied by the formula's factor, also
// for a refracted ray along the normal; the shadow ray of a light behind it, too.
TEST(Fading, FollowsItsFormula) {
    const auto drawn = [](const std::string& fade) {
        const auto scene = load_text(
            "conventions { transparency = highlights  mirror = add  transparent_shadow = colored  facing = "
            "all }\n"
            "render { size = 4 x 4  shading = phong  reflections = 4 }\n"
            "camera { projection = orthographic  position = (0, 0, 5)  look_at = (0, 0, 0)  width = 0.1 }\n"
            "light { type = directional  direction = (0, 0, 1) }\n"
            "box { min = (-1, -1, -0.5)  max = (1, 1, 0.7)  color = (1, 1, 1)  ambient = 0  diffuse = 0  "
            "transmit = 1  " +
                fade +
                " }\nplane { point = (0, 0, -2)  normal = (0, 0, 1)  color = (1, 1, 1)  ambient = 0  diffuse "
                "= 1 }\n",
            "fade.glint");
        EXPECT_TRUE(scene.has_value()) << scene.message;
        return scene ? render_scene(*scene).rgb : std::vector<float>(3);
    };
    EXPECT_EQ(drawn("fade_distance = 0  fade_power = 2")[0], drawn("")[0]);
    const double d = 1.2;
    for (const std::string ior : {"", "  refracts = true  ior = 1.5"}) {
        const auto expect = [&](const std::string& fade, Color t) {
            const std::vector<float> rgb = drawn(fade + ior);
            const double channels[] = {t.r, t.g, t.b};
            for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(rgb[c], channels[c] * channels[c], 1e-6) << fade;
        };
        const double linear = 1 / (1 + d / 3), cubic = 1 / (1 + std::pow(d / 0.5, 3)),
                     exponential = std::exp(-d / 2);
        expect("fade_distance = 3", {linear, linear, linear});
        expect("fade_distance = 0.5  fade_power = 3  fade_color = (1, 0.5, 0)",
               {1, 1 - 0.5 * (1 - cubic), cubic});
        expect("fade_distance = 2  fade_power = 1000", {exponential, exponential, exponential});
        expect("fade_distance = 2  fade_power = 1000  fade_color = (1, 0.5, 0)",
               {1, std::exp(-d / 4), exponential});
    }
}

TEST(Fading, IsExplained) {
    const Scene scene = room(
        "light { type = point  position = (0, 3, -3) }\nconventions { transparent_shadow = colored }\n"
        "box { min = (-0.8, -0.2, -0.5)  max = (0.7, 0.9, 0.6)  color = (0.5, 0.9, 0.7)  ambient = 0.1 "
        "diffuse = 0.2  mirror = 0.2  filter = 0.8  refracts = true  ior = 1.7  fade_distance = 0.7  "
        "fade_color = (0.9, 0.4, 0.1) }");
    const auto world = make_world(scene);
    ASSERT_TRUE(world);
    int faded = 0, total = 0, shadows = 0;
    for (int y = 1; y < scene.settings.height; y += 4) {
        for (int x = 1; x < scene.settings.width; x += 4) {
            const Result<Explanation> e = explain(scene, *world, x, y);
            ASSERT_TRUE(e) << e.message;
            expect_added_up(*e, x, y);
            for (const ExplainedRay& ray : e->rays) {
                if (!ray.hit) continue;
                const ExplainedHit& hit = *ray.hit;
                for (const LightTerms& light : hit.lights) {
                    Color product{1, 1, 1};
                    for (auto filter = light.filters.rbegin(); filter != light.filters.rend(); ++filter)
                        product = product * filter->factor * filter->fade;
                    if (light.visible > 0 && light.filters.size() > 1) {
                        EXPECT_EQ(product, light.filter);
                        ++shadows;
                    }
                }
                if (hit.fade == Color{1, 1, 1}) continue;
                if (hit.fresnel == 1 && hit.reflected.state == SecondaryRayState::traced) {
                    EXPECT_EQ(hit.reflected.weight, hit.weight * hit.fade);
                    ++total;
                } else if (hit.transmitted.state == SecondaryRayState::traced) {
                    EXPECT_EQ(hit.transmitted.weight, hit.weight * hit.through * hit.fade);
                    ++faded;
                }
            }
        }
    }
    EXPECT_GT(faded, 20);
    EXPECT_GT(total, 5);
    EXPECT_GT(shadows, 20);
}

TEST(Refraction, OfHollowObjectsIsInTheFog) {
    const std::string fog =
        "fog { type = exp  density = 0.3  color = (1, 1, 1) }\nconventions { fog_extent = outside_objects "
        "}\n";
    const std::string ball = "sphere { center = (0, 0.5, 0)  radius = 0.7  " + k_refracts + "1.2  ";
    EXPECT_GT(differing(picture(fog + ball + "hollow = true }"), picture(fog + ball + "}")), 0.02);
}

}  // namespace
}  // namespace glint::test
