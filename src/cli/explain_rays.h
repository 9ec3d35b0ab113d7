// SPDX-License-Identifier: Apache-2.0
#pragma once
// The rays of an explanation: what they are called, where they start, and what follows from them.
#include <string>
#include <string_view>
#include <vector>

#include "glint/explain.h"

namespace glint::cli {

/// What a ray adds to the pixel together with the rays that start where it hits.
struct Subtree {
    Color light;
    double most = 0;  ///< the sum of the largest channels: light of both signs does not cancel
    int rays = 1;
};

/// By the numbers of the rays. alpha_loss: what alpha loses where a ray of weight 1 sees the background; it
/// counts, too.
std::vector<Subtree> subtrees_of(const Explanation& explanation, double alpha_loss);

/// "mirror ray"
std::string_view kind_of(const ExplainedRay& ray);

/// Where a secondary ray starts, and why not at P itself. Empty if it is a part of the ray before.
std::string start_text(const ExplainedRay& ray, const ExplainedRay& before, const Scene& scene);

}  // namespace glint::cli
