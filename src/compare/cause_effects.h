// SPDX-License-Identifier: Apache-2.0
#pragma once
// What each cause of a scene does to its picture, from which follows which causes are worth a rendering with
// another one.
#include <utility>
#include <vector>

#include "compare/scene_search.h"

namespace glint {

/// A fault of the scene and its picture.
struct CauseEffect {
    CauseCandidate candidate;
    RenderedScene rendered;
    bool is_multiple = false;  ///< of a part of the light
};

/// All causes that have a picture, factors and multiples with several numbers. Throws bad_alloc.
std::vector<CauseEffect> effects_of(const SceneRenderer& renderer, const SceneSearch& causes,
                                    const PixelGrid& grid);

/// The candidates that are most likely to explain `target` together with `cause`, whose picture is `first`,
/// at most `most`: the changes of light by two faults nearly add up.
std::vector<CauseCandidate> candidates_after(const std::vector<CauseEffect>& effects,
                                             const SceneSearch& causes, const RenderedScene& first,
                                             const CauseCandidate& cause, const BytePicture& target,
                                             std::size_t most);

/// The pairs of candidates whose changes of light together are nearest to that of `target`, by least squares,
/// at most `most`, one of each two rows. Finds pairs of which neither cause explains anything alone.
std::vector<std::pair<CauseCandidate, CauseCandidate>> likely_pairs(const std::vector<CauseEffect>& effects,
                                                                    const SceneSearch& causes,
                                                                    const BytePicture& target,
                                                                    std::size_t most);

}  // namespace glint
