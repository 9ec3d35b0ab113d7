// SPDX-License-Identifier: Apache-2.0
#pragma once
// The search for two causes at once.
#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compare/cause_effects.h"
#include "compare/cause_pair.h"

namespace glint {

/// How many of the best causes, or pairs, something is tried with that takes long, or longer.
inline constexpr std::size_t k_few_causes = 3, k_fewer_causes = 2;

/// Two causes that explain a picture together. What `second` leaves, and whether it is exact, is of both.
struct CausePair {
    CauseCandidate first, second;
};

/// Searches pairs on a coarse grid of pixels, those first whose changes of light add up to the picture's; the
/// best are then judged by all pixels. Numbers of both causes are fitted together.
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
    // Some pixels of the picture.
    struct Level {
        PixelGrid grid;
        std::vector<std::uint8_t> edges;
    };

    // The search for the pair of one picture.
    struct Trial {
        const Search& whole;
        Search coarse;
        std::vector<CauseEffect> found = {};           // of its single causes
        std::vector<const CauseEffect*> effects = {};  // these, and those of all
        std::vector<const CauseEffect*> firsts = {};   // the best alone, one of each row of a table
        std::vector<LikelyPair> likely = {};           // of `effects`
        std::set<std::pair<std::string, std::string>> known = {};  // rows that have been rendered together
        std::vector<PairCandidate> pairs = {};
        std::optional<CauseCandidate> turn = {};  // the flip, or swapped channels, that explains most

        double least() const {
            double left = coarse.whole.all;
            for (const PairCandidate& pair : pairs) left = std::min(left, pair.left);
            return left;
        }
    };

    std::optional<Search> search_at(const Level& level, const Search& whole,
                                    const CauseCandidate& without) const;
    void find_firsts(Trial& trial) const;
    void try_pictures(Trial& trial) const;
    void try_likely(std::size_t firsts, std::size_t seconds, Trial& trial) const;
    void try_multiple(const CauseEffect& other, const CauseEffect& multiple, Trial& trial) const;
    void try_geometry(const CauseCandidate& other, Trial& trial) const;
    static void add(Trial& trial, CauseCandidate before, CauseCandidate after);
    void fit_best(Trial& trial) const;
    void fit(const Level& level, const Search& whole, PairCandidate& pair) const;
    ByteRule rule() const { return renderer_.rule(renderer_.scene().shading); }
    bool confirm(const Search& search, PairCandidate& pair) const;
    std::optional<CausePair> best_by_all_pixels(const Search& search,
                                                std::vector<PairCandidate>& pairs) const;
    CausePair named(PairCandidate pair, const Search& search) const;

    const SceneRenderer& renderer_;
    const BytePicture& reference_;
    Level coarse_, fine_;
    const PixelGrid all_;
    const SceneSearch causes_;          // on the coarse grid
    std::vector<CauseEffect> effects_;  // of causes_, once they are needed
};

}  // namespace glint
