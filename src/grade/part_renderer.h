// SPDX-License-Identifier: Apache-2.0
#pragma once
// The pictures that a rubric's rows require, as they should be and with the faults of a student's program.
#include <optional>
#include <string>
#include <vector>

#include "compare/named_faults.h"
#include "glint/render.h"
#include "grade/grading.h"

namespace glint {

/// The faults of a student's program that are known so far.
struct FaultChain {
    std::vector<NamedFault> faults;
    /// By light: whether the scene had it in which the first fault was found. The faults count lights in that
    /// scene.
    std::vector<bool> lights;

    bool empty() const { return faults.empty(); }
    /// Equal for equal faults.
    std::string key() const;
    /// True if the faults need a student's picture to be applied: a shift in the best direction.
    bool needs_picture() const;
};

class PartRenderer {
  public:
    /// The scene in its size. It must outlive the PartRenderer.
    PartRenderer(const Scene& scene, int threads);

    /// The picture that the row requires, and where it shows the part.
    WantedPicture render(const RubricRow& row) const;
    /// The same with the faults, fitted to `picture`. Nothing if it cannot be rendered.
    std::optional<WantedPicture> render(const RubricRow& row, const FaultChain& chain,
                                        const Image& picture) const;

    /// Whether the faults leave the number of lights as it is, so that other faults can count lights in a
    /// scene without them.
    bool keeps_lights(const FaultChain& chain) const;
    /// By light: whether the row's scene has it.
    std::vector<bool> lights_of(const RubricRow& row) const { return kept_lights(scene_, row.settings); }

  private:
    struct FaultyPicture {
        Image image;
        BytePicture bytes;
        FaultyScene scene;
    };
    std::optional<FaultyPicture> render_faulty(const RubricSettings& settings, const FaultChain& chain,
                                               const Image& picture) const;
    Result<Rendering> render_plain(const Scene& changed) const;

    const Scene& scene_;
    const CauseOptions options_;
    const SceneRenderer renderer_;
};

/// Whether a picture with faults still shows the part, so that a student with these faults can be judged by
/// it. `wanted`: the same without faults.
bool still_shows(const WantedPicture& faulty, const WantedPicture& wanted);

}  // namespace glint
