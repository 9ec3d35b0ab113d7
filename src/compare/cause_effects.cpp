// SPDX-License-Identifier: Apache-2.0
#include "compare/cause_effects.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/sort_stably.h"
#include "compare/cause_pair.h"
#include "compare/parameter_fit.h"

namespace glint {
namespace {

// Multiples of a number that are tried under a fault of pictures, as starts of a fit.
constexpr double k_multiples[] = {0.5, 0.7, 1.5, 2}, k_factors[] = {0.25, 0.5, 0.7, 1.5, 2, 4};
constexpr int k_rounds = 4;  // of a fit by least absolute differences

// The factor of `part` that is nearest to `wanted`, by least absolute differences.
double multiple_of(const std::vector<float>& part, const std::vector<float>& wanted,
                   const std::vector<std::uint8_t>& is_known) {
    double factor = 0;
    for (int round = 0; round < k_rounds; ++round) {
        double products = 0, squares = 0;
        for (std::size_t k = 0; k < part.size(); ++k) {
            if (is_known[k] == 0) continue;
            const auto p = static_cast<double>(part[k]), w = static_cast<double>(wanted[k]);
            const double weight = round == 0 ? 1 : 1 / std::max(std::fabs(w - factor * p), 0.5 / 255);
            products += weight * w * p;
            squares += weight * p * p;
        }
        if (!(squares > 0)) return 0;
        factor = products / squares;
    }
    return factor;
}

// What one effect adds to the light, in the pixels that count, with the sums of a fit.
struct Change {
    const CauseEffect* effect = nullptr;
    std::vector<float> part;
    double square = 0, wanted = 0;  // of the part, and of the part and what is wanted
};

// The multiples of two changes whose sum is nearest to what is wanted, and the squares that remain, of
// `whole`. A change that is no multiple of a part stays as it is.
struct Sum {
    double by_a = 1, by_b = 1, left = 0;
};
Sum nearest_sum(const Change& a, const Change& b, double whole) {
    const double ab = product(a.part, b.part);
    Sum sum;
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

// The multiple of a part of the light of which `by` times the change of the first multiple is the change.
double multiple_by(double by) { return 1 + by * (k_multiples[0] - 1); }

}  // namespace

std::vector<CauseEffect> effects_of(const SceneRenderer& renderer, const SceneSearch& causes,
                                    const PixelGrid& grid) {
    std::vector<CauseEffect> effects;
    const Image& plain = causes.rendered()->image;
    for (std::size_t i = 0; i < causes.size() && !renderer.is_cancelled(); ++i) {
        const SceneCause& cause = causes.cause(i);
        for (const double factor : k_factors) {
            if (!cause.scale) break;
            CauseCandidate candidate = causes.scaled_candidate(i, factor, true);
            if (auto scaled = render_candidate(renderer, candidate, renderer.scene(), grid))
                effects.push_back({std::move(candidate), *std::move(scaled), false});
        }
        std::optional<RenderedScene> made = causes.render_cause(i);
        if (!made || made->bytes.rgb == causes.rendered()->bytes.rgb) continue;
        for (const double factor : k_multiples) {
            if (cause.part.empty()) break;
            Image image = made->image;
            for (std::size_t k = 0; k < image.rgb.size(); ++k)
                image.rgb[k] += static_cast<float>(factor) * (plain.rgb[k] - image.rgb[k]);
            BytePicture bytes = to_bytes(image, 1, renderer.rule(renderer.scene().shading));
            effects.push_back(
                {causes.scaled_candidate(i, factor, true), {std::move(image), std::move(bytes)}, true});
        }
        effects.push_back({causes.candidate(i), *std::move(made), false});
    }
    return effects;
}

std::vector<CauseCandidate> candidates_after(const std::vector<CauseEffect>& effects,
                                             const SceneSearch& causes, const RenderedScene& first,
                                             const CauseCandidate& cause, const BytePicture& target,
                                             std::size_t most) {
    const std::vector<float>& plain = causes.rendered()->image.rgb;
    const std::size_t size = plain.size();
    std::vector<float> wanted(size), part(size), rest(size);
    std::vector<std::uint8_t> is_known(size);  // not clamped
    for (std::size_t k = 0; k < size; ++k) {
        wanted[k] = static_cast<float>(target.rgb[k]) / 255;
        rest[k] = wanted[k] - first.image.rgb[k];
        is_known[k] = target.rgb[k] > 0 && target.rgb[k] < 255 && first.image.rgb[k] < 1;
    }
    std::vector<std::pair<double, CauseCandidate>> order;
    for (const CauseEffect& effect : effects) {
        CauseCandidate candidate = effect.candidate;
        if (candidate.cause.name == cause.cause.name || (!cause.edit && !candidate.edit)) continue;
        for (std::size_t k = 0; k < size; ++k) part[k] = effect.rendered.image.rgb[k] - plain[k];
        float by = 1;
        if (effect.is_multiple) {
            if (candidate.values[0] != k_multiples[0]) continue;  // one of them says what the others would
            by = static_cast<float>(multiple_of(part, rest, is_known));
            const double factor = multiple_by(static_cast<double>(by));
            if (factor < k_min_multiple) continue;
            candidate = causes.scaled_candidate(candidate.row, factor, true);
        }
        double left = 0;
        for (std::size_t k = 0; k < size; ++k) {
            const float sum = first.image.rgb[k] + by * part[k];
            left += static_cast<double>(std::fabs(std::clamp(sum, 0.0f, 1.0f) - wanted[k]));
        }
        order.emplace_back(left, std::move(candidate));
    }
    sort_stably(order, [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<CauseCandidate> best;
    std::set<std::string> known;
    for (auto& [left, candidate] : order) {
        if (best.size() == most) break;
        if (known.insert(row_key(candidate)).second) best.push_back(std::move(candidate));
    }
    return best;
}

std::vector<std::pair<CauseCandidate, CauseCandidate>> likely_pairs(const std::vector<CauseEffect>& effects,
                                                                    const SceneSearch& causes,
                                                                    const BytePicture& target,
                                                                    std::size_t most) {
    const std::vector<float>& plain = causes.rendered()->image.rgb;
    std::vector<std::size_t> places;  // not clamped
    std::vector<float> wanted;
    for (std::size_t k = 0; k < plain.size(); ++k) {
        if (target.rgb[k] == 0 || target.rgb[k] == 255) continue;
        places.push_back(k);
        wanted.push_back(static_cast<float>(target.rgb[k]) / 255 - plain[k]);
    }
    const double whole = product(wanted, wanted);
    std::vector<Change> changes;
    for (const CauseEffect& effect : effects) {
        if (effect.is_multiple && effect.candidate.values[0] != k_multiples[0]) continue;
        Change change{&effect, {}};
        for (const std::size_t k : places) change.part.push_back(effect.rendered.image.rgb[k] - plain[k]);
        change.square = product(change.part, change.part);
        change.wanted = product(change.part, wanted);
        if (change.square > 0) changes.push_back(std::move(change));
    }
    struct Likely {
        double left = 0;
        const Change *a = nullptr, *b = nullptr;
        Sum sum;
    };
    std::vector<Likely> order;
    const auto is_possible = [](const Change& c, double by) {
        return !c.effect->is_multiple || multiple_by(by) >= k_min_multiple;
    };
    for (std::size_t i = 0; i < changes.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const CauseCandidate &a = changes[i].effect->candidate, &b = changes[j].effect->candidate;
            if (a.cause.name == b.cause.name || (!a.edit && !b.edit)) continue;
            const Sum sum = nearest_sum(changes[i], changes[j], whole);
            if (sum.left < whole && is_possible(changes[i], sum.by_a) && is_possible(changes[j], sum.by_b))
                order.push_back({sum.left, &changes[i], &changes[j], sum});
        }
    }
    sort_stably(order, [](const Likely& a, const Likely& b) { return a.left < b.left; });
    std::vector<std::pair<CauseCandidate, CauseCandidate>> best;
    std::set<std::pair<std::string, std::string>> known;
    const auto candidate_of = [&](const Change& c, double by) {
        const CauseCandidate& candidate = c.effect->candidate;
        return c.effect->is_multiple ? causes.scaled_candidate(candidate.row, multiple_by(by), true)
                                     : candidate;
    };
    for (const Likely& l : order) {
        if (best.size() == most) break;
        if (known.insert({row_key(l.a->effect->candidate), row_key(l.b->effect->candidate)}).second)
            best.emplace_back(candidate_of(*l.a, l.sum.by_a), candidate_of(*l.b, l.sum.by_b));
    }
    return best;
}

}  // namespace glint
