// SPDX-License-Identifier: Apache-2.0
#pragma once
// Random solids, and what is inside of them by definition.
#include <cmath>
#include <functional>
#include <memory>

#include "glint/scene.h"
#include "trace/rays.h"

namespace glint::test {

using Inside = std::function<bool(Vec3)>;

/// A shape without a transform, and what is inside it.
struct Part {
    Shape shape;
    Inside inside;
};

template <class T> Shape shape_of(Scene& scene, const T& parameters) {
    scene.add(parameters);
    const Shape shape = scene.shapes.back();
    scene.shapes.pop_back();
    return shape;
}

/// An octahedron around a point, with its corners at the distance r along the axes; its triangles are turned
/// outwards or inwards.
inline Shape octahedron(Scene& scene, Vec3 at, double r, bool is_inside_out) {
    auto mesh = std::make_shared<MeshData>();
    for (const double side : {r, -r}) {
        for (const Vec3 axis : {Vec3{side, 0, 0}, Vec3{0, side, 0}, Vec3{0, 0, side}})
            mesh->positions.push_back(at + axis);
    }
    for (std::uint32_t corner = 0; corner < 8; ++corner) {
        const auto end = [&](std::uint32_t axis) { return (corner >> axis & 1) != 0 ? axis + 3 : axis; };
        const bool is_even = ((corner ^ corner >> 1 ^ corner >> 2) & 1) == 0;
        if (is_even != is_inside_out)
            mesh->triangles.push_back({end(0), end(1), end(2)});
        else
            mesh->triangles.push_back({end(0), end(2), end(1)});
    }
    scene.meshes.push_back(std::move(mesh));
    return shape_of(scene, Mesh{static_cast<std::uint32_t>(scene.meshes.size() - 1)});
}

/// A solid of one shape: a mesh has an inside only in a solid.
inline Shape solid_of(Scene& scene, const Shape& shape) {
    scene.solids.push_back(combine(scene, SolidOperation::merge, {&shape, 1}));
    return shape_of(scene, Solid{static_cast<std::uint32_t>(scene.solids.size() - 1)});
}

/// Within the cube of half edge 2 around the origin, or a half-space.
inline Part random_part(Scene& scene, Random& random) {
    const Vec3 at = point_in_cube(random, 1);
    const Vec3 along = chance(random, 0.5) ? axis_direction(random) : unit_direction(random);
    const double r = random.uniform(0.2, 1);
    switch (below(random, 8)) {
        case 0:
            return {shape_of(scene, Sphere{at, r}), [=](Vec3 p) { return length(p - at) < r; }};
        case 1: {
            const Vec3 lo = at - Vec3{r, r / 2, r / 3}, hi = at + Vec3{r, r, r};
            return {shape_of(scene, Box{lo, hi}), [=](Vec3 p) {
                        return p.x > lo.x && p.x < hi.x && p.y > lo.y && p.y < hi.y && p.z > lo.z &&
                               p.z < hi.z;
                    }};
        }
        case 2:
            return {shape_of(scene, Cylinder{at, at + along, r / 2, true}), [=](Vec3 p) {
                        const double h = dot(p - at, along);
                        return h > 0 && h < 1 && length(p - at - along * h) < r / 2;
                    }};
        case 3:
            return {shape_of(scene, Cone{at, at + along, r, r / 4, true}), [=](Vec3 p) {
                        const double h = dot(p - at, along);
                        return h > 0 && h < 1 && length(p - at - along * h) < r + (r / 4 - r) * h;
                    }};
        case 4:
            return {shape_of(scene, Torus{at, along, r, r / 3}), [=](Vec3 p) {
                        const double h = dot(p - at, along);
                        const double off = length(p - at - along * h) - r;
                        return off * off + h * h < r * r / 9;
                    }};
        case 5: {  // of any type, with its center or apex at `at`
            const auto sign = [&] { return static_cast<double>(below(random, 3) - 1); };
            const Vec3 s{1, sign(), 2 * sign()}, scaled{s.x * at.x, s.y * at.y, s.z * at.z};
            // Two equal planes are no surface.
            const double size = s.y == 0 ? r * r : r * r * sign();
            return {shape_of(scene, Quadric{s, {}, scaled * -2, dot(scaled, at) - size}), [=](Vec3 p) {
                        const Vec3 q = p - at;
                        return s.x * q.x * q.x + s.y * q.y * q.y + s.z * q.z * q.z < size;
                    }};
        }
        case 6:
            return {solid_of(scene, octahedron(scene, at, r, chance(random, 0.5))), [=](Vec3 p) {
                        const Vec3 q = p - at;
                        return std::fabs(q.x) + std::fabs(q.y) + std::fabs(q.z) < r;
                    }};
        default:
            return {shape_of(scene, Plane{at, along}), [=](Vec3 p) { return dot(p - at, along) < 0; }};
    }
}

/// A tree with up to `most` operands; its last shape is added to the scene.
inline Part random_solid(Scene& scene, Random& random, int most) {
    if (most <= 1) return random_part(scene, random);
    const int first = 1 + below(random, most - 1);
    Part a = random_solid(scene, random, first), b = random_solid(scene, random, most - first);
    const auto operation = static_cast<SolidOperation>(
        below(random, 3) == 0 ? static_cast<int>(SolidOperation::merge)
                              : static_cast<int>(SolidOperation::intersection) + below(random, 2));
    const Shape parts[] = {a.shape, b.shape};
    scene.solids.push_back(combine(scene, operation, parts));
    const Shape solid = shape_of(scene, Solid{static_cast<std::uint32_t>(scene.solids.size() - 1)});
    const Inside x = a.inside, y = b.inside;
    if (operation == SolidOperation::merge) return {solid, [=](Vec3 p) { return x(p) || y(p); }};
    if (operation == SolidOperation::difference) return {solid, [=](Vec3 p) { return x(p) && !y(p); }};
    return {solid, [=](Vec3 p) { return x(p) && y(p); }};
}

}  // namespace glint::test
