// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/pack_solid.h"

#include <limits>
#include <utility>
#include <vector>

#include "bvh/rays.h"
#include "math/number.h"
#include "scene/solid_steps.h"

namespace glint {
namespace {

constexpr float k_infinite = std::numeric_limits<float>::infinity();

// The steps in the order of the kernels, from the last step down: a step begins before its parts.
class ItemList {
  public:
    explicit ItemList(const SolidTree& tree) : steps_(tree), inverted_(tree.operands.size()) {
        append(steps_.root(), false);
    }

    std::vector<SolidItem> take() { return std::move(items_); }
    bool is_inverted(std::size_t operand) const { return inverted_[operand]; }

  private:
    void append(std::size_t step, bool inverted) {
        const SolidOperation operation = steps_.operation(step);
        if (steps_.is_operand(step)) {
            const std::uint32_t operand = steps_.operand(step);
            inverted_[operand] = inverted;
            items_.push_back({SolidItem::Kind::operand, operation, operand});
            return;
        }
        items_.push_back({SolidItem::Kind::begin, operation, 0});
        const std::vector<std::size_t> parts = steps_.parts(step);
        for (const std::size_t part : parts) {
            const bool turns = operation == SolidOperation::inverse ||
                               (operation == SolidOperation::difference && part != parts.front());
            append(part, inverted != turns);
        }
        items_.push_back({SolidItem::Kind::end, operation, 0});
    }

    const SolidSteps steps_;
    std::vector<bool> inverted_;
    std::vector<SolidItem> items_;
};

}  // namespace

PackedSolid pack_solid(const Primitives& primitives, const PrimitiveSolid& solid,
                       std::span<const std::uint32_t> slots, std::uint32_t first,
                       std::span<PackedOperand> operands) {
    const SolidTree& tree = *solid.tree;
    ItemList list(tree);
    PackedSolid packed;
    const std::size_t count = tree.operands.size();
    for (int a = 0; a < 3; ++a) {
        packed.lo[a].assign(count + k_ray_padding, -k_infinite);
        packed.hi[a].assign(count + k_ray_padding, k_infinite);
    }
    packed.slots.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        const Primitive primitive{.shape = solid.shape, .element = i, .operand = solid.first + i};
        const std::uint32_t slot = slots[primitive.operand];
        packed.slots.push_back(slot);
        PackedOperand& operand = operands[slot - first];
        operand.is_inverted = list.is_inverted(i) != primitives.is_turned_mesh(primitive);
        operand.has_material = tree.operands[i].material != k_none;
        if (!class_traits()[static_cast<std::size_t>(primitives.class_of(primitive))].bounded) continue;
        const Aabb box = primitives.box_of(primitive);
        for (int a = 0; a < 3; ++a) {
            packed.lo[a][i] = box.lo[a], packed.hi[a][i] = box.hi[a];
            operand.reach = number::max(operand.reach, number::max(-box.lo[a], box.hi[a]));
        }
    }
    packed.items = list.take();
    return packed;
}

}  // namespace glint
