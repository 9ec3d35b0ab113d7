// SPDX-License-Identifier: Apache-2.0
#pragma once
// The properties of a kind of shape that choose how it is stored and tested.

namespace glint {

/// How often a line is inside of one shape at most: GeometryTraits::k_crossings / 2.
inline constexpr int k_max_intervals = 3;

/// The usual properties. The geometry of a kind (geometry/kinds-inl.h) derives from this struct and declares
/// those again that differ.
struct GeometryTraits {
    /// It has finite bounds.
    static constexpr bool k_bounded = true;
    /// Its box is stored. Otherwise Geometry::packed_bounds() computes it from the first
    /// Geometry::k_bounds_values packed values, which takes less memory.
    static constexpr bool k_stores_box = true;
    /// An affine map of the shape is a shape of the same kind, which apply_transform() returns.
    static constexpr bool k_bakes_transform = false;
    /// It has a Filter in single precision that rejects rays early.
    static constexpr bool k_filtered = false;
    /// Its Filter can be computed once for all rays from one origin: Filter::from_one_origin().
    static constexpr bool k_shares_filter = false;
    /// Its formula has a form for rays that are prepared once: ShearedRay and hit_sheared().
    static constexpr bool k_sheared = false;
    /// Its formula costs no more than the test of its box, for one ray.
    static constexpr bool k_cheap = false;
    /// It consists of the shapes of another PackedGeometry, which rays that are mapped into its coordinates
    /// traverse. It has no formula of its own.
    static constexpr bool k_is_instance = false;
    /// It consists of shapes that are not hit by themselves (Scene::solids). It has no formula of its own.
    static constexpr bool k_is_solid = false;
    static constexpr bool k_has_formula = true;
    /// Rays hit a shape of this kind as an operand of a solid only. One that is not an operand is packed as a
    /// solid of one operand. It needs no hit().
    static constexpr bool k_only_operand = false;
    /// The greatest number of crossings of a line with its surface, if it encloses a space; see
    /// geometry/crossings-inl.h. 0: it encloses none. Otherwise it has contains(): whether a point is inside.
    static constexpr int k_crossings = 0;
    /// It has tests that are cheaper than its formula: quick_test() and ParallelTest.
    static constexpr bool k_quick = false;
};

}  // namespace glint
