// SPDX-License-Identifier: Apache-2.0
// Noise, quantisation and dithering have no cause; small changes of the scene are not taken for another
// cause.
#include <algorithm>
#include <cmath>

#include "compare/small_scene.h"

namespace glint::test {
namespace {

// change(value in 0 to 255, index of the channel)
template <class Change> Image changed(const Image& image, Change&& change) {
    Image out = image;
    for (std::size_t i = 0; i < out.rgb.size(); ++i) {
        const double value = std::floor(255 * static_cast<double>(std::clamp(out.rgb[i], 0.0f, 1.0f)) + 0.5);
        out.rgb[i] = static_cast<float>(std::clamp(change(value, i), 0.0, 255.0) / 255);
    }
    return out;
}

double noise(std::size_t i, std::uint32_t levels) {
    auto h = static_cast<std::uint32_t>(i) * 2654435761u;
    h ^= h >> 15;
    h *= 2246822519u;
    return static_cast<double>((h >> 16) % levels);
}

TEST(CausesOfNoise, NoCause) {
    const Scene scene = read_scene(k_scene);
    const Image right = draw_text(k_scene);
    const auto dithered = [](double value, std::size_t i) {
        constexpr double thresholds[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
        const std::size_t x = i / 3 % 60, y = i / 180;
        return std::floor(std::floor(value / 255 * 7 + (thresholds[y % 4][x % 4] + 0.5) / 16) * 255 / 7 +
                          0.5);
    };
    const std::pair<const char*, Image> pictures[] = {
        {"one more or less", changed(right, [](double v, std::size_t i) { return v + noise(i, 3) - 1; })},
        {"one more", changed(right, [](double v, std::size_t i) { return v + noise(i, 2); })},
        {"six bits", changed(right, [](double v, std::size_t) { return std::floor(v / 4) * 4; })},
        {"five bits", changed(right, [](double v, std::size_t) { return std::floor(v / 8) * 8 + 4; })},
        {"eight levels, dithered", changed(right, dithered)}};
    for (const auto& [name, picture] : pictures) {
        for (const Scene* with : {static_cast<const Scene*>(nullptr), &scene}) {
            const CauseReport report = *find_causes(picture, right, with);
            EXPECT_GT(report.difference, 0);
            EXPECT_TRUE(report.causes.empty()) << name << all_causes(report);
        }
    }
}

bool is_named(const CauseReport& report, const char* name) {
    return std::any_of(report.causes.begin(), report.causes.end(),
                       [&](const Cause& cause) { return cause.name == name; });
}

TEST(CausesOfNoise, ALightThatMovedIsNoConstant) {
    const Scene scene = read_scene(k_scene);
    const Image right = draw_text(k_scene);
    for (const char* place : {"position = (3.4, 5, 4)", "position = (3, 5.5, 4)", "position = (3, 5, 5)"}) {
        const Image moved = draw_text(replaced(k_scene, "position = \\(3, 5, 4\\)", place));
        EXPECT_FALSE(is_named(*find_causes(moved, right), "constant-added")) << place;
        EXPECT_EQ(first_cause(find_causes(moved, right, &scene)), "light-moved") << place;
    }
}

TEST(CausesOfNoise, ACameraThatMovedIsNoShift) {
    const Scene scene = read_scene(k_scene);
    const Image right = draw_text(k_scene);
    for (const char* place :
         {"position = (0.52, 2, 7)", "position = (0.5, 2.04, 7)", "position = (0.56, 2, 7)"}) {
        const Image moved = draw_text(replaced(k_scene, "position = \\(0.5, 2, 7\\)", place));
        for (const Scene* with : {static_cast<const Scene*>(nullptr), &scene}) {
            const CauseReport report = *find_causes(moved, right, with);
            EXPECT_FALSE(is_named(report, "shifted-half-pixel")) << place << all_causes(report);
            EXPECT_FALSE(is_named(report, "anti-aliasing")) << place << all_causes(report);
            if (with != nullptr && !report.causes.empty()) {
                EXPECT_EQ(first_cause(report).substr(0, 7), "camera-") << place << all_causes(report);
            }
        }
    }
}

// Other samples give means of both sides of an edge; edges that have moved do not.
TEST(CausesOfNoise, MoreSamplesAreAntiAliasing) {
    const Image right = draw_text(k_scene);
    const Image samples = draw_text(replaced(k_scene, "size = 60", "aa = 3  size = 60"));
    EXPECT_EQ(first_cause(find_causes(samples, right)), "anti-aliasing");
    EXPECT_EQ(first_cause(find_causes(right, samples)), "anti-aliasing");
}

}  // namespace
}  // namespace glint::test
