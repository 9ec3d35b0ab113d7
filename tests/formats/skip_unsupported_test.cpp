// SPDX-License-Identifier: Apache-2.0
// LoadOptions::skip_unsupported: what glint does not render is left out, counted and named.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formats/load_text.h"
#include "glint/scene.h"

namespace glint::test {
namespace {

Result<Scene> load_rest(const std::string& text, const std::string& format, bool skips = true) {
    LoadOptions options;
    options.skip_unsupported = skips;
    const SceneText texts[] = {{"a", text, format}};
    return load(texts, options);
}

std::uint32_t left_out(const Result<Scene>& result) {
    std::uint32_t count = 0;
    for (const Diagnostic& d : result.diagnostics) count += d.left_out;
    return count;
}

TEST(SkipUnsupported, LeavesOutPovRaysShapes) {
    const std::string text =
        "light_source { 9, 1 }\n"
        "superellipsoid { <1, 1> pigment { rgb 1 } }\n"
        "#declare B = superellipsoid { <1, 1> }\n"
        "union { object { B } sphere { 0, 1 } blob { } }\n"
        "object { B translate x }\n"
        "torus { 0, .5 }\n"
        "light_source { 9, 1 cylinder point_at 0 radius 1 falloff 2 }\n";
    EXPECT_FALSE(load_rest(text, "povray", false));
    const Result<Scene> result = load_rest(text, "povray");
    ASSERT_TRUE(result) << messages(result);
    EXPECT_EQ(result->shapes.size(), 1u);
    EXPECT_EQ(result->lights.size(), 1u + 1u) << "and the ambient one";
    EXPECT_EQ(left_out(result), 6u);
    const std::string said = messages(result);
    EXPECT_NE(
        said.find(
            "2:1: warning: left out 3 objects that glint does not render: `superellipsoid` (a shape) of "
            "POV-Ray"),
        std::string::npos)
        << said;
    EXPECT_NE(said.find("4:38: warning: left out 1 object that glint does not render: `blob` (a shape)"),
              std::string::npos)
        << said;
}

TEST(SkipUnsupported, IsWhatErrorsSayThatItLeavesOut) {
    const auto can_skip = [](const Result<Scene>& result) {
        std::vector<bool> out;
        for (const Diagnostic& d : result.diagnostics) out.push_back(d.can_skip);
        return out;
    };
    const std::string text = "blob { }\nsphere { 0, 1 normal { bumps 1 } }\n", mistake = "sphere { 0 }\n";
    EXPECT_EQ(can_skip(load_rest(text + mistake, "povray", false)), (std::vector{true, false, false}));
    EXPECT_EQ(can_skip(load_rest(text, "povray")), (std::vector{false, false}));
}

TEST(SkipUnsupported, KeepsTheLookOfALight) {
    const std::string light =
        "light_source { <0, 3, 0>, 1 cylinder point_at z radius 1 falloff 2 looks_like { sphere { 0, 1 } } "
        "}\n";
    const Result<Scene> result = load_rest(light, "povray");
    ASSERT_TRUE(result) << messages(result);
    EXPECT_EQ(left_out(result), 1u) << "the light";
    ASSERT_EQ(result->shapes.size(), 1u);
    const Result<Scene> group = load_rest("union { " + light + " sphere { 0, 1 } translate x }\n", "povray");
    ASSERT_TRUE(group) << messages(group);
    EXPECT_EQ(left_out(group), 1u);
    EXPECT_EQ(group->shapes.size(), 2u);
    ASSERT_EQ(result->get<Sphere>().size(), 1u);
    EXPECT_EQ(result->get<Sphere>()[0].center, (Vec3{0, 3, 0}));
}

// Without these the objects are drawn.
TEST(SkipUnsupported, DrawsObjectsWithoutTheirCuts) {
    const std::string text =
        "camera { location -5*z look_at 0 }\ndisc { 0, y, 1 clipped_by { sphere { x, 1 } } }\n";
    EXPECT_FALSE(load_rest(text, "povray", false));
    const Result<Scene> result = load_rest(text, "povray");
    ASSERT_TRUE(result) << messages(result);
    EXPECT_EQ(result->shapes.size(), 1u);
    EXPECT_EQ(left_out(result), 0u);
    EXPECT_NE(
        messages(result).find("`clipped_by` (a part of a shape) of POV-Ray: the picture will differ; the "
                              "object is drawn whole"),
        std::string::npos)
        << messages(result);
}

// A camera of another kind leaves nothing to draw, and mistakes stay mistakes.
TEST(SkipUnsupported, KeepsOtherErrors) {
    EXPECT_FALSE(load_rest("camera { fisheye angle 180 }\nsphere { 0, 1 }", "povray"));
    EXPECT_FALSE(load_rest("blob { }\nsphere { 0 1", "povray"));
    EXPECT_FALSE(load_rest("Begin_Scene Resolution 4 4 Blub 3 End_Scene", "tachyon"));
}

TEST(SkipUnsupported, LeavesOutTachyonsObjects) {
    const std::string text =
        "Begin_Scene Resolution 4 4\n"
        "TexDef a Ambient 0 Diffuse 1 Specular 0 Opacity 1 Color 1 0 0 TexFunc 6 Center 0 0 0 Rotate 0 0 0 "
        "Scale 1 1 1\n"
        "Scape Res 3 3 Scale 1 1 Center 0 0 0 a\n"
        "Sphere Center 0 0 0 Rad 1 a\n"
        "ScalarVol Min 0 0 0 Max 1 1 1 Dim 2 2 2 File x a\n"
        "Scape Res 3 3 Scale 1 1 Center 0 0 0 a\n"
        "Start_ClipGroup NumPlanes 1 1 0 0 0 Sphere Center 3 0 0 Rad 1 a End_ClipGroup\n"
        "End_Scene\n";
    EXPECT_FALSE(load_rest(text, "tachyon", false));
    const Result<Scene> result = load_rest(text, "tachyon");
    ASSERT_TRUE(result) << messages(result);
    EXPECT_EQ(result->shapes.size(), 2u);
    EXPECT_EQ(left_out(result), 3u);
    const std::string said = messages(result);
    for (const char* part :
         {"3:1: warning: left out 2 objects that glint does not render: a random landscape (`Scape`) of "
          "Tachyon",
          "5:1: warning: left out 1 object that glint does not render: volumes (`ScalarVol`) of Tachyon",
          "warning: glint does not render the checker on a cylinder as a texture (`TexFunc 6`): the objects "
          "are "
          "drawn without",
          "warning: glint does not render clipping planes (`Start_ClipGroup`): the objects are drawn "
          "without them"})
        EXPECT_NE(said.find(part), std::string::npos) << part << "\n" << said;
}

// The names of files and textures can be words that begin an object.
TEST(SkipUnsupported, LeavesOutTachyonsObjectsWithAnyNames) {
    const std::string begin = "Begin_Scene Resolution 4 4\n",
                      end = "\nSphere Center 0 0 0 Rad 1 a End_Scene\n";
    const std::string body = " Texture Ambient 0 Diffuse 1 Specular 0 Opacity 1 Color 1 0 0 TexFunc 0";
    for (const std::string& object : {"TPolyFile Scale 1 1 1 Rot 0 0 0 Center 0 0 0 File plane" + body,
                                      "ScalarVol Min 0 0 0 Max 1 1 1 Dim 2 2 2 File box" + body,
                                      std::string("ScalarVol Min 0 0 0 Max 1 1 1 Dim 2 2 2 File light ring"),
                                      std::string("Scape Res 3 3 Scale 1 1 Center 0 0 0 camera")}) {
        const Result<Scene> result = load_rest(begin + object + end, "tachyon");
        ASSERT_TRUE(result) << object << messages(result);
        EXPECT_EQ(result->shapes.size(), 1u) << object;
        EXPECT_EQ(result->materials.size(), 1u) << object;
        EXPECT_EQ(left_out(result), 1u) << object;
    }
    const std::string checker =
        "Scape Res 3 3 Scale 1 1 Center 0 0 0 Texture Ambient 0 Diffuse 1 Specular 0 Opacity 1 Color 1 0 0 "
        "TexFunc 6 Center 0 0 0 Rotate 0 0 0 Scale 1 1 1";
    EXPECT_EQ(messages(load_rest(begin + checker + end, "tachyon")).find("checker"), std::string::npos);
    EXPECT_FALSE(load_rest(begin + "Scape Res 3 Scale 1 1 Center 0 0 0 a" + end, "tachyon"));
    EXPECT_FALSE(load_rest(begin + "Start_ClipGroup NumPlanes 2 1 0 0 0" + end, "tachyon"));
}

TEST(SkipUnsupported, CountsBeyondTheLastWarning) {
    std::string text;
    for (int i = 0; i < 200; ++i)
        text += "#warning \"w\"\n#version 3.7;\nsphere { " + std::to_string(i) + ", 1 normal { bumps } }\n";
    EXPECT_EQ(left_out(load_rest(text + "blob { } blob { threshold .5 }", "povray")), 2u);
}

}  // namespace
}  // namespace glint::test
