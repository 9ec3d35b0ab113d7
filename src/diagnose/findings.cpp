// SPDX-License-Identifier: Apache-2.0
#include "diagnose/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <set>

#include "diagnose/conditions.h"

namespace glint {
namespace {

constexpr std::size_t k_most_wrong = 240, k_most_right = 480;
constexpr std::size_t k_sure_pixels = 3;

template <class List> List thinned(const List& list, std::size_t most) {
    if (list.size() <= most) return list;
    List some;
    for (std::size_t i = 0; i < most; ++i) some.push_back(list[i * list.size() / most]);
    return some;
}

// What a trial says about the wrong and the right observations of a quantity.
struct TrialResult {
    Trial trial;
    std::set<std::size_t> matched;          // wrong observations whose number it gives
    std::vector<std::size_t> contradicted;  // right ones that it would have changed
    std::string only;
    bool is_rejected = false;
};

class ReasonFinder {
  public:
    ReasonFinder(const LogModel& model, const std::vector<Observation>& observations, Quantity quantity)
        : model_(model), all_(observations), quantity_(quantity), conditions_(place_conditions(model)) {
        std::vector<std::size_t> wrong;
        for (std::size_t i = 0; i < all_.size(); ++i) {
            if (all_[i].verdict == Verdict::right && all_[i].place.quantity <= quantity)
                right_[static_cast<std::size_t>(all_[i].place.quantity)].push_back(i);
            if (all_[i].place.quantity == quantity && all_[i].verdict == Verdict::wrong) wrong.push_back(i);
        }
        every_wrong_ = wrong;
        wrong_ = thinned(wrong, k_most_wrong);
        for (auto& right : right_) right = thinned(right, k_most_right);
    }

    std::vector<FoundReason> find() {
        std::vector<std::size_t> numbers;
        FoundReason not_numbers;
        for (const std::size_t i : wrong_) (all_[i].is_number ? numbers : not_numbers.places).push_back(i);
        std::vector<FoundReason> reasons;
        if (!not_numbers.places.empty()) {
            not_numbers.is_number = false;
            reasons.push_back(std::move(not_numbers));
        }
        std::vector<TrialResult> results;
        for (const MistakeInfo& info : mistake_infos()) {
            if (info.at > quantity_) continue;
            for (int v = 0; v < info.variants; ++v) {
                TrialResult result = try_mistake({info.mistake, v}, numbers);
                if (!result.matched.empty()) results.push_back(std::move(result));
            }
        }
        for (TrialResult& result : results) check_right(result);
        std::erase_if(results, [](const TrialResult& r) { return r.is_rejected; });
        if (results.empty() && quantity_ >= Quantity::power) try_exponents(numbers, results);
        std::set<std::size_t> left(numbers.begin(), numbers.end());
        for (int i = 0; i < 3 && !left.empty(); ++i)
            if (!take_best(results, left, reasons)) break;
        if (!left.empty()) reasons.emplace_back().places.assign(left.begin(), left.end());
        add_untried(reasons);
        return reasons;
    }

  private:
    // The places that were not tried belong to the first reason that gives their number, else to the last.
    void add_untried(std::vector<FoundReason>& reasons) const {
        if (reasons.empty() || every_wrong_.size() == wrong_.size()) return;
        const std::set<std::size_t> tried(wrong_.begin(), wrong_.end());
        for (const std::size_t i : every_wrong_) {
            if (tried.contains(i)) continue;
            auto reason = std::find_if(reasons.begin(), reasons.end(), [&](const FoundReason& r) {
                return std::any_of(r.trials.begin(), r.trials.end(),
                                   [&](const Trial& t) { return gives(t, all_[i]); });
            });
            if (reasons.size() == 1 || reason == reasons.end()) reason = reasons.end() - 1;
            reason->places.push_back(i);
        }
        for (FoundReason& reason : reasons) std::sort(reason.places.begin(), reason.places.end());
    }

    // Whether the trial gives the log's number there, and it is not the right one.
    bool gives(const Trial& trial, const Observation& seen) const {
        const Maybe predicted = expected_at(model_, seen.place, trial);
        // A cosine of 0 may have been below 0 before: that is no number that a mistake gives.
        const bool is_cosine =
            quantity_ == Quantity::n_l || quantity_ == Quantity::r_v || quantity_ == Quantity::n_h;
        if (is_cosine && predicted && seen.yours.x.v == 0 && predicted->x.v + predicted->x.e < 0)
            return false;
        return predicted && is_same(quantity_, seen.yours, *predicted) &&
               !is_same(quantity_, *predicted, seen.expected);
    }

    // An exponent of another value: the one that gives the first number, tried at all other places.
    void try_exponents(const std::vector<std::size_t>& wrong, std::vector<TrialResult>& results) const {
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

    TrialResult try_mistake(Trial trial, const std::vector<std::size_t>& wrong) const {
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
    void check_right(TrialResult& result) const {
        std::size_t changed = 0;
        // From the quantity on that it changes: where the log has that, and it is right, the mistake is not
        // made.
        for (int q = static_cast<int>(info_of(result.trial.mistake).at); q <= static_cast<int>(quantity_);
             ++q) {
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
            const bool separates =
                std::all_of(result.matched.begin(), result.matched.end(),
                            [&](std::size_t i) { return condition.holds(all_[i].place); }) &&
                std::none_of(result.contradicted.begin(), result.contradicted.end(),
                             [&](std::size_t i) { return condition.holds(all_[i].place); });
            if (!separates) continue;
            result.only = condition.words;
            return;
        }
        result.is_rejected = true;
    }

    // In a log of thousands of pixels, rounding behind several surfaces of glass gives some values of any
    // kind.
    std::size_t sure_pixels() const { return std::max(k_sure_pixels, model_.log.pixels.size() / 1000); }

    std::size_t pixels_of(const std::set<std::size_t>& places) const {
        std::set<std::uint32_t> pixels;
        for (const std::size_t i : places) pixels.insert(all_[i].place.pixel);
        return pixels.size();
    }

    // Takes the mistake that gives most of the numbers that are left.
    bool take_best(const std::vector<TrialResult>& results, std::set<std::size_t>& left,
                   std::vector<FoundReason>& reasons) const {
        const auto gained = [&](const TrialResult& r) {
            std::set<std::size_t> both;
            std::set_intersection(r.matched.begin(), r.matched.end(), left.begin(), left.end(),
                                  std::inserter(both, both.end()));
            return both;
        };
        std::size_t most = 0;
        for (const TrialResult& r : results) most = std::max(most, gained(r).size());
        if (most == 0) return false;
        const bool is_whole = most == left.size();
        FoundReason reason;
        std::set<std::size_t> places;
        bool is_noisy = false, has_unconditional = false;
        for (const TrialResult& r : results) {
            const auto here = gained(r);
            // A noisy mistake gives most of the numbers; those that it does not give are its own, too.
            const bool noisy = info_of(r.trial.mistake).is_noisy;
            if (here.size() != most && !(noisy && 10 * here.size() >= 7 * most)) continue;
            if (std::find(reason.causes.begin(), reason.causes.end(), r.trial.mistake) != reason.causes.end())
                continue;
            if (r.only.empty()) has_unconditional = true;
            is_noisy = is_noisy || noisy;
            reason.causes.push_back(r.trial.mistake);
            reason.trials.push_back(r.trial);
            places.insert(here.begin(), here.end());
            if (reason.only.empty()) reason.only = r.only;
        }
        // A condition is a weaker answer than none.
        if (has_unconditional) {
            reason.only.clear();
            std::erase_if(reason.causes, [&](TracerMistake m) {
                return std::none_of(results.begin(), results.end(), [&](const TrialResult& r) {
                    return r.trial.mistake == m && r.only.empty() && gained(r).size() > 0;
                });
            });
        }
        if (reason.causes.size() > 1) judge_by_later(results, reason.causes);
        // Rows that count from the bottom are known from the camera rays alone: a ray through another place
        // of its pixel may as well be one of a flipped picture.
        const bool is_of_rows =
            model_.rules.rows_from_bottom && !model_.log.rows_from_bottom && !model_.log.is_printrays;
        const auto moves_pixel = [](TracerMistake m) {
            return m >= TracerMistake::pixel_corner && m <= TracerMistake::pixel_opposite_corner;
        };
        const bool names_rows = std::find(reason.causes.begin(), reason.causes.end(),
                                          TracerMistake::rows_flipped) != reason.causes.end();
        if (is_of_rows && !names_rows && std::any_of(reason.causes.begin(), reason.causes.end(), moves_pixel))
            reason.causes.push_back(TracerMistake::rows_flipped);
        // A mistake without a condition in what is hit would show everywhere.
        // A flag has one other value, which a mistake under a condition gives too easily.
        const QuantityKind kind = info_of(quantity_).kind;
        const bool is_weak = !has_unconditional &&
                             (kind == QuantityKind::flag || kind == QuantityKind::label ||
                              std::any_of(reason.causes.begin(), reason.causes.end(),
                                          [](TracerMistake m) { return info_of(m).at == Quantity::hit; }));
        // The simpler of two that give the same numbers.
        if (std::find(reason.causes.begin(), reason.causes.end(), TracerMistake::bytes_truncated) !=
            reason.causes.end())
            std::erase(reason.causes, TracerMistake::bytes_wrapped);
        const bool covers_most =
            is_whole || 10 * most >= 9 * left.size() || (is_noisy && 10 * most >= 7 * left.size());
        reason.is_sure = reason.causes.size() == 1 && !is_weak && !(is_of_rows && names_rows) &&
                         pixels_of(places) >= sure_pixels() && (covers_most || separates(places, left));
        if (is_noisy && covers_most) places = left;
        std::erase_if(reason.trials, [&](const Trial& t) {
            return std::find(reason.causes.begin(), reason.causes.end(), t.mistake) == reason.causes.end();
        });
        reason.places.assign(places.begin(), places.end());
        for (const std::size_t i : places) left.erase(i);
        reasons.push_back(std::move(reason));
        return true;
    }

    // Of several mistakes that give the same numbers, later quantities may show which: one that would change
    // values that are right is not made; one that alone gives later wrong numbers is.
    void judge_by_later(const std::vector<TrialResult>& results, std::vector<TracerMistake>& causes) const {
        struct Evidence {
            std::size_t changed = 0, given = 0;
        };
        std::vector<Evidence> evidence;
        for (const TracerMistake cause : causes) {
            const auto trial = std::find_if(results.begin(), results.end(), [&](const TrialResult& r) {
                                   return r.trial.mistake == cause;
                               })->trial;
            Evidence& of = evidence.emplace_back();
            std::size_t seen = 0;
            for (std::size_t i = 0; i < all_.size() && seen < 2 * k_most_right; ++i) {
                const Observation& one = all_[i];
                if (one.place.quantity <= quantity_ || one.verdict == Verdict::unknown || !one.is_number)
                    continue;
                ++seen;
                const Maybe predicted = expected_at(model_, one.place, trial);
                if (!predicted || is_same(one.place.quantity, *predicted, one.expected)) continue;
                const bool is_given = is_same(one.place.quantity, one.yours, *predicted);
                if (one.verdict == Verdict::right && !is_given) ++of.changed;
                if (one.verdict == Verdict::wrong && is_given) ++of.given;
            }
        }
        const auto keep = [&](auto is_kept) {
            std::vector<TracerMistake> kept;
            std::vector<Evidence> of;
            for (std::size_t i = 0; i < causes.size(); ++i)
                if (is_kept(evidence[i])) kept.push_back(causes[i]), of.push_back(evidence[i]);
            if (!kept.empty()) causes = kept, evidence = of;
        };
        keep([](const Evidence& e) { return e.changed < 3; });
        keep([](const Evidence& e) { return e.given >= 3; });
    }

    // Whether a condition tells the places of one reason from the others.
    bool separates(const std::set<std::size_t>& places, const std::set<std::size_t>& left) const {
        return std::any_of(conditions_.begin(), conditions_.end(), [&](const Condition& condition) {
            return std::all_of(left.begin(), left.end(), [&](std::size_t i) {
                return condition.holds(all_[i].place) == places.contains(i);
            });
        });
    }

    const LogModel& model_;
    const std::vector<Observation>& all_;
    Quantity quantity_;
    std::vector<Condition> conditions_;
    std::vector<std::size_t> every_wrong_, wrong_;              // the second: those that are tried
    std::array<std::vector<std::size_t>, k_quantities> right_;  // by quantity, up to this one
};

}  // namespace

std::vector<FoundReason> find_reasons(const LogModel& model, const std::vector<Observation>& observations,
                                      Quantity quantity) {
    return ReasonFinder(model, observations, quantity).find();
}

}  // namespace glint
