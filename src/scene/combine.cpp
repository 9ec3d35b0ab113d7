// SPDX-License-Identifier: Apache-2.0
// Shapes that become a solid.
#include <algorithm>

#include "glint/scene.h"
#include "math/transform.h"

namespace glint {
namespace {

// Index of `outer` after `inner`.
std::uint32_t compose_transforms(Scene& scene, std::uint32_t outer, std::uint32_t inner) {
    if (outer == k_none) return inner;
    if (inner == k_none) return outer;
    scene.transforms.push_back(compose(scene.transforms[outer], scene.transforms[inner]));
    return static_cast<std::uint32_t>(scene.transforms.size() - 1);
}

}  // namespace

SolidTree combine(Scene& scene, SolidOperation operation, std::span<const Shape> parts) {
    SolidTree tree;
    for (const Shape& part : parts) {
        // Of an invalid solid, validate() tells.
        if (operands_of(scene, part).empty()) {
            tree.operands.push_back(part);
            tree.steps.push_back({SolidOperation::operand, 0});
            continue;
        }
        const std::uint32_t solid = scene.get<Solid>()[part.index].solid;
        for (std::size_t i = 0; i < scene.solids[solid].operands.size(); ++i) {
            Shape operand = scene.solids[solid].operands[i];
            operand.transform = compose_transforms(scene, part.transform, operand.transform);
            if (operand.material == k_none) operand.material = part.material;
            tree.operands.push_back(operand);
        }
        const std::vector<SolidStep>& steps = scene.solids[solid].steps;
        tree.steps.insert(tree.steps.end(), steps.begin(), steps.end());
    }
    tree.steps.push_back({operation, static_cast<std::uint32_t>(parts.size())});
    return tree;
}

std::uint32_t combine_last(Scene& scene, SolidOperation operation, std::uint32_t first,
                           std::uint32_t material, std::uint32_t transform) {
    if (first >= scene.shapes.size()) return k_none;
    SolidTree tree = combine(scene, operation, std::span(scene.shapes).subspan(first));
    // Solids that only this one has.
    for (std::size_t i = scene.shapes.size(); i-- > first;) {
        const Shape& part = scene.shapes[i];
        if (part.kind != ShapeKind::solid || part.index + 1 != scene.get<Solid>().size()) continue;
        if (scene.get<Solid>().back().solid + 1 == scene.solids.size()) scene.solids.pop_back();
        scene.get<Solid>().pop_back();
    }
    scene.shapes.resize(first);
    if (scene.shape_colors.size() > first) scene.shape_colors.resize(first);
    scene.solids.push_back(std::move(tree));
    return scene.add(Solid{static_cast<std::uint32_t>(scene.solids.size() - 1)}, material, transform);
}

}  // namespace glint
