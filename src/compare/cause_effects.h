// SPDX-License-Identifier: Apache-2.0
#pragma once
// What each cause of a scene does to its picture, from which follows which two are worth a rendering
// together.
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

/// Two effects, and the multiples of their changes of light: 1, or free if they are multiples.
struct LikelyPair {
    const CauseEffect *a = nullptr, *b = nullptr;
    double by_a = 1, by_b = 1;
    double left = 0;  ///< squares
};

/// The pairs whose changes of light together are near that of `target`, by least squares, the nearest first:
/// the changes by two faults nearly add up. Finds pairs of which neither cause explains anything alone.
std::vector<LikelyPair> likely_pairs(const std::vector<const CauseEffect*>& effects, const Image& plain,
                                     const BytePicture& target);

/// The candidate of an effect with `by` times its change.
CauseCandidate candidate_of(const CauseEffect& effect, double by, const SceneSearch& causes);

}  // namespace glint
