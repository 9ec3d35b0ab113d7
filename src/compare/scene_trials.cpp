// SPDX-License-Identifier: Apache-2.0
#include "compare/scene_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "compare/picture_causes.h"

namespace glint {
namespace {

// What is looked at on all pixels.
constexpr std::size_t k_confirmed = 6, k_fitted = 4, k_firsts = 5, k_confirmed_pairs = 4;
// A search on the grid is over with what leaves so little of the difference.
constexpr double k_found = 0.02;
// Numbers are fitted where a small change of them makes this part of the squared difference go away.
constexpr double k_promise = 0.1;
constexpr double k_min_fit = 0.85;  // to be named, a fit of several numbers explains this
// A pair that is not exact has to leave at most this part of what the better one of it leaves.
constexpr double k_pair_gain = 0.4, k_pair_explains = 0.9;
// Where the grid has not about as much of the difference as all pixels, by this factor, all are looked at.
constexpr double k_fair_grid = 2.5;
constexpr std::size_t k_named_shapes = 3;
constexpr double k_said_share = 0.1;

// The best of each name, by what they leave.
std::vector<CauseCandidate> best_of(const Search& search, std::size_t most) {
    std::vector<CauseCandidate> list = search.found;
    std::stable_sort(list.begin(), list.end(), [&](const CauseCandidate& a, const CauseCandidate& b) {
        return rated(a, a.left.all, search.whole.all) < rated(b, b.left.all, search.whole.all);
    });
    std::set<std::string> names;
    std::erase_if(list, [&](const CauseCandidate& c) { return !names.insert(c.cause.name).second; });
    list.resize(std::min(list.size(), most));
    return list;
}

}  // namespace

SceneTrials::SceneTrials(const Scene& scene, const BytePicture& reference,
                         const std::vector<std::uint8_t>& edges, const CauseOptions& options)
    : reference_(reference),
      edges_(edges),
      renderer_(scene, reference.width, reference.height, options),
      grid_(grid_of(scene, reference.width, reference.height)) {
    if (!renderer_.is_prepared()) return;
    rendered_ = renderer_.render(renderer_.scene(), {reference.width, reference.height, 1});
    if (!rendered_) return;
    grid_edges_ = on_grid(edges_, grid_);
    search_ = std::make_unique<SceneSearch>(renderer_, grid_, renderer_.scene());
    if (!search_->rendered()) search_.reset();
}

SceneTrials::GridSearch SceneTrials::grid_search(Search& whole, const PixelGrid& grid) const {
    GridSearch small;
    small.whole = &whole;
    Search& s = small.search;
    s.faulty = on_grid(*whole.target, grid);
    s.area = {grid.step == 1 ? &edges_ : &grid_edges_, all_rows(grid.rows()), whole.area.rim, 1};
    s.sample = s.area;
    s.report.difference = 1;
    s.has_content = whole.has_content;
    const BytePicture a = on_grid(whole.faulty, grid), b = on_grid(reference_, grid);
    s.whole = distance(a, b, s.area);
    return small;
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
        if (is_fair || grid_.step == 1)
            fair.push_back(std::move(small));
        else
            others.push_back(grid_search(search, all));
    }
    if (!fair.empty()) run_on(grid_, fair, step);
    if (!others.empty())
        run_on({grid_.width, grid_.height, 1}, others, fair.empty() ? step : std::function<void()>([] {}));
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
        search.try_cause(i, list);
        step();
    }
    for (GridSearch& s : searches) {
        if (is_cancelled()) return;
        const bool is_found =
            std::any_of(s.search.found.begin(), s.search.found.end(),
                        [&](const CauseCandidate& c) { return c.left.all <= k_found * s.search.whole.all; });
        const bool is_seen =
            std::any_of(s.whole->found.begin(), s.whole->found.end(), [&](const CauseCandidate& c) {
                return c.freedom == 0 && c.left.all <= k_found * s.whole->whole.all;
            });
        if (!is_found && !is_seen && s.whole->has_content) fit_geometry(grid, *search.rendered(), s);
        confirm(s);
    }
}

void SceneTrials::fit_geometry(const PixelGrid& grid, const RenderedScene& drawn, GridSearch& search) {
    Search& s = search.search;
    const auto shapes = shapes_of_pixels(renderer_, grid);
    const auto causes = geometry_causes(renderer_, shares_of_shapes(shapes, drawn.bytes, s.faulty));
    const ParameterFit fitter(renderer_, grid, renderer_.scene(), drawn, s.faulty);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < causes.size() && !is_cancelled(); ++i) {
        const double promise = fitter.promise(causes[i]);
        if (promise >= k_promise) order.emplace_back(-promise, i);
    }
    std::sort(order.begin(), order.end());
    order.resize(std::min(order.size(), k_fitted));
    for (const auto& [promise, i] : order) {
        if (is_cancelled()) return;
        const FittedCause& cause = causes[i];
        const std::optional<Fit> fit = fitter.fit(cause);
        if (!fit) continue;
        CauseCandidate candidate{{cause.name, cause.text(fit->values), 0, 0, true}, k_min_fit};
        candidate.parameters = static_cast<int>(cause.units.size());
        candidate.set_edit([put = cause.put, values = fit->values](FaultyScene& f) { put(f, values); });
        FaultyScene faulty = renderer_.scene();
        candidate.edit(faulty);
        if (const auto made = renderer_.render(faulty, grid)) s.judge(made->bytes, std::move(candidate));
        if (!s.found.empty() && s.found.back().left.all <= k_found * s.whole.all) return;
    }
}

std::optional<Image> SceneTrials::draw_image(const CauseCandidate& candidate, const FaultyScene& base) const {
    const PixelGrid all{grid_.width, grid_.height, 1};
    return candidate.make(base, [&](const FaultyScene& scene) -> std::optional<Image> {
        std::optional<RenderedScene> drawn = renderer_.render(scene, all);
        if (!drawn) return std::nullopt;
        return std::move(drawn->image);
    });
}

std::optional<BytePicture> SceneTrials::draw_whole(const CauseCandidate& candidate,
                                                   const FaultyScene& base) const {
    const std::optional<Image> image = draw_image(candidate, base);
    if (!image) return std::nullopt;
    return to_bytes(*image, renderer_.threads());
}

void SceneTrials::confirm(GridSearch& small) const {
    Search& whole = *small.whole;
    const int tried = whole.report.tried + small.search.report.tried;
    for (CauseCandidate& candidate : best_of(small.search, k_confirmed)) {
        if (is_cancelled()) return;
        const std::optional<BytePicture> made = draw_whole(candidate, renderer_.scene());
        if (!made) continue;
        whole.confirm(*made, candidate);
        whole.add(*made, std::move(candidate));
    }
    whole.report.tried = tried;
}

// ---- Two causes at once ----

void SceneTrials::pairs_of_scene(const CauseCandidate& first, GridSearch& small,
                                 std::vector<Pair>& pairs) const {
    FaultyScene base = renderer_.scene();
    first.edit(base);
    const SceneSearch search(renderer_, grid_, base);
    if (!search.rendered()) return;
    Search second = small.search;
    second.target = &second.faulty;
    second.found.clear();
    for (std::size_t i = 0; i < search.size() && !is_cancelled(); ++i) search.try_cause(i, {&second});
    for (CauseCandidate& c : best_of(second, 2)) {
        if (c.cause.name == first.cause.name) continue;
        const double rating = rated(c, rated(first, c.left.all, second.whole.all), second.whole.all);
        pairs.push_back({first, std::move(c), rating});
    }
}

// A fault of the picture after one of the scene.
void SceneTrials::pairs_of_pictures(const CauseCandidate& first, GridSearch& small,
                                    std::vector<Pair>& pairs) {
    const PictureCause& cause = picture_causes()[*first.of_pictures];
    const Search& s = small.search;
    BytePicture made = s.faulty;
    Search second = s;
    second.found.clear();
    if (cause.is_own_inverse) {  // then the scene makes the picture that this is the flip of
        const Image image{made.width, made.height, std::vector<float>(made.rgb.size())};
        if (!cause.make({image, s.faulty, s.faulty, s.area, s.area.rows, true}, made)) return;
        second.faulty = made;
        second.target = &second.faulty;
        for (std::size_t i = 0; i < search_->size() && !is_cancelled(); ++i) search_->try_cause(i, {&second});
        for (CauseCandidate& c : best_of(second, 2))
            pairs.push_back({first, c, rated(c, c.left.all, second.whole.all)});
        return;
    }
    if (drawn_causes_.empty()) {
        for (std::size_t i = 0; i < search_->size() && !is_cancelled(); ++i)
            drawn_causes_.push_back(search_->draw_cause(i));
    }
    for (std::size_t i = 0; i < drawn_causes_.size() && !is_cancelled(); ++i) {
        if (!drawn_causes_[i] || drawn_causes_[i]->bytes.rgb == search_->rendered()->bytes.rgb) continue;
        const PictureSource from{
            drawn_causes_[i]->image, drawn_causes_[i]->bytes, s.faulty, s.area, s.area.rows, true};
        if (!cause.make(from, made)) continue;
        CauseCandidate candidate = search_->candidate(i);
        candidate.left = distance(made, s.faulty, s.area);
        second.found.push_back(std::move(candidate));
    }
    for (CauseCandidate& c : best_of(second, 2)) pairs.push_back({first, c, c.left.all});
}

std::optional<BytePicture> SceneTrials::draw_pair(const Pair& pair, const Search& search) const {
    FaultyScene base = renderer_.scene();
    if (pair.first.edit) {
        pair.first.edit(base);
        return draw_whole(pair.second, base);
    }
    const std::optional<Image> image = draw_image(pair.second, base);
    if (!image) return std::nullopt;
    const BytePicture bytes = to_bytes(*image, renderer_.threads());
    BytePicture made = bytes;
    const PictureSource from{*image, bytes, *search.target, search.area, search.area.rows, true};
    if (!picture_causes()[*pair.first.of_pictures].make(from, made)) return std::nullopt;
    return made;
}

bool SceneTrials::find_pair(Search& search, CauseCandidate& first, CauseCandidate& second) {
    if (!search_ || !search.has_content) return false;
    GridSearch small = grid_search(search, grid_);
    small.search.target = &small.search.faulty;
    std::vector<Pair> pairs;
    std::size_t firsts = 0;
    for (const CauseCandidate& candidate : best_of(search, search.found.size())) {
        const bool is_of_picture = candidate.of_pictures && candidate.freedom == 0;
        if ((!candidate.edit && !is_of_picture) || is_cancelled()) continue;
        const bool is_turn = search.turn && candidate.cause.explanation == search.turn->explanation;
        if (!is_turn && firsts >= k_firsts) continue;
        firsts += !is_turn;
        if (is_of_picture)
            pairs_of_pictures(candidate, small, pairs);
        else
            pairs_of_scene(candidate, small, pairs);
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.rating < b.rating; });
    pairs.resize(std::min(pairs.size(), k_confirmed_pairs));
    const Pair* best = nullptr;
    for (Pair& pair : pairs) {
        const std::optional<BytePicture> made = draw_pair(pair, search);
        if (!made) continue;
        search.confirm(*made, pair.second);
        const bool is_better = best == nullptr || (pair.second.is_exact && !best->second.is_exact) ||
                               (pair.second.is_exact == best->second.is_exact &&
                                pair.second.left.all < best->second.left.all - k_found * search.whole.all);
        if (is_better) best = &pair;
    }
    if (best == nullptr) return false;
    const double left = best->second.left.all, whole = search.whole.all;
    if (!best->second.is_exact &&
        (left > k_pair_gain * best->first.left.all || left > (1 - k_pair_explains) * whole))
        return false;
    first = best->first;
    second = best->second;
    first.is_exact = second.is_exact;
    return true;
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
