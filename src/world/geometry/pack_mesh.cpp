// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/pack_mesh.h"

#include <algorithm>
#include <array>

#include "base/huge_pages.h"
#include "base/parallel_chunks.h"
#include "bvh/rays.h"
#include "math/extent.h"
#include "world/geometry/mesh_triangle-inl.h"

namespace glint {
namespace {

using Triangles = HWY_NAMESPACE::TriangleGeometry;

// Leaves of up to 8 triangles, as those of shapes (pack_shapes.cpp).
constexpr std::array<LeafCost, 1> k_mesh_leaf_costs{};

// Slots are in leaf order. Nothing but the corners and numbers of the triangles is stored by slot.
std::shared_ptr<const PackedMesh> pack_mesh(const std::shared_ptr<const MeshData>& data,
                                            const PrepareOptions& options) {
    const auto report = [&](double done) {
        if (options.progress) options.progress(done);
    };
    auto packed = std::make_shared<PackedMesh>();
    packed->data = data;
    const MeshData& mesh = *data;
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    const auto for_all = [&](const auto& body) { parallel_chunks(count, options.threads, body); };
    std::vector<BvhItem> leaves;
    resize_in_huge_pages(leaves, count, options.threads);
    for_all([&](std::size_t i) {
        Vec3 lo, hi;
        Triangles::bounds(HWY_NAMESPACE::mesh_triangle(mesh, static_cast<std::uint32_t>(i)), lo, hi);
        const Aabb box = padded_box(lo, hi);
        BvhItem& leaf = leaves[i];
        for (int a = 0; a < 3; ++a) leaf.lo[a] = box.lo[a], leaf.hi[a] = box.hi[a];
        leaf.item = static_cast<std::uint32_t>(i);
        leaf.item_class = 0;
    });
    report(0.15);
    PackedGeometry& geometry = packed->geometry;
    geometry.bvh = build_bvh(leaves, k_mesh_leaf_costs, options.threads, options.cancel);
    if (options.cancel.is_set()) return nullptr;
    report(0.75);
    geometry.bounded = geometry.count = count;
    ShapeClass triangles;
    triangles.kind = ShapeKind::triangle;
    triangles.count = count;
    triangles.mesh = data.get();
    triangles.stride = count + k_ray_padding;
    resize_in_huge_pages(triangles.corners, 3 * std::size_t{triangles.stride}, options.threads);
    resize_in_huge_pages(geometry.element, triangles.stride);
    for_all([&](std::size_t slot) {
        const std::uint32_t i = leaves[slot].item;
        geometry.element[slot] = i;
        for (std::size_t k = 0; k < 3; ++k)
            triangles.corners[k * triangles.stride + slot] = mesh.triangles[i][k];
    });
    geometry.classes.push_back(std::move(triangles));
    Extent box;
    for (const TriangleCorners& corners : mesh.triangles) {
        for (const std::uint32_t vertex : corners) box.add(mesh.position(vertex));
    }
    packed->lo = box.lo, packed->hi = box.hi;
    return packed;
}

}  // namespace

double count_mesh_triangles(const Scene& scene) {
    double count = 0;
    for (const auto& mesh : scene.meshes)
        count += mesh == nullptr ? 0 : static_cast<double>(mesh->triangles.size());
    return count;
}

PrepareOptions part_of(const PrepareOptions& options, double from, double to) {
    PrepareOptions part = options;
    if (options.progress) {
        part.progress = [whole = options.progress, from, to](double done) {
            whole(from + done * (to - from));
        };
    }
    return part;
}

bool pack_meshes(const Scene& scene, PackedMeshes& meshes, const PrepareOptions& options) {
    const PackedMeshes known = std::move(meshes);
    meshes.assign(scene.meshes.size(), nullptr);
    const double all = std::max(1.0, count_mesh_triangles(scene));
    double done = 0;
    std::vector<std::uint32_t> used;
    const auto use = [&](const Shape& shape) {
        if (shape.kind == ShapeKind::mesh) used.push_back(scene.get<Mesh>()[shape.index].mesh);
    };
    for (const Shape& shape : scene.shapes) {
        use(shape);
        for (const Shape& operand : operands_of(scene, shape)) use(operand);
    }
    for (const std::uint32_t index : used) {
        if (meshes[index] != nullptr) continue;
        const std::shared_ptr<const MeshData>& data = scene.meshes[index];
        const auto same = std::find_if(known.begin(), known.end(), [&](const auto& mesh) {
            return mesh != nullptr && mesh->data == data;
        });
        const double end = done + static_cast<double>(data->triangles.size());
        meshes[index] =
            same != known.end() ? *same : pack_mesh(data, part_of(options, done / all, end / all));
        if (meshes[index] == nullptr) return false;
        done = end;
    }
    return true;
}

void PackedGeometry::set_meshes(PackedMeshes packed) {
    meshes = std::move(packed);
    has_mesh_colors = std::any_of(meshes.begin(), meshes.end(), [](const auto& mesh) {
        return mesh != nullptr && !mesh->data->colors.empty();
    });
}

}  // namespace glint
