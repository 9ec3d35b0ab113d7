// SPDX-License-Identifier: Apache-2.0
#include "compare/missing_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "compare/item_texts.h"

namespace glint {
namespace {

constexpr std::size_t k_max_missing = 6;  // shapes that are tried
constexpr double k_missing_share = 0.05;  // of the difference, at least
constexpr double k_least_missing = 0.85;  // explained: the shape is chosen by the difference
constexpr double k_seen_share = 0.5;      // of the pixels of a shape, which change where it is left out
constexpr int k_seen_bytes = 2;           // what changes by more is seen

struct MissingShapes {
    std::vector<std::uint32_t> shapes;
    std::string explanation;
};

CauseCandidate without(const MissingShapes& missing) {
    CauseCandidate candidate{{k_shape_missing, missing.explanation, 0, 0, true}, k_least_missing};
    candidate.set_edit([shapes = missing.shapes](FaultyScene& s) {
        s.missing.insert(s.missing.end(), shapes.begin(), shapes.end());
    });
    return candidate;
}

std::vector<MissingShapes> missing_shapes(const Scene& scene, const std::vector<ShapeShare>& shares) {
    std::vector<MissingShapes> causes;
    std::vector<ShapeKind> kinds;
    for (std::size_t i = 0; i < std::min(shares.size(), k_max_missing); ++i) {
        const auto& [shape, share] = shares[i];
        if (shape == k_none || share < k_missing_share) continue;
        causes.push_back({{shape},
                          fmt::format("{} is missing: add it to the list of shapes, and test every shape "
                                      "of the list with every ray.",
                                      capitalized(shape_text(scene, shape)))});
        const ShapeKind kind = scene.shapes[shape].kind;
        if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) continue;
        kinds.push_back(kind);
        std::vector<std::uint32_t> all;
        for (std::uint32_t k = 0; k < scene.shapes.size(); ++k) {
            if (scene.shapes[k].kind == kind) all.push_back(k);
        }
        if (all.size() > 1)
            causes.push_back({std::move(all),
                              fmt::format("All shapes of the kind \"{}\" are missing: test them, too, with "
                                          "every ray.",
                                          to_string(kind))});
    }
    return causes;
}

bool are_seen(const std::vector<std::uint32_t>& shapes, const SeenShapes& seen, const BytePicture& without) {
    std::size_t pixels = 0, changed = 0;
    for (std::size_t i = 0; i < seen.of_pixels.size(); ++i) {
        if (std::find(shapes.begin(), shapes.end(), seen.of_pixels[i]) == shapes.end()) continue;
        ++pixels;
        int most = 0;
        for (std::size_t c = 3 * i; c < 3 * i + 3; ++c)
            most = std::max(most, std::abs(int{seen.rendered.rgb[c]} - int{without.rgb[c]}));
        changed += most > k_seen_bytes;
    }
    return static_cast<double>(changed) > k_seen_share * static_cast<double>(pixels);
}

}  // namespace

void try_missing_shapes(const SceneRenderer& renderer, const SeenShapes& seen,
                        const std::function<std::optional<RenderedScene>(const FaultyScene&)>& render,
                        Search& search) {
    if (!renderer.with_shapes()) return;
    for (const MissingShapes& missing : missing_shapes(*renderer.with_shapes(), seen.shares)) {
        if (renderer.is_cancelled()) return;
        CauseCandidate candidate = without(missing);
        FaultyScene scene = renderer.scene();
        candidate.edit(scene);
        const auto made = render(scene);
        if (made && are_seen(missing.shapes, seen, made->bytes))
            search.judge(made->bytes, std::move(candidate));
    }
}

}  // namespace glint
