// SPDX-License-Identifier: Apache-2.0
#pragma once
// What glint says about a picture beside another, and about a scene, as JSON, for the API.
#include "wasm/request.h"

namespace glint::wasm {

/// The JSON of glint_compare. `faults`: the reference's scene, if causes are wanted.
nlohmann::ordered_json comparison(const std::optional<World>& world, const std::optional<World>& reference,
                                  const Scene* faults);

/// The JSON of glint_check.
nlohmann::ordered_json findings(const Scene& scene, const std::vector<SceneText>& texts);

}  // namespace glint::wasm
