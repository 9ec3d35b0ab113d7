// SPDX-License-Identifier: Apache-2.0
#pragma once
// The primitives of a scene's shapes: one per shape, or one per triangle of a polygon. A solid has one for
// itself and one for each operand.
#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "glint/scene.h"
#include "math/aabb.h"
#include "world/geometry/packed_geometry.h"

namespace glint {

// A class is a kind, with or without a transform. Kinds that apply the transform to their own parameters
// have no transformed class.
inline constexpr int k_primitive_classes = 2 * k_shape_kinds;

struct Primitive {
    std::uint32_t shape = 0;          // the index in Scene::shapes
    std::uint32_t triangle = k_none;  // for a polygon: the index in Primitives::triangles
    std::uint32_t element = 0;  // SurfaceId::element: the number of the polygon's triangle, or the operand
    std::uint32_t operand = k_none;  // the index in Primitives::operands
    std::uint32_t solid = k_none;    // of a solid itself: the index in Primitives::solids

    bool is_operand() const { return operand != k_none; }
};

/// The solid of a shape: its operands are the primitives [first, first + count) of Primitives::operands.
struct PrimitiveSolid {
    std::uint32_t shape = 0, first = 0;
    const SolidTree* tree = nullptr;
};

/// Whether a shape of the scene is packed as a solid.
bool has_solids(const Scene& scene);

/// Whether a shape of the scene has several elements.
bool has_elements(const Scene& scene);

/// Properties of a class.
struct ClassTraits {
    int values = 0;          // number of values of a packed primitive
    bool bounded = true;     // it has a box
    bool stores_box = true;  // else it is computed
    bool bakes_transform = false;
    bool only_operand = false;
};
/// The packer's order of classes: those that store their boxes, those with computed ones, unbounded ones.
inline int layout_rank(const ClassTraits& traits) { return 2 - traits.bounded - traits.stores_box; }
using AllClassTraits = std::array<ClassTraits, k_primitive_classes>;
const AllClassTraits& class_traits();

/// Packs the shapes of a valid scene one by one.
class Primitives {
  public:
    /// meshes: those of the scene, packed.
    Primitives(const Scene& scene, const PackedMeshes& meshes) : scene_(scene), meshes_(meshes) {}

    /// Appends the primitives of a shape. Triangulates polygons.
    void add(std::uint32_t shape);
    /// Appends those of all shapes; cones: whether to include cones.
    void add_all(bool cones);

    std::size_t size() const { return one_per_shape_ ? scene_.shapes.size() : list_.size(); }
    Primitive operator[](std::size_t i) const {
        return one_per_shape_ ? Primitive{static_cast<std::uint32_t>(i), k_none, 0} : list_[i];
    }

    int class_of(const Primitive& primitive) const;
    std::span<const PrimitiveSolid> solids() const { return solids_; }
    /// The padded box; of a shape without ends, from -k_endless to k_endless.
    Aabb box_of(const Primitive& primitive) const;
    /// Whether the primitive is a closed mesh whose normals point inwards.
    bool is_turned_mesh(const Primitive& primitive) const;
    /// Whether the primitive's shape encloses no space.
    bool is_open(const Primitive& primitive) const;

    void prefetch(std::uint32_t i) const {
        if (!one_per_shape_) __builtin_prefetch(&list_[i]);
    }
    /// Prefetches what pack() and the others will read of a shape: first the shape, then its parameters. The
    /// order of packing differs from the scene's, and without prefetching, most of the time would be spent
    /// waiting for memory.
    void prefetch_shape(std::uint32_t shape) const { __builtin_prefetch(&scene_.shapes[shape]); }
    void prefetch_parameters(std::uint32_t shape) const;
    static constexpr std::size_t k_prefetch_distance = 12;  // shapes from one step to the next

    static constexpr int k_max_values = 64;
    /// Writes the packed values and returns their number.
    int pack(const Primitive& primitive, double* values) const;

  private:
    const Shape& shape_of(const Primitive& primitive) const {
        return primitive.is_operand() ? operands_[primitive.operand] : scene_.shapes[primitive.shape];
    }
    const Affine& map(std::uint32_t transform) const {
        const std::size_t of_scene = scene_.transforms.size();
        return transform < of_scene ? scene_.transforms[transform] : composed_[transform - of_scene];
    }
    std::uint32_t map_of(const Primitive& primitive) const;
    void add_solid(std::uint32_t shape, const SolidTree& tree);
    Aabb box_of_solid(const PrimitiveSolid& solid) const;
    template <class Parameters, class Geometry, class Visit>
    void visit_transformed(const Shape& shape, const Parameters& parameters, Geometry geometry,
                           Visit&& visit) const;
    template <class Visit> void with_parameters(const Primitive& primitive, Visit&& visit) const;
    const PackedMesh& mesh_of(const Shape& shape) const;
    Aabb box_of_mesh(const Shape& shape) const;
    int pack_mesh(const Shape& shape, double* values) const;

    const Scene& scene_;
    const PackedMeshes& meshes_;
    bool one_per_shape_ = false;  // add_all() found that primitive i is shape i: no list is needed
    std::vector<Primitive> list_;
    std::vector<Triangle> triangles_;
    std::vector<PrimitiveSolid> solids_;
    std::deque<SolidTree> single_;  // of shapes that rays hit as operands only
    std::vector<Shape> operands_;   // with the solids' transforms
    std::vector<Affine> composed_;  // continues the scene's transforms
};

/// Whether a shape encloses a space that no ray can enter or leave without hitting the shape.
bool is_closed(const Scene& scene, std::uint32_t shape);

}  // namespace glint
