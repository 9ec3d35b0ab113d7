#pragma once
// What has been found about a picture, and which of it is named.
#include <optional>

#include "glint/compare.h"
#include "inspect/byte_picture.h"

namespace glint {

struct Candidate {
    Cause cause;
    double least = k_least_explained;
    int freedom = 0;     ///< PictureCause::freedom
    Distance left = {};  ///< from the picture to explain
    /// If only a sample of rows has been looked at, by which `left` is estimated: the place in
    /// picture_causes().
    std::optional<std::size_t> unconfirmed = {};
};

/// One picture to explain, and what has been found about it.
struct Search {
    BytePicture faulty;
    const BytePicture* target = nullptr;  ///< what the causes are to make out of the reference
    Area area, sample;                    ///< all of the picture, and where causes are tried first
    CauseReport report;
    Distance whole;  ///< what there is to explain
    std::vector<Candidate> found;

    bool is_open() const { return report.error.empty() && whole.all > 0; }
    /// `made` is what the candidate makes of the reference.
    void judge(const BytePicture& made, Candidate candidate) {
        ++report.tried;
        candidate.left = distance(made, *target, area);
        found.push_back(std::move(candidate));
    }
};

/// What explains enough, the best first, one of each name. `away_from_edges` becomes
/// CauseReport::away_from_edges.
std::vector<Candidate> ranked(const Search& search, bool& away_from_edges);

}  // namespace glint
