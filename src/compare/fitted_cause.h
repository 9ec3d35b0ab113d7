// SPDX-License-Identifier: Apache-2.0
#pragma once
// A cause with numbers that are fitted to a picture: a factor, the position of a light.
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "compare/scene_renderer.h"

namespace glint {

struct FittedCause {
    std::string name;
    /// One for each number: a change of it that changes the picture visibly, but not much.
    std::vector<double> units;
    /// Puts the fault with these numbers into a scene.
    std::function<void(FaultyScene&, std::span<const double>)> put;
    /// The explanation. `about`: the numbers do not explain all of the difference.
    std::function<std::string(std::span<const double>, bool about)> text;
    double least = 0.85;             ///< CauseCandidate::least
    std::vector<double> start = {};  ///< of the numbers; zeros if it is empty
    bool starts_far = false;         ///< `start` is another picture than the scene's
    bool is_factor = false;          ///< of a number of the scene
    bool fits_bytes = false;         ///< the picture depends linearly on the number, which gives its bytes
    /// If the cause has more forms than its numbers say: those that begin where these numbers are fitted. The
    /// nearest of them is fitted next.
    std::function<std::vector<FittedCause>(std::span<const double>)> refined = {};
    /// Whether the picture hardly depends on the numbers: a factor beyond these leaves no highlight that
    /// would tell it from a larger one.
    bool is_vague(std::span<const double> values) const {
        constexpr double k_told = 8;
        return is_factor && (values[0] > k_told || values[0] * k_told < 1);
    }
};

}  // namespace glint
