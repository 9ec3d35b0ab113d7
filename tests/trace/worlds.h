// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes made in code, and their worlds.
#include <gtest/gtest.h>

#include "geometry/random_values.h"
#include "glint/render.h"
#include "math/transform.h"
#include "world/world.h"

namespace glint::test {

inline std::optional<World> make_world(const Scene& scene, int threads = 1) {
    Result<World> prepared = prepare(scene, {.threads = threads});
    EXPECT_TRUE(prepared) << to_string(prepared);
    return prepared ? std::optional(*std::move(prepared)) : std::nullopt;
}

/// A rotation, an uneven scaling (sometimes a mirroring) and a translation.
inline Affine random_transform(Random& random, double reach) {
    const auto scale = [&] { return log_uniform(random, 0.3, 3) * (chance(random, 0.2) ? -1 : 1); };
    const Affine turn =
        compose(rotation_x(random.uniform(0, 360)),
                compose(rotation_y(random.uniform(0, 360)), rotation_z(random.uniform(0, 360))));
    return compose(translation(point_in_cube(random, reach)),
                   compose(turn, scaling({scale(), scale(), scale()})));
}

/// A flat polygon around `at`: a star, concave.
inline void add_star(Scene& scene, Random& random, Vec3 at, double size, std::uint32_t transform) {
    const Vec3 n = unit_direction(random), x = perpendicular(random, n), y = cross(n, x);
    const auto first = static_cast<std::uint32_t>(scene.polygon_vertices.size());
    const auto corners = static_cast<std::uint32_t>(4 + 2 * below(random, 4));
    for (std::uint32_t i = 0; i < corners; ++i) {
        const double reach = size * (i % 2 == 0 ? 1 : random.uniform(0.3, 0.9)),
                     angle = 2 * M_PI * i / corners;
        scene.polygon_vertices.push_back(at + x * (reach * std::cos(angle)) + y * (reach * std::sin(angle)));
    }
    scene.add(Polygon{first, corners}, k_none, transform);
}

/// A shape other than a plane or a sphere, of about size r.
inline void add_other(Scene& scene, Random& random, Vec3 at, double r, std::uint32_t transform) {
    const Vec3 along = (chance(random, 0.5) ? axis_direction(random) : unit_direction(random)) * (3 * r);
    const auto corner = [&] { return at + point_in_cube(random, r); };
    switch (below(random, 7)) {
        case 0:
            scene.add(Cylinder{at, at + along, r, chance(random, 0.5)}, k_none, transform);
            break;
        case 1:
            scene.add(Cone{at, at + along, r, chance(random, 0.5) ? 0 : r / 2, chance(random, 0.5)}, k_none,
                      transform);
            break;
        case 2:
            // By the place, so that the numbers of the other shapes stay the same.
            if (at.y < 0) {
                scene.add(Torus{at, along, r, at.x < 0 ? r * 0.1 : r * 1.2}, k_none, transform);
            } else {
                scene.add(Disc{at, along, r, at.x < 0 ? r / 3 : 0}, k_none, transform);
            }
            break;
        case 3:
            scene.add(Box{at - Vec3{r, r / 2, r / 3}, at + Vec3{r, r, r}}, k_none, transform);
            break;
        case 4:
            scene.add(Triangle{{corner(), corner(), corner()}}, k_none, transform);
            break;
        case 5:
            scene.add(
                SmoothTriangle{{corner(), corner(), corner()},
                               {unit_direction(random), unit_direction(random), unit_direction(random)}},
                k_none, transform);
            break;
        default:
            add_star(scene, random, at, r, transform);
    }
}

/// `count` shapes within a cube: half of them spheres, some under transforms, a few planes.
inline Scene random_scene(Random& random, int count, double half = 10) {
    Scene scene;
    const double size = half / std::cbrt(static_cast<double>(count));
    for (int i = 0; i < 4; ++i) scene.transforms.push_back(random_transform(random, half / 4));
    for (int i = 0; i < count; ++i) {
        const std::uint32_t transform =
            chance(random, 0.2) ? static_cast<std::uint32_t>(below(random, 4)) : k_none;
        const Vec3 at = point_in_cube(random, half);
        const double r = log_uniform(random, size / 30, size);
        if (chance(random, count > 20 ? 0.02 : 0.2)) {
            scene.add(
                Plane{at * 1.2, chance(random, 0.5) ? axis_direction(random) : unit_direction(random) * 3},
                k_none, transform);
        } else if (chance(random, 0.5)) {
            add_other(scene, random, at, r, transform);
        } else {
            scene.add(Sphere{at, r}, k_none, transform);
        }
    }
    return scene;
}

/// Touching spheres, each with six smaller ones on it.
inline void add_flake(Scene& scene, Vec3 center, double radius, Vec3 from, int depth) {
    scene.add(Sphere{center, radius});
    if (depth == 0) return;
    const Vec3 ways[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (const Vec3 way : ways) {
        if (way == -from) continue;
        add_flake(scene, center + way * (radius * 1.5), radius / 2, way, depth - 1);
    }
}

inline void set_size(Scene& scene, int width, int height) {
    scene.settings.width = width;
    scene.settings.height = height;
}

inline std::uint32_t add_material(Scene& scene, const Material& material) {
    scene.materials.push_back(material);
    return static_cast<std::uint32_t>(scene.materials.size() - 1);
}

/// The unit normal at p of a plane or a sphere without a transform.
inline Vec3 plane_or_sphere_normal(const Scene& scene, const Shape& shape, Vec3 p) {
    if (shape.kind == ShapeKind::plane) return normalize(scene.get<Plane>()[shape.index].normal);
    return normalize(p - scene.get<Sphere>()[shape.index].center);
}

/// Gives the shapes in turn four materials: a mirror, matte, glass that is a mirror, and glass that refracts.
inline void mix_mirrors_and_glass(Scene& scene) {
    for (int i = 0; i < 4; ++i) {
        Material m;
        m.mirror = i % 2 == 0 ? 0.4 : 0;
        m.transmission = i >= 2 ? 0.7 : 0;
        m.ior = i == 3 ? 1.4 : 1;
        add_material(scene, m);
    }
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
        scene.shapes[i].material = static_cast<std::uint32_t>(i % 4);
}

/// Shapes of all kinds around the origin, without lights and materials.
inline Scene mixture(std::uint32_t seed, int count = 60) {
    Random random(seed);
    Scene scene = random_scene(random, count, 6);
    set_size(scene, 70, 50);
    scene.background = {0.2, 0.3, 0.9};
    scene.camera.position = {0, 2, 18};
    scene.camera.look_at = {0, 0, 0};
    return scene;
}

/// The same with mirrors and glass, and 2 x 2 samples.
inline Scene mirrors_and_glass(std::uint32_t seed) {
    Scene scene = mixture(seed);
    scene.settings.samples = 2;
    mix_mirrors_and_glass(scene);
    return scene;
}

}  // namespace glint::test
