// SPDX-License-Identifier: Apache-2.0
// Mirrors by Fresnel's equations (Material::mirror_fresnel) and conserve_energy, beside the equations written
// with angles.
#include <gtest/gtest.h>

#include <cmath>

#include "explain/added_up.h"
#include "formats/load_text.h"
#include "glint/explain.h"
#include "trace/pictures.h"

namespace glint::test {
namespace {

constexpr const char* k_room = R"(
conventions { transparency = highlights  mirror = add }
render { size = 60 x 45  shading = phong  reflections = 6 }
background = (0.3, 0.4, 0.6)
camera { position = (0.1, 1.2, 5)  look_at = (0, 0.6, 0)  fov_x = 45 }
light { type = point  position = (2, 5, 4) }
plane { point = (0, -0.3, 0)  normal = (0, 1, 0)  color = (0.8, 0.7, 0.5) }
)";

// (sin(i - t) / sin(i + t))^2 and (tan(i - t) / tan(i + t))^2, with n1 sin i = n2 sin t.
double reflectance(double cosine, double n1, double n2) {
    const double i = std::acos(cosine), sine = n1 * std::sin(i) / n2;
    if (n1 == n2) return 0;
    if (sine >= 1) return 1;
    if (i < 1e-6) return std::pow((n1 - n2) / (n1 + n2), 2);
    const double t = std::asin(sine), across = std::sin(i - t) / std::sin(i + t),
                 along = std::tan(i - t) / std::tan(i + t);
    return (across * across + along * along) / 2;
}

// Calls check(hit, cosine) for the hits of the rays on a grid of pixels.
template <class Check> int for_each_hit(const std::string& shapes, const Check& check) {
    const auto scene = load_text(k_room + shapes, "fresnel.glint");
    EXPECT_TRUE(scene.has_value()) << scene.message;
    if (!scene) return 0;
    const auto world = make_world(*scene);
    int count = 0;
    for (int y = 1; y < scene->settings.height; y += 3) {
        for (int x = 1; x < scene->settings.width; x += 3) {
            const Result<Explanation> e = explain(*scene, *world, x, y);
            EXPECT_TRUE(e.has_value()) << e.message;
            if (!e) return 0;
            expect_added_up(*e, x, y);
            for (const ExplainedRay& ray : e->rays) {
                if (!ray.hit || ray.hit->shape == 0) continue;
                check(*ray.hit, std::abs(dot(ray.hit->normal, ray.direction)) / length(ray.direction));
                ++count;
            }
        }
    }
    return count;
}

TEST(Fresnel, OpaqueMirrors) {
    for (const double ior : {1.0, 1.2, 2.5, 0.7}) {
        const int hits = for_each_hit(
            "sphere { center = (0, 0.5, 0)  radius = 0.8  mirror = 0.9  mirror_min = 0.1  mirror_fresnel = "
            "true  mirror_falloff = 3  ior = " +
                std::to_string(ior) + " }\n",
            [&](const ExplainedHit& hit, double cosine) {
                EXPECT_NEAR(hit.mirror, 0.1 + 0.8 * reflectance(cosine, 1, ior), 1e-12) << ior;
            });
        EXPECT_GT(hits, 20);
    }
}

// From inside the indices change places, and there is total reflection. All light goes one way or the other.
TEST(Fresnel, GlassReflectsAndTransmitsAllLight) {
    int inside = 0, total = 0, refracted = 0;
    for_each_hit(
        "box { min = (-0.7, 0, -0.4)  max = (0.5, 0.9, 0.6)  rotate = (0, 30, 0)  color = (1, 1, 1)  ambient "
        "= 0  diffuse = 0 "
        "transmit = 1  refracts = true  ior = 1.6  mirror = 1  mirror_fresnel = true  conserve_energy = true "
        "}\n",
        [&](const ExplainedHit& hit, double cosine) {
            const double n1 = hit.behind ? 1.6 : 1, n2 = hit.behind ? 1 : 1.6;
            EXPECT_NEAR(hit.mirror, reflectance(cosine, n1, n2), 1e-12);
            EXPECT_NEAR(hit.through.g, 1 - hit.mirror, 1e-15);
            inside += hit.behind;
            total += hit.fresnel == 1;
            if (hit.fresnel == 1) {
                EXPECT_EQ(hit.mirror, 1);
            }
            if (hit.reflected.state != SecondaryRayState::traced ||
                hit.transmitted.state != SecondaryRayState::traced)
                return;
            EXPECT_NEAR(hit.reflected.weight.r + hit.transmitted.weight.r, hit.weight.r, 1e-15);
            ++refracted;
        });
    EXPECT_GT(inside, 20);
    EXPECT_GT(total, 5);
    EXPECT_GT(refracted, 20);
}

// Where nothing is let through (POV-Ray, measured: tests/peers/fading.py).
TEST(Fresnel, WhatIsReflectedWholeDoesNotFade) {
    int whole = 0, faded = 0;
    for_each_hit(
        "box { min = (-0.7, 0, -0.4)  max = (0.5, 0.9, 0.6)  rotate = (0, 30, 0)  color = (1, 1, 1)  ambient "
        "= 0  diffuse = 0  transmit = 1  refracts = true  ior = 1.6  mirror = 1  mirror_fresnel = true  "
        "conserve_energy = true  fade_distance = 0.5  fade_power = 1 }\n",
        [&](const ExplainedHit& hit, double) {
            if (!hit.behind) return;
            if (hit.mirror < 1) {
                EXPECT_LT(hit.fade.r, 1);
                ++faded;
                return;
            }
            EXPECT_EQ(hit.fade, (Color{1, 1, 1}));
            if (hit.reflected.state == SecondaryRayState::traced) {
                EXPECT_EQ(hit.reflected.weight, hit.weight);
                ++whole;
            }
        });
    EXPECT_GT(whole, 5);
    EXPECT_GT(faded, 5);
}

// What is filtered out on the way is nothing that a mirror takes.
TEST(Fresnel, ColoredLightFadesWhereAnotherColorLeaves) {
    int total = 0;
    const std::string glass =
        "ambient = 0  diffuse = 0  filter = 1  refracts = true  ior = 1.6  mirror = 0.5  mirror_fresnel = "
        "true  "
        "conserve_energy = true  fade_distance = 0.5  fade_power = 1 ";
    for_each_hit(
        "intersection { rotate = (0, 30, 0)\n"
        "box { min = (-0.7, 0, -0.4)  max = (0.5, 0.9, 0.6)  color = (1, 0, 0) " +
            glass + "}\nplane { point = (0, 0, -0.2)  normal = (0, 0, -1)  color = (0, 1, 1) " + glass +
            "} }\n",
        [&](const ExplainedHit& hit, double) {
            if (!hit.behind || hit.fresnel < 1) return;
            EXPECT_LT(hit.fade.r, 1);
            if (hit.reflected.state != SecondaryRayState::traced) return;
            EXPECT_NEAR(hit.reflected.weight.r, hit.weight.r * hit.fade.r, 1e-15);
            ++total;
        });
    EXPECT_GT(total, 5);
}

TEST(Fresnel, OpaqueBallInWater) {
    int balls = 0;
    for_each_hit(
        "box { min = (-3, -0.2, -3)  max = (3, 1, 3)  color = (1, 1, 1)  ambient = 0  diffuse = 0  transmit "
        "= 1  "
        "refracts = true  ior = 1.33 }\n"
        "sphere { center = (0, 0.4, 0)  radius = 0.5  refracts = true  ior = 2  mirror = 1  mirror_fresnel = "
        "true }\n",
        [&](const ExplainedHit& hit, double cosine) {
            if (hit.shape != 2) return;
            EXPECT_NEAR(hit.mirror, reflectance(cosine, 1.33, 2), 1e-12);
            ++balls;
        });
    EXPECT_GT(balls, 10);
}

// Glass of `transmission`, which does not know what is around it.
TEST(Fresnel, MirrorsOfGlassByTransmission) {
    int inside = 0;
    for_each_hit(
        "sphere { center = (0, 0.5, 0)  radius = 0.8  transmission = 0.9  ior = 1.4  mirror = 0.8  "
        "mirror_fresnel = true }\n",
        [&](const ExplainedHit& hit, double cosine) {
            EXPECT_NEAR(hit.mirror,
                        0.8 * (hit.behind ? reflectance(cosine, 1.4, 1) : reflectance(cosine, 1, 1.4)),
                        1e-12);
            inside += hit.behind;
        });
    EXPECT_GT(inside, 10);
}

TEST(ConserveEnergy, ReducesWhatTheEyeSeesThrough) {
    const auto ball = [](bool conserves) {
        return std::string(
                   "conventions { transparent_shadow = colored }\n"
                   "sphere { center = (0, 0.5, 0)  radius = 0.8  filter = 0.5  transmit = 0.3  mirror = 0.6  "
                   "mirror_color = (1, 0.5, 0)  mirror_falloff = 1  color = (0.5, 1, 1)  conserve_energy "
                   "= ") +
               (conserves ? "true }\n" : "false }\n");
    };
    std::vector<Color> through, filters;
    for_each_hit(ball(false), [&](const ExplainedHit& hit, double) {
        through.push_back(hit.through);
        for (const LightTerms& light : hit.lights) filters.push_back(light.filter);
    });
    ASSERT_GT(through.size(), 20u);
    std::size_t at = 0, light_at = 0;
    for_each_hit(ball(true), [&](const ExplainedHit& hit, double) {
        ASSERT_LT(at, through.size());
        const Color was = through[at++], tint{1, 0.5, 0};
        EXPECT_NEAR(hit.through.r, was.r * (1 - hit.mirror * tint.r), 1e-15);
        EXPECT_NEAR(hit.through.g, was.g * (1 - hit.mirror * tint.g), 1e-15);
        EXPECT_EQ(hit.through.b, was.b);
        for (const LightTerms& light : hit.lights) EXPECT_EQ(light.filter, filters.at(light_at++));
    });
    EXPECT_EQ(at, through.size());
}

}  // namespace
}  // namespace glint::test
