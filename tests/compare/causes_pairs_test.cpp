// SPDX-License-Identifier: Apache-2.0
// Two causes at once: both are named.
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "compare/small_scene.h"

namespace glint::test {
namespace {

TEST(CausesPairs, OfTheSceneAndOfThePicture) {
    const Scene scene = read_scene(k_scene);
    const Image right = draw_text(k_scene);
    const std::string dark = replaced(k_scene, "light \\{ type = ambient[^}]*\\}", "");
    const Image both = draw_text(replaced(dark, "shading = phong", "shading = phong  shadows = false"));
    Image flipped = draw_text(dark);
    for (std::ptrdiff_t y = 0; y < 45 / 2; ++y)
        std::swap_ranges(flipped.rgb.begin() + 180 * y, flipped.rgb.begin() + 180 * (y + 1),
                         flipped.rgb.begin() + 180 * (44 - y));
    for (const auto& [picture, other] : {std::pair{both, "shadows-missing"}, {flipped, "upside-down"}}) {
        const CauseReport report = *find_causes(picture, right, &scene);
        ASSERT_EQ(report.causes.empty(), false);
        ASSERT_EQ(report.then.size(), 1u) << all_causes(report);
        const std::set<std::string> names = {first_cause(report), report.then[0].name};
        EXPECT_EQ(names, (std::set<std::string>{"ambient-missing", other})) << all_causes(report);
        EXPECT_FALSE(report.then[0].perhaps);
        EXPECT_GT(report.then[0].explained, 0.99);
    }
}

struct PlantedPair {
    const char *first, *first_with, *second, *second_with;  // patterns in the scene's text
    std::set<std::string> names;
};

std::set<std::string> names_of(const CauseReport& report) {
    std::set<std::string> names = {first_cause(report)};
    for (const Cause& cause : report.then) names.insert(cause.name);
    return names;
}

// The numbers of both are fitted together: each alone fits the other's change, too.
TEST(CausesPairs, WithFittedNumbers) {
    const PlantedPair planted[] = {
        {"ambient  intensity = 0.9",
         "ambient  intensity = 1.35",
         "intensity = 0.6",
         "intensity = 0.3",
         {"ambient-scaled", "light-scaled"}},
        {"intensity = 0.4",
         "intensity = 0.7",
         "mirror = 0.4",
         "mirror = 0.2",
         {"light-scaled", "mirror-scaled"}},
        {"ambient  intensity = 0.9",
         "ambient  intensity = 0",
         "position = \\(3, 5, 4\\)",
         "position = (3.8, 5, 4)",
         {"ambient-missing", "light-moved"}},
    };
    const Scene scene = read_scene(k_scene);
    const Image right = draw_text(k_scene);
    for (const PlantedPair& p : planted) {
        const std::string text = replaced(replaced(k_scene, p.first, p.first_with), p.second, p.second_with);
        const CauseReport report = *find_causes(draw_text(text), right, &scene);
        EXPECT_EQ(names_of(report), p.names) << all_causes(report);
        ASSERT_EQ(report.then.size(), 1u) << all_causes(report);
        EXPECT_FALSE(report.then[0].perhaps) << report.then[0].explanation;
    }
}

// One is a fault of the picture, and the other one a factor; or both are of the picture.
TEST(CausesPairs, WithAGamma) {
    const Scene scene = read_scene(k_scene);
    const Image right = draw_text(k_scene);
    const auto with_gamma = [](Image image) {
        for (float& v : image.rgb) v = std::pow(std::clamp(v, 0.0f, 1.0f), 1 / 2.2f);
        return as_file(image);
    };
    const Image lit = draw_text(replaced(k_scene, "intensity = 0.6", "intensity = 0.3"));
    Image flipped = right;
    for (std::ptrdiff_t y = 0; y < 45 / 2; ++y)
        std::swap_ranges(flipped.rgb.begin() + 180 * y, flipped.rgb.begin() + 180 * (y + 1),
                         flipped.rgb.begin() + 180 * (44 - y));
    for (const auto& [picture, other] : {std::pair{lit, "light-scaled"}, {flipped, "upside-down"}}) {
        const CauseReport report = *find_causes(with_gamma(picture), right, &scene);
        EXPECT_EQ(names_of(report), (std::set<std::string>{"gamma-applied", other})) << all_causes(report);
    }
}

// A shift changes edges only; it is no turned camera.
TEST(CausesPairs, WithAShift) {
    const Scene scene = read_scene(k_scene);
    const Image right = draw_text(k_scene);
    const std::string no_ambient = replaced(k_scene, "ambient  intensity = 0.9", "ambient  intensity = 0");
    const std::string no_shadows = replaced(k_scene, "shading = phong", "shading = phong  shadows = false");
    const auto to_the_right = [](Image image) {
        for (std::ptrdiff_t y = 0; y < 45; ++y)
            std::copy_backward(image.rgb.begin() + 180 * y, image.rgb.begin() + 180 * y + 177,
                               image.rgb.begin() + 180 * y + 180);
        return image;
    };
    const std::string corner = with_key(no_shadows, "pixel_sample", "corner");
    const std::tuple<Image, const char*, const char*> planted[] = {
        {to_the_right(draw_text(no_ambient)), "ambient-missing", "shifted-one-pixel"},
        {to_the_right(draw_text(no_shadows)), "shadows-missing", "shifted-one-pixel"},
        {draw_text(corner), "shadows-missing", "shifted-half-pixel"}};
    for (const auto& [picture, name, shift] : planted) {
        const CauseReport report = *find_causes(picture, right, &scene);
        EXPECT_EQ(names_of(report), (std::set<std::string>{name, shift})) << all_causes(report);
    }
}

// Without mirrors and without the ambient term hardly any step of the colors stays.
TEST(CausesPairs, ThatLookLikeAnotherScene) {
    const std::string bright = replaced(k_scene, "mirror = 0.4", "mirror = 0.9");
    const Scene scene = read_scene(bright);
    const std::string dark = replaced(bright, "ambient  intensity = 0.9", "ambient  intensity = 0");
    const Image both = draw_text(replaced(dark, "reflections = 2", "reflections = 0"));
    const CauseReport report = *find_causes(both, draw_text(bright), &scene);
    EXPECT_EQ(names_of(report), (std::set<std::string>{"ambient-missing", "reflections-missing"}))
        << all_causes(report);
}

}  // namespace
}  // namespace glint::test
