// SPDX-License-Identifier: Apache-2.0
// Closed meshes as operands of solids.
#include <gtest/gtest.h>

#include "trace/random_solid.h"
#include "trace/rays.h"
#include "trace/worlds.h"
#include "world/geometry/mesh_crossings.h"
#include "world/world.h"

namespace glint::test {
namespace {

// The cube from -1 to 1, with n x n squares of two triangles on each side.
Shape grid_cube(Scene& scene, std::uint32_t n) {
    auto mesh = std::make_shared<MeshData>();
    for (const double side : {-1.0, 1.0}) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto first = static_cast<std::uint32_t>(mesh->positions.size());
            for (std::uint32_t v = 0; v <= n; ++v) {
                for (std::uint32_t u = 0; u <= n; ++u) {
                    const double a = (2.0 * u - n) / n, b = (2.0 * v - n) / n * side;
                    mesh->positions.push_back(axis == 0   ? Vec3{side, a, b}
                                              : axis == 1 ? Vec3{b, side, a}
                                                          : Vec3{a, b, side});
                }
            }
            for (std::uint32_t v = 0; v < n; ++v) {
                for (std::uint32_t u = 0; u < n; ++u) {
                    const std::uint32_t at = first + v * (n + 1) + u;
                    mesh->triangles.push_back({at, at + 1, at + n + 2});
                    mesh->triangles.push_back({at, at + n + 2, at + n + 1});
                }
            }
        }
    }
    scene.meshes.push_back(std::move(mesh));
    return shape_of(scene, Mesh{static_cast<std::uint32_t>(scene.meshes.size() - 1)});
}

World world_of(Scene& scene, const Shape& mesh) {
    scene.shapes.push_back(mesh);
    combine_last(scene, SolidOperation::merge, static_cast<std::uint32_t>(scene.shapes.size() - 1));
    return *make_world(scene);
}

std::vector<MeshCrossing> crossings(const World& world, Vec3 origin, Vec3 direction) {
    const PackedGeometry& geometry = *world.parts().geometry;
    return find_mesh_crossings(geometry, geometry.first_operand(), origin, direction);
}

// Lines along the grid meet its vertices, edges and diagonals exactly.
TEST(MeshSolids, LinesThroughVerticesAndEdgesCrossOnce) {
    Scene scene;
    const World world = world_of(scene, grid_cube(scene, 4));
    int inside = 0, tangents = 0;
    for (int i = -6; i <= 6; ++i) {
        for (int k = -6; k <= 6; ++k) {
            const double a = i / 4.0, b = k / 4.0;
            for (const auto& [origin, direction] : {std::pair{Vec3{a, b, 5}, Vec3{0, 0, -1}},
                                                    {Vec3{5, a, b}, Vec3{-2, 0, 0}},
                                                    {Vec3{a, -5, b}, Vec3{0, 0.5, 0}}}) {
                const auto found = crossings(world, origin, direction);
                const double most = std::max(std::fabs(a), std::fabs(b));
                if (most > 1) {
                    EXPECT_TRUE(found.empty()) << a << ' ' << b;
                } else if (most < 1) {
                    ++inside;
                    ASSERT_EQ(found.size(), 2u) << a << ' ' << b;
                    EXPECT_NEAR(found[0].t * length(direction), 4, 1e-12);
                    EXPECT_NEAR(found[1].t * length(direction), 6, 1e-12);
                } else {
                    ++tangents;
                    EXPECT_EQ(found.size() % 2, 0u);
                }
            }
            // Through the cube's own edges, and along the diagonals of its squares.
            const auto diagonal = crossings(world, {a - 3, -3, b}, {1, 1, 0});
            EXPECT_EQ(diagonal.size() % 2, 0u);
            const auto space = crossings(world, {a - 3, b - 3, -3}, {1, 1, 1});
            EXPECT_EQ(space.size() % 2, 0u);
            if (std::fabs(a) < 0.5 && std::fabs(b) < 0.5) {
                EXPECT_EQ(space.size(), 2u);
            }
        }
    }
    EXPECT_EQ(inside, 3 * 7 * 7);
    EXPECT_EQ(tangents, 3 * (9 * 9 - 7 * 7));
}

// Also along the box's edges and faces, and from far away.
TEST(MeshSolids, RandomLinesCrossAnEvenNumberOfTimes) {
    Random random(77);
    Scene scene;
    const World world = world_of(scene, grid_cube(scene, 3));
    for (int i = 0; i < 20000; ++i) {
        const double far = i % 3 == 0 ? 1e5 : 3;
        const Vec3 target = point_in_cube(random, 1.2), origin = unit_direction(random) * far;
        const auto found = crossings(world, origin, target - origin);
        ASSERT_TRUE(found.empty() || found.size() == 2);
        if (std::max({std::fabs(target.x), std::fabs(target.y), std::fabs(target.z)}) < 0.999) {
            ASSERT_EQ(found.size(), 2u);
            EXPECT_LT(found[0].t, 1);
            EXPECT_GT(found[1].t, 1);
        }
    }
}

// The mesh of a shape, moved twice: by its own transform and by the solid's.
TEST(MeshSolids, TransformsApplyOneAfterTheOther) {
    Scene scene;
    Affine twice, up;
    for (int a = 0; a < 3; ++a) twice.m[a][a] = 2;
    up.m[1][3] = 5;
    scene.transforms = {twice, up};
    Shape mesh = octahedron(scene, {0, 0, 0}, 1, false);
    mesh.transform = 0;
    scene.shapes.push_back(mesh);
    combine_last(scene, SolidOperation::merge, 0, k_none, 1);
    const World world = *make_world(scene);
    const Ray ray{{0.1, 5.1, 9}, {0, 0, -1}, 0};
    const auto hits = nearest_hits(world, {&ray, 1}, 1);
    ASSERT_TRUE(hits.ok());
    EXPECT_NEAR(hits->front().t, 9 - 1.8, 1e-12);
    EXPECT_GT(hits->front().normal.z, 0.5);
}

// They would not be turned with the triangles.
TEST(MeshSolids, AMeshWithNormalsIsWoundOutwards) {
    for (const bool is_inside_out : {false, true}) {
        Scene scene;
        scene.shapes.push_back(octahedron(scene, {0, 0, 0}, 1, is_inside_out));
        auto mesh = std::make_shared<MeshData>(*scene.meshes[0]);
        for (const Vec3& corner : mesh->positions) mesh->normals.values.push_back(to_single(corner));
        scene.meshes[0] = mesh;
        combine_last(scene, SolidOperation::merge, 0);
        const std::vector<Diagnostic> found = validate(scene);
        ASSERT_EQ(found.size(), 1u);  // else that the scene has no lights
        EXPECT_EQ(found[0].message.find("found them clockwise") != std::string::npos, is_inside_out)
            << found[0].message;
    }
}

TEST(MeshSolids, AnOpenMeshIsRefused) {
    for (const std::size_t left_out : {std::size_t{0}, std::size_t{1}}) {
        Scene scene;
        const Shape mesh = octahedron(scene, {0, 0, 0}, 1, false);
        auto changed = std::make_shared<MeshData>(*scene.meshes[0]);
        // A triangle less, or one that is turned.
        if (left_out == 0)
            changed->triangles.pop_back();
        else
            std::swap(changed->triangles[3][0], changed->triangles[3][1]);
        scene.meshes[0] = changed;
        scene.shapes.push_back(mesh);
        combine_last(scene, SolidOperation::inverse, 0);
        const std::vector<Diagnostic> found = validate(scene);
        ASSERT_EQ(found.size(), 1u);
        EXPECT_NE(found[0].message.find("operand 1: expected a closed mesh"), std::string::npos)
            << found[0].message;
    }
}

}  // namespace
}  // namespace glint::test
