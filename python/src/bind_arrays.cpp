// SPDX-License-Identifier: Apache-2.0
// Many shapes from NumPy arrays, and hits of many rays as arrays.
#include <fmt/format.h>

#include <cstring>
#include <limits>

#include "arrays.h"
#include "errors.h"
#include "scene_state.h"

namespace glint::python {
namespace {

using Indices = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

// The material of the new shapes and, if each has its own, their colors.
struct Look {
    std::uint32_t material = k_none;
    std::vector<ShapeColor> colors = {};
};

Look add_look(SceneState& state, const py::object& colors, const py::object& material, std::size_t count) {
    const auto box = material.is_none() ? nullptr : material.cast<std::shared_ptr<MaterialBox>>();
    if (colors.is_none()) return {state.add(box)};
    ShapeColors found = to_shape_colors(colors, count);
    if (!found.one) return {state.add(box), std::move(found.each)};
    const Material colored = with_color(box ? box->value : Material{}, *found.one);
    return {state.add(std::make_shared<MaterialBox>(MaterialBox{colored, {}, box ? box->texture : nullptr}))};
}

// Adds `count` shapes; make(i) gives the parameters of each. Returns range(first, last).
template <class T, class Make>
py::object add_shapes(SceneState& state, std::size_t count, const py::object& colors,
                      const py::object& material, const Make& make) {
    if (count + state.scene().shapes.size() >= k_none) throw py::value_error("too many shapes");
    const Look look = add_look(state, colors, material, count);
    Scene& scene = state.add_shapes(count);
    auto& parameters = scene.get<T>();
    const std::size_t first = scene.shapes.size(), start = parameters.size();
    parameters.resize(start + count);
    scene.shapes.resize(first + count);
    for (std::size_t i = 0; i < count; ++i) {
        parameters[start + i] = make(i);
        scene.shapes[first + i] = {ShapeKindOf<T>::value, static_cast<std::uint32_t>(start + i),
                                   look.material, k_none};
    }
    if (!look.colors.empty()) {
        scene.shape_colors.resize(first);
        scene.shape_colors.insert(scene.shape_colors.end(), look.colors.begin(), look.colors.end());
    }
    return py::module_::import("builtins").attr("range")(first, first + count);
}

py::object add_spheres(SceneState& state, const py::object& centers, const py::object& radii,
                       const py::object& colors, const py::object& material) {
    const Doubles at = to_points_array(centers, "centers");
    const auto count = static_cast<std::size_t>(at.shape(0));
    const Lengths radius(radii, "radii", count);
    return add_shapes<Sphere>(state, count, colors, material, [&](std::size_t i) {
        return Sphere{point(at, i), radius[i]};
    });
}

py::object add_cylinders(SceneState& state, const py::object& from, const py::object& to,
                         const py::object& radii, const py::object& colors, const py::object& material,
                         bool caps) {
    const Doubles a = to_points_array(from, "from_"), b = to_points_array(to, "to");
    if (a.shape(0) != b.shape(0))
        throw py::value_error(fmt::format("from_ has {} points, to has {}", a.shape(0), b.shape(0)));
    const auto count = static_cast<std::size_t>(a.shape(0));
    const Lengths radius(radii, "radii", count);
    return add_shapes<Cylinder>(state, count, colors, material, [&](std::size_t i) {
        return Cylinder{point(a, i), point(b, i), radius[i], caps};
    });
}

// The triangles' corners: N x 3 x 3 numbers, or points and the indices of three for each.
Doubles corners(const py::object& values, const py::object& faces, std::string_view name) {
    if (faces.is_none()) {
        const Doubles array = to_doubles(values, name);
        if (array.ndim() != 3 || array.shape(1) != 3 || array.shape(2) != 3)
            throw py::value_error(
                fmt::format("{}: expected an array of N x 3 x 3 numbers, or N x 3 and faces, found {}", name,
                            shape_text(array)));
        return array;
    }
    const Doubles all = to_points_array(values, name);
    const Indices three = Indices::ensure(faces);
    if (!three) PyErr_Clear();
    if (!three || three.ndim() != 2 || three.shape(1) != 3)
        throw py::value_error("faces: expected an array of N x 3 indices");
    Doubles array({three.shape(0), py::ssize_t{3}, py::ssize_t{3}});
    double* to = array.mutable_data();
    for (py::ssize_t i = 0; i < three.size(); ++i) {
        const std::int64_t at = three.data()[i];
        if (at < 0 || at >= all.shape(0))
            throw py::index_error(fmt::format("faces[{}]: there is no vertex {}", i / 3, at));
        std::copy_n(all.data() + 3 * at, 3, to + 3 * i);
    }
    return array;
}

py::object add_triangles(SceneState& state, const py::object& vertices, const py::object& faces,
                         const py::object& normals, const py::object& colors, const py::object& material) {
    const Doubles at = corners(vertices, faces, "vertices");
    const auto count = static_cast<std::size_t>(at.shape(0));
    for (py::ssize_t i = 0; i < at.size(); ++i)
        if (!k_coordinate.contains(at.data()[i]))
            throw py::value_error(fmt::format("vertices[{}]: expected {}", i / 9, k_coordinate.text));
    if (normals.is_none()) {
        return add_shapes<Triangle>(state, count, colors, material, [&](std::size_t i) {
            return Triangle{{point(at, 3 * i), point(at, 3 * i + 1), point(at, 3 * i + 2)}};
        });
    }
    const Doubles up = corners(normals, faces, "normals");
    if (up.shape(0) != at.shape(0)) throw py::value_error("normals: expected as many as vertices");
    return add_shapes<SmoothTriangle>(state, count, colors, material, [&](std::size_t i) {
        return SmoothTriangle{{point(at, 3 * i), point(at, 3 * i + 1), point(at, 3 * i + 2)},
                              {point(up, 3 * i), point(up, 3 * i + 1), point(up, 3 * i + 2)}};
    });
}

// Of N x 3 numbers or three.
Doubles rays(const py::object& value, std::string_view name) {
    const Doubles array = to_doubles(value, name);
    if (array.ndim() < 1 || array.ndim() > 2 || array.shape(array.ndim() - 1) != 3)
        throw py::value_error(
            fmt::format("{}: expected an array of N x 3 numbers, found {}", name, shape_text(array)));
    return array;
}

py::tuple cast(SceneState& state, const py::object& origins, const py::object& directions, double t_min,
               double t_max, const py::object& progress) {
    const Doubles from = rays(origins, "origins"), towards = rays(directions, "directions");
    const std::size_t n = from.ndim() == 1 ? 1 : static_cast<std::size_t>(from.shape(0)),
                      m = towards.ndim() == 1 ? 1 : static_cast<std::size_t>(towards.shape(0));
    const std::size_t count = n == 1 ? m : n;
    if (n != count && n != 1) throw py::value_error("origins and directions differ in number");
    if (m != count && m != 1)
        throw py::value_error(fmt::format("there are {} origins and {} directions", n, m));
    std::vector<Ray> list(count);
    for (std::size_t i = 0; i < count; ++i)
        list[i] = {point(from, n == 1 ? 0 : i), point(towards, m == 1 ? 0 : i), t_min, t_max};
    const Snapshot snapshot = state.prepare({}, progress);
    const std::vector<RayHit> hits =
        value_or_raise(run(progress, [&](Running&) { return nearest_hits(snapshot.world, list); }));
    py::array_t<double> t(count), normals({count, std::size_t{3}}), hit_points({count, std::size_t{3}});
    py::array_t<std::int64_t> shapes(count);
    for (std::size_t i = 0; i < count; ++i) {
        const RayHit& hit = hits[i];
        const bool is_hit = hit.shape != k_none;
        const double at = is_hit ? hit.t : std::numeric_limits<double>::infinity();
        t.mutable_data()[i] = at;
        shapes.mutable_data()[i] = is_hit ? std::int64_t{hit.shape} : -1;
        const double no = std::numeric_limits<double>::quiet_NaN();
        const Vec3 normal = is_hit ? hit.normal : Vec3{},
                   p = is_hit ? list[i].origin + list[i].direction * at : Vec3{no, no, no};
        std::memcpy(normals.mutable_data() + 3 * i, &normal, sizeof(normal));
        std::memcpy(hit_points.mutable_data() + 3 * i, &p, sizeof(p));
    }
    return py::make_tuple(t, shapes, hit_points, normals);
}

// (min, max) of the bounded shapes; None if there are none.
py::object bounds_of(SceneState& state) {
    const Bounds bounds = scene_bounds(state.prepare({}, py::none(), 0, true).world);
    if (bounds.min.x > bounds.max.x) return py::none();
    return py::make_tuple(to_python(bounds.min), to_python(bounds.max));
}

}  // namespace

void bind_arrays(py::class_<SceneState, std::shared_ptr<SceneState>>& cls) {
    cls.def("add_spheres", &add_spheres)
        .def("add_cylinders", &add_cylinders)
        .def("add_triangles", &add_triangles)
        .def("cast_rays", &cast)
        .def("bounds", &bounds_of);
    bind_shape_arrays(cls);
}

}  // namespace glint::python
