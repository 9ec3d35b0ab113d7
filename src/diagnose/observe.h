// SPDX-License-Identifier: Apache-2.0
#pragma once
// The values of a log beside what they should be.
#include <functional>
#include <optional>
#include <vector>

#include "diagnose/ray_model.h"

namespace glint {

/// A quantity of a log at one place. light: in Scene::lights, or k_none.
struct ObservedPlace {
    std::uint32_t pixel = 0;
    std::int32_t ray = -1;
    std::uint32_t light = k_none;
    Quantity quantity = Quantity::origin;
};

/// Visits the places of all quantities that the log has, in the order in which a ray tracer computes them.
/// Lights whose label is unknown are left out. Ends if visit() returns false.
void for_each_place(const LogModel& model, const std::function<bool(const ObservedPlace&)>& visit);

enum class Verdict : std::uint8_t {
    right,
    wrong,
    unknown,  ///< it cannot be said what the value should be
};

struct Observation {
    ObservedPlace place;
    Verdict verdict = Verdict::unknown;
    bool is_number = true;  ///< false: the log has NaN or infinity
    ApproxVec yours, expected;
};

/// What a quantity should be at a place, with a mistake or without.
Maybe expected_at(const LogModel& model, const ObservedPlace& place, Trial trial);
/// The log's value at a place, in glint's conventions.
Maybe logged_at(const LogModel& model, const ObservedPlace& place);
/// Whether two values of a quantity are the same: directions by their direction, a cosine below 0 also as 0.
bool is_same(Quantity quantity, const ApproxVec& yours, const ApproxVec& expected);

/// Judges a place by the log's own earlier values. ray: the model of its ray, without a mistake; null for a
/// pixel.
Observation observe(const LogModel& model, const ObservedPlace& place, const RayModel* ray);

}  // namespace glint
