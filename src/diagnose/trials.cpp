// SPDX-License-Identifier: Apache-2.0
#include "diagnose/trials.h"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

template <class List> List thinned(const List& list, std::size_t most) {
    if (list.size() <= most) return list;
    List some;
    for (std::size_t i = 0; i < most; ++i) some.push_back(list[i * list.size() / most]);
    return some;
}

}  // namespace

Trials::Trials(const LogModel& model, const std::vector<Observation>& observations, Quantity quantity)
    : model_(model), all_(observations), quantity_(quantity), conditions_(place_conditions(model)) {
    for (std::size_t i = 0; i < all_.size(); ++i) {
        if (all_[i].verdict == Verdict::right && all_[i].place.quantity <= quantity)
            right_[static_cast<std::size_t>(all_[i].place.quantity)].push_back(i);
        if (all_[i].place.quantity == quantity && all_[i].verdict == Verdict::wrong)
            every_wrong_.push_back(i);
    }
    wrong_ = thinned(every_wrong_, k_most_wrong);
    for (auto& right : right_) right = thinned(right, k_most_right);
}

std::vector<TrialResult> Trials::run(const std::vector<std::size_t>& wrong) const {
    std::vector<TrialResult> results;
    for (const MistakeInfo& info : mistake_infos()) {
        if (info.at > quantity_) continue;
        for (int v = 0; v < info.variants; ++v) {
            TrialResult result = try_mistake({info.mistake, v}, wrong);
            if (!result.matched.empty()) results.push_back(std::move(result));
        }
    }
    for (TrialResult& result : results) check_right(result);
    std::erase_if(results, [](const TrialResult& r) { return r.is_rejected; });
    if (results.empty() && quantity_ >= Quantity::power) try_exponents(wrong, results);
    return results;
}

bool Trials::gives(const Trial& trial, const Observation& seen) const {
    const Maybe predicted = expected_at(model_, seen.place, trial);
    // A cosine of 0 may have been below 0 before: that is no number that a mistake gives.
    const bool is_cosine =
        quantity_ == Quantity::n_l || quantity_ == Quantity::r_v || quantity_ == Quantity::n_h;
    if (is_cosine && predicted && seen.yours.x.v == 0 && predicted->x.v + predicted->x.e < 0) return false;
    return predicted && is_same(quantity_, seen.yours, *predicted) &&
           !is_same(quantity_, *predicted, seen.expected);
}

// An exponent of another value: the one that gives the first number, tried at all other places.
void Trials::try_exponents(const std::vector<std::size_t>& wrong, std::vector<TrialResult>& results) const {
    for (std::size_t k = 0; k < std::min<std::size_t>(wrong.size(), 4); ++k) {
        const Observation& seen = all_[wrong[k * wrong.size() / 4]];
        const auto at = [&](double exponent) {
            const Maybe v = expected_at(model_, seen.place, {TracerMistake::exponent_other, 0, exponent});
            return v ? v->x.v + v->y.v + v->z.v : 0;
        };
        const double wanted = seen.yours.x.v + seen.yours.y.v + seen.yours.z.v;
        double low = 0.01, high = 1e5;
        if (!(at(low) > wanted && wanted > at(high) && wanted > 1e-12)) continue;
        for (int i = 0; i < 60; ++i) {
            const double middle = std::sqrt(low * high);
            (at(middle) > wanted ? low : high) = middle;
        }
        // As a user would have written it.
        double exponent = std::sqrt(low * high);
        if (const double whole = std::floor(exponent * 2 + 0.5) / 2;
            std::fabs(whole - exponent) < 1e-3 * exponent)
            exponent = whole;
        TrialResult result = try_mistake({TracerMistake::exponent_other, 0, exponent}, wrong);
        if (result.matched.size() < k_sure_pixels) continue;
        check_right(result);
        if (!result.is_rejected) {
            results.push_back(std::move(result));
            return;
        }
    }
}

TrialResult Trials::try_mistake(Trial trial, const std::vector<std::size_t>& wrong) const {
    TrialResult result;
    result.trial = trial;
    std::size_t tried = 0;
    for (const std::size_t i : wrong) {
        ++tried;
        if (gives(trial, all_[i])) result.matched.insert(i);
        if (tried == 40 && result.matched.empty()) break;
    }
    return result;
}

// A mistake would show at the right places, too, unless it happens under a condition.
void Trials::check_right(TrialResult& result) const {
    std::size_t changed = 0;
    // From the quantity on that it changes: where the log has that, and it is right, the mistake is not
    // made.
    for (int q = static_cast<int>(info_of(result.trial.mistake).at); q <= static_cast<int>(quantity_); ++q) {
        for (const std::size_t i : right_[static_cast<std::size_t>(q)]) {
            const Maybe predicted = expected_at(model_, all_[i].place, result.trial);
            if (!predicted || is_same(all_[i].place.quantity, all_[i].yours, *predicted)) continue;
            ++changed;
            result.contradicted.push_back(i);
        }
    }
    const bool is_noisy = info_of(result.trial.mistake).is_noisy;
    if (changed == 0 || (is_noisy && changed * 3 <= result.matched.size() + changed)) return;
    for (const Condition& condition : conditions_) {
        // What is hit is not a condition of what is hit.
        if (condition.is_of_shape && info_of(result.trial.mistake).at == Quantity::hit) continue;
        const bool separates = std::all_of(result.matched.begin(), result.matched.end(),
                                           [&](std::size_t i) { return condition.holds(all_[i].place); }) &&
                               std::none_of(result.contradicted.begin(), result.contradicted.end(),
                                            [&](std::size_t i) { return condition.holds(all_[i].place); });
        if (!separates) continue;
        result.only = condition.words;
        return;
    }
    result.is_rejected = true;
}

}  // namespace glint
