#pragma once
// The shapes' parameters. A new kind adds its struct, and one line to GLINT_SHAPES.
#include <cstdint>

#include "glint/vec.h"

namespace glint {

/// All points at distance radius > 0 from the center. Its normal points outward.
struct Sphere {
    Vec3 center;
    double radius = 1;
};

/// The infinite plane through point, perpendicular to normal (any length but 0).
struct Plane {
    Vec3 point;
    Vec3 normal{0, 1, 0};
};

/// The lateral surface of a finite cylinder around the axis from -> to (distinct points), radius > 0; with caps, also
/// the two discs at its ends. Its normal points away from the axis; a cap's, away from the cylinder.
struct Cylinder {
    Vec3 from, to{0, 1, 0};
    double radius = 1;
    bool caps = false;
};

// The list of kinds: X(Type, word). The order is that of ShapeKind; ties between shapes are broken by scene order.
#define GLINT_SHAPES(X) \
    X(Sphere, sphere)   \
    X(Plane, plane)     \
    X(Cylinder, cylinder)

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

}  // namespace glint
