// SPDX-License-Identifier: Apache-2.0
// Parameters, colors, transforms and materials of many shapes as arrays. The setters check everything first.
#include <pybind11/stl.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "arrays.h"
#include "scene/validate_transform.h"
#include "scene_state.h"

namespace glint::python {
namespace {

using Numbers = std::vector<std::uint32_t>;

Numbers numbers_of(const SceneState& state, const py::array_t<std::int64_t>& array) {
    const auto given = array.unchecked<1>();
    const auto count = static_cast<std::int64_t>(state.stored().shapes.size());
    Numbers numbers(static_cast<std::size_t>(given.shape(0)));
    for (py::ssize_t i = 0; i < given.shape(0); ++i) {
        if (given(i) < 0 || given(i) >= count) throw py::index_error("index out of range");
        numbers[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(given(i));
    }
    return numbers;
}

// A parameter of some kinds of shapes: `each` numbers.
struct Parameter {
    std::string_view name, kinds;
    std::vector<py::ssize_t> each;
    const Range& range;
    double* (*find)(Scene& scene, const Shape& shape);  ///< null for other kinds
};

double* find_center(Scene& scene, const Shape& shape) {
    if (shape.kind == ShapeKind::sphere) return &scene.get<Sphere>()[shape.index].center.x;
    if (shape.kind == ShapeKind::disc) return &scene.get<Disc>()[shape.index].center.x;
    if (shape.kind == ShapeKind::torus) return &scene.get<Torus>()[shape.index].center.x;
    return nullptr;
}
double* find_radius(Scene& scene, const Shape& shape) {
    if (shape.kind == ShapeKind::sphere) return &scene.get<Sphere>()[shape.index].radius;
    if (shape.kind == ShapeKind::cylinder) return &scene.get<Cylinder>()[shape.index].radius;
    if (shape.kind == ShapeKind::disc) return &scene.get<Disc>()[shape.index].radius;
    if (shape.kind == ShapeKind::torus) return &scene.get<Torus>()[shape.index].radius;
    return nullptr;
}
double* find_from(Scene& scene, const Shape& shape) {
    if (shape.kind == ShapeKind::cylinder) return &scene.get<Cylinder>()[shape.index].from.x;
    if (shape.kind == ShapeKind::cone) return &scene.get<Cone>()[shape.index].from.x;
    return nullptr;
}
double* find_to(Scene& scene, const Shape& shape) {
    if (shape.kind == ShapeKind::cylinder) return &scene.get<Cylinder>()[shape.index].to.x;
    if (shape.kind == ShapeKind::cone) return &scene.get<Cone>()[shape.index].to.x;
    return nullptr;
}
double* find_vertices(Scene& scene, const Shape& shape) {
    if (shape.kind == ShapeKind::triangle) return &scene.get<Triangle>()[shape.index].vertices[0].x;
    if (shape.kind == ShapeKind::smooth_triangle)
        return &scene.get<SmoothTriangle>()[shape.index].vertices[0].x;
    return nullptr;
}
double* find_normals(Scene& scene, const Shape& shape) {
    if (shape.kind == ShapeKind::smooth_triangle)
        return &scene.get<SmoothTriangle>()[shape.index].normals[0].x;
    return nullptr;
}

const Parameter& parameter_named(const std::string& name) {
    static const Parameter all[] = {
        {"centers", "spheres, discs and tori", {3}, k_coordinate, find_center},
        {"radii", "spheres, cylinders, discs and tori", {}, k_length, find_radius},
        {"from_", "cylinders and cones", {3}, k_coordinate, find_from},
        {"to", "cylinders and cones", {3}, k_coordinate, find_to},
        {"vertices", "triangles and smooth triangles", {3, 3}, k_coordinate, find_vertices},
        {"normals", "smooth triangles", {3, 3}, k_coordinate, find_normals},
    };
    for (const Parameter& parameter : all)
        if (parameter.name == name) return parameter;
    throw py::key_error(name);
}

std::size_t size_of(const Parameter& parameter) {
    std::size_t size = 1;
    for (const py::ssize_t n : parameter.each) size *= static_cast<std::size_t>(n);
    return size;
}

void check_kinds(const SceneState& state, const Parameter& parameter, const Numbers& numbers) {
    auto& scene = const_cast<Scene&>(state.stored());  // find() does not change it
    for (const std::uint32_t i : numbers) {
        if (parameter.find(scene, scene.shapes[i]) != nullptr) continue;
        const std::string_view name = scene.shape_texts.name(i);
        throw py::type_error(fmt::format(
            "{0}: expected {1}, found the shape {2}, which is of the kind {3}{4}; choose {1}, as in "
            "scene.shapes[numbers].{0}",
            parameter.name, parameter.kinds, i, to_string(scene.shapes[i].kind),
            name.empty() ? "" : fmt::format(" and has the name {}", repr_of(py::str(std::string(name))))));
    }
}

Doubles parameters_of(SceneState& state, const py::array_t<std::int64_t>& which, const std::string& name) {
    const Parameter& parameter = parameter_named(name);
    auto& scene = const_cast<Scene&>(state.scene());  // find() does not change it
    const Numbers numbers = numbers_of(state, which);
    check_kinds(state, parameter, numbers);
    std::vector<py::ssize_t> shape{which.shape(0)};
    shape.insert(shape.end(), parameter.each.begin(), parameter.each.end());
    Doubles array(shape);
    const std::size_t size = size_of(parameter);
    double* to = array.mutable_data();
    for (const std::uint32_t i : numbers) to = std::copy_n(parameter.find(scene, scene.shapes[i]), size, to);
    return array;
}

void set_parameters(SceneState& state, const py::array_t<std::int64_t>& which, const std::string& name,
                    const py::object& value) {
    const Parameter& parameter = parameter_named(name);
    state.scene();
    const Numbers numbers = numbers_of(state, which);
    check_kinds(state, parameter, numbers);
    const Doubles array = to_doubles(value, name);
    const std::size_t size = size_of(parameter);
    const bool is_one = parameter.each.empty() && array.ndim() == 0;  // for all
    std::vector<py::ssize_t> expected{which.shape(0)};
    expected.insert(expected.end(), parameter.each.begin(), parameter.each.end());
    if (!is_one && !std::equal(expected.begin(), expected.end(), array.shape(), array.shape() + array.ndim()))
        throw py::value_error(fmt::format("{}: expected {}{}, found {}", name,
                                          parameter.each.empty() ? "one number or " : "an array of ",
                                          fmt::join(expected, " x "), shape_text(array)));
    check_range(array, name, parameter.range, size);
    state.edit_shapes(numbers, [&](Scene& scene) {
        const double* from = array.data();
        for (const std::uint32_t i : numbers) {
            std::copy_n(from, size, parameter.find(scene, scene.shapes[i]));
            if (!is_one) from += size;
        }
    });
}

Doubles colors_of(SceneState& state, const py::array_t<std::int64_t>& which) {
    const Scene& scene = state.scene();
    Doubles array({which.shape(0), py::ssize_t{3}});
    double* to = array.mutable_data();
    for (const std::uint32_t i : numbers_of(state, which)) {
        const ShapeColor color = i < scene.shape_colors.size() ? scene.shape_colors[i] : ShapeColor{};
        *to++ = color.r, *to++ = color.g, *to++ = color.b;
    }
    return array;
}

void set_colors(SceneState& state, const py::array_t<std::int64_t>& which, const py::object& value) {
    state.scene();
    const Numbers numbers = numbers_of(state, which);
    ShapeColors colors{{}, {ShapeColor{}}};  // of None
    if (!value.is_none()) colors = to_shape_colors(value, numbers.size());
    if (colors.one) {
        Scene rounded;
        rounded.set_shape_color(0, colors.one);
        colors.each = rounded.shape_colors;
    }
    const bool is_one = value.is_none() || colors.one;
    state.edit_shapes(numbers, [&](Scene& scene) {
        scene.shape_colors.resize(scene.shapes.size());
        for (std::size_t i = 0; i < numbers.size(); ++i)
            scene.shape_colors[numbers[i]] = colors.each[is_one ? 0 : i];
    });
}

Doubles transforms_of(SceneState& state, const py::array_t<std::int64_t>& which) {
    const Scene& scene = state.scene();
    Doubles array({which.shape(0), py::ssize_t{3}, py::ssize_t{4}});
    double* to = array.mutable_data();
    for (const std::uint32_t i : numbers_of(state, which)) {
        const std::uint32_t transform = scene.shapes[i].transform;
        const Affine map = transform == k_none ? Affine{} : scene.transforms[transform];
        to = std::copy_n(&map.m[0][0], 12, to);
    }
    return array;
}

// N matrices, or one for all.
std::vector<Affine> to_affines(const py::object& value, std::size_t count) {
    const Doubles array = to_doubles(value, "transforms");
    const py::ssize_t n = array.ndim();
    const bool is_matrix =
        (n == 2 || n == 3) && (array.shape(n - 2) == 3 || array.shape(n - 2) == 4) && array.shape(n - 1) == 4;
    if (!is_matrix || (n == 3 && static_cast<std::size_t>(array.shape(0)) != count))
        throw py::value_error(
            fmt::format("transforms: expected an array of {0} x 3 x 4 or {0} x 4 x 4 numbers, one matrix, or "
                        "None, found {1}",
                        count, shape_text(array)));
    const auto size = static_cast<std::size_t>(4 * array.shape(n - 2));
    std::vector<Affine> maps(static_cast<std::size_t>(array.size()) / size);
    const double* from = array.data();
    for (std::size_t i = 0; i < maps.size(); ++i, from += size) {
        if (size == 16 && !(from[12] == 0 && from[13] == 0 && from[14] == 0 && from[15] == 1))
            throw py::value_error(
                fmt::format("transforms[{}]: expected a last row of 0, 0, 0, 1, found {}, {}, {}, {}", i,
                            from[12], from[13], from[14], from[15]));
        std::memcpy(maps[i].m, from, sizeof(maps[i].m));
        if (const std::string_view mistake = mistake_in(maps[i]); !mistake.empty())
            throw py::value_error(fmt::format("transforms[{}]{}", i, mistake));
    }
    return maps;
}

// Each shape gets a transform of its own. Those that no other shape uses are written again, so that films do
// not fill the memory.
void set_transforms(SceneState& state, const py::array_t<std::int64_t>& which, const py::object& value) {
    state.scene();
    const Numbers numbers = numbers_of(state, which);
    const std::vector<Affine> maps =
        value.is_none() ? std::vector<Affine>(1) : to_affines(value, numbers.size());
    const bool is_one = value.is_none() || maps.size() != numbers.size();
    state.edit_shapes(numbers, [&](Scene& scene) {
        std::vector<std::uint32_t> uses(scene.transforms.size());
        for (const Shape& shape : scene.shapes) {
            if (shape.transform != k_none) ++uses[shape.transform];
            for (const Shape& part : operands_of(scene, shape))
                if (part.transform != k_none) ++uses[part.transform];
        }
        std::size_t free = 0;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const Affine& map = maps[is_one ? 0 : i];
            std::uint32_t& at = scene.shapes[numbers[i]].transform;
            if (at != k_none) --uses[at];
            if (map == Affine{}) {
                at = k_none;
                continue;
            }
            if (at == k_none || uses[at] != 0) {
                while (free < uses.size() && uses[free] != 0) ++free;
                if (free == uses.size()) {
                    uses.push_back(0);
                    scene.transforms.emplace_back();
                }
                at = static_cast<std::uint32_t>(free);
            }
            ++uses[at];
            scene.transforms[at] = map;
        }
    });
}

py::list materials_of(SceneState& state, const py::array_t<std::int64_t>& which) {
    const Scene& scene = state.scene();
    const Numbers numbers = numbers_of(state, which);
    std::vector<py::object> objects(scene.materials.size());
    py::list list(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::uint32_t material = scene.shapes[numbers[i]].material;
        if (material == k_none) {
            list[i] = py::none();
            continue;
        }
        if (!objects[material]) objects[material] = py::cast(state.material(material));
        list[i] = objects[material];
    }
    return list;
}

// materials: one for all, or one for each; the caller has checked this.
void set_materials(SceneState& state, const py::array_t<std::int64_t>& which,
                   const std::vector<std::shared_ptr<MaterialBox>>& materials) {
    state.scene();
    const Numbers numbers = numbers_of(state, which);
    std::vector<std::uint32_t> rows;
    rows.reserve(materials.size());
    for (const auto& material : materials) rows.push_back(state.add(material));
    state.edit_shapes(numbers, [&](Scene& scene) {
        for (std::size_t i = 0; i < numbers.size(); ++i)
            scene.shapes[numbers[i]].material = rows[rows.size() == 1 ? 0 : i];
    });
}

}  // namespace

void bind_shape_arrays(py::class_<SceneState, std::shared_ptr<SceneState>>& cls) {
    cls.def("shape_parameters", &parameters_of)
        .def("set_shape_parameters", &set_parameters)
        .def("shape_colors", &colors_of)
        .def("set_shape_colors", &set_colors)
        .def("shape_transforms", &transforms_of)
        .def("set_shape_transforms", &set_transforms)
        .def("shape_materials", &materials_of)
        .def("set_shape_materials", &set_materials)
        .def("removals", &SceneState::removals);
}

}  // namespace glint::python
