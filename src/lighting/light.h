// SPDX-License-Identifier: Apache-2.0
#pragma once
// Properties of a light that are not part of the lighting equation.
#include "glint/scene.h"

namespace glint {

/// The cone of a spot as its formula needs it: the cosines of its angles off the axis, and the angles.
struct SpotCone {
    double inner_cosine = 1, outer_cosine = 0;
    double inner_radians = 0, outer_radians = 0;
    double tightness = 0;
};

/// The samples of an area light: columns x rows points on a parallelogram, a disc or a sphere.
struct AreaGrid {
    bool is_parallelogram = false, is_disc = false;  // else a sphere
    std::int32_t columns = 0, rows = 0;              // 0: not an area light
    Vec3 center;
    Vec3 x, y, z;  // the sides; or axes at right angles, the radius long, of which a disc has only x and y
    bool jitter = false;
    bool circular = false, oriented = false;  // parallelograms
    std::int32_t adaptive = k_all_levels;
    std::int32_t count() const { return columns * rows; }
};

/// Whether shadow rays are traced from the light to the surface, so that all of them have the same origin.
inline bool comes_from_light(const Light& light, const Conventions& conventions) {
    return light.has_position() && conventions.shadow_stops_at_light;
}

}  // namespace glint
