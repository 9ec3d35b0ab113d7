// SPDX-License-Identifier: Apache-2.0
#include "scene/solid_steps.h"

namespace glint {

SolidSteps::SolidSteps(const SolidTree& tree) : tree_(tree) {
    std::vector<std::size_t> open;  // the first steps of the results that no step has taken
    std::uint32_t operands = 0;
    first_.reserve(tree.steps.size());
    operands_before_.reserve(tree.steps.size());
    for (std::size_t step = 0; step < tree.steps.size(); ++step) {
        operands_before_.push_back(operands);
        if (is_operand(step)) {
            ++operands;
            open.push_back(step);
        } else {
            open.resize(open.size() - (tree.steps[step].count - 1));
        }
        first_.push_back(open.back());
    }
}

std::vector<std::size_t> SolidSteps::parts(std::size_t step) const {
    std::vector<std::size_t> parts(tree_.steps[step].count);
    std::size_t end = step;
    for (std::size_t part = parts.size(); part-- > 0;) {
        parts[part] = end - 1;
        end = first_[end - 1];
    }
    return parts;
}

}  // namespace glint
