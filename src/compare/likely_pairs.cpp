// SPDX-License-Identifier: Apache-2.0
// Which pairs are rendered.
#include <algorithm>
#include <map>
#include <string_view>

#include "base/sort_stably.h"
#include "compare/geometry_search.h"
#include "compare/missing_shapes.h"
#include "compare/pair_search.h"
#include "compare/picture_causes.h"

namespace glint {
namespace {

constexpr std::size_t k_likely = 24;  // pairs that are rendered because they are the most likely of all
constexpr std::string_view k_shift = "shifted-one-pixel";  // of pictures: it is a fault of the scene, too

}  // namespace

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

// What each cause explains alone.
void PairSearch::find_firsts(Trial& trial) const {
    for (const CauseCandidate& found : trial.whole.found) {  // numbers are fitted to more pixels
        if (found.of_pictures) continue;
        if (auto made = render_candidate(renderer_, found, renderer_.scene(), coarse_.grid))
            trial.found.push_back({found, *std::move(made)});
    }
    for (const CauseEffect& effect : effects_) trial.effects.push_back(&effect);
    for (const CauseEffect& effect : trial.found) trial.effects.push_back(&effect);
    const double whole = trial.coarse.whole.all;
    std::vector<std::pair<double, const CauseEffect*>> order;
    for (const CauseEffect* effect : trial.effects) {
        const double left = distance(effect->rendered.bytes, trial.coarse.faulty, trial.coarse.area).all;
        order.emplace_back(rated(effect->candidate, left, whole), effect);
    }
    sort_stably(order, [](const auto& a, const auto& b) { return a.first < b.first; });
    std::set<std::string> rows;
    for (const auto& [rating, effect] : order) {
        if (rows.insert(row_key(effect->candidate)).second) trial.firsts.push_back(effect);
    }
    // A number may be all, once it is fitted better: a pair with a cause that changes nothing.
    CauseCandidate nothing;
    nothing.set_edit([](FaultyScene&) {});
    for (const CauseEffect& effect : trial.found) {
        if (!effect.candidate.fitted) continue;
        nothing.left = distance(effect.rendered.bytes, trial.coarse.faulty, trial.coarse.area);
        add(trial, effect.candidate, nothing);
    }
    trial.likely = likely_pairs(trial.effects, causes_.rendered()->image, trial.coarse.faulty);
}

// Faults of pictures after each cause of the scene. Those that can be undone also after each other one.
void PairSearch::try_pictures(Trial& trial) const {
    const RenderedScene& plain = *causes_.rendered();
    double nearest = trial.coarse.whole.all;
    for (std::size_t i = 0; i < picture_causes().size() && !renderer_.is_cancelled(); ++i) {
        const PictureCause& cause = picture_causes()[i];
        const auto is_tried = [](const PictureCause& c) { return c.freedom == 0 && c.name != k_shift; };
        if (!is_tried(cause)) continue;
        CauseCandidate after = fault_of_pictures(i);
        const bool is_undone = can_be_undone(after);
        std::optional<Search> before = search_at(coarse_, trial.whole, after);
        // Not if that makes the difference larger.
        if (!before || (is_undone && before->whole.all >= trial.coarse.whole.all)) continue;
        if (is_undone && before->whole.all < nearest) {
            nearest = before->whole.all;
            trial.turn = after;
        }
        before->whole = trial.coarse.whole;
        BytePicture made = plain.bytes;
        const auto make = [&](const PictureCause& fault, const RenderedScene& of) {
            return fault
                .make({of.image, of.bytes, before->faulty, before->area, before->area.rows, true,
                       &renderer_.background(coarse_.grid)},
                      made)
                .has_value();
        };
        const auto judge = [&](CauseCandidate candidate, const BytePicture& bytes) {
            candidate.left = distance(bytes, before->faulty, before->area);
            before->found.push_back(std::move(candidate));
        };
        for (const CauseEffect& effect : effects_) {
            if (is_undone || make(cause, effect.rendered))
                judge(effect.candidate, is_undone ? effect.rendered.bytes : made);
        }
        for (std::size_t k = 0; is_undone && k < picture_causes().size(); ++k) {
            if (k != i && is_tried(picture_causes()[k]) && make(picture_causes()[k], plain))
                judge(fault_of_pictures(k), made);
        }
        for (CauseCandidate& candidate : best_of(*before, k_few_causes)) {
            after.left = candidate.left;
            add(trial, std::move(candidate), after);
        }
    }
}

// Renders the most likely pairs, and of each of the best causes so many.
void PairSearch::try_likely(std::size_t firsts, std::size_t seconds, Trial& trial) const {
    std::map<std::string, std::size_t> open;
    for (std::size_t i = 0; i < std::min(firsts, trial.firsts.size()); ++i)
        open[row_key(trial.firsts[i]->candidate)] = seconds;
    std::size_t of_all = k_likely;
    for (const LikelyPair& likely : trial.likely) {
        if (renderer_.is_cancelled()) return;
        std::string a = row_key(likely.a->candidate), b = row_key(likely.b->candidate);
        const auto of_a = open.find(a), of_b = open.find(b);
        bool is_tried = of_all > 0;
        for (const auto& of : {of_a, of_b}) is_tried = is_tried || (of != open.end() && of->second > 0);
        if (b < a) std::swap(a, b);
        if (!is_tried || !trial.known.insert({std::move(a), std::move(b)}).second) continue;
        if (of_all > 0) --of_all;
        for (const auto& of : {of_a, of_b}) {
            if (of != open.end() && of->second > 0) --of->second;
        }
        if (likely.a->is_multiple != likely.b->is_multiple) {
            likely.a->is_multiple ? try_multiple(*likely.b, *likely.a, trial)
                                  : try_multiple(*likely.a, *likely.b, trial);
            continue;
        }
        PairCandidate pair = in_order(candidate_of(*likely.a, likely.by_a, causes_),
                                      candidate_of(*likely.b, likely.by_b, causes_));
        // Of two changes of the scene one may undo or use the other, in one order.
        const int orders = of_all > 0 && pair.after.edit ? 2 : 1;
        for (int i = 0; i < orders; ++i, std::swap(pair.before, pair.after)) {
            const auto made = render_pair(renderer_, coarse_.grid, trial.coarse, pair);
            if (!made) continue;
            pair.after.left = distance(made->bytes, trial.coarse.faulty, trial.coarse.area);
            add(trial, pair.before, pair.after);
        }
    }
}

// With another cause, a part of the light may be another one. Light is a sum, so the picture with any
// multiple of a part is known from two.
void PairSearch::try_multiple(const CauseEffect& other, const CauseEffect& multiple, Trial& trial) const {
    PairCandidate pair = in_order(other.candidate, multiple.candidate);
    const auto made = render_pair(renderer_, coarse_.grid, trial.coarse, pair);
    if (!made) return;
    const auto by = static_cast<float>(1 / (1 - multiple.candidate.values[0]));
    std::vector<float> part = other.rendered.image.rgb, rest = part;
    for (std::size_t k = 0; k < part.size(); ++k) {
        part[k] = by * (part[k] - made->image.rgb[k]);
        rest[k] -= part[k];
    }
    const auto factor = fit_factor(rest, {coarse_.grid.columns(), coarse_.grid.rows(), part},
                                   other.rendered.bytes, trial.coarse.faulty, trial.coarse.area.rows);
    if (!factor || *factor < k_min_multiple) return;
    for (std::size_t k = 0; k < part.size(); ++k) rest[k] += static_cast<float>(*factor) * part[k];
    const BytePicture bytes = to_bytes({coarse_.grid.columns(), coarse_.grid.rows(), rest}, 1, rule());
    pair = in_order(other.candidate, causes_.scaled_candidate(multiple.candidate.row, *factor, true));
    pair.after.left = distance(bytes, trial.coarse.faulty, trial.coarse.area);
    add(trial, std::move(pair.before), std::move(pair.after));
}

// Numbers of the scene that are fitted, with the other cause in place, or without it if it can be undone.
void PairSearch::try_geometry(const CauseCandidate& other, Trial& trial) const {
    std::optional<Search> second = search_at(coarse_, trial.whole, other);
    if (!second) return;
    second->target = &second->faulty;
    second->whole = trial.coarse.whole;
    const auto render_with = [&](const FaultyScene& scene) {
        return can_be_undone(other) ? renderer_.render(scene, coarse_.grid)
                                    : render_candidate(renderer_, other, scene, coarse_.grid);
    };
    const std::optional<RenderedScene> rendered = render_with(renderer_.scene());
    if (!rendered) return;
    const auto shapes = shapes_of_pixels(renderer_, coarse_.grid);
    const auto shares = shares_of_shapes(shapes, rendered->bytes, second->faulty);
    try_missing_shapes(renderer_, {shapes, shares, rendered->bytes}, render_with, *second);
    fit_geometry(geometry_causes(renderer_, shares), coarse_.grid, renderer_.scene(), render_with,
                 k_fewer_causes, *second);
    for (CauseCandidate& before : best_of(*second, 1)) {
        CauseCandidate after = other;
        after.left = before.left;
        add(trial, std::move(before), std::move(after));
    }
}

}  // namespace glint
