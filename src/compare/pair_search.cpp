// SPDX-License-Identifier: Apache-2.0
#include "compare/pair_search.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

#include "base/sort_stably.h"
#include "compare/geometry_search.h"
#include "compare/left_structure.h"
#include "compare/missing_shapes.h"
#include "compare/picture_causes.h"

namespace glint {
namespace {

// Causes of the scene with which all others are tried, those of them with which numbers of the scene are
// fitted.
constexpr std::size_t k_firsts = 16, k_firsts_with_parts = 6, k_geometry_firsts = 2;
// Those with which all others are rendered if nothing else explains the picture.
constexpr std::size_t k_firsts_with_all = 4;
// A pair that leaves more than this fraction is not
// judged by all pixels; of a picture that shows another scene, it is not searched further, either. The grid's
// difference counts if that of all pixels is at most so many times as large.
constexpr double k_hopeless = 0.5, k_fair = 2.5;
// Pairs whose numbers are fitted together, and half of those that are judged by all pixels.
constexpr std::size_t k_fitted_pairs = 14, k_confirmed_pairs = 3;
// A pair that is not exact leaves at most this fraction of what the best single cause leaves, and explains
// this much.
constexpr double k_gain = 0.4, k_explains = 0.9;
// The numbers of so many pairs are fitted once more, if they leave at most this fraction of the difference.
constexpr std::size_t k_refined = 2;
constexpr double k_nearly = 0.3;
// Of exact pairs, what each fitted number must explain: there is no structure that it could fit by chance.
constexpr double k_exact_parameter = 0.0005;
// Faults that are rendered with another one, and pairs of which neither has to explain anything alone.
constexpr std::size_t k_seconds_rendered = 10, k_likely = 24;
constexpr std::size_t k_shifted = 3;  // causes with which shifts are tried alone

}  // namespace

PairSearch::PairSearch(const SceneRenderer& renderer, const BytePicture& reference,
                       const std::vector<std::uint8_t>& edges)
    : renderer_(renderer),
      reference_(reference),
      coarse_(coarse_grid_of(renderer.scene().shading, reference.width, reference.height)),
      fine_(grid_of(renderer.scene().shading, reference.width, reference.height)),
      all_{reference.width, reference.height, 1},
      edges_(edges),
      coarse_reference_(on_grid(reference, coarse_)),
      coarse_edges_(on_grid(edges, coarse_)),
      causes_(renderer, coarse_, renderer.scene()) {}

// `target` has all pixels.
Search PairSearch::coarse_search(const BytePicture& target, const Search& whole) const {
    return search_on(coarse_, target, coarse_edges_, coarse_reference_, whole);
}

void PairSearch::add(Trial& trial, CauseCandidate before, CauseCandidate after) {
    if (before.cause.name == after.cause.name) return;
    // The other model twice is the scene's own.
    const auto swaps_model = [](const CauseCandidate& c) {
        return c.cause.name.starts_with("shading-model");
    };
    if (swaps_model(before) && swaps_model(after)) return;
    const double left = after.left.all, whole = trial.coarse.whole.all;
    const double rating = rated(after, rated(before, left, whole), whole);
    trial.pairs.push_back({std::move(before), std::move(after), left, rating});
}

void PairSearch::try_scene(const CauseCandidate& first, std::size_t most, bool with_parts,
                           Trial& trial) const {
    const auto alone = render_candidate(renderer_, first, renderer_.scene(), coarse_);
    if (!alone) return;
    const Search& coarse = trial.coarse;
    for (CauseCandidate& other : candidates_after(effects_, causes_, *alone, first, coarse.faulty, most)) {
        PairCandidate pair{first.edit ? first : other, first.edit ? other : first};
        const auto made = render_pair(renderer_, coarse_, coarse, pair);
        if (!made || made->bytes.rgb == alone->bytes.rgb) continue;
        pair.after.left = distance(made->bytes, coarse.faulty, coarse.area);
        add(trial, std::move(pair.before), std::move(pair.after));
    }
    // A part of the light may be another one with `first`, or may not show in what is not clamped without it.
    for (std::size_t i = 0; with_parts && i < causes_.size() && !renderer_.is_cancelled(); ++i) {
        if (causes_.cause(i).part.empty() || causes_.cause(i).scaled == first.cause.name) continue;
        const CauseCandidate missing = causes_.candidate(i);
        PairCandidate pair{first.edit ? first : missing, first.edit ? missing : first};
        std::optional<RenderedScene> made = render_pair(renderer_, coarse_, coarse, pair);
        if (!made || made->bytes.rgb == alone->bytes.rgb) continue;
        std::vector<float> part = alone->image.rgb, &sum = made->image.rgb;
        for (std::size_t k = 0; k < part.size(); ++k) part[k] -= sum[k];
        const auto factor = fit_factor(sum, {coarse_.columns(), coarse_.rows(), part}, alone->bytes,
                                       coarse.faulty, coarse.area.rows);
        if (!factor || *factor < k_min_multiple) continue;
        for (std::size_t k = 0; k < part.size(); ++k) sum[k] += static_cast<float>(*factor) * part[k];
        (first.edit ? pair.after : pair.before) = causes_.scaled_candidate(i, *factor, true);
        pair.after.left = distance(to_bytes(made->image, 1, rule()), coarse.faulty, coarse.area);
        add(trial, std::move(pair.before), std::move(pair.after));
    }
}

// Numbers of the scene that are fitted, with the other cause in place.
void PairSearch::try_geometry(const CauseCandidate& other, Trial& trial) const {
    Search second = coarse_search(*trial.whole.target, trial.whole);
    second.target = &second.faulty;
    const auto render_with = [&](const FaultyScene& scene) {
        return render_candidate(renderer_, other, scene, coarse_);
    };
    const std::optional<RenderedScene> rendered = render_with(renderer_.scene());
    if (!rendered) return;
    const auto shapes = shapes_of_pixels(renderer_, coarse_);
    const auto shares = shares_of_shapes(shapes, rendered->bytes, second.faulty);
    try_missing_shapes(renderer_, {shapes, shares, rendered->bytes}, render_with, second);
    fit_geometry(geometry_causes(renderer_, shares), coarse_, renderer_.scene(), render_with, 2, second);
    for (CauseCandidate& before : best_of(second, 1)) {
        CauseCandidate after = other;
        after.left = before.left;
        add(trial, std::move(before), std::move(after));
    }
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
    const auto is_late = [](const CauseCandidate& c) { return c.of_pictures ? 2 : c.edit ? 0 : 1; };
    const bool is_after = is_late(first) > is_late(pair.second);
    PairCandidate changed{is_after ? pair.second : first, is_after ? first : pair.second};
    // Two that are not changes of the scene have no order that is known.
    if (first.cause.name == pair.second.cause.name || is_late(first) * is_late(pair.second) == 1 ||
        is_late(changed.before) == 2 || !confirm(search, changed))
        return std::nullopt;
    CausePair made{first, is_after ? changed.before : changed.after};
    made.second.left = changed.after.left;
    made.second.is_exact = changed.after.is_exact;
    return made;
}

// The best pairs, one of each two rows of the tables, with their numbers fitted.
void PairSearch::fit_best(Trial& trial) const {
    auto& pairs = trial.pairs;
    const auto by_rating = [](const PairCandidate& a, const PairCandidate& b) { return a.rating < b.rating; };
    sort_stably(pairs, by_rating);
    std::set<std::set<std::string>> known;
    std::erase_if(pairs, [&](const PairCandidate& p) {
        return !known.insert({row_key(p.before), row_key(p.after)}).second;
    });
    pairs.resize(std::min(pairs.size(), k_fitted_pairs));
    for (PairCandidate& pair : pairs) {
        if (!pair.is_fitted && !renderer_.is_cancelled())
            fit_pair(renderer_, causes_, coarse_, trial.coarse, pair);
        pair.is_fitted = true;
    }
    sort_stably(pairs, by_rating);
}

std::optional<CausePair> PairSearch::find(const Search& search) {
    if (!causes_.rendered()) return std::nullopt;
    if (effects_.empty()) effects_ = effects_of(renderer_, causes_, coarse_);
    Trial trial{search, coarse_search(*search.target, search), {}, {}};
    trial.coarse.whole = distance(on_grid(search.faulty, coarse_), coarse_reference_, trial.coarse.area);
    try_undone(trial);
    try_pictures(trial);
    for (auto& [a, b] : likely_pairs(effects_, causes_, trial.coarse.faulty, k_likely)) {
        PairCandidate pair{a.edit ? a : b, a.edit ? b : a};
        const auto made = render_pair(renderer_, coarse_, trial.coarse, pair);
        if (!made) continue;
        pair.after.left = distance(made->bytes, trial.coarse.faulty, trial.coarse.area);
        add(trial, std::move(pair.before), std::move(pair.after));
    }
    std::vector<CauseCandidate> firsts = trial.coarse.found;
    for (const CauseCandidate& found : search.found) {  // positions and colors, fitted to more pixels
        const bool is_known = std::any_of(firsts.begin(), firsts.end(), [&](const CauseCandidate& c) {
            return c.cause.name == found.cause.name;
        });
        if ((found.fitted || found.cause.name == k_shape_missing) && !is_known) firsts.push_back(found);
    }
    sort_stably(firsts, [&](const CauseCandidate& a, const CauseCandidate& b) {
        return rated(a, a.left.all, search.whole.all) < rated(b, b.left.all, search.whole.all);
    });
    std::set<std::string> known;
    std::erase_if(firsts, [&](const CauseCandidate& c) { return !known.insert(row_key(c)).second; });
    for (std::size_t i = 0; i < firsts.size() && !renderer_.is_cancelled(); ++i) {
        // A light that is missing may be hidden by the others, which are brighter.
        const bool with_parts = i < k_firsts_with_parts || firsts[i].cause.name == "light-missing";
        if (i < k_firsts || with_parts) try_scene(firsts[i], k_seconds_rendered, with_parts, trial);
    }
    firsts.resize(std::min(firsts.size(), k_firsts));
    fit_best(trial);
    const double whole = trial.coarse.whole.all;
    const auto goes_on = [&] {  // not if it is found, nor if this is another scene
        return trial.least() > std::min(k_pair_found * whole, k_rounding_mean) &&
               (search.same_view || trial.least() < k_hopeless * whole);
    };
    for (std::size_t i = 0; i < std::min(firsts.size(), k_firsts_with_all) && goes_on(); ++i)
        try_scene(firsts[i], SIZE_MAX, false, trial);  // changes that do not add up
    fit_best(trial);
    if (goes_on()) try_undone_geometry(trial);
    for (std::size_t i = 0; i < std::min(firsts.size(), k_geometry_firsts) && goes_on(); ++i)
        try_geometry(firsts[i], trial);
    fit_best(trial);
    std::vector<PairCandidate>& pairs = trial.pairs;
    const double calm = trial.coarse.whole.calm;
    if (k_fair * whole >= search.whole.all)
        std::erase_if(pairs, [&](const PairCandidate& p) {
            return p.left > k_hopeless * whole && p.after.left.calm >= k_hopeless * calm;
        });
    // The best by rating, and then by what they leave.
    const auto by_left = [](const PairCandidate& a, const PairCandidate& b) { return a.left < b.left; };
    if (pairs.size() > k_confirmed_pairs) sort_stably(std::span(pairs).subspan(k_confirmed_pairs), by_left);
    pairs.resize(std::min(pairs.size(), 2 * k_confirmed_pairs));
    return best_by_all_pixels(search, pairs);
}

// Edges that one cause leaves: a shift by a pixel or half of one, together with the best causes.
std::optional<CausePair> PairSearch::find_shifted(const Search& search) {
    std::vector<PairCandidate> pairs;
    for (const CauseCandidate& first : best_of(search, k_shifted)) {
        const bool is_undone = first.of_pictures && picture_causes()[*first.of_pictures].is_own_inverse;
        BytePicture target = *search.target;
        const Image none{target.width, target.height, {}};
        if (is_undone)
            picture_causes()[*first.of_pictures].make(
                {none, *search.target, reference_, search.area, search.area.rows, false}, target);
        Search coarse = coarse_search(target, search);
        coarse.target = &coarse.faulty;
        for (std::size_t i = 0; i < causes_.size() && !renderer_.is_cancelled(); ++i) {
            if (!causes_.cause(i).is_shift || first.cause.name == causes_.cause(i).name) continue;
            // What moves the camera comes before the shift of its picture.
            PairCandidate pair{first, causes_.candidate(i)};
            if (!first.edit) std::swap(pair.before, pair.after);
            const auto made =
                is_undone ? causes_.render_cause(i) : render_pair(renderer_, coarse_, coarse, pair);
            if (!made) continue;
            pair.left = pair.rating = distance(made->bytes, coarse.faulty, coarse.area).all;
            pairs.push_back(std::move(pair));
        }
    }
    sort_stably(pairs, [](const PairCandidate& a, const PairCandidate& b) { return a.left < b.left; });
    pairs.resize(std::min<std::size_t>(pairs.size(), 1));
    for (PairCandidate& pair : pairs) {
        Search coarse = coarse_search(*search.target, search);
        coarse.target = &coarse.faulty;
        fit_pair(renderer_, causes_, coarse_, coarse, pair);
    }
    return best_by_all_pixels(search, pairs);
}

// Sets what both leave of all pixels.
bool PairSearch::confirm(const Search& search, PairCandidate& pair) const {
    const std::optional<RenderedScene> made = render_pair(renderer_, all_, search, pair);
    if (made) {
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

// Fits numbers by more pixels.
void PairSearch::refine(const Search& search, PairCandidate& pair) const {
    const std::vector<std::uint8_t> edges = on_grid(edges_, fine_);
    Search fine = search_on(fine_, *search.target, edges, on_grid(reference_, fine_), search);
    fine.target = &fine.faulty;
    fit_pair(renderer_, causes_, fine_, fine, pair);
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
        if (!pair.after.is_exact && pair.after.left.all <= k_nearly * whole && refined < k_refined) {
            ++refined;
            refine(search, pair);
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
