// SPDX-License-Identifier: Apache-2.0
#include "mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/ranges.h"

namespace glint::python {
namespace {

template <class T> using Rows = py::array_t<T, py::array::c_style | py::array::forcecast>;

// An array with rows of three numbers, or as many as `columns` says. The error names the argument.
template <class T> Rows<T> to_rows(const py::object& value, const char* name, py::ssize_t columns = 3) {
    Rows<T> rows = Rows<T>::ensure(value);
    if (!rows) {
        PyErr_Clear();
        throw py::type_error(fmt::format("{}: expected an array of N x {} numbers", name, columns));
    }
    if (rows.ndim() != 2 || rows.shape(1) != columns) {
        throw py::value_error(
            fmt::format("{}: expected an array of N x {} numbers, found {} dimensions{}", name, columns,
                        rows.ndim(), rows.ndim() == 2 ? fmt::format(", {} columns", rows.shape(1)) : ""));
    }
    return rows;
}

template <class T, class Item> std::vector<Item> items_of(const Rows<T>& rows) {
    static_assert(sizeof(Item) == 3 * sizeof(T));
    std::vector<Item> items(static_cast<std::size_t>(rows.shape(0)));
    const T* from = rows.data();
    for (Item& item : items) {
        T* const to = reinterpret_cast<T*>(&item);
        std::copy_n(from, 3, to);
        from += 3;
    }
    return items;
}

// Refuses what prepare() would, at once. The error names the argument and the row.
template <class T> void check_numbers(const Rows<T>& rows, const char* name) {
    for (py::ssize_t i = 0; i < rows.size(); ++i) {
        if (const double x = rows.data()[i]; !k_coordinate.contains(x))
            throw py::value_error(fmt::format("{}: row {}: expected {}, found {}", name, i / rows.shape(1),
                                              k_coordinate.text, x));
    }
}

// The positions or values of an argument.
template <class T, class Item> std::vector<Item> checked_items(const py::object& value, const char* name) {
    const Rows<T> rows = to_rows<T>(value, name);
    check_numbers(rows, name);
    return items_of<T, Item>(rows);
}

template <class T> bool is_array_of(const py::object& value) {
    return py::isinstance<py::array>(value) && py::isinstance<py::array_t<T>>(value);
}

template <class T> std::vector<TriangleCorners> triangles_of(const py::object& value, std::size_t vertices) {
    const Rows<T> rows = to_rows<T>(value, "triangles");
    const auto count = static_cast<double>(vertices);
    std::vector<TriangleCorners> triangles(static_cast<std::size_t>(rows.shape(0)));
    const T* at = rows.data();
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::uint32_t& corner : triangles[i]) {
            const auto x = static_cast<double>(*at);
            if (!(x >= 0 && x < count))
                throw py::value_error(fmt::format(
                    "triangles: triangle {}: expected a vertex below {}, found {}", i, count, *at));
            if (x != std::floor(x))
                throw py::value_error(
                    fmt::format("triangles: triangle {}: expected a whole number, found {}", i, *at));
            corner = static_cast<std::uint32_t>(*at++);
        }
    }
    return triangles;
}

// Arrays of the usual types are read in place. All others, as doubles: negative numbers and fractions are not
// taken for others.
std::vector<TriangleCorners> triangles_in(const py::object& value, std::size_t vertices) {
    if (is_array_of<std::int32_t>(value)) return triangles_of<std::int32_t>(value, vertices);
    if (is_array_of<std::uint32_t>(value)) return triangles_of<std::uint32_t>(value, vertices);
    if (is_array_of<std::int64_t>(value)) return triangles_of<std::int64_t>(value, vertices);
    return triangles_of<double>(value, vertices);
}

void check_count(const CornerValues& of, const char* name, std::size_t vertices) {
    if (of.values.size() == vertices) return;
    throw py::value_error(
        fmt::format("{}: expected {}, one for each vertex, found {}", name, vertices, of.values.size()));
}

void set_values(CornerValues& to, const py::object& rows, const char* name, std::size_t vertices) {
    if (rows.is_none()) return;
    to.values = checked_items<float, Float3>(rows, name);
    check_count(to, name, vertices);
}

void set_colors(CornerValues& to, const py::object& rows, std::size_t vertices) {
    set_values(to, rows, "colors", vertices);
    if (!is_array_of<std::uint8_t>(rows)) return;
    for (Float3& color : to.values) color = {color.x / 255.0f, color.y / 255.0f, color.z / 255.0f};
}

void set_texture_coordinates(CornerValues& to, const py::object& value, std::size_t vertices) {
    constexpr auto name = "texture_coordinates";
    if (value.is_none()) return;
    const Rows<float> rows = to_rows<float>(value, name, 2);
    check_numbers(rows, name);
    to.values.resize(static_cast<std::size_t>(rows.shape(0)));
    const float* from = rows.data();
    for (Float3& uv : to.values) {
        uv = {from[0], from[1], 0};
        from += 2;
    }
    check_count(to, name, vertices);
}

std::shared_ptr<const MeshData> make_data(const py::object& vertices, const py::object& triangles,
                                          const py::object& normals, const py::object& colors,
                                          const py::object& texture_coordinates) {
    auto data = std::make_shared<MeshData>();
    if (is_array_of<float>(vertices)) {
        data->single_positions = checked_items<float, Float3>(vertices, "vertices");
    } else {
        data->positions = checked_items<double, Vec3>(vertices, "vertices");
    }
    data->triangles = triangles_in(triangles, data->vertex_count());
    set_values(data->normals, normals, "normals", data->vertex_count());
    set_colors(data->colors, colors, data->vertex_count());
    set_texture_coordinates(data->texture_coordinates, texture_coordinates, data->vertex_count());
    return data;
}

// A read-only view of the first numbers of each item of a list, which keeps the data alive.
template <class T, class Item>
py::object rows_of(const std::vector<Item>& items, const std::shared_ptr<const MeshData>& data,
                   py::ssize_t columns = 3) {
    const py::capsule owner(new std::shared_ptr<const MeshData>(data),
                            [](void* held) { delete static_cast<std::shared_ptr<const MeshData>*>(held); });
    py::array_t<T> rows({static_cast<py::ssize_t>(items.size()), columns},
                        {static_cast<py::ssize_t>(sizeof(Item)), static_cast<py::ssize_t>(sizeof(T))},
                        reinterpret_cast<const T*>(items.data()), owner);
    rows.attr("flags").attr("writeable") = false;
    return rows;
}

py::object values_of(const CornerValues& of, const std::shared_ptr<const MeshData>& data) {
    return of.empty() ? py::none() : rows_of<float>(of.values, data);
}

std::uint32_t index_in(Scene& scene, const std::shared_ptr<const MeshData>& data) {
    const auto found = std::find(scene.meshes.begin(), scene.meshes.end(), data);
    if (found == scene.meshes.end()) {
        scene.meshes.push_back(data);
        return static_cast<std::uint32_t>(scene.meshes.size() - 1);
    }
    return static_cast<std::uint32_t>(found - scene.meshes.begin());
}

}  // namespace

bool MeshBox::is_shape(const Scene& scene, std::uint32_t index, std::span<const std::uint32_t>) const {
    const Shape& shape = scene.shapes[index];
    return shape.kind == ShapeKind::mesh && scene.meshes[scene.get<Mesh>()[shape.index].mesh] == data;
}
void MeshBox::write(Scene& scene, std::uint32_t index, std::span<const std::uint32_t>) const {
    append(scene, {});
    const std::uint32_t last = scene.shapes.back().index;
    scene.shapes.pop_back();
    scene.shapes[index].kind = ShapeKind::mesh;
    scene.shapes[index].index = last;
}
void MeshBox::append(Scene& scene, std::span<const std::uint32_t>) const {
    scene.add(Mesh{index_in(scene, data)});
}
std::string MeshBox::text() const {
    return fmt::format("<{} vertices, {} triangles>", data->vertex_count(), data->triangles.size());
}
bool MeshBox::same(const ShapeBox& other) const {
    const auto* mesh = dynamic_cast<const MeshBox*>(&other);
    return mesh != nullptr && (mesh->data == data || *mesh->data == *data);
}

void bind_mesh(py::module_& m) {
    py::class_<MeshBox, ShapeBox, std::shared_ptr<MeshBox>>(
        m, "Mesh",
        "Mesh(vertices, triangles, normals=None, colors=None, texture_coordinates=None): triangles with "
        "common vertices. The data does not change; copies of a mesh share it.")
        .def(py::init([](const py::object& vertices, const py::object& triangles, const py::object& normals,
                         const py::object& colors, const py::object& texture_coordinates,
                         const py::kwargs& keywords) {
                 auto shape = std::make_shared<MeshBox>();
                 shape->data = make_data(vertices, triangles, normals, colors, texture_coordinates);
                 for (const auto& [key, value] : keywords)
                     if (!set_common(*shape, py::str(key), value))
                         throw py::type_error("mesh has no attribute " + py::repr(key).cast<std::string>());
                 return shape;
             }),
             py::arg("vertices"), py::arg("triangles"), py::arg("normals") = py::none(),
             py::arg("colors") = py::none(), py::arg("texture_coordinates") = py::none())
        .def_property_readonly(
            "vertices",
            [](const MeshBox& mesh) -> py::object {
                if (mesh.data->single_positions.empty())
                    return rows_of<double>(mesh.data->positions, mesh.data);
                return rows_of<float>(mesh.data->single_positions, mesh.data);
            },
            "Points in object coordinates, as an N x 3 array, of float32 if they were given so, else of "
            "float64")
        .def_property_readonly(
            "triangles",
            [](const MeshBox& mesh) { return rows_of<std::uint32_t>(mesh.data->triangles, mesh.data); },
            "Numbers of vertices, as an N x 3 array; counter-clockwise around the normal")
        .def_property_readonly(
            "normals",
            [](const MeshBox& mesh) -> py::object { return values_of(mesh.data->normals, mesh.data); },
            "Of any length, as an N x 3 array of float32, one for each vertex unless the mesh is from a file "
            "that numbers them otherwise; None: the triangles are flat")
        .def_property_readonly(
            "colors",
            [](const MeshBox& mesh) -> py::object { return values_of(mesh.data->colors, mesh.data); },
            "Linear colors, as an N x 3 array of float32, which are interpolated and replace the color of "
            "the "
            "shape; one for each vertex, as the normals; None: the triangles have the shape's color")
        .def_property_readonly(
            "texture_coordinates",
            [](const MeshBox& mesh) -> py::object {
                const CornerValues& of = mesh.data->texture_coordinates;
                return of.empty() ? py::none() : rows_of<float>(of.values, mesh.data, 2);
            },
            "u (to the right) and v (up) of textures, as an N x 2 array of float32; (0, 0) is the lower left "
            "corner of the picture; one for each vertex, as the normals; None: textures with mapping 'uv' "
            "do not show");
}

}  // namespace glint::python
