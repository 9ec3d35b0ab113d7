// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/primitives.h"

#include <span>
#include <type_traits>
#include <vector>

#include "geometry/kinds-inl.h"
#include "math/extent.h"
#include "math/transform.h"
#include "scene/closed_mesh.h"
#include "world/geometry/packed_mesh.h"
#include "world/geometry/triangulate.h"

namespace glint {

using namespace HWY_NAMESPACE;

namespace {

constexpr std::size_t k_cache_line = 64;

struct TraitsOf {
    ClassTraits traits;
    template <class Geometry> void visit() {
        traits.bakes_transform = Geometry::k_bakes_transform;
        traits.values = Geometry::k_values;
        traits.bounded = Geometry::k_bounded;
        traits.stores_box = traits.bounded && Geometry::k_stores_box;
        traits.only_operand = Geometry::k_only_operand;
    }
};

bool is_only_operand(ShapeKind kind) {
    return class_traits()[2 * static_cast<std::size_t>(kind)].only_operand;
}

// The largest number that the map adds up for a point of the box.
double map_magnitude(const Affine& map, Vec3 lo, Vec3 hi) {
    const double reach[3] = {number::max(-lo.x, hi.x), number::max(-lo.y, hi.y), number::max(-lo.z, hi.z)};
    double most = 0;
    for (const auto& row : map.m) {
        double sum = number::abs(row[3]);
        for (int k = 0; k < 3; ++k) sum += number::abs(row[k]) * number::abs(reach[k]);
        most = number::max(most, sum);
    }
    return most;
}

// The box of the corners of a box.
Extent mapped_box(const Affine& map, Vec3 lo, Vec3 hi) {
    Extent extent;
    for (int corner = 0; corner < 8; ++corner) {
        extent.add(transform_point(
            map, {corner & 1 ? hi.x : lo.x, corner & 2 ? hi.y : lo.y, corner & 4 ? hi.z : lo.z}));
    }
    return extent;
}

// What is in both boxes; a point of the first if nothing is.
Aabb common(const Aabb& a, const Aabb& b) {
    Aabb box;
    for (int k = 0; k < 3; ++k) {
        box.lo[k] = number::max(a.lo[k], b.lo[k]);
        box.hi[k] = number::min(a.hi[k], b.hi[k]);
        if (!(box.lo[k] <= box.hi[k])) return {{a.lo[0], a.lo[1], a.lo[2]}, {a.lo[0], a.lo[1], a.lo[2]}};
    }
    return box;
}

AllClassTraits find_class_traits() {
    AllClassTraits all;
    for (int c = 0; c < k_primitive_classes; ++c) {
        TraitsOf of;
        visit_geometry(static_cast<ShapeKind>(c / 2), c % 2 == 1, of);
        all[static_cast<std::size_t>(c)] = of.traits;
    }
    return all;
}

}  // namespace

const AllClassTraits& class_traits() {
    static const AllClassTraits all = find_class_traits();
    return all;
}

bool has_solids(const Scene& scene) {
    return !scene.get<Solid>().empty() || !scene.get<Quadric>().empty() || !scene.get<Quartic>().empty();
}

bool has_elements(const Scene& scene) {
    return !scene.get<Polygon>().empty() || !scene.get<Mesh>().empty() || has_solids(scene);
}

const PackedMesh& Primitives::mesh_of(const Shape& shape) const {
    return *meshes_[scene_.get<Mesh>()[shape.index].mesh];
}

void Primitives::add(std::uint32_t index) {
    const Shape& shape = scene_.shapes[index];
    if (shape.kind == ShapeKind::solid)
        return add_solid(index, scene_.solids[scene_.get<Solid>()[shape.index].solid]);
    if (is_only_operand(shape.kind)) {
        SolidTree& tree = single_.emplace_back();
        tree.operands.push_back({shape.kind, shape.index, k_none, k_none});
        tree.steps.push_back({SolidOperation::operand, 0});
        return add_solid(index, tree);
    }
    if (shape.kind != ShapeKind::polygon) {
        list_.push_back({index});
        return;
    }
    const Polygon& polygon = scene_.get<Polygon>()[shape.index];
    const auto first = static_cast<std::uint32_t>(triangles_.size());
    triangulate(std::span(scene_.polygon_vertices).subspan(polygon.first, polygon.count), triangles_);
    for (auto triangle = first; triangle < triangles_.size(); ++triangle)
        list_.push_back({index, triangle, triangle - first});
}

void Primitives::add_solid(std::uint32_t index, const SolidTree& tree) {
    const Shape& shape = scene_.shapes[index];
    const PrimitiveSolid solid{index, static_cast<std::uint32_t>(operands_.size()), &tree};
    list_.push_back({.shape = index, .solid = static_cast<std::uint32_t>(solids_.size())});
    solids_.push_back(solid);
    std::uint32_t element = 0;
    for (Shape operand : tree.operands) {
        if (operand.transform == k_none) {
            operand.transform = shape.transform;
        } else if (shape.transform != k_none) {
            composed_.push_back(
                compose(scene_.transforms[shape.transform], scene_.transforms[operand.transform]));
            operand.transform = static_cast<std::uint32_t>(scene_.transforms.size() + composed_.size() - 1);
        }
        list_.push_back(
            {.shape = index, .element = element++, .operand = static_cast<std::uint32_t>(operands_.size())});
        operands_.push_back(operand);
    }
}

void Primitives::add_all(bool cones) {
    one_per_shape_ =
        scene_.get<Polygon>().empty() && !has_solids(scene_) && (cones || scene_.get<Cone>().empty());
    if (one_per_shape_) return;
    list_.reserve(scene_.shapes.size());
    for (std::uint32_t i = 0; i < scene_.shapes.size(); ++i) {
        if (cones || scene_.shapes[i].kind != ShapeKind::cone) add(i);
    }
}

int Primitives::class_of(const Primitive& primitive) const {
    const Shape& s = shape_of(primitive);
    ShapeKind kind = primitive.solid == k_none ? s.kind : ShapeKind::solid;
    if (kind == ShapeKind::polygon) kind = ShapeKind::triangle;
    const int plain = 2 * static_cast<int>(kind);
    return plain + (s.transform != k_none && !class_traits()[static_cast<std::size_t>(plain)].bakes_transform
                        ? 1
                        : 0);
}

// The transform to pack with the primitive; none if it is applied to the parameters.
std::uint32_t Primitives::map_of(const Primitive& primitive) const {
    return class_of(primitive) % 2 == 1 ? shape_of(primitive).transform : k_none;
}

// Calls visit(parameters, geometry); the transform is applied to the parameters if the kind supports this.
template <class Parameters, class Geometry, class Visit>
void Primitives::visit_transformed(const Shape& shape, const Parameters& parameters, Geometry geometry,
                                   Visit&& visit) const {
    if constexpr (Geometry::k_bakes_transform) {
        if (shape.transform != k_none) {
            const Affine& map = this->map(shape.transform);
            // validate() has checked that the map is invertible.
            return visit(Geometry::apply_transform(parameters, map, inverse(map).value_or(Affine{})),
                         geometry);
        }
    }
    visit(parameters, geometry);
}

// Calls visit(parameters, geometry) for the primitive's kind.
template <class Visit> void Primitives::with_parameters(const Primitive& primitive, Visit&& visit) const {
    const Shape& shape = shape_of(primitive);
    if (primitive.triangle != k_none)
        return visit_transformed(shape, triangles_[primitive.triangle], TriangleGeometry(), visit);
    switch (shape.kind) {
#define GLINT_KIND(Type, word)                                                                  \
    case ShapeKind::word:                                                                       \
        if constexpr (k_is_packed<Type##Geometry> && Type##Geometry::k_has_formula) {           \
            visit_transformed(shape, scene_.get<Type>()[shape.index], Type##Geometry(), visit); \
        }                                                                                       \
        break;
        GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
    }
}

void Primitives::prefetch_parameters(std::uint32_t index) const {
    const Shape& shape = scene_.shapes[index];
    switch (shape.kind) {
#define GLINT_KIND(Type, word)                                                                               \
    case ShapeKind::word: {                                                                                  \
        const auto* at = reinterpret_cast<const char*>(&scene_.get<Type>()[shape.index]);                    \
        for (std::size_t byte = 0; byte < sizeof(Type); byte += k_cache_line) __builtin_prefetch(at + byte); \
        __builtin_prefetch(at + sizeof(Type) - 1);                                                           \
        break;                                                                                               \
    }
        GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
    }
}

// Padded for the rounding errors of mapped rays, beside those of every box.
Aabb Primitives::box_of_mesh(const Shape& shape) const {
    constexpr double k_map_error = 0x1p-40;
    const PackedMesh& mesh = mesh_of(shape);
    const Affine map = shape.transform == k_none ? Affine{} : this->map(shape.transform);
    const Extent box = mapped_box(map, mesh.lo, mesh.hi);
    const double pad = map_magnitude(map, mesh.lo, mesh.hi) * k_map_error;
    return padded_box(box.lo - Vec3{pad, pad, pad}, box.hi + Vec3{pad, pad, pad});
}

int Primitives::pack_mesh(const Shape& shape, double* values) const {
    const PackedMesh& mesh = mesh_of(shape);
    const Affine map = shape.transform == k_none ? Affine{} : this->map(shape.transform);
    const Affine object_from_world = shape.transform == k_none ? map : inverse(map).value_or(Affine{});
    int n = 0;
    for (const auto& row : object_from_world.m) {
        for (const double value : row) values[n++] = value;
    }
    values[MeshGeometry::k_mesh] = scene_.get<Mesh>()[shape.index].mesh;
    values[MeshGeometry::k_magnitude] = map_magnitude(map, mesh.lo, mesh.hi);
    return MeshGeometry::k_values;
}

// What contains the solid: its steps, applied to the operands' boxes. The outside of a shape has no ends.
Aabb Primitives::box_of_solid(const PrimitiveSolid& solid) const {
    const Aabb all{{-k_endless, -k_endless, -k_endless}, {k_endless, k_endless, k_endless}};
    std::vector<Aabb> boxes;
    std::uint32_t operand = solid.first;
    for (const SolidStep& step : solid.tree->steps) {
        if (step.operation == SolidOperation::operand) {
            boxes.push_back(box_of({.shape = solid.shape, .operand = operand++}));
            continue;
        }
        const std::size_t first = boxes.size() - step.count;
        Aabb box = boxes[first];
        for (std::size_t i = first + 1; i < boxes.size(); ++i) {
            if (step.operation == SolidOperation::merge || step.operation == SolidOperation::unite) {
                box.add(boxes[i]);
            } else if (step.operation != SolidOperation::difference) {
                box = common(box, boxes[i]);
            }
        }
        boxes.resize(first);
        boxes.push_back(step.operation == SolidOperation::inverse ? all : box);
    }
    return boxes.back();
}

Aabb Primitives::box_of(const Primitive& primitive) const {
    if (const Shape& shape = shape_of(primitive); shape.kind == ShapeKind::mesh) return box_of_mesh(shape);
    if (primitive.solid != k_none) return box_of_solid(solids_[primitive.solid]);
    Vec3 lo, hi;
    with_parameters(primitive,
                    [&](const auto& parameters, auto geometry) { geometry.bounds(parameters, lo, hi); });
    const std::uint32_t transform = map_of(primitive);
    if (transform != k_none && lo.x > -k_endless) {
        const Extent extent = mapped_box(map(transform), lo, hi);
        lo = extent.lo, hi = extent.hi;
    }
    return padded_box(lo, hi);
}

bool Primitives::is_turned_mesh(const Primitive& primitive) const {
    const Shape& shape = shape_of(primitive);
    return shape.kind == ShapeKind::mesh && is_inside_out(*mesh_of(shape).data);
}

bool Primitives::is_open(const Primitive& primitive) const {
    bool open = primitive.solid == k_none && !primitive.is_operand();  // as meshes are
    if (!open) return false;
    with_parameters(primitive,
                    [&](const auto& parameters, auto geometry) { open = geometry.is_open(parameters); });
    return open;
}

int Primitives::pack(const Primitive& primitive, double* values) const {
    if (const Shape& shape = shape_of(primitive); shape.kind == ShapeKind::mesh)
        return pack_mesh(shape, values);
    if (primitive.solid != k_none) {
        values[0] = primitive.solid;
        return 1;
    }
    int n = 0;
    with_parameters(primitive, [&](const auto& parameters, auto geometry) {
        static_assert(Transformed<decltype(geometry)>::k_values <= k_max_values);
        geometry.pack(parameters, values);
        n = decltype(geometry)::k_values;
    });
    if (const std::uint32_t map = map_of(primitive); map != k_none) {
        const Affine object_from_world = inverse(this->map(map)).value_or(Affine{});
        for (const auto& row : object_from_world.m) {
            for (const double value : row) values[n++] = value;
        }
    }
    return n;
}

bool is_closed(const Scene& scene, std::uint32_t shape) {
    const ShapeKind kind = scene.shapes[shape].kind;
    if (kind == ShapeKind::polygon || kind == ShapeKind::mesh || kind == ShapeKind::solid ||
        is_only_operand(kind))
        return false;
    const PackedMeshes none;
    return !Primitives(scene, none).is_open({shape});
}

}  // namespace glint
