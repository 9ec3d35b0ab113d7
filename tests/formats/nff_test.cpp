// SPDX-License-Identifier: Apache-2.0
// The Neutral File Format, entity by entity.
#include <cmath>

#include "formats/mistakes.h"

namespace glint::test {
namespace {

#define VIEW "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 20 10\n"
#define FILL "f 1 0.5 0.25 0.5 0.75 8 0 0\n"

Scene scene_of(const std::string& text) { return quiet_scene(text, "a.nff"); }

TEST(Nff, ReadsTheView) {
    const Scene s = scene_of(
        "# a comment\nb 0.078 0.361 0.753\nv\nfrom 1 2 3\nat 4 5 7\nup 0 0 2\nangle 30\nhither 0.1\n"
        "resolution 320 200\nl 0 0 9\n" FILL "s 0 0 0 1\n");
    EXPECT_EQ(s.profile, "nff");
    EXPECT_EQ(s.background, (Color{0.078, 0.361, 0.753}));
    EXPECT_EQ(s.background_place.line, 2u);
    EXPECT_EQ(s.camera.position, (Vec3{1, 2, 3}));
    EXPECT_EQ(s.camera.look_at, (Vec3{4, 5, 7}));
    EXPECT_EQ(s.camera.up, (Vec3{0, 0, 2}));
    EXPECT_EQ(s.camera.fov_degrees, 30);
    EXPECT_EQ(s.camera.fov_axis, FovAxis::y);
    EXPECT_EQ(s.camera_place.line, 3u);
    EXPECT_EQ(s.settings.width, 320);
    EXPECT_EQ(s.settings.height, 200);
    EXPECT_EQ(s.origins[*find_setting("size")].kind, SettingOrigin::Kind::file);
}

TEST(Nff, TheViewsLinesComeInAnyOrder) {
    const Scene s = scene_of("l 0 0 9 " FILL "s 0 0 0 1 v resolution 8 9 at 1 1 1 from 2 2 2 b 1 1 1");
    EXPECT_EQ(s.camera.position, (Vec3{2, 2, 2}));
    EXPECT_EQ(s.camera.look_at, (Vec3{1, 1, 1}));
    EXPECT_EQ(s.camera.up, (Vec3{0, 1, 0}));
    EXPECT_EQ(s.camera.fov_degrees, 45);
    EXPECT_EQ(s.settings.height, 9);
    EXPECT_EQ(s.background, (Color{1, 1, 1}));
}

TEST(Nff, LightsWithoutAColorGetADefaultIntensity) {
    const Scene s = scene_of(VIEW "l 1 2 3\nl 4 5 6 0.5 0.25 1\nl 7 8 9\nl 0 0 1\n" FILL "s 0 0 0 1\n");
    ASSERT_EQ(s.lights.size(), 4u);
    EXPECT_EQ(s.lights[0].kind, LightKind::point);
    EXPECT_EQ(s.lights[0].position, (Vec3{1, 2, 3}));
    EXPECT_EQ(s.lights[0].color, (Color{0.5, 0.5, 0.5})) << "1 / sqrt(4)";
    EXPECT_EQ(s.lights[1].color, (Color{0.5, 0.25, 1}));
    EXPECT_EQ(s.lights[1].specular_color, (Color{0.5, 0.25, 1}));
    EXPECT_EQ(s.lights[2].specular_color, (Color{0.5, 0.5, 0.5}));
    EXPECT_EQ(s.light_texts.place(1).line, 9u);
}

TEST(Nff, ReadsFills) {
    const Scene s = scene_of(VIEW
                             "l 0 0 9\nf 1 0.5 0.25 0.5 0.75 8 0.25 1.5\ns 0 0 0 1\nf 1 1 1 1 2 3 0 0\n"
                             "s 0 0 0 2\ns 0 0 0 3\n");
    ASSERT_EQ(s.materials.size(), 2u);
    const Material& m = s.materials[0];
    EXPECT_EQ(m.color, (Color{1, 0.5, 0.25}));
    EXPECT_EQ(m.ambient, (Color{0, 0, 0}));
    EXPECT_EQ(m.diffuse, (Color{0.5, 0.25, 0.125}));
    EXPECT_EQ(m.specular, (Color{0.75, 0.75, 0.75}));
    EXPECT_EQ(m.shininess, 8);
    EXPECT_EQ(m.mirror, 0.75);
    EXPECT_EQ(m.transmission, 0.25);
    EXPECT_EQ(m.ior, 1.5);
    EXPECT_EQ(s.material_texts.place(0).line, 9u);
    EXPECT_EQ(s.materials[1].ior, 1) << "0 means that none is given";
    EXPECT_EQ(s.materials[1].mirror, 1) << "a mirror reflects at most everything";
    EXPECT_EQ(s.materials[1].specular.r, 2);
    EXPECT_EQ(s.shapes[0].material, 0u);
    EXPECT_EQ(s.shapes[1].material, 1u);
    EXPECT_EQ(s.shapes[2].material, 1u);
}

TEST(Nff, ReadsShapes) {
    const Scene s = scene_of(VIEW "l 0 0 9\n" FILL
                                  "s 1 2 3 4\n"
                                  "c 0 0 0 1  0 0 2 0.5\nc 0 0 0 1 0 0 2 1\nc\n0 0 0 0\n0 0 2 1\n"
                                  "p 3 0 0 0 1 0 0 0 1 0\n"
                                  "p 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
                                  "pp 3 0 0 0 0 0 1 1 0 0 0 1 1 0 1 0 1 0 1\n");
    ASSERT_EQ(s.shapes.size(), 7u);
    EXPECT_EQ(s.get<Sphere>()[0].center, (Vec3{1, 2, 3}));
    EXPECT_EQ(s.get<Sphere>()[0].radius, 4);
    ASSERT_EQ(s.get<Cone>().size(), 2u);
    const Cone& cone = s.get<Cone>()[0];
    EXPECT_EQ(cone.from, (Vec3{0, 0, 0}));
    EXPECT_EQ(cone.to, (Vec3{0, 0, 2}));
    EXPECT_EQ(cone.from_radius, 1);
    EXPECT_EQ(cone.to_radius, 0.5);
    EXPECT_FALSE(cone.caps);
    EXPECT_EQ(s.get<Cone>()[1].from_radius, 0);
    ASSERT_EQ(s.get<Cylinder>().size(), 1u) << "equal radii";
    EXPECT_EQ(s.get<Cylinder>()[0].radius, 1);
    EXPECT_FALSE(s.get<Cylinder>()[0].caps);
    ASSERT_EQ(s.get<Triangle>().size(), 1u);
    EXPECT_EQ(s.get<Triangle>()[0].vertices[2], (Vec3{0, 1, 0}));
    ASSERT_EQ(s.get<Polygon>().size(), 1u);
    EXPECT_EQ(s.get<Polygon>()[0].count, 4u);
    EXPECT_EQ(s.polygon_vertices.size(), 4u) << "a triangle keeps its own";
    ASSERT_EQ(s.get<SmoothTriangle>().size(), 1u);
    EXPECT_EQ(s.get<SmoothTriangle>()[0].vertices[1], (Vec3{1, 0, 0}));
    EXPECT_EQ(s.get<SmoothTriangle>()[0].normals[1], (Vec3{0, 1, 1}));
    EXPECT_EQ(s.get<SmoothTriangle>()[0].normals[2], (Vec3{1, 0, 1}));
    EXPECT_EQ(s.shape_texts.place(0).line, 10u);
    EXPECT_EQ(s.shape_texts.place(6).line, 22u);
}

TEST(Nff, APatchOfMoreVerticesIsAFan) {
    const Scene s =
        scene_of(VIEW "l 0 0 9\n" FILL "pp 4 0 0 0 0 0 1  1 0 0 0 0 2  1 1 0 0 0 3  0 1 0 0 0 4\n");
    ASSERT_EQ(s.get<SmoothTriangle>().size(), 2u);
    const SmoothTriangle& second = s.get<SmoothTriangle>()[1];
    EXPECT_EQ(second.vertices[0], (Vec3{0, 0, 0}));
    EXPECT_EQ(second.vertices[1], (Vec3{1, 1, 0}));
    EXPECT_EQ(second.vertices[2], (Vec3{0, 1, 0}));
    EXPECT_EQ(second.normals[2], (Vec3{0, 0, 4}));
}

TEST(Nff, NegativeRadiiHaveNoEffect) {
    const Scene s = scene_of(VIEW "l 0 0 9\n" FILL "s 0 0 0 -2\nc 0 0 0 -1 0 0 1 -1\n");
    EXPECT_EQ(s.get<Sphere>()[0].radius, 2);
    EXPECT_EQ(s.get<Cylinder>()[0].radius, 1);
}

class NffMistakes : public testing::TestWithParam<BadText> {};
TEST_P(NffMistakes, AreReportedAtTheirPlace) { expect_messages(GetParam(), "a.nff"); }

#define ENTITIES                                                                                        \
    "`b`, `v`, `l`, `f`, `c`, `s`, `p` or `pp` (background, view, light, fill, cone, sphere, polygon, " \
    "patch)"
#define LF VIEW "l 0 0 9\n" FILL

INSTANTIATE_TEST_SUITE_P(
    Entities, NffMistakes,
    testing::Values(
        BadText{"empty", "$", {"expected " ENTITIES ", found the end of the text"}},
        BadText{"unknown", LF "$t 1 2 3\ns 0 0 0 1\n", {"expected " ENTITIES ", found 't'"}},
        BadText{"number_first", LF "$3 4 5 s 0 0 0 1\n", {"expected " ENTITIES ", found '3'"}},
        BadText{"too_many_numbers", LF "s 0 0 0 1 $2 3\ns 0 0 0 1\n", {"expected " ENTITIES ", found '2'"}},
        BadText{"too_few_numbers", LF "s 0 0 0\n$s 0 0 0 1\n", {"expected a number, found 's'"}},
        BadText{"cut_off", LF "s 0 0$", {"expected a number, found the end of the text"}},
        BadText{"word", LF "s 0 $abc 0 1\ns 0 0 0 1\n", {"expected a number, found 'abc'"}},
        BadText{"not_a_number", LF "s 0 $NaN 0 1\n", {"expected a number, found 'NaN'"}},
        BadText{"far", LF "s 0 0 $1e13 1\n", {"expected a number from -1e12 to 1e12, found '1e13'"}},
        BadText{"two_mistakes",
                LF "s 0 $x 0 1\np $2 0 0 0 1 1 1\n",
                {"expected a number, found 'x'", "expected a whole number from 3 to 4096, found '2'"}},
        BadText{"no_radius", LF "s 0 0 0 $0\n", {"expected a radius other than 0"}},
        BadText{"broken_vertices", LF "p 4 0 0 0 1 1 1 2 2 $x\n", {"expected a number, found 'x'"}}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    View, NffMistakes,
    testing::Values(
        BadText{"no_from", "$v at 0 0 0\n l 0 0 9\n" FILL "s 0 0 0 1\n", {"expected `from` in the view"}},
        BadText{"no_line", "$v\nl 0 0 9\n" FILL "s 0 0 0 1\n", {"expected `from`, `at` in the view"}},
        BadText{
            "misspelt",
            "v\n$form 0 0 5\nfrom 0 0 5 at 0 0 0\nl 0 0 9\n" FILL "s 0 0 0 1\n",
            {"expected `from`, `at`, `up`, `angle`, `hither` or `resolution`, or an entity, found 'form'; "
             "did you mean `from`?"}},
        BadText{"twice",
                "v from 0 0 5 at 0 0 0 $from 0 0 6\nl 0 0 9\n" FILL "s 0 0 0 1\n",
                {"`from` is given twice in one view: the last one holds"}},
        BadText{"two_views", LF "s 0 0 0 1\n$v from 0 0 6 at 0 0 0\n", {"a second view: the last one holds"}},
        BadText{"none",
                "l 0 0 9\n" FILL "s 0 0 0 1$",
                {"no view `v`: the camera is at the origin and looks along the negative z axis"}},
        BadText{"angle",
                "v from 0 0 5 at 0 0 0 angle $180\nl 0 0 9\n" FILL "s 0 0 0 1\n",
                {"expected an angle between 0 and 180 degrees, found '180'"}},
        BadText{"resolution",
                "v from 0 0 5 at 0 0 0 resolution 20 $0\nl 0 0 9\n" FILL "s 0 0 0 1\n",
                {"expected a whole number from 1 to 65536, found '0'"}},
        BadText{"half_a_pixel",
                "v from 0 0 5 at 0 0 0 resolution 20 $7.5\nl 0 0 9\n" FILL "s 0 0 0 1\n",
                {"expected a whole number from 1 to 65536, found '7.5'"}},
        BadText{"from_at",
                "$v from 0 0 5 at 0 0 5\nl 0 0 9\n" FILL "s 0 0 0 1\n",
                {"the camera is at the point that it looks at: the two must differ"}}),
    test_name);

INSTANTIATE_TEST_SUITE_P(
    Values, NffMistakes,
    testing::Values(
        BadText{"no_fill",
                VIEW "l 0 0 9\n$s 0 0 0 1\ns 0 0 0 2\n",
                {"no `f` before the first shape: it has glint's default material"}},
        BadText{"transmission",
                VIEW "l 0 0 9\nf 1 1 1 1 1 1 $2 1\ns 0 0 0 1\n",
                {"expected a number from 0 to 1, found '2'"}},
        BadText{"shine",
                VIEW "l 0 0 9\nf 1 1 1 1 1 $-1 0 1\ns 0 0 0 1\n",
                {"expected a number from 0 to 1e9, found '-1'"}},
        BadText{"index",
                VIEW "l 0 0 9\nf 1 1 1 1 1 1 0 $-1\ns 0 0 0 1\n",
                {"expected a number from 0 to 1e12, found '-1'"}},
        BadText{"vertices",
                LF "p $5000 0 0 0\ns 0 0 0 1\n",
                {"expected a whole number from 3 to 4096, found '5000'"}},
        BadText{"half_a_vertex",
                LF "pp $3.5 0 0 0\ns 0 0 0 1\n",
                {"expected a whole number from 3 to 4096, found '3.5'"}},
        BadText{"cone_without_axis",
                LF "$c 0 0 0 1 0 0 0 2\n",
                {"cone 1: expected an axis of some length, found two equal ends (0, 0, 0)"}},
        BadText{"cone_without_radius",
                LF "$c 0 0 0 0 0 0 1 0\n",
                {"cylinder 1: radius: expected a number > 0 and at most 1e12, found 0"}},
        BadText{
            "patch_without_normal",
            LF "$pp 3 0 0 0 0 0 0 1 0 0 0 0 1 1 1 0 0 0 1\n",
            {"smooth_triangle 1: expected a normal other than (0, 0, 0) and within 1e12, found (0, 0, 0)"}}),
    test_name);

}  // namespace
}  // namespace glint::test
