// SPDX-License-Identifier: Apache-2.0
#include "compare/missing_shapes.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/item_texts.h"

namespace glint {
namespace {

constexpr std::size_t k_max_missing = 6;  // shapes that are tried
constexpr double k_missing_share = 0.05;  // of the difference, at least
constexpr double k_least_missing = 0.85;  // explained: the shape is chosen by the difference

CauseCandidate without(std::vector<std::uint32_t> shapes, std::string explanation) {
    CauseCandidate candidate{{k_shape_missing, std::move(explanation), 0, 0, true}, k_least_missing};
    candidate.set_edit([shapes = std::move(shapes)](FaultyScene& s) {
        s.missing.insert(s.missing.end(), shapes.begin(), shapes.end());
    });
    return candidate;
}

}  // namespace

std::vector<CauseCandidate> missing_shapes(const SceneRenderer& renderer,
                                           const std::vector<ShapeShare>& shares) {
    std::vector<CauseCandidate> candidates;
    if (!renderer.with_shapes()) return candidates;
    const Scene& scene = *renderer.with_shapes();
    std::vector<ShapeKind> kinds;
    for (std::size_t i = 0; i < std::min(shares.size(), k_max_missing); ++i) {
        const auto& [shape, share] = shares[i];
        if (shape == k_none || share < k_missing_share) continue;
        candidates.push_back(
            without({shape}, fmt::format("{} is missing: add it to the list of shapes, and test every shape "
                                         "of the list with every ray.",
                                         capitalized(shape_text(scene, shape)))));
        const ShapeKind kind = scene.shapes[shape].kind;
        if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) continue;
        kinds.push_back(kind);
        std::vector<std::uint32_t> all;
        for (std::uint32_t k = 0; k < scene.shapes.size(); ++k) {
            if (scene.shapes[k].kind == kind) all.push_back(k);
        }
        if (all.size() > 1)
            candidates.push_back(without(
                std::move(all), fmt::format("All shapes of the kind \"{}\" are missing: test them, too, with "
                                            "every ray.",
                                            to_string(kind))));
    }
    return candidates;
}

void try_missing_shapes(const SceneRenderer& renderer, const std::vector<ShapeShare>& shares,
                        const std::function<std::optional<RenderedScene>(const FaultyScene&)>& render,
                        Search& search) {
    for (CauseCandidate& candidate : missing_shapes(renderer, shares)) {
        if (renderer.is_cancelled()) return;
        FaultyScene scene = renderer.scene();
        candidate.edit(scene);
        if (const auto made = render(scene)) search.judge(made->bytes, std::move(candidate));
    }
}

}  // namespace glint
