// SPDX-License-Identifier: Apache-2.0
#include "scene/validate_solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "scene/closed_mesh.h"
#include "scene/validate_mesh.h"

namespace glint {

bool encloses_space(const Scene& scene, const Shape& shape) {
    switch (shape.kind) {
        case ShapeKind::sphere:
        case ShapeKind::plane:
        case ShapeKind::box:
        case ShapeKind::torus:
        case ShapeKind::quadric:
        case ShapeKind::quartic:
            return true;
        case ShapeKind::cylinder:
            return shape.index < scene.get<Cylinder>().size() && scene.get<Cylinder>()[shape.index].caps;
        case ShapeKind::cone:
            return shape.index < scene.get<Cone>().size() && scene.get<Cone>()[shape.index].caps;
        case ShapeKind::disc:
        case ShapeKind::triangle:
        case ShapeKind::smooth_triangle:
        case ShapeKind::polygon:
        case ShapeKind::solid:
            return false;
        case ShapeKind::mesh: {
            const auto& meshes = scene.get<Mesh>();
            const std::uint32_t index = shape.index < meshes.size() ? meshes[shape.index].mesh : k_none;
            if (index >= scene.meshes.size() || scene.meshes[index] == nullptr) return false;
            return mistake_in(*scene.meshes[index]).empty() && !find_open_triangle(*scene.meshes[index]);
        }
    }
    return false;
}

std::string mistake_in_steps(const SolidTree& tree) {
    std::vector<int> depths;  // of the results that no step has taken
    std::size_t operands = 0;
    for (std::size_t i = 0; i < tree.steps.size(); ++i) {
        const SolidStep& step = tree.steps[i];
        if (step.operation == SolidOperation::operand) {
            ++operands;
            depths.push_back(0);
            continue;
        }
        if (step.operation > SolidOperation::clip)
            return fmt::format("step {}: no such operation of solids", i + 1);
        const bool is_inverse = step.operation == SolidOperation::inverse;
        if (step.count == 0 || step.count > depths.size() || (is_inverse && step.count != 1)) {
            return fmt::format("step {} of the solid: expected {} of the {} results before it, found {}",
                               i + 1, is_inverse ? "one" : "one or more", depths.size(), step.count);
        }
        const auto first = depths.end() - static_cast<std::ptrdiff_t>(step.count);
        const int depth = *std::max_element(first, depths.end()) + 1;
        if (depth > k_max_solid_depth)
            return fmt::format("expected operations nested at most {} deep", k_max_solid_depth);
        depths.erase(first, depths.end());
        depths.push_back(depth);
    }
    if (operands != tree.operands.size())
        return fmt::format("expected a step for each of the {} operands, found {}", tree.operands.size(),
                           operands);
    if (operands > k_max_solid_operands)
        return fmt::format("expected at most {} operands, found {}", k_max_solid_operands, operands);
    if (depths.size() != 1) return fmt::format("expected steps with one result, found {}", depths.size());
    return {};
}

}  // namespace glint
