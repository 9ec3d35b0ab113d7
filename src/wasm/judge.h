// SPDX-License-Identifier: Apache-2.0
#pragma once
// What glint says about a picture beside another, and about a scene, as JSON, for the API.
#include "wasm/request.h"

namespace glint::wasm {

/// The JSON of glint_compare. `faults`: the reference's scene, if causes are wanted.
nlohmann::ordered_json comparison(const World& world, const World& reference, const Scene* faults);

/// A picture of RGBA bytes, row by row from the top.
struct GivenPicture {
    const char* rgba;
    std::int32_t width, height;
};

/// The JSON of glint_compare_picture. The picture must have the size of the world's.
nlohmann::ordered_json comparison(const GivenPicture& picture, const World& world, const Scene* faults);

/// The JSON of glint_check.
nlohmann::ordered_json findings(const Scene& scene, const std::vector<SceneText>& texts);

/// The JSON of glint_diagnose, as text: the diagnosis may be long.
std::string diagnosis(const Scene& scene, const World& world, std::string_view log, std::string name);

}  // namespace glint::wasm
