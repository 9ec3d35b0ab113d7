// SPDX-License-Identifier: Apache-2.0
#pragma once
// From single differences to findings: which mistake gives all of them.
#include <optional>
#include <string>
#include <vector>

#include "diagnose/observe.h"

namespace glint {

/// Places where a quantity differs for one reason.
struct FoundReason {
    std::vector<std::size_t> places;    ///< in the list of observations
    std::vector<TracerMistake> causes;  ///< that give all of the numbers
    bool is_sure = false;
    bool is_number = true;  ///< false: the log has NaN or infinity there
    std::string only;
    std::vector<Trial> trials;  ///< of the causes
};

/// The reasons of the wrong observations of one quantity. observations: all of them, right and wrong.
std::vector<FoundReason> find_reasons(const LogModel& model, const std::vector<Observation>& observations,
                                      Quantity quantity);

}  // namespace glint
