// SPDX-License-Identifier: Apache-2.0
#include "compare/pair_search.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "base/sort_stably.h"
#include "compare/left_structure.h"

namespace glint {
namespace {

// Causes with which the most likely other ones are rendered, as many as pairs whose numbers are fitted
// together, and those with which all are if nothing else explains the picture.
constexpr std::size_t k_firsts = 16, k_firsts_with_all = 4;
// Other causes that are rendered with each of these.
constexpr std::size_t k_seconds = 10;
// A pair that leaves more than this fraction is not judged by all pixels; of a picture that shows another
// scene, it is not searched further, either. The grid's difference counts if that of all pixels is at most so
// many times as large.
constexpr double k_hopeless = 0.5, k_fair = 2.5;
// A pair that is not exact leaves at most this fraction of what the best single cause leaves, and explains
// this much.
constexpr double k_gain = 0.4, k_explains = 0.9;
// Numbers of pairs are fitted once more if they leave at most this fraction of the difference.
constexpr double k_nearly = 0.3;
// Of exact pairs, what each fitted number must explain: there is no structure that it could fit by chance.
constexpr double k_exact_parameter = 0.0005;

}  // namespace

PairSearch::PairSearch(const SceneRenderer& renderer, const BytePicture& reference,
                       const std::vector<std::uint8_t>& edges)
    : renderer_(renderer),
      reference_(reference),
      coarse_{coarse_grid_of(renderer.scene().shading, reference.width, reference.height), {}},
      fine_{grid_of(renderer.scene().shading, reference.width, reference.height), {}},
      all_{reference.width, reference.height, 1},
      causes_(renderer, coarse_.grid, renderer.scene()) {
    for (Level* level : {&coarse_, &fine_}) level->edges = on_grid(edges, level->grid);
}

// The search for what is to be explained, or for that without a fault that can be undone; nothing if it
// cannot have that fault.
std::optional<Search> PairSearch::search_at(const Level& level, const Search& whole,
                                            const CauseCandidate& without) const {
    const BytePicture& from = whole.target == &reference_ ? whole.faulty : reference_;
    std::optional<BytePicture> undone;
    if (can_be_undone(without)) {
        undone = flipped(*whole.target, without, whole.area);
        if (!undone) return std::nullopt;
    }
    return search_on(level.grid, undone ? *undone : *whole.target, level.edges, on_grid(from, level.grid),
                     whole);
}

// In the order in which they are named: first the one that explains more alone.
CausePair PairSearch::named(PairCandidate pair, const Search& search) const {
    const Distance both = pair.after.left;
    const bool is_exact = pair.after.is_exact;
    for (CauseCandidate* c : {&pair.before, &pair.after}) {
        c->is_exact = false;
        c->left = search.whole;
        if (c->of_pictures) {
            for (const CauseCandidate& found : search.found) {
                if (found.of_pictures != c->of_pictures) continue;
                c->left = found.left;
                c->is_exact = found.is_exact;
            }
        } else if (const auto made = render_candidate(renderer_, *c, renderer_.scene(), all_)) {
            search.confirm(made->bytes, made->image, rule(), *c, c->parameters > 0);
        }
    }
    CausePair named{std::move(pair.before), std::move(pair.after)};
    if (named.second.left.all < named.first.left.all) std::swap(named.first, named.second);
    named.second.left = both;
    named.second.is_exact = is_exact;
    return named;
}

std::optional<CausePair> PairSearch::with_first(const Search& search, const CauseCandidate& first,
                                                const CausePair& pair) const {
    PairCandidate changed = in_order(first, pair.second);
    // Two that are not changes of the scene have no order that is known.
    if (first.cause.name == pair.second.cause.name || (!changed.before.edit && !changed.after.of_pictures) ||
        changed.before.of_pictures || !confirm(search, changed))
        return std::nullopt;
    const bool is_after = changed.after.cause.name == first.cause.name;
    CausePair made{first, is_after ? changed.before : changed.after};
    made.second.left = changed.after.left;
    made.second.is_exact = changed.after.is_exact;
    return made;
}

// The best pairs, one of each two rows of the tables, with their numbers fitted.
void PairSearch::fit_best(Trial& trial) const {
    auto& pairs = trial.pairs;
    // Of those that leave the same, the first in the table are simpler.
    const auto by_rating = [](const PairCandidate& a, const PairCandidate& b) {
        const auto rows = [](const PairCandidate& p) { return std::minmax(p.before.row, p.after.row); };
        return a.rating < b.rating || (a.rating == b.rating && rows(a) < rows(b));
    };
    sort_stably(pairs, by_rating);
    std::set<std::set<std::string>> known;
    std::erase_if(pairs, [&](const PairCandidate& p) {
        return !known.insert({row_key(p.before), row_key(p.after)}).second;
    });
    pairs.resize(std::min(pairs.size(), k_firsts));
    for (PairCandidate& pair : pairs) {
        if (!std::exchange(pair.is_fitted, true) && !renderer_.is_cancelled())
            fit(coarse_, trial.whole, pair);
    }
    sort_stably(pairs, by_rating);
}

std::optional<CausePair> PairSearch::find(const Search& search) {
    if (!causes_.rendered()) return std::nullopt;
    if (effects_.empty()) effects_ = effects_of(renderer_, causes_, coarse_.grid);
    Trial trial{search, *search_at(coarse_, search, {})};
    trial.coarse.target = &trial.coarse.faulty;
    find_firsts(trial);
    try_pictures(trial);
    try_likely(k_firsts, k_seconds, trial);
    fit_best(trial);
    const double whole = trial.coarse.whole.all;
    const auto goes_on = [&] {  // not if it is found, nor if this is another scene
        return trial.least() > std::min(k_pair_found * whole, k_rounding_mean) &&
               (search.same_view || trial.least() < k_hopeless * whole);
    };
    if (goes_on()) try_likely(k_firsts_with_all, SIZE_MAX, trial);  // changes that do not add up
    fit_best(trial);
    std::vector<CauseCandidate> others;
    if (trial.turn) others.push_back(*trial.turn);
    for (std::size_t i = 0; i < std::min(trial.firsts.size(), k_fewer_causes); ++i)
        others.push_back(trial.firsts[i]->candidate);
    for (std::size_t i = 0; i < others.size() && goes_on(); ++i) try_geometry(others[i], trial);
    fit_best(trial);
    std::vector<PairCandidate>& pairs = trial.pairs;
    const double calm = trial.coarse.whole.calm;
    if (k_fair * whole >= search.whole.all)
        std::erase_if(pairs, [&](const PairCandidate& p) {
            return p.left > k_hopeless * whole && p.after.left.calm >= k_hopeless * calm;
        });
    // The best by rating, and then by what they leave.
    const auto by_left = [](const PairCandidate& a, const PairCandidate& b) { return a.left < b.left; };
    if (pairs.size() > k_few_causes) sort_stably(std::span(pairs).subspan(k_few_causes), by_left);
    pairs.resize(std::min(pairs.size(), 2 * k_few_causes));
    return best_by_all_pixels(search, pairs);
}

// Edges that one cause leaves: a shift by a pixel or half of one, together with the best causes.
std::optional<CausePair> PairSearch::find_shifted(const Search& search) {
    std::vector<PairCandidate> pairs;
    for (const CauseCandidate& first : best_of(search, k_few_causes)) {
        std::optional<Search> coarse = search_at(coarse_, search, first);
        if (coarse) coarse->target = &coarse->faulty;
        for (std::size_t i = 0; i < causes_.size() && coarse && !renderer_.is_cancelled(); ++i) {
            if (!causes_.cause(i).is_shift || first.cause.name == causes_.cause(i).name) continue;
            // What moves the camera comes before the shift of its picture.
            PairCandidate pair = in_order(first, causes_.candidate(i));
            const auto made = render_pair(renderer_, coarse_.grid, *coarse, pair);
            if (!made) continue;
            pair.left = pair.rating = distance(made->bytes, coarse->faulty, coarse->area).all;
            pairs.push_back(std::move(pair));
        }
    }
    sort_stably(pairs, [](const PairCandidate& a, const PairCandidate& b) { return a.left < b.left; });
    pairs.resize(std::min<std::size_t>(pairs.size(), 1));
    for (PairCandidate& pair : pairs) fit(coarse_, search, pair);
    return best_by_all_pixels(search, pairs);
}

// Sets what both leave of all pixels.
bool PairSearch::confirm(const Search& search, PairCandidate& pair) const {
    std::optional<RenderedScene> made = render_pair(renderer_, all_, search, pair);
    if (made) {
        if (can_be_undone(pair.after)) made->bytes = *flipped(made->bytes, pair.after, search.area);
        const bool is_of_bytes = pair.after.of_pictures.has_value();
        search.confirm(made->bytes, is_of_bytes ? view_of(made->bytes) : PictureView(made->image),
                       is_of_bytes ? ByteRule{} : rule(), pair.after,
                       pair.before.parameters + pair.after.parameters > 0);
    }
    // In the range of a picture, 0.8 / (1 + d) is near 1 / (3 + d).
    const auto is_curve = [](const CauseCandidate& c) { return c.cause.name == "attenuation-added"; };
    // A term that is missing may be one that is hardly visible (SceneTrials::judge_limit): not judged of
    // pairs.
    const auto may_be_tiny = [&](const CauseCandidate& c) {
        return causes_.cause_with_limit(c.cause.name).has_value();
    };
    if (pair.before.is_vague || may_be_tiny(pair.before) || may_be_tiny(pair.after) ||
        (is_curve(pair.before) && pair.after.fitted) || (is_curve(pair.after) && pair.before.fitted))
        pair.after.is_exact = false;
    return made.has_value();
}

void PairSearch::fit(const Level& level, const Search& whole, PairCandidate& pair) const {
    std::optional<Search> search = search_at(level, whole, pair.after);
    if (!search) return;
    search->target = &search->faulty;
    fit_pair(renderer_, causes_, level.grid, *search, pair);
}

std::optional<CausePair> PairSearch::best_by_all_pixels(const Search& search,
                                                        std::vector<PairCandidate>& pairs) const {
    const double whole = search.whole.all;
    double least = whole;
    for (const CauseCandidate& c : search.found) least = std::min(least, c.left.all);
    const PairCandidate* best = nullptr;
    std::size_t refined = 0;
    for (PairCandidate& pair : pairs) {
        if (!confirm(search, pair)) continue;
        if (!pair.after.is_exact && pair.after.left.all <= k_nearly * whole && refined < k_fewer_causes) {
            ++refined;
            fit(fine_, search, pair);
            if (!confirm(search, pair)) continue;
        }
        const double left = pair.after.left.all;
        const bool is_likely =
            (search.same_view || search.turn) && left <= k_gain * least && left <= (1 - k_explains) * whole;
        if (!pair.after.is_exact && !is_likely) continue;
        const int numbers = pair.before.parameters + pair.after.parameters;
        pair.rating = left + (pair.after.is_exact ? k_exact_parameter * numbers * whole
                                                  : rated(pair.after, rated(pair.before, 0, whole), whole));
        if (best == nullptr || (pair.after.is_exact && !best->after.is_exact) ||
            (pair.after.is_exact == best->after.is_exact && pair.rating < best->rating))
            best = &pair;
    }
    if (best == nullptr) return std::nullopt;
    return named(*best, search);
}

}  // namespace glint
