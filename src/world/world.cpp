// SPDX-License-Identifier: Apache-2.0
// Functions of Worlds: access to the parts, memory usage, bounds.
#include "world/world.h"

#include <atomic>
#include <utility>

#include "world/appearance/shading.h"
#include "world/geometry/edit_index.h"
#include "world/geometry/packed_mesh.h"
#include "world/geometry/primitive_bounds-inl.h"
#include "world/geometry/primitives.h"
#include "world/prepare_camera.h"

namespace glint {
namespace {

WorldParts empty_parts() {
    const Scene scene;
    WorldParts parts;
    parts.materials = pack_materials(scene.materials);
    parts.background = scene.background;
    parts.camera = prepare_camera(scene.camera, scene.settings);
    return parts;
}

template <class T> std::size_t bytes(const std::vector<T>& values) { return values.capacity() * sizeof(T); }

}  // namespace

struct World::Shared {
    explicit Shared(WorldParts&& all) : parts(std::move(all)) {}
    std::atomic<std::size_t> owners{1};
    WorldParts parts;
};

World::World(const World& other) noexcept : parts_(other.parts_) {
    if (parts_ != nullptr) parts_->owners.fetch_add(1, std::memory_order_relaxed);
}

World::~World() {
    if (parts_ != nullptr && parts_->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) delete parts_;
}

const WorldParts& World::parts() const {
    static const WorldParts empty = empty_parts();
    return parts_ != nullptr ? parts_->parts : empty;
}

World WorldAccess::make(WorldParts parts) {
    World world;
    world.parts_ = new World::Shared(std::move(parts));
    return world;
}

WorldParts& WorldAccess::own(World& world) {
    // Acquires what the destructors of other owners released, so that their reads come before the changes.
    if (world.parts_ == nullptr || world.parts_->owners.load(std::memory_order_acquire) != 1)
        world = make(world.parts());
    return world.parts_->parts;
}

WorldMemory memory_usage(const World& world) {
    const WorldParts& parts = world.parts();
    const PackedGeometry& geometry = *parts.geometry;
    WorldMemory m;
    for (const ShapeClass& c : geometry.classes) m.shapes += bytes(c.values);
    for (int a = 0; a < 3; ++a) m.boxes += bytes(geometry.box_lo[a]) + bytes(geometry.box_hi[a]);
    m.indices = bytes(geometry.shape_index) + bytes(geometry.element) + bytes(geometry.open) +
                bytes(*parts.slot_material);
    if (geometry.edit_index) m.indices += geometry.edit_index->bytes();
    m.packed = geometry.count;
    m.hierarchy = bytes(geometry.bvh.nodes);
    m.shapes += bytes(geometry.solids) + bytes(geometry.operands);
    for (const PackedSolid& solid : geometry.solids) {
        m.shapes += bytes(solid.items) + bytes(solid.slots);
        for (int a = 0; a < 3; ++a) m.boxes += bytes(solid.lo[a]) + bytes(solid.hi[a]);
    }
    for (const auto& mesh : geometry.meshes) {
        if (mesh == nullptr) continue;
        for (const ShapeClass& c : mesh->geometry.classes) m.shapes += bytes(c.corners);
        m.indices += bytes(mesh->geometry.element);
        m.packed += mesh->geometry.count;
        m.hierarchy += bytes(mesh->geometry.bvh.nodes);
    }
    m.colors = bytes(*parts.slot_color) + bytes(*parts.color_factors);
    m.materials = bytes(*parts.materials) + bytes(*parts.no_shadow) + bytes(*parts.extended) +
                  bytes(*parts.lights) + bytes(*parts.ambient_lights);
    return m;
}

Bounds scene_bounds(const World& world) {
    const PackedGeometry& geometry = *world.parts().geometry;
    if (!is_endless(geometry.bvh.bounds)) return to_bounds(geometry.bvh.bounds);
    Aabb all;
    for (std::uint32_t slot = 0; slot < geometry.bounded; ++slot) {
        const Aabb box = HWY_NAMESPACE::primitive_bounds(geometry, slot);
        if (!is_endless(box)) all.add(box);
    }
    return to_bounds(all);
}

}  // namespace glint
