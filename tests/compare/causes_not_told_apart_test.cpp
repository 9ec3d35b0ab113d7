// SPDX-License-Identifier: Apache-2.0
// Mistakes that no cause makes, or that the pixels do not tell from a cause: none of them is sure, or all
// are.
#include <algorithm>
#include <tuple>

#include "compare/planted_faults.h"
#include "compare/small_tracer.h"

namespace glint::test {
namespace {

SmallScene stairs() {
    SmallScene s;
    s.eye = {-0.3, 1.8, 6.4};
    s.fov_y = 44;
    s.background = {0.3, 0.5, 0.4};
    s.ambient = 0.25;
    s.lamps = {{-4, 5, 4}, {3, 6, 2}};
    s.lamp = 0.4;
    s.blinn = true;
    s.balls = {{{-1.6, 0.7, 0.9}, 0.7, {0.4, 0.6, 0.8}, 0.4, 18, 0},
               {{0, 1, -0.4}, 1, {0.8, 0.5, 0.3}, 0.6, 36, 0},
               {{1.7, 1.3, 0.2}, 0.9, {0.5, 0.7, 0.4}, 0.5, 24, 0}};
    return s;
}

SmallScene cluster() {
    SmallScene s;
    s.eye = {0.2, 1.4, 7.2};
    s.background = {0.5, 0.4, 0.6};
    s.ambient = 0.15;
    s.lamps = {{2, 5, 6}};
    s.lamp = 0.8;
    s.balls = {{{-0.9, 1.1, 0.2}, 1.1, {0.7, 0.4, 0.5}, 0.5, 15, 0},
               {{0.9, 0.6, 1.3}, 0.6, {0.3, 0.6, 0.6}, 0.3, 30, 0},
               {{1.4, 1.5, -0.9}, 0.8, {0.8, 0.8, 0.3}, 0.6, 40, 0}};
    s.width = 96;
    s.height = 72;
    return s;
}

CauseReport causes_of(const SmallScene& right, const SmallScene& wrong, const Mistakes& mistakes = {}) {
    const Scene read = read_scene(text_of(right));
    return *find_causes(as_file(SmallTracer(wrong, mistakes).draw()), as_file(draw(read)), &read);
}

bool is_sure(const CauseReport& report, const std::string& name) {
    return std::any_of(report.causes.begin(), report.causes.end(),
                       [&](const Cause& c) { return c.name == name && !c.perhaps; });
}

// What is left of so little light is within rounding, but not where rounding leaves it.
TEST(CausesNotToldApart, LightThatFadesByAnotherFormula) {
    for (const SmallScene& scene : {stairs(), cluster()}) {
        for (const auto& [power, offset] : {std::pair{1, 80.0}, {1, 20.0}, {2, 1.0}, {2, 10.0}}) {
            const CauseReport report =
                causes_of(scene, scene, {.distance_power = power, .distance_offset = offset});
            for (const Cause& c : report.causes) EXPECT_TRUE(c.perhaps) << offset << all_causes(report);
            for (const Cause& c : report.then) EXPECT_TRUE(c.perhaps) << offset << all_causes(report);
        }
        // As little light by a cause of the table.
        SmallScene dim = scene;
        dim.lamp *= 0.02;
        const CauseReport dimmed = causes_of(scene, dim);
        EXPECT_TRUE(is_sure(dimmed, "light-intensity")) << all_causes(dimmed);
        EXPECT_TRUE(is_sure(causes_of(scene, scene, {.distance_power = 2}), "attenuation-added"));
    }
}

TEST(CausesNotToldApart, HighlightsSmallerThanAPixel) {
    for (const SmallScene& scene : {stairs(), cluster()}) {
        for (const double factor : {100.0, 150.0, 200.0, 300.0, 1000.0, 3000.0}) {
            SmallScene wrong = scene;
            for (SmallBall& ball : wrong.balls) ball.shininess *= factor;
            const CauseReport report = causes_of(scene, wrong);
            EXPECT_EQ(is_sure(report, "specular-missing"), is_sure(report, "exponent"))
                << factor << all_causes(report);
            EXPECT_TRUE(factor < 3000 || is_sure(report, "exponent")) << all_causes(report);
        }
        SmallScene wrong = scene;
        for (SmallBall& ball : wrong.balls) ball.specular = 0;
        const CauseReport report = causes_of(scene, wrong);
        EXPECT_EQ(first_cause(report), "specular-missing") << all_causes(report);
        EXPECT_TRUE(is_sure(report, "specular-missing")) << all_causes(report);
        EXPECT_TRUE(is_sure(report, "exponent")) << all_causes(report);
        EXPECT_FALSE(is_sure(report, "specular-scaled")) << all_causes(report);
        // Highlights that are hardly visible are not missing.
        for (std::size_t i = 0; i < wrong.balls.size(); ++i)
            wrong.balls[i].specular = 0.05 * scene.balls[i].specular;
        EXPECT_TRUE(is_sure(causes_of(scene, wrong), "specular-scaled"));
    }
}

// Other causes that leave next to no highlights are no better than the missing term. The highlight is so
// small that the pixels that are wrong are few.
TEST(CausesNotToldApart, CausesThatLeaveHardlyAnyHighlights) {
    const auto text_of = [](double ball, double specular, double shininess, const std::string& size) {
        const auto n = [](double x) { return std::to_string(x); };
        return R"(
background = (0.4, 0.5, 0.6)
camera { position = (-0.8, 2.4, 6.5)  look_at = (0.1, 0.7, 0)  fov_x = 52 }
light { type = ambient  intensity = 0.3 }
light { type = directional  to_light = (1, 2, 1.2)  intensity = 0.5 }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.5, 0.5, 0.45)  diffuse = 0.7  specular = 0 }
sphere { center = (-1.4, 0.8, 0.1)  radius = 0.8  color = (0.7, 0.4, 0.5)  diffuse = 0.7  specular = 0 }
sphere { center = (0.1, )" +
               n(ball) + ", 1.7)  radius = " + n(ball) +
               "  color = (0.5, 0.5, 0.7)  diffuse = 0.6  specular = " + n(specular) +
               "  shininess = " + n(shininess) + " }\nrender { size = " + size + "  shading = phong }\n";
    };
    for (const auto& [ball, specular, shininess, factor, size] :
         {std::tuple{0.2, 0.2, 30.0, 60.0, "320 x 240"}, {0.3, 0.2, 30.0, 100.0, "480 x 360"}}) {
        const std::string right = text_of(ball, specular, shininess, size);
        const Scene scene = read_scene(right);
        const CauseReport report = *find_causes(draw_text(text_of(ball, specular, factor * shininess, size)),
                                                draw_text(right), &scene);
        for (const Cause& c : report.causes)
            EXPECT_TRUE(c.perhaps || c.name == "exponent") << all_causes(report);
    }
}

// A highlight so dim that an exponent of 9 times as much makes it vanish in rounding.
TEST(CausesNotToldApart, ADimHighlightVanishesEarly) {
    const auto text_of = [](const std::string& shininess) {
        return R"(
background = (0.11, 0.12, 0.13)
camera { position = (-0.8, 2.4, 6.5)  look_at = (0.1, 0.7, 0)  fov_x = 52 }
light { type = ambient  intensity = 0.3 }
light { type = directional  to_light = (1, 2, 1.2)  intensity = 0.5 }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.5, 0.5, 0.45)  diffuse = 0.7  specular = 0 }
cylinder { from = (0.8, 0, 1.3)  to = (0.8, 0.18, 1.3)  radius = 0.06
    ambient_color = (0.5, 0.5, 0.7)  diffuse_color = (0.3, 0.3, 0.42)
    specular_color = (0.3, 0.35, 0.25)  shininess = )" +
               shininess + " }\nrender { size = 320 x 240  shading = blinn-phong }\n";
    };
    const Scene scene = read_scene(text_of("12"));
    const CauseReport report = *find_causes(draw_text(text_of("108")), draw_text(text_of("12")), &scene);
    const auto exponent = std::find_if(report.causes.begin(), report.causes.end(),
                                       [](const Cause& c) { return c.name == "exponent"; });
    ASSERT_NE(exponent, report.causes.end()) << all_causes(report);
    EXPECT_NE(exponent->explanation.find(
                  " 8 times what it should be, or more: highlights are too small or too dim"),
              std::string::npos)
        << all_causes(report);
    EXPECT_FALSE(exponent->perhaps);
}

}  // namespace
}  // namespace glint::test
