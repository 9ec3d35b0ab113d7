// SPDX-License-Identifier: Apache-2.0
#pragma once
// Finds the multiple of a number that explains a picture, by rendering.
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace glint {

/// A factor and the remaining difference.
struct TriedFactor {
    double factor = 1, left = 0;
};

/// The remaining difference for a factor; nothing if it cannot be rendered.
using LeftByFactor = std::function<std::optional<double>(double)>;

/// The factor between low and high, both above 0, with the smallest remaining difference, or `known`, the
/// best so far. A golden-section search over the logarithm, which assumes one minimum, then numbers with two
/// digits near its result. Ends early if at most `enough` remains.
TriedFactor refine_factor(TriedFactor known, double low, double high, double enough,
                          const LeftByFactor& left_by);

/// A byte that is wanted, 0 to 1 without what no factor changes, and what a factor of 1 gives.
using WantedValue = std::pair<double, double>;

/// The factor within 1% of `near`, or half a byte of the largest value, that rounds the most of these values
/// to the bytes that are wanted; `near` if there is none that does so for half of them.
double factor_of_most(const std::vector<WantedValue>& values, double near);

/// A factor in words: "half", "twice", "1.5 times", "about 1.37 times".
std::string factor_text(double factor, bool about);

}  // namespace glint
