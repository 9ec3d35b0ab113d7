// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene as JSON, for the API.
#include "wasm/request.h"

namespace glint::wasm {

nlohmann::ordered_json to_json(const Diagnostic& diagnostic);

/// glint_info's JSON.
nlohmann::ordered_json describe(const Scene& scene, const World& world);

}  // namespace glint::wasm
