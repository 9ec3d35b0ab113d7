#include <algorithm>
#include <array>
#include <cstddef>

#include "base/parallel_for.h"
#include "bvh/bvh.h"

namespace glint {
namespace {

constexpr int k_bins = 16;
constexpr std::size_t k_parallel_items = 8192;  // below this a subtree is built by one thread
constexpr int k_balanced_below = 48;  // from this binary depth on, ranges are halved: the depth stays bounded
constexpr float k_traversal_cost = 1.0f, k_item_cost = 1.0f;

struct BinaryNode {
    Aabb box;
    std::uint32_t left = 0, right = 0;  // node indices; left == 0: a leaf
    std::uint32_t first = 0, count = 0;
};

struct Split {
    int axis = -1;
    float position = 0;  // centroids below go left
    float cost = 0;
};

class Builder {
  public:
    Builder(std::span<const Aabb> boxes, std::span<const std::uint8_t> classes,
            std::vector<std::uint32_t>& order)
        : boxes_(boxes), classes_(classes), order_(order), nodes_(2 * boxes.size()) {}

    // The subtree over order[first, first + count) takes nodes [node, node + 2 count - 1), whoever builds it.
    void build(std::uint32_t node, std::uint32_t first, std::uint32_t count, int depth) {
        BinaryNode& n = nodes_[node];
        n.first = first;
        n.count = count;
        Aabb centroids;
        for (std::uint32_t i = first; i < first + count; ++i) {
            n.box.add(boxes_[order_[i]]);
            centroids.add(centroid_box(order_[i]));
        }
        const std::uint32_t middle = choose(n, centroids, depth);
        if (middle == first) return;  // a leaf
        n.left = node + 1;
        n.right = node + 2 * (middle - first);
        const auto left = [&] { build(n.left, first, middle - first, depth + 1); };
        const auto right = [&] { build(n.right, middle, first + count - middle, depth + 1); };
        if (count >= k_parallel_items) {
            parallel_invoke(left, right);
        } else {
            left();
            right();
        }
    }

    const std::vector<BinaryNode>& nodes() const { return nodes_; }

  private:
    float centroid(std::uint32_t item, int axis) const {
        return 0.5f * boxes_[item].lo[axis] + 0.5f * boxes_[item].hi[axis];
    }
    Aabb centroid_box(std::uint32_t item) const {
        Aabb b;
        for (int a = 0; a < 3; ++a) b.lo[a] = b.hi[a] = centroid(item, a);
        return b;
    }

    // Reorders the node's items and returns where its right child begins, or first for a leaf.
    std::uint32_t choose(const BinaryNode& n, const Aabb& centroids, int depth) {
        auto* begin = order_.data() + n.first;
        auto* end = begin + n.count;
        const bool one_class =
            std::all_of(begin, end, [&](std::uint32_t i) { return classes_[i] == classes_[*begin]; });
        const bool may_be_leaf = one_class && n.count <= k_leaf_size;
        if (n.count == 1) return n.first;
        if (n.count <= k_leaf_size && !one_class) {
            // Small and mixed: part the first item's class from the others.
            const std::uint8_t first_class = classes_[*begin];
            auto* middle = std::stable_partition(begin, end,
                                                 [&](std::uint32_t i) { return classes_[i] == first_class; });
            return n.first + static_cast<std::uint32_t>(middle - begin);
        }
        const Split split = depth < k_balanced_below ? best_split(n, centroids) : Split{};
        if (split.axis >= 0) {
            const float leaf_cost = k_item_cost * static_cast<float>(n.count);
            if (may_be_leaf && leaf_cost <= k_traversal_cost + split.cost) return n.first;
            auto* middle = std::stable_partition(
                begin, end, [&](std::uint32_t i) { return centroid(i, split.axis) < split.position; });
            if (middle != begin && middle != end) return n.first + static_cast<std::uint32_t>(middle - begin);
        }
        if (may_be_leaf) return n.first;
        return n.first + n.count / 2;  // all centroids equal, or too deep: halves in the order they stand
    }

    Split best_split(const BinaryNode& n, const Aabb& centroids) const {
        Split best;
        const float parent = n.box.half_area();
        for (int axis = 0; axis < 3; ++axis) {
            const float lo = centroids.lo[axis], size = centroids.hi[axis] - lo;
            if (!(size > 0)) continue;
            const float scale = static_cast<float>(k_bins) / size;
            std::array<Aabb, k_bins> box;
            std::array<std::uint32_t, k_bins> count{};
            for (std::uint32_t i = n.first; i < n.first + n.count; ++i) {
                const std::uint32_t item = order_[i];
                const float f = (centroid(item, axis) - lo) * scale;
                const int bin = f < static_cast<float>(k_bins) ? static_cast<int>(f) : k_bins - 1;
                box[bin].add(boxes_[item]);
                ++count[bin];
            }
            std::array<float, k_bins> right_cost{};
            Aabb grown;
            std::uint32_t items = 0;
            for (int b = k_bins - 1; b > 0; --b) {
                grown.add(box[b]);
                items += count[b];
                right_cost[b] = grown.half_area() * static_cast<float>(items);
            }
            grown = Aabb{};
            items = 0;
            for (int b = 1; b < k_bins; ++b) {
                grown.add(box[b - 1]);
                items += count[b - 1];
                if (items == 0 || items == n.count) continue;
                const float area = grown.half_area() * static_cast<float>(items) + right_cost[b];
                const float cost = parent > 0 ? k_item_cost * area / parent : 0;
                if (best.axis < 0 || cost < best.cost) {
                    best = {axis, lo + static_cast<float>(b) / scale, cost};
                }
            }
        }
        return best;
    }

    std::span<const Aabb> boxes_;
    std::span<const std::uint8_t> classes_;
    std::vector<std::uint32_t>& order_;
    std::vector<BinaryNode> nodes_;
};

// Opens the child with the largest box until the node is full.
class Joiner {
  public:
    Joiner(const std::vector<BinaryNode>& binary, std::vector<BvhNode>& wide)
        : binary_(binary), wide_(wide) {}

    std::uint32_t join(std::uint32_t root) {
        std::array<std::uint32_t, k_bvh_width> children{};
        int count = 1;
        children[0] = root;
        while (count < k_bvh_width) {
            int widest = -1;
            float widest_area = -1;
            for (int i = 0; i < count; ++i) {
                const BinaryNode& n = binary_[children[i]];
                if (n.left != 0 && n.box.half_area() > widest_area)
                    widest = i, widest_area = n.box.half_area();
            }
            if (widest < 0) break;
            const BinaryNode& n = binary_[children[widest]];
            children[widest] = n.left;
            children[count++] = n.right;
        }
        const auto index = static_cast<std::uint32_t>(wide_.size());
        wide_.emplace_back();
        for (int i = 0; i < k_bvh_width; ++i) {
            const Aabb box = i < count ? binary_[children[i]].box : Aabb{};
            for (int a = 0; a < 3; ++a) {
                wide_[index].lo[a][i] = box.lo[a];
                wide_[index].hi[a][i] = box.hi[a];
            }
            wide_[index].child[i] = BvhChild::none();
        }
        for (int i = 0; i < count; ++i) {
            const BinaryNode& n = binary_[children[i]];
            const BvhChild child =
                n.left != 0 ? BvhChild::node(join(children[i])) : BvhChild::leaf(n.first, n.count);
            wide_[index].child[i] = child;
        }
        return index;
    }

  private:
    const std::vector<BinaryNode>& binary_;
    std::vector<BvhNode>& wide_;
};

}  // namespace

Bvh build_bvh(std::span<const Aabb> boxes, std::span<const std::uint8_t> item_class, int threads) {
    Bvh bvh;
    if (boxes.empty()) return bvh;
    const auto count = static_cast<std::uint32_t>(boxes.size());
    bvh.order.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) bvh.order[i] = i;
    Builder builder(boxes, item_class, bvh.order);
    run_with_threads(threads, [&] { builder.build(0, 0, count, 0); });
    bvh.bounds = builder.nodes()[0].box;
    Joiner(builder.nodes(), bvh.nodes).join(0);
    bvh.nodes.shrink_to_fit();
    return bvh;
}

}  // namespace glint
