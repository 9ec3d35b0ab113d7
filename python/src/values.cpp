// SPDX-License-Identifier: Apache-2.0
#include "values.h"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <map>
#include <utility>

#include "scene/validate_texture.h"

namespace glint::python {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

[[noreturn]] void fail(std::string_view name, std::string_view expected, const py::handle& found) {
    throw py::value_error(fmt::format("{}: expected {}, found {}", name, expected, repr_of(found)));
}

// The numbers of a sequence or an array; fails if they are not `least` to `most` many.
std::size_t numbers(const py::handle& value, std::string_view name, std::string_view expected,
                    std::size_t least, std::size_t most, double* to) {
    if (PyTuple_CheckExact(value.ptr()) || PyList_CheckExact(value.ptr())) {
        const auto items = py::reinterpret_borrow<py::sequence>(value);
        const std::size_t count = items.size();
        if (count < least || count > most) fail(name, expected, value);
        for (std::size_t i = 0; i < count; ++i) {
            to[i] = PyFloat_AsDouble(py::object(items[i]).ptr());
            if (to[i] == -1 && PyErr_Occurred() != nullptr) {
                PyErr_Clear();
                fail(name, expected, value);
            }
        }
        return count;
    }
    if (py::isinstance<py::str>(value) || value.is_none()) fail(name, expected, value);
    const Doubles array = Doubles::ensure(value);
    if (!array) {
        PyErr_Clear();
        fail(name, expected, value);
    }
    const auto count = static_cast<std::size_t>(array.size());
    if (array.ndim() != 1 || count < least || count > most) fail(name, expected, value);
    std::copy_n(array.data(), count, to);
    return count;
}

// "#ff8000" -> 1, 0.502, 0.
bool parse_hex(const std::string& text, double (&channels)[4]) {
    if (text.size() != 7 || text[0] != '#') return false;
    if (text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos) return false;
    for (std::size_t i = 0; i < 3; ++i)
        channels[i] = std::stoi(text.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    return true;
}

}  // namespace

py::object from_package(const char* module, const char* name) {
    // Never freed: at exit Python is gone before static objects.
    static auto& known = *new std::map<std::pair<std::string, std::string>, py::object>;
    py::object& found = known[{module, name}];
    if (!found) found = py::module_::import(module).attr(name);
    return found;
}

std::string repr_of(const py::handle& value) { return py::repr(value).cast<std::string>(); }

bool is_number(const py::handle& value) {
    return (PyFloat_Check(value.ptr()) || PyNumber_Check(value.ptr())) && !py::isinstance<py::array>(value) &&
           !PySequence_Check(value.ptr());
}

py::object to_python(double x) { return py::float_(x); }
py::object to_python(std::uint32_t x) {
    if (x == k_none) return py::none();
    return py::int_(x);
}
py::object to_python(std::int32_t x) { return py::int_(x); }
py::object to_python(bool x) { return py::bool_(x); }
py::object to_python(const Vec3& v) { return from_package("glint._values", "Vec3")(v.x, v.y, v.z); }
py::object to_python(const Color& c) { return from_package("glint._values", "Color")(c.r, c.g, c.b); }
py::object to_python(const Attenuation& a) {
    return from_package("glint._values", "Attenuation")(a.c0, a.c1, a.c2);
}
py::object to_python(const Affine& a) {
    py::array_t<double> matrix({3, 4});
    std::memcpy(matrix.mutable_data(), a.m, sizeof(a.m));
    return py::object(matrix);
}

double to_number(const py::handle& value, std::string_view name, const Range& range) {
    if (!is_number(value)) fail(name, range.text, value);
    const double x = PyFloat_AsDouble(value.ptr());
    if (x == -1 && PyErr_Occurred() != nullptr) {
        PyErr_Clear();
        fail(name, range.text, value);
    }
    if (!range.contains(x)) fail(name, range.text, value);
    return x;
}

Vec3 to_vec3(const py::handle& value, std::string_view name) {
    double x[3];
    numbers(value, name, "three numbers", 3, 3, x);
    return {x[0], x[1], x[2]};
}

Vec3 to_point(const py::handle& value, std::string_view name) {
    const Vec3 p = to_vec3(value, name);
    if (!is_coordinate(p)) fail(name, "three numbers from -1e12 to 1e12", value);
    return p;
}

Vec3 to_direction(const py::handle& value, std::string_view name) {
    const Vec3 d = to_point(value, name);
    if (is_zero(d)) fail(name, "a direction, which is not (0, 0, 0)", value);
    return d;
}

Color to_color(const py::handle& value, std::string_view name, const Range& range) {
    const std::string expected = fmt::format(
        "a color: three numbers, each {}; one number for grey; '#rrggbb'; or a name, such as 'red'",
        range.text);
    double c[4] = {};
    bool is_bytes = false;
    if (py::isinstance<py::str>(value)) {
        if (!parse_hex(value.cast<std::string>(), c)) {
            const py::object named = from_package("glint._colors", "named_color")(value);
            if (named.is_none()) fail(name, expected, value);
            numbers(named, name, expected, 3, 3, c);
        }
    } else if (is_number(value)) {
        is_bytes = py::isinstance(value, from_package("numpy", "uint8"));
        c[0] = c[1] = c[2] = is_bytes ? PyFloat_AsDouble(value.ptr()) : to_number(value, name, range);
    } else {
        is_bytes = py::isinstance<py::array_t<std::uint8_t>>(value);
        numbers(value, name, expected, 3, 4, c);
    }
    if (is_bytes)
        for (double& channel : c) channel /= 255;
    for (int i = 0; i < 3; ++i)
        if (!range.contains(c[i])) fail(name, expected, value);
    return {c[0], c[1], c[2]};
}

Attenuation to_attenuation(const py::handle& value, std::string_view name) {
    constexpr auto expected = "three coefficients c0, c1, c2 from 0 to 1e12, not all 0";
    double c[3];
    numbers(value, name, expected, 3, 3, c);
    for (const double x : c)
        if (!k_attenuation.contains(x)) fail(name, expected, value);
    if (c[0] == 0 && c[1] == 0 && c[2] == 0) fail(name, expected, value);
    return {c[0], c[1], c[2]};
}

Affine to_affine(const py::handle& value, std::string_view name) {
    const Doubles matrix = Doubles::ensure(value);
    if (!matrix) PyErr_Clear();
    if (!matrix || matrix.ndim() != 2 || (matrix.shape(0) != 3 && matrix.shape(0) != 4) ||
        matrix.shape(1) != 4)
        fail(name, "a matrix of 3x4 or 4x4 numbers", value);
    if (matrix.shape(0) == 4) {
        for (int i = 0; i < 4; ++i)
            if (matrix.at(3, i) != (i == 3 ? 1 : 0)) fail(name, "a last row of 0, 0, 0, 1", value);
    }
    Affine a;
    std::memcpy(a.m, matrix.data(), sizeof(a.m));
    return a;
}

py::object to_python(const std::vector<TextureColor>& colors) {
    if (colors.empty()) return py::none();
    py::list list;
    for (const TextureColor& c : colors) {
        const py::tuple color(to_python(c.color));
        list.append(c.alpha == 1 ? py::make_tuple(c.at, color) : py::make_tuple(c.at, color, c.alpha));
    }
    return list;
}

std::vector<TextureColor> to_color_map(const py::handle& value) {
    std::vector<TextureColor> colors;
    if (value.is_none()) return colors;
    for (const py::handle& item : value) {
        const std::string name = fmt::format("color_map: color {}", colors.size() + 1);
        if (!py::isinstance<py::sequence>(item) || py::isinstance<py::str>(item) || py::len(item) < 2 ||
            py::len(item) > 3)
            throw py::value_error(fmt::format(
                "{}: expected (place, color) or (place, color, alpha), found {}", name, repr_of(item)));
        const auto parts = item.cast<py::sequence>();
        TextureColor color{to_number(parts[0], name + ": place", k_fraction),
                           to_color(parts[1], name, k_channel)};
        if (parts.size() == 3) color.alpha = to_number(parts[2], name + ": alpha", k_fraction);
        colors.push_back(color);
    }
    if (const std::string mistake = mistake_in(colors); !mistake.empty()) throw py::value_error(mistake);
    return colors;
}

}  // namespace glint::python
