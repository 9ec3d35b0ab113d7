// SPDX-License-Identifier: Apache-2.0
#include "export/gltf/shapes.h"

#include <algorithm>
#include <utility>

#include "export/gltf/own_meshes.h"
#include "export/gltf/placement.h"
#include "export/gltf/unit_shapes.h"
#include "math/number.h"
#include "math/transform.h"
#include "world/geometry/triangulate.h"

namespace glint::gltf_export {
namespace {

constexpr double k_plane = 30;  // half the side of a plane's square, times the scene's radius

constexpr double k_largest = 1e11;  // half the side, at most: coordinates have a limit

// A frame whose z axis is `axis`, of any length; x and y have the length `across`.
Affine frame(Vec3 origin, Vec3 axis, double across) {
    const Vec3 z = normalize(axis);
    const Vec3 other = number::abs(z.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 x = normalize(cross(other, z)), y = cross(z, x);
    return {{{x.x * across, y.x * across, axis.x, origin.x},
             {x.y * across, y.y * across, axis.y, origin.y},
             {x.z * across, y.z * across, axis.z, origin.z}}};
}

Extent box_of(const MeshData& mesh) {
    Extent box;
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) box.add(mesh.position(v));
    return box;
}

// Appends a triangle with vertices of its own; of flat ones, the normals are (0, 0, 0).
void append(MeshData& to, const Vec3 (&vertices)[3], const Vec3* normals) {
    TriangleCorners corners;
    for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = static_cast<std::uint32_t>(to.positions.size());
        to.positions.push_back(vertices[k]);
        to.normals.values.push_back(normals != nullptr ? to_single(normalize(normals[k])) : Float3{});
    }
    to.triangles.push_back(corners);
}

}  // namespace

ShapeMeshes::ShapeMeshes(const Scene& scene, const Affine& file_from_world, Losses& losses)
    : scene_(scene), file_from_world_(file_from_world), losses_(losses) {
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) add(i);
    measure();
    for (PlacedMesh& placed : placed_) {
        if (placed.mesh == nullptr) place_plane(placed, scene.shapes[placed.shape]);
        finish(placed);
    }
}

void ShapeMeshes::add_ball(const Extent& box) {
    balls_.push_back({(box.lo + box.hi) / 2, length(box.hi - box.lo) / 2});
}

void ShapeMeshes::measure() {
    std::map<const MeshData*, Extent> boxes;
    for (const PlacedMesh& placed : placed_) {
        if (placed.mesh == nullptr) continue;
        const auto [known, is_new] = boxes.try_emplace(placed.mesh);
        if (is_new) known->second = box_of(*placed.mesh);
        const Extent& box = known->second;
        if (!(box.lo.x <= box.hi.x)) continue;
        Extent in_file;
        for (unsigned i = 0; i < 8; ++i)
            in_file.add(transform_point(
                placed.file_from_mesh,
                {i & 1 ? box.hi.x : box.lo.x, i & 2 ? box.hi.y : box.lo.y, i & 4 ? box.hi.z : box.lo.z}));
        box_.add(in_file.lo);
        box_.add(in_file.hi);
        const ShapeKind kind = scene_.shapes[placed.shape].kind;
        const bool is_group =
            kind == ShapeKind::triangle || kind == ShapeKind::smooth_triangle || kind == ShapeKind::polygon;
        if (!is_group) add_ball(in_file);  // a group has those of its triangles
    }
}

double ShapeMeshes::distance_from(Vec3 point) const {
    constexpr std::size_t k_enough = 4096;
    const std::size_t step = balls_.size() / k_enough + 1;
    std::vector<double> distances;
    for (std::size_t i = 0; i < balls_.size(); i += step)
        distances.push_back(number::max(length(balls_[i].center - point), balls_[i].radius / 2));
    if (distances.empty()) return 1;
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>((distances.size() - 1) / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle > 0 ? *middle : 1;
}

const MeshData& ShapeMeshes::own(MeshData mesh) {
    own_.push_back(std::make_unique<MeshData>(std::move(mesh)));
    return *own_.back();
}

const MeshData& ShapeMeshes::unit(ShapeKind kind) {
    const MeshData*& known = units_[kind];
    if (known == nullptr) {
        known = &own(kind == ShapeKind::sphere ? unit_sphere()
                     : kind == ShapeKind::box  ? unit_box()
                                               : unit_square());
    }
    return *known;
}

ShapeMeshes::Unit ShapeMeshes::cone(Vec3 from, Vec3 to, double from_radius, double to_radius, bool caps) {
    const double radius = number::max(from_radius, to_radius);
    const MeshData*& known = cones_[{from_radius / radius, to_radius / radius, caps}];
    if (known == nullptr) known = &own(unit_cone(from_radius / radius, to_radius / radius, caps));
    return {known, frame(from, to - from, radius)};
}

ShapeMeshes::Unit ShapeMeshes::disc(const Disc& d) {
    const MeshData*& known = discs_[d.hole / d.radius];
    if (known == nullptr) known = &own(unit_disc(d.hole / d.radius));
    return {known, frame(d.center, normalize(d.normal) * d.radius, d.radius)};
}

ShapeMeshes::Unit ShapeMeshes::torus(const Torus& t) {
    const MeshData*& known = tori_[t.tube / t.radius];
    if (known == nullptr) known = &own(unit_torus(t.tube / t.radius));
    return {known, frame(t.center, normalize(t.axis) * t.radius, t.radius)};
}

// A sphere to which the eye is near, as one that stands for the ground, is finer there: else, it would be
// far below what stands on it.
ShapeMeshes::Unit ShapeMeshes::sphere(const Sphere& s, const Affine& world_from_object) {
    const Vec3 eye =
        transform_point(inverse(world_from_object).value_or(Affine{}), scene_.camera.position) - s.center;
    const double gap = number::abs(length(eye) - s.radius) / s.radius;
    if (gap > 1.0 / 16 || eye == Vec3{})
        return {&unit(ShapeKind::sphere),
                compose(translation(s.center), scaling({s.radius, s.radius, s.radius}))};
    const double degrees = number::max(gap * 15, 1e-4);  // a quarter of the gap
    return {&own(unit_sphere(degrees)), frame(s.center, normalize(eye) * s.radius, s.radius)};
}

// Nothing for the other kinds.
ShapeMeshes::Unit ShapeMeshes::unit_of(const Shape& shape) {
    switch (shape.kind) {
        case ShapeKind::sphere:
            return sphere(scene_.get<Sphere>()[shape.index], transform(shape));
        case ShapeKind::cylinder: {
            const Cylinder& c = scene_.get<Cylinder>()[shape.index];
            return cone(c.from, c.to, c.radius, c.radius, c.caps);
        }
        case ShapeKind::cone: {
            const Cone& c = scene_.get<Cone>()[shape.index];
            if (!scene_.conventions.cones) return {};
            return cone(c.from, c.to, c.from_radius, c.to_radius, c.caps);
        }
        case ShapeKind::disc:
            return disc(scene_.get<Disc>()[shape.index]);
        case ShapeKind::torus:
            return torus(scene_.get<Torus>()[shape.index]);
        case ShapeKind::box: {
            const Box& b = scene_.get<Box>()[shape.index];
            return {&unit(shape.kind), compose(translation(b.min), scaling(b.max - b.min))};
        }
        case ShapeKind::mesh:
            return {scene_.meshes[scene_.get<Mesh>()[shape.index].mesh].get(), {}};
        case ShapeKind::plane:
        case ShapeKind::triangle:
        case ShapeKind::smooth_triangle:
        case ShapeKind::polygon:
        case ShapeKind::solid:
        case ShapeKind::quadric:
        case ShapeKind::quartic:
            break;
    }
    return {};
}

Affine ShapeMeshes::transform(const Shape& shape) const {
    return shape.transform == k_none ? Affine{} : scene_.transforms[shape.transform];
}

void ShapeMeshes::place(std::uint32_t index, const MeshData* mesh, const Affine& world_from_mesh) {
    placed_.push_back({mesh, compose(file_from_world_, world_from_mesh), scene_.shapes[index].material,
                       scene_.shape_color(index), std::string(scene_.shape_texts.name(index)), index});
}

void ShapeMeshes::add_triangles(std::uint32_t index) {
    const Shape& shape = scene_.shapes[index];
    std::optional<std::array<float, 3>> color;
    if (scene_.shape_color(index)) {
        const ShapeColor& c = scene_.shape_colors[index];
        color = {c.r, c.g, c.b};
    }
    MeshData*& group = groups_[{shape.material, shape.transform, color}];
    if (group == nullptr) {
        own_.push_back(std::make_unique<MeshData>());
        group = own_.back().get();
        place(index, group, transform(shape));
    }
    const std::size_t first = group->positions.size();
    if (shape.kind == ShapeKind::smooth_triangle) {
        const SmoothTriangle& t = scene_.get<SmoothTriangle>()[shape.index];
        append(*group, t.vertices, t.normals);
    } else if (shape.kind == ShapeKind::triangle) {
        append(*group, scene_.get<Triangle>()[shape.index].vertices, nullptr);
    } else {
        const Polygon& p = scene_.get<Polygon>()[shape.index];
        std::vector<Triangle> triangles;
        triangulate({scene_.polygon_vertices.data() + p.first, p.count}, triangles);
        for (const Triangle& t : triangles) append(*group, t.vertices, nullptr);
    }
    const Affine file_from_object = compose(file_from_world_, transform(shape));
    Extent box;
    for (std::size_t i = first; i < group->positions.size(); ++i)
        box.add(transform_point(file_from_object, group->positions[i]));
    if (first < group->positions.size()) add_ball(box);
}

void ShapeMeshes::add(std::uint32_t index) {
    const Shape& shape = scene_.shapes[index];
    switch (shape.kind) {
        case ShapeKind::plane:
            losses_.add("infinite planes", "each is a large square");
            return place(index, nullptr, {});
        case ShapeKind::quadric:
            return losses_.add("quadrics", "they are left out");
        case ShapeKind::quartic:
            return losses_.add("quartics", "they are left out");
        case ShapeKind::solid:
            return losses_.add("solids, which are combinations of shapes", "they are left out");
        case ShapeKind::triangle:
        case ShapeKind::smooth_triangle:
        case ShapeKind::polygon:
            return add_triangles(index);
        default:
            break;
    }
    const Unit unit = unit_of(shape);
    if (unit.mesh != nullptr) place(index, unit.mesh, compose(transform(shape), unit.object_from_mesh));
}

// Around the point of the plane that is nearest to the middle of the other shapes.
void ShapeMeshes::place_plane(PlacedMesh& placed, const Shape& shape) {
    const Plane& plane = scene_.get<Plane>()[shape.index];
    const Affine file_from_object = compose(file_from_world_, transform(shape));
    const Vec3 normal =
        normalize(transform_normal(inverse(file_from_object).value_or(Affine{}), plane.normal));
    const Vec3 point = transform_point(file_from_object, plane.point);
    const Vec3 eye = transform_point(file_from_world_, scene_.camera.position);
    const bool is_empty = !(box_.lo.x <= box_.hi.x);
    const Vec3 middle = is_empty ? eye : (box_.lo + box_.hi) / 2;
    const double radius = is_empty ? 0 : length(box_.hi - box_.lo) / 2;
    const Vec3 center = middle - normal * dot(middle - point, normal);
    const double reach =
        number::max(number::max(radius, length(eye - middle)), number::max(length(center - middle), 1.0));
    placed.mesh = &unit(ShapeKind::plane);
    const double half = number::min(k_plane * reach, k_largest);
    placed.file_from_mesh = frame(center, normal * half, half);
}

// A texture's mapping depends on the place, and so does the shape of what is sheared.
void ShapeMeshes::finish(PlacedMesh& placed) {
    const std::uint32_t texture =
        placed.material == k_none ? k_none : scene_.materials[placed.material].texture;
    if (texture != k_none && scene_.textures[texture].mapping != TextureMapping::uv) {
        const Affine world_from_file = file_from_world_;  // it is its own inverse
        placed.mesh = &own(with_coordinates(*placed.mesh, compose(world_from_file, placed.file_from_mesh),
                                            scene_.textures[texture]));
    }
    if (is_placement(placed.file_from_mesh)) return;
    placed.mesh = &own(transformed(*placed.mesh, placed.file_from_mesh));
    placed.file_from_mesh = {};
}

}  // namespace glint::gltf_export
