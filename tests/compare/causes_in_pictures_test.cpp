// SPDX-License-Identifier: Apache-2.0
// Faults that are planted in the pixels are named, with the scene and without it.
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <iostream>
#include <tuple>

#include "compare/planted_faults.h"

namespace glint::test {
namespace {

using Change = std::function<Image(const Image& drawn)>;  // of the unclamped picture

struct PicturePlant {
    const char* label;
    const char* cause;
    Change change;
    bool needs_scene = false;
};

// Pixel (x, y) is pixel from(x, y) of the picture, or black if that is outside.
template <class From> Image moved(const Image& image, From&& from) {
    Image out{image.width, image.height, std::vector<float>(image.rgb.size())};
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const auto [u, v] = from(x, y);
            if (u < 0 || v < 0 || u >= image.width || v >= image.height) continue;
            for (int c = 0; c < 3; ++c)
                out.rgb[3 * (y * image.width + x) + c] = image.rgb[3 * (v * image.width + u) + c];
        }
    }
    return out;
}

template <class Curve> Image curved(const Image& image, Curve&& curve) {
    Image out = image;
    for (float& v : out.rgb)
        v = static_cast<float>(curve(std::fmin(std::fmax(static_cast<double>(v), 0), 1)));
    return out;
}

Change shifted(int dx, int dy) {
    return [=](const Image& image) {
        return moved(image, [=](int x, int y) { return std::pair{x - dx, y - dy}; });
    };
}
Change channels(std::array<int, 3> order) {
    return [=](const Image& image) {
        Image out = image;
        for (std::size_t i = 0; i < image.rgb.size(); ++i) out.rgb[i] = image.rgb[i / 3 * 3 + order[i % 3]];
        return out;
    };
}

Image upside_down(const Image& image) {
    return moved(image, [&](int x, int y) { return std::pair{x, image.height - 1 - y}; });
}
Image mirrored(const Image& image) {
    return moved(image, [&](int x, int y) { return std::pair{image.width - 1 - x, y}; });
}
Image rotated(const Image& image) { return mirrored(upside_down(image)); }
Image encoded(const Image& image) {
    return as_file(decode(encode(image, {FileFormat::ppm, 16, Transfer::srgb}).value()).value().image);
}
Image wrapped(const Image& image) {
    Image out = image;
    for (float& v : out.rgb) v = static_cast<float>(static_cast<unsigned>(v * 255) & 255u) / 255;
    return out;
}
Image cut_off(const Image& image) {
    return curved(image, [](double v) { return std::floor(v * 255) / 255; });
}
Image darker(const Image& image) {
    Image out = image;
    for (float& v : out.rgb) v *= 0.6f;
    return out;
}

Change in_bytes(std::array<int, 3> factors, int added) {
    return [=](const Image& image) {
        Image out = as_file(image);
        for (std::size_t i = 0; i < out.rgb.size(); ++i)
            out.rgb[i] = out.rgb[i] * static_cast<float>(factors[i % 3]) + static_cast<float>(added) / 255;
        return out;
    };
}

const PicturePlant k_picture_plants[] = {
    {"without blue", "channel-missing", in_bytes({1, 1, 0}, 0)},
    {"only red", "channel-missing", in_bytes({1, 0, 0}, 0)},
    {"red thrice", "grey", channels({0, 0, 0})},
    {"30 more", "constant-added", in_bytes({1, 1, 1}, 30)},
    {"10 less", "constant-added", in_bytes({1, 1, 1}, -10)},
    {"upside down", "upside-down", upside_down},
    {"mirrored", "mirrored", mirrored},
    {"rotated", "rotated", rotated},
    {"blue green red", "red-blue-swapped", channels({2, 1, 0})},
    {"green red blue", "red-green-swapped", channels({1, 0, 2})},
    {"red blue green", "green-blue-swapped", channels({0, 2, 1})},
    {"green blue red", "channels-rotated", channels({1, 2, 0})},
    {"negative", "inverted",
     [](const Image& image) { return curved(image, [](double v) { return 1 - v; }); }},
    {"one right", "shifted-one-pixel", shifted(1, 0)},
    {"one left", "shifted-one-pixel", shifted(-1, 0)},
    {"one down", "shifted-one-pixel", shifted(0, 1)},
    {"one up and left", "shifted-one-pixel", shifted(-1, -1)},
    {"sRGB curve", "gamma-applied", encoded},
    {"gamma 2.2", "gamma-applied",
     [](const Image& image) { return curved(image, [](double v) { return std::pow(v, 1 / 2.2); }); }},
    {"decoded", "gamma-missing",
     [](const Image& image) { return curved(image, [](double v) { return std::pow(v, 2.2); }); }},
    {"scaled", "light-intensity", darker},
    {"not clamped", "not-clamped", wrapped, true},
    {"not rounded", "rounded-down", cut_off, true},
};

class PlantedInPixels : public ::testing::TestWithParam<int> {};

TEST_P(PlantedInPixels, AreNamedFirst) {
    // Brighter, for some colors to be above 1.
    const std::string text = with_light(test_scenes()[GetParam()].text, 2.5);
    const Scene reference_scene = read_scene(text);
    const Image drawn = draw(reference_scene), reference = as_file(drawn);
    std::vector<Image> pictures;
    for (const PicturePlant& plant : k_picture_plants) pictures.push_back(as_file(plant.change(drawn)));
    for (const bool with_scene : {false, true}) {
        const auto reports =
            find_causes(std::span(pictures), reference, with_scene ? &reference_scene : nullptr);
        for (std::size_t i = 0; i < reports.size(); ++i) {
            const PicturePlant& plant = k_picture_plants[i];
            EXPECT_NE(reference.rgb, pictures[i].rgb) << plant.label << ": nothing was planted";
            if (plant.needs_scene && !with_scene) continue;
            EXPECT_EQ(first_cause(reports[i]), plant.cause) << plant.label << with_scene << "\n"
                                                            << all_causes(reports[i]);
            if (reports[i]->causes.empty()) continue;
            const double explained = reports[i]->causes.front().explained;
            std::cout << plant.label << (with_scene ? ", by the scene: " : ": ") << first_cause(reports[i])
                      << " " << 100 * explained << "%\n";
            EXPECT_GT(explained, 0.85) << plant.label;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Scene, PlantedInPixels, ::testing::Range(0, k_scenes_to_test));

// Of a picture of twice the size whose rays pass corners, every second pixel is where the rays of the plain
// size pass, and those beside it half a pixel from there.
TEST(CausesInPictures, HalfAPixel) {
    for (const TestScene& scene : scenes_to_test()) {
        const std::string text = with_key(scene.text, "pixel_sample", "center");
        const Scene reference_scene = read_scene(text);
        const Image reference = draw_text(text);
        const std::string twice =
            replaced(with_key(scene.text, "pixel_sample", "corner"), "160 x 120", "320 x 240");
        const Image large = draw_text(twice);
        // Columns of centers are odd, rows of centers are even.
        const std::pair<int, int> from[] = {{0, 0}, {2, 0}, {1, 1}, {0, 1}};
        const char* const words[] = {
            "pixel to the right:", "pixel to the left:", "pixel up:", "pixel to the right and up:"};
        std::vector<Image> pictures;
        for (const auto& [dx, dy] : from) {
            Image faulty{160, 120, std::vector<float>(160 * 120 * 3)};
            for (int y = 0; y < 120; ++y) {
                for (int x = 0; x < 160; ++x) {
                    const int u = std::min(2 * x + dx, 319), v = 2 * y + dy;
                    std::copy_n(&large.rgb[3 * (v * 320 + u)], 3, &faulty.rgb[3 * (y * 160 + x)]);
                }
            }
            pictures.push_back(std::move(faulty));
        }
        for (const bool with_scene : {false, true}) {
            const auto reports = find_causes(std::span<const Image>(pictures), reference,
                                             with_scene ? &reference_scene : nullptr);
            for (std::size_t i = 0; i < reports.size(); ++i) {
                EXPECT_EQ(first_cause(reports[i]), "shifted-half-pixel")
                    << scene.name << with_scene << all_causes(reports[i]);
                if (reports[i]->causes.empty()) continue;
                EXPECT_NE(reports[i]->causes.front().explanation.find(words[i]), std::string::npos)
                    << words[i] << reports[i]->causes.front().explanation;
                std::cout << "half a " << words[i] << " " << scene.name
                          << (with_scene ? " by the scene " : " ")
                          << 100 * reports[i]->causes.front().explained << "%\n";
            }
        }
    }
}

TEST(CausesInPictures, GammaOfTheReference) {
    for (const TestScene& scene : scenes_to_test()) {
        const Image drawn = draw(read_scene(scene.text)), once = encoded(drawn);
        EXPECT_EQ(first_cause(find_causes(as_file(drawn), once)), "gamma-missing") << scene.name;
        EXPECT_EQ(first_cause(find_causes(encoded(once), once)), "gamma-applied") << scene.name;
    }
}

TEST(CausesInPictures, AnyGammaOfATenth) {
    for (const TestScene& scene : scenes_to_test()) {
        const Scene read = read_scene(scene.text);
        const Image drawn = draw(read), right = as_file(drawn);
        for (const auto& [power, name, number] : {std::tuple{1 / 1.8, "gamma-applied", "1/1.8"},
                                                  {1 / 1.5, "gamma-applied", "1/1.5"},
                                                  {2.0, "gamma-missing", "1/2.0"}}) {
            const Image faulty =
                as_file(curved(drawn, [power = power](double v) { return std::pow(v, power); }));
            for (const Scene* with : {static_cast<const Scene*>(nullptr), &read}) {
                const auto report = find_causes(faulty, right, with);
                ASSERT_EQ(first_cause(report), name) << scene.name << power << all_causes(report);
                EXPECT_NE(report->causes[0].explanation.find(number), std::string::npos)
                    << all_causes(report);
                EXPECT_FALSE(with != nullptr && report->causes[0].perhaps) << scene.name << power;
            }
        }
    }
}

// Specks as another renderer's acne has them, not glint's own.
TEST(CausesInPictures, SpecksAreAcne) {
    for (const TestScene& scene : scenes_to_test()) {
        const Image reference = draw_text(scene.text);
        const Image dark =
            draw_text(replaced(scene.text, "(type = (point|directional)[^}]*)\\}", "$1 color = (0, 0, 0) }"));
        Image faulty = reference;
        std::uint32_t state = 7;
        for (int y = 30; y < 100; ++y) {
            for (int x = 20; x < 140; ++x) {
                state = state * 1664525u + 1013904223u;
                if ((state >> 28) > 5) continue;
                std::copy_n(&dark.rgb[3 * (y * 160 + x)], 3, &faulty.rgb[3 * (y * 160 + x)]);
            }
        }
        const CauseReport report = find_causes(faulty, reference).value();
        EXPECT_EQ(first_cause(report), "acne") << scene.name << all_causes(report);
    }
}

TEST(CausesInPictures, MoreSamplesAreAntiAliasing) {
    for (const TestScene& scene : scenes_to_test()) {
        // One sample in the middle: else the mean of many is half a pixel away from it.
        const std::string text = with_key(scene.text, "pixel_sample", "center");
        const CauseReport report =
            find_causes(draw_text(replaced(text, "aa = 1", "aa = 4")), draw_text(text)).value();
        EXPECT_EQ(first_cause(report), "anti-aliasing") << scene.name << all_causes(report);
    }
}

// What the pictures alone cannot show is not blamed on something that they can.
TEST(CausesInPictures, LightingIsNotTakenForAnythingElse) {
    for (const TestScene& scene : scenes_to_test()) {
        for (const char* const key : {"shadows = true", "reflections = 2"}) {
            const std::string word(key, std::strcspn(key, " "));
            const std::string faulty =
                replaced(scene.text, key, word == "shadows" ? "shadows = false" : "reflections = 0");
            const CauseReport report = find_causes(draw_text(faulty), draw_text(scene.text)).value();
            EXPECT_TRUE(report.causes.empty()) << scene.name << " " << key << all_causes(report);
        }
    }
}

TEST(CausesInPictures, SizesAndEmptyPictures) {
    const Image small{2, 2, std::vector<float>(12)}, none;
    EXPECT_NE(find_causes(small, Image{2, 1, std::vector<float>(6)}).message, "");
    EXPECT_NE(find_causes(small, none).message, "");
    EXPECT_NE(find_causes(none, small).message, "");
    EXPECT_NE(find_causes(none, none).message, "");
    EXPECT_EQ(find_causes(small, small).message, "");
    EXPECT_TRUE(find_causes(std::span<const Image>{}, small, nullptr).empty());
}

}  // namespace
}  // namespace glint::test
