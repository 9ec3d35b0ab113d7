// SPDX-License-Identifier: Apache-2.0
// The messages for mistakes in .glint.
#include "formats/mistakes.h"

namespace glint::test {
namespace {

class GlintMistakes : public testing::TestWithParam<BadText> {};
TEST_P(GlintMistakes, AreReportedAtTheirPlace) { expect_messages(GetParam(), "a.glint"); }

#define CAMERA "camera { position = (0, 0, 5) }\n"
#define LIGHT "light { position = (0, 9, 5) }\n"
#define BALL "sphere { center = (0, 0, 0)  radius = 1 "
#define COLOR_WARNING \
    "colors go from 0 to 1, and this one is used unchanged; for 0 to 255 write rgb255(r, g, b)"

INSTANTIATE_TEST_SUITE_P(
    Habits, GlintMistakes,
    testing::Values(
        BadText{
            "specular_is_no_exponent",
            "material a { specular = $50 }",
            {"expected a number from 0 to 1, found '50': `specular` is a coefficient; the exponent is called "
             "shininess"}},
        BadText{"matte", "material a { specular = $-1 }", {"expected a number from 0 to 1, found '-1'"}},
        BadText{"bytes", CAMERA LIGHT BALL "color = $(200, 160, 40) }", {COLOR_WARNING}},
        BadText{"bytes_of_the_background", CAMERA LIGHT BALL "}\nbackground = $(0, 0, 255)", {COLOR_WARNING}},
        BadText{"bytes_of_a_light",
                CAMERA BALL "} light { position = (1, 9, 1)  color = $(255, 255, 255) }",
                {COLOR_WARNING}},
        BadText{"bare_fov",
                "camera { $fov = 60 }",
                {"a camera has no 'fov': write `fov_x` (across the picture's width) or `fov_y` (across its "
                 "height), "
                 "in degrees"}},
        BadText{"target", "camera { $target = (0, 0, 0) }", {"a camera has no 'target': write `look_at`"}},
        BadText{"reflective",
                CAMERA BALL "$reflective = 0.2 }",
                {"a sphere has no 'reflective': write `mirror`"}},
        BadText{"phong_size",
                "material a { $phong_size = 9 }",
                {"a material has no 'phong_size': write `shininess`"}},
        BadText{"centre",
                CAMERA "sphere { $centre = (0, 0, 0)  center = (0, 0, 0)  radius = 1 }",
                {"a sphere has no 'centre': write `center`"}},
        BadText{"bare_hexadecimal",
                "material a { color = #cc2222 }\n$$sphere { center = (0, 0, 0)  radius = 1 }",
                {"expected a color, found 'sphere': `#` begins a comment; write \"#rrggbb\" in quotes",
                 "expected `}` before 'sphere': the block that begins in line 1 has no end"}},
        BadText{"two_radii",
                CAMERA "sphere { center = (0, 0, 0)  radius = $(1, 2) }",
                {"expected a number: only a cone has two radii, found '('"}},
        BadText{"settings_at_top", CAMERA "$aa = 2", {"'aa' belongs in a `conventions` or a `render` block"}},
        BadText{"size_is_no_convention",
                CAMERA "conventions { $size = 3x3 }",
                {"a conventions block has no 'size': write it in a `render` block"}},
        BadText{"direction_without_type",
                "$light { direction = (0, 1, 0) }\n",
                {"expected `type = directional` in a light that has a direction and no position"}},
        BadText{"include_as_setting",
                CAMERA "$include = \"b.glint\"",
                {"an include has no `=`: write `include \"file\"`"}},
        BadText{"smooth_triangle",
                "$smooth_triangle { }",
                {"no block is called 'smooth_triangle': write `triangle` with `normals`"}}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Mistakes, GlintMistakes,
    testing::Values(
        BadText{
            "unknown_key", CAMERA BALL "$radios = 2 }", {"a sphere has no 'radios'; did you mean `radius`?"}},
        BadText{"unknown_block",
                CAMERA "$sphree { center = (0, 0, 0) }",
                {"no block is called 'sphree'; did you mean `sphere`?"}},
        BadText{"unknown_setting",
                CAMERA "$backgruond = (0, 0, 0)",
                {"no setting is called 'backgruond'; did you mean `background`?"}},
        BadText{"unknown_material",
                CAMERA "material gold { }\n" BALL "material = $glod }\n" BALL "material = glod }",
                {"no material is called 'glod'; did you mean `gold`?"}},
        BadText{"second_material",
                CAMERA "material gold { }\nmaterial $gold { }",
                {"a second material called 'gold': the first is in line 2"}},
        BadText{"material_without_name", "$material { }", {"expected a name after `material`"}},
        BadText{"missing_keys",
                CAMERA "$cylinder { from = (0, 0, 0) }",
                {"expected `to`, `radius` in the cylinder"}},
        BadText{"equal_ends",
                CAMERA "$cone { from = (0, 0, 0)  to = (0, 0, 0)  radius = 1 }",
                {"cone 1: expected an axis of some length, found two equal ends (0, 0, 0)"}},
        BadText{"spot_without_axis",
                CAMERA BALL "}\n$light { type = spot  position = (1, 9, 1) }",
                {"expected `axis` in the spot light"}},
        BadText{"spot_with_axis_and_target",
                CAMERA BALL
                "}\nlight { type = spot  position = (1, 9, 1)  axis = (0, -1, 0)  $target = (1, 0, 1) }",
                {"expected `axis` or `target` in the spot light, found both"}},
        BadText{"spot_aimed_at_itself",
                CAMERA BALL "}\nlight { $target = (1, 9, 1)  type = spot  position = (1, 9, 1) }",
                {"expected a target other than the position of the light"}},
        BadText{"target_of_a_point_light",
                CAMERA BALL "}\nlight { position = (1, 9, 1)  $target = (1, 0, 1) }",
                {"glint ignores the 'target' of a point light"}},
        BadText{"spot_without_outer_angle",
                CAMERA BALL
                "}\nlight { type = spot  position = (1, 9, 1)  axis = (0, -1, 0)  outer_angle = $0 }",
                {"expected an angle > 0 and at most 180 degrees, found '0'"}},
        BadText{"spot_with_a_large_inner_angle",
                CAMERA BALL
                "} $light { type = spot  position = (1, 9, 1)  axis = (0, -1, 0)  inner_angle = 46 }",
                {"light 1: inner angle: expected at most the outer angle of 45 degrees, found 46"}},
        BadText{
            "no_truth", CAMERA LIGHT BALL "casts_shadow = $no }", {"expected `true` or `false`, found 'no'"}},
        BadText{"filter_above_one",
                CAMERA LIGHT BALL "filter = $1.5 }",
                {"expected a number from 0 to 1, found '1.5'"}},
        BadText{"more_than_all_light",
                CAMERA LIGHT " $material pane { filter = 0.75  transmit = 0.5 }" BALL "material = pane }",
                {"material 'pane': filter + transmit: expected at most 1, found 0.75 + 0.5"}},
        BadText{"two_transparencies",
                CAMERA LIGHT " $material pane { filter = 0.5  transmission = 0.5 }" BALL "material = pane }",
                {"material 'pane': expected `transmission` (with refraction) or `filter` and `transmit` "
                 "(without), found both"}},
        BadText{"opacity", CAMERA LIGHT BALL "$opacity = 0.5 }", {"`transmit`, which is 1 - opacity"}},
        BadText{"no_scale",
                CAMERA BALL "$scale = (1, 0, 1) }",
                {"expected a scale without 0, which would leave nothing of the shape"}},
        BadText{"flat_matrix",
                CAMERA "\n $" BALL "matrix = ((1, 0, 0, 0), (0, 1, 0, 0), (1, 0, 0, 0)) }",
                {"transform 1 flattens what it transforms: it has no inverse"}},
        BadText{"two_rows",
                CAMERA BALL "matrix = $((1, 0, 0, 0), (0, 1, 0, 0)) }",
                {"expected three rows `(a, b, c, t)`, found 2"}},
        BadText{
            "both_angles", "$camera { fov_x = 30  fov_y = 40 }", {"expected `fov_x` or `fov_y`, found both"}},
        BadText{"flat_camera_with_angle",
                "$camera { projection = orthographic  fov_x = 30 }",
                {"an orthographic camera has no field of view: write `width`"}},
        BadText{"width_of_a_perspective",
                "$camera { width = 3 }",
                {"a perspective camera has no `width`: write `fov_x` or `fov_y`, or `projection = "
                 "orthographic`"}},
        BadText{"half_a_frame",
                "$camera { right = (1, 0, 0)  up = (0, 1, 0) }",
                {"expected `right`, `up` and `forward`, all three or none of them"}},
        BadText{"frame_and_target",
                "$camera { right = (1, 0, 0)  up = (0, 1, 0)  forward = (0, 0, -1)  look_at = (0, 0, 0) }",
                {"expected no `look_at` beside `right`, `up` and `forward`, which say it already"}},
        BadText{"unused_position",
                CAMERA BALL "}\nlight { type = directional  to_light = (0, 1, 0)  $position = (1, 1, 1) }",
                {"glint ignores the 'position' of a directional light"}},
        BadText{"no_such_light",
                CAMERA "light { type = $lamp }",
                {"expected `ambient`, `point`, `directional` or `spot`, found 'lamp'"}},
        BadText{"no_direction",
                CAMERA "light { type = directional  to_light = $(0, 0, 0) }",
                {"expected a direction other than (0, 0, 0)"}},
        BadText{"late_profile",
                CAMERA "render { aa = 2 }\n$profile = cgfs",
                {"expected `profile` before the first `conventions` or `render` block, whose keys it would "
                 "undo"}},
        BadText{"wrong_setting",
                CAMERA "conventions { offset = $foo }",
                {"offset: expected ray | normal | facing | direction | scale, found 'foo'"}},
        BadText{"version",
                CAMERA BALL "} " LIGHT "glint = $2",
                {"expected 1, the version of the language, found '2'"}},
        BadText{"late_group_key",
                CAMERA "group { " BALL "}  $scale = 2 }",
                {"expected 'scale' before what the group holds"}},
        BadText{"light_in_group",
                CAMERA "group { $light { } }",
                {"a group contains shapes, groups and includes; 'light' must be outside"}},
        BadText{"open_group",
                CAMERA "group {\n group { " BALL "} }\n$",
                {"expected `}`: the block that begins in line 2 has no end, found the end of the text"}},
        BadText{"open_block",
                CAMERA "sphere { radius = 1\n $light \"key\" { position = (0, 1, 0) }",
                {"expected `}` before 'light': the block that begins in line 2 has no end"}},
        BadText{"two_vertices",
                CAMERA "polygon { $vertices = ((0, 0, 0), (1, 0, 0)) }",
                {"expected at least 3 vertices, found 2"}},
        BadText{"four_corners",
                CAMERA "triangle { vertices = ((0, 0, 0), (1, 0, 0), (1, 1, 0), $(0, 1, 0)) }",
                {"expected `)` after the third of a triangle, found '('"}},
        BadText{
            "bad_hexadecimal",
            "material a { color = $\"#12345\" }",
            {"expected a color: (r, g, b) from 0 to 1, rgb255(r, g, b) or \"#rrggbb\", found '\"#12345\"'"}}),
    test_name);

}  // namespace
}  // namespace glint::test
