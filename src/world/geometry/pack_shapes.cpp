// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/pack_shapes.h"

#include <algorithm>
#include <array>

#include "base/huge_pages.h"
#include "base/parallel_chunks.h"
#include "base/sort_stably.h"
#include "bvh/rays.h"
#include "world/geometry/edit_index.h"
#include "world/geometry/pack_mesh.h"
#include "world/geometry/pack_solid.h"

namespace glint {
namespace {

// Leaves are intersected one vector of doubles at a time. Measured for all kinds: leaves of up to 8 items
// render 4% faster than those of up to 16, and 2% faster than those of up to 6. A cost per item, or another
// cost per vector, renders slower.
constexpr std::array<LeafCost, k_primitive_classes> k_leaf_costs{};

// Packs the primitives of a scene.
class Packer {
  public:
    Packer(const Scene& scene, bool cones, const PackedMeshes& meshes, const PrepareOptions& options)
        : options_(options), primitives_(scene, meshes) {
        geometry_.set_meshes(meshes);
        primitives_.add_all(cones);
        has_elements_ = has_elements(scene);
        geometry_.scene_shapes = static_cast<std::uint32_t>(scene.shapes.size());
        geometry_.has_cones = !scene.get<Cone>().empty();
    }

    std::optional<PackedGeometry> run() {
        find_boxes();
        if (!goes_on(0.15)) return std::nullopt;
        geometry_.bvh = build_bvh(leaves_, k_leaf_costs, options_.threads, options_.cancel);
        if (!goes_on(0.75)) return std::nullopt;
        lay_out_classes();
        lay_out_slots();
        for_all(leaves_.size(), [&](std::size_t i) { place(leaves_[i], slot_[i]); });
        for_all(unbounded_.size(), [&](std::size_t i) { primitive_[geometry_.bounded + i] = unbounded_[i]; });
        // The items of a leaf are of one class and consecutive in leaf order, so their slots are consecutive.
        for_all(geometry_.bvh.nodes.size(), [&](std::size_t i) {
            for (BvhChild& child : geometry_.bvh.nodes[i].child) {
                if (child.is_leaf()) child = BvhChild::leaf(slot_[child.first()], child.count());
            }
        });
        // Before the memory of the values is needed.
        std::vector<BvhItem>().swap(leaves_);
        std::vector<std::uint32_t>().swap(slot_);
        allocate_values();
        pack_solids();
        for_all(geometry_.count, [&](std::size_t slot) { write(static_cast<std::uint32_t>(slot)); });
        geometry_.shared_index = std::make_shared<SharedEditIndex>();
        return std::move(geometry_);
    }

  private:
    Primitive at(std::uint32_t i) const { return primitives_[i]; }
    std::size_t class_of(std::uint32_t i) const {
        return static_cast<std::size_t>(primitives_.class_of(at(i)));
    }
    // Operands are in classes of their own, which follow all others.
    std::size_t layout_class_of(std::uint32_t i) const {
        return class_of(i) + (at(i).is_operand() ? k_primitive_classes : 0);
    }

    template <class Body> void for_all(std::size_t count, const Body& body) const {
        parallel_chunks(count, options_.threads, body);
    }

    bool goes_on(double done) const {
        if (options_.progress) options_.progress(done);
        return !options_.cancel.is_set();
    }

    void find_boxes() {
        const AllClassTraits& traits = class_traits();
        const auto count = static_cast<std::uint32_t>(primitives_.size());
        std::uint32_t bounded = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            if (at(i).is_operand()) {
                operands_.push_back(i);
            } else if (traits[class_of(i)].bounded) {
                ++bounded;
            } else {
                unbounded_.push_back(i);
            }
        }
        resize_in_huge_pages(leaves_, bounded, options_.threads);
        std::uint32_t next = 0, skipped = 0, skipped_operands = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            if (skipped < unbounded_.size() && unbounded_[skipped] == i) {
                ++skipped;
            } else if (skipped_operands < operands_.size() && operands_[skipped_operands] == i) {
                ++skipped_operands;
            } else {
                leaves_[next++].item = i;
            }
        }
        for_all(leaves_.size(), [&](std::size_t i) {
            BvhItem& leaf = leaves_[i];
            const Aabb box = primitives_.box_of(at(leaf.item));
            for (int a = 0; a < 3; ++a) leaf.lo[a] = box.lo[a], leaf.hi[a] = box.hi[a];
            leaf.item_class = static_cast<std::uint32_t>(class_of(leaf.item));
        });
    }

    // Bounded classes first: those that store their boxes, then the others. Empty classes are omitted.
    void lay_out_classes() {
        std::array<std::uint32_t, 2 * k_primitive_classes> count{};
        for (std::uint32_t i = 0; i < primitives_.size(); ++i) ++count[layout_class_of(i)];
        const auto lay_out = [&](std::size_t c, std::size_t layout_class) {
            if (count[layout_class] == 0) return;
            ShapeClass packed;
            packed.kind = static_cast<ShapeKind>(c / 2);
            packed.transformed = c % 2 == 1;
            packed.first = geometry_.count;
            packed.count = count[layout_class];
            packed.stride = count[layout_class] + k_ray_padding;
            next_slot_[layout_class] = geometry_.count;
            geometry_.classes.push_back(std::move(packed));
            geometry_.count += count[layout_class];
        };
        for (int rank = 0; rank < 3; ++rank) {
            for (std::size_t c = 0; c < k_primitive_classes; ++c) {
                if (layout_rank(class_traits()[c]) == rank) lay_out(c, c);
            }
            if (rank == 0) geometry_.boxed = geometry_.count;
            if (rank == 1) geometry_.bounded = geometry_.count;
        }
        for (std::size_t c = 0; c < k_primitive_classes; ++c) lay_out(c, c + k_primitive_classes);
    }

    // Within a class: bounded items in leaf order, the others in scene order.
    void lay_out_slots() {
        resize_in_huge_pages(primitive_, geometry_.count, options_.threads);
        resize_in_huge_pages(slot_, leaves_.size(), options_.threads);
        for (std::size_t i = 0; i < leaves_.size(); ++i) slot_[i] = next_slot_[leaves_[i].item_class]++;
        sort_stably(unbounded_, [&](std::uint32_t a, std::uint32_t b) { return class_of(a) < class_of(b); });
        std::uint32_t slot = geometry_.count - static_cast<std::uint32_t>(operands_.size());
        sort_stably(operands_, [&](std::uint32_t a, std::uint32_t b) { return class_of(a) < class_of(b); });
        for (const std::uint32_t i : operands_) primitive_[slot++] = i;
        const std::size_t padded = geometry_.count + k_ray_padding;
        for (int a = 0; a < 3; ++a) {
            resize_in_huge_pages(geometry_.box_lo[a], geometry_.boxed + k_ray_padding, options_.threads);
            resize_in_huge_pages(geometry_.box_hi[a], geometry_.boxed + k_ray_padding, options_.threads);
        }
        resize_in_huge_pages(geometry_.shape_index, padded);
        if (has_elements_) resize_in_huge_pages(geometry_.element, padded);
        resize_in_huge_pages(geometry_.open, padded);
    }

    void place(const BvhItem& leaf, std::uint32_t slot) {
        primitive_[slot] = leaf.item;
        if (slot < geometry_.boxed)
            write_box({{leaf.lo[0], leaf.lo[1], leaf.lo[2]}, {leaf.hi[0], leaf.hi[1], leaf.hi[2]}}, slot,
                      geometry_);
    }

    // Of the operands, which have slots.
    void pack_solids() {
        if (operands_.empty()) return;
        const std::uint32_t first = geometry_.count - static_cast<std::uint32_t>(operands_.size());
        std::vector<std::uint32_t> slots(operands_.size());  // by operand
        geometry_.operands.resize(operands_.size());
        for (std::uint32_t slot = first; slot < geometry_.count; ++slot)
            slots[at(primitive_[slot]).operand] = slot;
        for (const PrimitiveSolid& solid : primitives_.solids())
            geometry_.solids.push_back(pack_solid(primitives_, solid, slots, first, geometry_.operands));
    }

    void allocate_values() {
        for (ShapeClass& shapes : geometry_.classes) {
            const ClassTraits& traits = class_traits()[class_of(primitive_[shapes.first])];
            resize_in_huge_pages(shapes.values,
                                 std::size_t{shapes.stride} * static_cast<std::size_t>(traits.values),
                                 options_.threads);
        }
    }

    void write(std::uint32_t slot) {
        // Prefetches the data of the next slots in steps; see Primitives::prefetch_shape().
        const auto ahead = [&](std::size_t steps) {
            return primitive_[std::min(slot + steps * Primitives::k_prefetch_distance,
                                       primitive_.size() - 1)];
        };
        primitives_.prefetch(ahead(3));
        primitives_.prefetch_shape(at(ahead(2)).shape);
        primitives_.prefetch_parameters(at(ahead(1)).shape);
        write_primitive(primitives_, at(primitive_[slot]), slot, geometry_.class_of(slot), geometry_);
    }

    const PrepareOptions& options_;
    Primitives primitives_;
    PackedGeometry geometry_;
    bool has_elements_ = false;
    std::vector<BvhItem> leaves_;      // the bounded primitives, in leaf order when the hierarchy is built
    std::vector<std::uint32_t> slot_;  // by position in leaf order
    std::vector<std::uint32_t> primitive_;  // by slot
    std::vector<std::uint32_t> unbounded_;  // the unbounded primitives, by class
    std::vector<std::uint32_t> operands_;   // those of solids, by class
    std::array<std::uint32_t, 2 * k_primitive_classes> next_slot_{};
};

}  // namespace

std::optional<PackedGeometry> pack_shapes(const Scene& scene, bool cones, const PrepareOptions& options) {
    PackedMeshes meshes;
    const double triangles = count_mesh_triangles(scene), shapes = static_cast<double>(scene.shapes.size());
    const double of_meshes = triangles / std::max(1.0, triangles + shapes);  // the part of the work
    if (!scene.meshes.empty() && !pack_meshes(scene, meshes, part_of(options, 0, of_meshes)))
        return std::nullopt;
    return Packer(scene, cones, meshes, part_of(options, of_meshes, 1)).run();
}

void write_primitive(const Primitives& primitives, const Primitive& primitive, std::uint32_t slot,
                     ShapeClass& shapes, PackedGeometry& geometry) {
    std::array<double, Primitives::k_max_values> values;
    const int n = primitives.pack(primitive, values.data());
    double* to = shapes.values.data() + (slot - shapes.first);
    for (int k = 0; k < n; ++k)
        to[static_cast<std::size_t>(k) * shapes.stride] = values[static_cast<std::size_t>(k)];
    geometry.shape_index[slot] = primitive.shape;
    if (geometry.has_elements()) geometry.element[slot] = primitive.element;
    geometry.open[slot] = primitives.is_open(primitive) ? 1 : 0;
}

void write_box(const Aabb& box, std::uint32_t slot, PackedGeometry& geometry) {
    for (int a = 0; a < 3; ++a) {
        geometry.box_lo[a][slot] = box.lo[a];
        geometry.box_hi[a][slot] = box.hi[a];
    }
}

std::vector<std::uint32_t> find_slot_materials(const Scene& scene, const PackedGeometry& geometry,
                                               std::size_t materials, int threads) {
    std::vector<std::uint32_t> rows;
    resize_in_huge_pages(rows, geometry.count + k_ray_padding, threads);
    parallel_chunks(geometry.count, threads, [&](std::size_t slot) {
        const Shape& shape = scene.shapes[geometry.shape_index[slot]];
        const PackedOperand* const operand = geometry.operand_of(static_cast<std::uint32_t>(slot));
        const std::uint32_t material = operand != nullptr && operand->has_material
                                           ? scene.solids[scene.get<Solid>()[shape.index].solid]
                                                 .operands[geometry.element[slot]]
                                                 .material
                                           : shape.material;
        rows[slot] = material == k_none ? static_cast<std::uint32_t>(materials) : material;
    });
    return rows;
}

}  // namespace glint
