#pragma once
// The mistakes of a scene, before they become diagnostics: load() has the texts to show, validate() has not.
#include <string>
#include <vector>

#include "glint/scene.h"

namespace glint {

struct Mistake {
    Severity severity = Severity::error;
    SourcePlace place;  ///< line 0: of the scene as a whole
    std::string message;
};

/// What validate() reports: at most 20 errors, then the warnings.
std::vector<Mistake> find_mistakes(const Scene& scene);

}  // namespace glint
