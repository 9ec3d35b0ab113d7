// SPDX-License-Identifier: Apache-2.0
// Shapes that are put in a World and taken out give the same bits as preparing the new scene.
#include <algorithm>
#include <numeric>

#include "trace/worlds.h"
#include "world/geometry/edit_index.h"
#include "world/geometry/primitive_bounds-inl.h"
#include "world/same_pictures.h"

namespace glint::test {
namespace {

using Indices = std::vector<std::uint32_t>;

Scene lit(Scene scene) {
    scene.settings.width = 48;
    scene.settings.height = 36;
    scene.camera.position = {12, 7, 21};
    scene.camera.look_at = {0, 0, 0};
    scene.lights.push_back(Light{});
    scene.lights[0].position = {10, 20, 10};
    scene.materials.assign(3, Material{});
    scene.materials[1].diffuse = {0.9, 0.1, 0.3};
    scene.materials[1].mirror = 0.4;
    scene.materials[2].transmission = 0.5;
    scene.materials[2].ior = 1.3;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
        scene.shapes[i].material = i % 4 == 3 ? k_none : static_cast<std::uint32_t>(i % 4);
    return scene;
}

// Two shapes with one mesh.
void add_mesh(Scene& scene, Random& random) {
    MeshData mesh;
    for (std::uint32_t i = 0; i < 20; ++i) {
        for (int corner = 0; corner < 3; ++corner) mesh.positions.push_back(point_in_cube(random, 3));
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    scene.meshes.push_back(std::make_shared<const MeshData>(std::move(mesh)));
    scene.transforms.push_back(translation({4, -3, 2}));
    scene.add(Mesh{0}, 1);
    scene.add(Mesh{0}, 2, static_cast<std::uint32_t>(scene.transforms.size() - 1));
}

// Colors are in step with the shapes.
void erase(Scene& scene, const Indices& removed) {
    for (auto at = removed.rbegin(); at != removed.rend(); ++at) {
        scene.shapes.erase(scene.shapes.begin() + *at);
        if (*at < scene.shape_colors.size()) scene.shape_colors.erase(scene.shape_colors.begin() + *at);
    }
}

// `count` different numbers below `end`, sorted.
Indices choose(Random& random, std::size_t end, std::size_t count) {
    Indices all(end);
    std::iota(all.begin(), all.end(), 0u);
    for (std::size_t i = 0; i < count; ++i) std::swap(all[i], all[i + random.bits() % (end - i)]);
    all.resize(count);
    std::sort(all.begin(), all.end());
    return all;
}

// Puts copies of shapes of any kind, moved, between those of the scene.
Indices insert(Scene& scene, Random& random, std::size_t count) {
    const Scene source = lit(random_scene(random, 30));
    const Indices added = choose(random, scene.shapes.size() + count, count);
    for (const std::uint32_t to : added) {
        const Shape& shape = source.shapes[random.bits() % source.shapes.size()];
        Shape copy = shape;
        const auto add = [&]<class T>(const T& parameters) {
            scene.get<T>().push_back(parameters);
            copy.index = static_cast<std::uint32_t>(scene.get<T>().size() - 1);
        };
        switch (shape.kind) {
            case ShapeKind::polygon:
            case ShapeKind::mesh:
            case ShapeKind::solid:  // they are built again: see below
            case ShapeKind::quadric:
            case ShapeKind::quartic:
                copy.kind = ShapeKind::sphere;
                add(Sphere{point_in_cube(random, 10), 0.7});
                break;
#define GLINT_KIND(Type, word)                \
    case ShapeKind::word:                     \
        add(source.get<Type>()[shape.index]); \
        break;
                GLINT_KIND(Sphere, sphere)
                GLINT_KIND(Plane, plane)
                GLINT_KIND(Cylinder, cylinder)
                GLINT_KIND(Cone, cone)
                GLINT_KIND(Disc, disc)
                GLINT_KIND(Box, box)
                GLINT_KIND(Torus, torus)
                GLINT_KIND(Triangle, triangle)
                GLINT_KIND(SmoothTriangle, smooth_triangle)
#undef GLINT_KIND
        }
        if (copy.transform != k_none) {
            scene.transforms.push_back(source.transforms[copy.transform]);
            copy.transform = static_cast<std::uint32_t>(scene.transforms.size() - 1);
        }
        scene.shapes.insert(scene.shapes.begin() + to, copy);
        if (to <= scene.shape_colors.size()) {
            ShapeColor color;
            if (below(random, 2) == 0) color = {0.5f, 0.25f, static_cast<float>(to % 8) / 8};
            scene.shape_colors.insert(scene.shape_colors.begin() + to, color);
        }
    }
    return added;
}

ShapeEdit splice(World& world, const Scene& scene, const Indices& removed, const Indices& added) {
    const Result<ShapeEdit> result = splice_shapes(world, scene, removed, added, {.threads = 2});
    EXPECT_TRUE(result.ok()) << to_string(result);
    return result.value_or(ShapeEdit::none);
}

void expect_same_hits(const World& a, const World& b, Random& random) {
    std::vector<Ray> rays;
    for (int i = 0; i < 500; ++i) rays.push_back({point_in_cube(random, 15), unit_direction(random)});
    const auto of_a = nearest_hits(a, rays).value(), of_b = nearest_hits(b, rays).value();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(of_a[i].shape, of_b[i].shape);
        EXPECT_EQ(of_a[i].t, of_b[i].t);
        EXPECT_EQ(of_a[i].normal, of_b[i].normal);
    }
}

// Each slot is in one leaf, of its class, and boxes are exact.
void expect_whole(const World& world) {
    const PackedGeometry& geometry = *world.parts().geometry;
    std::vector<int> leaves(geometry.bounded);
    const auto bounds = [&](std::uint32_t first, std::uint32_t count) {
        Aabb box;
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
            ++leaves[slot];
            EXPECT_EQ(&geometry.class_of(slot), &geometry.class_of(first));
            box.add(HWY_NAMESPACE::primitive_bounds(geometry, slot));
        }
        return box;
    };
    Bvh exact = geometry.bvh;
    refit_all(exact, bounds, 1);
    EXPECT_TRUE(std::all_of(leaves.begin(), leaves.end(), [](int n) { return n == 1; }));
    for (std::size_t n = 0; n < exact.nodes.size(); ++n) {
        for (int c = 0; c < k_bvh_width; ++c) {
            for (int a = 0; a < 3; ++a) {
                EXPECT_EQ(exact.nodes[n].lo[a][c], geometry.bvh.nodes[n].lo[a][c]) << n << ' ' << c;
                EXPECT_EQ(exact.nodes[n].hi[a][c], geometry.bvh.nodes[n].hi[a][c]) << n << ' ' << c;
            }
        }
    }
    for (int a = 0; a < 3; ++a) {
        EXPECT_EQ(exact.bounds.lo[a], geometry.bvh.bounds.lo[a]);
        EXPECT_EQ(exact.bounds.hi[a], geometry.bvh.bounds.hi[a]);
    }
}

TEST(SpliceShapes, RandomSequencesOfAllKinds) {
    Random random(301);
    int spliced = 0;
    for (int round = 0; round < 12; ++round) {
        Scene scene = lit(random_scene(random, 100 + 200 * (round % 3)));
        if (round % 3 == 1) add_mesh(scene, random);
        if (round % 2 == 1)
            for (std::uint32_t i = 0; i < scene.shapes.size(); i += 3)
                scene.set_shape_color(i, Color{0, 0.5, 1});
        scene.shape_colors.resize(round % 2 == 1 ? scene.shapes.size() : 0);
        scene.conventions.facing = round % 3 == 0 ? Facing::open : Facing::all;
        scene.conventions.cones = round % 4 != 3;
        World world = *make_world(scene);
        for (int step = 0; step < 12; ++step) {
            SCOPED_TRACE(testing::Message() << round << ' ' << step);
            const World copy = world;
            const Scene old = scene;
            const Indices removed = choose(random, scene.shapes.size(), random.bits() % 5);
            erase(scene, removed);
            const Indices added = insert(scene, random, random.bits() % 5);
            const ShapeEdit edit = splice(world, scene, removed, added);
            if (removed.empty() && added.empty()) {
                EXPECT_EQ(edit, ShapeEdit::none);
            } else {
                EXPECT_TRUE(edit == ShapeEdit::spliced || edit == ShapeEdit::rebuilt);
            }
            if (edit == ShapeEdit::spliced) ++spliced;
            expect_whole(world);
            const World wanted = *make_world(scene);
            EXPECT_TRUE(draw_the_same(world, wanted));
            expect_same_hits(world, wanted, random);
            EXPECT_TRUE(draw_the_same(copy, *make_world(old)));
            // Edits of the spliced World find their shapes.
            const Indices changed = choose(random, scene.shapes.size(), 3);
            for (const std::uint32_t shape : changed)
                if (scene.shapes[shape].kind == ShapeKind::sphere)
                    scene.get<Sphere>()[scene.shapes[shape].index] = {point_in_cube(random, 9), 0.6};
            EXPECT_TRUE(edit_shapes(world, scene, changed).ok());
            EXPECT_TRUE(draw_the_same(world, *make_world(scene)));
        }
    }
    EXPECT_GT(spliced, 100);
}

Scene cloud(Random& random, int count) {
    Scene scene;
    for (int i = 0; i < count; ++i) scene.add(Sphere{point_in_cube(random, 10), 0.2});
    return lit(std::move(scene));
}

TEST(SpliceShapes, OneByOneUntilItIsRebuilt) {
    Random random(302);
    Scene scene = cloud(random, 300);
    World world = *make_world(scene);
    int rebuilt = 0;
    for (int i = 0; i < 300; ++i) {
        // All at one place, far from the others.
        scene.add(Sphere{Vec3{30, 0, 0} + point_in_cube(random, 0.1), 0.1}, 1);
        const ShapeEdit edit =
            splice(world, scene, {}, {static_cast<std::uint32_t>(scene.shapes.size() - 1)});
        rebuilt += edit == ShapeEdit::rebuilt ? 1 : 0;
    }
    EXPECT_LT(rebuilt, 20);
    expect_whole(world);
    EXPECT_TRUE(draw_the_same(world, *make_world(scene)));
    while (scene.shapes.size() > 20) {
        const Indices removed = {static_cast<std::uint32_t>(random.bits() % scene.shapes.size())};
        erase(scene, removed);
        splice(world, scene, removed, {});
    }
    expect_whole(world);
    EXPECT_TRUE(draw_the_same(world, *make_world(scene)));
}

TEST(SpliceShapes, CostIsMeasuredFromTheBuild) {
    Random random(303);
    Scene scene = cloud(random, 4000);
    World world = *make_world(scene);
    // Few at a time exchange their places until the hierarchy would be too slow.
    bool is_rebuilt = false;
    int steps = 0;
    for (; steps < 100 && !is_rebuilt; ++steps) {
        const Indices removed = choose(random, scene.shapes.size(), 1), changed = choose(random, 3999, 5);
        erase(scene, removed);
        is_rebuilt = splice(world, scene, removed, {}) == ShapeEdit::rebuilt;
        scene.add(Sphere{point_in_cube(random, 10), 0.2});
        is_rebuilt = splice(world, scene, {}, {3999}) == ShapeEdit::rebuilt || is_rebuilt;
        for (const std::uint32_t shape : changed)
            scene.get<Sphere>()[scene.shapes[shape].index].center = point_in_cube(random, 10);
        is_rebuilt = edit_shapes(world, scene, changed).value() == ShapeEdit::rebuilt || is_rebuilt;
    }
    EXPECT_TRUE(is_rebuilt);
    EXPECT_GT(steps, 1) << "not at once";
    EXPECT_TRUE(draw_the_same(world, *make_world(scene)));
}

TEST(SpliceShapes, WhatIsBuiltAgain) {
    Random random(304);
    const Scene original = cloud(random, 40);
    const auto expect_rebuilt = [&](const char* what, const Indices& removed, const auto& change) {
        SCOPED_TRACE(what);
        Scene scene = original;
        World world = *make_world(scene);
        erase(scene, removed);
        const std::size_t kept = scene.shapes.size();
        change(scene);
        Indices added(scene.shapes.size() - kept);
        std::iota(added.begin(), added.end(), static_cast<std::uint32_t>(kept));
        EXPECT_EQ(splice(world, scene, removed, added), ShapeEdit::rebuilt);
        EXPECT_TRUE(draw_the_same(world, *make_world(scene)));
    };
    const auto nothing = [](Scene&) {};
    expect_rebuilt("many", {0, 1, 2, 3, 4, 5}, nothing);
    expect_rebuilt("a polygon", {}, [](Scene& s) {
        s.polygon_vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        s.add(Polygon{0, 4});
    });
    expect_rebuilt("a mesh", {}, [](Scene& s) {
        MeshData mesh;
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        mesh.triangles = {{0, 1, 2}};
        s.meshes.push_back(std::make_shared<const MeshData>(std::move(mesh)));
        s.add(Mesh{0});
    });
    Scene planes;
    for (int i = 0; i < 20; ++i) planes.add(Plane{{0, -1.0 * i, 0}, {0, 1, 0}});
    planes = lit(std::move(planes));
    World world = *make_world(planes);
    planes.add(Sphere{});
    EXPECT_EQ(splice(world, planes, {}, {20}), ShapeEdit::rebuilt) << "the first bounded shape";
    erase(planes, {20});
    EXPECT_EQ(splice(world, planes, {20}, {}), ShapeEdit::rebuilt) << "the last bounded shape";
    EXPECT_TRUE(draw_the_same(world, *make_world(planes)));
}

TEST(SpliceShapes, OthersKeepTheirMaterial) {
    Random random(305);
    Scene scene = cloud(random, 40);
    World world = *make_world(scene);
    const std::uint32_t shapes[] = {5, 7};
    ASSERT_TRUE(assign_material(world, shapes, 1));
    Scene expected = scene;
    expected.shapes[5].material = expected.shapes[7].material = 1;
    erase(scene, {0, 7});
    erase(expected, {0, 7});
    EXPECT_EQ(splice(world, scene, {0, 7}, {}), ShapeEdit::spliced);
    EXPECT_TRUE(draw_the_same(world, *make_world(expected)));
}

}  // namespace
}  // namespace glint::test
