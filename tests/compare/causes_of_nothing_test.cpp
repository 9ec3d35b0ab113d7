// SPDX-License-Identifier: Apache-2.0
// Pictures that no classic cause explains, and what is said of them instead.
#include <cmath>

#include "compare/planted_faults.h"

namespace glint::test {
namespace {

Image filled(const Image& like, float r, float g, float b) {
    Image out = like;
    for (std::size_t i = 0; i < out.rgb.size(); i += 3) {
        out.rgb[i] = r;
        out.rgb[i + 1] = g;
        out.rgb[i + 2] = b;
    }
    return out;
}

// The picture with these rows, or columns, black.
template <class IsBlack> Image blackened(const Image& image, IsBlack&& is_black) {
    Image out = image;
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) {
            if (is_black(x, y)) std::fill_n(&out.rgb[3 * (y * out.width + x)], 3, 0.0f);
        }
    }
    return out;
}

bool has(const std::string& text, const char* part) { return text.find(part) != std::string::npos; }

bool names(const CauseReport& report, const char* name) {
    return std::any_of(report.causes.begin(), report.causes.end(),
                       [&](const Cause& c) { return c.name == name; });
}

TEST(CausesOfNothing, OneColor) {
    for (const TestScene& scene : scenes_to_test()) {
        const Scene reference_scene = read_scene(scene.text);
        const Image right = draw_text(scene.text);
        for (const auto& [faulty, text] : {std::pair{filled(right, 1, 1, 1), "(255, 255, 255)"},
                                           {filled(right, 0, 0, 0), "(0, 0, 0)"},
                                           {filled(right, 0.2f, 0.4f, 0.6f), "(51, 102, 153)"}}) {
            for (const Scene* with : {static_cast<const Scene*>(nullptr), &reference_scene}) {
                const CauseReport report = find_causes(faulty, right, with).value();
                EXPECT_TRUE(has(report.remark, "The picture is one color throughout")) << report.remark;
                EXPECT_TRUE(has(report.remark, text)) << report.remark;
                EXPECT_TRUE(report.causes.empty()) << scene.name << all_causes(report);
            }
            const CauseReport reverse = find_causes(right, faulty).value();
            EXPECT_TRUE(has(reverse.remark, "The reference is one color throughout")) << reverse.remark;
            EXPECT_TRUE(reverse.causes.empty()) << all_causes(reverse);
        }
    }
}

// A fault that makes just that one color is a cause all the same.
TEST(CausesOfNothing, OneColorThatAFaultMakes) {
    const std::string text =
        "camera { position = (0, 0, 0)  look_at = (0, 0, -1)  fov_x = 50 }\nrender { size = 40 x 30 }\nlight "
        "{ type = ambient  intensity = 0.5 }\n"
        "sphere { center = (0, 0, -4)  radius = 1  ambient = 1  diffuse = 0  specular = 0 }\n";
    const Scene scene = read_scene(text);
    const Image right = draw_text(text);
    const CauseReport report = find_causes(filled(right, 0, 0, 0), right, &scene).value();
    EXPECT_EQ(first_cause(report), "ambient-missing") << all_causes(report);
    EXPECT_TRUE(has(report.remark, "one color")) << report.remark;
}

// A dark reference, and a picture of another scene that is black: several faults give black, so none is
// certain.
TEST(CausesOfNothing, BlackForADarkReferenceIsNeverCertain) {
    const std::string text =
        "camera { position = (0, 0, 6)  look_at = (0, 0, 0)  fov_x = 32 }\nrender { size = 40 x 30 }\n"
        "background = (0.008, 0.008, 0.012)\nlight { type = ambient  intensity = 0.02 }\n"
        "sphere { center = (0, 0, 0)  radius = 1.4  color = (0.75, 0.12, 0.1)  diffuse = 0.8 }\n";
    const Scene scene = read_scene(text);
    const Image right = draw_text(text);
    for (const Scene* with : {static_cast<const Scene*>(nullptr), &scene}) {
        for (const Cause& cause : find_causes(filled(right, 0, 0, 0), right, with).value().causes)
            EXPECT_TRUE(cause.perhaps) << cause.name;
    }
}

TEST(CausesOfNothing, AnotherScene) {
    int named = 0, reported = 0;
    for (const TestScene& scene : scenes_to_test()) {
        const Scene reference_scene = read_scene(scene.text);
        const Image right = draw_text(scene.text);
        std::vector<Image> others;
        for (const TestScene& other : test_scenes()) {
            if (other.name != scene.name) others.push_back(draw_text(other.text));
        }
        for (const Scene* with : {static_cast<const Scene*>(nullptr), &reference_scene}) {
            for (const Result<CauseReport>& report :
                 find_causes(std::span<const Image>(others), right, with)) {
                ASSERT_TRUE(report) << report.message;
                EXPECT_EQ(report->remark, "Another scene or another view: nothing classic explains it.")
                    << scene.name;
                EXPECT_TRUE(report->causes.empty()) << scene.name << all_causes(report);
                named += report->nearest && report->nearest->explained < 0.7;
                ++reported;
            }
        }
    }
    EXPECT_GT(named, reported == 24 ? 12 : 0);  // their shares are said all the same
}

// One of two faults is named, or else the flip is said: it is not another scene.
TEST(CausesOfNothing, AFlipUnderAGamma) {
    int flips = 0;
    for (const TestScene& scene : scenes_to_test()) {
        const Image right = draw_text(scene.text);
        for (const double power : {1 / 2.2, 2.2}) {
            Image faulty = right;
            for (int y = 0; y < 120; ++y) {
                for (int i = 0; i < 480; ++i) {
                    const auto v = static_cast<double>(right.rgb[480 * (119 - y) + i]);
                    faulty.rgb[480 * y + i] =
                        static_cast<float>(std::pow(std::fmin(std::fmax(v, 0), 1), power));
                }
            }
            const CauseReport report = find_causes(faulty, right).value();
            const std::string gamma = power < 1 ? "gamma-applied" : "gamma-missing";
            EXPECT_TRUE(first_cause(report) == "upside-down" || first_cause(report) == gamma ||
                        has(report.remark, "upside down"))
                << scene.name << power << report.remark << all_causes(report);
            flips += has(report.remark, "upside down");
        }
    }
    EXPECT_GT(flips, 0);
}

// Two faults at once are not another view, even if the picture is mirrored.
TEST(CausesOfNothing, TwoFaultsAreNotAnotherView) {
    for (const TestScene& scene : scenes_to_test()) {
        const Image dark = draw_text(replaced(scene.text, "shadows = true", "shadows = false"));
        Image faulty = dark;
        for (int y = 0; y < 120; ++y) {
            for (int x = 0; x < 160; ++x)
                std::copy_n(&dark.rgb[3 * (y * 160 + 159 - x)], 3, &faulty.rgb[3 * (y * 160 + x)]);
        }
        const CauseReport report = find_causes(faulty, draw_text(scene.text)).value();
        EXPECT_EQ(first_cause(report), "mirrored") << scene.name << report.remark << all_causes(report);
    }
}

TEST(CausesOfNothing, RowsAndColumnsThatAreMissing) {
    const auto second_row = [](int, int y) { return y % 2 == 1; };
    const auto third_column = [](int x, int) { return x % 3 == 0; };
    const auto bottom = [](int, int y) { return y >= 80; };
    for (const TestScene& scene : scenes_to_test()) {
        const Scene reference_scene = read_scene(scene.text);
        const Image right = draw_text(scene.text);
        for (const Scene* with : {static_cast<const Scene*>(nullptr), &reference_scene}) {
            const CauseReport rows = find_causes(blackened(right, second_row), right, with).value();
            EXPECT_EQ(first_cause(rows), "rows-missing") << scene.name << all_causes(rows);
            EXPECT_TRUE(has(all_causes(rows), "every second row, (0, 0, 0) throughout")) << all_causes(rows);
            const CauseReport columns = find_causes(blackened(right, third_column), right, with).value();
            EXPECT_EQ(first_cause(columns), "columns-missing") << scene.name << all_causes(columns);
            EXPECT_TRUE(has(all_causes(columns), "every third column")) << all_causes(columns);
            const CauseReport half = find_causes(blackened(right, bottom), right, with).value();
            EXPECT_EQ(first_cause(half), "rows-missing") << scene.name << all_causes(half);
            EXPECT_TRUE(has(all_causes(half), "rows 80 to 119")) << all_causes(half);
        }
    }
}

// A row of one color in the picture, and of nearly that color, though not of one, in the reference.
TEST(CausesOfNothing, ARowThatIsNearlyOneColor) {
    Image right = filled({8, 8, std::vector<float>(192)}, 0.4f, 0.4f, 0.4f), faulty = right;
    for (int x = 0; x < 8; ++x) {
        for (int c = 0; c < 3; ++c) {
            right.rgb[24 + 3 * x + c] = static_cast<float>(x % 2 == 0 ? 100 : 104) / 255;
            faulty.rgb[24 + 3 * x + c] = 102.0f / 255;
        }
    }
    EXPECT_FALSE(names(*find_causes(faulty, right), "rows-missing"));
}

// Not black from end to end, but darker: nothing that has a name here, and surely no acne.
TEST(CausesOfNothing, DarkRowsAreNoAcne) {
    for (const TestScene& scene : scenes_to_test()) {
        const Image right = draw_text(scene.text);
        for (const bool rows : {true, false}) {
            Image faulty = right;
            for (int y = 0; y < 120; ++y) {
                for (int x = 0; x < 160; ++x) {
                    if ((rows ? y : x) % 4 != 0) continue;
                    for (int c = 0; c < 3; ++c) faulty.rgb[3 * (y * 160 + x) + c] *= 0.5f;
                }
            }
            const CauseReport report = find_causes(as_file(faulty), right).value();
            EXPECT_FALSE(names(report, "acne")) << scene.name << all_causes(report);
        }
    }
}

// What a shifted picture has at its rim nobody knows, but where nothing else differs the rim is looked at.
TEST(CausesOfNothing, TheRimAlone) {
    for (const TestScene& scene : scenes_to_test()) {
        const Image right = draw_text(scene.text);
        const auto top = [](int, int y) { return y == 0; };
        const CauseReport missing = find_causes(blackened(right, top), right).value();
        EXPECT_GT(missing.difference, 0);
        EXPECT_GT(missing.tried, 0);
        // Of a row that is background, black is another color as well as nothing.
        EXPECT_TRUE(names(missing, "rows-missing") || names(missing, "rim"))
            << scene.name << all_causes(missing);
        Image faulty = right;
        for (int y = 0; y < 120; ++y) faulty.rgb[3 * (y * 160 + 159)] = static_cast<float>(y % 7) / 7;
        const CauseReport rim = find_causes(as_file(faulty), right).value();
        EXPECT_EQ(first_cause(rim), "rim") << scene.name << all_causes(rim);
        EXPECT_TRUE(has(all_causes(rim), "the right column")) << all_causes(rim);
        EXPECT_EQ(find_causes(right, right)->tried, 0);
    }
}

TEST(CausesOfNothing, QuarterTurnsOfSquarePictures) {
    for (const TestScene& scene : scenes_to_test()) {
        const Image right = draw_text(replaced(scene.text, "size = 160 x 120", "size = 120 x 120"));
        const auto moved = [&](auto&& from) {
            Image out = right;
            for (int y = 0; y < 120; ++y) {
                for (int x = 0; x < 120; ++x) {
                    const auto [u, v] = from(x, y);
                    std::copy_n(&right.rgb[3 * (v * 120 + u)], 3, &out.rgb[3 * (y * 120 + x)]);
                }
            }
            return out;
        };
        // To the left: the top right corner becomes the top left one.
        const std::pair<const char*, Image> turned[] = {{"turned-left", moved([](int x, int y) {
                                                             return std::pair{119 - y, x};
                                                         })},
                                                        {"turned-right", moved([](int x, int y) {
                                                             return std::pair{y, 119 - x};
                                                         })},
                                                        {"transposed", moved([](int x, int y) {
                                                             return std::pair{y, x};
                                                         })},
                                                        {"transposed", moved([](int x, int y) {
                                                             return std::pair{119 - y, 119 - x};
                                                         })}};
        for (const auto& [cause, faulty] : turned) {
            const CauseReport report = find_causes(faulty, right).value();
            EXPECT_EQ(first_cause(report), cause) << scene.name << all_causes(report);
            EXPECT_EQ(report.causes.empty() ? -1 : report.causes.front().remaining, 0);
        }
    }
    const Image wide{4, 3, std::vector<float>(36)}, high{3, 4, std::vector<float>(36)};
    EXPECT_TRUE(has(find_causes(wide, high).message, "4x3 and 3x4; width and height are swapped"));
    EXPECT_TRUE(has(compare(wide, high).message, "width and height are swapped"));
}

}  // namespace
}  // namespace glint::test
