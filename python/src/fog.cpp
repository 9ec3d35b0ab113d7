// SPDX-License-Identifier: Apache-2.0
// The fog as a Python object.
#include "item_fields.h"
#include "scene/fog_fields.h"

namespace glint::python {

template <> std::span<const ItemField<Fog>> fields_of() { return k_fog_fields; }

namespace {

FogKind fog_kind(const std::string& word) {
    for (const FogKind kind : {FogKind::linear, FogKind::exp, FogKind::exp2})
        if (to_string(kind) == word) return kind;
    throw py::value_error(fmt::format("kind: expected 'linear', 'exp' or 'exp2', found '{}'", word));
}

}  // namespace

bool same(const Fog& a, const Fog& b) { return a.kind == b.kind && same_fields(a, b); }

void bind_fog(py::module_& m) {
    py::class_<FogBox, std::shared_ptr<FogBox>> cls(
        m, "Fog",
        "Fog: of the light from distance d the part f is seen, and 1 - f of `color` is added. kind 'linear': "
        "f "
        "= (end - d) / (end - start); 'exp': exp(-density (d - start)); 'exp2': exp(-(density (d - "
        "start))**2).");
    cls.def(py::init([](const std::string& kind, const py::kwargs& keywords) {
                FogBox fog;
                fog.value.kind = fog_kind(kind);
                set_fields(fog.value, keywords, "Fog");
                return std::make_shared<FogBox>(fog);
            }),
            py::arg("kind") = "exp");
    bind_fields<Fog>(cls, &FogBox::value);
    cls.def_property(
           "kind", [](const FogBox& f) { return std::string(to_string(f.value.kind)); },
           [](FogBox& f, const std::string& kind) { f.value.kind = fog_kind(kind); },
           "'linear', 'exp' or 'exp2'")
        .def("__eq__",
             [](const FogBox& a, const py::object& other) {
                 return py::isinstance<FogBox>(other) && same(a.value, other.cast<const FogBox&>().value);
             })
        .def("__repr__", [](const FogBox& f) {
            Fog usual;
            usual.kind = f.value.kind;
            const std::string fields = changed_fields(f.value, usual);
            return fmt::format("Fog('{}'{}{})", to_string(f.value.kind), fields.empty() ? "" : ", ", fields);
        });
    bind_copies<decltype(cls), FogBox>(cls, [](const FogBox& f) { return f; });
    cls.attr("__hash__") = py::none();
}

}  // namespace glint::python
