// SPDX-License-Identifier: Apache-2.0
#include "shapes.h"

#include <fmt/format.h>

#include <concepts>
#include <unordered_map>

#include "base/text.h"
#include "mesh.h"
#include "shape_visitors.h"
#include "solid.h"

namespace glint::python {
namespace {

// A class for each kind.
template <class T> struct ShapeOf : ShapeBox {
    T value;

    void read(const Scene& scene, const Shape& shape) override { value = scene.get<T>()[shape.index]; }
    ShapeKind kind() const override { return ShapeKindOf<T>::value; }
    bool is_shape(const Scene& scene, std::uint32_t index, std::span<const std::uint32_t>) const override {
        const Shape& shape = scene.shapes[index];
        return shape.kind == kind() && equal(scene.get<T>()[shape.index], value);
    }
    void write(Scene& scene, std::uint32_t index, std::span<const std::uint32_t>) const override {
        Shape& shape = scene.shapes[index];
        if (shape.kind == kind()) {
            scene.get<T>()[shape.index] = value;
            return;
        }
        scene.get<T>().push_back(value);
        shape.kind = kind();
        shape.index = static_cast<std::uint32_t>(scene.get<T>().size() - 1);
    }
    void append(Scene& scene, std::span<const std::uint32_t>) const override { scene.add(value); }
    std::shared_ptr<ShapeBox> copy() const override { return std::make_shared<ShapeOf>(*this); }
    std::string text() const override {
        std::string text;
        for (const auto& [parameter, doc] : names_of<T>()) {
            Get get{parameter};
            visit_parameters(value, get);
            const bool is_array = py::isinstance<py::array>(get.found);
            text += fmt::format("{}{}={}", text.empty() ? "" : ", ", parameter,
                                repr_of(is_array ? get.found.attr("tolist")() : get.found));
        }
        return text;
    }
    bool same(const ShapeBox& other) const override {
        const auto* same_kind = dynamic_cast<const ShapeOf*>(&other);
        return same_kind != nullptr && equal(same_kind->value, value);
    }
};

template <> struct ShapeOf<Polygon> : ShapeBox {
    std::vector<Vec3> vertices;

    void read(const Scene& scene, const Shape& shape) override {
        const Polygon polygon = scene.get<Polygon>()[shape.index];
        const auto first = scene.polygon_vertices.begin() + polygon.first;
        vertices.assign(first, first + polygon.count);
    }
    ShapeKind kind() const override { return ShapeKind::polygon; }
    bool is_shape(const Scene& scene, std::uint32_t index, std::span<const std::uint32_t>) const override {
        const Shape& shape = scene.shapes[index];
        if (shape.kind != ShapeKind::polygon) return false;
        const Polygon& polygon = scene.get<Polygon>()[shape.index];
        return polygon.count == vertices.size() &&
               std::equal(vertices.begin(), vertices.end(), scene.polygon_vertices.begin() + polygon.first);
    }
    void write(Scene& scene, std::uint32_t index, std::span<const std::uint32_t>) const override {
        append(scene, {});
        const std::uint32_t last = scene.shapes.back().index;
        scene.shapes.pop_back();
        scene.shapes[index].kind = ShapeKind::polygon;
        scene.shapes[index].index = last;
    }
    void append(Scene& scene, std::span<const std::uint32_t>) const override {
        const auto first = static_cast<std::uint32_t>(scene.polygon_vertices.size());
        scene.polygon_vertices.insert(scene.polygon_vertices.end(), vertices.begin(), vertices.end());
        scene.add(Polygon{first, static_cast<std::uint32_t>(vertices.size())});
    }
    std::shared_ptr<ShapeBox> copy() const override { return std::make_shared<ShapeOf>(*this); }
    std::string text() const override {
        py::list points;
        for (const Vec3& v : vertices) points.append(to_python(v));
        return "vertices=" + repr_of(points);
    }
    bool same(const ShapeBox& other) const override {
        const auto* polygon = dynamic_cast<const ShapeOf*>(&other);
        return polygon != nullptr && polygon->vertices == vertices;
    }
};

template <class T> struct BoxFor { using type = ShapeOf<T>; };
template <> struct BoxFor<Mesh> { using type = MeshBox; };
template <> struct BoxFor<Solid> { using type = SolidBox; };

void set_material(ShapeBox& shape, const py::handle& material) {
    shape.material = material.is_none() ? nullptr : material.cast<std::shared_ptr<MaterialBox>>();
}
// Rounds to single precision, as the scene does.
void set_shape_color(ShapeBox& shape, const py::handle& color) {
    Scene scene;
    if (!color.is_none()) scene.set_shape_color(0, to_color(color, "color", k_channel));
    shape.color = scene.shape_color(0);
}
void set_transform(ShapeBox& shape, const py::handle& transform) {
    if (transform.is_none()) {
        shape.transform.reset();
    } else {
        shape.transform = to_affine(transform, "transform");
    }
}

template <class T>
std::shared_ptr<ShapeOf<T>> make_shape(const py::args& values, const py::kwargs& keywords) {
    static const auto names = names_of<T>();
    const auto class_name = std::string(to_string(ShapeKindOf<T>::value));
    auto shape = std::make_shared<ShapeOf<T>>();
    // Closed, as in the scene language.
    if constexpr (requires { shape->value.caps; }) shape->value.caps = true;
    if (values.size() > names.size())
        throw py::type_error(fmt::format("{}: {} values at most, then keywords", class_name, names.size()));
    for (std::size_t i = 0; i < values.size(); ++i) {
        const py::object value = values[i];
        visit_parameters(shape->value, Set{names[i].first, value});
    }
    for (const auto& [key, value] : keywords) {
        const std::string name = py::str(key);
        if (set_common(*shape, name, value)) continue;
        std::vector<std::string_view> known = {"material", "color", "transform", "name"};
        bool is_known = false;
        for (const auto& entry : names) {
            known.push_back(entry.first);
            is_known = is_known || entry.first == name;
        }
        if (!is_known)
            throw py::type_error(
                fmt::format("{} has no attribute '{}'{}", class_name, name, did_you_mean(name, known)));
        visit_parameters(shape->value, Set{name, value});
    }
    return shape;
}

template <class T> void bind_shape(py::module_& m, const char* name, const char* doc) {
    py::class_<ShapeOf<T>, ShapeBox, std::shared_ptr<ShapeOf<T>>> cls(m, name, doc);
    if constexpr (std::same_as<T, Polygon>) {
        cls.def(py::init([](const py::object& vertices, const py::kwargs& keywords) {
                    auto shape = std::make_shared<ShapeOf<Polygon>>();
                    shape->vertices = to_points(vertices, "vertices");
                    for (const auto& [key, value] : keywords)
                        if (!set_common(*shape, py::str(key), value))
                            throw py::type_error("polygon has no attribute " + repr_of(key));
                    return shape;
                }),
                py::arg("vertices"))
            .def_property(
                "vertices",
                [](const ShapeOf<Polygon>& s) {
                    return points_to_python(s.vertices.data(), s.vertices.size());
                },
                [](ShapeOf<Polygon>& s, const py::object& to) { s.vertices = to_points(to, "vertices"); },
                "3 to 4096 points in one plane, as an N x 3 array; counter-clockwise around the normal");
    } else {
        cls.def(py::init(&make_shape<T>));
        for (const auto& [parameter, help] : names_of<T>()) {
            cls.def_property(
                parameter.c_str(),
                [name = parameter](const ShapeOf<T>& shape) {
                    Get get{name};
                    visit_parameters(shape.value, get);
                    return get.found;
                },
                [name = parameter](ShapeOf<T>& shape, const py::object& to) {
                    visit_parameters(shape.value, Set{name, to});
                },
                help);
        }
    }
}

std::string describe(const ShapeBox& shape, const std::string& class_name) {
    std::string text = class_name + "(" + shape.text();
    if (shape.material) text += ", material=" + repr_of(py::cast(shape.material));
    if (shape.color) text += ", color=" + repr_of(to_python(*shape.color));
    if (shape.transform) text += ", transform=" + repr_of(to_python(*shape.transform).attr("tolist")());
    if (!shape.name.empty()) text += ", name=" + repr_of(py::str(shape.name));
    return text + ")";
}

}  // namespace

bool same_look(const ShapeBox& a, const ShapeBox& b) {
    if (a.color != b.color || a.transform != b.transform) return false;
    if (!a.material || !b.material) return a.material == b.material;
    return same(*a.material, *b.material);
}

bool set_common(ShapeBox& shape, const std::string& name, const py::handle& value) {
    if (name == "material") {
        set_material(shape, value);
    } else if (name == "color") {
        set_shape_color(shape, value);
    } else if (name == "transform") {
        set_transform(shape, value);
    } else if (name == "name") {
        shape.name = value.cast<std::string>();
    } else {
        return false;
    }
    return true;
}

std::shared_ptr<ShapeBox> read_shape(const Scene& scene, const Shape& shape) {
    switch (shape.kind) {
#define GLINT_KIND(Type, word)                             \
    case ShapeKind::word: {                                \
        auto box = std::make_shared<BoxFor<Type>::type>(); \
        box->read(scene, shape);                           \
        return box;                                        \
    }
        GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
    }
    return nullptr;
}

void bind_shapes(py::module_& m) {
    py::class_<ShapeBox, std::shared_ptr<ShapeBox>> cls(m, "Shape", "What all shapes have.");
    cls.def_readwrite("material", &ShapeBox::material, "A Material; None: the default one")
        .def_property(
            "color",
            [](const ShapeBox& s) -> py::object {
                if (!s.color) return py::none();
                return to_python(*s.color);
            },
            [](ShapeBox& s, const py::object& to) { set_shape_color(s, to); },
            "The shape's own color, in single precision, in place of the material's: the material's ambient, "
            "diffuse and specular stay the same multiples of the color. None: the material's")
        .def_property(
            "transform",
            [](const ShapeBox& s) -> py::object {
                if (!s.transform) return py::none();
                return to_python(*s.transform);
            },
            [](ShapeBox& s, const py::object& to) { set_transform(s, to); },
            "World from object, a matrix of 3x4 (or 4x4) numbers; None: the identity")
        .def_readwrite("name", &ShapeBox::name, "For scene.shapes[name]; may be empty.")
        .def_property_readonly(
            "kind", [](const ShapeBox& s) { return std::string(to_string(s.kind())); },
            "'sphere', 'plane' ...")
        .def("__eq__",
             [](const ShapeBox& a, const py::object& other) {
                 if (!py::isinstance<ShapeBox>(other)) return false;
                 const auto& b = other.cast<const ShapeBox&>();
                 return a.same(b) && a.name == b.name && same_look(a, b);
             })
        .def("__repr__",
             [](const py::object& self) {
                 return describe(self.cast<const ShapeBox&>(),
                                 py::type::of(self).attr("__name__").cast<std::string>());
             })
        .def("__copy__", [](const ShapeBox& s) { return s.copy(); })
        .def(
            "__deepcopy__",
            [](const ShapeBox& s, const py::dict&) {
                auto copy = s.copy();
                std::unordered_map<const MaterialBox*, std::shared_ptr<MaterialBox>> copies{
                    {nullptr, nullptr}};
                const auto replace = [&](std::shared_ptr<MaterialBox>& material) {
                    const auto [found, is_new] = copies.try_emplace(material.get());
                    if (is_new) found->second = deep_copy(*material);
                    material = found->second;
                };
                replace(copy->material);
                auto of_parts = copy->part_materials();
                for (auto& material : of_parts) replace(material);
                copy->set_part_materials(of_parts);
                return copy;
            },
            py::arg("memo"));
    cls.attr("__hash__") = py::none();
    bind_shape<Sphere>(m, "Sphere", "Sphere(center, radius=1)");
    bind_shape<Plane>(m, "Plane", "Plane(point, normal=(0, 1, 0)): infinite");
    bind_shape<Cylinder>(m, "Cylinder", "Cylinder(from_, to, radius, caps=True)");
    bind_shape<Cone>(m, "Cone", "Cone(from_, to, from_radius, to_radius=0, caps=True)");
    bind_shape<Disc>(m, "Disc", "Disc(center, normal, radius, hole=0)");
    bind_shape<Box>(m, "Box", "Box(min, max), along the axes");
    bind_shape<Triangle>(m, "Triangle", "Triangle(vertices): flat, its normal on the counter-clockwise side");
    bind_shape<SmoothTriangle>(m, "SmoothTriangle",
                               "SmoothTriangle(vertices, normals): shaded by its normals");
    bind_shape<Polygon>(m, "Polygon", "Polygon(vertices): flat, convex or not");
    bind_shape<Torus>(m, "Torus",
                      "Torus(center, axis, radius, tube): the points at distance `tube` from a circle of "
                      "that radius around the axis");
    bind_shape<Quadric>(
        m, "Quadric",
        "Quadric(squares, products, linear, constant): the points at which squares . (x^2, "
        "y^2, z^2) + products . (xy, xz, yz) + linear . (x, y, z) + constant is 0. Its inside "
        "is where that is below 0");
    bind_shape<Quartic>(m, "Quartic",
                        "Quartic(x4, x3y, ..., constant): the points at which the sum of the terms times "
                        "these factors is 0; x3y is that of x^3 y. Its inside is where that is below 0");
    bind_mesh(m);
    bind_solid(m, cls);
}

}  // namespace glint::python
