// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where alone a mistake may happen.
#include <functional>
#include <string>
#include <vector>

#include "diagnose/observe.h"

namespace glint {

/// A condition on places: "only where the ray comes from inside".
struct Condition {
    std::string words;
    std::function<bool(const ObservedPlace&)> holds;
    bool is_of_shape = false;  ///< of what is hit
};

/// All conditions that are tried. They refer to the model.
std::vector<Condition> place_conditions(const LogModel& model);

}  // namespace glint
