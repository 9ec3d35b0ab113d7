// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a scene's shapes are packed as: primitives, one a shape, or one a triangle of a polygon.
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "glint/scene.h"
#include "math/aabb.h"

namespace glint {

// A class is a kind, transformed or not. Kinds that take a map into their own parameters are never
// transformed.
inline constexpr int k_primitive_classes = 2 * k_shape_kinds;

struct Primitive {
    std::uint32_t shape = 0;          // the index in Scene::shapes
    std::uint32_t triangle = k_none;  // of a polygon: the index in Primitives::triangles
    std::uint32_t piece = 0;          // of a polygon: which of its triangles
};

/// What a class says of itself.
struct ClassTraits {
    int values = 0;          // of a packed primitive
    bool bounded = true;     // it has a box
    bool stores_box = true;  // a triangle's is computed
    bool bakes_transform = false;
};
using AllClassTraits = std::array<ClassTraits, k_primitive_classes>;
const AllClassTraits& class_traits();

/// Packs the shapes of a valid scene one by one.
class Primitives {
  public:
    explicit Primitives(const Scene& scene) : scene_(scene) {}

    /// Appends the shape's primitives. Polygons are cut into triangles here.
    void add(std::uint32_t shape);
    /// All of the scene's; cones: whether they are among them.
    void add_all(bool cones);

    std::vector<Primitive>& list() { return list_; }
    const std::vector<Primitive>& list() const { return list_; }

    int class_of(const Primitive& primitive) const;
    /// The padded box of a bounded primitive.
    Aabb box_of(const Primitive& primitive) const;
    /// Whether it is a surface that encloses no space.
    bool is_open(const Primitive& primitive) const;

    /// Has memory bring what pack() and the others will read of a shape: first the shape, and once that is
    /// here, its parameters. Shapes are packed in another order than the scene's, and waiting for them costs
    /// more than all else.
    void prefetch_shape(std::uint32_t shape) const { __builtin_prefetch(&scene_.shapes[shape]); }
    void prefetch_parameters(std::uint32_t shape) const;
    static constexpr std::size_t k_prefetch_distance = 12;  // shapes from one step to the next

    static constexpr int k_max_values = 64;
    /// Writes its packed values and returns how many.
    int pack(const Primitive& primitive, double* values) const;

  private:
    std::uint32_t map_of(const Primitive& primitive) const;
    template <class Parameters, class Geometry, class Visit>
    void visit_transformed(const Shape& shape, const Parameters& parameters, Geometry geometry,
                           Visit&& visit) const;
    template <class Visit> void with_parameters(const Primitive& primitive, Visit&& visit) const;

    const Scene& scene_;
    std::vector<Primitive> list_;
    std::vector<Triangle> triangles_;
};

/// Whether a shape of the scene encloses a space: no ray gets in or out without meeting it.
bool is_closed(const Scene& scene, std::uint32_t shape);

}  // namespace glint
