// SPDX-License-Identifier: Apache-2.0
// Mirrors and highlights that have the surface's color, and what is nearly that, in scenes that nothing was
// tuned with.
#include "compare/planted_faults.h"
#include "compare/small_tracer.h"

namespace glint::test {
namespace {

SmallScene window(bool blinn, bool mirrors) {
    SmallScene s;
    s.eye = {-0.5, 2, 8};
    s.fov_y = 36;
    s.lamps = {{3, 7, 4}, {-2, 8, 6}};
    s.lamp = 0.45;
    s.blinn = blinn;
    s.background = {0.5, 0.7, 0.8};
    const double mirror = mirrors ? 0.5 : 0;
    s.balls = {{{-1.8, 1, 1}, 1, {0.7, 0.4, 0.2}, 0.5, 30, mirror},
               {{0.6, 1.3, 0}, 1.3, {0.3, 0.5, 0.7}, 0.6, 15, mirror}};
    return s;
}

SmallScene steps(bool blinn, bool mirrors) {
    SmallScene s;
    s.eye = {1, 1.5, 7};
    s.fov_y = 44;
    s.lamps = {{5, 4, 6}};
    s.lamp = 0.7;
    s.blinn = blinn;
    s.background = {0.4, 0.5, 0.3};
    const double mirror = mirrors ? 0.35 : 0;
    s.balls = {{{-1, 0.5, 1.5}, 0.5, {0.3, 0.8, 0.4}, 0.4, 12, mirror},
               {{0.4, 0.9, 0.6}, 0.9, {0.8, 0.2, 0.5}, 0.5, 25, mirror},
               {{2.4, 1.5, -0.8}, 1.5, {0.6, 0.6, 0.2}, 0.6, 50, mirror}};
    s.width = 96;
    s.height = 72;
    return s;
}

Image tinted_picture(const SmallScene& scene, const Mistakes& mistakes) {
    return as_file(SmallTracer(scene, mistakes).draw());
}

TEST(CausesOfTints, OfMirrorsAndHighlights) {
    struct Tint {
        const char* name;
        bool mirrors;
        Mistakes mistakes;
    };
    for (const auto& make : {window, steps}) {
        const auto causes_of = [&](const Tint& tint, bool blinn) {
            const SmallScene scene = make(blinn, tint.mirrors);
            const Scene read = read_scene(text_of(scene));
            return *find_causes(tinted_picture(scene, tint.mistakes), as_file(draw(read)), &read);
        };
        for (const Tint& tint : {Tint{"mirror-surface-color", true, {.mirror_colored = true}},
                                 Tint{"highlight-surface-color", false, {.specular_colored = true}},
                                 Tint{"highlight-surface-color", false, {.specular_is_diffuse = true}}}) {
            const CauseReport report = causes_of(tint, true);
            EXPECT_EQ(first_cause(report), tint.name) << all_causes(report);
            EXPECT_FALSE(report.causes.empty() || report.causes[0].perhaps) << all_causes(report);
        }
        for (const Tint& near_miss :
             {Tint{"mirror-surface-color", true, {.mirror_half_colored = true}},
              Tint{"highlight-surface-color", false, {.specular_half_colored = true}}}) {
            for (const bool blinn : {false, true}) {
                const CauseReport report = causes_of(near_miss, blinn);
                EXPECT_NE(first_cause(report), near_miss.name) << all_causes(report);
                for (const Cause& cause : report.causes)
                    EXPECT_TRUE(cause.perhaps || cause.name != near_miss.name) << all_causes(report);
            }
        }
        // The lit color is near enough to be a likely cause.
        const CauseReport lit = causes_of({"", true, {.mirror_lit = true}}, false);
        for (const Cause& cause : lit.causes) EXPECT_TRUE(cause.perhaps) << all_causes(lit);
    }
}

}  // namespace
}  // namespace glint::test
