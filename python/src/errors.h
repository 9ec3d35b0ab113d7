// SPDX-License-Identifier: Apache-2.0
#pragma once
// Failures of the library as Python exceptions, and its warnings as Python's.
#include <vector>

#include "glint/result.h"
#include "values.h"

namespace glint::python {

/// Throws GlintError with the code, the message and the diagnostics; MemoryError where there is no memory.
[[noreturn]] void raise(const Status& status);

/// The value, or the exception.
template <class T> T value_or_raise(Result<T>&& result) {
    if (!result) raise(result);
    return *std::move(result);
}

/// Issues the warnings among the diagnostics as GlintWarning. Throws if the user turns warnings into errors.
void warn(const std::vector<Diagnostic>& diagnostics);

void bind_errors(py::module_& m);

}  // namespace glint::python
