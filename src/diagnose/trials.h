// SPDX-License-Identifier: Apache-2.0
#pragma once
// Known mistakes, tried at the places where a quantity of a log is wrong and where it is right.
#include <array>
#include <set>
#include <string>
#include <vector>

#include "diagnose/conditions.h"
#include "diagnose/observe.h"

namespace glint {

/// Pixels that must show a mistake before it is sure.
inline constexpr std::size_t k_sure_pixels = 3;
/// The most wrong and right places of a quantity that are tried.
inline constexpr std::size_t k_most_wrong = 240, k_most_right = 480;

/// What a trial says about the wrong and the right observations of a quantity.
struct TrialResult {
    Trial trial;
    std::set<std::size_t> matched;          ///< wrong observations whose number it gives
    std::vector<std::size_t> contradicted;  ///< right ones that it would have changed
    std::string only;                       ///< the condition without which it is contradicted; empty: none
    bool is_rejected = false;
};

class Trials {
  public:
    /// Both must outlive the object. quantity: the one that is wrong.
    Trials(const LogModel& model, const std::vector<Observation>& observations, Quantity quantity);

    const std::vector<Condition>& conditions() const { return conditions_; }
    /// The wrong places that are tried, as indices in the observations; and all of them.
    const std::vector<std::size_t>& tried() const { return wrong_; }
    const std::vector<std::size_t>& every_wrong() const { return every_wrong_; }

    /// Whether the trial gives the log's number there, and it is not the right one.
    bool gives(const Trial& trial, const Observation& seen) const;
    /// The mistakes that give a number of these places, and are not contradicted by a right value.
    std::vector<TrialResult> run(const std::vector<std::size_t>& wrong) const;

  private:
    void try_exponents(const std::vector<std::size_t>& wrong, std::vector<TrialResult>& results) const;
    TrialResult try_mistake(Trial trial, const std::vector<std::size_t>& wrong) const;
    void check_right(TrialResult& result) const;

    const LogModel& model_;
    const std::vector<Observation>& all_;
    Quantity quantity_;
    std::vector<Condition> conditions_;
    std::vector<std::size_t> every_wrong_, wrong_;
    std::array<std::vector<std::size_t>, k_quantities> right_;  // by quantity, up to this one
};

}  // namespace glint
