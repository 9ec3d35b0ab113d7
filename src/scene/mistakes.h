// SPDX-License-Identifier: Apache-2.0
#pragma once
// The mistakes of a scene, before they become diagnostics: load() has the texts to show, validate() has not.
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "glint/scene.h"

namespace glint {

struct Mistake {
    Severity severity = Severity::error;
    SourcePlace place;  ///< line 0: of the scene as a whole
    std::string message;
    SceneItem item = SceneItem::none;
    std::uint32_t index = 0;
};

/// What validate() reports: at most 20 errors, then the warnings.
std::vector<Mistake> find_mistakes(const Scene& scene);

/// A part of a scene that can be looked at by itself.
enum class ScenePart : std::uint8_t { settings, camera, background, lights, materials };
/// The errors of one part: at most 20.
std::vector<Mistake> find_mistakes(const Scene& scene, ScenePart part);
/// The errors of a material that messages give this index.
std::vector<Mistake> find_mistakes(const Material& material, std::uint32_t index);
/// The errors of some shapes, of their parameters and transforms, and of their materials, of which there are
/// `materials`: at most 20, in the order of the list.
std::vector<Mistake> find_mistakes(const Scene& scene, std::span<const std::uint32_t> shapes,
                                   std::size_t materials, int threads);

/// As validate() gives them.
std::vector<Diagnostic> to_diagnostics(std::vector<Mistake> mistakes, const Scene& scene);

}  // namespace glint
