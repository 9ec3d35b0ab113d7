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
