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
    static constexpr std::string_view others[] = {"name", "texture"};
    Material material;
    // The color first: the coefficients are factors of it.
    if (keywords.contains("color"))
        material = with_color(material, to_color(keywords["color"], "color", k_channel));
    set_fields(material, keywords, "Material", others);
    return material;
}

}  // namespace

bool same(const Material& a, const Material& b) { return same_fields(a, b); }
bool same(const MaterialBox& a, const MaterialBox& b) {
    if (a.name != b.name || !same(a.value, b.value)) return false;
    if (!a.texture || !b.texture) return a.texture == b.texture;
    return same(*a.texture, *b.texture);
}

std::shared_ptr<MaterialBox> deep_copy(const MaterialBox& material) {
    auto copy = std::make_shared<MaterialBox>(material);
    if (copy->texture) copy->texture = deep_copy(*copy->texture);
    return copy;
}

void bind_materials(py::module_& m) {
    py::class_<MaterialBox, std::shared_ptr<MaterialBox>> cls(
        m, "Material",
        "A surface. A number for ambient, diffuse, specular or emission is a factor of `color`: "
        "Material(color=(1, 0, "
        "0), specular=0.5). Three numbers are the coefficient itself. Setting `color` keeps the factors.");
    cls.def(py::init([](const py::kwargs& keywords) {
        auto box = std::make_shared<MaterialBox>(MaterialBox{make_material(keywords), name_in(keywords)});
        if (keywords.contains("texture")) box->texture = to_texture(keywords["texture"], "texture");
        return box;
    }));
    bind_fields<Material>(cls, &MaterialBox::value);
    cls.def_property(
        "texture", [](const MaterialBox& box) { return box.texture; },
        [](MaterialBox& box, const py::object& texture) { box.texture = to_texture(texture, "texture"); },
        "The Texture that changes the color from point to point, or None. It is added to the scenes that "
        "have the material.");
    cls.def_readwrite("name", &MaterialBox::name, "For scene.materials[name]; may be empty.")
        .def("__eq__",
             [](const MaterialBox& a, const py::object& other) {
                 return py::isinstance<MaterialBox>(other) && same(a, other.cast<const MaterialBox&>());
             })
        .def("__repr__",
             [](const MaterialBox& box) {
                 // The factors of the color are what Material(color=...) has.
                 const Color color = box.value.color;
                 const bool is_usual = color == Material{}.color;
                 const Material usual = is_usual ? Material{} : with_color(Material{}, color);
                 std::string text = box.name.empty() ? "" : "name=" + repr_of(py::str(box.name));
                 if (!is_usual)
                     text += fmt::format("{}color={}", text.empty() ? "" : ", ", repr_of(to_python(color)));
                 const std::string others = changed_fields(box.value, usual);
                 if (!text.empty() && !others.empty()) text += ", ";
                 text += others;
                 if (box.texture)
                     text += (text.empty() ? "" : ", ") + ("texture=" + repr_of(py::cast(box.texture)));
                 return fmt::format("Material({})", text);
             })
        .def("__copy__", [](const MaterialBox& box) { return std::make_shared<MaterialBox>(box); })
        .def(
            "__deepcopy__", [](const MaterialBox& box, const py::dict&) { return deep_copy(box); },
            py::arg("memo"));
    cls.attr("__hash__") = py::none();
}

}  // namespace glint::python
