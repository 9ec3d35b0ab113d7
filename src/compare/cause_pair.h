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

/// Which of two comes first: changes of the scene, then sums of pictures, then faults of pictures.
PairCandidate in_order(CauseCandidate a, CauseCandidate b);

/// What two candidates of one row of a table have in common, whatever their numbers are.
std::string row_key(const CauseCandidate& candidate);

/// The candidate of picture_causes()[i], whose `left` is still to be filled in.
CauseCandidate fault_of_pictures(std::size_t i);

/// Whether the fault is of pictures and its own inverse, a flip or swapped channels: then the other cause of
/// a pair is searched for in the picture without it.
bool can_be_undone(const CauseCandidate& fault);
/// A picture with such a fault, or without, if it has it; nothing if it cannot have it.
std::optional<BytePicture> flipped(const BytePicture& picture, const CauseCandidate& fault, const Area& area);

/// The picture with both, but without an `after` that can be undone; nothing if it cannot be rendered, or a
/// fault does not apply. Fills in the explanation of a fault of pictures.
std::optional<RenderedScene> render_pair(const SceneRenderer& renderer, const PixelGrid& grid,
                                         const Search& search, PairCandidate& pair);

/// Fits the numbers of both causes together, on the grid of `causes` and of `search`.
void fit_pair(const SceneRenderer& renderer, const SceneSearch& causes, const PixelGrid& grid,
              const Search& search, PairCandidate& pair);

}  // namespace glint
