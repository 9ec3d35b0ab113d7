// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene that need not be validated again.
#include <optional>
#include <utility>
#include <vector>

#include "scene/mistakes.h"

namespace glint {

/// A scene without errors. Nobody can change it, so prepare() (world/prepare.h) relies on it.
class ValidatedScene {
  public:
    /// Validates, and takes the scene if it has no errors. mistakes: what validate() reports.
    static std::optional<ValidatedScene> take(Scene& scene, std::vector<Mistake>& mistakes);

    const Scene& operator*() const { return scene_; }
    const Scene* operator->() const { return &scene_; }
    /// What validate() reports.
    const std::vector<Diagnostic>& warnings() const { return warnings_; }
    /// For a caller that changes it.
    Scene release() && { return std::move(scene_); }

  private:
    ValidatedScene(Scene scene, std::vector<Diagnostic> warnings)
        : scene_(std::move(scene)), warnings_(std::move(warnings)) {}
    Scene scene_;
    std::vector<Diagnostic> warnings_;
};

}  // namespace glint
