// SPDX-License-Identifier: Apache-2.0
#include "compare/cause_ranking.h"

#include <algorithm>

#include "compare/step_agreement.h"

namespace glint {
namespace {

// Of causes that explain nearly the same (by this part of the difference) the simplest, which is the earliest
// in the table, is named first.
constexpr double k_tie = 0.003;
// What can be bent is dropped if something else explains this much.
constexpr double k_explained_well = 0.9;
// In 255ths: less is nothing to explain.
constexpr double k_min_calm = 0.01;

// Does a candidate of no more freedom explain this much?
bool explains(const std::vector<CauseCandidate>& list, int freedom, double share) {
    return std::any_of(list.begin(), list.end(), [&](const CauseCandidate& c) {
        return c.freedom <= freedom && c.cause.explained >= share;
    });
}

// Fills in what each explains, of the whole or of what is away from edges, and drops what explains too
// little.
std::vector<CauseCandidate> explaining(const Search& search, bool calm) {
    std::vector<CauseCandidate> list = search.found;
    const double whole = calm ? search.whole.calm : search.whole.all;
    for (CauseCandidate& c : list) {
        c.cause.remaining = calm ? c.left.calm : c.left.all;
        c.cause.explained = 1 - c.cause.remaining / whole;
    }
    std::erase_if(list, [&](const CauseCandidate& c) {
        // A picture of one colour has no content that could speak for a cause which does not make just that.
        if (!search.has_content) return c.left.all > 0;
        const double least = c.is_strange ? std::max(c.least, k_explained_partly) : c.least;
        // Of what can be bent, edges are what it bends.
        return c.cause.explained < least || (calm && c.freedom > 0);
    });
    for (int freedom = 0; freedom < 2; ++freedom) {
        if (explains(list, freedom, k_explained_well))
            std::erase_if(list, [&](const CauseCandidate& c) { return c.freedom > freedom; });
    }
    return list;
}

}  // namespace

void Search::add(const BytePicture& made, CauseCandidate candidate) {
    ++report.tried;
    const double explained = 1 - candidate.left.all / whole.all;
    if (!same_view && explained < k_explained_partly) {
        const auto agreement = step_agreement(made, *target, sample.rows);
        candidate.is_strange = !agreement || agreement->both_ways < k_same_view;
        if (candidate.is_turn && agreement && agreement->one_way >= k_same_view &&
            agreement->one_way > agreement_turned) {
            turn = candidate.cause;
            agreement_turned = agreement->one_way;
        }
    }
    found.push_back(std::move(candidate));
}

std::vector<CauseCandidate> ranked(const Search& search, bool& away_from_edges) {
    std::vector<CauseCandidate> found = explaining(search, false), list;
    double whole = search.whole.all;
    away_from_edges = false;
    if (!explains(found, 2, k_explained_partly) && search.whole.calm > k_min_calm) {
        std::vector<CauseCandidate> calm = explaining(search, true);
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
        std::erase_if(found, [&](const CauseCandidate& c) { return c.cause.name == list.back().cause.name; });
    }
    return list;
}

void name_causes(Search& search) {
    CauseReport& report = search.report;
    for (CauseCandidate& c : ranked(search, report.away_from_edges))
        report.causes.push_back(std::move(c.cause));
    if (!report.causes.empty()) return;
    if (search.turn && search.has_content)
        report.remark = search.turn->explanation + " Something else differs besides: mend this first.";
    else if (!search.same_view && search.has_content)
        report.remark = "Another scene or another view: nothing classic explains it.";
    for (const CauseCandidate& c : search.found) {
        const double explained = 1 - c.left.all / search.whole.all;
        if (c.freedom > 0 || explained <= (report.nearest ? report.nearest->explained : 0)) continue;
        report.nearest = c.cause;
        report.nearest->explained = explained;
        report.nearest->remaining = c.left.all;
    }
}

}  // namespace glint
