// SPDX-License-Identifier: Apache-2.0
// Edits shapes of a World: in place if no other World shares the geometry.
#include <algorithm>

#include "base/fp_environment.h"
#include "base/huge_pages.h"
#include "base/parallel_chunks.h"
#include "base/status.h"
#include "scene/mistakes.h"
#include "world/edit_index.h"
#include "world/pack_shapes.h"
#include "world/primitive_bounds-inl.h"
#include "world/world.h"

namespace glint {
namespace {

// If at least 1 / k_many of all slots are edited, all slots are processed in order.
constexpr std::size_t k_many = 32;

// The index is of the geometry's structure, and edits leave it valid.
void need_edit_index(PackedGeometry& geometry) {
    if (geometry.edit_index) return;
    if (!geometry.shared_index) geometry.shared_index = std::make_shared<SharedEditIndex>();
    geometry.edit_index = geometry.shared_index->get(geometry);
    geometry.cost = geometry.edit_index->built_cost;
}

class ShapeEditor {
  public:
    ShapeEditor(World& world, const Scene& scene, std::span<const std::uint32_t> changed,
                const PrepareOptions& options)
        : world_(world), scene_(scene), changed_(changed), options_(options), primitives_(scene) {}

    // Sets `edit` as soon as it is done, so that what fails after it does not undo it.
    Status run(ShapeEdit& edit) {
        const WorldParts& now = world_.parts();
        if (scene_.shapes.size() != now.geometry->scene_shapes) {
            std::vector<Mistake> mistakes = find_mistakes_of_all();
            return mistakes.empty() ? rebuild(edit) : refuse(std::move(mistakes));
        }
        std::vector<Mistake> mistakes = find_mistakes(scene_, changed_, now.scene_materials());
        if (!mistakes.empty()) return refuse(std::move(mistakes));
        if (changed_.empty()) return {};
        for (const std::uint32_t shape : changed_) {
            if (now.conventions.cones || scene_.shapes[shape].kind != ShapeKind::cone) primitives_.add(shape);
        }
        // Do everything that may fail before the first write.
        WorldParts& parts = WorldAccess::own(world_);
        PackedGeometry& geometry = parts.geometry.own();
        need_edit_index(geometry);
        if (!fits(geometry)) return rebuild(edit);
        std::vector<std::uint32_t>& rows = parts.slot_material.own();
        const bool many = primitives_.list().size() > geometry.count / k_many;
        many ? write_many(geometry, rows) : write_few(geometry, rows);
        edit = ShapeEdit::refitted;
        const double built = geometry.edit_index->built_cost.expected();
        if (geometry.cost.expected() > k_max_refit_cost * built) return rebuild(edit);
        if (options_.progress) options_.progress(1);
        return {};
    }

  private:
    std::vector<Mistake> find_mistakes_of_all() const {
        std::vector<std::uint32_t> all(scene_.shapes.size());
        for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
        return find_mistakes(scene_, all, world_.parts().scene_materials());
    }

    Status refuse(std::vector<Mistake> mistakes) const {
        return invalid_scene(to_diagnostics(std::move(mistakes), scene_));
    }

    static std::uint32_t slot_of(const PackedGeometry& geometry, const Primitive& p) {
        return geometry.edit_index->slots_of(p.shape)[p.piece];
    }

    // Whether the changed shapes have the same number and classes of primitives as before.
    bool fits(const PackedGeometry& geometry) const {
        const std::vector<Primitive>& list = primitives_.list();
        std::size_t at = 0;
        for (const std::uint32_t shape : changed_) {
            const auto slots = geometry.edit_index->slots_of(shape);
            std::size_t pieces = 0;
            for (; at < list.size() && list[at].shape == shape && list[at].piece == pieces; ++at, ++pieces) {
                if (pieces == slots.size()) return false;
                const ShapeClass& shapes = geometry.class_of(slots[pieces]);
                if (2 * static_cast<int>(shapes.kind) + (shapes.transformed ? 1 : 0) !=
                    primitives_.class_of(list[at]))
                    return false;
            }
            if (pieces != slots.size()) return false;
        }
        return true;
    }

    std::uint32_t row_of(std::uint32_t shape) const {
        const std::uint32_t material = scene_.shapes[shape].material;
        return material == k_none ? world_.parts().scene_materials() : material;
    }

    void write(const Primitive& p, std::uint32_t slot, PackedGeometry& geometry,
               std::vector<std::uint32_t>& rows) const {
        const Aabb box = slot < geometry.boxed ? primitives_.box_of(p) : Aabb{};
        write_primitive(primitives_, p, box, slot, geometry.class_of(slot), geometry);
        rows[slot] = row_of(p.shape);
    }

    void write_few(PackedGeometry& geometry, std::vector<std::uint32_t>& rows) const {
        const auto box = [&](std::uint32_t slot) { return HWY_NAMESPACE::primitive_bounds(geometry, slot); };
        for (const Primitive& p : primitives_.list()) {
            const std::uint32_t slot = slot_of(geometry, p);
            write(p, slot, geometry, rows);
            if (slot < geometry.bounded)
                refit_item(geometry.bvh, geometry.edit_index->links, slot, box, geometry.cost);
        }
    }

    void write_many(PackedGeometry& geometry, std::vector<std::uint32_t>& rows) const {
        const std::vector<Primitive>& list = primitives_.list();
        std::vector<std::uint32_t> first;  // by shape: its first primitive
        resize_in_huge_pages(first, geometry.scene_shapes);
        std::fill(first.begin(), first.end(), k_none);
        for (std::size_t i = list.size(); i-- > 0;) {
            if (list[i].piece == 0) first[list[i].shape] = static_cast<std::uint32_t>(i);
        }
        const auto shape_at = [&](std::size_t slot) {
            return geometry.shape_index[std::min<std::size_t>(slot, geometry.count - 1)];
        };
        constexpr std::size_t ahead = Primitives::k_prefetch_distance;
        parallel_chunks(geometry.count, options_.threads, [&](std::size_t slot) {
            primitives_.prefetch_shape(shape_at(slot + 2 * ahead));
            primitives_.prefetch_parameters(shape_at(slot + ahead));
            const std::uint32_t shape = geometry.shape_index[slot];
            if (first[shape] == k_none) return;
            const bool is_polygon = scene_.shapes[shape].kind == ShapeKind::polygon;
            const Primitive primitive =
                is_polygon ? list[first[shape] + geometry.piece_of(static_cast<std::uint32_t>(slot))]
                           : Primitive{shape, k_none, 0};
            write(primitive, static_cast<std::uint32_t>(slot), geometry, rows);
        });
        refit_all(
            geometry.bvh, [&](std::uint32_t slot) { return HWY_NAMESPACE::primitive_bounds(geometry, slot); },
            options_.threads);
        geometry.cost = find_cost(geometry.bvh);
    }

    // Shapes that are not edited keep the material that the World has assigned to them.
    std::vector<std::uint32_t> keep_materials(const PackedGeometry& built) const {
        const WorldParts& now = world_.parts();
        std::vector<std::uint32_t> rows =
            find_slot_materials(scene_, built, now.scene_materials(), options_.threads);
        if (built.scene_shapes != now.geometry->scene_shapes) return rows;
        std::vector<std::uint32_t> by_shape(built.scene_shapes, k_none);
        for (std::uint32_t slot = 0; slot < now.geometry->count; ++slot)
            by_shape[now.geometry->shape_index[slot]] = (*now.slot_material)[slot];
        for (const std::uint32_t shape : changed_) by_shape[shape] = k_none;
        for (std::uint32_t slot = 0; slot < built.count; ++slot) {
            const std::uint32_t kept = by_shape[built.shape_index[slot]];
            if (kept != k_none) rows[slot] = kept;
        }
        return rows;
    }

    Status rebuild(ShapeEdit& edit) {
        auto built = pack_shapes(scene_, world_.parts().conventions.cones, options_);
        if (!built) return cancelled();
        std::vector<std::uint32_t> rows = keep_materials(*built);
        WorldParts& parts = WorldAccess::own(world_);
        parts.slot_material = std::move(rows);
        parts.geometry = std::move(*built);
        edit = ShapeEdit::rebuilt;
        return {};
    }

    World& world_;
    const Scene& scene_;
    const std::span<const std::uint32_t> changed_;
    const PrepareOptions& options_;
    Primitives primitives_;
};

}  // namespace

Result<ShapeEdit> edit_shapes(World& world, const Scene& scene, std::span<const std::uint32_t> changed,
                              const PrepareOptions& options) {
    ShapeEdit edit = ShapeEdit::none;
    const auto body = [&] {
        const DefaultFpEnvironment environment;
        return ShapeEditor(world, scene, changed, options).run(edit);
    };
    Status status = result_of(body, " while editing shapes");
    // Where only the rebuilding has failed, the refitted hierarchy draws the same.
    if (!status.ok() && edit == ShapeEdit::none) return status;
    return edit;
}

}  // namespace glint
