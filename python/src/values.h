// SPDX-License-Identifier: Apache-2.0
#pragma once
// Numbers, points and colors between Python and glint. Python's classes are in glint/_values.py.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glint/scene.h"
#include "scene/ranges.h"

namespace glint::python {

namespace py = pybind11;

/// A class or function of one of the package's modules, which is looked up once.
py::object from_package(const char* module, const char* name);

py::object to_python(double x);
py::object to_python(std::int32_t x);
/// None for k_none.
py::object to_python(std::uint32_t x);
py::object to_python(bool x);
py::object to_python(const Vec3& v);
py::object to_python(const Color& c);
py::object to_python(const Attenuation& a);
/// A list of (place, color) or (place, color, alpha); None without colors.
py::object to_python(const std::vector<TextureColor>& colors);

// From Python: `name` is for messages. Each throws TypeError or ValueError.

double to_number(const py::handle& value, std::string_view name, const Range& range);
/// From any three numbers: a tuple, a list, an array.
Vec3 to_vec3(const py::handle& value, std::string_view name);
Vec3 to_point(const py::handle& value, std::string_view name);
/// Any length but 0.
Vec3 to_direction(const py::handle& value, std::string_view name);
/// From three numbers, from four (the alpha of a colormap is left out), one (grey), "#rrggbb" or a
/// name. Of uint8, 255 is 1.
Color to_color(const py::handle& value, std::string_view name, const Range& range);
Attenuation to_attenuation(const py::handle& value, std::string_view name);
/// Colors as to_python() makes them; none for None.
std::vector<TextureColor> to_color_map(const py::handle& value);
/// From a matrix of 3x4 or 4x4.
Affine to_affine(const py::handle& value, std::string_view name);
py::object to_python(const Affine& a);

bool is_number(const py::handle& value);

/// repr(value).
std::string repr_of(const py::handle& value);

}  // namespace glint::python
