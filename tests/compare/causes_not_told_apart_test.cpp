// SPDX-License-Identifier: Apache-2.0
// Mistakes that no cause makes, or that the pixels do not tell from a cause: none of them is sure, or all
// are.
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

}  // namespace
}  // namespace glint::test
