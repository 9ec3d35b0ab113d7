// SPDX-License-Identifier: Apache-2.0
#pragma once
// What has been found about a picture, and which of it is named.
#include <optional>

#include "compare/byte_picture.h"
#include "glint/compare.h"

namespace glint {

struct CauseCandidate {
    Cause cause;
    double least = k_min_explained;
    int freedom = 0;     ///< PictureCause::freedom
    Distance left = {};  ///< from the picture to explain
    /// If only a sample of rows has been looked at, by which `left` is estimated: the place in
    /// picture_causes().
    std::optional<std::size_t> unconfirmed = {};
    bool is_turn = false;     ///< PictureCause::is_turn
    bool is_strange = false;  ///< what it makes does not show what the picture shows: it has to explain more
};

/// One picture to explain, and what has been found about it.
struct Search {
    BytePicture faulty;
    const BytePicture* target = nullptr;  ///< what the causes are to make out of the reference
    Area area, sample;                    ///< all of the picture, and where causes are tried first
    CauseReport report;
    Status status;   ///< why there is no report
    Distance whole;  ///< what there is to explain
    std::vector<CauseCandidate> found;

    bool same_view = true;    ///< picture and reference show the same things
    bool has_content = true;  ///< neither of them is one colour throughout
    /// The flip or turn after which they show the same things, if only then, and how well their steps agree.
    std::optional<Cause> turn;
    double agreement_turned = 0;

    bool is_open() const { return status.ok() && whole.all > 0; }
    /// `made` is what the candidate makes of the reference.
    void judge(const BytePicture& made, CauseCandidate candidate) {
        candidate.left = distance(made, *target, area);
        add(made, std::move(candidate));
    }
    /// The same, of a candidate whose `left` is known.
    void add(const BytePicture& made, CauseCandidate candidate);
};

/// What a cause has to explain that does not show what the picture shows.
inline constexpr double k_explained_partly = 0.7;

/// What explains enough, the best first, one of each name. `away_from_edges` becomes
/// CauseReport::away_from_edges.
std::vector<CauseCandidate> ranked(const Search& search, bool& away_from_edges);

/// Fills in the report by what was found.
void name_causes(Search& search);

}  // namespace glint
