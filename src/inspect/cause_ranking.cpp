#include "inspect/cause_ranking.h"

#include <algorithm>

namespace glint {
namespace {

// Of causes that explain nearly the same (by this part of the difference) the simplest, which is the earliest
// in the table, is named first.
constexpr double k_tie = 0.003;
// Another look is taken if nothing explains the one share, and what can be bent is dropped if something else
// explains the other.
constexpr double k_explained_partly = 0.7, k_explained_well = 0.9;
// In 255ths: less is nothing to explain.
constexpr double k_least_calm = 0.01;

// Does a candidate of no more freedom explain this much?
bool explains(const std::vector<Candidate>& list, int freedom, double share) {
    return std::any_of(list.begin(), list.end(), [&](const Candidate& c) {
        return c.freedom <= freedom && c.cause.explained >= share;
    });
}

// Fills in what each explains, of the whole or of what is away from edges, and drops what explains too
// little.
std::vector<Candidate> explaining(const Search& search, bool calm) {
    std::vector<Candidate> list = search.found;
    const double whole = calm ? search.whole.calm : search.whole.all;
    for (Candidate& c : list) {
        c.cause.remaining = calm ? c.left.calm : c.left.all;
        c.cause.explained = 1 - c.cause.remaining / whole;
    }
    // Of what can be bent, edges are what it bends.
    std::erase_if(list,
                  [&](const Candidate& c) { return c.cause.explained < c.least || (calm && c.freedom > 0); });
    for (int freedom = 0; freedom < 2; ++freedom) {
        if (explains(list, freedom, k_explained_well))
            std::erase_if(list, [&](const Candidate& c) { return c.freedom > freedom; });
    }
    return list;
}

}  // namespace

std::vector<Candidate> ranked(const Search& search, bool& away_from_edges) {
    std::vector<Candidate> found = explaining(search, false), list;
    double whole = search.whole.all;
    away_from_edges = false;
    if (!explains(found, 2, k_explained_partly) && search.whole.calm > k_least_calm) {
        std::vector<Candidate> calm = explaining(search, true);
        if (explains(calm, 0, k_explained_partly)) {
            found = std::move(calm);
            whole = search.whole.calm;
            away_from_edges = true;
        }
    }
    while (!found.empty()) {
        const auto least = std::min_element(found.begin(), found.end(), [](const auto& x, const auto& y) {
            return x.cause.remaining < y.cause.remaining;
        });
        const double limit = least->cause.remaining + (least->cause.remaining > 0 ? k_tie * whole : 0);
        const auto best = std::find_if(found.begin(), found.end(),
                                       [&](const auto& c) { return c.cause.remaining <= limit; });
        list.push_back(*best);
        std::erase_if(found, [&](const Candidate& c) { return c.cause.name == list.back().cause.name; });
    }
    return list;
}

}  // namespace glint
