// SPDX-License-Identifier: Apache-2.0
#pragma once
// The parameters of shapes. A new kind adds its struct and one line to GLINT_SHAPES (docs/adding_a_shape.md).
// If a kind has only points, directions, lengths and coefficients, fields() lists them once, for validate()
// and the scene language. It calls visit.point, visit.direction (not 0), visit.length (> 0), visit.radius
// (>= 0, and 0 if a scene file has none), visit.coefficients or visit.coefficient (any number, likewise) for
// each.
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string_view>

#include "glint/vec.h"

namespace glint {

inline constexpr std::uint32_t k_none = 0xffffffffu;

/// All points at distance radius > 0 from the center. The normal points outward.
struct Sphere {
    Vec3 center;
    double radius = 1;
    template <class Self, class Visit> static void fields(Self& self, Visit&& visit) {
        visit.point("center", self.center);
        visit.length("radius", self.radius);
    }
};

/// The infinite plane through point, perpendicular to normal (any length except 0).
struct Plane {
    Vec3 point;
    Vec3 normal{0, 1, 0};
    template <class Self, class Visit> static void fields(Self& self, Visit&& visit) {
        visit.point("point", self.point);
        visit.direction("normal", self.normal);
    }
};

/// The lateral surface of a finite cylinder around the axis from -> to (distinct points), radius > 0; with
/// caps, also the two discs at its ends. The normal points away from the axis; on a cap, away from the
/// cylinder.
struct Cylinder {
    Vec3 from, to{0, 1, 0};
    double radius = 1;
    bool caps = false;
};

/// The lateral surface of a cone around the axis from -> to (distinct points). The radius changes from
/// from_radius to to_radius, both >= 0 and not both 0; with caps, also the discs at its ends. The normal
/// points away from the axis.
struct Cone {
    Vec3 from, to{0, 1, 0};
    double from_radius = 1, to_radius = 0;
    bool caps = false;
};

/// A flat disc of radius > 0 perpendicular to normal (any length except 0). It has a hole of radius hole
/// around its center, 0 <= hole < radius.
struct Disc {
    Vec3 center;
    Vec3 normal{0, 1, 0};
    double radius = 1, hole = 0;
    template <class Self, class Visit> static void fields(Self& self, Visit&& visit) {
        visit.point("center", self.center);
        visit.direction("normal", self.normal);
        visit.length("radius", self.radius);
        visit.radius("hole", self.hole);
    }
};

/// An axis-aligned box, min <= max in each coordinate. The normals point outward. Scene files call it `box`.
struct Box {
    Vec3 min{-1, -1, -1}, max{1, 1, 1};
};

/// A flat triangle; its normal is on the counter-clockwise side, (b - a) × (c - a). A triangle without area
/// is never hit.
struct Triangle {
    Vec3 vertices[3];
};

/// A triangle whose vertex normals (any length except 0) are interpolated by the point's barycentric
/// coordinates.
struct SmoothTriangle {
    Vec3 vertices[3];
    Vec3 normals[3];
};

inline constexpr std::uint32_t k_max_polygon_vertices = 4096;

/// A flat polygon, convex or concave, without holes: Scene::polygon_vertices [first, first + count), with
/// count from 3 to k_max_polygon_vertices. Its normal is on the counter-clockwise side. prepare()
/// triangulates it.
struct Polygon {
    std::uint32_t first = 0, count = 0;
};

/// The triangles of Scene::meshes[mesh]. Each is a Triangle, or a SmoothTriangle if its vertices have
/// normals. Several shapes may have one mesh.
struct Mesh {
    std::uint32_t mesh = 0;
};

/// The points at distance tube > 0 from a circle of radius > 0 around the center, perpendicular to axis (any
/// length except 0). The normal points away from the circle. If tube > radius, the surface intersects itself,
/// and the space around the center that it encloses twice counts as outside.
struct Torus {
    Vec3 center;
    Vec3 axis{0, 1, 0};
    double radius = 1, tube = 0.25;
    template <class Self, class Visit> static void fields(Self& self, Visit&& visit) {
        visit.point("center", self.center);
        visit.direction("axis", self.axis);
        visit.length("radius", self.radius);
        visit.length("tube", self.tube);
    }
};

/// A combination of shapes: Scene::solids[solid].
struct Solid {
    std::uint32_t solid = 0;
};

/// The points at which f(x, y, z) = squares.x x^2 + squares.y y^2 + squares.z z^2 + products.x xy +
/// products.y xz + products.z yz + linear.x x + linear.y y + linear.z z + constant is 0: an ellipsoid, a
/// paraboloid, a hyperboloid, or a cone or cylinder without ends. One coefficient besides `constant` at least
/// is not 0. Its inside is where f < 0; the normal is the gradient of f. Two equal planes (x^2 = 0), where f
/// does not change its sign, are no surface, but rounding errors may show some of it.
struct Quadric {
    Vec3 squares, products, linear;
    double constant = 0;
    template <class Self, class Visit> static void fields(Self& self, Visit&& visit) {
        visit.coefficients("squares", self.squares);
        visit.coefficients("products", self.products);
        visit.coefficients("linear", self.linear);
        visit.coefficient("constant", self.constant);
    }
};

/// The terms of a Quartic: "x2yz" is x^2 y z.
inline constexpr std::string_view k_quartic_terms[] = {
    "x4",  "x3y",  "x3z", "x3",  "x2y2", "x2yz", "x2y", "x2z2", "x2z", "x2",  "xy3",     "xy2z",
    "xy2", "xyz2", "xyz", "xy",  "xz3",  "xz2",  "xz",  "x",    "y4",  "y3z", "y3",      "y2z2",
    "y2z", "y2",   "yz3", "yz2", "yz",   "y",    "z4",  "z3",   "z2",  "z",   "constant"};

/// The points at which f(x, y, z), the sum of coefficients[i] times the term k_quartic_terms[i], is 0: a
/// surface of degree 4 at most. One coefficient besides `constant` at least is not 0. Its inside is where f <
/// 0; the normal is the gradient of f. Where f does not change its sign, there is no surface, as of a
/// Quadric.
struct Quartic {
    double coefficients[std::size(k_quartic_terms)] = {};
    template <class Self, class Visit> static void fields(Self& self, Visit&& visit) {
        for (std::size_t i = 0; i < std::size(k_quartic_terms); ++i)
            visit.coefficient(k_quartic_terms[i], self.coefficients[i]);
    }
};

// The list of kinds: X(Type, word), in the order of ShapeKind. Ties between shapes are resolved by scene
// order.
#define GLINT_SHAPES(X)                \
    X(Sphere, sphere)                  \
    X(Plane, plane)                    \
    X(Cylinder, cylinder)              \
    X(Cone, cone)                      \
    X(Disc, disc)                      \
    X(Box, box)                        \
    X(Triangle, triangle)              \
    X(SmoothTriangle, smooth_triangle) \
    X(Polygon, polygon)                \
    X(Mesh, mesh)                      \
    X(Torus, torus)                    \
    X(Solid, solid)                    \
    X(Quadric, quadric)                \
    X(Quartic, quartic)

enum class ShapeKind : std::uint8_t {
#define GLINT_KIND(Type, word) word,
    GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
};

inline constexpr int k_shape_kinds = 0
#define GLINT_KIND(Type, word) +1
    GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
    ;

/// One shape of the scene: parameters number `index` of its kind, its material and its transform.
struct Shape {
    ShapeKind kind = ShapeKind::sphere;
    std::uint32_t index = 0;           ///< into Scene::get<Kind>()
    std::uint32_t material = k_none;   ///< into Scene::materials; k_none: the default Material
    std::uint32_t transform = k_none;  ///< into Scene::transforms (world_from_object); k_none: identity
};

}  // namespace glint
