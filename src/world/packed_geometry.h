// SPDX-License-Identifier: Apache-2.0
#pragma once
// The part of a World that takes time to build: packed shapes and the hierarchy over them. It contains no
// materials, lights, camera, conventions or settings.
#include <cstdint>
#include <memory>
#include <vector>

#include "bvh/refit.h"
#include "glint/shapes.h"
#include "glint/vec.h"

namespace glint {

struct EditIndex;
class SharedEditIndex;

/// Shapes of one kind, transformed or not, packed as columns: value k of the class's item i is values[k *
/// stride + i].
struct ShapeClass {
    ShapeKind kind = ShapeKind::sphere;
    bool transformed = false;
    std::uint32_t first = 0;  // its items are the slots [first, first + count) of the geometry
    std::uint32_t count = 0;
    std::uint32_t stride = 0;  // count plus a vector of padding
    std::vector<double> values;
    const double* column(int k) const { return values.data() + static_cast<std::size_t>(k) * stride; }
};

/// Slots are the positions of packed shapes; each triangle of a polygon has its own. The bounded ones are in
/// the hierarchy's leaf order within their class; the unbounded ones follow. All arrays by slot are padded by
/// vector.
struct PackedGeometry {
    std::vector<ShapeClass> classes;          // bounded classes first
    std::uint32_t boxed = 0;                  // slots below this have a stored box
    std::uint32_t bounded = 0;                // slots below this are in the hierarchy
    std::uint32_t count = 0;                  // the number of slots
    Bvh bvh;                                  // its leaves refer to slots
    std::vector<float> box_lo[3], box_hi[3];  // by slot: the shape's padded bounds; computed for triangles
    std::vector<std::uint32_t> shape_index;   // by slot: the index in Scene::shapes
    std::vector<std::uint32_t> piece;         // by slot: the polygon's triangle, from 0; k_open_shape
    std::uint32_t scene_shapes = 0;           // the number of the scene's shapes
    bool has_cones = false;                   // the scene has cones, packed or omitted by the conventions
    std::shared_ptr<SharedEditIndex> shared_index;  // of this geometry and its copies
    std::shared_ptr<const EditIndex> edit_index;    // set by the first edit
    BvhCost cost;  // of the current hierarchy; kept up to date once there is an edit_index

    static constexpr std::uint32_t k_open_shape = 0x80000000u;
    std::uint32_t piece_of(std::uint32_t slot) const { return piece[slot] & ~k_open_shape; }
    /// Whether the shape encloses no space: `facing = open` applies to it.
    bool is_open(std::uint32_t slot) const { return (piece[slot] & k_open_shape) != 0; }

    bool is_smooth_triangle(std::uint32_t slot) const {
        return class_of(slot).kind == ShapeKind::smooth_triangle;
    }
    /// Of a smooth triangle a, b, c: (b - a) x (c - a), of any length.
    Vec3 face_normal(std::uint32_t slot) const {
        const ShapeClass& shapes = class_of(slot);
        const std::uint32_t item = slot - shapes.first;
        const auto vertex = [&](int k) {
            return Vec3{shapes.column(k)[item], shapes.column(k + 1)[item], shapes.column(k + 2)[item]};
        };
        return cross(vertex(3) - vertex(0), vertex(6) - vertex(0));
    }

    /// The class of a slot.
    const ShapeClass& class_of(std::uint32_t slot) const { return classes[class_index(slot)]; }
    ShapeClass& class_of(std::uint32_t slot) { return classes[class_index(slot)]; }

  private:
    std::size_t class_index(std::uint32_t slot) const {
        std::size_t c = 0;
        while (slot - classes[c].first >= classes[c].count) ++c;
        return c;
    }
};

/// The unit normal of a slot's shape at a point of it.
Vec3 primitive_normal(const PackedGeometry& geometry, std::uint32_t slot, Vec3 point);

}  // namespace glint
