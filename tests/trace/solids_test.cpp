// SPDX-License-Identifier: Apache-2.0
// Solids: rays meet them where a point's membership changes, by definition and not by the tested formulas.
#include <gtest/gtest.h>

#include "trace/pictures.h"
#include "trace/random_solid.h"
#include "trace/rays.h"
#include "trace/worlds.h"

namespace glint::test {
namespace {

struct SurfaceHit {
    bool exists = false;
    double t = 0;
    Vec3 normal;
    std::uint32_t material = k_none;  // the row
};

/// The same on every instruction set.
SurfaceHit nearest_surface(const World& world, Vec3 o, Vec3 d) {
    Rays rays;
    rays.push(o, d);
    SurfaceHit found;
    bool is_first = true;
    for (const Kernels& kernels : available_kernels()) {
        const Hits hits = nearest_hits(kernels, world, rays, 64);
        const SurfaceId id{hits.slot[0], hits.element[0]};
        if (!is_first) {
            EXPECT_EQ(id.exists(), found.exists);
            if (found.exists) {
                EXPECT_EQ(hits.t[0], found.t);
            }
        }
        is_first = false;
        if (!id.exists()) continue;
        const SurfaceNormals normals = surface_normals(*world.parts().geometry, id, o + d * hits.t[0]);
        found = {true, hits.t[0], normals.shading, (*world.parts().slot_material)[id.slot]};
    }
    return found;
}

// The inside changes at each hit and nowhere before it: found by steps along the ray, which are much smaller
// than the parts.
TEST(Solids, ARayMeetsTheFirstChangeOfTheInside) {
    Random random(4001);
    int hits = 0, starts_inside = 0;
    for (int round = 0; round < 600; ++round) {
        Scene scene;
        const Part solid = random_solid(scene, random, 1 + below(random, 6));
        scene.shapes.push_back(solid.shape);
        const std::optional<World> world = make_world(scene);
        ASSERT_TRUE(world);
        for (int i = 0; i < 40; ++i) {
            const Vec3 o = point_in_cube(random, 2.5);
            const Vec3 d = chance(random, 0.2) ? axis_direction(random) : unit_direction(random);
            const bool inside = solid.inside(o);
            starts_inside += inside;
            constexpr double k_step = 1e-3, k_reach = 8;
            double change = k_reach;
            for (double t = 0; t < k_reach; t += k_step) {
                if (solid.inside(o + d * t) != inside) {
                    change = t;
                    break;
                }
            }
            const SurfaceHit hit = nearest_surface(*world, o, d);
            const double t = hit.exists ? std::min(hit.t, k_reach) : k_reach;
            if (hit.exists) {
                ++hits;
                // Where it begins or ends, and the normal is towards the outside.
                EXPECT_NE(solid.inside(o + d * (hit.t - 1e-7)), solid.inside(o + d * (hit.t + 1e-7)));
                const Vec3 p = o + d * hit.t;
                if (std::fabs(dot(hit.normal, d)) > 1e-3) {
                    EXPECT_TRUE(solid.inside(p - hit.normal * 1e-6));
                    EXPECT_FALSE(solid.inside(p + hit.normal * 1e-6));
                }
            }
            EXPECT_LE(t, change + 1e-6);
            // Thin parts lie between two steps.
            if (t < change - 2 * k_step) {
                EXPECT_NE(solid.inside(o + d * (t + 1e-6)), inside) << "round " << round;
            }
        }
    }
    EXPECT_GT(hits, 2000);
    EXPECT_GT(starts_inside, 800);
}

// Packets try the last occluder first: that is the solid, not the operand.
TEST(Solids, OccludeWhereTheyAreHit) {
    Random random(4003);
    int occluded = 0, free = 0;
    for (int round = 0; round < 100; ++round) {
        Scene scene;
        for (int i = 0; i < 3; ++i) {
            const Part solid = random_solid(scene, random, 2 + below(random, 4));
            scene.shapes.push_back(solid.shape);
        }
        const std::optional<World> world = make_world(scene);
        ASSERT_TRUE(world);
        Rays rays;
        const Vec3 light = unit_direction(random) * 6;
        for (int i = 0; i < 200; ++i) {
            const Vec3 target = i % 2 == 0 ? point_in_cube(random, 1.5) : Vec3{0, 0, 0};
            rays.push(light, target - light, 0, 1e9);
        }
        for (const Kernels& kernels : available_kernels()) {
            const Hits hits = nearest_hits(kernels, *world, rays, 64);
            for (const int packet : {1, 64}) {
                const std::vector<std::uint8_t> any = any_hits(kernels, *world, rays, packet);
                for (int i = 0; i < rays.size(); ++i) {
                    const bool is_hit = hits.slot[static_cast<std::size_t>(i)] != k_none;
                    EXPECT_EQ(any[static_cast<std::size_t>(i)] != 0, is_hit);
                    ++(is_hit ? occluded : free);
                }
            }
        }
    }
    EXPECT_GT(occluded, 10000);
    EXPECT_GT(free, 10000);
}

// Of a rounded die: faces of operands that coincide leave no skin, and tangents no surface.
TEST(Solids, FlushCutsLeaveNoSkin) {
    Scene scene;
    scene.add(Box{{-1, -1, -1}, {1, 1, 1}});
    scene.add(Box{{-1, -1, 0}, {1, 1, 1}});
    combine_last(scene, SolidOperation::difference, 0);
    const std::optional<World> world = make_world(scene);
    const SurfaceHit hit = nearest_surface(*world, {0.3, 0.2, 5}, {0, 0, -1});
    ASSERT_TRUE(hit.exists);
    EXPECT_NEAR(hit.t, 5, 1e-12);
    EXPECT_NEAR(hit.normal.z, 1, 1e-12);
}

// Walls much thinner than 1e-9 of the ray's origin.
TEST(Solids, RaysFromFarAwayMeetThinParts) {
    Scene scene;
    scene.add(Box{{-1, -1, -1}, {1, 1, 1}});
    scene.add(Box{{-0.99, -0.99, -0.99}, {0.99, 0.99, 0.99}});
    combine_last(scene, SolidOperation::difference, 0);
    const std::optional<World> world = make_world(scene);
    for (const double distance : {1e3, 1e6, 1e9}) {
        const Vec3 o{0.3, 0.2, distance}, d{0, 0, -distance};
        const SurfaceHit outer = nearest_surface(*world, o, d);
        ASSERT_TRUE(outer.exists);
        EXPECT_NEAR(distance - outer.t * distance, 1, 1e-15 * distance);
        Rays rays;
        rays.push(o, d, (distance - 0.995) / distance);
        const Hits inner = nearest_hits(available_kernels().front(), *world, rays, 64);
        EXPECT_NEAR(distance - inner.t[0] * distance, 0.99, 1e-15 * distance);
    }
}

TEST(Solids, TheOutsideOfAShapeIsASolid) {
    Scene scene;
    scene.add(Sphere{{0, 0, 0}, 1});
    combine_last(scene, SolidOperation::inverse, 0);
    const std::optional<World> world = make_world(scene);
    const SurfaceHit hit = nearest_surface(*world, {0, 0, 5}, {0, 0, -1});
    ASSERT_TRUE(hit.exists);
    EXPECT_NEAR(hit.t, 4, 1e-12);
    EXPECT_NEAR(hit.normal.z, -1, 1e-12);  // into the sphere
}

TEST(Solids, ACutIsOpen) {
    Scene scene;
    scene.add(Sphere{{0, 0, 0}, 1});
    scene.add(Plane{{0, 0, 0}, {0, 0, 1}});  // keeps z < 0
    combine_last(scene, SolidOperation::clip, 0);
    const std::optional<World> world = make_world(scene);
    const SurfaceHit hit = nearest_surface(*world, {0, 0, 5}, {0, 0, -1});
    ASSERT_TRUE(hit.exists);
    EXPECT_NEAR(hit.t, 6, 1e-12);
    EXPECT_NEAR(hit.normal.z, -1, 1e-12);
}

// POV-Ray's union within a solid.
TEST(Solids, AUnionKeepsInnerSurfacesAndAMergeDoesNot) {
    for (const bool keeps : {true, false}) {
        Scene scene;
        scene.add(Sphere{{0, 0, 0.5}, 1});
        scene.add(Sphere{{0, 0, -0.5}, 1});
        combine_last(scene, keeps ? SolidOperation::unite : SolidOperation::merge, 0);
        scene.add(Box{{-3, -3, -3}, {3, 3, 3}});
        combine_last(scene, SolidOperation::intersection, 0);
        const std::optional<World> world = make_world(scene);
        const SurfaceHit hit = nearest_surface(*world, {0, 0, 1.4}, {0, 0, -1});
        ASSERT_TRUE(hit.exists);
        EXPECT_NEAR(hit.t, keeps ? 0.9 : 2.9, 1e-12);
    }
}

// More operands than a packet's rays are tested with: those that no ray meets are left out.
TEST(Solids, ManyHolesEqualAFewOfThem) {
    Scene all, one;
    for (Scene* scene : {&all, &one}) scene->add(Box{{-10, -10, -1}, {10, 10, 1}});
    for (int i = 0; i < 400; ++i) {
        const Vec3 at{-9.5 + i % 20, -9.5 + i / 20, 0};
        all.add(Cylinder{at - Vec3{0, 0, 2}, at + Vec3{0, 0, 2}, 0.3, true});
        if (i == 210) one.add(Cylinder{at - Vec3{0, 0, 2}, at + Vec3{0, 0, 2}, 0.3, true});
    }
    combine_last(all, SolidOperation::difference, 0);
    combine_last(one, SolidOperation::difference, 0);
    const std::optional<World> worlds[] = {make_world(all), make_world(one)};
    Random random(4002);
    for (int i = 0; i < 2000; ++i) {
        const Vec3 o{random.uniform(0, 1), random.uniform(0, 1), 5};
        const SurfaceHit a = nearest_surface(*worlds[0], o, {0, 0, -1}),
                         b = nearest_surface(*worlds[1], o, {0, 0, -1});
        ASSERT_EQ(a.exists, b.exists);
        if (a.exists) {
            ASSERT_EQ(a.t, b.t);
        }
    }
}

// Of many crossings each ray is tested by itself, of few all of a vector: which it is depends on the packet.
TEST(Solids, RaysMeetTheSameAloneAndTogether) {
    Random random(4012);
    int hits = 0;
    for (int round = 0; round < 40; ++round) {
        Scene scene;
        scene.shapes.push_back(random_solid(scene, random, 12 + 4 * round).shape);
        const std::optional<World> world = make_world(scene);
        ASSERT_TRUE(world);
        Rays rays;
        for (int i = 0; i < 64; ++i) {
            const Vec3 to = point_in_cube(random, 1.5), o = i % 4 == 0 ? to : Vec3{0, 0.2, 6};
            rays.push(o, i % 4 == 0 ? unit_direction(random) : normalize(to - o));
        }
        std::optional<Hits> all;
        for (const Kernels& kernels : available_kernels()) {
            for (const int batch : {64, 7, 1}) {
                const Hits found = nearest_hits(kernels, *world, rays, batch);
                if (!all) all = found;
                for (std::size_t i = 0; i < 64; ++i) {
                    ASSERT_EQ(found.t[i], all->t[i]) << "round " << round << ", ray " << i;
                    ASSERT_EQ(found.slot[i], all->slot[i]);
                    ASSERT_EQ(found.element[i], all->element[i]);
                }
            }
        }
        for (std::size_t i = 0; i < 64; ++i) hits += all->slot[i] != k_none;
    }
    EXPECT_GT(hits, 400);
}

// Each operand has its own material, or the solid's.
TEST(Solids, OperandsHaveMaterials) {
    Scene scene;
    Material red, blue;
    red.color = {1, 0, 0}, blue.color = {0, 0, 1};
    scene.materials = {red, blue};
    scene.add(Box{{-1, -1, -1}, {1, 1, 1}});
    scene.add(Sphere{{0, 0, 1}, 0.5}, 1);
    combine_last(scene, SolidOperation::difference, 0, 0);
    const std::optional<World> world = make_world(scene);
    EXPECT_EQ(nearest_surface(*world, {0.9, 0, 5}, {0, 0, -1}).material, 0u);
    EXPECT_EQ(nearest_surface(*world, {0, 0, 5}, {0, 0, -1}).material, 1u);
}

// Rays hit a quadric as an operand only: by itself, it is packed as a solid of one.
TEST(Solids, AQuadricByItselfIsASolidOfOne) {
    Scene alone, combined, sphere;
    Material blue;
    blue.color = {0, 0, 1};
    for (Scene* scene : {&alone, &combined, &sphere}) {
        scene->materials = {Material{}, blue};
        scene->transforms.push_back({{{2, 0, 0, 0.5}, {0, 1, 0.3, 0}, {0, 0, 0.5, -1}}});
        scene->add(Sphere{{0, 3, 0}, 1});
    }
    const Quadric unit{{1, 1, 1}, {}, {}, -1};
    alone.add(unit, 1, 0);
    combined.add(unit, k_none, 0);
    combine_last(combined, SolidOperation::merge, 1, 1);
    sphere.add(Sphere{}, 1, 0);
    const std::optional<World> worlds[] = {make_world(alone), make_world(combined), make_world(sphere)};
    Random random(4003);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 o = point_in_cube(random, 5);
        const Vec3 d = point_in_cube(random, 1.5) - o;
        const SurfaceHit a = nearest_surface(*worlds[0], o, d), b = nearest_surface(*worlds[1], o, d),
                         c = nearest_surface(*worlds[2], o, d);
        ASSERT_EQ(a.exists, b.exists);
        ASSERT_EQ(a.exists, c.exists);
        if (!a.exists) continue;
        ++hits;
        EXPECT_EQ(a.t, b.t);
        EXPECT_EQ(a.normal, b.normal);
        EXPECT_EQ(a.material, b.material);
        EXPECT_EQ(a.material, c.material);
        EXPECT_NEAR(a.t, c.t, 1e-9);
        EXPECT_NEAR(length(a.normal - c.normal), 0, 1e-9);
    }
    EXPECT_GT(hits, 500);
}

// A solid without ends does not count for the bounds of the scene, which frame its picture.
TEST(Solids, WithoutEndsAreNotBounded) {
    Scene scene;
    scene.add(Quadric{{1, 0, 1}, {}, {}, -1});
    EXPECT_GT(scene_bounds(*make_world(scene)).min.x, scene_bounds(*make_world(scene)).max.x);
    scene.add(Sphere{{1, 2, 3}, 0.5});
    scene.add(Plane{});
    scene.add(Sphere{});
    combine_last(scene, SolidOperation::difference, 2);
    scene.add(Sphere{{-4, 0, 0}, 1});
    scene.add(Plane{});
    combine_last(scene, SolidOperation::intersection, 3);
    const Bounds box = scene_bounds(*make_world(scene));
    EXPECT_NEAR(box.min.x, -5, 1e-5);
    EXPECT_NEAR(box.max.x, 1.5, 1e-5);
    EXPECT_NEAR(box.max.y, 2.5, 1e-5);
}

}  // namespace
}  // namespace glint::test
