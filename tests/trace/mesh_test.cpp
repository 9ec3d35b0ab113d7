// SPDX-License-Identifier: Apache-2.0
// Meshes have a hierarchy of their own, which shapes share.
#include <gtest/gtest.h>

#include "trace/pictures.h"
#include "trace/worlds.h"

namespace glint::test {
namespace {

std::uint32_t corner(Random& random) { return static_cast<std::uint32_t>(below(random, 40)); }

// Triangles with common vertices around the origin; every third vertex has no normal, if any has.
MeshData random_mesh(Random& random, bool smooth, bool single) {
    MeshData mesh;
    for (int i = 0; i < 40; ++i) {
        const Vec3 p = point_in_cube(random, 3), n = unit_direction(random) * random.uniform(0.5, 2);
        const auto narrow = [](Vec3 v) {
            return Float3{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
        };
        if (single) {
            mesh.single_positions.push_back(narrow(p));
        } else {
            mesh.positions.push_back(p);
        }
        if (smooth) mesh.normals.values.push_back(i % 3 == 0 ? Float3{} : narrow(n));
    }
    for (int i = 0; i < 60; ++i) mesh.triangles.push_back({corner(random), corner(random), corner(random)});
    return mesh;
}

void add_triangles(Scene& scene, const MeshData& mesh, std::uint32_t material, std::uint32_t transform) {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto [a, b, c] = mesh.triangles[i];
        const Triangle flat{{mesh.position(a), mesh.position(b), mesh.position(c)}};
        if (const auto normals = mesh.corner_normals(i)) {
            const auto& [na, nb, nc] = *normals;
            scene.add(SmoothTriangle{{flat.vertices[0], flat.vertices[1], flat.vertices[2]},
                                     {to_vec3(na), to_vec3(nb), to_vec3(nc)}},
                      material, transform);
        } else {
            scene.add(flat, material, transform);
        }
    }
}

// Meshes under maps, and the same as triangles of the world.
struct Pair {
    Scene meshes, triangles;
};
Pair random_pair(Random& random, int i) {
    Scene whole;
    set_size(whole, 90, 70);
    whole.camera.position = {0, 1, 14};
    whole.camera.look_at = {0, 0, 0};
    whole.lights = {ambient_light({0.3, 0.3, 0.3}), point_light({5, 9, 19})};
    Material shiny;
    shiny.mirror = 0.3;
    shiny.specular = {0.5, 0.5, 0.5};
    add_material(whole, shiny);
    Scene parts = whole;
    const auto mesh = std::make_shared<const MeshData>(random_mesh(random, i % 2 == 0, i % 3 == 0));
    whole.meshes.push_back(mesh);
    for (int copy = 0; copy < 3; ++copy) {
        std::uint32_t transform = k_none;
        if (copy > 0) {
            transform = static_cast<std::uint32_t>(whole.transforms.size());
            whole.transforms.push_back(random_transform(random, 5));
            parts.transforms.push_back(whole.transforms.back());
        }
        const std::uint32_t material = copy == 1 ? 0 : k_none;
        whole.add(Mesh{0}, material, transform);
        add_triangles(parts, *mesh, material, transform);
    }
    return {whole, parts};
}

// The map of rays rounds otherwise than the map of vertices: at edges another triangle may be hit. Flat
// triangles: vertex normals are interpolated before they are mapped, those of smooth triangles after it.
TEST(Mesh, IsThePictureOfItsTriangles) {
    Random random(36);
    for (int i = 0; i < 12; ++i) {
        const Pair pair = random_pair(random, 2 * i + 1);
        const Image a = render_scene(pair.meshes), b = render_scene(pair.triangles);
        std::size_t far = 0;
        for (std::size_t k = 0; k < a.rgb.size(); ++k) far += std::abs(a.rgb[k] - b.rgb[k]) > 1e-5;
        EXPECT_LE(far, a.rgb.size() / 1000) << i;
    }
}

// Under a map that mirrors, the front side of a triangle moves with it: of flat and smooth ones, of a mesh
// and without one. Each has one normal at its corners, so that the order of map and interpolation is the
// same.
TEST(Mesh, IsThePictureOfItsMirroredSmoothTriangles) {
    for (const Facing facing : {Facing::none, Facing::open, Facing::all, Facing::winding}) {
        Scene whole;
        set_size(whole, 60, 50);
        whole.conventions.facing = facing;
        whole.camera.position = {0, 1, 14};
        whole.camera.look_at = {0, 0, 0};
        whole.lights = {ambient_light({0.3, 0.3, 0.3}), point_light({5, 9, 19})};
        whole.transforms = {scaling({-1, 1, 1})};
        MeshData mesh;
        for (int i = 0; i < 6; ++i) {
            const double x = i * 1.5 - 3.75, side = i % 2 == 0 ? 1 : -1;
            mesh.positions.insert(mesh.positions.end(), {{x, -2, 0}, {x + 1, -2, 0.5}, {x, 2, i % 3 - 1.0}});
            for (int k = 0; k < 3; ++k) mesh.normals.values.push_back(to_single({0, 0, side}));
            const auto first = static_cast<std::uint32_t>(3 * i), turned = static_cast<std::uint32_t>(i / 3);
            mesh.triangles.push_back({first, first + 1 + turned, first + 2 - turned});
        }
        Scene parts = whole;
        add_triangles(parts, mesh, k_none, 0);
        whole.meshes.push_back(std::make_shared<const MeshData>(mesh));
        whole.add(Mesh{0}, k_none, 0);
        EXPECT_EQ(render_scene(whole).rgb, render_scene(parts).rgb) << static_cast<int>(facing);
    }
}

TEST(Mesh, IsTheSameInAnyPartOfThePicture) {
    Random random(38);
    for (int i = 0; i < 4; ++i) {
        const std::optional<World> world = make_world(random_pair(random, i).meshes);
        ASSERT_TRUE(world);
        expect_same_crops(*world, 12);
    }
}

// Of surfaces at one t the first in the scene is hit, and of a mesh's triangles the first of them: in any
// part of the picture.
TEST(Mesh, TiesAreDecidedByTheOrderOfTheScene) {
    const auto square = [](double size, double at) {
        MeshData mesh;
        mesh.positions = {{at, 0, at}, {at + size, 0, at}, {at + size, 0, at + size}, {at, 0, at + size}};
        mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
        return std::make_shared<const MeshData>(mesh);
    };
    Scene scene;
    set_size(scene, 90, 70);
    scene.camera.position = {0, 3, -6};
    scene.camera.look_at = {0, 0, 0};
    Light ambient;
    ambient.kind = LightKind::ambient;
    scene.lights = {ambient};
    scene.meshes = {square(3, -2), square(3, -1)};
    for (const Color color : {Color{1, 0, 0}, Color{0, 1, 0}, Color{0, 0, 1}}) {
        Material material;
        material.color = material.ambient = color;
        material.mirror = color.b > 0 ? 0.5 : 0;
        scene.materials.push_back(material);
    }
    Scene polygons = scene;
    polygons.meshes.clear();
    scene.add(Mesh{0}, 0);
    scene.add(Plane{{0, 0, 0}, {0, 1, 0}}, 1);
    scene.add(Mesh{1}, 2);
    scene.add(Sphere{{0, 1.5, 1}, 1}, 2);
    for (const std::uint32_t index : {0u, 1u}) {
        const MeshData& mesh = *scene.meshes[index];
        if (index == 1) polygons.add(Plane{{0, 0, 0}, {0, 1, 0}}, 1);
        for (const TriangleCorners& t : mesh.triangles) {
            polygons.add(Triangle{{mesh.position(t[0]), mesh.position(t[1]), mesh.position(t[2])}},
                         index == 0 ? 0 : 2);
        }
    }
    polygons.add(Sphere{{0, 1.5, 1}, 1}, 2);
    const std::optional<World> world = make_world(scene);
    ASSERT_TRUE(world);
    expect_same_crops(*world, 12);
    EXPECT_EQ(render_world(*world).rgb, render_scene(polygons).rgb);
}

TEST(Mesh, TwoCopiesAreAsOneMeshUsedTwice) {
    Random random(39);
    Scene one = random_pair(random, 0).meshes, two = one;
    two.meshes.push_back(std::make_shared<const MeshData>(*two.meshes[0]));
    two.get<Mesh>()[1].mesh = 1;
    EXPECT_EQ(render_scene(one).rgb, render_scene(two).rgb);
}

}  // namespace
}  // namespace glint::test
