// SPDX-License-Identifier: Apache-2.0
#pragma once
// Solids as Python objects.
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "shapes.h"

namespace glint::python {

/// A solid. Its parts do not change, so copies share them; those that Python gives and gets are copies. They
/// have no names and no colors, and parts that are solids also no materials and transforms, which are those
/// of their own parts: as in a scene, which has one SolidTree for all of it.
struct SolidBox : ShapeBox {
    SolidOperation operation = SolidOperation::merge;
    std::vector<std::shared_ptr<const ShapeBox>> parts;

    ShapeKind kind() const override { return ShapeKind::solid; }
    std::vector<std::shared_ptr<MaterialBox>> part_materials() const override;
    void set_part_materials(std::span<const std::shared_ptr<MaterialBox>> materials) override;
    void read(const Scene& scene, const Shape& shape) override;
    bool is_shape(const Scene& scene, std::uint32_t index,
                  std::span<const std::uint32_t> part_materials) const override;
    void write(Scene& scene, std::uint32_t index,
               std::span<const std::uint32_t> part_materials) const override;
    void append(Scene& scene, std::span<const std::uint32_t> part_materials) const override;
    std::shared_ptr<ShapeBox> copy() const override { return std::make_shared<SolidBox>(*this); }
    std::string text() const override;
    bool same(const ShapeBox& other) const override;

    py::tuple copied_parts() const;
    /// The steps, with operands that are not set.
    SolidTree tree() const;
    /// Replaces the shapes that the solid and the solids in it consist of by changed copies, in order.
    void change_operands(const std::function<void(ShapeBox&)>& change);
};

/// Null for other kinds.
const SolidBox* as_solid(const ShapeBox& shape);

/// The class, and the operators of all shapes that make one.
void bind_solid(py::module_& m, py::class_<ShapeBox, std::shared_ptr<ShapeBox>>& shape);

}  // namespace glint::python
