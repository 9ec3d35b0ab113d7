// SPDX-License-Identifier: Apache-2.0
// What POV-Ray accepts in other places or spellings than its documentation has.
#include "formats/povray_text.h"

namespace glint::test {
namespace {

const std::string k_red = "pigment { rgb <1, 0, 0> }";

// A value without `;` whose last token is that of a macro.
TEST(PovRaySpellings, LocalsAreThoseOfTheMacroThatDeclaresThem) {
    const Scene scene = povray_scene(
        "#macro Up(A) transform { translate A*y } #end #macro Twice(A) 2*A; #end\n"
        "#macro Ball(A) #local M = Up(A) #local N = Twice(A) #if (N > 1) sphere { 0, N transform M } #end "
        "#end Ball(3)");
    ASSERT_EQ(scene.get<Sphere>().size(), 1u);
    EXPECT_EQ(scene.get<Sphere>()[0].center.y, 3);
    EXPECT_EQ(scene.get<Sphere>()[0].radius, 6);
}

TEST(PovRaySpellings, DeclareNeedsNoHash) {
    EXPECT_EQ(povray_scene("declare R = 3;\nsphere { 0, R }").get<Sphere>().at(0).radius, 3);
}

TEST(PovRaySpellings, ATextureMayBeAPigment) {
    const Scene s =
        povray_scene("#declare P = " + k_red + "\nsphere { 0, 1 texture { P finish { diffuse 1 } } }");
    EXPECT_EQ(s.materials.at(s.shapes.at(0).material).diffuse, (Color{1, 0, 0}));
}

// The factors, as POV-Ray has them (measured).
TEST(PovRaySpellings, AlbedoIsOfAllLightInPlaceOfTheBrightest) {
    const auto look = [](const std::string& finish) {
        const Scene s = povray_scene("sphere { 0, 1 " + k_red + " finish { " + finish + " } }");
        return s.materials.at(s.shapes.at(0).material);
    };
    EXPECT_EQ(look("diffuse albedo .5").diffuse.r, 0.5);
    EXPECT_EQ(look("diffuse albedo .25 brilliance 3").diffuse.r, 0.5);
    EXPECT_EQ(look("phong albedo .25 phong_size 5").phong.r, 0.75);
    EXPECT_EQ(look("phong albedo .25 phong_size 5 phong .5").phong.r, 1.5);
    EXPECT_EQ(look("phong .25 phong_size 5").phong.r, 0.25);
    EXPECT_NEAR(look("specular albedo .5 roughness .5").specular.r, 1.0 / 3, k_pov_near);
    EXPECT_NEAR(look("specular albedo .25 roughness .05").specular.r, 0.25 * 22 / (8 - 4.0 / 1024),
                k_pov_near);
    // A finish that is named has its numbers; the factor is that of its own block.
    const std::string named = "#declare F = finish { brilliance 3 diffuse albedo .25 }\n";
    const auto copied = [&](const std::string& change) {
        return povray_scene(named + "sphere { 0, 1 " + k_red + " finish { F " + change + " } }")
            .materials.at(0)
            .diffuse.r;
    };
    EXPECT_EQ(copied(""), 0.5);
    EXPECT_EQ(copied("diffuse .25"), 0.25);
    EXPECT_EQ(copied("brilliance 1"), 0.5);
}

TEST(PovRaySpellings, OnlyAlbedoIsBeforeANumberOfAFinish) {
    for (const char* word : {"Kd", "\"x\"", ";", "sphere"}) {
        const Result<Scene> result =
            read_povray("sphere { 0, 1 finish { diffuse " + std::string(word) + " 0.4 } }");
        EXPECT_FALSE(result) << word;
        EXPECT_NE(messages(result).find("expected a number"), std::string::npos) << messages(result);
    }
}

TEST(PovRaySpellings, SrgbIsInTheNumbersOfAssumedGamma) {
    const auto red = [](const std::string& gamma) {
        return povray_scene("global_settings { assumed_gamma " + gamma +
                            " }\nsphere { 0, 1 pigment { srgb <.5, 0, 0> } }")
            .materials.at(0)
            .color.r;
    };
    const double linear = red("1");
    EXPECT_NEAR(linear, 0.21404114048, 1e-9);
    EXPECT_NEAR(red("2") * red("2"), linear, 1e-9);
    EXPECT_EQ(red("srgb"), 0.5);
}

TEST(PovRaySpellings, TheWordOfAShapeTakesADeclaredOne) {
    EXPECT_EQ(
        povray_scene("#declare B = sphere { 0, 1 }\nsphere { B translate 2*x }").get<Sphere>().at(0).center,
        (Vec3{2, 0, 0}));
    const std::string mesh = "mesh { triangle { 0, x, y } }",
                      mesh2 = "mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 2> } }";
    for (const std::string& text : {mesh, mesh2}) {
        const std::string word = text.substr(0, text.find(' '));
        EXPECT_EQ(povray_scene("#declare M = " + text + "\n" + word + " { M " + k_red + " }").shapes.size(),
                  povray_scene(text).shapes.size());
    }
}

TEST(PovRaySpellings, AFogTakesColorTwice) {
    const Scene s = povray_scene("fog { distance 9 color color rgb <1, .5, 0> }\nsphere { 0, 1 }");
    ASSERT_TRUE(s.fog);
    EXPECT_EQ(s.fog->color, (Color{1, .5, 0}));
}

// `ior` in a finish is that of the interior; an interior { } counts more.
TEST(PovRaySpellings, RefractionInAFinish) {
    const auto ior = [](const std::string& items) {
        const Scene s = povray_scene("sphere { 0, 1 pigment { rgbt 1 } " + items + " }");
        return s.materials.at(s.shapes.at(0).material).ior;
    };
    EXPECT_EQ(ior("finish { refraction 1 ior 1.5 }"), ior("interior { ior 1.5 }"));
    EXPECT_EQ(ior("finish { ior 1.25 } interior { ior 1.5 }"), ior("interior { ior 1.5 }"));
    for (const std::string finish : {"refraction 0 ior 1.5", "refraction 1.2 ior 1.5", "refraction .5"}) {
        const std::string rest = " finish { " + finish + " } }";
        EXPECT_EQ(messages(read_povray("sphere { 0, 1" + rest)), "") << "opaque";
        EXPECT_NE(messages(read_povray("sphere { 0, 1 pigment { rgbt .5 }" + rest))
                      .find("`refraction` (of a finish, other than 1)"),
                  std::string::npos)
            << finish;
    }
}

TEST(PovRaySpellings, LinesMayEndWithCarriageReturnAlone) {
    EXPECT_EQ(
        povray_scene("// a comment\rsphere { 0, 2 } // another\rsphere { 0, 3 }\r").get<Sphere>().size(), 2u);
}

TEST(PovRaySpellings, DivisionByZeroIsAGreatNumber) {
    const Scene s = povray_scene(
        "#declare A = 1/0; #declare B = -1/0; #declare C = 0/0; #declare V = <1, 2, 3>/<0, 1, 2>;\n"
        "#if (A > 1e100 & B > 1e100 & C > 1e100 & V.x > 1e100) sphere { 0, V.y } #end");
    ASSERT_EQ(s.get<Sphere>().size(), 1u);
    EXPECT_EQ(s.get<Sphere>()[0].radius, 2);
}

TEST(PovRaySpellings, CallersDeclareNumbers) {
    LoadOptions options;
    options.declared = {{"Big", 3}, {"clock", .5}, {"sphere", 4}};
    const SceneText text{
        "a.pov", "#ifdef (Big) sphere { 0, Big + clock } #end sphere { 0, 1 + clock_on + frame_number }",
        "povray"};
    const auto scene = load({&text, 1}, options);
    ASSERT_TRUE(scene) << to_string(scene);
    ASSERT_EQ(scene->get<Sphere>().size(), 2u);
    EXPECT_EQ(scene->get<Sphere>()[0].radius, 3.5);
    EXPECT_EQ(scene->get<Sphere>()[1].radius, 2);
}

// A string of some length has the number of a word.
TEST(PovRaySpellings, AShapeDoesNotBeginWithAString) {
    for (const std::string shape : {"sphere", "mesh", "mesh2", "polygon", "triangle", "union"}) {
        const Result<Scene> result =
            read_povray("#declare A = " + shape + " { \"" + std::string(1200, 'a') + "\" }\n");
        EXPECT_FALSE(result) << shape;
        EXPECT_NE(messages(result).find("expected"), std::string::npos) << messages(result);
    }
}

// Nor is it a name.
TEST(PovRaySpellings, UndefTakesANameOnly) {
    for (const std::string& name : {std::string("3"), '"' + std::string(1200, 'a') + '"',
                                    std::string("sphere"), std::string("#while"), std::string()}) {
        const Result<Scene> result = read_povray("#undef " + name + "\nsphere { 0, 1 }");
        EXPECT_FALSE(result) << name;
        EXPECT_NE(messages(result).find("expected a name after `#undef`"), std::string::npos)
            << messages(result);
    }
    EXPECT_EQ(
        povray_scene("#declare R = 3;\n#undef R\n#undef T\n#ifndef (R) sphere { 0, 1 } #end").shapes.size(),
        1u);
}

}  // namespace
}  // namespace glint::test
