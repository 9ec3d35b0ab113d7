// SPDX-License-Identifier: Apache-2.0
#include "export/gltf/unit_shapes.h"

#include "math/elementary.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::gltf_export {
namespace {

constexpr auto k_circle = static_cast<std::uint32_t>(k_around);

// The point number i / 2 of the circle: odd numbers are between two vertices.
Vec3 half_step(std::uint32_t i) {
    const double degrees = 180.0 * i / k_around;
    return {cos_degrees(degrees), sin_degrees(degrees), 0};
}

class Builder {
  public:
    std::uint32_t vertex(Vec3 p) {
        mesh.single_positions.push_back(to_single(p));
        return static_cast<std::uint32_t>(mesh.single_positions.size() - 1);
    }
    // With normals, which every vertex has then.
    std::uint32_t vertex(Vec3 p, Vec3 normal) {
        mesh.normals.values.push_back(to_single(normalize(normal)));
        return vertex(p);
    }
    void smooth(std::uint32_t a, std::uint32_t b, std::uint32_t c) { add({a, b, c}, {a, b, c}); }
    void flat(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        constexpr std::uint32_t none = CornerValues::k_none;
        add({a, b, c}, {none, none, none});
    }
    MeshData mesh;

  private:
    void add(const TriangleCorners& triangle, const TriangleCorners& normals) {
        mesh.triangles.push_back(triangle);
        if (!mesh.normals.empty()) mesh.normals.corners.push_back(normals);
    }
};

// Its normal is z or, from below, -z.
void add_disc(Builder& to, double radius, double z, bool is_below) {
    if (!(radius > 0)) return;
    const std::uint32_t middle = to.vertex({0, 0, z});
    for (std::uint32_t i = 0; i < k_circle; ++i) to.vertex(half_step(2 * i) * radius + Vec3{0, 0, z});
    for (std::uint32_t i = 0; i < k_circle; ++i) {
        const std::uint32_t a = middle + 1 + i, b = middle + 1 + (i + 1) % k_circle;
        is_below ? to.flat(middle, b, a) : to.flat(middle, a, b);
    }
}

}  // namespace

MeshData unit_sphere(double degrees) {
    Builder to;
    to.vertex({0, 0, 1}, {0, 0, 1});
    const double first = number::min(degrees, k_row_degrees);
    for (double at = first; at < 180 - k_row_degrees / 2;) {
        const double radius = sin_degrees(at), z = cos_degrees(at);
        for (std::uint32_t i = 0; i < k_circle; ++i) {
            const Vec3 p = half_step(2 * i) * radius + Vec3{0, 0, z};
            to.vertex(p, p);
        }
        at += number::max(first, number::min(at / 4, k_row_degrees));
    }
    const std::uint32_t bottom = to.vertex({0, 0, -1}, {0, 0, -1}), last = bottom - k_circle;
    for (std::uint32_t i = 0; i < k_circle; ++i) {
        const std::uint32_t next = (i + 1) % k_circle;
        to.smooth(0, 1 + i, 1 + next);
        for (std::uint32_t high = 1; high < last; high += k_circle) {
            to.smooth(high + i, high + k_circle + next, high + next);
            to.smooth(high + i, high + k_circle + i, high + k_circle + next);
        }
        to.smooth(last + i, bottom, last + next);
    }
    to.mesh.normals.corners.clear();  // each vertex has its own
    return to.mesh;
}

MeshData unit_cone(double from_radius, double to_radius, bool caps) {
    Builder to;
    const Vec3 rise{0, 0, from_radius - to_radius};
    // At a point of the axis, each triangle has a vertex of its own, whose normal is that of its middle.
    for (std::uint32_t i = 0; i < k_circle; ++i) {
        const Vec3 low = half_step(from_radius > 0 ? 2 * i : 2 * i + 1);
        const Vec3 high = half_step(to_radius > 0 ? 2 * i : 2 * i + 1);
        to.vertex(low * from_radius, low + rise);
        to.vertex(high * to_radius + Vec3{0, 0, 1}, high + rise);
    }
    for (std::uint32_t i = 0; i < k_circle; ++i) {
        const std::uint32_t low = 2 * i, next = 2 * ((i + 1) % k_circle);
        if (from_radius > 0) to.smooth(low, next, to_radius > 0 ? next + 1 : low + 1);
        if (to_radius > 0) to.smooth(low, next + 1, low + 1);
    }
    if (caps) {
        add_disc(to, from_radius, 0, true);
        add_disc(to, to_radius, 1, false);
    }
    return to.mesh;
}

MeshData unit_disc(double hole) {
    Builder to;
    if (!(hole > 0)) {
        add_disc(to, 1, 0, false);
        return to.mesh;
    }
    for (std::uint32_t i = 0; i < k_circle; ++i) {
        to.vertex(half_step(2 * i) * hole);
        to.vertex(half_step(2 * i));
    }
    for (std::uint32_t i = 0; i < k_circle; ++i) {
        const std::uint32_t inner = 2 * i, next = 2 * ((i + 1) % k_circle);
        to.flat(inner, inner + 1, next + 1);
        to.flat(inner, next + 1, next);
    }
    return to.mesh;
}

MeshData unit_torus(double tube) {
    Builder to;
    constexpr std::uint32_t rows = k_circle / 2;  // around the tube
    for (std::uint32_t i = 0; i < k_circle; ++i) {
        for (std::uint32_t j = 0; j < rows; ++j) {
            const Vec3 out = half_step(2 * i), turn = half_step(4 * j);
            const Vec3 normal = out * turn.x + Vec3{0, 0, turn.y};
            to.vertex(out + normal * tube, normal);
        }
    }
    for (std::uint32_t i = 0; i < k_circle; ++i) {
        const std::uint32_t here = i * rows, there = (i + 1) % k_circle * rows;
        for (std::uint32_t j = 0; j < rows; ++j) {
            const std::uint32_t next = (j + 1) % rows;
            to.smooth(here + j, there + j, there + next);
            to.smooth(here + j, there + next, here + next);
        }
    }
    to.mesh.normals.corners.clear();  // each vertex has its own
    return to.mesh;
}

MeshData unit_box() {
    Builder to;
    for (unsigned i = 0; i < 8; ++i) to.vertex({i & 1 ? 1.0 : 0.0, i & 2 ? 1.0 : 0.0, i & 4 ? 1.0 : 0.0});
    constexpr std::uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& f : faces) {
        to.flat(f[0], f[1], f[2]);
        to.flat(f[0], f[2], f[3]);
    }
    return to.mesh;
}

MeshData unit_square() {
    Builder to;
    for (const Vec3 p : {Vec3{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}) to.vertex(p);
    to.flat(0, 1, 2);
    to.flat(0, 2, 3);
    return to.mesh;
}

}  // namespace glint::gltf_export
