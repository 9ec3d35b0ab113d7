// SPDX-License-Identifier: Apache-2.0
#include "compare/scene_search.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/factor_search.h"
#include "compare/item_texts.h"
#include "compare/picture_faults.h"

namespace glint {
namespace {

// What is fitted to the picture has to explain more.
constexpr double k_min_light_multiple = 0.85;
// A factor is looked for from 1 to these, and no further where no more than this part of the difference
// stays.
constexpr double k_max_factor = 16, k_exact_part = 0.001, k_min_way = 0.3;

FaultEdit edit_of(const SceneCause& cause) {
    return [put = cause.put, reshape = cause.reshape, fault = cause.fault](FaultyScene& s) {
        if (put) put(s.shading);
        if (reshape != nullptr) s.reshape.push_back(reshape);
        if (fault != TracerFault::none) s.fault = fault;
    };
}

// What one unit of a factor is, for a fit of it together with others.
constexpr double k_factor_unit = 0.05, k_min_scale = 0.01;

void put_scaled(const SceneCause& cause, Scene& scene, double factor) {
    if (cause.put) cause.put(scene);
    cause.scale(scene, std::max(factor, k_min_scale));
}

std::shared_ptr<const FittedCause> factor_of(const SceneCause& cause, double near) {
    FittedCause factor{
        cause.name,
        {k_factor_unit * near},
        [cause](FaultyScene& s, std::span<const double> v) { put_scaled(cause, s.shading, v[0]); },
        [text = cause.scale_text](std::span<const double> v, bool about) { return text(v[0], about); }};
    factor.is_factor = true;
    return std::make_shared<FittedCause>(std::move(factor));
}

std::shared_ptr<const FittedCause> multiple_of(const SceneCause& cause, double near) {
    FittedCause multiple{
        cause.scaled,
        {k_factor_unit * near},
        [scale = cause.scale_part](FaultyScene& s, std::span<const double> v) {
            scale(s.shading, std::max(v[0], 0.0));
        },
        [part = capitalized(cause.part), hint = cause.scale_hint](std::span<const double> v, bool) {
            return fmt::format("{} is {:.3g} times what it should be.{}", part, v[0], hint ? hint(v[0]) : "");
        }};
    multiple.fits_bytes = true;
    return std::make_shared<FittedCause>(std::move(multiple));
}

}  // namespace

std::optional<RenderedScene> render_candidate(const SceneRenderer& renderer, const CauseCandidate& candidate,
                                              const FaultyScene& base, const PixelGrid& grid) {
    if (candidate.edit) {
        FaultyScene scene = base;
        candidate.edit(scene);
        return renderer.render(scene, grid);
    }
    std::optional<Image> image = candidate.make(base, [&](const FaultyScene& s) {
        std::optional<RenderedScene> made = renderer.render(s, grid);
        return made ? std::optional(std::move(made->image)) : std::nullopt;
    });
    if (!image) return std::nullopt;
    RenderedScene rendered{std::move(*image), {}};
    rendered.bytes = to_bytes(rendered.image, renderer.threads(), renderer.rule(base.shading));
    return rendered;
}

SceneSearch::SceneSearch(const SceneRenderer& renderer, const PixelGrid& grid, const FaultyScene& scene)
    : renderer_(renderer), grid_(grid), scene_(scene) {
    rendered_ = renderer_.render(scene_, grid_);
    if (rendered_) causes_ = scene_causes(scene_.shading);
}

std::optional<RenderedScene> SceneSearch::render(const FaultEdit& edit) const {
    FaultyScene scene = scene_;
    edit(scene);
    return renderer_.render(scene, grid_);
}

std::optional<RenderedScene> SceneSearch::render_cause(std::size_t i) const {
    const SceneCause& cause = causes_[i];
    if (cause.scale || (cause.is_of_samples && grid_.step > 1)) return std::nullopt;
    return render_candidate(renderer_, candidate(i), scene_, grid_);
}

CauseCandidate SceneSearch::candidate(std::size_t i) const {
    const SceneCause& cause = causes_[i];
    CauseCandidate candidate{{cause.name, cause.explanation, 0, 0, true}, cause.least};
    candidate.row = i;
    if (!cause.compose) {
        candidate.set_edit(edit_of(cause));
        return candidate;
    }
    candidate.make = [compose = cause.compose](const FaultyScene& base, const RenderFaulty& render) {
        return compose(base.shading, [&](const Scene& scene) {
            FaultyScene changed = base;
            changed.shading = scene;
            return render(changed);
        });
    };
    return candidate;
}

CauseCandidate SceneSearch::scaled_candidate(std::size_t i, double factor, bool about) const {
    const SceneCause& cause = causes_[i];
    const double least = cause.scale ? k_min_explained : k_min_light_multiple;
    CauseCandidate candidate = fitted_candidate(
        cause.scale ? factor_of(cause, factor) : multiple_of(cause, factor), {factor}, about, least);
    candidate.row = i;
    return candidate;
}

std::optional<std::size_t> SceneSearch::row_of(const std::string& name) const {
    for (std::size_t i = 0; i < size(); ++i) {
        if (causes_[i].name == name) return i;
    }
    return std::nullopt;
}

std::optional<std::size_t> SceneSearch::cause_with_limit(const std::string& name) const {
    for (std::size_t i = 0; i < size(); ++i) {
        if (causes_[i].limit == name) return i;
    }
    return std::nullopt;
}

void SceneSearch::try_cause(std::size_t i, const std::vector<Search*>& searches) const {
    const SceneCause& cause = causes_[i];
    if (cause.scale) return try_factors(searches, i);
    const std::optional<RenderedScene> made = render_cause(i);
    // What changes nothing in this scene explains nothing.
    if (!made || made->bytes.rgb == rendered_->bytes.rgb) return;
    for (Search* search : searches) search->judge(made->bytes, candidate(i));
    if (!cause.part.empty()) try_multiples(searches, i, *made);
}

// How the search for one picture's factor goes.
struct SceneSearch::Walk {
    Distance at_one;   // what stays with the factor 1
    TriedFactor best;  // so far
    bool leads = false, goes_on = false;
};

std::optional<RenderedScene> SceneSearch::render_scaled(const SceneCause& cause, double factor) const {
    return render([&](FaultyScene& s) { put_scaled(cause, s.shading, factor); });
}

// A number of the scene by a factor that is fitted: from 1 by powers of two as long as it gets better,
// then to the bottom of the valley.
void SceneSearch::try_factors(const std::vector<Search*>& searches, std::size_t row) const {
    const SceneCause& cause = causes_[row];
    const std::optional<RenderedScene> one = render_scaled(cause, 1);
    if (!one) return;
    std::vector<Walk> walks(searches.size());
    for (std::size_t i = 0; i < searches.size(); ++i) {
        walks[i].at_one = distance(one->bytes, *searches[i]->target, searches[i]->area);
        walks[i].best = {1, walks[i].at_one.all};
    }
    for (const double step : {2.0, 0.5}) walk(searches, cause, one->bytes, step, walks);
    for (std::size_t i = 0; i < searches.size() && !renderer_.is_cancelled(); ++i) {
        Search& search = *searches[i];
        const double enough = k_exact_part * search.whole.all;
        const bool is_explained =
            std::any_of(search.found.begin(), search.found.end(),
                        [&](const CauseCandidate& c) { return c.freedom == 0 && c.left.all <= enough; });
        if (!walks[i].leads || is_explained) continue;
        TriedFactor best = walks[i].best;
        if (best.left > enough) {
            best = refine_factor(best, best.factor / 2, best.factor * 2, enough,
                                 [&](double factor) -> std::optional<double> {
                                     const auto made = render_scaled(cause, factor);
                                     if (!made) return std::nullopt;
                                     return distance(made->bytes, *search.target, search.area).all;
                                 });
        }
        const std::optional<RenderedScene> made = render_scaled(cause, best.factor);
        if (!made || made->bytes.rgb == one->bytes.rgb) continue;
        search.judge(made->bytes, scaled_candidate(row, best.factor, best.left > enough));
    }
}

// A picture lies on the way from `one` to a factor as far as going there is no detour.
void SceneSearch::walk(const std::vector<Search*>& searches, const SceneCause& cause, const BytePicture& one,
                       double step, std::vector<Walk>& walks) const {
    for (std::size_t i = 0; i < searches.size(); ++i) walks[i].goes_on = true;
    const auto goes_on = [](const Walk& w) { return w.goes_on; };
    for (double factor = step; factor <= k_max_factor && factor * k_max_factor >= 1; factor *= step) {
        if (std::none_of(walks.begin(), walks.end(), goes_on) || renderer_.is_cancelled()) return;
        const std::optional<RenderedScene> made = render_scaled(cause, factor);
        if (!made || made->bytes.rgb == one.rgb) return;
        for (std::size_t i = 0; i < searches.size(); ++i) {
            Walk& w = walks[i];
            if (!w.goes_on) continue;
            const Distance moved = distance(made->bytes, one, searches[i]->area),
                           left = distance(made->bytes, *searches[i]->target, searches[i]->area);
            const auto is_on_the_way = [](double from_one, double way, double rest) {
                return (from_one + way - rest) / 2 > k_min_way * from_one;
            };
            w.leads = w.leads || is_on_the_way(w.at_one.all, moved.all, left.all) ||
                      is_on_the_way(w.at_one.calm, moved.calm, left.calm);
            w.goes_on = left.all < w.best.left;
            if (w.goes_on) w.best = {factor, left.all};
        }
    }
}

// The part of the light that is missing in `without`, by a factor that is fitted. Light is a sum, so the
// picture with any multiple of a part is known from those with and without it.
void SceneSearch::try_multiples(const std::vector<Search*>& searches, std::size_t row,
                                const RenderedScene& without) const {
    std::vector<float> part = rendered_->image.rgb;
    for (std::size_t i = 0; i < part.size(); ++i) part[i] -= without.image.rgb[i];
    for (Search* search : searches) {
        const auto factor = fit_factor(without.image.rgb, {grid_.columns(), grid_.rows(), part},
                                       rendered_->bytes, *search->target, search->area.rows);
        if (!factor) continue;
        Image image = without.image;
        for (std::size_t i = 0; i < part.size(); ++i) image.rgb[i] += static_cast<float>(*factor) * part[i];
        const BytePicture made = to_bytes(image, 1, renderer_.rule(scene_.shading));
        // What cannot be seen is missing.
        if (beyond_rounding(made, without.bytes) > 0)
            search->judge(made, scaled_candidate(row, *factor, false));
    }
}

}  // namespace glint
