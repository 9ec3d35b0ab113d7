// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the caller asks for, in JSON, and what the library makes of it.
// The browser has no file system for the JSON library to know.
#define JSON_HAS_FILESYSTEM 0
#define JSON_HAS_EXPERIMENTAL_FILESYSTEM 0
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "glint/glint.h"

namespace glint::wasm {

/// A text that the scene was read from, kept for convert().
struct OwnedText {
    std::string name, text, format;
};

/// The texts of a request, then its includes.
struct RequestTexts {
    std::vector<OwnedText> texts, includes;
    /// All of them, for write_glint(); they refer to this.
    std::vector<SceneText> all() const;
};
RequestTexts read_texts(const nlohmann::json& request);

/// Reads the scene that a request of glint_open names.
Result<Scene> load(const RequestTexts& texts, const nlohmann::json& request);

/// Applies a request of glint_prepare to a scene. Returns an empty string, or what is wrong with it.
std::string apply(const nlohmann::json& request, Scene& scene);

}  // namespace glint::wasm
