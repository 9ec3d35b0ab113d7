// SPDX-License-Identifier: Apache-2.0
#pragma once
// The search for two causes at once.
#include <algorithm>
#include <optional>
#include <vector>

#include "compare/cause_effects.h"
#include "compare/cause_pair.h"

namespace glint {

/// Two causes that explain a picture together. What `second` leaves, and whether it is exact, is of both.
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
    /// The same, of the best causes and a shift of the picture by a pixel or half of one.
    std::optional<CausePair> find_shifted(const Search& search);
    /// The pair with another first cause, judged by all pixels; nothing if the two do not go together.
    std::optional<CausePair> with_first(const Search& search, const CauseCandidate& first,
                                        const CausePair& pair) const;

  private:
    // A fault of pictures, the search for the picture without it, and how much that differs.
    struct Undone {
        std::size_t row = 0;
        Search search;
        double whole = 0;
    };

    // The search for the pair of one picture.
    struct Trial {
        const Search& whole;
        Search coarse;
        std::vector<PairCandidate> pairs;
        std::vector<Undone> undone;

        double least() const {
            double left = coarse.whole.all;
            for (const PairCandidate& pair : pairs) left = std::min(left, pair.left);
            return left;
        }
    };

    Search coarse_search(const BytePicture& target, const Search& whole) const;
    std::vector<Undone> undone_faults(const Trial& trial) const;
    void try_undone(Trial& trial) const;
    void try_two_of_pictures(std::size_t after, const Search& undone, Trial& trial) const;
    void try_pictures(Trial& trial);
    void try_scene(const CauseCandidate& first, std::size_t most, bool with_parts, Trial& trial) const;
    void try_geometry(const CauseCandidate& other, Trial& trial) const;
    void try_undone_geometry(Trial& trial) const;
    static void add(Trial& trial, CauseCandidate before, CauseCandidate after);
    void fit_best(Trial& trial) const;
    ByteRule rule() const { return renderer_.rule(renderer_.scene().shading); }
    bool confirm(const Search& search, PairCandidate& pair) const;
    void refine(const Search& search, PairCandidate& pair) const;
    std::optional<CausePair> best_by_all_pixels(const Search& search,
                                                std::vector<PairCandidate>& pairs) const;
    CausePair named(PairCandidate pair, const Search& search) const;

    const SceneRenderer& renderer_;
    const BytePicture& reference_;
    const PixelGrid coarse_, fine_, all_;
    const std::vector<std::uint8_t>& edges_;
    const BytePicture coarse_reference_;
    const std::vector<std::uint8_t> coarse_edges_;
    const SceneSearch causes_;          // on the coarse grid
    std::vector<CauseEffect> effects_;  // of causes_, once they are needed
};

}  // namespace glint
