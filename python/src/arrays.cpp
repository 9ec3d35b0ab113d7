// SPDX-License-Identifier: Apache-2.0
#include "arrays.h"

#include <fmt/format.h>

namespace glint::python {

std::string shape_text(const py::array& array) {
    std::string text;
    for (py::ssize_t i = 0; i < array.ndim(); ++i)
        text += fmt::format("{}{}", i == 0 ? "" : " x ", array.shape(i));
    return text.empty() ? "one number" : text;
}

Doubles to_doubles(const py::handle& value, std::string_view name) {
    Doubles array = Doubles::ensure(value);
    if (!array) {
        PyErr_Clear();
        throw py::value_error(fmt::format("{}: expected an array of numbers", name));
    }
    return array;
}

void check_range(const Doubles& array, std::string_view name, const Range& range, std::size_t each) {
    const double* x = array.data();
    const auto count = static_cast<std::size_t>(array.size());
    for (std::size_t i = 0; i < count; ++i)
        if (!range.contains(x[i]))
            throw py::value_error(
                fmt::format("{}[{}]: expected {}, found {}", name, i / each, range.text, x[i]));
}

Doubles to_points_array(const py::handle& value, std::string_view name) {
    Doubles array = to_doubles(value, name);
    if (array.ndim() != 2 || array.shape(1) != 3)
        throw py::value_error(
            fmt::format("{}: expected an array of N x 3 numbers, found {}", name, shape_text(array)));
    check_range(array, name, k_coordinate, 3);
    return array;
}

Lengths::Lengths(const py::handle& value, std::string_view name, std::size_t count)
    : array_(to_doubles(value, name)) {
    if (array_.ndim() > 1 || (array_.ndim() == 1 && static_cast<std::size_t>(array_.size()) != count))
        throw py::value_error(
            fmt::format("{}: expected one number or {}, found {}", name, count, shape_text(array_)));
    check_range(array_, name, k_length, 1);
    step_ = array_.ndim() == 0 ? 0 : 1;
}

ShapeColors to_shape_colors(const py::object& colors, std::size_t count) {
    auto array =
        is_number(colors) || py::isinstance<py::str>(colors) ? Doubles() : to_doubles(colors, "colors");
    if (array.ndim() != 2) return {to_color(colors, "colors", k_channel)};
    const auto channels = static_cast<std::size_t>(array.shape(1));
    if (static_cast<std::size_t>(array.shape(0)) != count || (channels != 3 && channels != 4))
        throw py::value_error(fmt::format(
            "colors: expected one color or an array of {} x 3 numbers, found {}", count, shape_text(array)));
    if (py::isinstance<py::array_t<std::uint8_t>>(colors)) {  // of which to_doubles() made a copy
        double* const channel = array.mutable_data();
        for (py::ssize_t i = 0; i < array.size(); ++i) channel[i] /= 255;
    }
    check_range(array, "colors", k_channel, channels);
    ShapeColors result{{}, std::vector<ShapeColor>(count)};
    const double* c = array.data();
    for (ShapeColor& color : result.each) {
        color = {static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2])};
        c += channels;
    }
    return result;
}

}  // namespace glint::python
