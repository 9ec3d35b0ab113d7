// SPDX-License-Identifier: Apache-2.0
// text. The stage `peers` compares the pictures with POV-Ray's.
#include "formats/mistakes.h"
#include "formats/povray_text.h"
#include "formats/tiny_font.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::test {
namespace {

TextSources fonts() {
    return TextSources({{"tiny.ttf", tiny_font()},
                        {"/usr/share/povray-3.7/include/own.ttf", tiny_font()},
                        {"scene.ttf", "sphere { 0, 1 }"},
                        {"post.otf", "OTTO" + tiny_font().substr(4)},
                        {"short.ttf", tiny_font().substr(0, 300)}});
}

Scene text_scene(const std::string& items, const std::string& before = {}) {
    TextSources sources = fonts();
    return povray_scene(before + "text { " + items + " }", &sources);
}

std::string said_of_text(const std::string& text) {
    TextSources sources = fonts();
    return messages(read_povray("light_source { <0, 0, -9>, rgb 1 }\n" + text, &sources));
}

const MeshData& text_mesh(const Scene& scene) {
    EXPECT_EQ(scene.meshes.size(), 1u);
    static const MeshData none;
    return scene.meshes.empty() ? none : *scene.meshes[0];
}

TEST(PovRayText, CharactersBeyondAsciiNeedACharset) {
    const auto said = [](const std::string& characters, const std::string& before = {}) {
        return said_of_text(before + "text { ttf \"tiny.ttf\" " + characters + " 1, 0 }");
    };
    EXPECT_NE(said("\"\u00e4\"").find("`text` (of characters beyond ASCII without `charset utf8`)"),
              std::string::npos)
        << said("\"\u00e4\"");
    EXPECT_EQ(said("\"\u00e4\"", "global_settings { charset utf8 } "), "");
    EXPECT_EQ(said("chr(228)"), "");
    EXPECT_EQ(said("\"A\""), "");
}

// Of both caps.
double cap_area(const Scene& scene) {
    const MeshData& mesh = text_mesh(scene);
    double area = 0;
    for (const TriangleCorners& t : mesh.triangles) {
        const Vec3 a = mesh.position(t[0]), b = mesh.position(t[1]), c = mesh.position(t[2]);
        area += number::abs(cross(b - a, c - a).z) / 2;
    }
    return area;
}

struct TextBox {
    Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
};

// Of the triangles.
TextBox box_of(const Scene& scene) {
    const MeshData& mesh = text_mesh(scene);
    TextBox box;
    for (const TriangleCorners& t : mesh.triangles) {
        for (const std::uint32_t i : t) {
            const Vec3 p = mesh.position(i);
            box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
            box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
        }
    }
    return box;
}

void expect_box(const std::string& items, Vec3 low, Vec3 high) {
    const TextBox box = box_of(text_scene(items));
    constexpr double near = 1e-6;
    EXPECT_NEAR(box.low.x, low.x, near) << items;
    EXPECT_NEAR(box.low.y, low.y, near) << items;
    EXPECT_NEAR(box.low.z, low.z, near) << items;
    EXPECT_NEAR(box.high.x, high.x, near) << items;
    EXPECT_NEAR(box.high.y, high.y, near) << items;
    EXPECT_NEAR(box.high.z, high.z, near) << items;
}

TEST(PovRayText, WhatAnOddNumberOfEdgesSurroundsIsInside) {
    const double hole = 0.5 * 0.6 - 0.3 * 0.4;
    EXPECT_NEAR(cap_area(text_scene(R"(ttf "tiny.ttf" "a" 1, 0)")), 2 * hole, 1e-6);
    EXPECT_NEAR(cap_area(text_scene(R"(ttf "tiny.ttf" "h" 1, 0)")), 2 * hole, 1e-6) << "of the same turn";
    const double overlap = 0.4 * 0.5 + 0.4 * 0.5 - 2 * 0.2 * 0.3;
    EXPECT_NEAR(cap_area(text_scene(R"(ttf "tiny.ttf" "b" 1, 0)")), 2 * overlap, 1e-6);
    EXPECT_NEAR(cap_area(text_scene(R"(ttf "tiny.ttf" "c" 1, 0)")), 2 * overlap, 1e-6);
}

TEST(PovRayText, CurvesAreParabolas) {
    // Between its ends and below its tangents: two thirds of half the triangle's height.
    EXPECT_NEAR(cap_area(text_scene(R"(ttf "tiny.ttf" "i" 1, 0)")), 2 * (2.0 / 3) * 0.4 * 0.3, 1e-5);
}

TEST(PovRayText, StandsWherePovRayPutsIt) {
    expect_box(R"(ttf "tiny.ttf" "a" 2, 0)", {0, 0, 0}, {0.5, 0.6, 2});
    expect_box(R"(ttf "tiny.ttf" "a" -2, 0)", {0, 0, -2}, {0.5, 0.6, 0});
    expect_box(R"(ttf "tiny.ttf" "fa" 1, 0)", {0, 0, 0}, {1.28, 0.6, 1});
    expect_box(R"(ttf "tiny.ttf" "af" 1, 0)", {0, 0, 0}, {1.12, 0.6, 1});
    expect_box(R"(ttf "tiny.ttf" "ab" 1, 0)", {0, 0, 0}, {1.2, 0.7, 1});
    expect_box(R"(ttf "tiny.ttf" "a a" 1, 0)", {0, 0, 0}, {1.57, 0.6, 1});
    expect_box(R"(ttf "tiny.ttf" "aa" 1, <0.5, 0.25, 3>)", {0, 0, 0}, {1.7, 0.85, 1});
    expect_box(R"(ttf "tiny.ttf" "g" 1, 0)", {0.1, 0, 0}, {0.6, 0.7, 1});
    expect_box(R"(ttf "tiny.ttf" "kb" 1, 0)", {0, -0.1, 0}, {1.3, 0.7, 1});
    expect_box(R"(ttf "tiny.ttf" "Z" 1, 0)", {0, 0, 0}, {0.4, 0.7, 1});
}

TEST(PovRayText, ThicknessBelowZeroHasNoSides) {
    const MeshData thick = text_mesh(text_scene(R"(ttf "tiny.ttf" "d" 1, 0)"));
    EXPECT_EQ(thick.triangles.size(), 4u + 8u);
    EXPECT_EQ(text_mesh(text_scene(R"(ttf "tiny.ttf" "d" -1, 0)")).triangles.size(), 4u);
}

TEST(PovRayText, CharactersAreUtf8OrLatin1) {
    const double box = 2 * 0.6 * 0.7;
    EXPECT_NEAR(cap_area(text_scene("ttf \"tiny.ttf\" \"\xce\xb1\" 1, 0")), box, 1e-6);
    EXPECT_NEAR(cap_area(text_scene(R"(ttf "tiny.ttf" "\u03b1" 1, 0)")), box, 1e-6);
    const double round = cap_area(text_scene(R"(ttf "tiny.ttf" "e" 1, 0)"));
    EXPECT_EQ(cap_area(text_scene(R"(ttf "tiny.ttf" chr(233) 1, 0)")), round);
    EXPECT_EQ(cap_area(text_scene("ttf \"tiny.ttf\" \"\xc3\xa9\" 1, 0")), round);
}

TEST(PovRayText, HasTheExtentOfItsGlyphsBoxes) {
    const std::string ends =
        " #declare A = min_extent(T); #declare B = max_extent(T); sphere { A, 1 } sphere { B, 1 }";
    const auto expect_extent = [&](const std::string& characters, const std::string& items, Vec3 low,
                                   Vec3 high) {
        TextSources sources = fonts();
        const Scene scene = povray_scene(
            "#declare T = text { ttf \"tiny.ttf\" \"" + characters + "\" 1, 0 " + items + " }" + ends,
            &sources);
        const auto& spheres = scene.get<Sphere>();
        ASSERT_EQ(spheres.size(), 2u);
        for (const auto& [is, wanted] :
             {std::pair(spheres[0].center, low), std::pair(spheres[1].center, high)}) {
            EXPECT_NEAR(is.x, wanted.x, 1e-4);
            EXPECT_NEAR(is.y, wanted.y, 1e-4);
            EXPECT_NEAR(is.z, wanted.z, 1e-4);
        }
    };
    expect_extent("a   ", "", {0, 0, 0}, {1.27, 0.6, 1});
    expect_extent(" ", "", {0, 0, 0}, {0, 0, 1});
    expect_extent("g", "", {0, 0, 0}, {0.6, 0.7, 1});
    expect_extent("ab", "rotate 30*z rotate -30*z", {-0.3031, -0.5196, 0}, {1.5031, 1.2196, 1});
    expect_extent("", "", {-1e10, -1e10, -1e10}, {1e10, 1e10, 1e10});
}

TEST(PovRayText, FindsFontsAsIncludes) {
    EXPECT_EQ(text_scene(R"(ttf "own.ttf" "a" 1, 0)").meshes.size(), 1u);
    EXPECT_EQ(text_scene(R"(ttf "own" "a" 1, 0)").meshes.size(), 1u);
    EXPECT_EQ(text_scene(R"(ttf "tiny", "a", 1, 0)").meshes.size(), 1u);
    TextSources sources = fonts();
    const Scene twice =
        povray_scene(R"(text { ttf "tiny.ttf" "a" 1, 0 } text { ttf "tiny.ttf" "b" 1, x })", &sources);
    EXPECT_EQ(twice.files.size(), 2u) << "read once";
}

TEST(PovRayText, EqualTextsShareAMesh) {
    TextSources sources = fonts();
    const std::string a = "text { ttf \"tiny.ttf\" \"a\" 1, 0 translate x } ";
    const Scene scene = povray_scene(a + a +
                                         "text { ttf \"tiny.ttf\" \"a\" 2, 0 } text { ttf \"tiny.ttf\" \"a\" "
                                         "1, y } text { ttf \"own.ttf\" \"a\" 1, 0 }",
                                     &sources);
    EXPECT_EQ(scene.shapes.size(), 5u);
    EXPECT_EQ(scene.meshes.size(), 4u);
}

TEST(PovRayText, IsAnObjectLikeOthers) {
    const std::string declared = "#declare T = text { ttf \"tiny.ttf\" \"a\" 1, 0 }\n";
    TextSources sources = fonts();
    const Scene scene = povray_scene(
        declared + "object { T } text { T translate x no_shadow } union { object { T } sphere { 0, 1 } }",
        &sources);
    EXPECT_EQ(scene.shapes.size(), 4u);
    EXPECT_EQ(scene.meshes.size(), 1u);
    const Scene empty = povray_scene("text { ttf \"tiny.ttf\" \"\" 1, 0 } sphere { 0, 1 }", &sources);
    EXPECT_EQ(empty.shapes.size(), 1u);
}

TEST(PovRayText, MistakesAndBrokenFontsAreErrors) {
    const auto expect_said = [](const std::string& text, const std::string& wanted) {
        const std::string said = said_of_text(text);
        EXPECT_NE(said.find(wanted), std::string::npos) << text << "\n" << said;
    };
    expect_said(R"(text { ttf "none.ttf" "a" 1, 0 })", "2:12: error: 'none.ttf': no such file");
    expect_said(R"(text { ttf "scene.ttf" "a" 1, 0 })", "2:12: error: 'scene.ttf': expected a TrueType font");
    expect_said(R"(text { ttf "post.otf" "a" 1, 0 })", "found those of PostScript");
    expect_said(R"(text { ttf "short.ttf" "a" 1, 0 })", "2:12: error: 'short.ttf': the font");
    expect_said(R"(text { "tiny.ttf" "a" 1, 0 })", "expected `ttf`");
    expect_said(R"(text { ttf "tiny.ttf" 1, 0 })", "expected a string");
    expect_said(R"(text { internal 1 "a" 1, 0 pigment { rgb 1 } })", "`text` (with an internal font)");
    EXPECT_EQ(said_of_text(R"(difference { box { 0, 1 } text { ttf "tiny.ttf" "a" 1, 0 } })"), "");
    EXPECT_FALSE(read_povray(R"(text { ttf "tiny.ttf" "a" 1, 0 })"));
}

TEST(PovRayText, EveryPartOfAFontIsReadOrRefused) {
    const std::string whole = tiny_font();
    const std::string scene = "light_source { 9, 1 } text { ttf \"a.ttf\" \"abcdefghijkl\" 1, 0 }";
    for (std::size_t size = 0; size < whole.size(); size += 7) {
        TextSources cut({{"a.ttf", whole.substr(0, size)}});
        const Result<Scene> result = read_povray(scene, &cut);
        EXPECT_EQ(result.has_value(), !has_errors(result.diagnostics));
    }
    for (std::size_t at = 4; at < whole.size(); at += 3) {
        std::string changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ 0xff);
        TextSources sources({{"a.ttf", changed}});
        const Result<Scene> result = read_povray(scene, &sources);
        EXPECT_EQ(result.has_value(), !has_errors(result.diagnostics));
    }
}

TEST(PovRayText, IsLeftOutWithoutItsFont) {
    LoadOptions options;
    options.skip_unsupported = true;
    const SceneText texts[] = {
        {"a.pov", "light_source { 9, 1 } text { ttf \"none.ttf\" \"a\" 1, 0 rotate 3 } sphere { 0, 1 }",
         "povray"}};
    TextSources sources = fonts();
    const Result<Scene> result = load(texts, options, &sources);
    ASSERT_TRUE(result) << messages(result);
    EXPECT_EQ(result->shapes.size(), 1u);
    EXPECT_NE(messages(result).find("`text` (without its font)"), std::string::npos) << messages(result);
}

}  // namespace
}  // namespace glint::test
