// SPDX-License-Identifier: Apache-2.0
#pragma once
// How far shapes reach: what the reader asks where a rule depends on other shapes.
#include <cstdint>
#include <optional>

#include "glint/scene.h"

namespace glint::povray {

/// The greatest dot(d, p) of the points p of a shape, of a solid an upper bound; nothing for shapes without
/// end.
std::optional<double> reach(const Scene& scene, const Shape& shape, Vec3 d);

/// The box around shapes.
struct ReachBox {
    Vec3 least{1e300, 1e300, 1e300}, most{-1e300, -1e300, -1e300};
    bool is_unbounded = false;  ///< some have no end; it leaves these out

    void add(const Scene& scene, const Shape& shape);
    void add(const ReachBox& box);
    /// Of its longest side; below 0 if it is empty.
    double size() const;
};

/// What reach() takes for a shape, in points.
std::uint64_t reach_steps(const Scene& scene, const Shape& shape);

/// Whether the boxes of two shapes are apart; false for shapes without end.
bool are_apart(const Scene& scene, const Shape& a, const Shape& b);

}  // namespace glint::povray
