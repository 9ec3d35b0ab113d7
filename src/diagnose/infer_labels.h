// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which shapes and lights the numbers and names of a log are.
#include <cstddef>

#include "diagnose/log_model.h"

namespace glint {

/// The most places that are looked at to find out what a log's numbers mean.
inline constexpr std::size_t k_most_places = 400;

/// By where they are hit, else by their names or numbers. Writes to model.rules.
void infer_shapes(LogModel& model);
/// By L, distance, N.L or the diffuse term, else by their names or numbers. Writes to model.rules.
void infer_lights(LogModel& model);

}  // namespace glint
