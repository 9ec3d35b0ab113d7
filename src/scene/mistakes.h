// SPDX-License-Identifier: Apache-2.0
#pragma once
// The mistakes of a scene, before they become diagnostics: load() can show their text, validate() cannot.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "glint/scene.h"

namespace glint {

struct Mistake {
    Severity severity = Severity::error;
    SourcePlace place;  ///< line 0: about the scene as a whole
    std::string message;
    SceneItem item = SceneItem::none;
    std::uint32_t index = 0;
};

/// The mistakes that validate() reports: at most 20 errors, then the warnings.
std::vector<Mistake> find_mistakes(const Scene& scene);

/// A part of a scene that can be validated separately.
enum class ScenePart : std::uint8_t { settings, camera, background, lights, materials };
/// The errors of one part: at most 20.
std::vector<Mistake> find_mistakes(const Scene& scene, ScenePart part);
/// The errors of a material. index: its index in messages.
std::vector<Mistake> find_mistakes(const Material& material, std::uint32_t index);
/// The errors of shapes' own colors: at most 20.
std::vector<Mistake> find_mistakes(std::span<const ShapeColor> colors);
/// The errors of some shapes: of their parameters, transforms, material indices and colors. materials: the
/// number of materials. At most 20 errors, in the order of the list.
std::vector<Mistake> find_mistakes(const Scene& scene, std::span<const std::uint32_t> shapes,
                                   std::size_t materials, int threads);

/// The diagnostics that validate() returns.
std::vector<Diagnostic> to_diagnostics(std::vector<Mistake> mistakes, const Scene& scene);

}  // namespace glint
