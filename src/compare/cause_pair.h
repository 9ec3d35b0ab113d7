// SPDX-License-Identifier: Apache-2.0
#pragma once
// Two causes at once: their picture, and the fit of their numbers.
#include <optional>
#include <string>

#include "compare/scene_search.h"

namespace glint {

/// Numbers of the scene are fitted no more once a cause or a pair leaves less than this fraction of the
/// difference.
inline constexpr double k_pair_found = 0.02;
/// A multiple below this is a part that is missing.
inline constexpr double k_min_multiple = 0.03;

/// `before` is put into the scene before `after`, which may be a fault of pictures.
struct PairCandidate {
    CauseCandidate before, after;
    double left = 0, rating = 0;  ///< of both: what remains, and rated()
    bool is_fitted = false;       ///< its numbers, together
};

/// What two candidates of one row of a table have in common, whatever their numbers are.
std::string row_key(const CauseCandidate& candidate);

/// The candidate of picture_causes()[i], whose `left` is still to be filled in.
CauseCandidate fault_of_pictures(std::size_t i);

/// The picture with both; nothing if it cannot be rendered, or a fault does not apply. Fills in the
/// explanation of a fault of pictures.
std::optional<RenderedScene> render_pair(const SceneRenderer& renderer, const PixelGrid& grid,
                                         const Search& search, PairCandidate& pair);

/// Fits the numbers of both causes together, on the grid of `causes` and of `search`.
void fit_pair(const SceneRenderer& renderer, const SceneSearch& causes, const PixelGrid& grid,
              const Search& search, PairCandidate& pair);

}  // namespace glint
