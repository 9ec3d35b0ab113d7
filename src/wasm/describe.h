// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene's contents as JSON, for the API.
#include "wasm/request.h"

namespace glint::wasm {

nlohmann::ordered_json to_json(const Diagnostic& diagnostic);

/// The JSON of glint_info.
nlohmann::ordered_json describe(const Scene& scene, const World& world);

}  // namespace glint::wasm
