// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a World's functions say where there is nothing of the scene to point at.
#include <string>
#include <utility>

#include "glint/diagnostic.h"

namespace glint {

/// An error without a place.
inline Diagnostic failure_diagnostic(std::string message) {
    Diagnostic d;
    d.message = std::move(message);
    return d;
}

}  // namespace glint
