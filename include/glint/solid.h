// SPDX-License-Identifier: Apache-2.0
#pragma once
// Constructive solid geometry: shapes that are combined by their insides.
#include <cstdint>
#include <string_view>
#include <vector>

#include "glint/export.h"
#include "glint/shapes.h"

namespace glint {

enum class SolidOperation : std::uint8_t {
    operand,       ///< the next of SolidTree::operands
    merge,         ///< inside any; only the surface of the whole
    unite,         ///< inside any; surfaces within another one remain (POV-Ray's union in a solid)
    intersection,  ///< inside all
    difference,    ///< inside the first and outside of the others
    inverse,       ///< outside; `count` is 1
    /// The first, cut off where it is outside of one of the others. The cut is open: it has no surface.
    clip,
};

/// Those that take shapes.
inline constexpr SolidOperation k_combinations[] = {SolidOperation::unite,        SolidOperation::merge,
                                                    SolidOperation::intersection, SolidOperation::difference,
                                                    SolidOperation::inverse,      SolidOperation::clip};

/// The word in scene files: "union" for `unite`, else the name above.
GLINT_API std::string_view to_string(SolidOperation operation);

/// A step takes the results of the last `count` ones that no other step has taken.
struct SolidStep {
    SolidOperation operation = SolidOperation::operand;
    std::uint32_t count = 0;  ///< 0 for an operand, else at least 1
    friend bool operator==(const SolidStep&, const SolidStep&) = default;
};

inline constexpr std::uint32_t k_max_solid_operands = 4096;
/// Of steps within steps.
inline constexpr int k_max_solid_depth = 100;

/// The shapes of a solid, and how they are combined. An operand encloses a space: a sphere, box, torus,
/// quadric, quartic, closed mesh, cylinder or cone with caps, or a plane, whose normal points out of it.
///
/// A ray meets the solid where its inside begins or ends. Crossings of operands within 1e-9 of each other,
/// relative to the coordinates there, are one: there is no surface where two faces coincide and the inside is
/// the same on both sides. The surface has the operand's material and normal; the normal is turned if the
/// operand counts by its outside.
struct SolidTree {
    /// `index` as of the scene's shapes; a transform is applied before the solid's own; material k_none: the
    /// solid's.
    std::vector<Shape> operands;
    std::vector<SolidStep> steps;  ///< in postfix order
};

}  // namespace glint
