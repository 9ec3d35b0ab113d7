// SPDX-License-Identifier: Apache-2.0
#include "compare/cause_ranking.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "base/sort_stably.h"
#include "compare/left_structure.h"
#include "compare/step_agreement.h"

namespace glint {
namespace {

// Among causes within this fraction of the difference the simplest, which is the first in the table, is named
// first. Among exact ones, they leave the same but for the rounding of a few bytes: this mean, in 255ths.
constexpr double k_tie = 0.003, k_exact_tie = 0.01;
// An exact cause is no better than another if it gives fewer wrong pixels by no more than these and this
// fraction of them.
constexpr double k_same_wrong = 2, k_same_wrong_part = 0.1;
// The fraction of the whole difference that each further fitted number must explain.
constexpr double k_parameter = 0.012;
// A flexible candidate is dropped if another one explains this much.
constexpr double k_explained_well = 0.9, k_explained_partly = 0.7;
// A candidate whose steps are not the picture's has to explain this much: in a dark picture noise makes
// steps.
constexpr double k_explained_strange = 0.85;
// In 255ths: less needs no explanation.
constexpr double k_min_calm = 0.01;
// An exact cause explains this much of the whole, or this much of what is away from edges if that is as much
// as this, and leaves at most these parts of the structured pixels and of the picture.
constexpr double k_exact = 0.97, k_enough_calm = 0.05;
constexpr double k_structure_left = 0.03;
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
        c.cause.perhaps = !c.is_exact || c.freedom > 0;
    }
    std::erase_if(list, [&](const CauseCandidate& c) {
        // A picture of one color has no content, so a cause has to give exactly that picture.
        if (!search.has_content) return c.left.all > 0;
        // Flexible candidates change only edges.
        if (c.is_strange && !c.is_exact &&
            c.cause.explained < (c.is_confirmed ? k_explained_strange : k_explained_partly))
            return true;
        return c.cause.explained < c.least || (calm && c.freedom > 0);
    });
    // If several give a picture of one color, it does not tell which.
    if (search.is_one_color && list.size() > 1) {
        for (CauseCandidate& c : list) c.cause.perhaps = true;
    }
    for (int freedom = 0; freedom < 2; ++freedom) {
        if (explains(list, freedom, k_explained_well))
            std::erase_if(list, [&](const CauseCandidate& c) { return c.freedom > freedom; });
    }
    return list;
}

// Which exact causes, of those that are in the list, give the picture best; all if that is not known.
std::function<bool(const CauseCandidate&)> best_of_exact(const std::vector<CauseCandidate>& list) {
    double least = HUGE_VAL;
    for (const CauseCandidate& c : list) {
        if (!c.is_exact) continue;
        if (!c.wrong) return [](const CauseCandidate& candidate) { return candidate.is_exact; };
        least = std::min(least, static_cast<double>(*c.wrong));
    }
    return [most = least + k_same_wrong + k_same_wrong_part * least](const CauseCandidate& candidate) {
        return candidate.is_exact && static_cast<double>(*candidate.wrong) <= most;
    };
}

}  // namespace

Search search_on(const PixelGrid& grid, const BytePicture& target, const std::vector<std::uint8_t>& edges,
                 const BytePicture& from, const Search& search) {
    Search small;
    small.faulty = on_grid(target, grid);
    small.area = {&edges, all_rows(grid.rows()), search.area.rim, 1};
    small.sample = small.area;
    small.report.difference = 1;
    small.has_content = search.has_content;
    small.whole = distance(small.faulty, from, small.area);
    return small;
}

CauseCandidate fitted_candidate(std::shared_ptr<const FittedCause> fitted, std::vector<double> values,
                                bool about, double least) {
    CauseCandidate candidate{{fitted->name, {}, 0, 0, true}, least};
    candidate.fitted = std::move(fitted);
    candidate.set_values(std::move(values), about);
    return candidate;
}

double rated(const CauseCandidate& candidate, double remaining, double whole) {
    return remaining + k_parameter * whole * candidate.parameters;
}

std::vector<CauseCandidate> best_of(const Search& search, std::size_t most) {
    std::vector<CauseCandidate> list = search.found;
    sort_stably(list, [&](const CauseCandidate& a, const CauseCandidate& b) {
        return rated(a, a.left.all, search.whole.all) < rated(b, b.left.all, search.whole.all);
    });
    std::set<std::string> names;
    std::erase_if(list, [&](const CauseCandidate& c) { return !names.insert(c.cause.name).second; });
    list.resize(std::min(list.size(), most));
    return list;
}

void Search::confirm(const BytePicture& made, const PictureView& numbers, const ByteRule& rule,
                     CauseCandidate& candidate, bool is_near) const {
    candidate.left = distance(made, *target, area);
    candidate.is_estimated = false;
    candidate.is_confirmed = true;
    const bool explains_all = candidate.left.all <= (1 - k_exact) * whole.all;
    const bool explains_it =
        explains_all || (whole.calm > k_enough_calm && candidate.left.calm <= (1 - k_exact) * whole.calm);
    const auto check_view = [&] {
        const auto agreement = step_agreement(made, *target, sample.rows);
        candidate.is_strange = agreement && agreement->both_ways < k_same_view;
    };
    if (!explains_it) return check_view();
    const double least = std::min(k_structure_left * static_cast<double>(structure),
                                  2 + k_structure_of_picture * static_cast<double>(made.rgb.size() / 3));
    const NumbersOfBytes of_bytes{numbers, rule, is_near ? k_near_numbers : k_other_program};
    candidate.is_exact = !candidate.is_vague &&
                         static_cast<double>(structured_pixels(made, *target, area)) <= least &&
                         !has_blobs(made, *target, area) &&
                         (original == nullptr ||
                          agrees_where_changed(made, of_bytes, *target, *original, area, !explains_all));
    if (!candidate.is_exact) return check_view();
    if (original != nullptr) candidate.wrong = wrong_pixels(made, of_bytes, *target, area);
}

void Search::add(const BytePicture& made, CauseCandidate candidate) {
    ++report.tried;
    if (!same_view) {
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

const CauseCandidate* Search::found_as(const Cause& cause) const {
    const auto it = std::find_if(found.begin(), found.end(), [&](const CauseCandidate& c) {
        return c.cause.name == cause.name && c.cause.explanation == cause.explanation;
    });
    return it != found.end() ? &*it : nullptr;
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
    const auto rate = [&](const CauseCandidate& c) { return rated(c, c.cause.remaining, whole); };
    while (!found.empty()) {
        const bool is_exact =
            std::any_of(found.begin(), found.end(), [](const CauseCandidate& c) { return c.is_exact; });
        const auto is_best_exact = best_of_exact(found);
        const auto may_be_first = [&](const CauseCandidate& c) { return !is_exact || is_best_exact(c); };
        double least = HUGE_VAL;
        for (const CauseCandidate& c : found) {
            if (may_be_first(c)) least = std::min(least, rate(c));
        }
        const double tie = is_exact ? std::min(k_tie * whole, k_exact_tie) : k_tie * whole;
        const double limit = least + (least > 0 ? tie : 0);
        const auto best = std::find_if(found.begin(), found.end(), [&](const CauseCandidate& c) {
            return may_be_first(c) && rate(c) <= limit;
        });
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
        report.remark = search.turn->explanation + " Something else differs, too: correct this first.";
    else if (!search.same_view && search.has_content)
        report.remark = "Another scene or another view: nothing classic explains it.";
    for (const CauseCandidate& c : search.found) {
        const double explained = 1 - c.left.all / search.whole.all;
        if (c.freedom > 0 || c.parameters > 1 ||
            explained <= (report.nearest ? report.nearest->explained : 0))
            continue;
        report.nearest = c.cause;
        report.nearest->explained = explained;
        report.nearest->remaining = c.left.all;
    }
}

}  // namespace glint
