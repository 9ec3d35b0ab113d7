// SPDX-License-Identifier: Apache-2.0
// CSC 473's .pov, key by key.
#include <cmath>

#include "formats/mistakes.h"
#include "math/transform.h"

namespace glint::test {
namespace {

#define CAMERA "camera { location <1, 2, 14> up <0, 1, 0> right <1.5, 0, 0> look_at <1, 2, 3> }\n"
#define LIGHT "light_source { <-100, 100, 100> color rgb <1.5, 1, 0.5> }\n"

Scene scene_of(const std::string& text) { return quiet_scene(text, "a.pov"); }

TEST(Csc473, ReadsTheCamera) {
    const Scene s = scene_of(CAMERA LIGHT "sphere { <0, 0, 0>, 2 }");
    EXPECT_EQ(s.profile, "csc473");
    EXPECT_EQ(s.camera.position, (Vec3{1, 2, 14}));
    ASSERT_TRUE(s.camera.frame);
    EXPECT_EQ(s.camera.frame->right, (Vec3{1.5, 0, 0}));
    EXPECT_EQ(s.camera.frame->up, (Vec3{0, 1, 0}));
    EXPECT_EQ(s.camera.frame->forward, (Vec3{0, 0, -1})) << "unit, right-handed";
    EXPECT_EQ(s.camera_place.line, 1u);
}

TEST(Csc473, TheCamerasKeysComeInAnyOrderAndHaveDefaults) {
    const Scene s = scene_of(LIGHT "camera { look_at <0,0,-2>, location <0,0,4> } sphere { <0,0,0> 2 }");
    EXPECT_EQ(s.camera.frame->right, (Vec3{1.33333, 0, 0}));
    EXPECT_EQ(s.camera.frame->up, (Vec3{0, 1, 0}));
    EXPECT_EQ(s.camera.frame->forward, (Vec3{0, 0, -1}));
}

TEST(Csc473, AddsAnAmbientLight) {
    const Scene s = scene_of(CAMERA LIGHT "light_source{<1,2,3>, rgbf <1,1,1,0>} sphere { <0,0,0>, 2 }");
    ASSERT_EQ(s.lights.size(), 3u);
    EXPECT_EQ(s.lights[0].kind, LightKind::ambient);
    EXPECT_EQ(s.lights[0].color, (Color{1, 1, 1}));
    EXPECT_EQ(s.lights[1].kind, LightKind::point);
    EXPECT_EQ(s.lights[1].position, (Vec3{-100, 100, 100}));
    EXPECT_EQ(s.lights[1].color, (Color{1.5, 1, 0.5}));
    EXPECT_EQ(s.lights[1].specular_color, (Color{1.5, 1, 0.5}));
    EXPECT_EQ(s.light_texts.place(1).line, 2u);
    EXPECT_EQ(s.lights[2].position, (Vec3{1, 2, 3}));
}

TEST(Csc473, ReadsPigmentAndFinish) {
    const Scene s = scene_of(CAMERA LIGHT
                             "sphere { <0, 0, 0>, 2\n"
                             "  pigment { color rgbf <1, 0.5, 0.25, 0.75> }\n"
                             "  finish { ambient 0.5 diffuse 0.25 specular 2 roughness 0.5 reflection 0.125 "
                             "refraction 1 ior 1.5 } }");
    ASSERT_EQ(s.materials.size(), 1u);
    const Material& m = s.materials[0];
    EXPECT_EQ(m.color, (Color{1, 0.5, 0.25}));
    EXPECT_EQ(m.ambient, (Color{0.5, 0.25, 0.125}));
    EXPECT_EQ(m.diffuse, (Color{0.25, 0.125, 0.0625}));
    EXPECT_EQ(m.specular, (Color{2, 1, 0.5}));
    EXPECT_EQ(m.shininess, 6) << "2 / roughness^2 - 2";
    EXPECT_EQ(m.mirror, 0.125);
    EXPECT_EQ(m.mirror_tint, m.color);
    EXPECT_EQ(m.transmission, 0.75);
    EXPECT_EQ(m.transmission_tint, m.color);
    EXPECT_EQ(m.ior, 1.5);
    EXPECT_EQ(s.material_texts.place(0).line, 3u);
}

TEST(Csc473, MissingAttributesAreBlackAndMatte) {
    const Scene s = scene_of(CAMERA LIGHT
                             "sphere { <0,0,0>, 2 } sphere { <0,0,0>, 1 pigment { rgb <1,1,1> } }"
                             "sphere { <0,0,0>, 1 finish { roughness 9 } }");
    EXPECT_EQ(s.materials[0].color, (Color{0, 0, 0}));
    EXPECT_EQ(s.materials[1].ambient, (Color{0, 0, 0}));
    EXPECT_EQ(s.materials[1].diffuse, (Color{0, 0, 0}));
    EXPECT_EQ(s.materials[1].shininess, 0) << "roughness 1";
    EXPECT_EQ(s.materials[1].mirror, 0);
    EXPECT_EQ(s.materials[1].transmission, 0);
    EXPECT_EQ(s.materials[1].ior, 1);
    EXPECT_EQ(s.materials[2].shininess, 0) << "no exponent below 0";
}

TEST(Csc473, EqualNeighboursShareAMaterial) {
    const std::string red = "sphere { <0,0,0>, 2 pigment { color rgb <1,0,0> } finish { ambient 1 } }\n";
    const std::string dull = "sphere { <0,0,0>, 2 pigment { color rgb <1,0,0> } }\n";
    const Scene s = scene_of(CAMERA LIGHT + red + red + dull + dull + red);
    ASSERT_EQ(s.materials.size(), 3u);
    EXPECT_EQ(s.shapes[1].material, 0u);
    EXPECT_EQ(s.shapes[2].material, 1u);
    EXPECT_EQ(s.shapes[3].material, 1u);
    EXPECT_EQ(s.shapes[4].material, 2u);
}

TEST(Csc473, ReadsShapes) {
    const Scene s = scene_of(CAMERA LIGHT
                             "sphere { <1, 2, 3>, 4 }\n"
                             "plane {<0, 2, 0>, -4 }\n"
                             "triangle { <0, 0, 0>, <1, 0, 0>, <0, 1, 0> }\n"
                             "box { <1, -1, 1>, <-1, 1, -1> } /* any two corners */\n");
    ASSERT_EQ(s.shapes.size(), 4u);
    EXPECT_EQ(s.get<Sphere>()[0].center, (Vec3{1, 2, 3}));
    EXPECT_EQ(s.get<Sphere>()[0].radius, 4);
    EXPECT_EQ(s.get<Plane>()[0].normal, (Vec3{0, 2, 0}));
    EXPECT_EQ(s.get<Plane>()[0].point, (Vec3{0, -2, 0})) << "n.p = d with n as written";
    EXPECT_EQ(s.get<Triangle>()[0].vertices[1], (Vec3{1, 0, 0}));
    EXPECT_EQ(s.get<Box>()[0].min, (Vec3{-1, -1, -1}));
    EXPECT_EQ(s.get<Box>()[0].max, (Vec3{1, 1, 1}));
    EXPECT_EQ(s.shape_texts.place(3).line, 6u);
}

TEST(Csc473, ReadsConesAndReportsThatTheyAreNotRendered) {
    const Result<Scene> result = load_text(CAMERA LIGHT "cone { <0, 0, 1>, 2, <0, 0, -3>, 0 }", "a.pov");
    ASSERT_TRUE(result);
    const Cone& c = result->get<Cone>().at(0);
    EXPECT_EQ(c.from, (Vec3{0, 0, 1}));
    EXPECT_EQ(c.to, (Vec3{0, 0, -3}));
    EXPECT_EQ(c.from_radius, 2);
    EXPECT_EQ(c.to_radius, 0);
    EXPECT_TRUE(c.caps);
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].line, 3u);
    LoadOptions options;
    options.settings = {{"cones", "true"}};
    EXPECT_EQ(messages(load_text(CAMERA LIGHT "cone { <0, 0, 1>, 2, <0, 0, -3>, 0 }", "a.pov", options)), "");
}

void expect_near(Vec3 a, Vec3 b) {
    EXPECT_NEAR(a.x, b.x, 1e-14);
    EXPECT_NEAR(a.y, b.y, 1e-14);
    EXPECT_NEAR(a.z, b.z, 1e-14);
}

Vec3 moved(const std::string& maps, Vec3 p) {
    const Scene s = scene_of(CAMERA LIGHT "sphere { <0,0,0>, 1 " + maps + " }");
    return s.shapes[0].transform == k_none ? p : transform_point(s.transforms[s.shapes[0].transform], p);
}

TEST(Csc473, MapsAreAppliedInTheOrderWritten) {
    EXPECT_EQ(moved("", {1, 2, 3}), (Vec3{1, 2, 3}));
    expect_near(moved("translate <1, 2, 3>", {1, 1, 1}), {2, 3, 4});
    expect_near(moved("scale <2, 3, 4> translate <1, 0, 0>", {1, 1, 1}), {3, 3, 4});
    expect_near(moved("translate <1, 0, 0> scale <2, 3, 4>", {1, 1, 1}), {4, 3, 4});
    expect_near(moved("scale 2", {1, 1, 1}), {2, 2, 2});
    expect_near(moved("rotate <90, 0, 0>", {0, 1, 0}), {0, 0, 1});
    expect_near(moved("rotate <0, 90, 0>", {0, 0, 1}), {1, 0, 0});
    expect_near(moved("rotate <0, 0, 90>", {1, 0, 0}), {0, 1, 0});
    expect_near(moved("rotate <90, 90, 0>", {0, 1, 0}), {1, 0, 0});
    expect_near(
        moved("pigment { color rgb <1,1,1> } rotate <90, 0, 0> finish { ambient 1 } translate <0, 0, 5>",
              {0, 1, 0}),
        {0, 0, 6});
}

class Csc473Mistakes : public testing::TestWithParam<BadText> {};
TEST_P(Csc473Mistakes, AreReportedAtTheirPlace) { expect_messages(GetParam(), "a.pov", "csc473"); }

#define CL CAMERA LIGHT
#define BLOCKS "`camera`, `light_source`, `sphere`, `plane`, `triangle`, `box` or `cone`"
#define OF_POVRAY " is of POV-Ray's own language; of it glint reads what CSC 473 uses: expected "
#define DIRECTIVE \
    " is of POV-Ray's own language, which is left-handed and larger; of it glint reads what CSC 473 uses"
#define ATTRIBUTES "`pigment`, `finish`, `translate`, `rotate`, `scale` or `}`"
#define FINISH "`ambient`, `diffuse`, `specular`, `roughness`, `reflection`, `refraction`, `ior` or `}`"

INSTANTIATE_TEST_SUITE_P(
    PovRay, Csc473Mistakes,
    testing::Values(
        BadText{"declare", CL "$#declare R = 2;\nsphere { <0,0,0>, R }", {"`#declare`" DIRECTIVE}},
        BadText{"include", "$#include \"colors.inc\"\ncamera { location <0,0,0> }", {"`#include`" DIRECTIVE}},
        BadText{"macro", CL "$#macro m()\n#end", {"`#macro`" DIRECTIVE}},
        BadText{"version", "$#version 3.7;", {"`#version`" DIRECTIVE}},
        BadText{"hash", CL "$# sphere", {"expected " BLOCKS ", found '#'"}},
        BadText{"settings",
                "$global_settings { assumed_gamma 1 }\n" CL,
                {"`global_settings` (a setting of a whole scene)" OF_POVRAY BLOCKS}},
        BadText{"union_of",
                CL "$union { sphere { <0,0,0>, 1 } box { <0,0,0>, <1,1,1> } }",
                {"`union` (a solid made of others)" OF_POVRAY BLOCKS}},
        BadText{"two_solids",
                CL "$difference { } $intersection { }",
                {"`difference` (a solid made of others)" OF_POVRAY BLOCKS,
                 "`intersection` (a solid made of others)" OF_POVRAY BLOCKS}},
        BadText{"cylinder",
                CL "$cylinder { <0,0,0>, <0,1,0>, 1 }\nsphere { <0,0,0>, 1 }",
                {"`cylinder` (a shape)" OF_POVRAY BLOCKS}},
        BadText{"texture",
                CL "sphere { <0,0,0>, 1 $texture { pigment { color rgb <1,0,0> } } }",
                {"`texture` (a material)" OF_POVRAY ATTRIBUTES}},
        BadText{"matrix",
                CL "sphere { <0,0,0>, 1 $matrix <1,0,0,0,1,0,0,0,1,0,0,0> }",
                {"`matrix` (a map)" OF_POVRAY ATTRIBUTES}},
        BadText{"checker",
                CL "sphere { <0,0,0>, 1 pigment { $checker color rgb <1,1,1> } finish { } }",
                {"`checker` (a pattern)" OF_POVRAY "`rgb` or `rgbf`"}},
        BadText{"colour",
                CL "sphere { <0,0,0>, 1 pigment { color $rgbt <1,1,1,1> } }",
                {"`rgbt` (a way to write a color)" OF_POVRAY "`rgb` or `rgbf`"}},
        BadText{"phong",
                CL "sphere { <0,0,0>, 1 finish { ambient 1 $phong 1 } }",
                {"`phong` (a property of a finish)" OF_POVRAY FINISH}},
        BadText{"spotlight",
                CAMERA "light_source { <0,0,0> color rgb <1,1,1> $spotlight }\nsphere { <0,0,0>, 1 }",
                {"`spotlight` (a kind of light)" OF_POVRAY "`}` after the light's color"}},
        BadText{"angle",
                "camera { location <0,0,5> $angle 40 }\n" LIGHT "sphere { <0,0,0>, 1 }",
                {"`angle` (a property of a camera)" OF_POVRAY "`location`, `up`, `right`, `look_at` or `}`"}},
        BadText{"vector_of_a_number",
                CL "sphere { $0, 1 }",
                {"expected `<` and three numbers, found '0': names and single numbers for vectors are of "
                 "POV-Ray's own language"}},
        BadText{"arithmetic",
                CL "sphere { <0, 1$*2, 0>, 1 }",
                {"expected `,` and three numbers in all, found '*'"}}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Blocks, Csc473Mistakes,
    testing::Values(
        BadText{"empty", "$", {"expected " BLOCKS ", found the end of the text"}},
        BadText{"misspelt",
                CL "$spere { <0,0,0>, 1 }",
                {"expected " BLOCKS ", found 'spere'; did you mean `sphere`?"}},
        BadText{"outside", CL "$rgb <1, 2, 3> sphere { <0,0,0>, 1 }", {"expected " BLOCKS ", found 'rgb'"}},
        BadText{"closed_twice", CL "sphere { <0,0,0>, 1 } $}", {"expected " BLOCKS ", found '}'"}},
        BadText{"no_brace", CL "sphere $<0,0,0>, 1", {"expected `{`, found '<'"}},
        BadText{
            "not_closed", CL "sphere { <0,0,0>, 1$", {"expected " ATTRIBUTES ", found the end of the text"}},
        BadText{"attribute",
                CL "sphere { <0,0,0>, 1 $pigmnt { color rgb <1,1,1> } } sphere { <0,0,0>, 1 }",
                {"expected " ATTRIBUTES ", found 'pigmnt'; did you mean `pigment`?"}},
        BadText{"twice",
                CL "sphere { <0,0,0>, 1 finish { ambient 1 } $finish { diffuse 1 $diffuse 2 } }",
                {"`finish` is given twice in one sphere: the last one holds",
                 "`diffuse` is given twice in one finish: the last one holds"}},
        BadText{
            "two_cameras", CL "$" CAMERA "sphere { <0,0,0>, 1 }", {"a second camera: the last one holds"}},
        BadText{"camera_at_its_target",
                "$camera { location <1,1,1> look_at <1,1,1> } sphere { <0,0,0>, 1 }",
                {"expected a camera that looks somewhere, found `look_at` at its location"}},
        BadText{"flat_camera",
                "$camera { location <0,0,1> look_at <0,0,0> up <1,0,0> right <1,0,0> }"
                "sphere { <0,0,0>, 1 }",
                {"the camera's right (1, 0, 0), up (1, 0, 0) and forward (0, 0, -1) lie in one plane"}}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Values, Csc473Mistakes,
    testing::Values(
        BadText{
            "radius", CL "sphere { <0,0,0>, $-1 }", {"expected a number > 0 and at most 1e12, found '-1'"}},
        BadText{
            "two_numbers", CL "sphere { <0,0$>, 1 }", {"expected `,` and three numbers in all, found '>'"}},
        BadText{"four_of_rgb",
                CL "sphere { <0,0,0>, 1 pigment { color rgb <1,0,0$,0.5> } translate <1,0,0> }",
                {"expected `>` after three numbers, found ','"}},
        BadText{"three_of_rgbf",
                CL "sphere { <0,0,0>, 1 pigment { color rgbf <1,0,0$> } }",
                {"three numbers of four: the filter is 0"}},
        BadText{"two_of_rgbf",
                CL "sphere { <0,0,0>, 1 pigment { color rgbf <1,0$> } }",
                {"expected `,` and four numbers in all, found '>'"}},
        BadText{"filter",
                CL "sphere { <0,0,0>, 1 pigment { color rgbf <1,0,0,$2> } }",
                {"expected a number from 0 to 1, found '2'"}},
        BadText{"name_of_a_colour",
                CL "sphere { <0,0,0>, 1 pigment { color $White } }",
                {"expected `rgb` or `rgbf`, found 'White'"}},
        BadText{"no_number",
                CL "sphere { <0,0,0>, 1 finish { ambient $diffuse 1 } }",
                {"expected a number, found 'diffuse'"}},
        BadText{"reflection",
                CL "sphere { <0,0,0>, 1 finish { reflection $1.5 } }",
                {"expected a number from 0 to 1, found '1.5'"}},
        BadText{"roughness",
                CL "sphere { <0,0,0>, 1 finish { roughness $0 } }",
                {"expected a number > 0 and at most 1e6, found '0'"}},
        BadText{"ior",
                CL "sphere { <0,0,0>, 1 finish { ior $0 } }",
                {"expected a number > 0 and at most 1e6, found '0'"}},
        BadText{
            "refraction_without_filter",
            CL "sphere { <0,0,0>, 1 pigment { color rgb <1,1,1> } finish { $refraction 1 ior 1.3 } }\n"
               "sphere { <0,0,0>, 1 finish { refraction 1 } }",
            {"glint ignores `refraction`, as CSC 473's own program does: what passes through a surface is "
             "the fourth number of its `rgbf`"}},
        BadText{
            "refraction_without_ior",
            CL "sphere { <0,0,0>, 1 pigment { color rgbf <1,1,1,0.9> } finish { $refraction 1 } }\n"
               "sphere { <0,0,0>, 1 pigment { color rgbf <1,1,1,0.9> } finish { refraction 1 ior 1.5 } }\n"
               "sphere { <0,0,0>, 1 pigment { color rgbf <1,1,1,0.9> } }",
            {"`refraction` without an `ior` other than 1, which is that of air: rays go straight through; "
             "expected, for example, `ior 1.33` (water) or `ior 1.5` (glass)"}},
        BadText{"no_scale",
                CL "sphere { <0,0,0>, 1 $scale <1, 0, 1> }",
                {"expected a scale without 0, which would leave nothing of the shape"}},
        BadText{"flattened",
                CL "$sphere { <0,0,0>, 1 scale <1e-12, 1, 1> rotate <0, 0, 45> }",
                {"transform 1 flattens what it transforms: it has no inverse"}},
        BadText{"far",
                CL "$sphere { <0,0,0>, 1 scale 1e9 scale 1e9 }",
                {"transform 1: expected numbers from -1e12 to 1e12"}},
        BadText{"normal", CL "plane { $<0,0,0>, 1 }", {"expected a normal other than <0, 0, 0>"}},
        BadText{"cone_without_radius",
                CL "$cone { <0,0,0>, 0, <0,1,0>, 0 }",
                {"cone 1: expected a radius > 0 at one end at least, found (0, 0)"}}),
    test_name);

}  // namespace
}  // namespace glint::test
