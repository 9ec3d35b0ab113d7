// What is said of mistakes in the books' formats.
#include "formats/mistakes.h"

namespace glint {
namespace {

class CgfsMistakes : public testing::TestWithParam<Mistake> {};
TEST_P(CgfsMistakes, AreNamedWhereTheyAre) { expect_messages(GetParam(), "a.cgfs"); }

#define L "light { type = ambient intensity = 1 }\n"
#define S "sphere { center = (0,0,3) radius = 1 color = (1,2,3) }\n"

INSTANTIATE_TEST_SUITE_P(
    Values, CgfsMistakes,
    testing::Values(Mistake{"word",
                            L "sphere { center = (0,0,3) radius = $abc color = (1,2,3) }",
                            {"expected a number, found 'abc'"}},
                    Mistake{"nan",
                            L "sphere { center = (0,$NaN,3) radius = 1 color = (1,2,3) }",
                            {"expected a number, found 'NaN'"}},
                    Mistake{"infinity",
                            L "sphere { center = (0,$-inf,3) radius = 1 color = (1,2,3) }",
                            {"expected a number, found '-inf'"}},
                    Mistake{"out_of_range",
                            L "sphere { center = (0,0,3) radius = $1e999 color = (1,2,3) }",
                            {"number out of range: '1e999' (doubles end at 1.8e308)"}},
                    Mistake{"malformed",
                            L "sphere { center = (0,0,3) radius = $1.2.3 color = (1,2,3) }",
                            {"expected a number, found '1.2.3'"}},
                    Mistake{"zero_radius",
                            L "sphere { center = (0,0,3) radius = $0 color = (1,2,3) }",
                            {"expected a number > 0 and at most 1e12, found '0'"}},
                    Mistake{"far_away",
                            L "sphere { center = (0,0,$1e13) radius = 1 color = (1,2,3) }",
                            {"expected a number from -1e12 to 1e12, found '1e13'"}},
                    Mistake{"mirror",
                            L "sphere { center = (0,0,3) radius = 1 color = (1,2,3) reflective = $1.5 }",
                            {"expected a number from 0 to 1, found '1.5'"}},
                    Mistake{"specular",
                            L "sphere { center = (0,0,3) radius = 1 color = (1,2,3) specular = $-0.5 }",
                            {"expected -1 (matte) or a number from 0 to 1e9, found '-0.5'"}},
                    Mistake{"two_numbers",
                            L "sphere { center = (0,0$) radius = 1 color = (1,2,3) }",
                            {"expected `,` and three numbers in all, found ')'"}},
                    Mistake{"four_numbers",
                            L "sphere { center = (0,0,0,$0) radius = 1 color = (1,2,3) }",
                            {"expected `)` after three numbers, found '0'"}},
                    Mistake{"no_brackets",
                            L "sphere { center = $0,0,3 radius = 1 color = (1,2,3) }",
                            {"expected `(` and three numbers, found '0'"}},
                    Mistake{"no_value",
                            L "sphere { center = (0,0,3) radius = $color = (1,2,3) }",
                            {"expected a number, found 'color'"}},
                    Mistake{"color",
                            L "sphere { center = (0,0,3) radius = 1 color = $(1,2,300) }",
                            {"a color's numbers go from 0 to 255; this one is drawn as it is written"}},
                    Mistake{"string",
                            L "sphere { center = (0,0,3) radius = $\"abc color = (1,2,3)\n color = (1,2,3) }",
                            {"expected a closing quote before the end of the line"}}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Blocks, CgfsMistakes,
    testing::Values(
        Mistake{"missing", L "$sphere { }", {"expected `center`, `radius`, `color` in the sphere"}},
        Mistake{"misspelled",
                L "$sphere { center = (0,0,3) $raduis = 1 color = (1,2,3) }",
                {"expected `radius` in the sphere",
                 "glint ignores 'raduis' of a sphere; did you mean `radius`?"}},
        Mistake{"ignored_once",
                L S "sphere { center = (0,0,3) radius = 1 color = (1,2,3) $foo = (1, (2)) }\n"
                    "sphere { center = (0,0,3) radius = 1 color = (1,2,3) foo = bar }\n",
                {"glint ignores 'foo' of a sphere"}},
        Mistake{"twice",
                L "sphere { center = (0,0,3) radius = 1 $radius = 2 color = (1,2,3) }",
                {"`radius` is given twice in one sphere: the last one holds"}},
        Mistake{
            "block_ignored", L S "$plane { normal = (0, { 1 }, 0) }\nplane { }", {"glint ignores 'plane'"}},
        Mistake{"block_misspelled", L S "$shpere { }", {"glint ignores 'shpere'; did you mean `sphere`?"}},
        Mistake{"setting_ignored",
                L S "$gamma = 2.2\n$size = 3 x 4\n",
                {"glint ignores 'gamma'", "glint ignores 'size'"}},
        Mistake{"no_end",
                L "sphere { center = (0,0,3) radius = 1 color = (1,2,3)\n$",
                {"expected `}`: the block that begins in line 2 has no end, found the end of the text"}},
        Mistake{"no_end_before_a_block",
                "sphere { center = (0,0,3) radius = 1\n\n$" L "$sphere { }",
                {"expected `}` before 'light': the block that begins in line 1 has no end",
                 "expected `center`, `radius`, `color` in the sphere"}},
        Mistake{"no_equals",
                L "sphere { center $(0,0,3) radius = 1 color = (1,2,3) }\n" S,
                {"expected `=`, found '('"}},
        Mistake{"no_key", L "sphere { $3 = 4 }\n" S, {"expected a key or `}`, found '3'"}},
        Mistake{"prose",
                "Once $upon a time\nthere $was a sphere\n",
                {"expected `{` or `=` after 'Once', found 'upon'",
                 "expected `{` or `=` after 'there', found 'was'"}},
        Mistake{"block_as_setting", L S "$sphere = 3\n", {"expected a block `sphere { ... }`"}},
        Mistake{
            "setting_as_block", L S "background ${ 1 }\n", {"expected `=` after 'background', found '{'"}},
        Mistake{"symbol", L S "$}\n", {"expected `sphere`, `light`, `camera` or `background`, found '}'"}}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Lights, CgfsMistakes,
    testing::Values(
        Mistake{"type",
                S "light { type = $pont intensity = 1 position = (0,0,0) }",
                {"expected `ambient`, `point` or `directional`, found 'pont'; did you mean `point`?"}},
        Mistake{"no_type", S "$light { intensity = 1 }", {"expected `type` in the light"}},
        Mistake{"no_position",
                S "$light { type = point intensity = 1 }",
                {"expected `position` in the point light"}},
        Mistake{"no_direction",
                S "$light { type = directional intensity = 1 }",
                {"expected `direction` in the directional light"}},
        Mistake{"zero_direction",
                S "light { type = directional intensity = 1 $direction = (0,0,0) }",
                {"expected a direction other than (0, 0, 0)"}},
        Mistake{"unused",
                S "light { type = ambient intensity = 1 $position = (0,0,0) $direction = (0,1,0) }",
                {"glint ignores the 'position' of an ambient light",
                 "glint ignores the 'direction' of an ambient light"}},
        Mistake{"color",
                S "light { type = ambient intensity = 1 $color = (1,2,3) }",
                {"glint ignores 'color' of a light"}}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Cameras, CgfsMistakes,
    testing::Values(
        Mistake{"singular",
                L S "$camera { rotation = ((1,0,1),(0,1,0),(1,0,1)) }",
                {"the camera's right (1, 0, 1), up (0, 1, 0) and forward (1, 0, 1) lie in one plane"}},
        Mistake{"two_rows",
                L S "camera { rotation = ((1,0,0),(0,1,0)$) }",
                {"expected `(` and three numbers, found ')'"}},
        Mistake{"second", L S "camera { }\n$camera { }", {"a second camera: the last one holds"}},
        Mistake{"second_background",
                L S "background = (1,1,1)\n$background = (2,2,2)",
                {"a second background: the last one holds"}},
        Mistake{"viewport",
                L S "viewport_size = 1 $y 1\n",
                {"expected `x` and the viewport's height, found 'y'"}}),
    test_name);

class EpflMistakes : public testing::TestWithParam<Mistake> {};
TEST_P(EpflMistakes, AreNamedWhereTheyAre) { expect_messages(GetParam(), "a.json"); }

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
        Mistake{"comma",
                "{ " CAMERA "\n $" MATERIALS ",\n " SPHERES " }",
                {"expected `,` or `}`, found '\"materials\"'"}},
        Mistake{"comma_in_list",
                WITH("\"spheres\": [ " SPHERE " $" SPHERE " ]"),
                {"expected `,` or `]`, found '{'"}},
        Mistake{"colon", WITH("\"spheres\" $[ " SPHERE " ]"), {"expected `:`, found '['"}},
        Mistake{"bracket",
                "{ " CAMERA ",\n " MATERIALS ",\n \"spheres\": [ " SPHERE "\n$}",
                {"expected `,` or `]`, found '}'"}},
        Mistake{"not_closed",
                "{ " CAMERA ",\n " MATERIALS ",\n " SPHERES "\n$",
                {"expected `}`: the scene that begins in line 1 has no end, found the end of the text"}},
        Mistake{"after_the_end", WITH(SPHERES) " $}", {"expected the end of the text, found '}'"}},
        Mistake{"list_expected",
                WITH("\"spheres\": $" SPHERE),
                {"expected a list of spheres `[ ... ]`, found '{'"}},
        Mistake{"object_expected",
                WITH("\"spheres\": [ $1, " SPHERE " ]"),
                {"expected a sphere `{ ... }`, found '1'"}},
        Mistake{"nothing", "$[ ]", {"expected a scene `{ ... }`, found none"}},
        Mistake{"number", "$42", {"expected a scene `{ ... }` or a list of scenes `[ ... ]`, found '42'"}},
        Mistake{"open_comment", WITH(SPHERES) " $/* more", {"expected `*/`: the comment has no end"}}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Code, EpflMistakes,
    testing::Values(
        Mistake{"map_of_scenes",
                "const a = [ " WITH(SPHERES) " ]\n$.map((s) => s);",
                {"expected the end of the text, found '.': glint reads data, not code"}},
        Mistake{"map_in_a_scene",
                WITH("spheres: []\n  $.map((x) => ({ center: [x, 0, 0] })), planes: []"),
                {"expected `,` or `}`, found '.': glint reads data, not code"}},
        Mistake{"operator_",
                WITH("spheres: [ { center: [0, 0, 1 $+ 1], radius: 1, material: 'clay' } ]"),
                {"expected `]` after three numbers, found '+': glint reads data, not code"}},
        Mistake{"call",
                WITH("spheres: [ { center: $vec3(0, 0, 1), radius: $Math.sqrt(2), material: 'clay' } ]"),
                {"expected `[` and three numbers, found 'vec3': glint reads data, not code",
                 "expected a number, found 'Math': glint reads data, not code"}},
        Mistake{"variable",
                WITH("spheres: [ { center: [0, 0, 1], radius: 1, material: $clay } ]"),
                {"expected a material's name in quotes, found 'clay'"}},
        Mistake{"spread",
                WITH("spheres: [ $...more ]"),
                {"expected a sphere `{ ... }`, found '.': glint reads data, not code"}}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Items, EpflMistakes,
    testing::Values(
        Mistake{"unknown_material",
                WITH("\"spheres\": [ { \"center\": [0,0,0], \"radius\": 1, \"material\": $\"caly\" } ]"),
                {"no material is called 'caly'; did you mean `clay`?"}},
        Mistake{"material_of_another_word",
                WITH("\"spheres\": [ { \"center\": [0,0,0], \"radius\": 1, \"material\": $\"gold\" } ]"),
                {"no material is called 'gold'"}},
        Mistake{"no_camera", "${ " MATERIALS ", " SPHERES " }", {"expected `camera` in the scene"}},
        Mistake{"camera_keys",
                "{ $\"camera\": { \"position\": [0,0,9] }, " MATERIALS ", " SPHERES " }",
                {"expected `target`, `up`, `fov` in the camera"}},
        Mistake{
            "fov_0",
            "{ \"camera\": { \"position\": [0,0,9], \"target\": [0,0,0], \"up\": [0,1,0], \"fov\": $0 } }",
            {"expected an angle between 0 and 180 degrees, found '0'"}},
        Mistake{
            "fov_180",
            "{ \"camera\": { \"position\": [0,0,9], \"target\": [0,0,0], \"up\": [0,1,0], \"fov\": $180 } }",
            {"expected an angle between 0 and 180 degrees, found '180'"}},
        Mistake{
            "on_its_target",
            "{ $\"camera\": { \"position\": [0,0,0], \"target\": [0,0,0], \"up\": [0,1,0], \"fov\": 60 } }",
            {"the camera looks at the place where it stands: the two must differ"}},
        Mistake{
            "up_along_the_view",
            "{ $\"camera\": { \"position\": [0,9,0], \"target\": [0,0,0], \"up\": [0,1,0], \"fov\": 60 } }",
            {"the camera's up (0, 1, 0) is along its view direction (0, -9, 0)"}},
        Mistake{
            "no_axis",
            WITH("\"cylinders\": [ { \"center\": [0,0,0], \"axis\": $[0,0,0], \"radius\": 1, \"height\": 1, "
                 "\"material\": \"clay\" } ]"),
            {"expected a direction other than [0, 0, 0]"}},
        Mistake{"no_normal",
                WITH("\"planes\": [ { \"center\": [0,0,0], \"normal\": $[0,0,0], \"material\": \"clay\" } ]"),
                {"expected a direction other than [0, 0, 0]"}},
        Mistake{"radius",
                WITH("\"spheres\": [ { \"center\": [0,0,0], \"radius\": $-1, \"material\": \"clay\" } ]"),
                {"expected a number > 0 and at most 1e12, found '-1'"}},
        Mistake{"mirror",
                "{ " CAMERA
                ", \"materials\": [ { \"name\": \"a\", \"color\": [1,1,1], \"ambient\": 0, \"diffuse\": 1,"
                " \"specular\": 0,\n \"shininess\": 1, \"mirror\": $2 } ], "
                "\"spheres\": [] }",
                {"expected a number from 0 to 1, found '2'"}},
        Mistake{"ignored", WITH("$\"meshes\": [], " SPHERES), {"glint ignores 'meshes' of a scene"}}),
    test_name);

TEST(Messages, SeveralMistakesAreFoundInOneRun) {
    const LoadResult result =
        load_text("sphere { center = (1, 2) radius = -1 }\nlight { type = lamp intensity = NaN }\nsphere {\n",
                  "a.cgfs");
    EXPECT_FALSE(result.scene);
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
    const LoadResult result = load_text(text, "a.cgfs");
    EXPECT_TRUE(result.scene);
    EXPECT_EQ(result.diagnostics.size(), 100u);
}

TEST(Messages, MistakesOfTheWholeSceneShowTheirLine) {
    const LoadResult result =
        load_text("{ camera: { position: [1,1,1],\n target: [1,1,1], up: [0,1,0], fov: 9 } }", "a.js");
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].source_line, "{ camera: { position: [1,1,1],");
    EXPECT_EQ(result.diagnostics[0].length, 6u);
}

}  // namespace
}  // namespace glint
