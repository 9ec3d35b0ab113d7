// SPDX-License-Identifier: Apache-2.0
// POV-Ray's mesh and mesh2.
#include <gtest/gtest.h>

#include "povray_text.h"

namespace glint::test {
namespace {

// The rest of a mesh2 with two faces of a square, whose textures have these items.
std::string square(const std::string& textures, const std::string& faces, const std::string& items = "") {
    return "mesh2 { vertex_vectors { 4, 0, x, y, <1, 1, 0> } texture_list { " + textures +
           " } face_indices { 2, " + faces + " } " + items + " }\n";
}

std::string texture(const std::string& color, const std::string& finish = "") {
    return "texture { pigment { rgb " + color + " } finish { " + finish + " } }";
}

const MeshData& pov_mesh(const Scene& scene, std::size_t shape = 0) {
    return *scene.meshes.at(scene.get<Mesh>().at(scene.shapes.at(shape).index).mesh);
}

TEST(PovRayMesh, HasVerticesNormalsAndATransform) {
    const Scene scene = povray_scene(
        "mesh2 { vertex_vectors { 4, 0, x, y, <1, 1, 0> } normal_vectors { 2, 3*z, 0 }\n"
        "  face_indices { 2, <0, 1, 2>, <1, 3, 2> } normal_indices { 1, <0, 1, 0> } translate 2*z }\n"
        "mesh { inside_vector z triangle { 0, x, y } smooth_triangle { 0, z, x, z, y, z } inside_vector y "
        "pigment { rgb 1 } "
        "}\n");
    ASSERT_EQ(scene.shapes.size(), 2u);
    EXPECT_EQ(scene.transforms.at(scene.shapes[0].transform).m[2][3], 2);
    EXPECT_EQ(pov_mesh(scene).position(3), (Vec3{1, 1, 0}));
    ASSERT_TRUE(pov_mesh(scene).corner_normals(0));
    EXPECT_EQ((*pov_mesh(scene).corner_normals(0))[0], (Float3{0, 0, 1}));
    EXPECT_EQ((*pov_mesh(scene).corner_normals(0))[1], (Float3{1, 0, 0})) << "as POV-Ray's for 0";
    EXPECT_FALSE(pov_mesh(scene).corner_normals(1));
    EXPECT_FALSE(pov_mesh(scene, 1).corner_normals(0));
    EXPECT_TRUE(pov_mesh(scene, 1).corner_normals(1));
}

TEST(PovRayMesh, IsStoredOnceForAllItsPlaces) {
    const Scene scene =
        povray_scene("#declare M = " +
                     square("2, " + texture("1") + texture("0", "phong 1"), "<0, 1, 2>, 0, <1, 3, 2>, 1") +
                     "#declare G = union { object { M } object { M translate x pigment { rgb 1 } } }\n"
                     "object { G } object { G scale <1, 2, 3> } M object { M no_shadow }\n");
    EXPECT_EQ(scene.shapes.size(), 12u);
    EXPECT_EQ(scene.meshes.size(), 2u) << "one for each finish";
    EXPECT_EQ(scene.materials.size(), 4u) << "two of them cast no shadow";
}

TEST(PovRayMesh, FacesOfDifferentColorsAreOneMesh) {
    const Scene scene = povray_scene(
        square("2, " + texture("<1, 0, 0>", "specular .5") + ", " + texture("<0, .5, 0>", "specular .5"),
               "<0, 1, 2>, 1, <1, 3, 2>, 0"));
    ASSERT_EQ(scene.shapes.size(), 1u);
    const MeshData& mesh = pov_mesh(scene);
    EXPECT_EQ((*mesh.corner_values(mesh.colors, 0))[2], (Float3{0, .5, 0}));
    EXPECT_EQ((*mesh.corner_values(mesh.colors, 1))[0], (Float3{1, 0, 0}));
    const Material gray = with_color(scene.materials.at(0), {.5, .5, .5});
    EXPECT_EQ(gray.diffuse, (Color{.3, .3, .3}));
    EXPECT_EQ(gray.ambient, (Color{.05, .05, .05}));
    EXPECT_EQ(gray.specular, (Color{.5, .5, .5})) << "of no color but the light's";
    EXPECT_EQ(with_color(scene.materials.at(0), {0, 0, 1}).specular, (Color{.5, .5, .5}));
    // One color is the material's.
    const Scene plain =
        povray_scene(square("2, " + texture("x") + texture("x"), "<0, 1, 2>, 1, <1, 3, 2>, 0"));
    EXPECT_TRUE(pov_mesh(plain).colors.empty());
    EXPECT_EQ(plain.materials.at(0).color, (Color{1, 0, 0}));
}

TEST(PovRayMesh, CornersHaveColors) {
    const std::string red = texture("<1, 0, 0>"), blue = texture("<0, 0, 1>");
    const Scene scene = povray_scene(square("2, " + red + blue, "<0, 1, 2>, 0, 1, 0, <1, 3, 2>, 1"));
    ASSERT_EQ(scene.shapes.size(), 1u);
    const MeshData& mesh = pov_mesh(scene);
    EXPECT_EQ((*mesh.corner_values(mesh.colors, 0))[0], (Float3{1, 0, 0}));
    EXPECT_EQ((*mesh.corner_values(mesh.colors, 0))[1], (Float3{0, 0, 1}));
    // Where the light is not linear in the color, or something else differs, faces are divided.
    for (const std::string& other :
         {texture("0", "emission 1"), texture("0", "ambient x"), texture("0 filter .5"), texture("-1")}) {
        const Scene fine = povray_scene(square("2, " + other + red, "<0, 1, 2>, 0, 1, 0, <1, 3, 2>, 1"));
        EXPECT_GT(fine.shapes.size(), 100u) << other;
        EXPECT_EQ(fine.get<Mesh>().size(), 1u) << other;
    }
}

TEST(PovRayMesh, FacesWithoutATextureHaveThatOfTheObject) {
    const Scene scene = povray_scene(
        square("1, " + texture("x"), "<0, 1, 2>, 0, <1, 3, 2>", "texture { pigment { rgb z } }"));
    ASSERT_EQ(scene.shapes.size(), 2u);
    EXPECT_EQ(scene.materials.at(scene.shapes[0].material).color, (Color{1, 0, 0}));
    EXPECT_EQ(scene.materials.at(scene.shapes[1].material).color, (Color{0, 0, 1}));
    EXPECT_EQ(pov_mesh(scene, 1).triangles.size(), 1u);
    EXPECT_EQ(pov_mesh(scene, 1).position(pov_mesh(scene, 1).triangles[0][1]), (Vec3{1, 1, 0}));
}

// PyMOL writes each triangle of a surface as a mesh.
TEST(PovRayMesh, SingleFacesWithThreeColorsAreGathered) {
    const auto face = [](const std::string& finish, const std::string& items = "") {
        return "mesh2 { vertex_vectors { 3, 0, x, y } texture_list { 3, " + texture("x", finish) +
               texture("y", finish) + texture("z", finish) + "} face_indices { 1, <0, 1, 2>, 0, 1, 2 } " +
               items + " }\n";
    };
    const Scene scene =
        povray_scene(face("phong 1") + "sphere { 0, 1 }\n" + face("phong 1") + face("phong .5") +
                     face("phong .5", "no_shadow") + face("phong .5", "translate x"));
    ASSERT_EQ(scene.get<Mesh>().size(), 4u);
    const MeshData& mesh = pov_mesh(scene);
    ASSERT_EQ(mesh.triangles.size(), 2u);
    EXPECT_EQ((*mesh.corner_values(mesh.colors, 1))[2], (Float3{0, 0, 1}));
    // Of one color: a triangle.
    EXPECT_EQ(povray_scene("mesh { triangle { 0, x, y } translate z }").get<Triangle>().at(0).vertices[0],
              (Vec3{0, 0, 1}));
}

TEST(PovRayMesh, IsCutByBoxes) {
    const Scene scene = povray_scene(
        "mesh2 { vertex_vectors { 3, 0, 2*x, 2*y } face_indices { 1, <0, 1, 2> }\n"
        "  clipped_by { box { -1, 1 } } }");
    ASSERT_EQ(scene.meshes.size(), 1u);
    EXPECT_EQ(pov_mesh(scene).triangles.size(), 2u) << "a quadrangle: the corner square without the corner";
    for (std::uint32_t i = 0; i < pov_mesh(scene).vertex_count(); ++i)
        EXPECT_LE(pov_mesh(scene).position(i).x, 1 + k_pov_near);
    // The other side of a plane.
    for (const std::string plane : {"plane { -x, -1.5 }", "plane { x, 1.5 inverse }"}) {
        const Scene part = povray_scene(
            "mesh2 { vertex_vectors { 3, 0, 2*x, 2*y } face_indices { 1, <0, 1, 2> }\n  clipped_by { " +
            plane + " } }");
        EXPECT_EQ(part.get<Triangle>().at(0).vertices[1], (Vec3{2, 0, 0})) << plane;
        for (const Vec3& v : part.get<Triangle>().at(0).vertices) EXPECT_GE(v.x, 1.5) << plane;
    }
    // A box that holds the whole shape cuts nothing.
    EXPECT_EQ(povray_scene("sphere { 0, 1 clipped_by { box { -2, 2 } } }").shapes.size(), 1u);
}

TEST(PovRayMesh, IsNotCutWithoutAMessage) {
    const auto said = [](const std::string& mesh) {
        return messages(read_povray("light_source { <0, 0, -9>, rgb 1 }\ncamera { location -9*z }\n" + mesh));
    };
    const std::string refused = "a.pov:4:2: error: glint does not render `clipped_by`";
    const std::string vertices = "mesh2 { vertex_vectors { 4, 0, 2*x, 2*y, 9*z }";
    const std::string faces = vertices + " face_indices { 1, <0, 1, 2> }\n ";
    const auto with_colors = [&](const std::string& indices) {
        return vertices + " texture_list { 2, " + texture("x") + texture("y") + "} face_indices { 2, " +
               indices + " }\n clipped_by { plane { z, 1 } }}";
    };
    for (const std::string& mesh : {
             faces + "clipped_by { box { -1, 1 inverse } }}",
             faces + "clipped_by { box { -3, -2 inverse } }}",
             faces + "clipped_by { box { -1, 1 rotate 45*z } }}",
             faces + "clipped_by { sphere { 0, 1 } }}",
             with_colors("<0, 1, 2>, 0, 0, 0, <1, 2, 3>, 0, 1, 1"),
         }) {
        EXPECT_NE(said(mesh).find(refused), std::string::npos) << mesh << said(mesh);
    }
    EXPECT_NE(
        said(faces + "translate x clipped_by { box { -1, 1 } }}").find("4:14: error: glint does not render"),
        std::string::npos);
    for (const std::string& mesh : {
             faces + "clipped_by { box { -1, 1 inverse inverse } } translate x rotate 45*z }",
             with_colors("<0, 1, 2>, 0, 1, 1, <1, 2, 3>, 0, 0, 0"),
         }) {
        EXPECT_EQ(said(mesh).find("clipped_by"), std::string::npos) << mesh << said(mesh);
    }
}

TEST(PovRayMesh, AFarVertexIsNamedAsWritten) {
    const auto said = [](const std::string& mesh) {
        return messages(read_povray("sphere { 0, 1 }\n" + mesh));
    };
    const std::string message = "a.pov:2:1: error: vertex 3: expected coordinates within 1e12, found ";
    for (const auto& [number, found] : {std::pair{"1/0", "(0, 1e+300, 0)"},
                                        {"-1e60", "(0, -1e+60, 0)"},
                                        {"1e30", "(0, 1e+30, 0)"},
                                        {"1e13", "(0, 10000000000000, 0)"}}) {
        const std::string vertex = "<0, " + std::string(number) + ", 0>";
        const std::string list = said("mesh2 { vertex_vectors { 4, 0, x, y, " + vertex +
                                      " } face_indices { 2, <0, 1, 2>, <0, 1, 3> } }");
        EXPECT_NE(list.find(message + found), std::string::npos) << list;
        const std::string one = said("mesh { triangle { 0, x, y } triangle { " + vertex + ", x, y } }");
        EXPECT_NE(one.find(message + found), std::string::npos) << one;
    }
    // One that is not placed is not refused.
    EXPECT_EQ(said("#declare M = mesh { triangle { 0, x, <0, 1/0, 0> } }").find("error"), std::string::npos);
}

}  // namespace
}  // namespace glint::test
