// SPDX-License-Identifier: Apache-2.0
// Materials as Python objects.
#include "scene/material_fields.h"

#include "item_fields.h"

namespace glint::python {

template <> std::span<const ItemField<Material>> fields_of() { return k_material_fields; }

void set_field(const ItemField<Material>& field, Material& material, const py::handle& value) {
    const MaterialCoefficient* coefficient = coefficient_of(field);
    if (coefficient != nullptr && is_number(value)) {
        material.*coefficient->field = to_number(value, field.name, coefficient->range) * material.color;
        return;
    }
    if (is_field_of(field, &Material::color)) {
        material = with_color(material, to_color(value, field.name, k_channel));
        return;
    }
    set_field<Material>(field, material, value);
}

namespace {

Material make_material(const py::kwargs& keywords) {
    static constexpr std::string_view others[] = {"name"};
    Material material;
    // The color first: the coefficients are factors of it.
    if (keywords.contains("color"))
        material = with_color(material, to_color(keywords["color"], "color", k_channel));
    set_fields(material, keywords, "Material", others);
    return material;
}

}  // namespace

bool same(const Material& a, const Material& b) { return same_fields(a, b); }

void bind_materials(py::module_& m) {
    py::class_<MaterialBox, std::shared_ptr<MaterialBox>> cls(
        m, "Material",
        "A surface. A number for ambient, diffuse, specular or emission is a factor of `color`: "
        "Material(color=(1, 0, "
        "0), specular=0.5). Three numbers are the coefficient itself. Setting `color` keeps the factors.");
    cls.def(py::init([](const py::kwargs& keywords) {
        return std::make_shared<MaterialBox>(MaterialBox{make_material(keywords), name_in(keywords)});
    }));
    bind_fields<Material>(cls, &MaterialBox::value);
    cls.def_readwrite("name", &MaterialBox::name, "For scene.materials[name]; may be empty.")
        .def("__eq__",
             [](const MaterialBox& a, const py::object& other) {
                 if (!py::isinstance<MaterialBox>(other)) return false;
                 const auto& b = other.cast<const MaterialBox&>();
                 return a.name == b.name && same(a.value, b.value);
             })
        .def("__repr__", [](const MaterialBox& box) {
            return fmt::format("Material({})", changed_fields(box.value, Material{}, box.name));
        });
    bind_copies<decltype(cls), MaterialBox>(cls, [](const MaterialBox& box) { return box; });
    cls.attr("__hash__") = py::none();
}

}  // namespace glint::python
