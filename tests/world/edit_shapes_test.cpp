// SPDX-License-Identifier: Apache-2.0
// Edited shapes of a World give the same bits as preparing the scene again, refitted or rebuilt.
#include <algorithm>
#include <numeric>
#include <thread>

#include "trace/worlds.h"
#include "world/geometry/edit_index.h"
#include "world/geometry/primitive_bounds-inl.h"
#include "world/same_pictures.h"

namespace glint::test {
namespace {

World world_of(const Scene& scene) { return *make_world(scene); }

std::vector<std::uint32_t> all_of(const Scene& scene) {
    std::vector<std::uint32_t> all(scene.shapes.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

ShapeEdit edit(World& world, const Scene& scene, std::span<const std::uint32_t> changed, int threads = 1) {
    const Result<ShapeEdit> result = edit_shapes(world, scene, changed, {.threads = threads});
    EXPECT_TRUE(result.ok()) << to_string(result);
    EXPECT_TRUE(result.diagnostics.empty());
    return result.value_or(ShapeEdit::none);
}
ShapeEdit edit(World& world, const Scene& scene, std::initializer_list<std::uint32_t> changed) {
    return edit(world, scene, std::span(changed.begin(), changed.size()));
}

// A camera outside, and lights and materials that show every normal, shadow and mirror.
Scene lit(Scene scene, double half) {
    scene.settings.width = 48;
    scene.settings.height = 36;
    scene.camera.position = {half * 1.2, half * 0.7, half * 2.1};
    scene.camera.look_at = {0, 0, 0};
    scene.background = {0.2, 0.3, 0.4};
    scene.lights.push_back(Light{});
    scene.lights[0].position = {half, half * 2, half};
    scene.lights.push_back({LightKind::directional});
    scene.materials.assign(3, Material{});
    scene.materials[1].diffuse = {0.9, 0.1, 0.3};
    scene.materials[1].mirror = 0.4;
    scene.materials[2].transmission = 0.5;
    scene.materials[2].ior = 1.3;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
        scene.shapes[i].material = i % 4 == 3 ? k_none : static_cast<std::uint32_t>(i % 4);
    return scene;
}

template <class T> T& parameters(Scene& scene, const Shape& shape) { return scene.get<T>()[shape.index]; }

// Moves a shape of any kind without changing how it is packed.
void move(Scene& scene, std::uint32_t index, Vec3 by) {
    const Shape& shape = scene.shapes[index];
    const auto move_all = [&](std::initializer_list<Vec3*> points) {
        for (Vec3* p : points) *p = *p + by;
    };
    switch (shape.kind) {
        case ShapeKind::sphere:
            return move_all({&parameters<Sphere>(scene, shape).center});
        case ShapeKind::plane:
            return move_all({&parameters<Plane>(scene, shape).point});
        case ShapeKind::cylinder: {
            Cylinder& c = parameters<Cylinder>(scene, shape);
            c.caps = !c.caps;
            return move_all({&c.from, &c.to});
        }
        case ShapeKind::cone: {
            Cone& c = parameters<Cone>(scene, shape);
            return move_all({&c.from, &c.to});
        }
        case ShapeKind::torus:
            return move_all({&parameters<Torus>(scene, shape).center});
        case ShapeKind::disc:
            return move_all({&parameters<Disc>(scene, shape).center});
        case ShapeKind::box: {
            Box& c = parameters<Box>(scene, shape);
            return move_all({&c.min, &c.max});
        }
        case ShapeKind::triangle:
            for (Vec3& v : parameters<Triangle>(scene, shape).vertices) v = v + by;
            return;
        case ShapeKind::smooth_triangle:
            for (Vec3& v : parameters<SmoothTriangle>(scene, shape).vertices) v = v + by;
            return;
        case ShapeKind::polygon: {
            const Polygon& p = parameters<Polygon>(scene, shape);
            for (std::uint32_t i = 0; i < p.count; ++i) move_all({&scene.polygon_vertices[p.first + i]});
            return;
        }
        case ShapeKind::mesh: {
            auto& mesh = scene.meshes[parameters<Mesh>(scene, shape).mesh];
            MeshData moved = *mesh;
            for (Vec3& v : moved.positions) v = v + by;
            mesh = std::make_shared<const MeshData>(std::move(moved));
            return;
        }
        case ShapeKind::solid:  // solids_test.cpp
        case ShapeKind::quadric:
        case ShapeKind::quartic:
            return;
    }
}

// The same hits for rays in all directions, although the two hierarchies differ.
void expect_same_hits(const World& a, const World& b, Random& random, double half) {
    std::vector<Ray> rays;
    for (int i = 0; i < 500; ++i) rays.push_back({point_in_cube(random, 1.5 * half), unit_direction(random)});
    const auto of_a = nearest_hits(a, rays).value(), of_b = nearest_hits(b, rays).value();
    const auto any_a = occluded(a, rays).value(), any_b = occluded(b, rays).value();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        EXPECT_EQ(of_a[i].shape, of_b[i].shape);
        EXPECT_EQ(of_a[i].t, of_b[i].t);
        EXPECT_EQ(of_a[i].normal, of_b[i].normal);
        EXPECT_EQ(any_a[i], any_b[i]);
    }
}

TEST(EditShapes, AFewOrAllMoved) {
    Random random(201);
    for (int round = 0; round < 12; ++round) {
        const double half = 10;
        Scene scene = lit(random_scene(random, 60 + 200 * (round % 3), half), half);
        scene.conventions.facing = round % 2 == 0 ? Facing::open : Facing::all;
        World world = world_of(scene);
        for (const std::size_t count : {std::size_t{1}, std::size_t{3}, scene.shapes.size()}) {
            std::vector<std::uint32_t> changed = all_of(scene);
            for (std::size_t i = 0; i < count; ++i)
                std::swap(changed[i], changed[i + random.bits() % (changed.size() - i)]);
            changed.resize(count);
            for (const std::uint32_t shape : changed) {
                move(scene, shape, point_in_cube(random, half / 8));
                scene.shapes[shape].material = static_cast<std::uint32_t>(below(random, 3));
            }
            EXPECT_EQ(edit(world, scene, changed, 1 + round % 2), ShapeEdit::refitted);
            EXPECT_TRUE(draw_the_same(world, world_of(scene))) << round << ' ' << count;
            expect_same_hits(world, world_of(scene), random, half);
        }
        // All shapes in the order of the scene, on two threads.
        for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) move(scene, i, {0.1, 0.2, -0.1});
        EXPECT_EQ(edit(world, scene, all_of(scene), 2), ShapeEdit::refitted);
        EXPECT_TRUE(draw_the_same(world, world_of(scene))) << round;
        // Other transforms for the same shapes.
        std::vector<std::uint32_t> mapped;
        for (std::uint32_t i = 0; i < scene.shapes.size(); ++i)
            if (scene.shapes[i].transform != k_none) mapped.push_back(i);
        for (Affine& map : scene.transforms) map = compose(translation({0.3, -0.2, 0.1}), map);
        EXPECT_EQ(edit(world, scene, mapped), ShapeEdit::refitted);
        EXPECT_TRUE(draw_the_same(world, world_of(scene)));
    }
}

TEST(EditShapes, RefittedBoxesAreExact) {
    Random random(202);
    Scene scene = random_scene(random, 3000);
    World world = world_of(scene);
    for (int round = 0; round < 40; ++round) {
        std::vector<std::uint32_t> changed;
        for (int i = 0; i < (round % 8 == 7 ? 1000 : 5); ++i)
            changed.push_back(
                static_cast<std::uint32_t>(below(random, static_cast<int>(scene.shapes.size()))));
        for (const std::uint32_t shape : changed) move(scene, shape, point_in_cube(random, 0.3));
        if (edit(world, scene, changed) != ShapeEdit::refitted) continue;
        const PackedGeometry& geometry = *world.parts().geometry;
        const auto bounds = [&](std::uint32_t first, std::uint32_t count) {
            Aabb box;
            for (std::uint32_t slot = first; slot < first + count; ++slot)
                box.add(HWY_NAMESPACE::primitive_bounds(geometry, slot));
            return box;
        };
        Bvh all = geometry.bvh;
        refit_all(all, bounds, 1);
        for (std::size_t n = 0; n < all.nodes.size(); ++n) {
            for (int a = 0; a < 3; ++a) {
                EXPECT_TRUE(std::equal(all.nodes[n].lo[a], all.nodes[n].lo[a] + k_bvh_width,
                                       geometry.bvh.nodes[n].lo[a]));
                EXPECT_TRUE(std::equal(all.nodes[n].hi[a], all.nodes[n].hi[a] + k_bvh_width,
                                       geometry.bvh.nodes[n].hi[a]));
                EXPECT_EQ(all.bounds.lo[a], geometry.bvh.bounds.lo[a]);
                EXPECT_EQ(all.bounds.hi[a], geometry.bvh.bounds.hi[a]);
            }
        }
        EXPECT_NEAR(geometry.cost.expected(), find_cost(all).expected(), 1e-9 * find_cost(all).expected());
    }
}

TEST(EditShapes, IsInPlaceUnlessACopyExists) {
    Random random(203);
    Scene scene = lit(random_scene(random, 200), 10);
    World world = world_of(scene);
    const PackedGeometry* before = &*world.parts().geometry;
    move(scene, 5, {0.1, 0, 0});
    edit(world, scene, {5});
    EXPECT_EQ(&*world.parts().geometry, before);
    const World copy = world;
    const Scene old = scene;
    move(scene, 6, {0.1, 0, 0});
    edit(world, scene, {6});
    EXPECT_NE(&*world.parts().geometry, before);
    EXPECT_EQ(&*copy.parts().geometry, before);
    EXPECT_TRUE(draw_the_same(copy, world_of(old)));
    EXPECT_TRUE(draw_the_same(world, world_of(scene)));
    // Another World of the same geometry is a copy, too.
    const World other = *with_background(world, {1, 0, 0});
    before = &*world.parts().geometry;
    move(scene, 7, {0.1, 0, 0});
    edit(world, scene, {7});
    EXPECT_EQ(&*other.parts().geometry, before);
    EXPECT_NE(&*world.parts().geometry, before);
}

TEST(EditShapes, CopiesOfAWorldShareOneIndex) {
    Random random(211);
    const Scene original = lit(random_scene(random, 200), 10);
    const World base = world_of(original);
    constexpr std::size_t k_copies = 4;
    std::vector<World> copies(k_copies, base);
    std::vector<Scene> scenes(k_copies, original);
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < k_copies; ++i) {
        threads.emplace_back([&, i] {
            for (std::uint32_t shape = 0; shape < 20; ++shape) {
                move(scenes[i], shape, {0.1 * static_cast<double>(i + 1), 0, 0});
                edit(copies[i], scenes[i], {shape});
            }
        });
    }
    for (std::thread& thread : threads) thread.join();
    EXPECT_TRUE(draw_the_same(base, world_of(original)));
    const EditIndex* const index = copies[0].parts().geometry->edit_index.get();
    ASSERT_NE(index, nullptr);
    for (std::size_t i = 0; i < k_copies; ++i) {
        EXPECT_EQ(copies[i].parts().geometry->edit_index.get(), index) << i;
        EXPECT_TRUE(draw_the_same(copies[i], world_of(scenes[i]))) << i;
        const PackedGeometry& geometry = *copies[i].parts().geometry;
        const double cost = find_cost(geometry.bvh).expected();
        EXPECT_NEAR(geometry.cost.expected(), cost, 1e-9 * cost) << i;
    }
    // The same for a World that is prepared after them.
    World later = base;
    Scene scene = original;
    move(scene, 3, {0, 1, 0});
    edit(later, scene, {3});
    EXPECT_EQ(later.parts().geometry->edit_index.get(), index);
    EXPECT_TRUE(draw_the_same(later, world_of(scene)));
}

TEST(EditShapes, RebuildsWhenTheStructureChanges) {
    Random random(204);
    const Scene original = lit(random_scene(random, 120), 10);
    const auto expect_rebuilt = [&](const char* what, std::uint32_t shape, const auto& change) {
        SCOPED_TRACE(what);
        Scene scene = original;
        World world = world_of(scene);
        const World copy = world;
        change(scene);
        EXPECT_EQ(edit(world, scene, {shape}), ShapeEdit::rebuilt);
        EXPECT_TRUE(draw_the_same(world, world_of(scene)));
        EXPECT_TRUE(draw_the_same(copy, world_of(original)));
    };
    const auto first = [&](ShapeKind kind) {
        for (std::uint32_t i = 0; i < original.shapes.size(); ++i)
            if (original.shapes[i].kind == kind && original.shapes[i].transform == k_none) return i;
        ADD_FAILURE() << "no such shape";
        return 0u;
    };
    const std::uint32_t sphere = first(ShapeKind::sphere), polygon = first(ShapeKind::polygon);
    const auto replace = [](Scene& s, std::uint32_t shape, const auto& by) {
        const std::uint32_t at = s.add(by, s.shapes[shape].material);
        s.shapes[shape] = s.shapes[at];
        s.shapes.pop_back();
    };
    expect_rebuilt("another kind", sphere, [&](Scene& s) { replace(s, sphere, Box{}); });
    expect_rebuilt("without bounds", sphere, [&](Scene& s) {
        replace(s, sphere, Plane{{0, -9, 0}, {0, 1, 0}});
    });
    expect_rebuilt("with a map", sphere, [&](Scene& s) { s.shapes[sphere].transform = 0; });
    expect_rebuilt("a polygon's pieces", polygon,
                   [&](Scene& s) { --parameters<Polygon>(s, s.shapes[polygon]).count; });
    expect_rebuilt("a polygon of a triangle", first(ShapeKind::triangle), [&](Scene& s) {
        const auto at = static_cast<std::uint32_t>(s.polygon_vertices.size());
        for (const Vec3 v : {Vec3{0, 0, 0}, Vec3{3, 0, 0}, Vec3{3, 3, 0}, Vec3{0, 3, 0}})
            s.polygon_vertices.push_back(v);
        replace(s, first(ShapeKind::triangle), Polygon{at, 4});
    });
    expect_rebuilt("one more", sphere, [&](Scene& s) { s.add(Sphere{{1, 1, 1}, 2}, 1); });
    expect_rebuilt("one less", sphere, [&](Scene& s) { s.shapes.pop_back(); });
}

// A polygon of one piece is packed as a triangle, so it can become one by refitting.
TEST(EditShapes, ATriangleAsAPolygonIsRefitted) {
    Scene scene;
    scene.polygon_vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    scene.add(Triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
    World world = world_of(scene);
    const std::uint32_t at = scene.add(Polygon{0, 3});
    scene.shapes[0] = scene.shapes[at];
    scene.shapes.pop_back();
    EXPECT_EQ(edit(world, scene, {0}), ShapeEdit::refitted);
    EXPECT_TRUE(draw_the_same(world, world_of(scene)));
}

TEST(EditShapes, RebuildsWhenTheCostIncreases) {
    Random random(205);
    Scene scene;
    for (int i = 0; i < 4000; ++i) scene.add(Sphere{point_in_cube(random, 10), 0.05});
    scene = lit(std::move(scene), 10);
    World world = world_of(scene);
    const std::vector<std::uint32_t> all = all_of(scene);
    // The same cloud, moved and enlarged.
    for (Sphere& s : scene.get<Sphere>()) s = {s.center * 2 + Vec3{3, 4, 5}, s.radius * 2};
    EXPECT_EQ(edit(world, scene, all), ShapeEdit::refitted);
    // All shapes exchange their places.
    for (Sphere& s : scene.get<Sphere>()) s.center = point_in_cube(random, 10);
    EXPECT_EQ(edit(world, scene, all), ShapeEdit::rebuilt);
    EXPECT_TRUE(draw_the_same(world, world_of(scene)));
    for (Sphere& s : scene.get<Sphere>()) s.center = s.center + Vec3{0.1, 0, 0};
    EXPECT_EQ(edit(world, scene, all), ShapeEdit::refitted) << "the new hierarchy's cost is the new measure";
    EXPECT_TRUE(draw_the_same(world, world_of(scene)));
}

// A bent polygon: its triangles have different normals, and rays along the cuts hit two at the same t.
TEST(EditShapes, TiesWithinAPolygonDoNotDependOnTheHierarchy) {
    Random random(206);
    int differing_orders = 0;
    for (int round = 0; round < 60; ++round) {
        Scene scene;
        const auto corners = static_cast<std::uint32_t>(5 + below(random, 8));
        for (std::uint32_t i = 0; i < corners; ++i) {
            const double angle = 2 * M_PI * i / corners;
            scene.polygon_vertices.push_back(
                {std::round(16 * std::cos(angle)), std::round(16 * std::sin(angle)), 0});
        }
        scene.add(Polygon{0, corners});
        scene = lit(std::move(scene), 20);
        scene.camera.projection = Projection::orthographic;
        scene.camera.position = {0, 0, 50};
        scene.camera.look_at = {0, 0, 0};
        scene.camera.width = 33;
        scene.settings.width = scene.settings.height = 33;
        World world = world_of(scene);
        for (Vec3& v : scene.polygon_vertices)
            v = {v.x + below(random, 7) - 3, v.y + below(random, 7) - 3, (below(random, 3) - 1) * 1e-3};
        const ShapeEdit how = edit(world, scene, {0});
        const World again = world_of(scene);
        EXPECT_TRUE(draw_the_same(world, again)) << round;
        differing_orders +=
            how == ShapeEdit::refitted && world.parts().geometry->element != again.parts().geometry->element;
    }
    EXPECT_GT(differing_orders, 5) << "nothing was tested";
}

TEST(EditShapes, ErrorsLeaveTheWorldUnchanged) {
    Random random(207);
    const Scene original = lit(random_scene(random, 50), 10);
    World world = world_of(original);
    const PackedGeometry* before = &*world.parts().geometry;
    const auto expect_error = [&](const Scene& scene, std::uint32_t shape, const char* message) {
        const Result<ShapeEdit> result = edit_shapes(world, scene, {{0, shape}});
        EXPECT_EQ(result.code, ErrorCode::invalid_scene);
        ASSERT_FALSE(result.diagnostics.empty()) << message;
        EXPECT_NE(result.diagnostics[0].message.find(message), std::string::npos)
            << result.diagnostics[0].message;
        EXPECT_EQ(&*world.parts().geometry, before);
    };
    Scene scene = original;
    expect_error(scene, 50, "there is no shape 51: the scene has 50");
    for (Sphere& s : scene.get<Sphere>()) s.radius = -1;
    std::uint32_t sphere = 0;
    while (scene.shapes[sphere].kind != ShapeKind::sphere) ++sphere;
    expect_error(scene, sphere, "radius");
    scene = original;
    scene.shapes[7].material = 3;
    expect_error(scene, 7, "no such material");
    scene = original;
    scene.shapes[7].transform = 99;
    expect_error(scene, 7, "no such transform");
    scene = original;
    scene.transforms[1] = Affine{};
    scene.transforms[1].m[0][0] = 0;
    scene.shapes[7].transform = 1;
    expect_error(scene, 7, "transform 2");
    scene = original;
    scene.add(Sphere{{0, 0, 0}, -1});
    expect_error(scene, 7, "radius");
    EXPECT_TRUE(draw_the_same(world, world_of(original)));
    EXPECT_EQ(edit_shapes(world, original, {}).value(), ShapeEdit::none);
}

TEST(EditShapes, ErrorsAmongManyShapesAreInTheOrderOfTheList) {
    Scene scene;
    for (int i = 0; i < 50000; ++i) scene.add(Sphere{{0.001 * i, 0, 0}, 0.1});
    World world = world_of(scene);
    std::vector<std::uint32_t> changed = all_of(scene);
    std::reverse(changed.begin(), changed.end());
    for (const std::size_t sphere : {100u, 20000u, 45000u}) scene.get<Sphere>()[sphere].radius = -1;
    const Result<ShapeEdit> result = edit_shapes(world, scene, changed, {.threads = 2});
    EXPECT_EQ(result.code, ErrorCode::invalid_scene);
    ASSERT_EQ(result.diagnostics.size(), 3u);
    EXPECT_EQ(result.diagnostics[0].index, 45000u);
    EXPECT_EQ(result.diagnostics[1].index, 20000u);
    EXPECT_EQ(result.diagnostics[2].index, 100u);
}

TEST(EditShapes, OtherShapesKeepTheirMaterial) {
    Random random(208);
    Scene scene = lit(random_scene(random, 50), 10);
    World world = world_of(scene);
    const std::uint32_t shapes[] = {1, 2};
    ASSERT_TRUE(assign_material(world, shapes, 1));
    Scene expected = scene;
    expected.shapes[1].material = expected.shapes[2].material = 1;
    // The scene does not have this change, and shape 2 is updated from the scene.
    scene.shapes[2].material = expected.shapes[2].material = 0;
    scene.shapes[3] = scene.shapes[scene.add(Box{}, 2)];
    scene.shapes.pop_back();
    expected.shapes[3] = expected.shapes[expected.add(Box{}, 2)];
    expected.shapes.pop_back();
    EXPECT_EQ(edit(world, scene, {2, 3}), ShapeEdit::rebuilt);
    EXPECT_TRUE(draw_the_same(world, world_of(expected)));
}

// One thread renders a copy repeatedly while another changes the World.
TEST(EditShapes, CopiesStayValidWhileTheyRender) {
    Random random(210);
    Scene scene = lit(random_scene(random, 60), 10);
    World world = world_of(scene);
    const World copy = world;
    std::thread drawing([copy, expected = render(copy)] {
        for (int i = 0; i < 20; ++i) {
            const Result<Rendering> again = render(copy, {.threads = 1});
            EXPECT_TRUE(same_bits(again->image.rgb, expected->image.rgb));
        }
    });
    const std::uint32_t shapes[] = {0, 1};
    for (int i = 0; i < 200; ++i) {
        scene.lights[0].position.x = i * 0.01;
        world = with_lights(world, scene.lights).value();
        EXPECT_TRUE(assign_material(world, shapes, static_cast<std::uint32_t>(i % 2)));
        for (const std::uint32_t shape : shapes) move(scene, shape, {0, 0.01, 0});
        edit(world, scene, shapes);
    }
    drawing.join();
    EXPECT_TRUE(draw_the_same(world, world_of(scene)));
}

TEST(EditShapes, ARebuildCanBeCancelled) {
    Random random(209);
    Scene scene = lit(random_scene(random, 50), 10);
    World world = world_of(scene);
    const World copy = world;
    const std::atomic<bool> cancel{true};
    scene.add(Sphere{});
    const Result<ShapeEdit> result =
        edit_shapes(world, scene, {}, {.threads = 1, .progress = {}, .cancel = &cancel});
    EXPECT_EQ(result.code, ErrorCode::cancelled);
    EXPECT_TRUE(draw_the_same(world, copy));
}

}  // namespace
}  // namespace glint::test
