// SPDX-License-Identifier: Apache-2.0
#include "solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "scene/solid_steps.h"

namespace glint::python {
namespace {

void visit_operands(const SolidBox& solid, const std::function<void(const ShapeBox&)>& visit) {
    for (const auto& part : solid.parts) {
        if (const SolidBox* const inner = as_solid(*part)) {
            visit_operands(*inner, visit);
        } else {
            visit(*part);
        }
    }
}

void add_steps(const SolidBox& solid, SolidTree& tree) {
    for (const auto& part : solid.parts) {
        if (const SolidBox* const inner = as_solid(*part)) {
            add_steps(*inner, tree);
        } else {
            tree.operands.emplace_back();
            tree.steps.push_back({SolidOperation::operand, 0});
        }
    }
    tree.steps.push_back({solid.operation, static_cast<std::uint32_t>(solid.parts.size())});
}

// The part that step number `step` of a scene's solid is.
std::shared_ptr<ShapeBox> read_step(const Scene& scene, const SolidTree& tree, const SolidSteps& steps,
                                    std::size_t step) {
    if (steps.is_operand(step)) {
        const Shape& operand = tree.operands[steps.operand(step)];
        auto shape = read_shape(scene, operand);
        if (operand.transform != k_none) shape->transform = scene.transforms[operand.transform];
        return shape;
    }
    auto solid = std::make_shared<SolidBox>();
    solid->operation = steps.operation(step);
    for (const std::size_t part : steps.parts(step))
        solid->parts.push_back(read_step(scene, tree, steps, part));
    return solid;
}

// Whether they are the same but for materials.
bool have_same_form(const SolidBox& a, const SolidBox& b) {
    return a.operation == b.operation &&
           std::equal(a.parts.begin(), a.parts.end(), b.parts.begin(), b.parts.end(),
                      [](const auto& x, const auto& y) {
                          const SolidBox *const p = as_solid(*x), *const q = as_solid(*y);
                          if (p != nullptr && q != nullptr) return have_same_form(*p, *q);
                          return x->same(*y) && x->transform == y->transform;
                      });
}

}  // namespace

const SolidBox* as_solid(const ShapeBox& shape) { return dynamic_cast<const SolidBox*>(&shape); }

std::vector<std::shared_ptr<MaterialBox>> SolidBox::part_materials() const {
    std::vector<std::shared_ptr<MaterialBox>> materials;
    visit_operands(*this, [&](const ShapeBox& operand) { materials.push_back(operand.material); });
    return materials;
}
void SolidBox::set_part_materials(std::span<const std::shared_ptr<MaterialBox>> materials) {
    std::size_t next = 0;
    change_operands([&](ShapeBox& operand) { operand.material = materials[next++]; });
}
void SolidBox::change_operands(const std::function<void(ShapeBox&)>& change) {
    for (auto& part : parts) {
        std::shared_ptr<ShapeBox> changed = part->copy();
        if (auto* const inner = dynamic_cast<SolidBox*>(changed.get())) {
            inner->change_operands(change);
        } else {
            change(*changed);
        }
        part = std::move(changed);
    }
}
void SolidBox::read(const Scene& scene, const Shape& shape) {
    const SolidTree& tree = scene.solids[scene.get<Solid>()[shape.index].solid];
    const SolidSteps steps(tree);
    const auto whole = read_step(scene, tree, steps, steps.root());
    if (const SolidBox* const solid = as_solid(*whole)) {
        operation = solid->operation;
        parts = solid->parts;
    } else {  // of one shape
        operation = SolidOperation::merge;
        parts = {whole};
    }
}
SolidTree SolidBox::tree() const {
    SolidTree tree;
    add_steps(*this, tree);
    return tree;
}
bool SolidBox::is_shape(const Scene& scene, std::uint32_t index,
                        std::span<const std::uint32_t> part_materials) const {
    const Shape& shape = scene.shapes[index];
    if (shape.kind != ShapeKind::solid ||
        !std::ranges::equal(operands_of(scene, shape), part_materials, {}, &Shape::material))
        return false;
    SolidBox now;
    now.read(scene, shape);
    return have_same_form(*this, now);
}
void SolidBox::write(Scene& scene, std::uint32_t index, std::span<const std::uint32_t> part_materials) const {
    if (is_shape(scene, index, part_materials)) return;
    append(scene, part_materials);
    const std::uint32_t last = scene.shapes.back().index;
    scene.shapes.pop_back();
    scene.shapes[index].kind = ShapeKind::solid;
    scene.shapes[index].index = last;
}
void SolidBox::append(Scene& scene, std::span<const std::uint32_t> part_materials) const {
    const auto first = static_cast<std::uint32_t>(scene.shapes.size());
    for (const auto& part : parts) {
        const SolidBox* const inner = as_solid(*part);
        const std::size_t count = inner == nullptr ? 1 : inner->part_materials().size();
        part->append(scene, part_materials.first(count));
        if (inner == nullptr) scene.shapes.back().material = part_materials.front();
        part_materials = part_materials.subspan(count);
        if (!part->transform) continue;
        scene.transforms.push_back(*part->transform);
        scene.shapes.back().transform = static_cast<std::uint32_t>(scene.transforms.size() - 1);
    }
    combine_last(scene, operation, first);
}
py::tuple SolidBox::copied_parts() const {
    py::tuple copies(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) copies[i] = parts[i]->copy();
    return copies;
}
std::string SolidBox::text() const {
    return fmt::format("operation='{}', parts={}", to_string(operation), repr_of(copied_parts()));
}
bool SolidBox::same(const ShapeBox& other) const {
    const SolidBox* const solid = as_solid(other);
    return solid != nullptr && operation == solid->operation &&
           std::equal(parts.begin(), parts.end(), solid->parts.begin(), solid->parts.end(),
                      [](const auto& a, const auto& b) { return a->same(*b) && same_look(*a, *b); });
}

}  // namespace glint::python
