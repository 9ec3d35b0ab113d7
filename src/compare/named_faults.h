// SPDX-License-Identifier: Apache-2.0
#pragma once
// Causes that can be applied to other scenes and pictures: for the module that grades.
#include <optional>
#include <span>
#include <vector>

#include "compare/scene_renderer.h"
#include "glint/compare.h"

namespace glint {

/// A cause, and what it changes. One of the last three is set.
struct NamedFault {
    Cause cause;
    FaultEdit edit = {};    ///< of the scene
    MakePicture make = {};  ///< of a scene, if no change of the scene has the same effect
    std::optional<std::size_t> of_pictures = {};  ///< of pictures: the index in picture_causes()
};

struct FaultReport {
    CauseReport report;
    std::vector<NamedFault> faults;  ///< the first of `causes`, and `then`; none if there is no cause
};

/// As find_causes(), with the changes.
std::vector<Result<FaultReport>> find_faults(std::span<const Image> pictures, const Image& b,
                                             const Scene* scene, const CauseOptions& options);

}  // namespace glint
