// SPDX-License-Identifier: Apache-2.0
#pragma once
// The curves of prisms and lathes, as lines of points.
#include <functional>

#include "formats/povray/even_odd.h"

namespace glint::povray {

enum class Spline : std::uint8_t { linear, quadratic, cubic, bezier, b_spline, refused };
/// A set of kinds, one bit each.
constexpr unsigned splines(auto... kinds) { return ((1u << static_cast<unsigned>(kinds)) | ...); }
inline constexpr unsigned k_flat_splines =
    splines(Spline::linear, Spline::quadratic, Spline::cubic, Spline::bezier);

/// Adds the points of the curve that points[first..end) give. The pieces between them turn by at most about
/// 0.25 degrees each. spend: as of fill_even_odd.
void add_curve(const FlatLoop& points, std::size_t first, std::size_t end, Spline spline,
               const std::function<bool(std::uint64_t)>& spend, FlatLoop& to);

}  // namespace glint::povray
