// SPDX-License-Identifier: Apache-2.0
// The messages for mistakes in the formats of the books and courses.
#include "formats/mistakes.h"

namespace glint::test {
namespace {

class CgfsMistakes : public testing::TestWithParam<BadText> {};
TEST_P(CgfsMistakes, AreReportedAtTheirPlace) { expect_messages(GetParam(), "a.cgfs"); }

#define L "light { type = ambient intensity = 1 }\n"
#define S "sphere { center = (0,0,3) radius = 1 color = (1,2,3) }\n"

INSTANTIATE_TEST_SUITE_P(
    Values, CgfsMistakes,
    testing::Values(BadText{"word",
                            L "sphere { center = (0,0,3) radius = $abc color = (1,2,3) }",
                            {"expected a number, found 'abc'"}},
                    BadText{"nan",
                            L "sphere { center = (0,$NaN,3) radius = 1 color = (1,2,3) }",
                            {"expected a number, found 'NaN'"}},
                    BadText{"infinity",
                            L "sphere { center = (0,$-inf,3) radius = 1 color = (1,2,3) }",
                            {"expected a number, found '-inf'"}},
                    BadText{"out_of_range",
                            L "sphere { center = (0,0,3) radius = $1e999 color = (1,2,3) }",
                            {"number out of range: '1e999' (doubles end at 1.8e308)"}},
                    BadText{"malformed",
                            L "sphere { center = (0,0,3) radius = $1.2.3 color = (1,2,3) }",
                            {"expected a number, found '1.2.3'"}},
                    BadText{"zero_radius",
                            L "sphere { center = (0,0,3) radius = $0 color = (1,2,3) }",
                            {"expected a number > 0 and at most 1e12, found '0'"}},
                    BadText{"far_away",
                            L "sphere { center = (0,0,$1e13) radius = 1 color = (1,2,3) }",
                            {"expected a number from -1e12 to 1e12, found '1e13'"}},
                    BadText{"mirror",
                            L "sphere { center = (0,0,3) radius = 1 color = (1,2,3) reflective = $1.5 }",
                            {"expected a number from 0 to 1, found '1.5'"}},
                    BadText{"specular",
                            L "sphere { center = (0,0,3) radius = 1 color = (1,2,3) specular = $-0.5 }",
                            {"expected -1 (matte) or a number from 0 to 1e9, found '-0.5'"}},
                    BadText{"two_numbers",
                            L "sphere { center = (0,0$) radius = 1 color = (1,2,3) }",
                            {"expected `,` and three numbers in all, found ')'"}},
                    BadText{"four_numbers",
                            L "sphere { center = (0,0,0,$0) radius = 1 color = (1,2,3) }",
                            {"expected `)` after three numbers, found '0'"}},
                    BadText{"no_brackets",
                            L "sphere { center = $0,0,3 radius = 1 color = (1,2,3) }",
                            {"expected `(` and three numbers, found '0'"}},
                    BadText{"no_value",
                            L "sphere { center = (0,0,3) radius = $color = (1,2,3) }",
                            {"expected a number, found 'color'"}},
                    BadText{"color",
                            L "sphere { center = (0,0,3) radius = 1 color = $(1,2,300) }",
                            {"a color's numbers go from 0 to 255; this one is used unchanged"}},
                    BadText{"string",
                            L "sphere { center = (0,0,3) radius = $\"abc color = (1,2,3)\n color = (1,2,3) }",
                            {"expected a closing quote before the end of the line"}}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Blocks, CgfsMistakes,
    testing::Values(
        BadText{"missing", L "$sphere { }", {"expected `center`, `radius`, `color` in the sphere"}},
        BadText{"misspelled",
                L "$sphere { center = (0,0,3) $raduis = 1 color = (1,2,3) }",
                {"expected `radius` in the sphere",
                 "glint ignores 'raduis' of a sphere; did you mean `radius`?"}},
        BadText{"ignored_once",
                L S "sphere { center = (0,0,3) radius = 1 color = (1,2,3) $foo = (1, (2)) }\n"
                    "sphere { center = (0,0,3) radius = 1 color = (1,2,3) foo = bar }\n",
                {"glint ignores 'foo' of a sphere"}},
        BadText{"twice",
                L "sphere { center = (0,0,3) radius = 1 $radius = 2 color = (1,2,3) }",
                {"`radius` is given twice in one sphere: the last one holds"}},
        BadText{
            "block_ignored", L S "$plane { normal = (0, { 1 }, 0) }\nplane { }", {"glint ignores 'plane'"}},
        BadText{"block_misspelled", L S "$shpere { }", {"glint ignores 'shpere'; did you mean `sphere`?"}},
        BadText{"setting_ignored",
                L S "$gamma = 2.2\n$size = 3 x 4\n",
                {"glint ignores 'gamma'", "glint ignores 'size'"}},
        BadText{"no_end",
                L "sphere { center = (0,0,3) radius = 1 color = (1,2,3)\n$",
                {"expected `}`: the block that begins in line 2 has no end, found the end of the text"}},
        BadText{"no_end_before_a_block",
                "sphere { center = (0,0,3) radius = 1\n\n$" L "$sphere { }",
                {"expected `}` before 'light': the block that begins in line 1 has no end",
                 "expected `center`, `radius`, `color` in the sphere"}},
        BadText{"no_equals",
                L "sphere { center $(0,0,3) radius = 1 color = (1,2,3) }\n" S,
                {"expected `=`, found '('"}},
        BadText{"no_key", L "sphere { $3 = 4 }\n" S, {"expected a key or `}`, found '3'"}},
        BadText{"prose",
                "Once $upon a time\nthere $was a sphere\n",
                {"expected `{` or `=` after 'Once', found 'upon'",
                 "expected `{` or `=` after 'there', found 'was'"}},
        BadText{"block_as_setting", L S "$sphere = 3\n", {"expected a block `sphere { ... }`"}},
        BadText{
            "setting_as_block", L S "background ${ 1 }\n", {"expected `=` after 'background', found '{'"}},
        BadText{"symbol", L S "$}\n", {"expected `sphere`, `light`, `camera` or `background`, found '}'"}}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Lights, CgfsMistakes,
    testing::Values(
        BadText{"type",
                S "light { type = $pont intensity = 1 position = (0,0,0) }",
                {"expected `ambient`, `point` or `directional`, found 'pont'; did you mean `point`?"}},
        BadText{"no_type", S "$light { intensity = 1 }", {"expected `type` in the light"}},
        BadText{"no_position",
                S "$light { type = point intensity = 1 }",
                {"expected `position` in the point light"}},
        BadText{"no_direction",
                S "$light { type = directional intensity = 1 }",
                {"expected `direction` in the directional light"}},
        BadText{"zero_direction",
                S "light { type = directional intensity = 1 $direction = (0,0,0) }",
                {"expected a direction other than (0, 0, 0)"}},
        BadText{"unused",
                S "light { type = ambient intensity = 1 $position = (0,0,0) $direction = (0,1,0) }",
                {"glint ignores the 'position' of an ambient light",
                 "glint ignores the 'direction' of an ambient light"}},
        BadText{"color",
                S "light { type = ambient intensity = 1 $color = (1,2,3) }",
                {"glint ignores 'color' of a light"}}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Cameras, CgfsMistakes,
    testing::Values(
        BadText{"singular",
                L S "$camera { rotation = ((1,0,1),(0,1,0),(1,0,1)) }",
                {"the camera's right (1, 0, 1), up (0, 1, 0) and forward (1, 0, 1) lie in one plane"}},
        BadText{"two_rows",
                L S "camera { rotation = ((1,0,0),(0,1,0)$) }",
                {"expected `(` and three numbers, found ')'"}},
        BadText{"second", L S "camera { }\n$camera { }", {"a second camera: the last one holds"}},
        BadText{"second_background",
                L S "background = (1,1,1)\n$background = (2,2,2)",
                {"a second background: the last one holds"}},
        BadText{"viewport",
                L S "viewport_size = 1 $y 1\n",
                {"expected `x` and the viewport's height, found 'y'"}}),
    test_name);

class EpflMistakes : public testing::TestWithParam<BadText> {};
TEST_P(EpflMistakes, AreReportedAtTheirPlace) { expect_messages(GetParam(), "a.json"); }

#define CAMERA "\"camera\": { \"position\": [0,0,9], \"target\": [0,0,0], \"up\": [0,1,0], \"fov\": 60 }"
#define MATERIAL                                                                                    \
    "{ \"name\": \"clay\", \"color\": [1,1,1], \"ambient\": 0.1, \"diffuse\": 1, \"specular\": 0, " \
    "\"shininess\": 1 }"
#define MATERIALS "\"materials\": [ " MATERIAL " ]"
#define SPHERE "{ \"center\": [0,0,0], \"radius\": 1, \"material\": \"clay\" }"
#define SPHERES "\"spheres\": [ " SPHERE " ]"
#define WITH(rest) "{ " CAMERA ",\n " MATERIALS ",\n " rest "\n}"

INSTANTIATE_TEST_SUITE_P(
    Syntax, EpflMistakes,
    testing::Values(
        BadText{"comma",
                "{ " CAMERA "\n $" MATERIALS ",\n " SPHERES " }",
                {"expected `,` or `}`, found '\"materials\"'"}},
        BadText{"comma_in_list",
                WITH("\"spheres\": [ " SPHERE " $" SPHERE " ]"),
                {"expected `,` or `]`, found '{'"}},
        BadText{"colon", WITH("\"spheres\" $[ " SPHERE " ]"), {"expected `:`, found '['"}},
        BadText{"bracket",
                "{ " CAMERA ",\n " MATERIALS ",\n \"spheres\": [ " SPHERE "\n$}",
                {"expected `,` or `]`, found '}'"}},
        BadText{"not_closed",
                "{ " CAMERA ",\n " MATERIALS ",\n " SPHERES "\n$",
                {"expected `}`: the scene that begins in line 1 has no end, found the end of the text"}},
        BadText{"after_the_end", WITH(SPHERES) " $}", {"expected the end of the text, found '}'"}},
        BadText{"list_expected",
                WITH("\"spheres\": $" SPHERE),
                {"expected a list of spheres `[ ... ]`, found '{'"}},
        BadText{"object_expected",
                WITH("\"spheres\": [ $1, " SPHERE " ]"),
                {"expected a sphere `{ ... }`, found '1'"}},
        BadText{"nothing", "$[ ]", {"expected a scene `{ ... }`, found none"}},
        BadText{"number", "$42", {"expected a scene `{ ... }` or a list of scenes `[ ... ]`, found '42'"}},
        BadText{"open_comment", WITH(SPHERES) " $/* more", {"expected `*/`: the comment has no end"}}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Code, EpflMistakes,
    testing::Values(
        BadText{"map_of_scenes",
                "const a = [ " WITH(SPHERES) " ]\n$.map((s) => s);",
                {"expected the end of the text, found '.': glint reads data, not code"}},
        BadText{"map_in_a_scene",
                WITH("spheres: []\n  $.map((x) => ({ center: [x, 0, 0] })), planes: []"),
                {"expected `,` or `}`, found '.': glint reads data, not code"}},
        BadText{"operator_",
                WITH("spheres: [ { center: [0, 0, 1 $+ 1], radius: 1, material: 'clay' } ]"),
                {"expected `]` after three numbers, found '+': glint reads data, not code"}},
        BadText{"call",
                WITH("spheres: [ { center: $vec3(0, 0, 1), radius: $Math.sqrt(2), material: 'clay' } ]"),
                {"expected `[` and three numbers, found 'vec3': glint reads data, not code",
                 "expected a number, found 'Math': glint reads data, not code"}},
        BadText{"variable",
                WITH("spheres: [ { center: [0, 0, 1], radius: 1, material: $clay } ]"),
                {"expected a material's name in quotes, found 'clay'"}},
        BadText{"spread",
                WITH("spheres: [ $...more ]"),
                {"expected a sphere `{ ... }`, found '.': glint reads data, not code"}}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Items, EpflMistakes,
    testing::Values(
        BadText{"unknown_material",
                WITH("\"spheres\": [ { \"center\": [0,0,0], \"radius\": 1, \"material\": $\"caly\" } ]"),
                {"no material is called 'caly'; did you mean `clay`?"}},
        BadText{"material_of_another_word",
                WITH("\"spheres\": [ { \"center\": [0,0,0], \"radius\": 1, \"material\": $\"gold\" } ]"),
                {"no material is called 'gold'"}},
        BadText{"no_camera", "${ " MATERIALS ", " SPHERES " }", {"expected `camera` in the scene"}},
        BadText{"camera_keys",
                "{ $\"camera\": { \"position\": [0,0,9] }, " MATERIALS ", " SPHERES " }",
                {"expected `target`, `up`, `fov` in the camera"}},
        BadText{
            "fov_0",
            "{ \"camera\": { \"position\": [0,0,9], \"target\": [0,0,0], \"up\": [0,1,0], \"fov\": $0 } }",
            {"expected an angle between 0 and 180 degrees, found '0'"}},
        BadText{
            "fov_180",
            "{ \"camera\": { \"position\": [0,0,9], \"target\": [0,0,0], \"up\": [0,1,0], \"fov\": $180 } }",
            {"expected an angle between 0 and 180 degrees, found '180'"}},
        BadText{
            "on_its_target",
            "{ $\"camera\": { \"position\": [0,0,0], \"target\": [0,0,0], \"up\": [0,1,0], \"fov\": 60 } }",
            {"the camera is at the point that it looks at: the two must differ"}},
        BadText{
            "up_along_the_view",
            "{ $\"camera\": { \"position\": [0,9,0], \"target\": [0,0,0], \"up\": [0,1,0], \"fov\": 60 } }",
            {"the camera's up (0, 1, 0) is along its view direction (0, -9, 0)"}},
        BadText{
            "no_axis",
            WITH("\"cylinders\": [ { \"center\": [0,0,0], \"axis\": $[0,0,0], \"radius\": 1, \"height\": 1, "
                 "\"material\": \"clay\" } ]"),
            {"expected a direction other than [0, 0, 0]"}},
        BadText{"no_normal",
                WITH("\"planes\": [ { \"center\": [0,0,0], \"normal\": $[0,0,0], \"material\": \"clay\" } ]"),
                {"expected a direction other than [0, 0, 0]"}},
        BadText{"radius",
                WITH("\"spheres\": [ { \"center\": [0,0,0], \"radius\": $-1, \"material\": \"clay\" } ]"),
                {"expected a number > 0 and at most 1e12, found '-1'"}},
        BadText{"mirror",
                "{ " CAMERA
                ", \"materials\": [ { \"name\": \"a\", \"color\": [1,1,1], \"ambient\": 0, \"diffuse\": 1,"
                " \"specular\": 0,\n \"shininess\": 1, \"mirror\": $2 } ], "
                "\"spheres\": [] }",
                {"expected a number from 0 to 1, found '2'"}},
        BadText{"ignored", WITH("$\"meshes\": [], " SPHERES), {"glint ignores 'meshes' of a scene"}}),
    test_name);

TEST(Messages, SeveralMistakesAreFoundInOneRun) {
    const Result<Scene> result =
        load_text("sphere { center = (1, 2) radius = -1 }\nlight { type = lamp intensity = NaN }\nsphere {\n",
                  "a.cgfs");
    EXPECT_FALSE(result);
    EXPECT_EQ(result.diagnostics.size(), 7u);
}

TEST(Messages, ReadingStopsAfterMaxErrors) {
    std::string text;
    for (int i = 0; i < 1000; ++i) text += "sphere { radius = x }\n";
    EXPECT_EQ(load_text(text, "a.cgfs").diagnostics.size(), 20u);
    LoadOptions options;
    options.max_errors = 3;
    EXPECT_EQ(load_text(text, "a.cgfs", options).diagnostics.size(), 3u);
    options.max_errors = 0;
    EXPECT_EQ(load_text(text, "a.cgfs", options).diagnostics.size(), 1u);
}

TEST(Messages, WarningsAreLimitedToo) {
    std::string text = L S;
    for (int i = 0; i < 1000; ++i) text += "key" + std::to_string(i) + " = 1\n";
    const Result<Scene> result = load_text(text, "a.cgfs");
    EXPECT_TRUE(result);
    EXPECT_EQ(result.diagnostics.size(), 100u);
}

TEST(Messages, MistakesOfTheWholeSceneShowTheirLine) {
    const Result<Scene> result =
        load_text("{ camera: { position: [1,1,1],\n target: [1,1,1], up: [0,1,0], fov: 9 } }", "a.js");
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].source_line, "{ camera: { position: [1,1,1],");
    EXPECT_EQ(result.diagnostics[0].length, 6u);
}

}  // namespace
}  // namespace glint::test
