// SPDX-License-Identifier: Apache-2.0
#pragma once
// Meshes as Python objects.
#include <memory>
#include <string>

#include "shapes.h"

namespace glint::python {

/// A mesh, whose data it shares with the scenes that have it.
struct MeshBox : ShapeBox {
    std::shared_ptr<const MeshData> data = std::make_shared<const MeshData>();

    void read(const Scene& scene, const Shape& shape) override {
        data = scene.meshes[scene.get<Mesh>()[shape.index].mesh];
    }
    ShapeKind kind() const override { return ShapeKind::mesh; }
    bool is_shape(const Scene& scene, std::uint32_t index,
                  std::span<const std::uint32_t> part_materials) const override;
    void write(Scene& scene, std::uint32_t index,
               std::span<const std::uint32_t> part_materials) const override;
    void append(Scene& scene, std::span<const std::uint32_t> part_materials) const override;
    std::shared_ptr<ShapeBox> copy() const override { return std::make_shared<MeshBox>(*this); }
    std::string text() const override;
    bool same(const ShapeBox& other) const override;
};

void bind_mesh(py::module_& m);

}  // namespace glint::python
