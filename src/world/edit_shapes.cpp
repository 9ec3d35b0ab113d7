// SPDX-License-Identifier: Apache-2.0
// Edits shapes of a World: in place if no other World shares the geometry.
#include <algorithm>
#include <atomic>

#include "base/fp_environment.h"
#include "base/parallel_chunks.h"
#include "base/status.h"
#include "scene/mistakes.h"
#include "world/appearance/interiors.h"
#include "world/appearance/shading.h"
#include "world/geometry/edit_index.h"
#include "world/geometry/pack_mesh.h"
#include "world/geometry/pack_shapes.h"
#include "world/geometry/primitive_bounds-inl.h"
#include "world/world.h"

namespace glint {
namespace {

// If at least 1 / k_many of all slots are edited, all slots are processed in order.
constexpr std::size_t k_many = 32;

// Makes the index if there is none. It depends on the structure of the geometry only, so edits keep it valid.
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
        : world_(world), scene_(scene), changed_(changed), options_(options), primitives_(scene, meshes_) {}

    // Sets `edit` as soon as the edit is done, so that a later failure does not report it as not done.
    Status run(ShapeEdit& edit) {
        const WorldParts& now = world_.parts();
        if (scene_.shapes.size() != now.geometry->scene_shapes) {
            std::vector<Mistake> mistakes = find_mistakes_of_all();
            return mistakes.empty() ? rebuild(edit) : refuse(std::move(mistakes));
        }
        std::vector<Mistake> mistakes =
            find_mistakes(scene_, changed_, now.scene_materials(), options_.threads);
        if (!mistakes.empty()) return refuse(std::move(mistakes));
        if (changed_.empty()) return {};
        // The operands of a solid are packed together.
        if (has_solids(scene_) || !now.geometry->solids.empty()) return rebuild(edit);
        triangulate_polygons();
        if (!scene_.meshes.empty()) {
            meshes_ = now.geometry->meshes;
            if (!pack_meshes(scene_, meshes_, options_)) return cancelled();
        }
        // Do everything that may fail before the first write.
        WorldParts& parts = WorldAccess::own(world_);
        PackedGeometry& geometry = parts.geometry.own();
        need_edit_index(geometry);
        if (!fits(geometry)) return rebuild(edit);
        geometry.set_meshes(meshes_);
        std::vector<std::uint32_t>& rows = parts.slot_material.own();
        prepare_colors(parts);
        const bool many = changed_.size() + primitives_.size() > geometry.count / k_many;
        many ? write_many(geometry, rows) : write_few(geometry, rows);
        edit = ShapeEdit::refitted;
        if (geometry.cost.expected() > k_max_refit_cost * geometry.expected_built_cost())
            return rebuild(edit);
        if (options_.progress) options_.progress(1);
        return {};
    }

  private:
    std::vector<Mistake> find_mistakes_of_all() const {
        std::vector<std::uint32_t> all(scene_.shapes.size());
        for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
        return find_mistakes(scene_, all, world_.parts().scene_materials(), options_.threads);
    }

    Status refuse(std::vector<Mistake> mistakes) const {
        return invalid_scene(to_diagnostics(std::move(mistakes), scene_));
    }

    // Only the primitives of polygons are listed. Other shapes are one primitive each, and need no memory.
    void triangulate_polygons() {
        if (scene_.get<Polygon>().empty()) return;
        first_triangle_.reserve(changed_.size());
        for (const std::uint32_t shape : changed_) {
            first_triangle_.push_back(static_cast<std::uint32_t>(primitives_.size()));
            if (scene_.shapes[shape].kind == ShapeKind::polygon) primitives_.add(shape);
        }
    }

    // Sets `colors_` if a shape or a mesh has colors of its own, or had some.
    void prepare_colors(WorldParts& parts) {
        if (parts.slot_color->empty()) {
            const bool any = parts.geometry->has_mesh_colors ||
                             std::any_of(changed_.begin(), changed_.end(), [&](std::uint32_t shape) {
                                 return scene_.shape_color(shape).has_value();
                             });
            if (any) set_colors(parts, scene_.shape_colors, options_.threads);
        } else {
            colors_ = &parts.slot_color.own();
        }
    }

    // The number of primitives of changed shape i.
    std::size_t count_primitives(std::size_t i) const {
        const ShapeKind kind = scene_.shapes[changed_[i]].kind;
        if (kind == ShapeKind::cone && !world_.parts().conventions.cones) return 0;
        if (kind != ShapeKind::polygon) return 1;
        const std::size_t end = i + 1 < changed_.size() ? first_triangle_[i + 1] : primitives_.size();
        return end - first_triangle_[i];
    }

    // first_triangle: used for polygons only.
    Primitive primitive(std::uint32_t shape, std::uint32_t first_triangle, std::size_t element) const {
        if (scene_.shapes[shape].kind != ShapeKind::polygon) return {shape, k_none, 0};
        return primitives_[first_triangle + element];
    }
    // Primitive `element` of changed shape i.
    Primitive changed_primitive(std::size_t i, std::size_t element) const {
        return primitive(changed_[i], first_triangle_.empty() ? 0 : first_triangle_[i], element);
    }

    // Whether the changed shapes have the same number and classes of primitives as before.
    bool fits(const PackedGeometry& geometry) const {
        std::atomic<bool> all{true};
        parallel_chunks(changed_.size(), options_.threads, [&](std::size_t i) {
            const auto slots = geometry.edit_index->slots_of(changed_[i]);
            bool same = slots.size() == count_primitives(i);
            for (std::size_t element = 0; same && element < slots.size(); ++element) {
                const ShapeClass& shapes = geometry.class_of(slots[element]);
                same = 2 * static_cast<int>(shapes.kind) + (shapes.transformed ? 1 : 0) ==
                       primitives_.class_of(changed_primitive(i, element));
            }
            if (!same) all = false;
        });
        return all;
    }

    std::uint32_t row_of(std::uint32_t shape) const {
        const std::uint32_t material = scene_.shapes[shape].material;
        return material == k_none ? world_.parts().scene_materials() : material;
    }

    void write(const Primitive& p, std::uint32_t slot, PackedGeometry& geometry,
               std::vector<std::uint32_t>& rows) const {
        write_primitive(primitives_, p, slot, geometry.class_of(slot), geometry);
        if (slot < geometry.boxed) write_box(primitives_.box_of(p), slot, geometry);
        rows[slot] = row_of(p.shape);
        if (colors_ == nullptr) return;
        const ShapeColor color =
            p.shape < scene_.shape_colors.size() ? scene_.shape_colors[p.shape] : ShapeColor{};
        float* to = colors_->data() + 3 * std::size_t{slot};
        to[0] = color.r, to[1] = color.g, to[2] = color.b;
    }

    // The bounds of consecutive slots of one class.
    static Aabb bounds_of(const PackedGeometry& geometry, std::uint32_t first, std::uint32_t count) {
        Aabb box;
        for (std::uint32_t slot = first; slot < first + count; ++slot)
            box.add(HWY_NAMESPACE::primitive_bounds(geometry, slot));
        return box;
    }

    void write_few(PackedGeometry& geometry, std::vector<std::uint32_t>& rows) const {
        const auto bounds = [&](std::uint32_t first, std::uint32_t count) {
            return bounds_of(geometry, first, count);
        };
        for (std::size_t i = 0; i < changed_.size(); ++i) {
            const auto slots = geometry.edit_index->slots_of(changed_[i]);
            for (std::size_t element = 0; element < slots.size(); ++element) {
                write(changed_primitive(i, element), slots[element], geometry, rows);
                if (slots[element] < geometry.bounded)
                    refit_item(geometry.bvh, geometry.edit_index->links, slots[element], bounds,
                               geometry.cost);
            }
        }
    }

    void write_many(PackedGeometry& geometry, std::vector<std::uint32_t>& rows) const {
        std::vector<bool> is_changed;  // by shape; empty: all shapes are changed
        if (!is_all()) {
            is_changed.resize(geometry.scene_shapes);
            for (const std::uint32_t shape : changed_) is_changed[shape] = true;
        }
        std::vector<std::uint32_t> first_triangle;  // by shape
        if (!first_triangle_.empty()) first_triangle.resize(geometry.scene_shapes);
        for (std::size_t i = 0; i < first_triangle_.size(); ++i)
            first_triangle[changed_[i]] = first_triangle_[i];
        const auto shape_at = [&](std::size_t slot) {
            return geometry.shape_index[std::min<std::size_t>(slot, geometry.count - 1)];
        };
        constexpr std::size_t ahead = Primitives::k_prefetch_distance;
        parallel_chunks(geometry.count, options_.threads, [&](std::size_t slot) {
            primitives_.prefetch_shape(shape_at(slot + 2 * ahead));
            primitives_.prefetch_parameters(shape_at(slot + ahead));
            const std::uint32_t shape = geometry.shape_index[slot];
            if (!is_changed.empty() && !is_changed[shape]) return;
            const auto at = static_cast<std::uint32_t>(slot);
            const std::uint32_t first = first_triangle.empty() ? 0 : first_triangle[shape];
            write(primitive(shape, first, geometry.element_of(at)), at, geometry, rows);
        });
        refit_all(
            geometry.bvh,
            [&](std::uint32_t first, std::uint32_t count) { return bounds_of(geometry, first, count); },
            options_.threads);
        geometry.cost = find_cost(geometry.bvh);
    }

    // Whether the list of changed shapes is that of all shapes, in order.
    bool is_all() const {
        if (changed_.size() != scene_.shapes.size()) return false;
        for (std::size_t i = 0; i < changed_.size(); ++i) {
            if (changed_[i] != i) return false;
        }
        return true;
    }

    // Shapes that are not edited keep the material that the World has assigned to them.
    std::vector<std::uint32_t> keep_materials(const PackedGeometry& built) const {
        const WorldParts& now = world_.parts();
        std::vector<std::uint32_t> rows =
            find_slot_materials(scene_, built, now.scene_materials(), options_.threads);
        if (built.scene_shapes != now.geometry->scene_shapes) return rows;
        std::vector<std::uint32_t> by_shape(built.scene_shapes, k_none);
        for (std::uint32_t slot = 0; slot < now.geometry->first_operand(); ++slot)
            by_shape[now.geometry->shape_index[slot]] = (*now.slot_material)[slot];
        for (const std::uint32_t shape : changed_) by_shape[shape] = k_none;
        for (std::uint32_t slot = 0; slot < built.count; ++slot) {
            const std::uint32_t kept = by_shape[built.shape_index[slot]];
            if (kept != k_none && !built.has_own_material(slot)) rows[slot] = kept;
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
        set_colors(parts, scene_.shape_colors, options_.threads);
        edit = ShapeEdit::rebuilt;
        return {};
    }

    World& world_;
    const Scene& scene_;
    const std::span<const std::uint32_t> changed_;
    const PrepareOptions& options_;
    PackedMeshes meshes_;                        // of the scene
    Primitives primitives_;                      // of the changed polygons
    std::vector<float>* colors_ = nullptr;       // of the World, if it has colors to be edited
    std::vector<std::uint32_t> first_triangle_;  // by changed shape, if the scene has polygons
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
    // If only the rebuild has failed, the refitted hierarchy gives the same pictures.
    if (!status.ok() && edit == ShapeEdit::none) return status;
    if (edit != ShapeEdit::none) set_interiors(WorldAccess::own(world));
    return edit;
}

}  // namespace glint
