// SPDX-License-Identifier: Apache-2.0
#include "compare/scene_search.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/factor_search.h"
#include "compare/picture_faults.h"
#include "compare/render_scene.h"

namespace glint {
namespace {

// What is fitted to the picture has to explain more.
constexpr double k_min_fitted = 0.85, k_min_factor = 0.5;
// A factor is looked for from 1 to these, and no further where no more than this part of the difference
// stays.
constexpr double k_max_factor = 16, k_enough = 0.001;

std::string capital(std::string text) {
    if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

// Shapes without a material get one of the scene's, so that faults of materials reach them.
void name_default_material(Scene& scene) {
    const auto index = static_cast<std::uint32_t>(scene.materials.size());
    bool used = false;
    for (Shape& shape : scene.shapes) {
        if (shape.material != k_none) continue;
        shape.material = index;
        used = true;
    }
    if (used) scene.materials.emplace_back();
}

void drop_shapes(Scene& scene) {
    scene.shapes = {};
    scene.transforms = {};
    scene.polygon_vertices = {};
    scene.parameters = {};
    scene.shape_texts = {};
}

}  // namespace

SceneSearch::SceneSearch(const Scene& scene, std::int32_t width, std::int32_t height,
                         const CauseOptions& options)
    : scene_(scene), options_(options) {
    scene_.settings.width = width;
    scene_.settings.height = height;
    name_default_material(scene_);
    world_ = prepare(scene_, {.threads = options_.threads});
    if (!world_) return;
    causes_ = scene_causes(scene_);
    drop_shapes(scene_);
    rendered_ = render(scene_);
    if (!rendered_) causes_.clear();
}

bool SceneSearch::is_cancelled() const {
    return options_.cancel != nullptr && options_.cancel->load(std::memory_order_relaxed);
}

std::optional<RenderedScene> SceneSearch::render(const Scene& shading) const {
    Result<Rendering> result = render_scene(*world_, shading, options_.threads, options_.cancel);
    if (!result) return std::nullopt;
    RenderedScene rendered{std::move(result->image), {}};
    rendered.bytes = to_bytes(rendered.image, options_.threads);
    return rendered;
}

void SceneSearch::try_cause(std::size_t i, std::vector<Search>& searches) const {
    const SceneCause& cause = causes_[i];
    if (cause.scale) return try_factors(searches, cause);
    Scene scene = scene_;
    cause.put(scene);
    const std::optional<RenderedScene> made = render(scene);
    // What changes nothing in this scene explains nothing.
    if (!made || made->bytes.rgb == rendered_->bytes.rgb) return;
    for (Search& search : searches) {
        if (search.is_open()) search.judge(made->bytes, {{cause.name, cause.explanation, 0, 0, true}});
    }
    if (!cause.part.empty()) try_multiples(searches, cause, *made);
}

// How the search for one picture's factor goes.
struct SceneSearch::Walk {
    Distance at_one;   // what stays with the factor 1
    TriedFactor best;  // so far
    bool leads = false, goes_on = false;
};

std::optional<RenderedScene> SceneSearch::render_scaled(const SceneCause& cause, double factor) const {
    Scene scene = scene_;
    if (cause.put) cause.put(scene);
    cause.scale(scene, factor);
    return render(scene);
}

// A number of the scene by a factor that is fitted: from 1 by powers of two as long as it gets better,
// then to the bottom of the valley.
void SceneSearch::try_factors(std::vector<Search>& searches, const SceneCause& cause) const {
    const std::optional<RenderedScene> one = render_scaled(cause, 1);
    if (!one) return;
    std::vector<Walk> walks(searches.size());
    for (std::size_t i = 0; i < searches.size(); ++i) {
        if (!searches[i].is_open()) continue;
        walks[i].at_one = distance(one->bytes, *searches[i].target, searches[i].area);
        walks[i].best = {1, walks[i].at_one.all};
    }
    for (const double step : {2.0, 0.5}) walk(searches, cause, one->bytes, step, walks);
    for (std::size_t i = 0; i < searches.size() && !is_cancelled(); ++i) {
        Search& search = searches[i];
        const double enough = k_enough * search.whole.all;
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
        search.judge(
            made->bytes,
            {{cause.name, cause.scale_text(best.factor, best.left > enough), 0, 0, true}, k_min_factor});
    }
}

// A picture lies on the way from `one` to a factor as far as going there is no detour.
void SceneSearch::walk(std::vector<Search>& searches, const SceneCause& cause, const BytePicture& one,
                       double step, std::vector<Walk>& walks) const {
    for (std::size_t i = 0; i < searches.size(); ++i) walks[i].goes_on = searches[i].is_open();
    const auto goes_on = [](const Walk& w) { return w.goes_on; };
    for (double factor = step; factor <= k_max_factor && factor * k_max_factor >= 1; factor *= step) {
        if (std::none_of(walks.begin(), walks.end(), goes_on) || is_cancelled()) return;
        const std::optional<RenderedScene> made = render_scaled(cause, factor);
        if (!made || made->bytes.rgb == one.rgb) return;
        for (std::size_t i = 0; i < searches.size(); ++i) {
            Walk& w = walks[i];
            if (!w.goes_on) continue;
            const Distance moved = distance(made->bytes, one, searches[i].area),
                           left = distance(made->bytes, *searches[i].target, searches[i].area);
            const auto is_on_the_way = [](double from_one, double way, double rest) {
                return (from_one + way - rest) / 2 > k_min_explained * from_one;
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
void SceneSearch::try_multiples(std::vector<Search>& searches, const SceneCause& cause,
                                const RenderedScene& without) const {
    std::vector<float> part = rendered_->image.rgb;
    for (std::size_t i = 0; i < part.size(); ++i) part[i] -= without.image.rgb[i];
    for (Search& search : searches) {
        if (!search.is_open()) continue;
        const auto factor =
            fit_factor(without.image.rgb, part, rendered_->bytes, *search.target, search.sample.rows);
        if (!factor) continue;
        Image image = without.image;
        for (std::size_t i = 0; i < part.size(); ++i) image.rgb[i] += static_cast<float>(*factor) * part[i];
        search.judge(
            to_bytes(image, options_.threads),
            {{cause.scaled,
              fmt::format("{} is {:.3g} times what it should be.", capital(cause.part), *factor), 0, 0, true},
             k_min_fitted});
    }
}

}  // namespace glint
