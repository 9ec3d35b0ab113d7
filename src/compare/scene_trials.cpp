// SPDX-License-Identifier: Apache-2.0
#include "compare/scene_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/memory_limit.h"
#include "base/sort_stably.h"
#include "compare/geometry_search.h"
#include "compare/item_texts.h"
#include "compare/left_structure.h"
#include "compare/missing_shapes.h"

namespace glint {
namespace {

// Candidates that are judged by all pixels, and causes whose numbers are fitted.
constexpr std::size_t k_confirmed_trials = 6, k_fitted_trials = 4;
// Nothing more is fitted once a cause leaves so little of the difference.
constexpr double k_little_left = 0.02;
// If the grid's difference and that of all pixels are further apart than this factor, all pixels are used.
constexpr double k_fair_grid = 2.5;
// Other forms of a cause are fitted if it leaves at most this fraction of the difference.
constexpr double k_has_forms = 0.6;
// A candidate that explains less of the grid's difference than this part of what it must is judged by all
// pixels only if it may be the nearest, whose share is said.
constexpr double k_worth_judging = 0.5;
// Bytes of each pixel before causes are tried on all of them, at least.
constexpr std::size_t k_before_trials = 40;
// Factors whose picture may be that of a term that is missing: from where the search for factors ends.
constexpr double k_least_limit = 8, k_most_limit = 4096, k_limit_step = 1.414213562373095;
// Another cause gives the picture without the term if it differs from that in at most this fraction of the
// pixels that it changes.
constexpr double k_limit_pixels = 0.02;
constexpr std::size_t k_named_shapes = 3;
constexpr double k_said_share = 0.1;

bool is_worth_judging(const CauseCandidate& c, const Distance& whole) {
    const double most = 1 - k_worth_judging * c.least;
    return c.left.all <= most * whole.all || c.left.calm < most * whole.calm;
}

// What remains of all pixels' difference if it is the same fraction as of the grid's.
double estimate(double left, double whole_of_grid, double whole) {
    return whole_of_grid > 0 ? left / whole_of_grid * whole : whole;
}

double pixels_beyond_rounding(const BytePicture& a, const BytePicture& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
        const auto is_beyond = [&](std::size_t c) {
            return std::abs(int{a.rgb[i + c]} - int{b.rgb[i + c]}) > k_rounding;
        };
        count += is_beyond(0) || is_beyond(1) || is_beyond(2);
    }
    return static_cast<double>(count);
}

}  // namespace

SceneTrials::SceneTrials(const Scene& scene, const BytePicture& reference,
                         const std::vector<std::uint8_t>& edges, const CauseOptions& options)
    : reference_(reference),
      edges_(edges),
      renderer_(scene, reference.width, reference.height, options),
      grid_(grid_of(scene, reference.width, reference.height)),
      max_memory_(options.max_memory) {
    if (!renderer_.is_prepared()) return;
    rendered_ = renderer_.render(renderer_.scene(), {reference.width, reference.height, 1});
    if (!rendered_) return;
    grid_edges_ = on_grid(edges_, grid_);
    search_ = std::make_unique<SceneSearch>(renderer_, grid_, renderer_.scene());
    if (!search_->rendered()) search_.reset();
}

SceneTrials::GridSearch SceneTrials::grid_search(Search& whole, const PixelGrid& grid) const {
    const std::vector<std::uint8_t>& edges = grid.step == 1 ? edges_ : grid_edges_;
    const BytePicture& from = whole.target == &reference_ ? whole.faulty : reference_;
    return {search_on(grid, *whole.target, edges, on_grid(from, grid), whole), &whole};
}

void SceneTrials::run(std::vector<Search>& searches, const std::function<void()>& step) {
    if (!search_) return;
    std::vector<GridSearch> fair, others;
    for (Search& search : searches) {
        if (!search.is_open()) continue;
        GridSearch small = grid_search(search, grid_);
        const bool is_fair = small.search.whole.all * k_fair_grid >= search.whole.all &&
                             small.search.whole.all <= search.whole.all * k_fair_grid;
        const PixelGrid all{grid_.width, grid_.height, 1};
        if (is_fair || grid_.step == 1) {
            fair.push_back(std::move(small));
        } else if (search.status = memory_for_all(); search.status.ok()) {
            others.push_back(grid_search(search, all));
        }
    }
    if (!fair.empty()) run_on(grid_, fair, step);
    if (!others.empty())
        run_on({grid_.width, grid_.height, 1}, others, fair.empty() ? step : std::function<void()>([] {}));
}

Status SceneTrials::memory_for_all() const {
    return memory_fault((k_before_trials + k_trial_bytes) * (reference_.rgb.size() / 3), max_memory_,
                        "the difference is of few pixels: trying the scene's causes on all pixels");
}

void SceneTrials::run_on(const PixelGrid& grid, std::vector<GridSearch>& searches,
                         const std::function<void()>& step) {
    std::vector<Search*> list;
    for (GridSearch& s : searches) {
        s.search.target = &s.search.faulty;
        list.push_back(&s.search);
    }
    std::unique_ptr<SceneSearch> own;
    if (grid.step != grid_.step) own = std::make_unique<SceneSearch>(renderer_, grid, renderer_.scene());
    const SceneSearch& search = own ? *own : *search_;
    if (!search.rendered()) return;
    for (std::size_t i = 0; i < search.size() && !is_cancelled(); ++i) {
        if (!search.cause(i).only_pairs) search.try_cause(i, list);
        step();
    }
    for (GridSearch& s : searches) {
        if (is_cancelled()) return;
        const bool is_found = std::any_of(
            s.search.found.begin(), s.search.found.end(),
            [&](const CauseCandidate& c) { return c.left.all <= k_little_left * s.search.whole.all; });
        const bool is_seen =
            std::any_of(s.whole->found.begin(), s.whole->found.end(), [&](const CauseCandidate& c) {
                return c.freedom == 0 && c.left.all <= k_little_left * s.whole->whole.all;
            });
        if (!is_found && !is_seen && s.whole->has_content) try_geometry(grid, *search.rendered(), s);
        confirm(s);
    }
}

void SceneTrials::try_geometry(const PixelGrid& grid, const RenderedScene& rendered,
                               GridSearch& search) const {
    const auto shapes = shapes_of_pixels(renderer_, grid);
    const auto shares = shares_of_shapes(shapes, rendered.bytes, search.search.faulty);
    const auto render = [&](const FaultyScene& scene) { return renderer_.render(scene, grid); };
    try_missing_shapes(renderer_, {shapes, shares, rendered.bytes}, render, search.search);
    const bool is_missing =
        std::any_of(search.search.found.begin(), search.search.found.end(), [&](const CauseCandidate& c) {
            return c.cause.name == k_shape_missing && c.left.all <= k_little_left * search.search.whole.all;
        });
    if (is_missing) return;
    fit_geometry(geometry_causes(renderer_, shares), grid, renderer_.scene(), render, k_fitted_trials,
                 search.search);
    try_forms(grid, search);
}

// Other forms of the best cause, on fewer pixels: they are many.
void SceneTrials::try_forms(const PixelGrid& grid, GridSearch& search) const {
    const std::vector<CauseCandidate> best = best_of(search.search, 1);
    if (best.empty() || !best[0].fitted || !best[0].fitted->refined || is_cancelled()) return;
    const double left = best[0].left.all, whole = search.search.whole.all;
    if (left <= k_little_left * whole || left > k_has_forms * whole) return;
    const PixelGrid few = coarse_grid_of(renderer_.scene().shading, reference_.width, reference_.height);
    const std::vector<std::uint8_t> edges = on_grid(edges_, few);
    const auto at_first = renderer_.render(renderer_.scene(), few);
    if (!at_first) return;
    Search coarse = search_on(few, *search.whole->target, edges, at_first->bytes, *search.whole);
    coarse.target = &coarse.faulty;
    fit_forms(
        *best[0].fitted, best[0].values, few, renderer_.scene(),
        [&](const FaultyScene& scene) { return renderer_.render(scene, few); }, coarse);
    for (CauseCandidate& candidate : best_of(coarse, 1)) {
        const auto made = render_candidate(renderer_, candidate, renderer_.scene(), grid);
        if (made) search.search.judge(made->bytes, std::move(candidate));
    }
}

void SceneTrials::confirm(GridSearch& small) const {
    Search& whole = *small.whole;
    const int tried = whole.report.tried + small.search.report.tried;
    std::vector<CauseCandidate> best = best_of(small.search, k_confirmed_trials);
    // Of candidates that leave nearly the same, the first in the table is named.
    sort_stably(best, [](const CauseCandidate& a, const CauseCandidate& b) { return a.row < b.row; });
    double least = HUGE_VAL;
    for (const CauseCandidate& c : best) {
        if (c.parameters <= 1) least = std::min(least, c.left.all);
    }
    for (CauseCandidate& candidate : best) {
        if (is_cancelled()) return;
        const Distance &left = candidate.left, &of_grid = small.search.whole;
        const bool is_nearest = candidate.parameters <= 1 && left.all == least;
        if (!is_nearest && !is_worth_judging(candidate, of_grid)) {
            candidate.left = {estimate(left.all, of_grid.all, whole.whole.all),
                              estimate(left.calm, of_grid.calm, whole.whole.calm)};
            whole.found.push_back(std::move(candidate));
            continue;
        }
        const auto made =
            render_candidate(renderer_, candidate, renderer_.scene(), {grid_.width, grid_.height, 1});
        if (!made) continue;
        whole.confirm(made->bytes, made->image, renderer_.rule(renderer_.scene().shading), candidate,
                      candidate.is_near());
        std::optional<CauseCandidate> rival = judge_limit(whole, *made, candidate);
        whole.add(made->bytes, std::move(candidate));
        if (rival) whole.add(made->bytes, *std::move(rival));
    }
    whole.report.tried = tried;
}

// Is this the picture that ever larger factors of cause `row` approach, but for a few pixels?
bool SceneTrials::is_limit(const BytePicture& made, std::size_t row) const {
    const std::optional<std::size_t> limit = search_->row_of(search_->cause(row).limit);
    if (!limit) return false;
    const auto picture = render_candidate(renderer_, search_->candidate(*limit), renderer_.scene(),
                                          {grid_.width, grid_.height, 1});
    return picture && pixels_beyond_rounding(picture->bytes, made) <=
                          k_limit_pixels * pixels_beyond_rounding(rendered_->bytes, made);
}

// A term that is missing, and a factor that leaves hardly anything of it, look the same but for a few pixels.
// If a factor gives these, the term is not missing. If there are none, the factor from which on the pictures
// are the same is a cause, too.
std::optional<CauseCandidate> SceneTrials::judge_limit(const Search& whole, const RenderedScene& made,
                                                       CauseCandidate& candidate) const {
    if (!candidate.is_exact) return std::nullopt;
    std::size_t row = 0;
    while (row < search_->size() && search_->cause(row).limit.empty()) ++row;
    if (row == search_->size() || search_->cause(row).name == candidate.cause.name ||
        !is_limit(made.bytes, row))
        return std::nullopt;
    const auto wrong = [&](const RenderedScene& scene) {
        return wrong_pixels(scene.bytes, {scene.image, renderer_.rule(renderer_.scene().shading)},
                            *whole.target, whole.area);
    };
    const std::size_t off = beyond_rounding(made.bytes, *whole.target), wrong_of_it = wrong(made);
    for (double factor = k_least_limit; factor <= k_most_limit && !is_cancelled(); factor *= k_limit_step) {
        CauseCandidate rival = search_->scaled_candidate(row, factor, true);
        const auto with =
            render_candidate(renderer_, rival, renderer_.scene(), {grid_.width, grid_.height, 1});
        if (!with) return std::nullopt;
        const std::size_t wrong_of_rival = wrong(*with);
        if (beyond_rounding(with->bytes, *whole.target) < off || wrong_of_rival + 1 < wrong_of_it) {
            candidate.is_exact = false;
            return std::nullopt;
        }
        if (wrong_of_rival > wrong_of_it + 1 || beyond_rounding(with->bytes, made.bytes) > 0) continue;
        rival.cause.explanation = search_->cause(row).limit_text(factor);
        rival.left = candidate.left;
        rival.wrong = candidate.wrong;
        rival.is_confirmed = rival.is_exact = true;
        return rival;
    }
    return std::nullopt;
}

std::optional<CausePair> SceneTrials::find_pair(Search& search, PairKind kind) {
    if (!search_ || !search.has_content) return std::nullopt;
    if (!pairs_) pairs_ = std::make_unique<PairSearch>(renderer_, reference_, edges_);
    return kind == PairKind::with_shift ? pairs_->find_shifted(search) : pairs_->find(search);
}

std::string SceneTrials::where_text(const Search& search) {
    if (!renderer_.with_shapes() || !search_) return {};
    const auto shares = shares_of_shapes(shapes_of_pixels(renderer_, grid_), on_grid(*search.target, grid_),
                                         search_->rendered()->bytes);
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < std::min(shares.size(), k_named_shapes); ++i) {
        if (shares[i].share < k_said_share) break;
        const std::string name = shares[i].shape == k_none
                                     ? "the background"
                                     : shape_text(*renderer_.with_shapes(), shares[i].shape);
        parts.push_back(fmt::format("{} ({:.0f}%)", name, 100 * shares[i].share));
    }
    return parts.empty() ? "" : fmt::format("Of the difference, most is on {}.", fmt::join(parts, ", "));
}

}  // namespace glint
