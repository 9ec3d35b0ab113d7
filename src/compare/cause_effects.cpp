// SPDX-License-Identifier: Apache-2.0
#include "compare/cause_effects.h"

#include <algorithm>

#include "base/sort_stably.h"
#include "compare/cause_pair.h"
#include "compare/parameter_fit.h"

namespace glint {
namespace {

// What a number of the scene, or a part of its light, is multiplied by, as starts of a fit. The change of a
// part with the first of them stands for those with all.
constexpr double k_factors[] = {0.5, 0.25, 0.7, 1.5, 2, 4};

// What one effect adds to the light, in the pixels that count, with the sums of a fit.
struct Change {
    const CauseEffect* effect = nullptr;
    std::vector<float> part;
    double square = 0, wanted = 0;  // of the part, and of the part and what is wanted
};

// The factor of a part of the light of which `by` times the change is the change.
double factor_by(double by) { return 1 + by * (k_factors[0] - 1); }

// The multiples of two changes whose sum is nearest to what is wanted, of which the squares are `whole`. A
// change that is no multiple of a part stays as it is.
LikelyPair nearest_sum(const Change& a, const Change& b, double whole) {
    const double ab = product(a.part, b.part);
    LikelyPair sum{a.effect, b.effect};
    const bool free_a = a.effect->is_multiple, free_b = b.effect->is_multiple;
    if (free_a && free_b) {
        const double det = a.square * b.square - ab * ab;
        if (det > 1e-9 * a.square * b.square) {
            sum.by_a = (a.wanted * b.square - b.wanted * ab) / det;
            sum.by_b = (b.wanted * a.square - a.wanted * ab) / det;
        }
    } else if (free_a) {
        sum.by_a = (a.wanted - ab) / a.square;
    } else if (free_b) {
        sum.by_b = (b.wanted - ab) / b.square;
    }
    sum.left = whole + sum.by_a * sum.by_a * a.square + sum.by_b * sum.by_b * b.square +
               2 * (sum.by_a * sum.by_b * ab - sum.by_a * a.wanted - sum.by_b * b.wanted);
    return sum;
}

}  // namespace

std::vector<CauseEffect> effects_of(const SceneRenderer& renderer, const SceneSearch& causes,
                                    const PixelGrid& grid) {
    std::vector<CauseEffect> effects;
    const auto add = [&](CauseCandidate candidate, bool is_multiple) {
        auto made = render_candidate(renderer, candidate, renderer.scene(), grid);
        if (!made || made->bytes.rgb == causes.rendered()->bytes.rgb) return;
        effects.push_back({std::move(candidate), *std::move(made), is_multiple});
    };
    for (std::size_t i = 0; i < causes.size() && !renderer.is_cancelled(); ++i) {
        const SceneCause& cause = causes.cause(i);
        for (const double factor : k_factors) {
            if (cause.scale || !cause.part.empty())
                add(causes.scaled_candidate(i, factor, true), !cause.scale);
        }
        if (!cause.scale && !(cause.is_of_samples && grid.step > 1)) add(causes.candidate(i), false);
    }
    return effects;
}

CauseCandidate candidate_of(const CauseEffect& effect, double by, const SceneSearch& causes) {
    if (!effect.is_multiple) return effect.candidate;
    return causes.scaled_candidate(effect.candidate.row, std::max(factor_by(by), k_min_multiple), true);
}

std::vector<LikelyPair> likely_pairs(const std::vector<const CauseEffect*>& effects, const Image& plain,
                                     const BytePicture& target) {
    const auto light = [](const Image& image, std::size_t k) { return std::max(image.rgb[k], 0.0f); };
    std::vector<std::size_t> places;  // not clamped to 1
    std::vector<float> wanted;
    for (std::size_t k = 0; k < target.rgb.size(); ++k) {
        if (target.rgb[k] == 255) continue;
        places.push_back(k);
        wanted.push_back(static_cast<float>(target.rgb[k]) / 255 - light(plain, k));
    }
    const double whole = product(wanted, wanted);
    std::vector<Change> changes;
    for (const CauseEffect* effect : effects) {
        if (effect->is_multiple && effect->candidate.values[0] != k_factors[0]) continue;
        Change change{effect, {}};
        for (const std::size_t k : places)
            change.part.push_back(light(effect->rendered.image, k) - light(plain, k));
        change.square = product(change.part, change.part);
        change.wanted = product(change.part, wanted);
        if (change.square > 0) changes.push_back(std::move(change));
    }
    std::vector<LikelyPair> pairs;
    for (std::size_t i = 0; i < changes.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const CauseCandidate &a = changes[i].effect->candidate, &b = changes[j].effect->candidate;
            if (a.cause.name == b.cause.name || (!a.edit && !b.edit)) continue;
            pairs.push_back(nearest_sum(changes[i], changes[j], whole));
        }
    }
    sort_stably(pairs, [](const LikelyPair& a, const LikelyPair& b) { return a.left < b.left; });
    return pairs;
}

}  // namespace glint
