// SPDX-License-Identifier: Apache-2.0
// The extension module glint._glint. What users call is in glint/*.py.
#include "errors.h"
#include "glint/version.h"
#include "items.h"
#include "rendering.h"
#include "scene_state.h"
#include "shapes.h"

PYBIND11_MODULE(_glint, m) {
    using namespace glint::python;
    m.doc() = "glint's C++ library; use the package glint";
    m.attr("version") = GLINT_VERSION;
    // False for an object whose constructor has not ended: pybind11 would give its functions uninitialised
    // memory.
    m.def("has_values", [](const py::handle& object) {
        if (PyObject_IsInstance(object.ptr(), py::detail::get_internals().instance_base) != 1) return true;
        return reinterpret_cast<py::detail::instance*>(object.ptr())
            ->get_value_and_holder()
            .holder_constructed();
    });
    bind_errors(m);
    bind_lights(m);
    bind_textures(m);
    bind_materials(m);
    bind_cameras(m);
    bind_fog(m);
    bind_sky(m);
    bind_shapes(m);
    bind_rendering(m);
    bind_scene(m);
    bind_comparison(m);
}
