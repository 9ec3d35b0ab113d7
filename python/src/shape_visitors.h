// SPDX-License-Identifier: Apache-2.0
#pragma once
// The parameters of shapes as attributes of Python objects. Visitors of visit_parameters() look for one by
// its name.
#include <fmt/format.h>

#include <algorithm>
#include <concepts>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "shape_fields.h"
#include "values.h"

namespace glint::python {

/// N x 3 numbers.
inline py::object points_to_python(const Vec3* points, std::size_t count) {
    py::array_t<double> array({count, std::size_t{3}});
    std::copy_n(&points[0].x, 3 * count, array.mutable_data());
    return py::object(array);
}

inline std::vector<Vec3> to_points(const py::handle& value, std::string_view name) {
    std::vector<Vec3> points;
    for (const py::handle& point : value) points.push_back(to_point(point, name));
    return points;
}

/// Visitors of the parameters. Each looks for one by its name.
struct Get {
    std::string_view name;
    py::object found = {};
    template <class Value> void take(std::string_view at, const Value& value) {
        if (at == name) found = to_python(value);
    }
    void point(std::string_view at, const Vec3& v) { take(at, v); }
    void direction(std::string_view at, const Vec3& v) { take(at, v); }
    void length(std::string_view at, double x) { take(at, x); }
    void radius(std::string_view at, double x) { take(at, x); }
    void coefficients(std::string_view at, const Vec3& v) { take(at, v); }
    void coefficient(std::string_view at, double x) { take(at, x); }
    void flag(std::string_view at, bool x) { take(at, x); }
    void points(std::string_view at, const Vec3 (&v)[3]) {
        if (at == name) found = points_to_python(v, 3);
    }
};

struct Set {
    std::string_view name;
    const py::handle& value;
    void point(std::string_view at, Vec3& v) {
        if (at == name) v = to_point(value, at);
    }
    void direction(std::string_view at, Vec3& v) {
        if (at == name) v = to_direction(value, at);
    }
    void length(std::string_view at, double& x) {
        if (at == name) x = to_number(value, at, k_length);
    }
    void radius(std::string_view at, double& x) {
        if (at == name) x = to_number(value, at, k_not_negative);
    }
    void coefficients(std::string_view at, Vec3& v) { point(at, v); }
    void coefficient(std::string_view at, double& x) {
        if (at == name) x = to_number(value, at, k_coordinate);
    }
    void flag(std::string_view at, bool& x) {
        if (at == name) x = value.cast<bool>();
    }
    void points(std::string_view at, Vec3 (&v)[3]) {
        if (at != name) return;
        const std::vector<Vec3> given = to_points(value, at);
        if (given.size() != 3)
            throw py::value_error(fmt::format("{}: expected three points, found {}", at, repr_of(value)));
        std::copy_n(given.begin(), 3, v);
    }
};

struct Names {
    std::vector<std::pair<std::string, const char*>> names = {};
    void add(std::string_view name, const char* doc) { names.emplace_back(name, doc); }
    void point(std::string_view at, const Vec3&) {
        add(at, "A point in world space, or that of `transform`");
    }
    void direction(std::string_view at, const Vec3&) { add(at, "A direction of any length but 0"); }
    void length(std::string_view at, double) { add(at, "A number > 0, in the scene's units"); }
    void radius(std::string_view at, double) { add(at, "A number >= 0, in the scene's units"); }
    void coefficients(std::string_view at, const Vec3&) { add(at, "Three numbers"); }
    void coefficient(std::string_view at, double) { add(at, "A number"); }
    void flag(std::string_view at, bool) { add(at, "Whether the ends are closed by discs"); }
    void points(std::string_view at, const Vec3 (&)[3]) {
        add(at, "Three points or normals, as a 3x3 array");
    }
};

/// Whether two shapes have the same parameters: all are numbers, without padding but after `caps`.
struct Numbers {
    std::vector<double> all = {};
    void add(const Vec3& v) { all.insert(all.end(), {v.x, v.y, v.z}); }
    void point(std::string_view, const Vec3& v) { add(v); }
    void direction(std::string_view, const Vec3& v) { add(v); }
    void length(std::string_view, double x) { all.push_back(x); }
    void radius(std::string_view, double x) { all.push_back(x); }
    void coefficients(std::string_view, const Vec3& v) { add(v); }
    void coefficient(std::string_view, double x) { all.push_back(x); }
    void flag(std::string_view, bool x) { all.push_back(x ? 1 : 0); }
    void points(std::string_view, const Vec3 (&v)[3]) {
        for (const Vec3& p : v) add(p);
    }
};

template <class T> bool equal(const T& a, const T& b) {
    Numbers x, y;
    visit_parameters(a, x);
    visit_parameters(b, y);
    return x.all == y.all;
}

template <class T> std::vector<std::pair<std::string, const char*>> names_of() {
    Names names;
    const T shape{};
    visit_parameters(shape, names);
    return names.names;
}

}  // namespace glint::python
