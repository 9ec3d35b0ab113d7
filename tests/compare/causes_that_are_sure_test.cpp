// SPDX-License-Identifier: Apache-2.0
// A cause is sure only if the picture's bytes are roundings of what it gives.
#include <cmath>

#include "compare/planted_faults.h"
#include "compare/small_tracer.h"

namespace glint::test {
namespace {

SmallScene bridge(bool blinn) {
    SmallScene s;
    s.eye = {0.6, 1.7, 6.8};
    s.fov_y = 42;
    s.background = {0.15, 0.25, 0.35};
    s.ambient = 0.18;
    s.lamps = {{-3, 6, 4}};
    s.lamp = 0.75;
    s.blinn = blinn;
    s.balls = {{{-1.2, 0.9, 0.5}, 0.9, {0.6, 0.3, 0.7}, 0.5, 22, 0},
               {{0.7, 1.3, -0.7}, 1.3, {0.3, 0.8, 0.5}, 0.4, 34, 0},
               {{1.5, 0.5, 1.6}, 0.5, {0.9, 0.6, 0.2}, 0.6, 45, 0}};
    return s;
}

SmallScene gate(bool blinn) {
    SmallScene s;
    s.eye = {-0.5, 1.3, 7.4};
    s.background = {0.7, 0.5, 0.3};
    s.ambient = 0.22;
    s.lamps = {{3, 4, 5}, {-5, 3, 2}};
    s.lamp = 0.45;
    s.blinn = blinn;
    s.balls = {{{-1.4, 1, 0.2}, 1, {0.4, 0.4, 0.8}, 0.6, 28, 0},
               {{1.1, 1.2, 0.4}, 1.2, {0.8, 0.5, 0.4}, 0.5, 16, 0}};
    s.width = 96;
    s.height = 72;
    return s;
}

struct Trial {
    const char* name;
    Mistakes mistakes = {};
    double exponent = 1;
};

CauseReport causes_of(const SmallScene& right, const Trial& trial) {
    SmallScene wrong = right;
    for (SmallBall& ball : wrong.balls) ball.shininess *= trial.exponent;
    const Scene read = read_scene(text_of(right));
    return *find_causes(as_file(SmallTracer(wrong, trial.mistakes).draw()), as_file(draw(read)), &read);
}

// A cause that explains a third of the difference is not even likely.
TEST(CausesThatAreSure, NoneIsLikelyThatExplainsLittle) {
    for (const bool blinn : {true, false}) {
        const CauseReport report = causes_of(gate(blinn), {"no N.L", {.no_cosine = true}});
        EXPECT_EQ(first_cause(report), "none") << all_causes(report);
        ASSERT_TRUE(report.nearest);
        EXPECT_GT(report.nearest->explained, 0.3);
        EXPECT_LT(report.nearest->explained, k_min_explained);
    }
}

TEST(CausesThatAreSure, AreNotThoseOfMistakesThatAreUnknown) {
    for (const auto& make : {bridge, gate}) {
        for (const bool blinn : {true, false}) {
            for (const Trial& trial :
                 {Trial{"1 / (100 + d^2)", {.distance_power = 2, .distance_offset = 100}},
                  {"1 / (50 + d)", {.distance_power = 1, .distance_offset = 50}},
                  {"exponent squared", {.exponent_squared = true}},
                  {"exponent times 20", {}, 20}}) {
                const SmallScene scene = make(blinn);
                const CauseReport report = causes_of(scene, trial);
                for (const auto* list : {&report.causes, &report.then}) {
                    for (const Cause& c : *list)
                        EXPECT_TRUE(c.perhaps || c.name == (trial.exponent > 1 ? "exponent" : ""))
                            << trial.name << scene.width << blinn << all_causes(report);
                }
            }
        }
    }
}

// The numbers are fitted until the bytes are their roundings.
TEST(CausesThatAreSure, HaveNumbersThatGiveTheBytes) {
    for (const auto& make : {bridge, gate}) {
        for (const bool blinn : {true, false}) {
            const SmallScene scene = make(blinn);
            const Scene read = read_scene(text_of(scene));
            SmallScene moved = scene;
            moved.lamps[0] = moved.lamps[0] + Vec3{0.63, -0.27, 0.41};
            const CauseReport report =
                *find_causes(as_file(SmallTracer(moved, {}).draw()), as_file(draw(read)), &read);
            EXPECT_EQ(first_cause(report), "light-moved") << all_causes(report);
            EXPECT_FALSE(report.causes.empty() || report.causes[0].perhaps) << all_causes(report);
        }
    }
}

// 0.7 times 255 is 178.5, and the background is 179 for a program that rounds halves up.
TEST(CausesThatAreSure, AreNotABackgroundThatIsRounded) {
    const SmallScene scene = gate(true);
    const Scene read = read_scene(text_of(scene));
    Image wrong = SmallTracer(scene, {.specular_times_cosine = true}).draw();
    for (float& v : wrong.rgb)
        v = static_cast<float>(std::floor(255 * std::clamp(static_cast<double>(v), 0.0, 1.0) + 0.50001) /
                               255);
    const CauseReport report = *find_causes(wrong, as_file(draw(read)), &read);
    EXPECT_EQ(first_cause(report), "highlight-times-cosine") << all_causes(report);
    EXPECT_TRUE(report.then.empty()) << all_causes(report);
}

}  // namespace
}  // namespace glint::test
