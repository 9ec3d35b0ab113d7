// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/pack_shapes.h"

#include <algorithm>
#include <array>

#include "base/huge_pages.h"
#include "base/parallel_chunks.h"
#include "bvh/rays.h"
#include "world/geometry/edit_index.h"
#include "world/geometry/pack_mesh.h"

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
        for_all(leaves_.size(), [&](std::size_t i) {
            prefetch(i);
            write(leaves_[i].item, slot_[i], &leaves_[i]);
        });
        for_all(unbounded_.size(), [&](std::size_t i) {
            write(unbounded_[i], geometry_.bounded + static_cast<std::uint32_t>(i), nullptr);
        });
        // The items of a leaf are of one class and consecutive in leaf order, so their slots are consecutive.
        for_all(geometry_.bvh.nodes.size(), [&](std::size_t i) {
            for (BvhChild& child : geometry_.bvh.nodes[i].child) {
                if (child.is_leaf()) child = BvhChild::leaf(slot_[child.first()], child.count());
            }
        });
        geometry_.shared_index = std::make_shared<SharedEditIndex>();
        return std::move(geometry_);
    }

  private:
    const Primitive& at(std::uint32_t i) const { return primitives_.list()[i]; }
    std::size_t class_of(std::uint32_t i) const {
        return static_cast<std::size_t>(primitives_.class_of(at(i)));
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
        const auto count = static_cast<std::uint32_t>(primitives_.list().size());
        std::uint32_t bounded = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            if (traits[class_of(i)].bounded) {
                ++bounded;
            } else {
                unbounded_.push_back(i);
            }
        }
        resize_in_huge_pages(leaves_, bounded);
        std::uint32_t next = 0, skipped = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            if (skipped < unbounded_.size() && unbounded_[skipped] == i) {
                ++skipped;
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
        std::array<std::uint32_t, k_primitive_classes> count{};
        for (const Primitive& p : primitives_.list())
            ++count[static_cast<std::size_t>(primitives_.class_of(p))];
        for (int rank = 0; rank < 3; ++rank) {
            for (std::size_t c = 0; c < count.size(); ++c) {
                const ClassTraits& traits = class_traits()[c];
                if (2 - traits.bounded - traits.stores_box != rank || count[c] == 0) continue;
                ShapeClass packed;
                packed.kind = static_cast<ShapeKind>(c / 2);
                packed.transformed = c % 2 == 1;
                packed.first = geometry_.count;
                packed.count = count[c];
                packed.stride = count[c] + k_ray_padding;
                resize_in_huge_pages(packed.values, static_cast<std::size_t>(packed.stride) *
                                                        static_cast<std::size_t>(traits.values));
                next_slot_[c] = geometry_.count;
                class_index_[c] = geometry_.classes.size();
                geometry_.classes.push_back(std::move(packed));
                geometry_.count += count[c];
            }
            if (rank == 0) geometry_.boxed = geometry_.count;
            if (rank == 1) geometry_.bounded = geometry_.count;
        }
    }

    // Within a class: bounded items in leaf order, the others in scene order.
    void lay_out_slots() {
        resize_in_huge_pages(slot_, leaves_.size());
        for (std::size_t i = 0; i < leaves_.size(); ++i) slot_[i] = next_slot_[leaves_[i].item_class]++;
        std::stable_sort(unbounded_.begin(), unbounded_.end(),
                         [&](std::uint32_t a, std::uint32_t b) { return class_of(a) < class_of(b); });
        const std::size_t padded = geometry_.count + k_ray_padding;
        for (int a = 0; a < 3; ++a) {
            resize_in_huge_pages(geometry_.box_lo[a], geometry_.boxed + k_ray_padding);
            resize_in_huge_pages(geometry_.box_hi[a], geometry_.boxed + k_ray_padding);
        }
        resize_in_huge_pages(geometry_.shape_index, padded);
        if (has_elements_) resize_in_huge_pages(geometry_.element, padded);
        resize_in_huge_pages(geometry_.open, padded);
    }

    // Prefetches the data of the next leaves in steps; see Primitives::prefetch_shape().
    void prefetch(std::size_t i) const {
        const auto item = [&](std::size_t ahead) {
            return leaves_[std::min(i + ahead, leaves_.size() - 1)].item;
        };
        __builtin_prefetch(&at(item(3 * Primitives::k_prefetch_distance)));
        primitives_.prefetch_shape(at(item(2 * Primitives::k_prefetch_distance)).shape);
        primitives_.prefetch_parameters(at(item(Primitives::k_prefetch_distance)).shape);
    }

    // box: of a bounded primitive.
    void write(std::uint32_t i, std::uint32_t slot, const BvhItem* box) {
        Aabb bounds;
        if (box != nullptr)
            for (int a = 0; a < 3; ++a) bounds.lo[a] = box->lo[a], bounds.hi[a] = box->hi[a];
        write_primitive(primitives_, at(i), bounds, slot, geometry_.classes[class_index_[class_of(i)]],
                        geometry_);
    }

    const PrepareOptions& options_;
    Primitives primitives_;
    PackedGeometry geometry_;
    bool has_elements_ = false;
    std::vector<BvhItem> leaves_;      // the bounded primitives, in leaf order when the hierarchy is built
    std::vector<std::uint32_t> slot_;  // by position in leaf order
    std::vector<std::uint32_t> unbounded_;  // the unbounded primitives, by class
    std::array<std::uint32_t, k_primitive_classes> next_slot_{};
    std::array<std::size_t, k_primitive_classes> class_index_{};
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

void write_primitive(const Primitives& primitives, const Primitive& primitive, const Aabb& box,
                     std::uint32_t slot, ShapeClass& shapes, PackedGeometry& geometry) {
    std::array<double, Primitives::k_max_values> values;
    const int n = primitives.pack(primitive, values.data());
    double* to = shapes.values.data() + (slot - shapes.first);
    for (int k = 0; k < n; ++k)
        to[static_cast<std::size_t>(k) * shapes.stride] = values[static_cast<std::size_t>(k)];
    geometry.shape_index[slot] = primitive.shape;
    if (geometry.has_elements()) geometry.element[slot] = primitive.element;
    geometry.open[slot] = primitives.is_open(primitive) ? 1 : 0;
    if (slot >= geometry.boxed) return;
    for (int a = 0; a < 3; ++a) {
        geometry.box_lo[a][slot] = box.lo[a];
        geometry.box_hi[a][slot] = box.hi[a];
    }
}

std::vector<std::uint32_t> find_slot_materials(const Scene& scene, const PackedGeometry& geometry,
                                               std::size_t materials, int threads) {
    std::vector<std::uint32_t> rows;
    resize_in_huge_pages(rows, geometry.count + k_ray_padding);
    parallel_chunks(geometry.count, threads, [&](std::size_t slot) {
        const std::uint32_t material = scene.shapes[geometry.shape_index[slot]].material;
        rows[slot] = material == k_none ? static_cast<std::uint32_t>(materials) : material;
    });
    return rows;
}

}  // namespace glint
