// SPDX-License-Identifier: Apache-2.0
// Material::one_sided: rays pass surfaces that they meet from behind.
#include <gtest/gtest.h>

#include "explain/added_up.h"
#include "formats/load_text.h"
#include "glint/explain.h"
#include "trace/pictures.h"

namespace glint::test {
namespace {

const std::string k_one_sided_view =
    "render { size = 40 x 30 }\n"
    "light { type = ambient  intensity = 0.3 }\nlight { position = (3, 6, 9) }\n"
    "plane \"wall\" { point = (0, 0, -4)  normal = (0, 0, 1)  color = (0.5, 0.6, 0.7) }\n";

Scene one_sided_scene(const std::string& shapes) {
    const bool has_camera = shapes.find("camera {") != shapes.npos;
    return quiet_scene(
        (has_camera ? "" : "camera { position = (0, 1, 8)  look_at = (0, 1, 0)  fov_x = 40 }\n") +
            k_one_sided_view + shapes,
        "a.glint");
}
Image one_sided_picture(const std::string& shapes) { return render_scene(one_sided_scene(shapes)); }

// Shapes that enclose space, and a mirror that shows them from the other side.
std::string closed_shapes(const std::string& keys) {
    const std::string k = "  color = (0.9, 0.5, 0.2)  specular = 0.4  " + keys + " }\n";
    return "sphere { center = (-2, 1, 0)  radius = 0.6" + k + "sphere { center = (-2, 2.4, 0)  radius = 0.5" +
           "  scale = (1, 0.7, -1.4)" + k + "box { min = (-1, 0, 0)  max = (0, 1, 1)  rotate = (0, 30, 10)" +
           k + "cylinder { from = (1, 0, 0)  to = (1.2, 1, 0.3)  radius = 0.4" + k +
           "cone { from = (2.2, 0, 0)  to = (2.2, 1, 0)  radius = (0.5, 0.1)" + k +
           // A tetrahedron, as it is and reflected.
           "mesh { vertices = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))  "
           "triangles = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))  translate = (0.5, 1.6, 0)" +
           k +
           "mesh { vertices = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))  "
           "triangles = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))  scale = (-1, 1, 0.6)  "
           "translate = (0.3, 1.6, 0)" +
           k +
           "disc \"mirror\" { center = (0, 3.4, -2)  normal = (0, -1, 1)  radius = 3  mirror = 0.8 }\n"
           "plane { point = (0, -0.2, 0)  normal = (0, 1, 0)  mirror = 0.3 " +
           k;
}

// Two triangles whose front is towards the camera, or (`back`) away from it.
std::string one_sided_square(bool back, const std::string& keys = {}) {
    return "mesh { vertices = ((-1, 0, 0), (1, 0, 0), (1, 2, 0), (-1, 2, 0))  triangles = " +
           std::string(back ? "((0, 2, 1), (0, 3, 2))" : "((0, 1, 2), (0, 2, 3))") +
           "  color = (1, 0.2, 0.1)  " + (keys.find("one_sided") == keys.npos ? "one_sided = true  " : "") +
           keys + " }\n";
}

void expect_same_image(const Image& a, const Image& b) {
    ASSERT_EQ(a.rgb.size(), b.rgb.size());
    EXPECT_EQ(a.rgb, b.rgb);
}

TEST(OneSided, ClosedShapesLookTheSame) {
    const Image usual = one_sided_picture(closed_shapes("")),
                one_sided = one_sided_picture(closed_shapes("one_sided = true"));
    expect_same_image(usual, one_sided);
    EXPECT_NE(usual.rgb, one_sided_picture("").rgb);
}

TEST(OneSided, RaysPassTheBack) {
    const std::string no_shadow = "casts_shadow = false";
    const Image empty = one_sided_picture(""), front = one_sided_picture(one_sided_square(false, no_shadow)),
                back = one_sided_picture(one_sided_square(true, no_shadow));
    expect_same_image(empty, back);
    EXPECT_GT(front.pixel(20, 15).r, 3 * front.pixel(20, 15).b);
    // Planes, discs and shapes around the camera.
    expect_same_image(
        empty, one_sided_picture(
                   "disc { center = (0, 1, 2)  normal = (0, 0.2, -1)  radius = 1  one_sided = true " +
                   no_shadow + " }\nplane { point = (0, 0, -3)  normal = (0, 0, -1)  one_sided = true " +
                   no_shadow + " }\nsphere { center = (0, 1, 8)  radius = 2  one_sided = true " + no_shadow +
                   " }\nbox { min = (-1, 0, 7)  max = (1, 2, 9)  one_sided = true " + no_shadow + " }\n"));
}

TEST(OneSided, BothSidesCastShadows) {
    // From a camera between the square and the wall, which shows nothing but the shadow.
    const auto shadow = [](const std::string& shapes) {
        return one_sided_picture(shapes +
                                 "camera { position = (0, 1, -1)  look_at = (0, 1, -4)  fov_x = 90 }\n");
    };
    const Image usual = shadow(one_sided_square(false, "one_sided = false"));
    expect_same_image(usual, shadow(one_sided_square(false)));
    expect_same_image(usual, shadow(one_sided_square(true)));
    EXPECT_NE(usual.rgb, shadow("").rgb);
}

TEST(OneSided, OfTwoTrianglesBackToBackTheFrontIsSeen) {
    const Image front = one_sided_picture(one_sided_square(false));
    for (const bool back_first : {false, true}) {
        // As two shapes, and as one mesh with a transform.
        expect_same_image(front,
                          one_sided_picture(one_sided_square(back_first) + one_sided_square(!back_first)));
        const std::string one = "((0, 1, 2), (0, 2, 3), ", other = "((0, 2, 1), (0, 3, 2), ";
        const std::string both = back_first ? other + one.substr(1) : one + other.substr(1);
        expect_same_image(
            front, one_sided_picture(
                       "mesh { vertices = ((-2, 0, 0), (2, 0, 0), (2, 1, 0), (-2, 1, 0))  triangles = " +
                       both.substr(0, both.size() - 2) +
                       ")  scale = (0.5, 2, 1)  color = (1, 0.2, 0.1)  one_sided = true }\n"));
    }
}

TEST(OneSided, MirrorsShowTheFrontOnly) {
    // The camera sees the mirror beside the square, and in it the square's other side.
    const std::string mirror =
        "disc { center = (0, 1, 9)  normal = (0, 0, -1)  radius = 9  mirror = 1  color = "
        "(0, 0, 0)  casts_shadow = false }\n";
    const auto seen = [&](const std::string& shapes) {
        return one_sided_picture("camera { position = (0, 1, 7)  look_at = (0, 1, 9)  fov_x = 40 }\n" +
                                 mirror + shapes);
    };
    expect_same_image(seen(""), seen(one_sided_square(true, "casts_shadow = false")));
    EXPECT_NE(seen("").rgb, seen(one_sided_square(false, "casts_shadow = false")).rgb);
}

TEST(OneSided, HasNoEffectOnGlass) {
    const std::string glass =
        "sphere { center = (0, 1, 0)  radius = 1  transmission = 0.9  ior = 1.5  one_sided = ";
    expect_same_image(one_sided_picture(glass + "false }\n"), one_sided_picture(glass + "true }\n"));
}

TEST(OneSided, WorksWithTransparency) {
    // Of a thin shell, the front alone is left: one layer of transmit instead of two.
    const std::string keys =
        "color = (0.2, 0.9, 0.2)  diffuse = 0  transmit = 0.5  casts_shadow = false  one_sided = ";
    const Image both = one_sided_picture("sphere { center = (0, 1, 0)  radius = 1  " + keys + "false }\n"),
                one = one_sided_picture("sphere { center = (0, 1, 0)  radius = 1  " + keys + "true }\n"),
                none = one_sided_picture("");
    const double wall = none.pixel(20, 15).b, own = 0.3 * 0.1 * 0.2;
    EXPECT_NEAR(one.pixel(20, 15).b, wall / 2 + own / 2, 1e-3);
    EXPECT_NEAR(both.pixel(20, 15).b, wall / 4 + own / 2 + own / 4, 1e-3);
}

TEST(OneSided, CanBeChangedInAWorld) {
    const Scene scene = one_sided_scene("sphere { center = (0, 1, 8)  radius = 2  color = (1, 1, 1) }\n");
    const World world = prepare(scene).value();
    const auto index = static_cast<std::uint32_t>(scene.materials.size() - 1);
    Material material = scene.materials[index];
    material.one_sided = true;
    Scene changed = scene;
    changed.materials[index] = material;
    expect_same_image(render_world(with_material(world, index, material).value()), render_scene(changed));
    expect_same_image(render_world(with_materials(world, changed.materials).value()), render_scene(changed));
    expect_same_image(render_world(with_material(with_material(world, index, material).value(), index,
                                                 scene.materials[index])
                                       .value()),
                      render_world(world));
}

TEST(OneSided, CropsAreTheSameOnAllMachines) {
    const std::optional<World> world =
        make_world(one_sided_scene(closed_shapes("one_sided = true") + one_sided_square(true)));
    ASSERT_TRUE(world);
    expect_same_crops(*world, 20);
}

TEST(OneSided, IsExplained) {
    const std::string squares = one_sided_square(true, "translate = (0, 0, 4)") +
                                one_sided_square(true, "translate = (0, 0, 3)") +
                                closed_shapes("one_sided = true");
    const Scene scene = one_sided_scene(squares);
    const World world = prepare(scene).value();
    const Explanation through = explain(scene, world, 20, 15).value();
    ASSERT_FALSE(through.rays.empty());
    const ExplainedRay& ray = through.rays[0];
    ASSERT_TRUE(ray.hit);
    EXPECT_EQ(ray.hole_count, 2);
    ASSERT_EQ(ray.holes.size(), 2u);
    EXPECT_EQ(ray.holes[0].shape, 1u);
    EXPECT_EQ(ray.holes[1].shape, 2u);
    for (const ExplainedHole& hole : ray.holes) {
        EXPECT_TRUE(hole.back);
        EXPECT_FALSE(hole.texture);
        EXPECT_LT(hole.t, ray.t);
    }
    const Image image = render_world(world);
    for (int y = 1; y < 30; y += 4) {
        for (int x = 1; x < 40; x += 4) {
            const Explanation e = explain(scene, world, x, y).value();
            expect_added_up(e, x, y);
            const Color drawn = image.pixel(x, y);
            EXPECT_EQ(e.value[0], static_cast<float>(drawn.r));
            EXPECT_EQ(e.value[1], static_cast<float>(drawn.g));
        }
    }
}

}  // namespace
}  // namespace glint::test
