// SPDX-License-Identifier: Apache-2.0
#pragma once
// Points, lengths and colors of many shapes from NumPy arrays. `name` is for messages: each function throws
// ValueError, which names the first row that is wrong.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "values.h"

namespace glint::python {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// "5 x 3".
std::string shape_text(const py::array& array);

Doubles to_doubles(const py::handle& value, std::string_view name);

/// Refuses the first number out of the range. each: how many numbers a row has.
void check_range(const Doubles& array, std::string_view name, const Range& range, std::size_t each);

/// N x 3 numbers, each a coordinate.
Doubles to_points_array(const py::handle& value, std::string_view name);

inline Vec3 point(const Doubles& array, std::size_t i) {
    const double* p = array.data() + 3 * i;
    return {p[0], p[1], p[2]};
}

/// One number for all, or one for each.
class Lengths {
  public:
    Lengths(const py::handle& value, std::string_view name, std::size_t count);
    double operator[](std::size_t i) const { return array_.data()[step_ * i]; }

  private:
    Doubles array_;
    std::size_t step_ = 0;
};

/// One color for all, or one for each.
struct ShapeColors {
    std::optional<Color> one = {};
    std::vector<ShapeColor> each = {};
};
ShapeColors to_shape_colors(const py::object& colors, std::size_t count);

}  // namespace glint::python
