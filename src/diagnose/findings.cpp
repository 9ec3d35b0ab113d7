// SPDX-License-Identifier: Apache-2.0
#include "diagnose/findings.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "diagnose/trials.h"

namespace glint {
namespace {

class ReasonFinder {
  public:
    ReasonFinder(const LogModel& model, const std::vector<Observation>& observations, Quantity quantity)
        : model_(model), all_(observations), quantity_(quantity), trials_(model, observations, quantity) {
        for (const Observation& seen : all_)
            if (seen.verdict == Verdict::wrong && seen.place.quantity < quantity &&
                (seen.place.quantity == Quantity::hit || seen.place.quantity == Quantity::t))
                misplaced_.emplace(seen.place.pixel, seen.place.ray);
    }

    std::vector<FoundReason> find() {
        std::vector<std::size_t> numbers;
        FoundReason not_numbers;
        for (const std::size_t i : trials_.tried())
            (all_[i].is_number ? numbers : not_numbers.places).push_back(i);
        std::vector<FoundReason> reasons;
        if (!not_numbers.places.empty()) {
            not_numbers.is_number = false;
            reasons.push_back(std::move(not_numbers));
        }
        const std::vector<TrialResult> results = trials_.run(numbers);
        std::set<std::size_t> left(numbers.begin(), numbers.end());
        for (int i = 0; i < 3 && !left.empty(); ++i)
            if (!take_best(results, left, reasons)) break;
        if (!left.empty()) {
            FoundReason& unknown = reasons.emplace_back();
            unknown.places.assign(left.begin(), left.end());
            unknown.only = condition_of(unknown.places);
        }
        add_untried(reasons);
        return reasons;
    }

  private:
    // The places that were not tried belong to the first reason that gives their number, else to the last.
    void add_untried(std::vector<FoundReason>& reasons) const {
        const std::vector<std::size_t>& some = trials_.tried();
        if (reasons.empty() || trials_.every_wrong().size() == some.size()) return;
        const std::set<std::size_t> tried(some.begin(), some.end());
        for (const std::size_t i : trials_.every_wrong()) {
            if (tried.contains(i)) continue;
            auto reason = std::find_if(reasons.begin(), reasons.end(), [&](const FoundReason& r) {
                return std::any_of(r.trials.begin(), r.trials.end(),
                                   [&](const Trial& t) { return trials_.gives(t, all_[i]); });
            });
            if (reasons.size() == 1 || reason == reasons.end()) reason = reasons.end() - 1;
            reason->places.push_back(i);
        }
        for (FoundReason& reason : reasons) std::sort(reason.places.begin(), reason.places.end());
    }

    // Where alone a difference is whose cause is unknown: a condition that holds at all of its places, and at
    // no right one of at least three.
    std::string condition_of(const std::vector<std::size_t>& places) const {
        std::vector<std::size_t> right;
        for (std::size_t i = 0; i < all_.size() && right.size() < k_most_right; ++i)
            if (all_[i].place.quantity == quantity_ && all_[i].verdict == Verdict::right) right.push_back(i);
        if (right.size() < k_sure_pixels || places.size() < k_sure_pixels) return {};
        for (const Condition& condition : trials_.conditions()) {
            const auto holds = [&](std::size_t i) { return condition.holds(all_[i].place); };
            if (std::all_of(places.begin(), places.end(), holds) &&
                std::none_of(right.begin(), right.end(), holds))
                return condition.words;
        }
        return {};
    }

    // In a log of thousands of pixels, rounding behind several surfaces of glass gives some values of any
    // kind.
    std::size_t sure_pixels() const { return std::max(k_sure_pixels, model_.log.pixels.size() / 1000); }

    // Where the shape or its distance is wrong, what follows from them shows no mistake of its own surely.
    std::size_t sound_pixels_of(const std::set<std::size_t>& places) const {
        std::set<std::uint32_t> pixels;
        for (const std::size_t i : places)
            if (!misplaced_.contains({all_[i].place.pixel, all_[i].place.ray}))
                pixels.insert(all_[i].place.pixel);
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
        // Shadow rays, which are not in the log, are intersected by the same functions.
        const bool is_of_hits = quantity_ == Quantity::blocked && !misplaced_.empty();
        reason.is_sure = reason.causes.size() == 1 && !is_weak && !is_of_hits &&
                         !(is_of_rows && names_rows) && sound_pixels_of(places) >= sure_pixels() &&
                         (covers_most || separates(places, left));
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
        const std::vector<Condition>& conditions = trials_.conditions();
        return std::any_of(conditions.begin(), conditions.end(), [&](const Condition& condition) {
            return std::all_of(left.begin(), left.end(), [&](std::size_t i) {
                return condition.holds(all_[i].place) == places.contains(i);
            });
        });
    }

    const LogModel& model_;
    const std::vector<Observation>& all_;
    Quantity quantity_;
    Trials trials_;
    std::set<std::pair<std::uint32_t, std::int32_t>> misplaced_;  // pixels and rays with a wrong hit
};

}  // namespace

std::vector<FoundReason> find_reasons(const LogModel& model, const std::vector<Observation>& observations,
                                      Quantity quantity) {
    return ReasonFinder(model, observations, quantity).find();
}

}  // namespace glint
