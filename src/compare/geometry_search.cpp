// SPDX-License-Identifier: Apache-2.0
#include "compare/geometry_search.h"

#include <algorithm>

#include "compare/parameter_fit.h"

namespace glint {
namespace {

// Numbers are fitted if a small change of them removes this fraction of the squared difference.
constexpr double k_promise = 0.1;
constexpr double k_found = 0.02;  // nothing more is fitted once so little of the difference remains

}  // namespace

void fit_geometry(const std::vector<FittedCause>& causes, const PixelGrid& grid, const FaultyScene& base,
                  const RenderScenePicture& render, std::size_t most, Search& search) {
    const std::optional<RenderedScene> at_start = render(base);
    if (!at_start) return;
    const ParameterFit fitter(grid, *search.target);
    const auto problem_of = [&](const FittedCause& cause) {
        return FitProblem{std::vector<double>(cause.units.size()), cause.units,
                          [&](std::span<const double> values) -> std::optional<std::vector<float>> {
                              FaultyScene scene = base;
                              cause.put(scene, values);
                              std::optional<RenderedScene> made = render(scene);
                              if (!made) return std::nullopt;
                              return std::move(made->image.rgb);
                          }};
    };
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < causes.size(); ++i) {
        const double promise = fitter.promise(problem_of(causes[i]), at_start->image.rgb);
        if (promise >= k_promise) order.emplace_back(-promise, i);
    }
    std::sort(order.begin(), order.end());
    order.resize(std::min(order.size(), most));
    for (const auto& [promise, i] : order) {
        const std::optional<Fit> fit = fitter.fit(problem_of(causes[i]), FitStart::far);
        if (!fit) continue;
        CauseCandidate candidate =
            fitted_candidate(std::make_shared<FittedCause>(causes[i]), fit->values, false, causes[i].least);
        FaultyScene faulty = base;
        candidate.edit(faulty);
        const std::optional<RenderedScene> made = render(faulty);
        if (!made) continue;
        search.judge(made->bytes, std::move(candidate));
        if (search.found.back().left.all <= k_found * search.whole.all) return;
    }
}

}  // namespace glint
