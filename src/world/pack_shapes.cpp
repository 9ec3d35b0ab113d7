#include "world/pack_shapes.h"

#include <algorithm>
#include <array>
#include <span>
#include <type_traits>

#include "base/huge_pages.h"
#include "base/parallel_for.h"
#include "bvh/rays.h"
#include "geometry/kinds-inl.h"
#include "math/extent.h"
#include "math/transform.h"
#include "world/triangulate.h"

namespace glint {
namespace {

using namespace HWY_NAMESPACE;

// A class is a kind, transformed or not.
constexpr int k_classes = 2 * k_shape_kinds;

// Leaves are met a vector of doubles at a time. Measured for every kind alike: leaves of up to 8 items draw
// 4% faster than those of up to 16, 2% faster than those of up to 6; a cost for each item, or another one of
// the vector, draws slower.
constexpr std::array<LeafCost, k_classes> k_leaf_costs{};

// What is packed: a shape, or a piece of one (a polygon's triangle).
struct Item {
    std::uint32_t shape = 0;
    std::uint32_t piece = k_none;  // into Items::pieces
};
struct Items {
    std::vector<Item> list;
    std::vector<Triangle> pieces;
};

// What a kind says of itself: how many values, whether it has a box.
struct KindFacts {
    int values = 0;
    bool bounded = true;
    bool stores_box = true;
    bool takes_maps = false;
    template <class Geometry> void visit() {
        takes_maps = Geometry::k_takes_maps;
        values = Geometry::k_values;
        bounded = Geometry::k_bounded;
        stores_box = bounded && !k_is_triangle<Geometry>;
    }
};

using Facts = std::array<KindFacts, k_classes>;
Facts all_facts() {
    Facts facts;
    for (int c = 0; c < k_classes; ++c) visit_geometry(static_cast<ShapeKind>(c / 2), c % 2 == 1, facts[c]);
    return facts;
}

Items list_items(const Scene& scene) {
    Items items;
    items.list.reserve(scene.shapes.size());
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
        const Shape& shape = scene.shapes[i];
        if (shape.kind == ShapeKind::cone && !scene.conventions.cones) continue;
        if (shape.kind != ShapeKind::polygon) {
            items.list.push_back({i, k_none});
            continue;
        }
        const Polygon& polygon = scene.get<Polygon>()[shape.index];
        const auto first = static_cast<std::uint32_t>(items.pieces.size());
        triangulate(std::span(scene.polygon_vertices).subspan(polygon.first, polygon.count), items.pieces);
        for (auto piece = first; piece < items.pieces.size(); ++piece) items.list.push_back({i, piece});
    }
    return items;
}

// Packs a scene's items into a world.
class Packer {
  public:
    Packer(const Scene& scene, World& world, int threads)
        : scene_(scene), world_(world), threads_(threads), items_(list_items(scene)), facts_(all_facts()) {}

    void run() {
        build_hierarchy();
        lay_out_classes();
        lay_out_slots();
        for_all(leaves_.size(),
                [&](std::size_t i) { fill(items_.list[leaves_[i].item], slot_[i], &leaves_[i]); });
        for_all(unbounded_.size(), [&](std::size_t i) {
            fill(items_.list[unbounded_[i]], world_.bounded + static_cast<std::uint32_t>(i), nullptr);
        });
        // A leaf's items are of one class and consecutive in leaf order, so their slots are consecutive too.
        for_all(world_.bvh.nodes.size(), [&](std::size_t i) {
            for (BvhChild& child : world_.bvh.nodes[i].child) {
                if (child.is_leaf()) child = BvhChild::leaf(slot_[child.first()], child.count());
            }
        });
    }

  private:
    int class_of(const Item& item) const {
        const Shape& s = scene_.shapes[item.shape];
        const ShapeKind kind = item.piece == k_none ? s.kind : ShapeKind::triangle;
        const int plain = 2 * static_cast<int>(kind);
        return plain + (s.transform != k_none && !facts_[plain].takes_maps ? 1 : 0);
    }

    template <class Body> void for_all(std::size_t count, Body&& body) const {
        constexpr std::size_t chunk = 16384;
        parallel_for((count + chunk - 1) / chunk, threads_, [&](std::size_t block) {
            const std::size_t end = std::min(count, (block + 1) * chunk);
            for (std::size_t i = block * chunk; i < end; ++i) body(i);
        });
    }

    // The transform that the item is packed with: none where its parameters take it.
    std::uint32_t map_of(const Item& item) const {
        return class_of(item) % 2 == 1 ? scene_.shapes[item.shape].transform : k_none;
    }

    // Calls visit(parameters, geometry), with the shape's map taken into the parameters where the kind
    // allows.
    template <class Visit, class Parameters, class Geometry>
    void visit_mapped(const Shape& shape, const Parameters& parameters, Geometry geometry,
                      Visit&& visit) const {
        if constexpr (Geometry::k_takes_maps) {
            if (shape.transform != k_none) {
                const Affine& map = scene_.transforms[shape.transform];
                // validate() has made sure that it can be inverted.
                return visit(Geometry::mapped(parameters, map, inverse(map).value_or(Affine{})), geometry);
            }
        }
        visit(parameters, geometry);
    }

    // Calls visit(parameters, geometry) for the item's kind.
    template <class Visit> void with_parameters(const Item& item, Visit&& visit) const {
        const Shape& shape = scene_.shapes[item.shape];
        if (item.piece != k_none)
            return visit_mapped(shape, items_.pieces[item.piece], TriangleGeometry(), visit);
        switch (shape.kind) {
#define GLINT_KIND(Type, word)                                                             \
    case ShapeKind::word:                                                                  \
        if constexpr (!std::is_same_v<Type, Polygon>) {                                    \
            visit_mapped(shape, scene_.get<Type>()[shape.index], Type##Geometry(), visit); \
        }                                                                                  \
        break;
            GLINT_SHAPES(GLINT_KIND)
#undef GLINT_KIND
        }
    }

    Aabb box_of(const Item& item) const {
        Vec3 lo, hi;
        with_parameters(item,
                        [&](const auto& parameters, auto geometry) { geometry.bounds(parameters, lo, hi); });
        const std::uint32_t transform = map_of(item);
        if (transform != k_none) {
            Extent extent;  // of the box's corners
            for (int corner = 0; corner < 8; ++corner) {
                extent.add(transform_point(
                    scene_.transforms[transform],
                    {corner & 1 ? hi.x : lo.x, corner & 2 ? hi.y : lo.y, corner & 4 ? hi.z : lo.z}));
            }
            lo = extent.lo, hi = extent.hi;
        }
        return padded_box(lo, hi);
    }

    bool turns_normal(const Item& item) const {
        if (scene_.conventions.facing != Facing::open) return scene_.conventions.facing == Facing::all;
        bool open = false;
        with_parameters(item,
                        [&](const auto& parameters, auto geometry) { open = geometry.open(parameters); });
        return open;
    }

    bool casts_no_shadow(std::uint32_t material) const {
        return scene_.conventions.glass_shadow == GlassShadow::none && material < scene_.materials.size() &&
               scene_.materials[material].transmission > 0;
    }

    void build_hierarchy() {
        std::uint32_t bounded = 0;
        for (std::uint32_t i = 0; i < items_.list.size(); ++i) {
            if (facts_[class_of(items_.list[i])].bounded) {
                ++bounded;
            } else {
                unbounded_.push_back(i);
            }
        }
        resize_in_huge_pages(leaves_, bounded);
        std::uint32_t next = 0, skipped = 0;
        for (std::uint32_t i = 0; i < items_.list.size(); ++i) {
            if (skipped < unbounded_.size() && unbounded_[skipped] == i) {
                ++skipped;
            } else {
                leaves_[next++].item = i;
            }
        }
        for_all(leaves_.size(), [&](std::size_t i) {
            BvhItem& leaf = leaves_[i];
            const Item& item = items_.list[leaf.item];
            const Aabb box = box_of(item);
            for (int a = 0; a < 3; ++a) leaf.lo[a] = box.lo[a], leaf.hi[a] = box.hi[a];
            leaf.item_class = static_cast<std::uint32_t>(class_of(item));
        });
        world_.bvh = build_bvh(leaves_, k_leaf_costs, threads_);
    }

    // Bounded classes first, those that store their boxes before the others; an empty class is left out.
    void lay_out_classes() {
        std::array<std::uint32_t, k_classes> count{};
        for (const Item& item : items_.list) ++count[class_of(item)];
        for (int rank = 0; rank < 3; ++rank) {
            for (int c = 0; c < k_classes; ++c) {
                if (2 - facts_[c].bounded - facts_[c].stores_box != rank || count[c] == 0) continue;
                ShapeClass packed;
                packed.kind = static_cast<ShapeKind>(c / 2);
                packed.transformed = c % 2 == 1;
                packed.first = world_.count;
                packed.count = count[c];
                packed.stride = count[c] + k_ray_padding;
                resize_in_huge_pages(packed.values,
                                     static_cast<std::size_t>(packed.stride) * facts_[c].values);
                next_slot_[c] = world_.count;
                class_index_[c] = world_.classes.size();
                world_.classes.push_back(std::move(packed));
                world_.count += count[c];
            }
            if (rank == 0) world_.boxed = world_.count;
            if (rank == 1) world_.bounded = world_.count;
        }
    }

    // Within a class, bounded items in leaf order, the others in the scene's.
    void lay_out_slots() {
        resize_in_huge_pages(slot_, leaves_.size());
        for (std::size_t i = 0; i < leaves_.size(); ++i) slot_[i] = next_slot_[leaves_[i].item_class]++;
        std::stable_sort(unbounded_.begin(), unbounded_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return class_of(items_.list[a]) < class_of(items_.list[b]);
        });
        const std::size_t padded = world_.count + k_ray_padding;
        for (int a = 0; a < 3; ++a) {
            resize_in_huge_pages(world_.box_lo[a], world_.boxed + k_ray_padding);
            resize_in_huge_pages(world_.box_hi[a], world_.boxed + k_ray_padding);
        }
        resize_in_huge_pages(world_.shape_index, padded);
        resize_in_huge_pages(world_.material, padded);
    }

    // box: of a bounded item.
    void fill(const Item& item, std::uint32_t slot, const BvhItem* box) {
        const Shape& shape = scene_.shapes[item.shape];
        world_.shape_index[slot] = item.shape;
        const auto last = static_cast<std::uint32_t>(scene_.materials.size());  // the default material
        const std::uint32_t material = shape.material == k_none ? last : shape.material;
        world_.material[slot] = material | (turns_normal(item) ? k_turn_normal : 0) |
                                (casts_no_shadow(material) ? k_no_shadow : 0);

        std::array<double, k_max_values> values;
        int n = 0;
        with_parameters(item, [&](const auto& parameters, auto geometry) {
            static_assert(Transformed<decltype(geometry)>::k_values <= k_max_values);
            geometry.pack(parameters, values.data());
            n = decltype(geometry)::k_values;
        });
        if (map_of(item) != k_none) {
            const Affine object_from_world = inverse(scene_.transforms[map_of(item)]).value_or(Affine{});
            for (const auto& row : object_from_world.m) {
                for (const double value : row) values[n++] = value;
            }
        }
        ShapeClass& packed = world_.classes[class_index_[class_of(item)]];
        for (int k = 0; k < n; ++k) {
            packed.values[static_cast<std::size_t>(k) * packed.stride + (slot - packed.first)] = values[k];
        }
        if (slot >= world_.boxed) return;
        for (int a = 0; a < 3; ++a) {
            world_.box_lo[a][slot] = box->lo[a];
            world_.box_hi[a][slot] = box->hi[a];
        }
    }

    static constexpr int k_max_values = 64;

    const Scene& scene_;
    World& world_;
    int threads_;
    Items items_;
    Facts facts_;
    std::vector<BvhItem> leaves_;           // the items with boxes, in leaf order once the hierarchy is built
    std::vector<std::uint32_t> slot_;       // by place in leaf order
    std::vector<std::uint32_t> unbounded_;  // the items without, by class
    std::array<std::uint32_t, k_classes> next_slot_{};
    std::array<std::size_t, k_classes> class_index_{};
};

}  // namespace

void pack_shapes(const Scene& scene, World& world, int threads) { Packer(scene, world, threads).run(); }

}  // namespace glint
