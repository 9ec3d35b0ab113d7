// SPDX-License-Identifier: Apache-2.0
#pragma once
// The search for two causes at once.
#include <optional>
#include <vector>

#include "compare/scene_search.h"

namespace glint {

/// Two causes that explain a picture together. What `second` leaves is what both leave.
struct CausePair {
    CauseCandidate first, second;
};

/// Searches pairs on a coarse grid of pixels; the best are then judged by all pixels. Numbers of both causes
/// are fitted together.
class PairSearch {
  public:
    /// All must outlive it. Throws bad_alloc.
    PairSearch(const SceneRenderer& renderer, const BytePicture& reference,
               const std::vector<std::uint8_t>& edges);

    /// The best pair; nothing if none explains much more than each cause that was found.
    std::optional<CausePair> find(const Search& search);

  private:
    // `before` is put into the scene before `after`, which may be a fault of pictures.
    struct Pair {
        CauseCandidate before, after;
        double left = 0, rating = 0;
        bool is_fitted = false;  // its numbers, together
    };
    struct Trial;

    // A fault of the scene and its picture on the coarse grid.
    struct Effect {
        CauseCandidate candidate;
        RenderedScene rendered;
        bool is_multiple = false;  // of a part of the light
    };

    Search coarse_search(const BytePicture& target, const Search& whole) const;
    void try_undone(Trial& trial) const;
    void try_two_of_pictures(std::size_t after, const Search& undone, Trial& trial) const;
    void make_effects();
    void try_pictures(Trial& trial);
    std::vector<CauseCandidate> candidates_after(const RenderedScene& first, const CauseCandidate& cause,
                                                 const BytePicture& target) const;
    void try_scene(const CauseCandidate& first, bool with_parts, Trial& trial) const;
    void try_geometry(const CauseCandidate& other, Trial& trial) const;
    static void add(Trial& trial, CauseCandidate before, CauseCandidate after);
    void add_shifted(const std::vector<CauseCandidate>& firsts, std::vector<Pair>& pairs) const;
    void fit_best(Trial& trial) const;
    void fit(Pair& pair, const Search& coarse) const;
    std::optional<RenderedScene> render(Pair& pair, const PixelGrid& grid, const Search& search) const;
    CausePair named(Pair pair, const Search& search) const;

    const SceneRenderer& renderer_;
    const BytePicture& reference_;
    const PixelGrid coarse_, all_;
    const BytePicture coarse_reference_;
    const std::vector<std::uint8_t> coarse_edges_;
    const SceneSearch causes_;     // on the coarse grid
    std::vector<Effect> effects_;  // of causes_, once they are needed
};

}  // namespace glint
