// SPDX-License-Identifier: Apache-2.0
// Builds the binary tree top down. Ranges above a size are split one after another, each on all threads; the
// remaining ranges become subtrees, each built on one thread.
#include <algorithm>
#include <cstddef>

#include "base/parallel_for.h"
#include "bvh/binary_tree.h"
#include "bvh/bins.h"
#include "bvh/partition.h"

namespace glint {
namespace {

constexpr std::uint32_t k_lowest = 2;       // maximum items of one class in a lowest node
constexpr std::uint32_t k_mixed = 32;       // items of several classes for which both splits are tried
constexpr std::uint32_t k_min_task = 2048;  // minimum items of a subtree built as a task
constexpr std::uint32_t k_tasks = 64;
// From this depth on, ranges are halved regardless of class. The depth is then at most 48 + 27
// (k_bvh_max_items is 2^27), or 48 + 31 if the split of k_mixed items by class has just begun: both are below
// k_bvh_max_depth.
constexpr int k_balanced_below = 48;

// Areas are relative to the scene's size, so that they do not overflow.
float area_scale(const Box4& whole) {
    const Float4 side = whole.hi - whole.lo;
    const float most = std::max({side[0], side[1], side[2]});
    return most > 1e-30f ? 1 / most : 1;
}

class Builder {
  public:
    Builder(std::span<BvhItem> items, std::span<const LeafCost> costs, int threads, CancelFlag cancel)
        : items_(items), costs_(costs), threads_(threads), cancel_(cancel) {}

    std::vector<Subtree> run() {
        const ItemRange whole = whole_range();
        area_scale_ = area_scale(whole.box);
        task_items_ = std::max(k_min_task, whole.count / k_tasks);
        build_top(whole);
        subtrees_.resize(1 + tasks_.size());
        cuts_.resize(tasks_.size());
        parallel_for(tasks_.size(), threads_, [&](std::size_t i) {
            if (is_cancelled()) return;
            Subtree& subtree = subtrees_[1 + i];
            subtree.tree.reserve(2 * std::size_t{tasks_[i].range.count});
            subtree.tree.emplace_back();
            build(subtree.tree, 0, tasks_[i].range, tasks_[i].depth, cuts_[i]);
            condense(subtree);
        });
        if (is_cancelled()) return {};
        cut_top();
        return std::move(subtrees_);
    }

  private:
    struct Task {
        ItemRange range;
        int depth;
    };

    // Once true, it stays true, because part of the tree is then missing.
    bool is_cancelled() {
        if (cancel_.is_set()) is_cancelled_ = true;
        return is_cancelled_;
    }

    ItemRange whole_range() const {
        std::vector<ItemRange> chunks((items_.size() + k_chunk - 1) / k_chunk);
        parallel_for(chunks.size(), threads_, [&](std::size_t c) {
            for (const BvhItem& item :
                 items_.subspan(c * k_chunk, std::min(k_chunk, items_.size() - c * k_chunk))) {
                chunks[c].box.add(load3(item.lo), load3(item.hi));
                const Float4 at = centroid(item);
                chunks[c].centroids.add(at, at);
            }
        });
        ItemRange whole;
        whole.count = static_cast<std::uint32_t>(items_.size());
        for (const ItemRange& c : chunks) {
            whole.box.add(c.box);
            whole.centroids.add(c.centroids);
        }
        return whole;
    }

    Split best_split(const ItemRange& range, const Binning& binning, int threads) const {
        const std::span<const BvhItem> items = items_.subspan(range.first, range.count);
        Bins bins(binning.bins);
        if (items.size() <= k_chunk) {
            bins.add(items, binning);
        } else {
            std::vector<Bins> chunks((items.size() + k_chunk - 1) / k_chunk, bins);
            parallel_for(chunks.size(), threads, [&](std::size_t c) {
                chunks[c].add(items.subspan(c * k_chunk, std::min(k_chunk, items.size() - c * k_chunk)),
                              binning);
            });
            for (const Bins& c : chunks) bins.add(c);
        }
        return bins.best_split(area_scale_);
    }

    // noinline: keeps the bins out of the stack frames of the recursion.
    __attribute__((noinline)) SplitRanges split_range(const ItemRange& range, int depth, int threads) const {
        if (depth < k_balanced_below) {
            const Binning binning(range);
            const Split split = best_split(range, binning, threads);
            if (split.axis >= 0) return partition(items_, range, binning, split, threads);
        }
        return halve(items_, range);  // all centroids are equal, or the depth is too large
    }

    bool of_one_class(const ItemRange& range) const {
        const std::span<const BvhItem> items = items_.subspan(range.first, range.count);
        return std::all_of(items.begin(), items.end(),
                           [&](const BvhItem& i) { return i.item_class == items[0].item_class; });
    }

    static std::uint32_t add_children(BinaryTree& tree, std::uint32_t node, const ItemRange& range) {
        BinaryNode& n = tree[node];
        n.box = range.box.aabb();
        n.first = range.first;
        n.count = range.count;
        n.left = static_cast<std::uint32_t>(tree.size());
        tree.resize(tree.size() + 2);
        return tree[node].left;
    }

    // Two items are separated if their boxes are small compared with their common box.
    bool is_lowest(const ItemRange& range) const {
        if (range.count == 1) return true;
        if (range.count > k_lowest || !of_one_class(range)) return false;
        const BvhItem &a = items_[range.first], &b = items_[range.first + 1];
        if (costs_[a.item_class].most < 2) return false;
        const auto area = [&](const BvhItem& i) {
            Box4 box;
            box.add(load3(i.lo), load3(i.hi));
            return half_area(box, area_scale_);
        };
        return area(a) + area(b) >= half_area(range.box, area_scale_);
    }

    void build(BinaryTree& tree, std::uint32_t node, const ItemRange& range, int depth, CutCosts& cut) const {
        if (is_lowest(range)) {
            BinaryNode& n = tree[node];
            n.box = range.box.aabb();
            n.first = range.first;
            n.count = range.count;
            choose_cut(n, half_area(range.box, area_scale_), items_[range.first].item_class, costs_, cut);
        } else if (range.count == 2) {
            build(tree, node, range, halve(items_, range), depth, cut);
        } else if (range.count > k_mixed || depth >= k_balanced_below || of_one_class(range)) {
            build(tree, node, range, split_range(range, depth, 1), depth, cut);
        } else {
            build_mixed(tree, node, range, depth, cut);
        }
    }

    void build(BinaryTree& tree, std::uint32_t node, const ItemRange& range, const SplitRanges& ranges,
               int depth, CutCosts& cut) const {
        const std::uint32_t left = add_children(tree, node, range);
        CutCosts left_cut, right_cut;
        build(tree, left, ranges.left, depth + 1, left_cut);
        build(tree, left + 1, ranges.right, depth + 1, right_cut);
        choose_cut(tree[node], half_area(range.box, area_scale_), left_cut, right_cut, costs_, cut);
    }

    // Splits the items by position and by class, and keeps the split whose two roots cost less.
    __attribute__((noinline)) void build_mixed(BinaryTree& tree, std::uint32_t node, const ItemRange& range,
                                               int depth, CutCosts& cut) const {
        const auto items = items_.begin() + range.first;
        const auto end = static_cast<std::ptrdiff_t>(tree.size());
        std::array<BvhItem, k_mixed> by_place;
        BinaryTree tree_by_place;
        build(tree, node, range, split_range(range, depth, 1), depth, cut);
        std::copy_n(items, range.count, by_place.begin());
        tree_by_place.assign(tree.begin() + end, tree.end());
        const BinaryNode node_by_place = tree[node];
        tree.resize(static_cast<std::size_t>(end));
        CutCosts cut_by_class;
        build_by_class(tree, node, range, depth, cut_by_class);
        if (cut_by_class.cost[1] < cut.cost[1]) {
            cut = cut_by_class;
            return;
        }
        std::copy_n(by_place.begin(), range.count, items);
        tree.resize(static_cast<std::size_t>(end));
        tree.insert(tree.end(), tree_by_place.begin(), tree_by_place.end());
        tree[node] = node_by_place;
    }

    // Splits off one class at a time. Only one kind of split is tried below: both would take exponential time
    void build_by_class(BinaryTree& tree, std::uint32_t node, const ItemRange& range, int depth,
                        CutCosts& cut) const {
        if (of_one_class(range)) return build(tree, node, range, depth, cut);
        const SplitRanges ranges = partition_by_class(items_, range);
        const std::uint32_t left = add_children(tree, node, range);
        CutCosts left_cut, right_cut;
        build(tree, left, ranges.left, depth + 1, left_cut);
        build_by_class(tree, left + 1, ranges.right, depth + 1, right_cut);
        choose_cut(tree[node], half_area(range.box, area_scale_), left_cut, right_cut, costs_, cut);
    }

    // Builds the top tree without its cut, and the tasks. Children come after their parents.
    void build_top(const ItemRange& whole) {
        subtrees_.resize(1);
        BinaryTree& top = subtrees_[0].tree;
        top.emplace_back();
        std::vector<std::pair<std::uint32_t, Task>> open{{0, {whole, 0}}};
        while (!open.empty() && !is_cancelled()) {
            const auto [node, task] = open.back();
            open.pop_back();
            if (task.range.count <= task_items_) {
                tasks_.push_back(task);
                top[node].box = task.range.box.aabb();
                top[node].is_link = true;
                top[node].left = static_cast<std::uint32_t>(tasks_.size());
                continue;
            }
            const SplitRanges ranges = split_range(task.range, task.depth, threads_);
            const std::uint32_t left = add_children(top, node, task.range);
            open.push_back({left + 1, {ranges.right, task.depth + 1}});
            open.push_back({left, {ranges.left, task.depth + 1}});
        }
    }

    void cut_top() {
        BinaryTree& top = subtrees_[0].tree;
        std::vector<CutCosts> cuts(top.size());
        for (std::size_t i = top.size(); i-- > 0;) {
            BinaryNode& n = top[i];
            if (n.is_link) {
                cuts[i] = cuts_[n.left - 1];
                continue;
            }
            Box4 box;
            box.add(load3_exact(n.box.lo), load3_exact(n.box.hi));
            choose_cut(n, half_area(box, area_scale_), cuts[n.left], cuts[n.left + 1], costs_, cuts[i]);
        }
    }
    static Float4 load3_exact(const float* p) { return Float4{p[0], p[1], p[2], 0}; }

    std::span<BvhItem> items_;
    std::span<const LeafCost> costs_;
    int threads_;
    CancelFlag cancel_;
    std::atomic<bool> is_cancelled_{false};
    float area_scale_ = 1;
    std::uint32_t task_items_ = 0;
    std::vector<Subtree> subtrees_;
    std::vector<Task> tasks_;
    std::vector<CutCosts> cuts_;  // one per task
};

}  // namespace

std::vector<Subtree> build_binary(std::span<BvhItem> items, std::span<const LeafCost> costs, int threads,
                                  CancelFlag cancel) {
    return Builder(items, costs, threads, cancel).run();
}

}  // namespace glint
