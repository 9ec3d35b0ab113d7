// SPDX-License-Identifier: Apache-2.0
#pragma once
// Finds the multiple of a number that explains a picture, by rendering.
#include <functional>
#include <optional>
#include <string>

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

/// A factor in words: "half", "twice", "1.5 times", "about 1.37 times".
std::string factor_text(double factor, bool about);

}  // namespace glint
