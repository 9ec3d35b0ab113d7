// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which multiple of a number makes a picture, found by drawing.
#include <functional>
#include <optional>
#include <string>

namespace glint {

/// A factor, and what stays of the difference with it.
struct TriedFactor {
    double factor = 1, left = 0;
};

/// What stays with a factor; nothing if it cannot be drawn.
using LeftByFactor = std::function<std::optional<double>(double)>;

/// The factor from low to high, both above 0, with which least stays, or `known`, the best so far. A golden
/// section over the logarithm, which takes for granted that there is one valley, then the number of two
/// digits near what it found. Ends early where no more than `enough` stays.
TriedFactor refine_factor(TriedFactor known, double low, double high, double enough,
                          const LeftByFactor& left_by);

/// How much of a thing there is in place of it: "half", "twice", "1.5 times", "about 1.37 times".
std::string factor_text(double factor, bool about);

}  // namespace glint
