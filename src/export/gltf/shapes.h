// SPDX-License-Identifier: Apache-2.0
#pragma once
// The shapes of a scene as meshes that are placed.
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "export/gltf/losses.h"
#include "glint/scene.h"
#include "math/extent.h"

namespace glint::gltf_export {

/// A mesh in the file's coordinates.
struct PlacedMesh {
    const MeshData* mesh = nullptr;
    Affine file_from_mesh;
    std::uint32_t material = k_none;
    std::optional<Color> color;
    std::string name;
    std::uint32_t shape = 0;  ///< the first one of it in Scene::shapes
};

/// The meshes of a scene, in the order of its shapes. Spheres, cylinders, cones, discs, tori and boxes share
/// meshes of one size. Triangles and polygons with the same material, color and transform are one mesh. A
/// plane is a square. The Scene must outlive it.
class ShapeMeshes {
  public:
    /// file_from_world: the identity, or a reflection. Meshes whose place a node cannot have are meshes of
    /// their own.
    ShapeMeshes(const Scene& scene, const Affine& file_from_world, Losses& losses);

    const std::vector<PlacedMesh>& placed() const { return placed_; }
    /// The box of all shapes but planes, in the file's coordinates; empty if there is none.
    const Extent& box() const { return box_; }
    /// The median of the distances from a point to the shapes but planes; 1 without any. Of a large shape,
    /// the distance is at least half its radius.
    double distance_from(Vec3 point) const;

  private:
    struct Ball {
        Vec3 center;
        double radius = 0;
    };
    struct Unit {
        const MeshData* mesh = nullptr;
        Affine object_from_mesh;
    };
    using GroupKey = std::tuple<std::uint32_t, std::uint32_t, std::optional<std::array<float, 3>>>;

    void add(std::uint32_t index);
    void add_triangles(std::uint32_t index);
    void place(std::uint32_t index, const MeshData* mesh, const Affine& world_from_mesh);
    void place_plane(PlacedMesh& placed, const Shape& shape);
    void finish(PlacedMesh& placed);
    void add_ball(const Extent& box);
    void measure();
    const MeshData& own(MeshData mesh);
    const MeshData& unit(ShapeKind kind);
    Unit cone(Vec3 from, Vec3 to, double from_radius, double to_radius, bool caps);
    Unit disc(const Disc& d);
    Unit torus(const Torus& t);
    Unit sphere(const Sphere& s, const Affine& world_from_object);
    Unit unit_of(const Shape& shape);
    Affine transform(const Shape& shape) const;

    const Scene& scene_;
    const Affine file_from_world_;
    Losses& losses_;
    std::vector<PlacedMesh> placed_;
    std::vector<std::unique_ptr<MeshData>> own_;
    std::map<ShapeKind, const MeshData*> units_;
    std::map<std::tuple<double, double, bool>, const MeshData*> cones_;
    std::map<double, const MeshData*> discs_, tori_;  // by the hole, by the tube, of the radius
    std::map<GroupKey, MeshData*> groups_;
    Extent box_;
    std::vector<Ball> balls_;  // around the shapes but planes
};

}  // namespace glint::gltf_export
