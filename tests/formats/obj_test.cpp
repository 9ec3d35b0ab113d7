// SPDX-License-Identifier: Apache-2.0
// .obj: faces and their numbers, smoothing groups, colors, parts, and mistakes. mtl_test.cpp: materials.
#include "formats/mistakes.h"
#include "math/transform.h"

namespace glint::test {
namespace {

using Corners3 = std::vector<TriangleCorners>;
constexpr std::uint32_t k_no_value = CornerValues::k_none;
constexpr TriangleCorners k_flat{k_no_value, k_no_value, k_no_value};

constexpr std::string_view k_square_lines = "v 0 0 0\nv 1 0 0\nv 1 1 0.5\nv 0 1 0\n";

Scene scene_of(const std::string& text) { return quiet_scene(text, "a.obj"); }
MeshData mesh_of_obj(const std::string& text) {
    const Scene scene = scene_of(text);
    EXPECT_EQ(scene.meshes.size(), 1u);
    return scene.meshes.empty() ? MeshData{} : *scene.meshes[0];
}
// The square's vertices and these lines.
MeshData square(const std::string& lines) { return mesh_of_obj(std::string(k_square_lines) + lines); }

TEST(Obj, AFileIsASceneWithCameraAndLights) {
    const Scene scene = scene_of("# a square\n" + std::string(k_square_lines) + "f 1 2 3 4\n");
    ASSERT_EQ(scene.meshes.size(), 1u);
    const MeshData& mesh = *scene.meshes[0];
    EXPECT_EQ(mesh.single_positions, (std::vector<Float3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5F}, {0, 1, 0}}));
    EXPECT_EQ(mesh.triangles, (Corners3{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_TRUE(mesh.normals.empty());
    EXPECT_TRUE(mesh.colors.empty());
    EXPECT_EQ(scene.camera.look_at, (Vec3{0.5, 0.5, 0.25}));
    ASSERT_EQ(scene.lights.size(), 3u);
    EXPECT_EQ(scene.lights[0].color, (Color{1, 1, 1})) << "there are no materials of the file's own";
}

TEST(Obj, FacesHaveFourFormsAndNegativeNumbers) {
    const Corners3 expected{{0, 1, 2}};
    EXPECT_EQ(square("f 1 2 3\n").triangles, expected);
    EXPECT_EQ(square("vt 0 0\nf 1/1 2/1 3/1\n").triangles, expected);
    EXPECT_EQ(square("vt 0 0\nf -4/-1 -3/1 -2/1\n").triangles, expected);
    EXPECT_EQ(square("f 1/ 2// 3/7/\n").triangles, expected) << "nothing after a slash";
    for (const char* const face :
         {"f 1//1 2//2 3//1\n", "f 1/9/1 2/9/2 3/9/1\n", "f -4//-2 -3//-1 -2//-2\n"}) {
        const MeshData mesh = square(std::string("vn 0 0 1\nvn 0 1 1\n") + face);
        EXPECT_EQ(mesh.triangles, expected) << face;
        EXPECT_EQ(mesh.normals.values, (std::vector<Float3>{{0, 0, 1}, {0, 1, 1}})) << face;
        EXPECT_EQ(mesh.normals.corners, (Corners3{{0, 1, 0}})) << face;
    }
    const MeshData some = square("vn 0 0 1\nf 1//1 2//1 3//1\nf 1//1 3 4//1\nf 1 2 4\n");
    EXPECT_EQ(some.normals.corners, (Corners3{{0, 0, 0}, k_flat, k_flat})) << "a corner has none";
    const MeshData same = square("vn 0 0 1\nvn 0 1 1\nvn 0 1 0\nf 1//1 2//2 3//3\n");
    EXPECT_TRUE(same.normals.corners.empty()) << "normals have the numbers of vertices";
    EXPECT_EQ(mesh_of_obj("f 3 1 2\n" + std::string(k_square_lines)).triangles, expected)
        << "vertices may come later";
}

TEST(Obj, LinesAreContinuedAndEndInThreeWays) {
    const std::string text = "  v 0 \\\n 0\\\r\n 0 # the first\r\nv\t1 0 0\rv 0 +1 0\n\nf 1 2\\\n 3";
    EXPECT_EQ(mesh_of_obj(text).single_positions, (std::vector<Float3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    const std::string comment = "# a folder: C:\\\n" + std::string(k_square_lines) + "f 1 2 3\n";
    EXPECT_EQ(mesh_of_obj(comment).single_positions.size(), 3u) << "a comment is not continued";
}

TEST(Obj, PositionsHaveThePrecisionOfTheirNumbers) {
    const auto with = [](const std::string& x) {
        return mesh_of_obj("v " + x + " 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    };
    for (const char* const single : {"0.1", "12.345678", "1e-3", "0.10000000149011612"})
        EXPECT_TRUE(with(single).positions.empty()) << single;
    EXPECT_EQ(with("0.1").single_positions.at(0).x, 0.1F);
    EXPECT_TRUE(with("0.123456789").single_positions.empty());
    EXPECT_EQ(with("0.123456789").positions.at(0).x, 0.123456789);
    EXPECT_EQ(with("123456789").positions.at(0).x, 123456789);
}

TEST(Obj, SmoothingGroupsGiveNormals) {
    // Two right angles along the edge from (0,0,0) to (0,1,0): the triangle in z = 0 has twice the area.
    const std::string roof = "v 0 0 0\nv 0 1 0\nv 2 0 0\nv 0 0 1\n";
    const std::string faces = "f 1 3 2\nf 1 2 4\n";
    EXPECT_TRUE(mesh_of_obj(roof + faces).normals.empty());
    EXPECT_TRUE(mesh_of_obj(roof + "s off\n" + faces).normals.empty());
    EXPECT_TRUE(mesh_of_obj(roof + "s 0\n" + faces).normals.empty());
    const MeshData mesh = mesh_of_obj(roof + "s 1\n" + faces);
    const auto normals = mesh.corner_normals(0), second = mesh.corner_normals(1);
    ASSERT_TRUE(normals && second);
    const Vec3 edge = normalize(Vec3{1, 0, 2});  // by the areas
    for (const Float3& n : {normals->at(0), normals->at(2), second->at(0), second->at(1)})
        EXPECT_LT(length(to_vec3(n) - edge), 1e-6);
    EXPECT_EQ(normals->at(1), (Float3{0, 0, 1}));
    EXPECT_EQ(second->at(2), (Float3{1, 0, 0}));

    const MeshData apart = mesh_of_obj(roof + "s 1\nf 1 3 2\ns 2\nf 1 2 4\ns off\nf 2 3 4\n");
    EXPECT_EQ(apart.corner_normals(0)->at(0), (Float3{0, 0, 1})) << "the other face is in another group";
    EXPECT_EQ(apart.corner_normals(1)->at(0), (Float3{1, 0, 0}));
    EXPECT_EQ(apart.normals.corners.at(2), k_flat);

    const MeshData own = mesh_of_obj(roof + "vn 0 1 0\ns 1\nf 1//1 3//1 2//1\nf 1 2 4\n");
    EXPECT_EQ(own.corner_normals(0)->at(0), (Float3{0, 1, 0})) << "normals of the file count";
    EXPECT_EQ(own.corner_normals(1)->at(0), (Float3{1, 0, 0})) << "and their faces do not";

    const MeshData opposite = mesh_of_obj(roof + "s 1\nf 1 3 2\nf 1 2 3\n");
    EXPECT_FALSE(opposite.corner_normals(0)) << "the sum is 0: flat";
}

TEST(Obj, VerticesHaveColors) {
    const MeshData all = mesh_of_obj("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 0.5\nv 9 9 9\nf 1 2 3\n");
    EXPECT_EQ(all.colors.values, (std::vector<Float3>{{1, 0, 0}, {0, 1, 0}, {0, 0, 0.5F}}));
    EXPECT_TRUE(all.colors.corners.empty()) << "the vertex without a color is not used";
    const MeshData some =
        mesh_of_obj("v 9 9 9\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 0.5 1\nf 2 3 4\nf 1 2 3\n");
    EXPECT_EQ(some.corner_values(some.colors, 0)->at(2), (Float3{0, 0, 0.5F}));
    EXPECT_FALSE(some.corner_values(some.colors, 1));
    EXPECT_TRUE(mesh_of_obj("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n").colors.empty()) << "a weight";
}

TEST(Obj, AnObjectsNameIsItsShapes) {
    EXPECT_EQ(scene_of("o a cube\ng side\n" + std::string(k_square_lines) + "f 1 2 3\n").shape_texts.name(0),
              "a cube");
    const Scene several = scene_of("o a\n" + std::string(k_square_lines) + "f 1 2 3\no b\nf 1 3 4\n");
    EXPECT_EQ(several.shapes.size(), 1u);
    EXPECT_EQ(several.shape_texts.name(0), "");
}

TEST(Obj, WhatIsNotDrawnIsNamedOnce) {
    const std::string text =
        std::string(k_square_lines) + "l 1 2\np 1\ncstype bezier\nf 1 2 3\nf 1 2\nmystery 1\nriddle 2\n";
    const Result<Scene> result = load_text(text, "a.obj");
    ASSERT_TRUE(result) << messages(result);
    ASSERT_EQ(result.diagnostics.size(), 3u) << messages(result);
    EXPECT_NE(messages(result).find("a.obj:1:1: warning: 1 faces with fewer"), std::string::npos);
    EXPECT_NE(messages(result).find("a.obj:5:1: warning: glint draws no points, lines"), std::string::npos);
    EXPECT_NE(messages(result).find("a.obj:10:1: warning: glint ignores 'mystery'"), std::string::npos);
}

TEST(Obj, EveryShortenedFileHasAnAnswer) {
    const std::string whole =
        "mtllib a.mtl\no x\n" + std::string(k_square_lines) +
        "vn 0 0 1\nusemtl red\ns 1\nf 1//1 2//1 3//1 4//1\nf 1 2 \\\n3\ns off\nf -1 -2 -3\n";
    for (std::size_t length = 0; length <= whole.size(); ++length) {
        const std::string text = whole.substr(0, length);
        ASSERT_EQ(what_is_wrong(load_text(text, "a.obj"), text), "") << length;
    }
}

TEST(Obj, MistakesAreReportedAtTheirPlace) {
    const auto expect_error = [](const std::string& lines, const std::string& message) {
        const Result<Scene> result = load_text(std::string(k_square_lines) + lines, "a.obj");
        EXPECT_FALSE(result);
        EXPECT_NE(messages(result).find(message), std::string::npos) << messages(result);
    };
    expect_error("v 1 2\n", "a.obj:5:6: error: the line ends here: expected a number from -1e12 to 1e12");
    expect_error("v 1 2 x3\n", "a.obj:5:7: error: expected a number from -1e12 to 1e12, found 'x3'");
    expect_error("v nan 2 3\n", "a.obj:5:3: error: expected a number from -1e12 to 1e12, found 'nan'");
    expect_error("v 1 1e13 3\n", "a.obj:5:5: error: expected a number");
    expect_error("v 1 1 1 0 -1 0\n", "a.obj:5:11: error: expected a number from 0 to 1e12, found '-1'");
    expect_error("vn 0 0\n", "a.obj:5:7: error: the line ends here");
    expect_error("f 1 2 0\n", "a.obj:5:7: error: expected a corner");
    expect_error("f 1 2 3/x\n", "a.obj:5:7: error: expected a corner");
    expect_error("f 1 2 99999999999999999999\n", "a.obj:5:7: error: expected a corner");
    expect_error("f 1 2 5\n", "a.obj:5:7: error: expected the number of a vertex from 1 to 4, found 5");
    expect_error("f 1 2 4294967297\n", "expected the number of a vertex from 1 to 4, found 4294967297");
    expect_error("f 1 2 -5\n",
                 "a.obj:5:7: error: expected the number of a vertex before this line, of which there are 4, "
                 "found '-5'");
    expect_error("f 1//1 2//1 3//2\nvn 0 0 1\n",
                 "a.obj:5:13: error: expected the number of a normal from 1 to 1, found 2");
    expect_error("f 1//-1 2 3\n", "a.obj:5:3: error: expected the number of a normal before");
    expect_error("v 1e12 0 0\nf 1 2 5\n", "a.obj:1:1: error: the mesh is so large that a camera");
    expect_error("f 1 2\n", "no faces with three vertices");
    expect_error("", "no faces with three vertices");
    expect_error("s\n", "a.obj:5:2: error: the line ends here: expected a smoothing group, or `off`");
    expect_error("usemtl\n", "a.obj:5:7: error: the line ends here: expected the name of a material");
    const Result<Scene> two = load_text("v 1\nv x\nf 1 2 3\n", "a.obj");
    EXPECT_EQ(two.diagnostics.size(), 2u) << "reading goes on after a line with a mistake: " << messages(two);
}

TEST(Obj, MemoryIsAskedForBeforeItIsAllocated) {
    std::string text(k_square_lines);
    text += "s 1\n";
    for (int i = 0; i < 400'000; ++i) text += "f 1 2 3\n";
    LoadOptions options;
    options.max_memory = 16u << 20;
    const Result<Scene> result = load_text(text, "a.obj", options);
    EXPECT_FALSE(result);
    EXPECT_EQ(result.code, ErrorCode::out_of_memory) << messages(result);
    EXPECT_TRUE(load_text(text, "a.obj"));
}

}  // namespace
}  // namespace glint::test
