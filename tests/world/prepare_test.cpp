// SPDX-License-Identifier: Apache-2.0
// Scene -> World: packing, boxes, the camera, and independence of threads.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "formats/load_validated.h"
#include "trace/hit_rule.h"
#include "trace/worlds.h"
#include "world/appearance/appearance.h"
#include "world/geometry/primitive_bounds-inl.h"
#include "world/prepare.h"
#include "world/same_pictures.h"

namespace glint::test {
namespace {

TEST(Prepare, EveryShapeHasItsSlots) {
    Random random(111);
    const Scene scene = random_scene(random, 500);
    const std::optional<World> world = make_world(scene);
    ASSERT_TRUE(world);
    std::set<std::uint32_t> shapes;
    std::uint32_t next = 0;
    bool unbounded = false;
    for (const ShapeClass& c : world->parts().geometry->classes) {
        EXPECT_EQ(c.first, next);
        EXPECT_GT(c.count, 0u);
        EXPECT_GE(c.stride, c.count + static_cast<std::uint32_t>(k_ray_padding));
        next += c.count;
        if (c.kind == ShapeKind::plane) unbounded = true;
        EXPECT_EQ(c.first >= world->parts().geometry->bounded, unbounded) << "bounded classes come first";
        for (std::uint32_t slot = c.first; slot < c.first + c.count; ++slot) {
            EXPECT_EQ(&world->parts().geometry->class_of(slot), &c);
            const Shape& shape = scene.shapes.at(world->parts().geometry->shape_index[slot]);
            EXPECT_EQ(c.kind, shape.kind == ShapeKind::polygon ? ShapeKind::triangle : shape.kind);
            const bool again = !shapes.insert(world->parts().geometry->shape_index[slot]).second;
            EXPECT_TRUE(!again || shape.kind == ShapeKind::polygon);
        }
    }
    EXPECT_EQ(next, world->parts().geometry->count);
    EXPECT_EQ(shapes.size(), scene.shapes.size());
    EXPECT_GE(world->parts().geometry->box_lo[0].size(),
              world->parts().geometry->boxed + static_cast<std::size_t>(k_ray_padding));
    EXPECT_GE(world->parts().geometry->shape_index.size(),
              world->parts().geometry->count + static_cast<std::size_t>(k_ray_padding));
}

TEST(Prepare, ScenesThatLoadHasValidated) {
    const SceneText text{"a.glint",
                         "camera { position = (0, 0, 5)  look_at = (0, 0, 0)  fov_x = 50 }\n"
                         "sphere { center = (0, 0, 0)  radius = 1 }\n"};
    const Result<ValidatedScene> loaded = load_validated({&text, 1});
    ASSERT_TRUE(loaded) << loaded.message;
    static_assert(std::is_const_v<std::remove_reference_t<decltype(**loaded)>>);
    const Result<World> world = prepare(*loaded), validated_again = prepare(**loaded);
    ASSERT_TRUE(world);
    ASSERT_TRUE(validated_again);
    EXPECT_TRUE(draw_the_same(*world, *validated_again));
    ASSERT_EQ(world.diagnostics.size(), 1u) << "there is no light";
    ASSERT_EQ(validated_again.diagnostics.size(), 1u);
    EXPECT_EQ(to_string(world.diagnostics[0]), to_string(validated_again.diagnostics[0]));
    EXPECT_EQ(load({&text, 1})->shapes.size(), (*loaded)->shapes.size());

    const SceneText wrong{"a.glint", "sphere { center = (0, 0, 0)  radius = -1 }\n"};
    EXPECT_FALSE(load_validated({&wrong, 1}));
}

TEST(Prepare, OmitsConesByConvention) {
    Scene scene;
    scene.add(Sphere{{0, 0, 0}, 1});
    scene.add(Cone{{0, 0, 0}, {0, 9, 0}, 1, 0, true});
    scene.add(Sphere{{0, 0, 2}, 1});
    EXPECT_EQ(make_world(scene)->parts().geometry->count, 3u);
    scene.conventions.cones = false;
    const std::optional<World> world = make_world(scene);
    EXPECT_EQ(world->parts().geometry->count, 2u);
    EXPECT_LT(scene_bounds(*world).max.y, 2);
    EXPECT_EQ(world->parts().geometry->shape_index[0] + world->parts().geometry->shape_index[1], 2u)
        << "indices are the scene's";
}

TEST(Prepare, LeavesReferToSlotsOfOneClass) {
    Random random(112);
    const std::optional<World> world = make_world(random_scene(random, 700));
    std::vector<int> met(world->parts().geometry->bounded);
    for (const BvhNode& node : world->parts().geometry->bvh.nodes) {
        for (int c = 0; c < k_bvh_width; ++c) {
            if (!node.child[c].is_leaf()) continue;
            for (std::uint32_t i = 0; i < node.child[c].count(); ++i) {
                const std::uint32_t slot = node.child[c].first() + i;
                ASSERT_LT(slot, world->parts().geometry->bounded);
                ++met[slot];
                EXPECT_EQ(&world->parts().geometry->class_of(slot),
                          &world->parts().geometry->class_of(node.child[c].first()));
                const Aabb box = primitive_box(*world->parts().geometry, slot);
                for (int a = 0; a < 3; ++a) {
                    EXPECT_LE(node.lo[a][c], box.lo[a]);
                    EXPECT_GE(node.hi[a][c], box.hi[a]);
                }
            }
        }
    }
    for (const int times : met) EXPECT_EQ(times, 1);
}

TEST(Prepare, PrimitiveBoundsAreThoseOfTheKernels) {
    Random random(114);
    const std::optional<World> world = make_world(random_scene(random, 700));
    const PackedGeometry& geometry = *world->parts().geometry;
    int computed = 0;
    for (std::uint32_t slot = 0; slot < geometry.bounded; ++slot) {
        const Aabb box = primitive_box(geometry, slot),
                   bounds = HWY_NAMESPACE::primitive_bounds(geometry, slot);
        for (int a = 0; a < 3; ++a) {
            EXPECT_EQ(bounds.lo[a], box.lo[a]) << slot;
            EXPECT_EQ(bounds.hi[a], box.hi[a]) << slot;
        }
        computed += slot >= geometry.boxed;
    }
    EXPECT_GT(computed, 0) << "no triangles";
}

TEST(Prepare, TheSameForAnyNumberOfThreads) {
    Random random(113);
    const Scene scene = random_scene(random, 40000);
    const std::optional<World> one = make_world(scene, 1);
    for (const int threads : {2, 7}) {
        const std::optional<World> other = make_world(scene, threads);
        EXPECT_EQ(one->parts().geometry->shape_index, other->parts().geometry->shape_index);
        EXPECT_EQ(*one->parts().slot_material, *other->parts().slot_material);
        for (int a = 0; a < 3; ++a) {
            EXPECT_EQ(one->parts().geometry->box_lo[a], other->parts().geometry->box_lo[a]);
            EXPECT_EQ(one->parts().geometry->box_hi[a], other->parts().geometry->box_hi[a]);
        }
        ASSERT_EQ(one->parts().geometry->classes.size(), other->parts().geometry->classes.size());
        for (std::size_t c = 0; c < one->parts().geometry->classes.size(); ++c)
            EXPECT_EQ(one->parts().geometry->classes[c].values, other->parts().geometry->classes[c].values);
    }
}

TEST(Prepare, FlippedNormals) {
    Scene scene;
    scene.transforms.push_back(translation({1, 2, 3}));
    const auto turned = [&](Facing facing) {
        scene.conventions.facing = facing;
        const std::optional<World> world = make_world(scene);
        std::vector<bool> by_shape(scene.shapes.size());
        for (std::uint32_t slot = 0; slot < world->parts().geometry->count; ++slot) {
            by_shape[world->parts().geometry->shape_index[slot]] = flips_normal(world->parts(), {slot, 0});
        }
        return by_shape;
    };
    const std::uint32_t none = k_none;
    for (const std::uint32_t transform : {none, std::uint32_t{0}}) {
        scene.add(Sphere{}, k_none, transform);
        scene.add(Plane{}, k_none, transform);
        scene.add(Cylinder{{0, 0, 0}, {0, 1, 0}, 1, false}, k_none, transform);
        scene.add(Cylinder{{0, 0, 0}, {0, 1, 0}, 1, true}, k_none, transform);
        scene.add(Cone{{0, 0, 0}, {0, 1, 0}, 1, 0, false}, k_none, transform);
        scene.add(Cone{{0, 0, 0}, {0, 1, 0}, 1, 0, true}, k_none, transform);
        scene.add(Disc{}, k_none, transform);
        scene.add(Box{}, k_none, transform);
        scene.add(Triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, k_none, transform);
        scene.add(Torus{}, k_none, transform);
    }
    EXPECT_EQ(turned(Facing::none), std::vector<bool>(20, false));
    EXPECT_EQ(turned(Facing::all), std::vector<bool>(20, true));
    EXPECT_EQ(turned(Facing::winding), std::vector<bool>(20, true));
    std::vector<bool> open{false, true, true, false, true, false, true, false, true, false};
    open.insert(open.end(), open.begin(), open.end());
    EXPECT_EQ(turned(Facing::open), open);
}

TEST(Prepare, LightsAndMaterials) {
    Scene scene;
    Light light;
    light.kind = LightKind::ambient;
    light.color = {0.1, 0.2, 0.3};
    scene.lights = {light, Light{}, light};
    scene.lights[1].position = {1, 2, 3};
    Material m;
    m.shininess = 99;
    scene.materials = {m, m};
    scene.add(Sphere{});
    scene.add(Sphere{}, 1);
    const std::optional<World> world = make_world(scene);
    EXPECT_EQ(world->parts().ambient, (Color{0.2, 0.4, 0.6}));
    ASSERT_EQ(world->parts().lights->size(), 1u);
    EXPECT_EQ((*world->parts().lights)[0].position, (Vec3{1, 2, 3}));
    ASSERT_EQ(world->parts().materials->size(), 3u * k_material_values);
    for (std::uint32_t slot = 0; slot < 2; ++slot) {
        const std::uint32_t material = (*world->parts().slot_material)[slot];
        const bool has_own = world->parts().geometry->shape_index[slot] == 1;
        EXPECT_EQ(material, has_own ? 1u : 2u);
        EXPECT_EQ(world->parts().material(material)[k_shininess], has_own ? 99 : Material{}.shininess);
    }
}

TEST(Prepare, BoundsAndMemory) {
    Scene scene;
    scene.add(Plane{});
    Bounds none = scene_bounds(*make_world(scene));
    EXPECT_GT(none.min.x, none.max.x);
    scene.add(Sphere{{1, 2, 3}, 0.5});
    scene.add(Cylinder{{-4, 0, 0}, {-4, 7, 0}, 1, false});
    const std::optional<World> world = make_world(scene);
    const Bounds b = scene_bounds(*world);
    EXPECT_NEAR(b.min.x, -5, 1e-5);
    EXPECT_NEAR(b.min.y, 0, 1e-5);
    EXPECT_NEAR(b.max.x, 1.5, 1e-5);
    EXPECT_NEAR(b.max.y, 7, 1e-5);
    EXPECT_NEAR(b.max.z, 3.5, 1e-5);
    EXPECT_GE(memory_usage(*world).shapes, sizeof(double) * 4);
    EXPECT_GE(memory_usage(*world).hierarchy, sizeof(BvhNode));
}

TEST(Prepare, MemoryByPart) {
    Random random(114);
    Scene scene;
    scene.add(Plane{{0, 0, 0}, {0, 1, 0}});
    EXPECT_EQ(memory_usage(*make_world(scene)).hierarchy, 0u);
    for (int i = 0; i < 20000; ++i) scene.add(Sphere{point_in_cube(random, 10), 0.1});
    const std::optional<World> world = make_world(scene);
    const WorldMemory used = memory_usage(*world);
    EXPECT_EQ(used.packed, world->parts().geometry->count);
    EXPECT_GE(used.shapes, 20000 * 4 * sizeof(double));
    EXPECT_GE(used.indices, 20000 * 2 * sizeof(std::uint32_t));
    EXPECT_GE(used.hierarchy, sizeof(BvhNode));
    EXPECT_GE(used.materials, k_material_values * sizeof(double));
    EXPECT_EQ(used.total(), used.shapes + used.boxes + used.indices + used.hierarchy + used.materials);
    EXPECT_LE(used.each(), 96) << "what a sphere may cost";
    EXPECT_EQ(memory_usage(*make_world(Scene{})).each(), 0);
}

TEST(Prepare, RejectsInvalidScenes) {
    Scene scene;
    scene.add(Sphere{{0, 0, 0}, -1});
    const Result<World> result = prepare(scene);
    EXPECT_FALSE(result);
    EXPECT_TRUE(has_errors(result.diagnostics));
}

// Points of shapes are within their slots' boxes.
TEST(Prepare, BoundsContainTheShapes) {
    Random random(114);
    Scene scene;
    for (int i = 0; i < 6; ++i) scene.transforms.push_back(random_transform(random, 3));
    for (int i = 0; i < 3000; ++i) {
        const std::uint32_t transform =
            chance(random, 0.5) ? static_cast<std::uint32_t>(below(random, 6)) : k_none;
        const Vec3 at = point_in_cube(random, 10);
        const double r = log_uniform(random, 1e-6, 10);
        if (chance(random, 0.3)) {
            scene.add(Sphere{at, r}, k_none, transform);
        } else {
            add_other(scene, random, at, r, transform);
        }
    }
    const std::optional<World> world = make_world(scene);
    int checked = 0;
    for (std::uint32_t slot = 0; slot < world->parts().geometry->bounded; ++slot) {
        const ShapeClass& shapes = world->parts().geometry->class_of(slot);
        double lo[3], hi[3];
        const Aabb box = primitive_box(*world->parts().geometry, slot);
        for (int a = 0; a < 3; ++a) lo[a] = box.lo[a], hi[a] = box.hi[a];
        for (int i = 0; i < 20; ++i) {
            // From far outside the box through a point inside.
            const Vec3 to{random.uniform(lo[0], hi[0]), random.uniform(lo[1], hi[1]),
                          random.uniform(lo[2], hi[2])};
            const double size = std::max({hi[0] - lo[0], hi[1] - lo[1], hi[2] - lo[2]});
            const Vec3 d = unit_direction(random), o = to - d * (3 * size);
            FormulaHit hit{shapes, slot - shapes.first, {{o.x, o.y, o.z}, {d.x, d.y, d.z}}, 0};
            plain::visit_geometry(shapes.kind, shapes.transformed, hit);
            if (!hit.hit.valid) continue;
            ++checked;
            const Vec3 p = o + d * hit.hit.t;
            const double at[3] = {p.x, p.y, p.z};
            for (int a = 0; a < 3; ++a) {
                const double slack = 1e-14 * (std::fabs(at[a]) + 10);
                EXPECT_GE(at[a], lo[a] - slack) << "slot " << slot << " axis " << a;
                EXPECT_LE(at[a], hi[a] + slack) << "slot " << slot << " axis " << a;
            }
        }
    }
    EXPECT_GT(checked, 10000);
}

TEST(Prepare, TheCameraByItsDefinition) {
    Scene scene;
    scene.settings.width = 200;
    scene.settings.height = 100;
    scene.camera.position = {1, 2, 3};
    scene.camera.look_at = {1, 2, -7};
    scene.camera.up = {0, 5, 1};
    scene.camera.fov_degrees = 90;
    const auto prepared = [&] { return make_world(scene)->parts().camera; };
    PreparedCamera c = prepared();
    EXPECT_EQ(c.forward, (Vec3{0, 0, -1}));
    EXPECT_NEAR(c.right.x, 2, 1e-15);  // 2 tan 45
    EXPECT_NEAR(c.up.y, 1, 1e-15);
    EXPECT_EQ(dot(c.right, c.up), 0);
    scene.camera.fov_axis = FovAxis::y;
    c = prepared();
    EXPECT_NEAR(c.up.y, 2, 1e-15);
    EXPECT_NEAR(c.right.x, 4, 1e-15);
    scene.camera.projection = Projection::orthographic;
    scene.camera.width = 6;
    c = prepared();
    EXPECT_NEAR(c.right.x, 6, 1e-15);
    EXPECT_NEAR(c.up.y, 3, 1e-15);
    scene.camera.frame = CameraFrame{{3, 0, 0}, {0, 4, 0}, {0, 0, 5}};
    c = prepared();
    EXPECT_EQ(c.right, (Vec3{3, 0, 0}));
    EXPECT_EQ(c.up, (Vec3{0, 4, 0}));
    EXPECT_EQ(c.forward, (Vec3{0, 0, 5}));
}

}  // namespace
}  // namespace glint::test
