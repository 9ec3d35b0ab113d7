// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/splice_geometry.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "base/sort_stably.h"
#include "bvh/rays.h"
#include "bvh/splice.h"
#include "world/geometry/edit_index.h"
#include "world/geometry/pack_shapes.h"
#include "world/geometry/primitive_bounds-inl.h"
#include "world/geometry/primitives.h"

namespace glint {
namespace {

std::size_t class_of(const ShapeClass& shapes) {
    return 2 * static_cast<std::size_t>(shapes.kind) + (shapes.transformed ? 1 : 0);
}

// New primitives that are put together before an old slot of their class.
struct Insertion {
    std::uint32_t before = 0;
    std::uint32_t leaf = 0;            // in the numbering of BvhSplice; 0 of unbounded shapes
    std::vector<std::uint32_t> added;  // indices in the list of the shapes to be put in
};

class GeometrySplicer {
  public:
    GeometrySplicer(const PackedGeometry& old, const Scene& scene, bool cones,
                    std::span<const std::uint32_t> removed, std::span<const std::uint32_t> added)
        : old_(old),
          scene_(scene),
          cones_(cones),
          removed_(removed),
          added_(added),
          primitives_(scene, old.meshes) {}

    std::optional<SplicedGeometry> run() {
        if (old_.bvh.nodes.empty() || !old_.solids.empty() || has_solids(scene_)) return std::nullopt;
        number_shapes();
        geometry_.bvh = old_.bvh;
        BvhSplice tree(geometry_.bvh, old_.bounded, [&](std::uint32_t slot) {
            return static_cast<std::uint32_t>(class_of(old_.class_of(slot)));
        });
        for (std::uint32_t slot = 0; slot < old_.count; ++slot) {
            if (new_shape_[old_.shape_index[slot]] != k_none) continue;
            removed_slots_.push_back(slot);
            if (slot < old_.bounded) tree.remove(slot);
        }
        if (!insert_all(tree)) return std::nullopt;
        lay_out(tree);
        if (geometry_.bounded == 0) return std::nullopt;
        copy_slots();
        write_added();
        tree.renumber([&](std::uint32_t first) {
            return first < old_.bounded ? new_slot_[first] : new_leaf_[first - old_.bounded];
        });
        tree.refit([&](std::uint32_t first, std::uint32_t count) {
            Aabb box;
            for (std::uint32_t slot = first; slot < first + count; ++slot)
                box.add(HWY_NAMESPACE::primitive_bounds(geometry_, slot));
            return box;
        });
        finish();
        return std::move(result_);
    }

  private:
    // The new index of each old shape; k_none: it is removed.
    void number_shapes() {
        new_shape_.resize(old_.scene_shapes);
        std::uint32_t next = 0;
        auto removed = removed_.begin();
        auto added = added_.begin();
        for (std::uint32_t i = 0; i < old_.scene_shapes; ++i) {
            if (removed != removed_.end() && *removed == i) {
                new_shape_[i] = k_none;
                ++removed;
                continue;
            }
            for (; added != added_.end() && *added == next; ++added) ++next;
            new_shape_[i] = next++;
        }
    }

    Primitive primitive(std::size_t i) const { return {added_[i], k_none, 0}; }
    std::size_t class_of_added(std::size_t i) const {
        return static_cast<std::size_t>(primitives_.class_of(primitive(i)));
    }

    const ShapeClass* old_class(std::size_t c) const {
        for (const ShapeClass& shapes : old_.classes)
            if (class_of(shapes) == c) return &shapes;
        return nullptr;
    }

    bool insert_all(BvhSplice& tree) {
        boxes_.resize(added_.size());
        for (std::uint32_t i = 0; i < added_.size(); ++i) {
            const ShapeKind kind = scene_.shapes[added_[i]].kind;
            if (kind == ShapeKind::polygon || kind == ShapeKind::mesh) return false;
            if (kind == ShapeKind::cone && !cones_) continue;
            const std::size_t c = class_of_added(i);
            if (class_traits()[c].bounded) {
                boxes_[i] = primitives_.box_of(primitive(i));
                if (!tree.insert(boxes_[i], static_cast<std::uint32_t>(c), i)) return false;
            } else {
                insertions_[c].push_back({place_of_unbounded(c, added_[i]), 0, {i}});
            }
        }
        for (const auto& [first, leaf] : tree.leaves()) {
            if (leaf.added.empty()) continue;
            const ShapeClass* const shapes = old_class(leaf.item_class);
            const std::uint32_t end = shapes == nullptr ? 0 : shapes->first + shapes->count;
            insertions_[leaf.item_class].push_back(
                {leaf.end == BvhSplice::Leaf::k_new ? end : leaf.end, first, leaf.added});
        }
        // At the end of a class its last old leaf comes before new ones, whose numbers are greater.
        for (auto& list : insertions_)
            sort_stably(list, [](const Insertion& a, const Insertion& b) {
                return a.before != b.before ? a.before < b.before : a.leaf < b.leaf;
            });
        return true;
    }

    // Unbounded shapes are in the order of the scene.
    std::uint32_t place_of_unbounded(std::size_t c, std::uint32_t shape) const {
        const ShapeClass* const shapes = old_class(c);
        if (shapes == nullptr) return 0;
        std::uint32_t slot = shapes->first;
        const std::uint32_t end = slot + shapes->count;
        while (slot < end &&
               (new_shape_[old_.shape_index[slot]] == k_none || new_shape_[old_.shape_index[slot]] < shape))
            ++slot;
        return slot;
    }

    // The classes in the order of the packer, and where each slot goes.
    void lay_out(const BvhSplice& tree) {
        new_slot_.resize(old_.count);
        added_slots_.assign(added_.size(), k_none);
        std::uint32_t new_leaves = 0;
        for (const auto& [first, leaf] : tree.leaves())
            if (leaf.end == BvhSplice::Leaf::k_new) ++new_leaves;
        new_leaf_.resize(new_leaves);
        for (int rank = 0; rank < 3; ++rank) {
            for (std::size_t c = 0; c < insertions_.size(); ++c)
                if (layout_rank(class_traits()[c]) == rank) lay_out_class(c);
            if (rank == 0) geometry_.boxed = geometry_.count;
            if (rank == 1) geometry_.bounded = geometry_.count;
        }
    }

    void lay_out_class(std::size_t c) {
        const ShapeClass* const old = old_class(c);
        const std::uint32_t start = geometry_.count;
        std::uint32_t slot = old == nullptr ? 0 : old->first;
        for (const Insertion& insertion : insertions_[c]) {
            if (old != nullptr) keep_until(slot, insertion.before);
            if (insertion.leaf >= old_.bounded) new_leaf_[insertion.leaf - old_.bounded] = geometry_.count;
            for (const std::uint32_t i : insertion.added) added_slots_[i] = geometry_.count++;
        }
        if (old != nullptr) keep_until(slot, old->first + old->count);
        if (geometry_.count == start) return;
        ShapeClass shapes;
        shapes.kind = static_cast<ShapeKind>(c / 2);
        shapes.transformed = c % 2 == 1;
        shapes.first = start;
        shapes.count = geometry_.count - start;
        shapes.stride = shapes.count + k_ray_padding;
        resize_in_huge_pages(shapes.values, static_cast<std::size_t>(shapes.stride) *
                                                static_cast<std::size_t>(class_traits()[c].values));
        geometry_.classes.push_back(std::move(shapes));
    }

    // Keeps the old slots from `slot` to `end`, but for the removed ones.
    void keep_until(std::uint32_t& slot, std::uint32_t end) {
        while (slot < end) {
            const auto next = std::lower_bound(removed_slots_.begin(), removed_slots_.end(), slot);
            const std::uint32_t stop = next == removed_slots_.end() ? end : std::min(*next, end);
            if (stop > slot) {
                result_.runs.push_back({slot, geometry_.count, stop - slot});
                std::iota(new_slot_.begin() + slot, new_slot_.begin() + stop, geometry_.count);
                geometry_.count += stop - slot;
            }
            if (stop < end) new_slot_[stop] = geometry_.count;  // where the next one goes
            slot = std::min(stop + 1, end);
        }
    }

    void copy_slots() {
        for (int a = 0; a < 3; ++a) {
            geometry_.box_lo[a] = result_.move_slots(old_.box_lo[a], geometry_.boxed);
            geometry_.box_hi[a] = result_.move_slots(old_.box_hi[a], geometry_.boxed);
        }
        geometry_.shape_index = result_.move_slots(old_.shape_index, geometry_.count);
        for (const SlotRun& run : result_.runs)
            for (std::uint32_t slot = run.to; slot < run.to + run.count; ++slot)
                geometry_.shape_index[slot] = new_shape_[geometry_.shape_index[slot]];
        if (old_.has_elements()) geometry_.element = result_.move_slots(old_.element, geometry_.count);
        geometry_.open = result_.move_slots(old_.open, geometry_.count);
        for (ShapeClass& shapes : geometry_.classes) {
            const ShapeClass* const old = old_class(class_of(shapes));
            if (old == nullptr) continue;
            const std::size_t columns = shapes.values.size() / shapes.stride;
            for (const SlotRun& run : result_.runs) {
                if (run.to < shapes.first || run.to >= shapes.first + shapes.count) continue;
                for (std::size_t k = 0; k < columns; ++k)
                    std::copy_n(old->values.data() + k * old->stride + (run.from - old->first), run.count,
                                shapes.values.data() + k * shapes.stride + (run.to - shapes.first));
            }
        }
    }

    void write_added() {
        for (std::size_t i = 0; i < added_.size(); ++i) {
            const std::uint32_t slot = added_slots_[i];
            if (slot == k_none) continue;
            write_primitive(primitives_, primitive(i), slot, geometry_.class_of(slot), geometry_);
            if (slot < geometry_.boxed) write_box(boxes_[i], slot, geometry_);
            result_.added.push_back(slot);
        }
    }

    void finish() {
        geometry_.set_meshes(old_.meshes);
        geometry_.scene_shapes = static_cast<std::uint32_t>(scene_.shapes.size());
        geometry_.has_cones = !scene_.get<Cone>().empty();
        geometry_.shared_index = std::make_shared<SharedEditIndex>();
        geometry_.built_cost = old_.expected_built_cost();
        geometry_.cost = find_cost(geometry_.bvh);
    }

    const PackedGeometry& old_;
    const Scene& scene_;
    const bool cones_;
    const std::span<const std::uint32_t> removed_, added_;
    const Primitives primitives_;
    SplicedGeometry result_;
    PackedGeometry& geometry_ = result_.geometry;
    std::vector<std::uint32_t> new_shape_;      // by old shape
    std::vector<std::uint32_t> removed_slots_;  // sorted
    std::vector<Aabb> boxes_;                   // of the shapes that are put in
    std::array<std::vector<Insertion>, k_primitive_classes> insertions_;
    std::vector<std::uint32_t> new_slot_;     // by old slot; of a removed one, that of the next
    std::vector<std::uint32_t> new_leaf_;     // first slots of the new leaves
    std::vector<std::uint32_t> added_slots_;  // of the shapes that are put in
};

}  // namespace

std::optional<SplicedGeometry> splice_geometry(const PackedGeometry& old, const Scene& scene, bool cones,
                                               std::span<const std::uint32_t> removed,
                                               std::span<const std::uint32_t> added) {
    return GeometrySplicer(old, scene, cones, removed, added).run();
}

}  // namespace glint
