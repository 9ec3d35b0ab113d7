// SPDX-License-Identifier: Apache-2.0
#include "compare/pair_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compare/geometry_search.h"
#include "compare/parameter_fit.h"
#include "compare/picture_causes.h"

namespace glint {
namespace {

// Causes of the scene with which all others are tried, those of them with which numbers of the scene are
// fitted, and the numbers of seconds that are kept for each.
constexpr std::size_t k_firsts = 16, k_firsts_with_parts = 6, k_geometry_firsts = 2, k_seconds = 3;
// Pairs whose numbers are fitted together, and half of those that are judged by all pixels.
constexpr std::size_t k_fitted = 14, k_confirmed = 3;
// Positions and colours are fitted unless a pair leaves less than this fraction of the difference.
constexpr double k_found = 0.02;
// A pair that is not exact leaves at most this fraction of what the best single cause leaves, and explains
// this much.
constexpr double k_gain = 0.4, k_explains = 0.9;
// Numbers that a fault of pictures with a detail fits.
constexpr int k_detail_parameters = 2;
// Faults that are rendered with another one.
constexpr std::size_t k_seconds_rendered = 10;
// Multiples of a number that are tried under a fault of pictures, as starts of a fit.
constexpr double k_multiples[] = {0.5, 0.7, 1.5, 2}, k_factors[] = {0.25, 0.5, 0.7, 1.5, 2, 4};
// Needs all pixels.
constexpr std::string_view k_shift = "shifted-one-pixel";
constexpr std::size_t k_shifted = 2;  // causes that are tried with it
// Rounds of a fit by least absolute differences; a multiple below the least is a part that is missing.
constexpr int k_rounds = 4;
constexpr double k_min_multiple = 0.03;

// What two candidates of one row have in common, whatever their numbers are.
std::string key(const CauseCandidate& c) {
    return fmt::format("{} {} {}", c.cause.name, c.row, c.of_pictures.has_value());
}

CauseCandidate fault_of_pictures(std::size_t i) {
    const PictureCause& cause = picture_causes()[i];
    CauseCandidate candidate{{cause.name, cause.explanation, 0, 0, false}, cause.least};
    candidate.of_pictures = i;
    // What the explanation names is fitted.
    if (candidate.cause.explanation.find("{}") != std::string::npos)
        candidate.parameters = k_detail_parameters;
    return candidate;
}

// The factor of `part` that is nearest to `wanted`, by least absolute differences.
double multiple_of(const std::vector<float>& part, const std::vector<float>& wanted,
                   const std::vector<std::uint8_t>& is_known) {
    double factor = 0;
    for (int round = 0; round < k_rounds; ++round) {
        double products = 0, squares = 0;
        for (std::size_t k = 0; k < part.size(); ++k) {
            if (is_known[k] == 0) continue;
            const auto p = static_cast<double>(part[k]), w = static_cast<double>(wanted[k]);
            const double weight = round == 0 ? 1 : 1 / std::max(std::fabs(w - factor * p), 0.5 / 255);
            products += weight * w * p;
            squares += weight * p * p;
        }
        if (!(squares > 0)) return 0;
        factor = products / squares;
    }
    return factor;
}

}  // namespace

struct PairSearch::Trial {
    const Search& whole;
    Search coarse;
    std::vector<Pair> pairs;

    double least() const {
        double left = coarse.whole.all;
        for (const Pair& pair : pairs) left = std::min(left, pair.left);
        return left;
    }
};

PairSearch::PairSearch(const SceneRenderer& renderer, const BytePicture& reference,
                       const std::vector<std::uint8_t>& edges)
    : renderer_(renderer),
      reference_(reference),
      coarse_(coarse_grid_of(renderer.scene().shading, reference.width, reference.height)),
      all_{reference.width, reference.height, 1},
      coarse_reference_(on_grid(reference, coarse_)),
      coarse_edges_(on_grid(edges, coarse_)),
      causes_(renderer, coarse_, renderer.scene()) {}

// `target` has all pixels.
Search PairSearch::coarse_search(const BytePicture& target, const Search& whole) const {
    Search search;
    search.faulty = on_grid(target, coarse_);
    search.area = {&coarse_edges_, all_rows(coarse_.rows()), whole.area.rim, 1};
    search.sample = search.area;
    search.report.difference = 1;
    search.has_content = whole.has_content;
    search.whole = distance(search.faulty, coarse_reference_, search.area);
    return search;
}

void PairSearch::add(Trial& trial, CauseCandidate before, CauseCandidate after) {
    if (before.cause.name == after.cause.name) return;
    const double left = after.left.all, whole = trial.coarse.whole.all;
    const double rating = rated(after, rated(before, left, whole), whole);
    trial.pairs.push_back({std::move(before), std::move(after), left, rating});
}

// All causes of the scene for the picture, and for the picture without a fault of pictures, where that can be
// undone and leaves less of a difference.
void PairSearch::try_undone(Trial& trial) const {
    std::vector<std::size_t> undone;
    std::vector<Search> without;
    const BytePicture& target = *trial.whole.target;
    const Image none{target.width, target.height, {}};
    const PictureSource source{none, target, reference_, trial.whole.area, trial.whole.area.rows, false};
    for (std::size_t i = 0; i < picture_causes().size(); ++i) {
        BytePicture made = target;
        if (!picture_causes()[i].is_own_inverse || !picture_causes()[i].make(source, made)) continue;
        Search search = coarse_search(made, trial.whole);
        if (search.whole.all >= trial.coarse.whole.all) continue;
        search.whole = trial.coarse.whole;
        undone.push_back(i);
        without.push_back(std::move(search));
    }
    trial.coarse.target = &trial.coarse.faulty;
    std::vector<Search*> searches = {&trial.coarse};
    for (Search& search : without) {
        search.target = &search.faulty;
        searches.push_back(&search);
    }
    for (std::size_t i = 0; i < causes_.size() && !renderer_.is_cancelled(); ++i)
        causes_.try_cause(i, searches);
    for (std::size_t k = 0; k < undone.size(); ++k) {
        CauseCandidate after = fault_of_pictures(undone[k]);
        try_two_of_pictures(undone[k], without[k], trial);
        for (CauseCandidate& before : best_of(without[k], k_seconds)) {
            after.left = before.left;
            add(trial, std::move(before), after);
        }
    }
}

// `undone` is the search for the picture without that fault of pictures.
void PairSearch::try_two_of_pictures(std::size_t after, const Search& undone, Trial& trial) const {
    BytePicture made = undone.faulty;
    const RenderedScene& plain = *causes_.rendered();
    const PictureSource from{plain.image, plain.bytes, undone.faulty, undone.area, undone.area.rows, true};
    for (std::size_t i = 0; i < picture_causes().size(); ++i) {
        const PictureCause& cause = picture_causes()[i];
        if (i == after || cause.freedom > 0 || !cause.make(from, made)) continue;
        CauseCandidate second = fault_of_pictures(after);
        second.left = distance(made, undone.faulty, undone.area);
        add(trial, fault_of_pictures(i), std::move(second));
    }
}

void PairSearch::make_effects() {
    if (!effects_.empty()) return;
    const Image& plain = causes_.rendered()->image;
    for (std::size_t i = 0; i < causes_.size() && !renderer_.is_cancelled(); ++i) {
        const SceneCause& cause = causes_.cause(i);
        for (const double factor : k_factors) {
            if (!cause.scale) break;
            CauseCandidate candidate = causes_.scaled_candidate(i, factor, true);
            if (auto scaled = render_candidate(renderer_, candidate, renderer_.scene(), coarse_))
                effects_.push_back({std::move(candidate), *std::move(scaled), false});
        }
        std::optional<RenderedScene> made = causes_.render_cause(i);
        if (!made || made->bytes.rgb == causes_.rendered()->bytes.rgb) continue;
        for (const double factor : k_multiples) {
            if (cause.part.empty()) break;
            Image image = made->image;
            for (std::size_t k = 0; k < image.rgb.size(); ++k)
                image.rgb[k] += static_cast<float>(factor) * (plain.rgb[k] - image.rgb[k]);
            BytePicture bytes = to_bytes(image, 1);
            effects_.push_back(
                {causes_.scaled_candidate(i, factor, true), {std::move(image), std::move(bytes)}, true});
        }
        effects_.push_back({causes_.candidate(i), *std::move(made), false});
    }
}

// A fault of pictures after each of the scene.
void PairSearch::try_pictures(Trial& trial) {
    make_effects();
    const Search& coarse = trial.coarse;
    BytePicture made = coarse.faulty;
    for (std::size_t i = 0; i < picture_causes().size() && !renderer_.is_cancelled(); ++i) {
        const PictureCause& cause = picture_causes()[i];
        const bool is_of_grid = coarse_.step == 1 || cause.name != k_shift;
        if (cause.is_own_inverse || cause.freedom > 0 || !is_of_grid) continue;
        Search second = coarse_search(*trial.whole.target, trial.whole);
        second.whole = coarse.whole;
        CauseCandidate after = fault_of_pictures(i);
        for (const Effect& effect : effects_) {
            const PictureSource from{effect.rendered.image, effect.rendered.bytes, coarse.faulty,
                                     coarse.area,           coarse.area.rows,      true};
            if (!cause.make(from, made)) continue;
            CauseCandidate candidate = effect.candidate;
            candidate.left = distance(made, coarse.faulty, coarse.area);
            second.found.push_back(std::move(candidate));
        }
        for (CauseCandidate& before : best_of(second, k_seconds)) {
            after.left = before.left;
            add(trial, std::move(before), after);
        }
    }
}

// The changes of light by two faults nearly add up. This says which effects are worth a rendering with
// `first`.
std::vector<CauseCandidate> PairSearch::candidates_after(const RenderedScene& first,
                                                         const CauseCandidate& cause,
                                                         const BytePicture& target) const {
    const std::vector<float>& plain = causes_.rendered()->image.rgb;
    const std::size_t size = plain.size();
    std::vector<float> wanted(size), part(size), rest(size);
    std::vector<std::uint8_t> is_known(size);  // not clamped
    for (std::size_t k = 0; k < size; ++k) {
        wanted[k] = static_cast<float>(target.rgb[k]) / 255;
        rest[k] = wanted[k] - first.image.rgb[k];
        is_known[k] = target.rgb[k] > 0 && target.rgb[k] < 255 && first.image.rgb[k] < 1;
    }
    std::vector<std::pair<double, CauseCandidate>> order;
    for (const Effect& effect : effects_) {
        CauseCandidate candidate = effect.candidate;
        if (candidate.cause.name == cause.cause.name || (!cause.edit && !candidate.edit)) continue;
        for (std::size_t k = 0; k < size; ++k) part[k] = effect.rendered.image.rgb[k] - plain[k];
        float by = 1;
        if (effect.is_multiple) {
            if (candidate.values[0] != k_multiples[0]) continue;  // one of them says what the others would
            by = static_cast<float>(multiple_of(part, rest, is_known));
            const double factor = 1 + static_cast<double>(by) * (k_multiples[0] - 1);
            if (factor < k_min_multiple) continue;
            candidate = causes_.scaled_candidate(candidate.row, factor, true);
        }
        double left = 0;
        for (std::size_t k = 0; k < size; ++k) {
            const float sum = first.image.rgb[k] + by * part[k];
            left += static_cast<double>(std::fabs(std::clamp(sum, 0.0f, 1.0f) - wanted[k]));
        }
        order.emplace_back(left, std::move(candidate));
    }
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<CauseCandidate> best;
    std::set<std::string> known;
    for (auto& [left, candidate] : order) {
        if (best.size() == k_seconds_rendered) break;
        if (known.insert(key(candidate)).second) best.push_back(std::move(candidate));
    }
    return best;
}

void PairSearch::try_scene(const CauseCandidate& first, bool with_parts, Trial& trial) const {
    const auto alone = render_candidate(renderer_, first, renderer_.scene(), coarse_);
    if (!alone) return;
    const Search& coarse = trial.coarse;
    for (CauseCandidate& other : candidates_after(*alone, first, coarse.faulty)) {
        Pair pair{first.edit ? first : other, first.edit ? other : first};
        const auto made = render(pair, coarse_, coarse);
        if (!made || made->bytes.rgb == alone->bytes.rgb) continue;
        pair.after.left = distance(made->bytes, coarse.faulty, coarse.area);
        add(trial, std::move(pair.before), std::move(pair.after));
    }
    // A part of the light may be another one with `first`, or may not show in what is not clamped without it.
    for (std::size_t i = 0; with_parts && i < causes_.size() && !renderer_.is_cancelled(); ++i) {
        if (causes_.cause(i).part.empty() || causes_.cause(i).scaled == first.cause.name) continue;
        const CauseCandidate missing = causes_.candidate(i);
        Pair pair{first.edit ? first : missing, first.edit ? missing : first};
        std::optional<RenderedScene> made = render(pair, coarse_, coarse);
        if (!made || made->bytes.rgb == alone->bytes.rgb) continue;
        std::vector<float> part = alone->image.rgb, &sum = made->image.rgb;
        for (std::size_t k = 0; k < part.size(); ++k) part[k] -= sum[k];
        const auto factor = fit_factor(sum, part, alone->bytes, coarse.faulty, coarse.area.rows);
        if (!factor || *factor < k_min_multiple) continue;
        for (std::size_t k = 0; k < part.size(); ++k) sum[k] += static_cast<float>(*factor) * part[k];
        (first.edit ? pair.after : pair.before) = causes_.scaled_candidate(i, *factor, true);
        pair.after.left = distance(to_bytes(made->image, 1), coarse.faulty, coarse.area);
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
    const auto shares =
        shares_of_shapes(shapes_of_pixels(renderer_, coarse_), rendered->bytes, second.faulty);
    fit_geometry(geometry_causes(renderer_, shares), coarse_, renderer_.scene(), render_with, 2, second);
    for (CauseCandidate& before : best_of(second, 1)) {
        CauseCandidate after = other;
        after.left = before.left;
        add(trial, std::move(before), std::move(after));
    }
}

// Fills in the explanation of a fault of pictures.
std::optional<RenderedScene> PairSearch::render(Pair& pair, const PixelGrid& grid,
                                                const Search& search) const {
    FaultyScene base = renderer_.scene();
    if (!pair.after.of_pictures) {
        pair.before.edit(base);
        return render_candidate(renderer_, pair.after, base, grid);
    }
    std::optional<RenderedScene> made = pair.before.of_pictures
                                            ? renderer_.render(base, grid)
                                            : render_candidate(renderer_, pair.before, base, grid);
    for (CauseCandidate* fault : {&pair.before, &pair.after}) {
        if (!fault->of_pictures || !made) continue;
        BytePicture bytes = made->bytes;
        const PictureCause& cause = picture_causes()[*fault->of_pictures];
        const auto detail = cause.make(
            {made->image, made->bytes, *search.target, search.area, search.area.rows, true}, bytes);
        if (!detail) return std::nullopt;
        fault->cause.explanation = fmt::format(fmt::runtime(cause.explanation), *detail);
        for (std::size_t i = 0; i < bytes.rgb.size(); ++i)
            made->image.rgb[i] = static_cast<float>(bytes.rgb[i]) / 255;
        made->bytes = std::move(bytes);
    }
    return made;
}

// Fits the numbers of both causes together.
void PairSearch::fit(Pair& pair, const Search& coarse) const {
    FitProblem problem;
    for (const CauseCandidate* c : {&pair.before, &pair.after}) {
        problem.start.insert(problem.start.end(), c->values.begin(), c->values.end());
        if (c->fitted)
            problem.units.insert(problem.units.end(), c->fitted->units.begin(), c->fitted->units.end());
    }
    const bool is_undone = pair.after.of_pictures && picture_causes()[*pair.after.of_pictures].is_own_inverse;
    if (problem.start.empty() || is_undone) return;
    const auto with_values = [&](std::span<const double> values, bool about) {
        Pair changed = pair;
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(pair.before.values.size());
        if (changed.before.fitted) changed.before.set_values({values.begin(), middle}, about);
        if (changed.after.fitted) changed.after.set_values({middle, values.end()}, about);
        return changed;
    };
    problem.render = [&](std::span<const double> values) -> std::optional<std::vector<float>> {
        Pair changed = with_values(values, true);
        std::optional<RenderedScene> made = render(changed, coarse_, coarse);
        if (!made) return std::nullopt;
        return std::move(made->image.rgb);
    };
    const std::optional<Fit> fit = ParameterFit(coarse_, *coarse.target).fit(problem, FitStart::near);
    if (!fit) return;
    Pair fitted = with_values(fit->values, fit->left > k_found);
    for (CauseCandidate* c : {&fitted.before, &fitted.after}) {
        const bool is_of_part =
            c->fitted && c->row < causes_.size() && c->cause.name == causes_.cause(c->row).scaled;
        if (is_of_part && c->values[0] < k_min_multiple) *c = causes_.candidate(c->row);  // it is missing
    }
    fitted.rating += fit->left - pair.left;
    fitted.left = fit->left;
    pair = std::move(fitted);
}

// In the order in which they are named: first the one that explains more alone.
CausePair PairSearch::named(Pair pair, const Search& search) const {
    const Distance both = pair.after.left;
    for (CauseCandidate* c : {&pair.before, &pair.after}) {
        c->is_exact = pair.after.is_exact;
        c->left = search.whole;
        if (c->of_pictures) {
            for (const CauseCandidate& found : search.found) {
                if (found.of_pictures == c->of_pictures) c->left = found.left;
            }
        } else if (const auto made = render_candidate(renderer_, *c, renderer_.scene(), all_)) {
            c->left = distance(made->bytes, *search.target, search.area);
        }
    }
    CausePair named{std::move(pair.before), std::move(pair.after)};
    if (named.second.left.all < named.first.left.all) std::swap(named.first, named.second);
    named.second.left = both;
    return named;
}

// The best pairs, one of each two rows of the tables, with their numbers fitted.
void PairSearch::fit_best(Trial& trial) const {
    auto& pairs = trial.pairs;
    const auto by_rating = [](const Pair& a, const Pair& b) { return a.rating < b.rating; };
    std::stable_sort(pairs.begin(), pairs.end(), by_rating);
    std::set<std::set<std::string>> known;
    std::erase_if(pairs, [&](const Pair& p) { return !known.insert({key(p.before), key(p.after)}).second; });
    pairs.resize(std::min(pairs.size(), k_fitted));
    for (Pair& pair : pairs) {
        if (!pair.is_fitted && !renderer_.is_cancelled()) fit(pair, trial.coarse);
        pair.is_fitted = true;
    }
    std::stable_sort(pairs.begin(), pairs.end(), by_rating);
}

// A shift by a pixel after the best causes of the scene.
void PairSearch::add_shifted(const std::vector<CauseCandidate>& firsts, std::vector<Pair>& pairs) const {
    for (std::size_t i = 0; i < picture_causes().size(); ++i) {
        if (picture_causes()[i].name != k_shift) continue;
        for (std::size_t k = 0; k < std::min(firsts.size(), k_shifted); ++k)
            pairs.push_back({firsts[k], fault_of_pictures(i)});
    }
}

std::optional<CausePair> PairSearch::find(const Search& search) {
    if (!causes_.rendered()) return std::nullopt;
    make_effects();
    Trial trial{search, coarse_search(*search.target, search), {}};
    trial.coarse.whole = distance(on_grid(search.faulty, coarse_), coarse_reference_, trial.coarse.area);
    try_undone(trial);
    try_pictures(trial);
    std::vector<CauseCandidate> firsts = trial.coarse.found;
    for (const CauseCandidate& found : search.found) {  // positions and colours, fitted to more pixels
        const bool is_known = std::any_of(firsts.begin(), firsts.end(), [&](const CauseCandidate& c) {
            return c.cause.name == found.cause.name;
        });
        if (found.fitted && !is_known) firsts.push_back(found);
    }
    std::stable_sort(firsts.begin(), firsts.end(), [&](const CauseCandidate& a, const CauseCandidate& b) {
        return rated(a, a.left.all, search.whole.all) < rated(b, b.left.all, search.whole.all);
    });
    std::set<std::string> known;
    std::erase_if(firsts, [&](const CauseCandidate& c) { return !known.insert(key(c)).second; });
    firsts.resize(std::min(firsts.size(), k_firsts));
    for (std::size_t i = 0; i < firsts.size() && !renderer_.is_cancelled(); ++i)
        try_scene(firsts[i], i < k_firsts_with_parts, trial);
    fit_best(trial);
    if (trial.least() > k_found * trial.coarse.whole.all) {
        for (std::size_t i = 0; i < std::min(firsts.size(), k_geometry_firsts); ++i)
            try_geometry(firsts[i], trial);
        fit_best(trial);
    }
    std::vector<Pair>& pairs = trial.pairs;  // the best by rating, and then by what they leave
    const auto by_left = [](const Pair& a, const Pair& b) { return a.left < b.left; };
    if (pairs.size() > k_confirmed) std::stable_sort(pairs.begin() + k_confirmed, pairs.end(), by_left);
    pairs.resize(std::min(pairs.size(), 2 * k_confirmed));
    add_shifted(firsts, pairs);
    const Pair* best = nullptr;
    double least = search.whole.all;
    for (const CauseCandidate& c : search.found) least = std::min(least, c.left.all);
    for (Pair& pair : pairs) {
        const std::optional<RenderedScene> made = render(pair, all_, search);
        if (!made) continue;
        search.confirm(made->bytes, pair.after);
        const double left = pair.after.left.all;
        if (!pair.after.is_exact && (left > k_gain * least || left > (1 - k_explains) * search.whole.all))
            continue;
        if (best == nullptr || (pair.after.is_exact && !best->after.is_exact)) best = &pair;
    }
    if (best == nullptr) return std::nullopt;
    return named(*best, search);
}

}  // namespace glint
