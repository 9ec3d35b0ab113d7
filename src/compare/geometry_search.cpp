// SPDX-License-Identifier: Apache-2.0
#include "compare/geometry_search.h"

#include <algorithm>
#include <cmath>

#include "compare/parameter_fit.h"

namespace glint {
namespace {

// Numbers are fitted if a small change of them removes this fraction of the squared difference.
constexpr double k_promise = 0.1;
constexpr double k_found = 0.02;  // nothing more is fitted once so little of the difference remains

// Fits numbers of `base` to one picture.
class GeometryFit {
  public:
    GeometryFit(const PixelGrid& grid, const FaultyScene& base, const RenderScenePicture& render,
                Search& search)
        : base_(base), render_(render), search_(search), fitter_(grid, *search.target) {}

    // ParameterFit::promise. at_base: without the cause.
    double promise(const FittedCause& cause, const RenderedScene& at_base) const {
        if (!cause.starts_far) return fitter_.promise(problem_of(cause), at_base.image.rgb);
        const std::optional<RenderedScene> at_start = render_with(cause, cause.start);
        if (!at_start) return 0;
        // Of the difference without the cause: the start may remove it, too, or be far from the picture.
        const double left =
            fitter_.blurred_square(at_start->image.rgb) / fitter_.blurred_square(at_base.image.rgb);
        return left < 1 ? 1 - left * (1 - fitter_.promise(problem_of(cause), at_start->image.rgb)) : 0;
    }

    // Fits and judges a cause.
    std::optional<Fit> fit(const FittedCause& cause, FitStart start) {
        const std::optional<Fit> fit = fitter_.fit(problem_of(cause), start);
        return fit && judge(cause, fit->values) ? fit : std::nullopt;
    }

    // The form that leaves least at its start.
    std::optional<FittedCause> nearest(std::vector<FittedCause> forms) const {
        std::optional<FittedCause> best;
        double least = HUGE_VAL;
        for (FittedCause& form : forms) {
            const std::optional<RenderedScene> made = render_with(form, start_of(form));
            if (!made) return std::nullopt;
            const double left = distance(made->bytes, *search_.target, search_.area).all;
            if (left >= least) continue;
            least = left;
            best = std::move(form);
        }
        return best;
    }

    // What changes this picture by no more than rounding is no cause.
    void keep_from(const BytePicture& picture) { at_base_ = &picture; }

    // Whether the last one that was judged explains nearly all.
    bool is_found() const { return left() <= k_found * search_.whole.all; }

  private:
    double left() const { return search_.found.empty() ? HUGE_VAL : search_.found.back().left.all; }

    static std::vector<double> start_of(const FittedCause& cause) {
        return cause.start.empty() ? std::vector<double>(cause.units.size()) : cause.start;
    }

    std::optional<RenderedScene> render_with(const FittedCause& cause, std::span<const double> values) const {
        FaultyScene scene = base_;
        cause.put(scene, values);
        return render_(scene);
    }

    FitProblem problem_of(const FittedCause& cause) const {
        return {start_of(cause), cause.units,
                [&](std::span<const double> values) -> std::optional<std::vector<float>> {
                    std::optional<RenderedScene> made = render_with(cause, values);
                    if (!made) return std::nullopt;
                    return std::move(made->image.rgb);
                }};
    }

    bool judge(const FittedCause& cause, const std::vector<double>& values) {
        const std::optional<RenderedScene> made = render_with(cause, values);
        if (!made || (at_base_ != nullptr && beyond_rounding(made->bytes, *at_base_) == 0)) return false;
        search_.judge(made->bytes,
                      fitted_candidate(std::make_shared<FittedCause>(cause), values, false, cause.least));
        return true;
    }

    const FaultyScene& base_;
    const RenderScenePicture& render_;
    Search& search_;
    const ParameterFit fitter_;
    const BytePicture* at_base_ = nullptr;
};

}  // namespace

void fit_geometry(const std::vector<FittedCause>& causes, const PixelGrid& grid, const FaultyScene& base,
                  const RenderScenePicture& render, std::size_t most, Search& search) {
    const std::optional<RenderedScene> at_start = render(base);
    if (!at_start) return;
    GeometryFit fit(grid, base, render, search);
    fit.keep_from(at_start->bytes);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < causes.size(); ++i) {
        const double promise = fit.promise(causes[i], *at_start);
        if (promise >= k_promise) order.emplace_back(-promise, i);
    }
    std::sort(order.begin(), order.end());
    order.resize(std::min(order.size(), most));
    for (const auto& [promise, i] : order) {
        if (fit.fit(causes[i], FitStart::far) && fit.is_found()) return;
    }
}

void fit_forms(const FittedCause& cause, std::span<const double> values, const PixelGrid& grid,
               const FaultyScene& base, const RenderScenePicture& render, Search& search) {
    GeometryFit fit(grid, base, render, search);
    FittedCause last = cause;
    std::vector<double> at(values.begin(), values.end());
    while (last.refined) {
        std::optional<FittedCause> next = fit.nearest(last.refined(at));
        if (!next) return;
        const std::optional<Fit> fitted = fit.fit(*next, FitStart::near);
        if (!fitted || fit.is_found()) return;
        last = *std::move(next);
        at = fitted->values;
    }
}

}  // namespace glint
