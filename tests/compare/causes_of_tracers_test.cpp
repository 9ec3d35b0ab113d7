// SPDX-License-Identifier: Apache-2.0
// Mistakes of another ray tracer (small_tracer.h) that no edit of the scene makes.
#include "compare/planted_faults.h"
#include "compare/small_tracer.h"

namespace glint::test {
namespace {

struct Case {
    const char* name;
    Mistakes mistakes;
    bool blinn = false, mirrors = false;
    double fov_factor = 0;  // of the angle, if not 0
};

SmallScene table(bool blinn, bool mirrors) {
    SmallScene s;
    s.eye = {0.4, 1.6, 7};
    s.lamps = {{4, 6, 5}, {-5, 4, 6}};
    s.blinn = blinn;
    const double mirror = mirrors ? 0.4 : 0;
    s.balls = {{{-1.3, 1.2, 0.4}, 1.2, {0.8, 0.3, 0.2}, 0.5, 25, mirror},
               {{0.5, 0.8, 1.6}, 0.8, {0.3, 0.7, 0.3}, 0.4, 10, mirror},
               {{1.7, 1.4, -0.8}, 1.4, {0.3, 0.4, 0.8}, 0.6, 40, mirror}};
    return s;
}

SmallScene row(bool blinn, bool mirrors) {
    SmallScene s;
    s.eye = {0, 1.2, 6};
    s.fov_y = 48;
    s.lamps = {{-3, 5, 3}};
    s.lamp = 0.8;
    s.blinn = blinn;
    s.background = {0.7, 0.6, 0.4};
    const double mirror = mirrors ? 0.3 : 0;
    s.balls = {{{1.2, 0.7, 1.4}, 0.7, {0.9, 0.8, 0.2}, 0.5, 20, mirror},
               {{0.1, 1.5, -1}, 1.5, {0.2, 0.6, 0.7}, 0.5, 30, mirror},
               {{-1.4, 0.6, 0.8}, 0.6, {0.7, 0.3, 0.6}, 0.3, 8, mirror}};
    s.width = 72;
    s.height = 54;
    return s;
}

Image picture(const SmallScene& scene, const Mistakes& mistakes) {
    return as_file(SmallTracer(scene, mistakes).draw());
}

const std::vector<Case>& cases() {
    static const std::vector<Case> all = {
        {"light-vector-not-normalized", {.l_raw = true}, true},
        {"half-vector-not-normalized", {.h_raw = true}, true},
        {"half-vector-wrong", {.h_of_difference = true}, true},
        {"normal-not-normalized", {.n_raw = true}},
        {"normal-not-normalized", {.n_raw = true, .n_raw_in_mirrors = true}, false, true},
        {"not-normalized", {.l_raw = true, .v_raw = true}},
        {"normals-reversed", {.n_reversed = true}},
        {"normals-reversed", {.balls_reversed = true}},
        {"normal-from-origin", {.n_from_origin = true}},
        {"view-vector-not-normalized", {.v_raw = true}},
        {"eye-not-from-point", {.v_is_eye = true}},
        {"cosine-of-other-vectors", {.of_n_r = true}},
        {"cosine-of-other-vectors", {.of_r_l = true}},
        {"cosine-of-other-vectors", {.of_h_v = true}, true},
        {"cosine-of-other-vectors", {.diffuse_of_view = true}},
        {"diffuse-squared", {.diffuse_squared = true}, true},
        {"reflection-vector-negated", {.r_negated = true}},
        {"highlight-times-cosine", {.specular_times_cosine = true}},
        {"highlight-times-cosine", {.specular_times_cosine = true}, true},
        {"diffuse-exponent", {.diffuse_to_power = true}},
        {"eye-at-origin", {.v_from_origin = true}},
        {"eye-direction-fixed", {.v_fixed = true}, true},
        {"eye-at-origin", {.v_from_origin = true, .v_anywhere = true}, false, true},
        {"eye-direction-fixed", {.v_fixed = true, .v_anywhere = true}, true, true},
        {"shadow-black", {.black_shadow = true}},
        {"shadow-black", {.no_ambient_in_shadow = true}},
        {"mirror-direction", {.mirror_plus = true}, false, true},
        {"mirror-direction", {.mirror_negated = true}, false, true},
        {"mirror-surface-color", {.mirror_colored = true}, true, true},
        {"highlight-surface-color", {.specular_is_diffuse = true}, true},
        {"last-shape-hit", {.last_hit = true}},
        {"first-shape-hit", {.first_hit = true}},
        {"hits-behind-camera", {.accepts_behind = true}},
        {"colors-truncated", {.integer_colors = true}},
        {"colors-truncated", {.integer_sum = true}},
        {"attenuation-added", {.distance_power = 1}},
        {"attenuation-added", {.distance_power = 2}},
        {"attenuation-added", {.distance_power = 1, .distance_offset = 1}},
        {"half-vector-not-normalized", {.h_halved = true}, true},
        {"half-lambert", {.lambert_offset = 1}},
        {"half-lambert", {.lambert_offset = 1}, true},
        {"shadow-ray-short", {.shadow_limit = 1}},
        {"shadow-ray-negated", {.shadow_negated = true}},
        {"shadow-of-shape-missing", {.last_casts_none = true}},
        {"epsilon-too-large", {.shadow_least = 0.7}},
        {"shadow-black", {.dimming = 0.5}},
        {"shadow-black", {.black_shadow = true}, false, true},
        {"shadow-black", {.dimming = 0.5}, true, true},
        {"light-vector", {.l_from_eye = true}},
        {"radius-squared", {.root_of_radius = true}},
        {"pixel-step", {.rays_to_corners = true}},
        {"mirror-part-not-mixed", {.mirror_whole_shine = true}, false, true},
        {"mirror-part-not-mixed", {.mirror_whole_ambient = true}, true, true},
        {"mirror-not-multiplied", {.mirror_whole_seen = true}, false, true},
        {"mirrors-show-less", {.mirror_unshadowed = true}, false, true},
        {"mirrors-show-less", {.mirror_dull = true}, true, true},
        {"mirrors-show-less", {.mirror_flat = true}, false, true},
        {"mirror-fresnel", {.schlick_power = 5}, false, true},
        {"aspect-missing", {.x_factor = 0.75}},
        {"aspect-missing", {.y_factor = 4.0 / 3}},
        {"aspect-inverted", {.x_factor = 0.5625}},
        {"field-of-view-doubled", {}, false, false, 2},
        {"field-of-view-halved", {}, false, false, 0.5},
        {"field-of-view-radians", {}, false, false, 57.29577951308232},
    };
    return all;
}

// First, or as the cause of the same picture: if R is negated there are hardly any highlights.
bool is_among_the_best(const CauseReport& report, const std::string& name) {
    for (const Cause& cause : report.causes) {
        if (cause.explained < report.causes[0].explained - 0.001) break;
        if (cause.name == name) return true;
    }
    return false;
}

TEST(CausesOfTracers, WithoutAMistakeThePicturesAgree) {
    for (const SmallScene& scene : {table(false, true), row(true, true)}) {
        const Image right = draw_text(text_of(scene));
        const CauseReport report = find_causes(picture(scene, {}), right).value();
        EXPECT_TRUE(report.difference < 0.02) << report.difference;
    }
}

TEST(CausesOfTracers, AreNamedFirst) {
    for (const auto& make : {table, row}) {
        for (const Case& c : cases()) {
            const SmallScene scene = make(c.blinn, c.mirrors);
            Mistakes mistakes = c.mistakes;
            if (c.fov_factor != 0) {
                const double half = scene.fov_y / 2 * 3.14159265358979323846 / 180;
                mistakes.plane_factor = std::tan(half * c.fov_factor) / std::tan(half);
            }
            const Scene read = read_scene(text_of(scene));
            const Result<CauseReport> report =
                find_causes(picture(scene, mistakes), as_file(draw(read)), &read);
            ASSERT_TRUE(report && !report->causes.empty()) << c.name;
            EXPECT_FALSE(report->causes[0].perhaps) << all_causes(report);
            EXPECT_TRUE(is_among_the_best(*report, c.name)) << c.name << "\n" << all_causes(report);
        }
    }
}

// Near misses: numbers that a row does not have.
TEST(CausesOfTracers, AreNotSureWhereTheyAreNot) {
    const Case near_misses[] = {
        {"half-lambert", {.lambert_offset = 0.6}},
        {"shadow-ray-short", {.shadow_limit = 1.6}},
        {"shadow-black", {.dimming = 0.6}},
        {"mirror-fresnel", {.schlick_power = 4}, false, true},
    };
    for (const auto& make : {table, row}) {
        for (const Case& c : near_misses) {
            const SmallScene scene = make(c.blinn, c.mirrors);
            const Scene read = read_scene(text_of(scene));
            const CauseReport report = *find_causes(picture(scene, c.mistakes), as_file(draw(read)), &read);
            EXPECT_TRUE(report.causes.empty() || report.causes[0].perhaps) << c.name << "\n"
                                                                           << all_causes(report);
        }
    }
}

// V = P is V = -P with R negated. Without highlights nearly as little is left, but then V could not be wrong.
TEST(CausesOfTracers, ThePairThatWasFoundIsNamed) {
    for (const double shininess : {4.0, 8.0, 16.0}) {
        SmallScene scene = row(false, false);
        for (SmallBall& ball : scene.balls) ball.shininess = shininess;
        const Scene read = read_scene(text_of(scene));
        const CauseReport report = *find_causes(picture(scene, {.v_is_p = true}), as_file(draw(read)), &read);
        EXPECT_EQ(first_cause(report), "reflection-vector-negated") << all_causes(report);
        ASSERT_EQ(report.then.size(), 1u) << all_causes(report);
        EXPECT_EQ(report.then[0].name, "eye-at-origin");
        EXPECT_FALSE(report.then[0].perhaps);
    }
}

// A program that rounds halves up, and 0.7 times 255 is 178.5 for it, as for one with doubles: its background
// differs from the scene's own picture by 1, mistake or not.
Image rounded_half_up(Image image) {
    for (float& v : image.rgb)
        v = static_cast<float>(std::floor(255 * std::clamp(static_cast<double>(v), 0.0, 1.0) + 0.50001) /
                               255);
    return image;
}

// Most of the difference is that of the background.
TEST(CausesOfTracers, ColorsThatAreLimitedBeforeTheyAreMixed) {
    for (const auto& make : {table, row}) {
        SmallScene scene = make(true, true);
        scene.lamp = 1.6;
        const Scene read = read_scene(text_of(scene));
        const CauseReport report =
            *find_causes(picture(scene, {.local_clamped = true}), as_file(draw(read)), &read);
        EXPECT_EQ(first_cause(report), "local-color-clamped") << all_causes(report);
        EXPECT_FALSE(report.causes.empty() || report.causes[0].perhaps);
    }
}

// Rays along a surface depend on how far from it they start.
TEST(CausesOfTracers, MirrorRaysAlongTheSurface) {
    for (const auto& make : {table, row}) {
        const SmallScene scene = make(false, true);
        const Scene read = read_scene(text_of(scene));
        const CauseReport report =
            *find_causes(picture(scene, {.mirror_along = true}), as_file(draw(read)), &read);
        ASSERT_EQ(first_cause(report), "mirror-direction") << all_causes(report);
        EXPECT_NE(report.causes[0].explanation.find("along the surface"), std::string::npos);
    }
}

TEST(CausesOfTracers, AFewPixelsAreSeenByProgramsThatRoundDifferently) {
    const SmallScene scene = row(false, false);
    const Scene read = read_scene(text_of(scene));
    Image wrong = rounded_half_up(SmallTracer(scene, {}).draw());
    for (int y = 0; y < wrong.height; ++y) {
        for (int c = 0; c < 3; ++c)
            wrong.rgb[3 * (static_cast<std::size_t>(y + 1) * wrong.width - 1) + c] = 0;
    }
    const CauseReport report = *find_causes(wrong, as_file(draw(read)), &read);
    EXPECT_EQ(first_cause(report), "columns-missing") << all_causes(report);
    EXPECT_FALSE(report.causes.empty() || report.causes[0].perhaps);
}

TEST(CausesOfTracers, AreNamedAloneByProgramsThatRoundDifferently) {
    for (const char* const name : {"highlight-times-cosine", "colors-truncated", "first-shape-hit"}) {
        const Case& c = *std::find_if(cases().begin(), cases().end(),
                                      [&](const Case& each) { return std::string(each.name) == name; });
        const SmallScene scene = row(c.blinn, c.mirrors);
        const Scene read = read_scene(text_of(scene));
        const Image right = rounded_half_up(SmallTracer(scene, {}).draw()),
                    wrong = rounded_half_up(SmallTracer(scene, c.mistakes).draw());
        ASSERT_NE(right.rgb, as_file(draw(read)).rgb) << "the same rounding";
        const Result<CauseReport> report = find_causes(wrong, right, &read);
        ASSERT_TRUE(report && !report->causes.empty()) << c.name;
        EXPECT_FALSE(report->causes[0].perhaps) << all_causes(report);
        EXPECT_EQ(report->causes[0].name, name) << all_causes(report);
        EXPECT_TRUE(report->then.empty()) << all_causes(report);
        EXPECT_GT(report->causes[0].explained, 0.99) << all_causes(report);
    }
}

// What is left of a highlight that is all edges is not overlooked: here one is missing, and all is brighter.
TEST(CausesOfTracers, AreNotSureIfTheyLeaveHighlights) {
    SmallScene scene = row(false, false);
    scene.width = 160;
    scene.height = 120;
    for (SmallBall& ball : scene.balls) ball.shininess *= 4;
    Scene read = read_scene(text_of(scene));
    read.settings.width = scene.width;
    read.settings.height = scene.height;
    SmallScene other = scene;
    other.ambient *= 1.5;
    other.balls[1].specular = 0;
    const Image wrong = picture(other, {});
    const CauseReport report = find_causes(wrong, as_file(draw(read)), &read).value();
    ASSERT_FALSE(report.causes.empty());
    EXPECT_TRUE(report.causes[0].perhaps || !report.then.empty()) << all_causes(report);
}

// Other numbers of the same scene: no mistake of the table is named surely.
TEST(CausesOfTracers, AreNotNamedForOtherNumbers) {
    for (const auto& make : {table, row}) {
        const Scene read = read_scene(text_of(make(false, false)));
        const Image right = as_file(draw(read));
        const auto expect_none = [&](const char* what, const SmallScene& scene, const Mistakes& mistakes) {
            const CauseReport report = find_causes(picture(scene, mistakes), right, &read).value();
            for (const Cause& cause : report.causes) {
                const bool is_of_table = std::any_of(cases().begin(), cases().end(),
                                                     [&](const Case& c) { return cause.name == c.name; });
                EXPECT_FALSE(is_of_table && !cause.perhaps) << what << "\n" << all_causes(report);
                EXPECT_FALSE(is_of_table && &cause == &report.causes[0]) << what << "\n"
                                                                         << all_causes(report);
            }
        };
        expect_none("stretched", make(false, false), {.x_factor = 0.88});
        expect_none("another angle", make(false, false), {.plane_factor = 1.3});
        SmallScene dim = make(false, false), sharp = dim, moved = dim, near = dim;
        dim.lamp *= 0.7;
        for (SmallBall& ball : sharp.balls) ball.shininess *= 1.6;
        moved.balls[1].center.x += 0.3;
        for (Vec3& lamp : near.lamps) lamp = lamp * 0.8;
        expect_none("dim", dim, {});
        expect_none("sharp", sharp, {});
        expect_none("moved", moved, {});
        expect_none("near", near, {});
        SmallScene mirrors = make(false, true);
        const Scene with_mirrors = read_scene(text_of(mirrors));
        for (SmallBall& ball : mirrors.balls) ball.mirror *= 0.8;
        const CauseReport dimmer =
            *find_causes(picture(mirrors, {}), as_file(draw(with_mirrors)), &with_mirrors);
        EXPECT_EQ(first_cause(dimmer), "mirror-scaled") << all_causes(dimmer);
    }
}

// What is not in the tables is near to what is, but not the same where the lights or the highlights are.
TEST(CausesOfTracers, AreNotSureOfOtherMistakes) {
    for (const auto& make : {table, row}) {
        for (const Case& c : {Case{"exponent squared", {.exponent_squared = true}},
                              Case{"divided by the eye's distance", {.fades_from_eye = true}}}) {
            SmallScene scene = make(c.blinn, false);
            const Scene read = read_scene(text_of(scene));
            const CauseReport report = *find_causes(picture(scene, c.mistakes), as_file(draw(read)), &read);
            EXPECT_TRUE(report.causes.empty() || report.causes[0].perhaps) << c.name << all_causes(report);
        }
        // The same exponent for all highlights, and light that fades from the lamp, are known.
        SmallScene sharp = make(false, false);
        for (SmallBall& ball : sharp.balls) ball.shininess *= 2;
        const Scene read = read_scene(text_of(make(false, false)));
        const CauseReport report = *find_causes(picture(sharp, {}), as_file(draw(read)), &read);
        EXPECT_EQ(first_cause(report), "exponent") << all_causes(report);
        EXPECT_FALSE(report.causes.empty() || report.causes[0].perhaps) << all_causes(report);
    }
}

// What is left of the highlights is a dot of each.
TEST(CausesOfTracers, HighlightsThatHaveNearlyVanished) {
    for (const auto& make : {table, row}) {
        for (const bool blinn : {false, true}) {
            SmallScene scene = make(blinn, false);
            scene.width = 160;
            scene.height = 120;
            Scene read = read_scene(text_of(scene));
            read.settings.width = scene.width;
            read.settings.height = scene.height;
            const Image right = as_file(draw(read));
            const auto causes_of = [&](double exponent, double specular) {
                SmallScene wrong = scene;
                for (SmallBall& ball : wrong.balls) {
                    ball.shininess *= exponent;
                    ball.specular *= specular;
                }
                return *find_causes(picture(wrong, {}), right, &read);
            };
            for (const double exponent : {20.0, 40.0, 100.0}) {
                const CauseReport report = causes_of(exponent, 1);
                for (const Cause& cause : report.causes)
                    EXPECT_TRUE(cause.perhaps) << exponent << all_causes(report);
            }
            const CauseReport report = causes_of(1, 0);
            EXPECT_EQ(first_cause(report), "specular-missing") << all_causes(report);
            EXPECT_FALSE(report.causes.empty() || report.causes[0].perhaps) << all_causes(report);
        }
    }
}

// In the range of a picture, 1 / (3 + d) is near 0.8 / (1 + d).
TEST(CausesOfTracers, AFactorDoesNotTellHowLightFades) {
    for (const auto& make : {table, row}) {
        const SmallScene scene = make(false, false);
        const Scene read = read_scene(text_of(scene));
        const CauseReport report = *find_causes(picture(scene, {.distance_power = 1, .distance_offset = 3}),
                                                as_file(draw(read)), &read);
        EXPECT_EQ(first_cause(report), "attenuation-added") << all_causes(report);
        EXPECT_TRUE(report.causes.empty() || report.causes[0].perhaps) << all_causes(report);
        for (const Cause& cause : report.then) EXPECT_TRUE(cause.perhaps) << all_causes(report);
    }
}

// The half size is the tangent divided by 2, or twice it: not an angle that is halved or doubled.
TEST(CausesOfTracers, AViewOfHalfTheSize) {
    for (const auto& make : {table, row}) {
        for (const double factor : {0.5, 2.0}) {
            const SmallScene scene = make(false, false);
            const Scene read = read_scene(text_of(scene));
            const CauseReport report =
                *find_causes(picture(scene, {.plane_factor = factor}), as_file(draw(read)), &read);
            EXPECT_EQ(first_cause(report), "field-of-view-scaled") << factor << all_causes(report);
            EXPECT_FALSE(report.causes.empty() || report.causes[0].perhaps) << all_causes(report);
            EXPECT_TRUE(report.then.empty()) << all_causes(report);
        }
    }
}

// Of a fault that is a sum of pictures and one of the kernels, both are in all of these pictures.
TEST(CausesOfTracers, BlackShadowsAndAnotherFault) {
    const SmallScene scene = table(false, false);
    const Scene read = read_scene(text_of(scene));
    const CauseReport report = *find_causes(
        picture(scene, {.specular_times_cosine = true, .black_shadow = true}), as_file(draw(read)), &read);
    ASSERT_EQ(report.then.size(), 1u) << all_causes(report);
    EXPECT_EQ(first_cause(report), "shadow-black") << all_causes(report);
    EXPECT_EQ(report.then[0].name, "highlight-times-cosine");
    EXPECT_FALSE(report.then[0].perhaps);
}

}  // namespace
}  // namespace glint::test
