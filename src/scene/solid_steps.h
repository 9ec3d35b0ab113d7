// SPDX-License-Identifier: Apache-2.0
#pragma once
// The steps of a solid as a tree.
#include <cstddef>
#include <cstdint>
#include <vector>

#include "glint/solid.h"

namespace glint {

/// Of a tree without mistakes.
class SolidSteps {
  public:
    explicit SolidSteps(const SolidTree& tree);

    std::size_t root() const { return tree_.steps.size() - 1; }
    SolidOperation operation(std::size_t step) const { return tree_.steps[step].operation; }
    bool is_operand(std::size_t step) const { return operation(step) == SolidOperation::operand; }
    /// The index of the operand that the step is.
    std::uint32_t operand(std::size_t step) const { return operands_before_[step]; }
    /// The steps whose results the step takes, in order.
    std::vector<std::size_t> parts(std::size_t step) const;

  private:
    const SolidTree& tree_;
    std::vector<std::size_t> first_;  // by step: the first of those that its result depends on
    std::vector<std::uint32_t> operands_before_;
};

}  // namespace glint
