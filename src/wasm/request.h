// SPDX-License-Identifier: Apache-2.0
#pragma once
// Parses the caller's requests, which are JSON, and applies them.
// The browser build has no <filesystem> for the JSON library.
#define JSON_HAS_FILESYSTEM 0
#define JSON_HAS_EXPERIMENTAL_FILESYSTEM 0
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "glint/glint.h"
#include "scene/validated_scene.h"

namespace glint::wasm {

/// A text that the scene was read from, kept for glint_convert().
struct OwnedText {
    std::string name, text, format;
};

/// The texts of a request, then its includes.
struct RequestTexts {
    std::vector<OwnedText> texts, includes;
    /// The texts, and of the includes those that the scene was read from; they refer to this object.
    std::vector<SceneText> read_by(const Scene& scene) const;
};
RequestTexts read_texts(const nlohmann::json& request);

/// By mesh of the scene: the name of its file, relative to the folder of the first text; empty: none.
std::vector<std::string> mesh_files(const Scene& scene);

/// Reads the scene that a request of glint_open names. `missing`: the included texts that it does not have.
/// progress: as in LoadOptions.
Result<ValidatedScene> load(const RequestTexts& texts, const nlohmann::json& request,
                            std::vector<std::string>& missing, Function<void(double)> progress = {});

/// What a request of glint_prepare can change.
struct Changeable {
    Camera camera;
    Conventions conventions;
    RenderSettings settings;
    std::vector<SettingOrigin> origins;

    Changeable() = default;
    explicit Changeable(const Scene& scene)
        : camera(scene.camera),
          conventions(scene.conventions),
          settings(scene.settings),
          origins(scene.origins) {}
    void restore(Scene& scene) const {
        scene.camera = camera;
        scene.conventions = conventions;
        scene.settings = settings;
        scene.origins = origins;
    }
};

/// Applies a request to glint_prepare. Returns an error message, or an empty string.
std::string apply(const nlohmann::json& request, Scene& scene);

}  // namespace glint::wasm
