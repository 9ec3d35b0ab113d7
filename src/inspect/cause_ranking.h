#pragma once
// What has been found about a picture, and which of it is named.
#include "glint/compare.h"
#include "inspect/byte_picture.h"

namespace glint {

struct Candidate {
    Cause cause;
    double least = k_least_explained;
    int freedom = 0;     ///< PictureCause::freedom
    Distance left = {};  ///< from the picture to explain
};

/// One picture to explain, and what has been found about it.
struct Search {
    BytePicture faulty;
    CauseReport report;
    Distance whole;  ///< what there is to explain
    std::vector<Candidate> found;

    bool is_open() const { return report.error.empty() && whole.all > 0; }
};

/// Fills in the report's causes: the best first, one of each name.
void rank(Search& search);

}  // namespace glint
