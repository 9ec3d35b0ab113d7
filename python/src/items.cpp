// SPDX-License-Identifier: Apache-2.0
#include "items.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "base/text.h"
#include "scene/camera_fields.h"
#include "scene/light_fields.h"
#include "scene/material_fields.h"

namespace glint::python {
namespace {

template <class Item> std::span<const ItemField<Item>> fields_of();
template <> std::span<const ItemField<Light>> fields_of() { return k_light_fields; }
template <> std::span<const ItemField<Material>> fields_of() { return k_material_fields; }
template <> std::span<const ItemField<Camera>> fields_of() { return k_camera_fields; }
template <> std::span<const ItemField<CameraFrame>> fields_of() { return k_frame_fields; }

// The value of a field from Python.
Vec3 from_python(const PointType&, const py::handle& value, std::string_view name) {
    return to_point(value, name);
}
Vec3 from_python(const DirectionType&, const py::handle& value, std::string_view name) {
    return to_direction(value, name);
}
double from_python(const NumberType& type, const py::handle& value, std::string_view name) {
    return to_number(value, name, type.range);
}
Color from_python(const ColorType& type, const py::handle& value, std::string_view name) {
    return to_color(value, name, type.range);
}
Attenuation from_python(const AttenuationType&, const py::handle& value, std::string_view name) {
    return to_attenuation(value, name);
}

template <class Item> py::object get_field(const ItemField<Item>& field, const Item& item) {
    return std::visit(
        [&](const auto& member) -> py::object {
            const auto& value = item.*member.at;
            if constexpr (requires { value.has_value(); }) {
                if (!value) return py::none();
                return to_python(*value);
            } else {
                return to_python(value);
            }
        },
        field.member);
}

template <class Item> void set_field(const ItemField<Item>& field, Item& item, const py::handle& value) {
    std::visit(
        [&](const auto& member) {
            auto& to = item.*member.at;
            if constexpr (requires { to.has_value(); }) {
                if (value.is_none()) {
                    to.reset();
                    return;
                }
            }
            to = from_python(member.type, value, field.name);
        },
        field.member);
}

// A number for ambient, diffuse or specular is a factor of the color, as in the scene language.
void set_field(const ItemField<Material>& field, Material& material, const py::handle& value) {
    const MaterialCoefficient* coefficient = coefficient_of(field);
    if (coefficient != nullptr && is_number(value)) {
        material.*coefficient->field = to_number(value, field.name, coefficient->range) * material.color;
        return;
    }
    if (is_field_of(field, &Material::color)) {
        set_color(material, to_color(value, field.name, k_channel));
        return;
    }
    set_field<Material>(field, material, value);
}

template <class Item> bool same_fields(const Item& a, const Item& b) {
    const auto fields = fields_of<Item>();
    return std::all_of(fields.begin(), fields.end(),
                       [&](const ItemField<Item>& field) { return same_bits(field, a, b); });
}

// "name=value" of each field that differs from the default.
template <class Item>
std::string changed_fields(const Item& item, const Item& usual, const std::string& name = {}) {
    std::string text = name.empty() ? "" : "name=" + repr_of(py::str(name));
    for (const ItemField<Item>& field : fields_of<Item>()) {
        if (same_bits(field, item, usual) || !applies(field, item)) continue;
        text += fmt::format("{}{}={}", text.empty() ? "" : ", ", field.name,
                            py::str(get_field(field, item)).template cast<std::string>());
    }
    return text;
}

// "Position of the light. ..." for Python's help().
template <class Item> std::string docstring(const ItemField<Item>& field) {
    const auto type = std::visit(
        [](const auto& member) {
            const auto& t = member.type;
            if constexpr (requires { t.range; }) {
                return fmt::format("{}: {}", t.word, t.range.text);
            } else {
                return std::string(t.word);
            }
        },
        field.member);
    return fmt::format("{} ({})", field.description, type);
}

// Property or method, the owner's value first.
template <class Item, class Class, class Owner> void bind_fields(Class& cls, Item Owner::*value) {
    for (const ItemField<Item>& field : fields_of<Item>()) {
        cls.def_property(
            std::string(field.name).c_str(),
            [&field, value](const Owner& owner) { return get_field(field, owner.*value); },
            [&field, value](Owner& owner, const py::object& to) { set_field(field, owner.*value, to); },
            docstring(field).c_str());
    }
}

// Sets the fields that the keywords name. `others`: keywords that the caller sets itself.
template <class Item>
void set_fields(Item& item, const py::kwargs& keywords, std::string_view class_name,
                std::span<const std::string_view> others = {}) {
    for (const auto& [key, value] : keywords) {
        const std::string name = py::str(key);
        if (std::find(others.begin(), others.end(), name) != others.end()) continue;
        const auto fields = fields_of<Item>();
        const auto field = std::find_if(fields.begin(), fields.end(),
                                        [&](const ItemField<Item>& f) { return f.name == name; });
        if (field == fields.end()) {
            std::vector<std::string_view> known(others.begin(), others.end());
            for (const ItemField<Item>& f : fields) known.push_back(f.name);
            throw py::type_error(
                fmt::format("{} has no attribute '{}'{}", class_name, name, did_you_mean(name, known)));
        }
        set_field(*field, item, value);
    }
}

LightKind light_kind(const std::string& word) {
    for (int kind = 0; kind < k_light_kinds; ++kind)
        if (to_string(static_cast<LightKind>(kind)) == word) return static_cast<LightKind>(kind);
    throw py::value_error(
        fmt::format("kind: expected 'ambient', 'point' or 'directional', found '{}'", word));
}

double largest(const Color& c) { return std::max({c.r, c.g, c.b}); }

// Scales both colors so that the largest channel of `color` is `to`.
void set_intensity(Light& light, double to) {
    const double now = largest(light.color);
    if (now > 0) {
        light.color = light.color * (to / now);
        light.specular_color = light.specular_color * (to / now);
    } else {
        light.color = light.specular_color = Color{to, to, to};
    }
}

Light make_light(const std::string& kind, const py::kwargs& keywords) {
    static constexpr std::string_view others[] = {"name", "intensity"};
    Light light;
    light.kind = light_kind(kind);
    set_fields(light, keywords, "Light", others);
    if (keywords.contains("color") && !keywords.contains("specular_color"))
        light.specular_color = light.color;
    if (keywords.contains("intensity")) {
        const double factor = to_number(keywords["intensity"], "intensity", k_channel);
        light.color = light.color * factor;
        light.specular_color = light.specular_color * factor;
    }
    return light;
}

Material make_material(const py::kwargs& keywords) {
    static constexpr std::string_view others[] = {"name"};
    Material material;
    // The color first: the coefficients are factors of it.
    if (keywords.contains("color")) set_color(material, to_color(keywords["color"], "color", k_channel));
    set_fields(material, keywords, "Material", others);
    return material;
}

std::string name_in(const py::kwargs& keywords) {
    return keywords.contains("name") ? keywords["name"].cast<std::string>() : std::string();
}

constexpr const char* k_projections[] = {"perspective", "orthographic"};
constexpr const char* k_axes[] = {"x", "y"};

template <class Enum>
Enum enum_of(const char* const (&words)[2], const std::string& word, std::string_view name) {
    for (int i = 0; i < 2; ++i)
        if (words[i] == word) return static_cast<Enum>(i);
    throw py::value_error(
        fmt::format("{}: expected '{}' or '{}', found '{}'", name, words[0], words[1], word));
}

void set_frame(CameraBox& camera, const py::object& frame) {
    camera.frame = frame.is_none() ? nullptr : frame.cast<std::shared_ptr<FrameBox>>();
}

// copy.copy and copy.deepcopy.
template <class Class, class T> void bind_copies(Class& cls, T (*copy)(const T&)) {
    cls.def("__copy__", [copy](const T& self) { return std::make_shared<T>(copy(self)); });
    cls.def(
        "__deepcopy__", [copy](const T& self, const py::dict&) { return std::make_shared<T>(copy(self)); },
        py::arg("memo"));
}

void bind_light(py::module_& m) {
    py::class_<LightBox, std::shared_ptr<LightBox>> cls(
        m, "Light", "A light: ambient, point or directional. Colors are linear RGB, intensity included.");
    cls.def(py::init([](const std::string& kind, const py::kwargs& keywords) {
                return std::make_shared<LightBox>(LightBox{make_light(kind, keywords), name_in(keywords)});
            }),
            py::arg("kind") = "point");
    bind_fields<Light>(cls, &LightBox::value);
    cls.def_property(
           "kind", [](const LightBox& l) { return std::string(to_string(l.value.kind)); },
           [](LightBox& l, const std::string& kind) { l.value.kind = light_kind(kind); },
           "'ambient', 'point' or 'directional'")
        .def_property(
            "intensity", [](const LightBox& l) { return largest(l.value.color); },
            [](LightBox& l, const py::object& to) {
                set_intensity(l.value, to_number(to, "intensity", k_tint));
            },
            "The largest channel of `color`. Setting it scales `color` and `specular_color`.")
        .def_readwrite("name", &LightBox::name, "For scene.lights[name]; may be empty.")
        .def("__eq__",
             [](const LightBox& a, const py::object& other) {
                 if (!py::isinstance<LightBox>(other)) return false;
                 const auto& b = other.cast<const LightBox&>();
                 return a.name == b.name && same(a.value, b.value);
             })
        .def("__repr__", [](const LightBox& l) {
            Light usual;
            usual.kind = l.value.kind;
            usual.specular_color = l.value.color;
            const std::string fields = changed_fields(l.value, usual, l.name);
            return fmt::format("Light('{}'{}{})", to_string(l.value.kind), fields.empty() ? "" : ", ",
                               fields);
        });
    bind_copies<decltype(cls), LightBox>(cls, [](const LightBox& l) { return l; });
    cls.attr("__hash__") = py::none();
}

void bind_material(py::module_& m) {
    py::class_<MaterialBox, std::shared_ptr<MaterialBox>> cls(
        m, "Material",
        "A surface. A number for ambient, diffuse or specular is a factor of `color`: Material(color=(1, 0, "
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

void bind_frame(py::module_& m) {
    py::class_<FrameBox, std::shared_ptr<FrameBox>> cls(
        m, "CameraFrame",
        "A camera's axes: `right` spans the picture's width and `up` its height at `forward` from the "
        "position.");
    cls.def(py::init([](const py::kwargs& keywords) {
        FrameBox frame;
        set_fields(frame.value, keywords, "CameraFrame");
        return std::make_shared<FrameBox>(frame);
    }));
    bind_fields<CameraFrame>(cls, &FrameBox::value);
    cls.def("__eq__",
            [](const FrameBox& a, const py::object& other) {
                return py::isinstance<FrameBox>(other) && a.value == other.cast<const FrameBox&>().value;
            })
        .def("__repr__", [](const FrameBox& frame) {
            CameraFrame other{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}};
            return fmt::format("CameraFrame({})", changed_fields(frame.value, other));
        });
    bind_copies<decltype(cls), FrameBox>(cls, [](const FrameBox& frame) { return frame; });
    cls.attr("__hash__") = py::none();
}

void bind_camera(py::module_& m) {
    py::class_<CameraBox, std::shared_ptr<CameraBox>> cls(
        m, "Camera", "The camera. Without a frame it is right-handed, and pixels are square.");
    cls.def(py::init([](const py::kwargs& keywords) {
        static constexpr std::string_view others[] = {"projection", "fov_axis", "frame"};
        CameraBox camera;
        set_fields(camera.value, keywords, "Camera", others);
        if (keywords.contains("projection"))
            camera.value.projection =
                enum_of<Projection>(k_projections, keywords["projection"].cast<std::string>(), "projection");
        if (keywords.contains("fov_axis"))
            camera.value.fov_axis =
                enum_of<FovAxis>(k_axes, keywords["fov_axis"].cast<std::string>(), "fov_axis");
        if (keywords.contains("frame")) set_frame(camera, keywords["frame"]);
        return std::make_shared<CameraBox>(camera);
    }));
    bind_fields<Camera>(cls, &CameraBox::value);
    cls.def_property(
           "projection",
           [](const CameraBox& c) { return k_projections[static_cast<int>(c.value.projection)]; },
           [](CameraBox& c, const std::string& word) {
               c.value.projection = enum_of<Projection>(k_projections, word, "projection");
           },
           "'perspective' or 'orthographic'")
        .def_property(
            "fov_axis", [](const CameraBox& c) { return k_axes[static_cast<int>(c.value.fov_axis)]; },
            [](CameraBox& c, const std::string& word) {
                c.value.fov_axis = enum_of<FovAxis>(k_axes, word, "fov_axis");
            },
            "The side of the picture that `fov` spans: 'x', its width, or 'y', its height")
        .def_property(
            "frame", [](const CameraBox& c) { return c.frame; },
            [](CameraBox& c, const py::object& frame) { set_frame(c, frame); },
            "A CameraFrame, which replaces look_at, up, fov and width; or None")
        .def("__eq__",
             [](const CameraBox& a, const py::object& other) {
                 return py::isinstance<CameraBox>(other) &&
                        same(a.whole(), other.cast<const CameraBox&>().whole());
             })
        .def("__repr__", [](const CameraBox& c) {
            std::string text = changed_fields(c.whole(), Camera{});
            const auto add = [&](const std::string& more) { text += (text.empty() ? "" : ", ") + more; };
            if (c.value.projection != Projection::perspective) add("projection='orthographic'");
            if (c.value.fov_axis != FovAxis::x) add("fov_axis='y'");
            if (c.frame) add("frame=" + repr_of(py::cast(c.frame)));
            return "Camera(" + text + ")";
        });
    bind_copies<decltype(cls), CameraBox>(cls, [](const CameraBox& c) {
        CameraBox copy = c;
        if (c.frame) copy.frame = std::make_shared<FrameBox>(*c.frame);
        return copy;
    });
    cls.attr("__hash__") = py::none();
}

}  // namespace

bool same(const Light& a, const Light& b) { return a.kind == b.kind && same_fields(a, b); }
bool same(const Material& a, const Material& b) { return same_fields(a, b); }
bool same(const Camera& a, const Camera& b) {
    return a.projection == b.projection && a.fov_axis == b.fov_axis && a.frame == b.frame &&
           same_fields(a, b);
}

void set_color(Material& material, const Color& color) {
    const Color old = material.color;
    for (const MaterialCoefficient& coefficient : k_material_coefficients) {
        Color& value = material.*coefficient.field;
        const double sum = old.r + old.g + old.b;
        if (!(sum > 0)) {
            if (value == Color{}) value = coefficient.usual * color;
            continue;
        }
        double factor = (value.r + value.g + value.b) / sum;
        if (std::abs(factor - coefficient.usual) <= 1e-12) factor = coefficient.usual;
        const Color multiple = factor * old;
        const double off = std::max(
            {std::abs(multiple.r - value.r), std::abs(multiple.g - value.g), std::abs(multiple.b - value.b)});
        if (off <= 1e-9 * std::max(1.0, largest(value))) value = factor * color;
    }
    material.color = color;
}

void bind_items(py::module_& m) {
    bind_light(m);
    bind_material(m);
    bind_frame(m);
    bind_camera(m);
}

}  // namespace glint::python
