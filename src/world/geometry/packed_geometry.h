// SPDX-License-Identifier: Apache-2.0
#pragma once
// The part of a World that takes time to build: packed shapes and the hierarchy over them. It contains no
// materials, lights, camera, conventions or settings.
#include <cstdint>
#include <memory>
#include <vector>

#include "bvh/refit.h"
#include "glint/mesh.h"
#include "glint/shapes.h"
#include "glint/vec.h"
#include "world/geometry/packed_solid.h"
#include "world/geometry/surface_id.h"

namespace glint {

struct EditIndex;
struct PackedMesh;
class SharedEditIndex;

/// By index in Scene::meshes; null if no shape has the mesh.
using PackedMeshes = std::vector<std::shared_ptr<const PackedMesh>>;

/// Shapes of one kind, transformed or not, packed as columns: value k of the class's item i is values[k *
/// stride + i].
struct ShapeClass {
    ShapeKind kind = ShapeKind::sphere;
    bool transformed = false;
    std::uint32_t first = 0;  // its items are the slots [first, first + count) of the geometry
    std::uint32_t count = 0;
    std::uint32_t stride = 0;  // count plus a vector of padding
    std::vector<double> values;
    // Triangles of a mesh: the numbers of their vertices in it, as three columns, instead of `values`.
    const MeshData* mesh = nullptr;
    std::vector<std::uint32_t> corners;
    const double* column(int k) const { return values.data() + static_cast<std::size_t>(k) * stride; }
    double value(int k, std::uint32_t slot) const { return column(k)[slot - first]; }
    const std::uint32_t* corner_column(int k) const {
        return corners.data() + static_cast<std::size_t>(k) * stride;
    }
};

/// Slots are the positions of packed shapes; each triangle of a polygon or of a mesh by itself has a slot of
/// its own, and so has each operand of a solid. The bounded ones are in the hierarchy's leaf order within
/// their class; the unbounded ones follow, then the operands, which rays meet only through their solid. All
/// arrays by slot are padded by vector.
struct PackedGeometry {
    std::vector<ShapeClass> classes;          // bounded classes first
    std::uint32_t boxed = 0;                  // slots below this have a stored box
    std::uint32_t bounded = 0;                // slots below this are in the hierarchy
    std::uint32_t count = 0;                  // the number of slots
    Bvh bvh;                                  // its leaves refer to slots
    std::vector<float> box_lo[3], box_hi[3];  // by slot: the shape's padded bounds; computed for triangles
    std::vector<std::uint32_t> shape_index;   // by slot: the index in Scene::shapes
    std::vector<std::uint32_t> element;       // by slot: SurfaceId::element; empty: 0
    PackedMeshes meshes;                      // the shapes of the kind `mesh` refer to them
    std::vector<PackedSolid> solids;          // the shapes of the kind `solid` refer to them
    std::vector<PackedOperand> operands;      // of the slots from first_operand() on
    std::vector<std::uint8_t> open;           // by slot: 1 if the shape encloses no space
    std::uint32_t scene_shapes = 0;           // the number of the scene's shapes
    bool has_mesh_colors = false;             // one of `meshes` has colors
    bool has_cones = false;                   // the scene has cones, packed or omitted by the conventions
    std::shared_ptr<SharedEditIndex> shared_index;  // of this geometry and its copies
    std::shared_ptr<const EditIndex> edit_index;    // set by the first edit
    BvhCost cost;           // of the current hierarchy; kept up to date once there is an edit_index
    double built_cost = 0;  // expected(), when it was built, of a hierarchy that was spliced since; else 0

    /// The expected cost when the hierarchy was built.
    double expected_built_cost() const;
    /// Sets `meshes`.
    void set_meshes(PackedMeshes packed);
    std::uint32_t first_operand() const { return count - static_cast<std::uint32_t>(operands.size()); }
    /// Null if the slot is not an operand's.
    const PackedOperand* operand_of(std::uint32_t slot) const {
        return slot < first_operand() ? nullptr : &operands[slot - first_operand()];
    }
    /// Whether the slot's normal is turned: of an operand that its solid is outside of.
    bool is_inverted(std::uint32_t slot) const {
        const PackedOperand* const operand = operand_of(slot);
        return operand != nullptr && operand->is_inverted;
    }
    /// Whether the slot is an operand's that has a material of its own.
    bool has_own_material(std::uint32_t slot) const {
        const PackedOperand* const operand = operand_of(slot);
        return operand != nullptr && operand->has_material;
    }
    /// Whether a shape may have several elements.
    bool has_elements() const { return !element.empty(); }
    std::uint32_t element_of(std::uint32_t slot) const { return has_elements() ? element[slot] : 0; }
    SurfaceId surface_of(std::uint32_t slot) const { return {slot, element_of(slot)}; }
    /// The index in Scene::shapes of a surface's shape.
    std::uint32_t shape_of(SurfaceId id) const { return shape_index[id.slot]; }
    /// The operand of a solid that has the surface; of other shapes its element.
    std::uint32_t part_of(SurfaceId id) const {
        return id.slot < first_operand() ? id.element : element_of(id.slot);
    }
    /// Whether a surface is in the hierarchy, or its solid is.
    bool is_bounded(SurfaceId id) const { return id.slot < bounded || id.slot >= first_operand(); }
    /// Whether a surface's shape encloses no space: `facing = open` applies to it.
    bool is_open(SurfaceId id) const { return open[id.slot] != 0; }
    /// Whether surface a comes before b where a ray hits both at one t: by the order of the shapes in the
    /// scene, then by the order of their elements.
    bool precedes(SurfaceId a, SurfaceId b) const {
        const std::uint32_t shape_a = shape_of(a), shape_b = shape_of(b);
        return shape_a != shape_b ? shape_a < shape_b : a.element < b.element;
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

/// The normals of a surface at a point of it, not turned to any ray.
struct SurfaceNormals {
    Vec3 shading;  // unit; interpolated if the shape has vertex normals
    Vec3 face;     // that of the face, of any length: it tells which side a ray comes from
};
SurfaceNormals surface_normals(const PackedGeometry& geometry, SurfaceId id, Vec3 point);

}  // namespace glint
