// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures.
#include <memory>

#include "glint/glint.h"
#include "values.h"

namespace glint::python {

void bind_rendering(py::module_& m);
void bind_comparison(py::module_& m);

}  // namespace glint::python
