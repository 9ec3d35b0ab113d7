// SPDX-License-Identifier: Apache-2.0
// Lights as Python objects.
#include "item_fields.h"
#include "scene/light_fields.h"

namespace glint::python {

template <> std::span<const ItemField<Light>> fields_of() { return k_light_fields; }

namespace {

LightKind light_kind(const std::string& word) {
    std::vector<std::string_view> words;
    for (int kind = 0; kind < k_light_kinds; ++kind) {
        words.push_back(to_string(static_cast<LightKind>(kind)));
        if (words.back() == word) return static_cast<LightKind>(kind);
    }
    throw py::value_error(fmt::format("kind: expected '{}', found '{}'", fmt::join(words, "', '"), word));
}

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

}  // namespace

bool same(const Light& a, const Light& b) { return a.kind == b.kind && same_fields(a, b); }

void bind_lights(py::module_& m) {
    py::class_<LightBox, std::shared_ptr<LightBox>> cls(
        m, "Light",
        "A light: ambient, point, directional or spot; parallelogram, disc or sphere. Colors are linear RGB, "
        "intensity included.");
    cls.def(py::init([](const std::string& kind, const py::kwargs& keywords) {
                return std::make_shared<LightBox>(LightBox{make_light(kind, keywords), name_in(keywords)});
            }),
            py::arg("kind") = "point");
    bind_fields<Light>(cls, &LightBox::value);
    cls.def_property(
           "kind", [](const LightBox& l) { return std::string(to_string(l.value.kind)); },
           [](LightBox& l, const std::string& kind) { l.value.kind = light_kind(kind); },
           "'ambient', 'point', 'directional', 'spot', 'parallelogram', 'disc' or 'sphere'")
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

}  // namespace glint::python
