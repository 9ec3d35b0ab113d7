// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shapes as Python objects.
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "glint/scene.h"
#include "items.h"

namespace glint::python {

/// A shape that Python refers to, with its material, its own color and its transform.
struct ShapeBox {
    std::shared_ptr<MaterialBox> material;  ///< null: the default material
    std::optional<Color> color;             ///< the shape's own, in single precision
    std::optional<Affine> transform;        ///< world_from_object
    std::string name;

    virtual ~ShapeBox() = default;
    virtual ShapeKind kind() const = 0;
    /// The materials of a solid's parts in the order of SolidTree::operands, null for the solid's; nothing of
    /// other kinds. A scene has numbers for them, which the functions below take.
    virtual std::vector<std::shared_ptr<MaterialBox>> part_materials() const { return {}; }
    virtual void set_part_materials(std::span<const std::shared_ptr<MaterialBox>>) {}
    /// Takes the parameters of a shape of the same kind, without the materials of parts.
    virtual void read(const Scene& scene, const Shape& shape) = 0;
    /// Whether the parameters are those of shape number `index` of the scene.
    virtual bool is_shape(const Scene& scene, std::uint32_t index,
                          std::span<const std::uint32_t> part_materials) const = 0;
    /// Makes them those of shape number `index`, which may be of another kind.
    virtual void write(Scene& scene, std::uint32_t index,
                       std::span<const std::uint32_t> part_materials) const = 0;
    /// Adds a shape with these parameters to the scene.
    virtual void append(Scene& scene, std::span<const std::uint32_t> part_materials) const = 0;
    virtual std::shared_ptr<ShapeBox> copy() const = 0;
    /// The parameters as in a call: "center=(0.0, 1.0, 0.0), radius=1.0".
    virtual std::string text() const = 0;
    virtual bool same(const ShapeBox& other) const = 0;
};

/// The parameters of a shape of the scene, without materials, color, transform and name.
std::shared_ptr<ShapeBox> read_shape(const Scene& scene, const Shape& shape);

/// Whether they have the same color, transform and material.
bool same_look(const ShapeBox& a, const ShapeBox& b);

/// Sets one of the attributes that every kind has: material, color, transform, name. False for other words.
bool set_common(ShapeBox& shape, const std::string& name, const py::handle& value);

void bind_shapes(py::module_& m);

}  // namespace glint::python
