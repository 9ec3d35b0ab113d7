// SPDX-License-Identifier: Apache-2.0
// Pictures that agree but for rounding, and pictures of which only guesses can be made: nothing is named
// surely.
#include "compare/small_scene.h"

namespace glint::test {
namespace {

// The channel of a pixel, by n 255ths more, or less where more would be above 1.
Image changed(Image image, std::int32_t x, std::int32_t y, int n) {
    float& value = image.rgb[3 * (static_cast<std::size_t>(y) * image.width + x)];
    const float by = static_cast<float>(n) / 255;
    value = value + by > 1 ? value - by : value + by;
    return image;
}

bool contains(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

TEST(Agreement, OnePixelThatIsRoundedOtherwiseHasNoCause) {
    const Scene scene = read_scene(k_scene);
    const Image right = draw_text(k_scene);
    for (const Scene* with : {static_cast<const Scene*>(nullptr), &scene}) {
        const CauseReport report = find_causes(changed(right, 30, 20, 1), right, with).value();
        EXPECT_TRUE(report.agrees);
        EXPECT_EQ(report.remark,
                  "The pictures agree: all pixels are within rounding; 1 of 2700 differs by 1 of 255.");
        EXPECT_TRUE(report.causes.empty()) << all_causes(report);
        EXPECT_FALSE(report.nearest);
        EXPECT_EQ(report.tried, 0);
    }
    const CauseReport more = find_causes(changed(right, 30, 20, 2), right, &scene).value();
    EXPECT_FALSE(more.agrees);
    EXPECT_TRUE(contains(more.remark, "All pixels but 1 of 2700 are within rounding")) << more.remark;
    EXPECT_TRUE(more.causes.empty()) << all_causes(more);
}

// Every other pixel is off by one: truncation does this, but without the scene nobody knows.
TEST(Agreement, ManyPixelsWithinRoundingAgree) {
    const Scene scene = read_scene(k_scene);
    const Image right = draw_text(k_scene);
    Image off = right;
    for (std::int32_t y = 0; y < off.height; ++y) {
        for (std::int32_t x = y % 2; x < off.width; x += 2) off = changed(std::move(off), x, y, 1);
    }
    for (const Scene* with : {static_cast<const Scene*>(nullptr), &scene}) {
        const CauseReport report = find_causes(off, right, with).value();
        EXPECT_TRUE(report.agrees);
        EXPECT_TRUE(report.causes.empty()) << all_causes(report);
        EXPECT_TRUE(contains(report.remark, "1350 of 2700 differ by 1 of 255")) << report.remark;
    }
}

TEST(Agreement, TruncationIsNamed) {
    const Scene scene = read_scene(k_scene);
    Image off = draw(scene);
    for (float& v : off.rgb) v = std::floor(255 * std::min(v, 1.0f)) / 255;
    const CauseReport report = find_causes(off, draw_text(k_scene), &scene).value();
    EXPECT_TRUE(report.agrees);
    EXPECT_EQ(first_cause(report), "rounded-down") << all_causes(report);
}

// A smooth gradient has no edges, though each wrong value is one that a neighbour has.
TEST(Agreement, NoiseOnAGradientIsNoAntiAliasing) {
    const int width = 60, height = 45;
    Image right{width, height, std::vector<float>(3 * width * height)};
    Image off = right;
    std::uint32_t state = 1;
    for (std::size_t i = 0; i < right.rgb.size() / 3; ++i) {
        const auto x = static_cast<int>(i % width);
        state = state * 1664525u + 1013904223u;
        const int noise = state >> 30 == 0 ? 2 : 0;
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c) {
            right.rgb[c] = static_cast<float>(20 + 3 * std::min(x, width - 1 - x)) / 255;
            off.rgb[c] = right.rgb[c] + static_cast<float>(noise) / 255;
        }
    }
    const CauseReport report = find_causes(off, right).value();
    for (const Cause& cause : report.causes) EXPECT_NE(cause.name, "anti-aliasing") << all_causes(report);
}

// A shadow ray that begins at P + epsilon N and has the direction L, as a correct program may send it: a few
// pixels at the borders of shadows differ, and nothing is behind the light.
TEST(Agreement, BordersOfShadowsAreNoSureCause) {
    Scene scene = read_scene(R"(
camera { position = (1.5, -9, 3.2)  look_at = (0.3, 0, 0.9)  up = (0, 0, 1)  fov_x = 48 }
light { type = ambient }
light { type = point  position = (-5, -6, 7)  color = (0.9, 0.8, 0.65) }
plane { point = (0, 0, 0)  normal = (0, 0, 1)  color = (0.55, 0.38, 0.22)  ambient = 0.2  diffuse = 0.7 }
sphere { center = (-1.6, -0.5, 1)  radius = 1  color = (0.9, 0.2, 0.1)  ambient = 0.2  diffuse = 0.7 }
sphere { center = (1.4, 0.3, 0.8)  radius = 0.8  color = (0.3, 0.8, 0.6)  ambient = 0.2  diffuse = 0.7 }
render { size = 320 x 240 })");
    scene.conventions.offset = Offset::normal;
    scene.conventions.epsilon = 0.001;
    Scene other = scene;
    other.conventions.shadow_stops_at_light = false;
    const CauseReport report = find_causes(draw(other), draw(scene), &scene).value();
    EXPECT_GT(report.difference, 0);
    EXPECT_TRUE(report.causes.empty()) << all_causes(report);
    EXPECT_TRUE(contains(report.remark, "these are on edges, where renderers differ")) << report.remark;
}

// The same scene without its objects: rows in which nothing is visible were written all the same.
TEST(Agreement, RowsWithoutObjectsAreNotSurelyMissing) {
    const std::string ball = R"(
background = (0.2, 0.3, 0.5)
camera { position = (0, 0, 7)  look_at = (0, 0, 0)  fov_x = 48 }
light { type = point  position = (3, 5, 4)  intensity = 0.6 }
sphere { center = (0, 1, 0)  radius = 0.9  color = (0.9, 0.2, 0.2) }
sphere { center = (0, -1, 0)  radius = 0.9  color = (0.2, 0.2, 0.9) }
render { size = 60 x 45 })";
    const std::string without = replaced(ball, "\nsphere \\{ center = \\(0, 1,[^}]*\\}", "\n");
    const CauseReport report = find_causes(draw_text(without), draw_text(ball)).value();
    for (const Cause& cause : report.causes) EXPECT_TRUE(cause.perhaps) << all_causes(report);
}

}  // namespace
}  // namespace glint::test
