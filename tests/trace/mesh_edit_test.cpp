// SPDX-License-Identifier: Apache-2.0
// Edits of meshes give the picture of a new World: of their places, content, colors and materials.
#include <gtest/gtest.h>

#include "trace/pictures.h"
#include "trace/worlds.h"

namespace glint::test {
namespace {

Float3 color(Random& random) {
    const auto channel = [&] { return static_cast<float>(random.uniform(0, 1)); };
    const float r = channel(), g = channel();
    return {r, g, channel()};
}

// `count` triangles around the origin.
std::shared_ptr<const MeshData> mesh_of(Random& random, std::size_t count, bool smooth, bool colored) {
    MeshData mesh;
    for (std::size_t i = 0; i < 3 * count; ++i) {
        mesh.single_positions.push_back(to_single(point_in_cube(random, 2)));
        if (smooth) mesh.normals.values.push_back(to_single(unit_direction(random)));
        if (colored) mesh.colors.values.push_back(color(random));
    }
    for (std::uint32_t i = 0; i < count; ++i) mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    return std::make_shared<const MeshData>(std::move(mesh));
}

// Three places of one mesh, one of another, and a floor.
Scene scene_of(Random& random) {
    Scene scene;
    set_size(scene, 60, 50);
    scene.camera.position = {0, 1, 16};
    scene.camera.look_at = {0, 0, 0};
    scene.lights = {ambient_light({0.3, 0.3, 0.3}), point_light({5, 9, 19})};
    for (const double red : {0.2, 0.9}) {
        Material material;
        material.diffuse = {red, 0.5, 0.4};
        add_material(scene, material);
    }
    scene.meshes = {mesh_of(random, 20, false, false), mesh_of(random, 12, true, false)};
    scene.transforms = {translation({-4, 0, 0}), translation({4, 0, 0}), translation({0, 3, 0}),
                        translation({0, -3, 1})};
    for (std::uint32_t i = 0; i < 3; ++i) scene.add(Mesh{0}, i == 2 ? 1 : 0, i);
    scene.add(Mesh{1}, 1, 3);
    scene.add(Plane{{0, -5, 0}, {0, 1, 0}}, 0);
    return scene;
}

class MeshEdit : public ::testing::Test {
  protected:
    void SetUp() override {
        world = make_world(scene);
        ASSERT_TRUE(world);
    }
    void expect_picture_of_edit(std::vector<std::uint32_t> changed,
                                ShapeEdit expected = ShapeEdit::refitted) {
        const World before = *world;
        const std::vector<float> old_picture = render_world(before).rgb;
        const Result<ShapeEdit> edit = edit_shapes(*world, scene, changed);
        ASSERT_TRUE(edit) << to_string(edit);
        EXPECT_EQ(*edit, expected);
        const std::vector<float> picture = render_world(*world).rgb;
        EXPECT_EQ(picture, render_scene(scene).rgb);
        EXPECT_NE(picture, old_picture);
        EXPECT_EQ(render_world(before).rgb, old_picture) << "a copy of the World is kept";
    }
    Random random{41};
    Scene scene = scene_of(random);
    std::optional<World> world;
};

TEST_F(MeshEdit, MovesOnePlaceOfThree) {
    scene.transforms[1] = translation({4, 1, 2});
    expect_picture_of_edit({1});
    scene.shapes[0].transform = 3;
    expect_picture_of_edit({0});
}

TEST_F(MeshEdit, ReplacesTheContentInAllPlaces) {
    for (const std::size_t count : {20, 3, 50}) {
        scene.meshes[0] = mesh_of(random, count, count == 3, false);
        expect_picture_of_edit({0, 1, 2});
    }
}

TEST_F(MeshEdit, GivesColorsAndTakesThemAway) {
    for (const bool colored : {true, false, true}) {
        scene.meshes[0] = mesh_of(random, 20, false, colored);
        expect_picture_of_edit({0, 1, 2});
    }
}

TEST_F(MeshEdit, GivesOnePlaceAnotherMesh) {
    scene.get<Mesh>()[1].mesh = 1;
    expect_picture_of_edit({1});
    scene.meshes.push_back(mesh_of(random, 30, true, true));
    scene.get<Mesh>()[2].mesh = 2;
    expect_picture_of_edit({2});
}

TEST_F(MeshEdit, ChangesTheMaterialOfOnePlace) {
    scene.shapes[1].material = 1;
    expect_picture_of_edit({1});
    // Those that are not edited keep theirs.
    scene.meshes[0] = mesh_of(random, 20, true, false);
    expect_picture_of_edit({0, 1, 2});
    EXPECT_TRUE(assign_material(*world, std::vector<std::uint32_t>{3}, 0));
    scene.shapes[3].material = 0;
    scene.transforms[0] = translation({-4, 2, 0});
    expect_picture_of_edit({0});
}

TEST_F(MeshEdit, BuildsANewHierarchyForAnotherKind) {
    scene.get<Sphere>().push_back({{0, 0, 0}, 2});
    scene.shapes[3].kind = ShapeKind::sphere;
    scene.shapes[3].index = 0;
    expect_picture_of_edit({3}, ShapeEdit::rebuilt);
}

TEST_F(MeshEdit, RefusesAMeshThatIsNotThere) {
    scene.get<Mesh>()[1].mesh = 7;
    const std::vector<float> picture = render_world(*world).rgb;
    EXPECT_FALSE(edit_shapes(*world, scene, std::vector<std::uint32_t>{1}));
    EXPECT_EQ(render_world(*world).rgb, picture);
}

}  // namespace
}  // namespace glint::test
