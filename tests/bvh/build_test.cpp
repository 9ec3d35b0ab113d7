// SPDX-License-Identifier: Apache-2.0
// Properties of every hierarchy, for all kinds of boxes.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>

#include "bvh/bvh.h"
#include "geometry/random_values.h"

namespace glint::test {
namespace {

// Classes with different leaf sizes and costs.
constexpr std::array<LeafCost, 18> k_costs = [] {
    std::array<LeafCost, 18> costs{};
    for (int c = 0; c < 18; ++c) {
        const auto f = static_cast<float>(c);
        costs[c] = {0.1f * f, 0.5f + 0.1f * f, c % 2 == 0 ? 0.0f : 0.2f, 1 << c % 5, 1 + (c + 15) % 16};
    }
    return costs;
}();

struct Input {
    std::vector<BvhItem> items;  // in the order added: item i is the i-th

    void add(Vec3 at, Vec3 half, int item_class = 0) {
        const Aabb box = padded_box(at - half, at + half);
        items.push_back({{box.lo[0], box.lo[1], box.lo[2]},
                         static_cast<std::uint32_t>(items.size()),
                         {box.hi[0], box.hi[1], box.hi[2]},
                         static_cast<std::uint32_t>(item_class)});
    }
};

struct Built {
    std::vector<BvhItem> items;
    Bvh bvh;
    explicit Built(const Input& input, int threads = 1, std::span<const LeafCost> costs = k_costs)
        : items(input.items), bvh(build_bvh(items, costs, threads)) {}
};

bool same(const Aabb& a, const Aabb& b) { return std::memcmp(&a, &b, sizeof(Aabb)) == 0; }

// Traverses the tree: checks boxes, leaves and depth, and counts how often each item occurs.
class Checker {
  public:
    Checker(const Input& input, const Built& built)
        : input_(input.items), items_(built.items), bvh_(built.bvh), met_(input_.size()) {}

    void run() {
        ASSERT_EQ(items_.size(), input_.size());
        if (input_.empty()) {
            EXPECT_TRUE(bvh_.nodes.empty());
            return;
        }
        const Aabb whole = node(0, 1);
        EXPECT_TRUE(same(whole, bvh_.bounds));
        for (std::size_t i = 0; i < met_.size(); ++i) ASSERT_EQ(met_[i], 1) << "item " << i;
        EXPECT_EQ(nodes_, bvh_.nodes.size());
        EXPECT_LE(depth_, k_bvh_max_depth);
    }
    int depth() const { return depth_; }
    std::size_t nodes() const { return nodes_; }

  private:
    // The bounds of everything below the node; checks that each child's box is exactly the bounds of its
    // items.
    Aabb node(std::uint32_t index, int depth) {
        Aabb all;
        if (depth > 200 || index >= bvh_.nodes.size()) {
            ADD_FAILURE() << "a child refers to an invalid node, or to its own";
            return all;
        }
        ++nodes_;
        depth_ = std::max(depth_, depth);
        const BvhNode& n = bvh_.nodes[index];
        bool ended = false;
        for (int c = 0; c < k_bvh_width; ++c) {
            const BvhChild child = n.child[c];
            if (child.is_none()) {
                ended = true;
                continue;
            }
            EXPECT_FALSE(ended) << "a child after an empty one";
            const Aabb found = child.is_leaf() ? leaf(child) : node(child.index(), depth + 1);
            Aabb written;
            for (int a = 0; a < 3; ++a) written.lo[a] = n.lo[a][c], written.hi[a] = n.hi[a][c];
            EXPECT_TRUE(same(written, found)) << "node " << index << ", child " << c;
            all.add(found);
        }
        return all;
    }

    Aabb leaf(BvhChild child) {
        Aabb box;
        const std::uint32_t item_class = items_.at(child.first()).item_class;
        EXPECT_LE(child.count(), static_cast<std::uint32_t>(k_costs[item_class].most));
        for (std::uint32_t i = child.first(); i < child.first() + child.count(); ++i) {
            const BvhItem& item = items_.at(i);
            ++met_.at(item.item);
            EXPECT_EQ(std::memcmp(&item, &input_[item.item], sizeof item), 0);
            Aabb own;
            for (int a = 0; a < 3; ++a) own.lo[a] = item.lo[a], own.hi[a] = item.hi[a];
            box.add(own);
            EXPECT_EQ(item.item_class, item_class) << "a leaf of two classes";
        }
        return box;
    }

    const std::vector<BvhItem>& input_;
    const std::vector<BvhItem>& items_;
    const Bvh& bvh_;
    std::vector<int> met_;
    std::size_t nodes_ = 0;
    int depth_ = 0;
};

int check(const Input& input) {
    const Built built(input);
    Checker checker(input, built);
    checker.run();
    return checker.depth();
}

Input random_input(Random& random, int count, int classes) {
    Input input;
    for (int i = 0; i < count; ++i) {
        const double size = log_uniform(random, 0.001, 1);
        input.add(point_in_cube(random, 10), {size, size * 0.5, size}, below(random, classes));
    }
    return input;
}

TEST(Bvh, KeepsItsInvariants) {
    Random random(51);
    for (const int count : {0, 1, 2, 7, 8, 9, 16, 17, 100, 129, 3000, 20000}) {
        for (const int classes : {1, 2, 18}) {
            SCOPED_TRACE(std::to_string(count) + " items of " + std::to_string(classes) + " classes");
            check(random_input(random, count, classes));
        }
    }
    Input large = random_input(random, 600000, 2);
    for (int i = 1; i < 8; ++i) large.add({1e3 * i, 0, 0}, {1, 1, 1});  // subtrees of one item
    check(large);
}

TEST(Bvh, EqualBoxes) {
    for (const int classes : {1, 3}) {
        Input input;
        for (int i = 0; i < 100000; ++i) input.add({1, 2, 3}, {1, 1, 1}, i % classes);
        EXPECT_LE(check(input), 20);  // halved again and again
    }
}

TEST(Bvh, PointsOnALineAndInAPlane) {
    Input line, plane;
    for (int i = 0; i < 5000; ++i) {
        line.add({i * 0.1, 0, 0}, {0, 0, 0});
        plane.add({i % 71 * 0.1, 0, i / 71 * 0.1}, {0.05, 0, 0.05});  // NOLINT(bugprone-integer-division)
    }
    EXPECT_LE(check(line), 12);
    EXPECT_LE(check(plane), 12);
}

TEST(Bvh, ExponentiallySpacedBoxesStayWithinTheDepth) {
    // The surface-area heuristic splits off the largest boxes one by one.
    for (const double ratio : {1.02, 1.5, 2.0, 3.0}) {
        Input input, of_many_classes;
        double at = 1e-18;
        for (int i = 0; i < 4000 && at < 1e12; ++i, at *= ratio) {
            input.add({at, at, at}, {at * 0.1, at * 0.1, at * 0.1}, i % 2);
            of_many_classes.add({at, at, at}, {at * 0.1, at * 0.1, at * 0.1}, i % 18);
        }
        check(input);
        check(of_many_classes);
    }
}

TEST(Bvh, HugeAndTinyCoordinates) {
    Random random(52);
    Input input;
    for (int i = 0; i < 3000; ++i) {
        const double scale = log_uniform(random, 1e-30, 1e12);
        input.add(point_in_cube(random, scale), Vec3{1, 1, 1} * log_uniform(random, 1e-30, 1e12),
                  below(random, 3));
    }
    check(input);
}

TEST(Bvh, TheSameForAnyNumberOfThreads) {
    Random random(53);
    const Input small = random_input(random, 60000, 3);
    const Input large = random_input(random, 600000, 3);  // split in chunks
    for (const Input* input : {&small, &large}) {
        const Built one(*input);
        for (const int threads : {2, 7}) {
            const Built other(*input, threads);
            EXPECT_EQ(std::memcmp(one.items.data(), other.items.data(), one.items.size() * sizeof(BvhItem)),
                      0);
            ASSERT_EQ(one.bvh.nodes.size(), other.bvh.nodes.size());
            EXPECT_EQ(std::memcmp(one.bvh.nodes.data(), other.bvh.nodes.data(),
                                  one.bvh.nodes.size() * sizeof(BvhNode)),
                      0);
        }
    }
}

TEST(Bvh, SeparatesDistantClusters) {
    // Two clusters far apart: no child of the root contains both.
    Random random(54);
    Input input;
    for (int i = 0; i < 200; ++i) {
        input.add(Vec3{i % 2 == 0 ? -100.0 : 100.0, 0, 0} + point_in_cube(random, 1), {0.1, 0.1, 0.1});
    }
    const Bvh bvh = Built(input).bvh;
    for (int c = 0; c < k_bvh_width; ++c) {
        if (!bvh.nodes[0].child[c].is_none()) {
            EXPECT_LT(bvh.nodes[0].hi[0][c] - bvh.nodes[0].lo[0][c], 3);
        }
    }
}

TEST(Bvh, NodesAndLeavesAreFilled) {
    // 28 bytes per item, also if classes alternate: items of one class are put together.
    Random random(55);
    for (const int classes : {1, 2}) {
        Input input;
        for (int i = 0; i < 20000; ++i) {
            const Vec3 at = point_in_cube(random, 10);
            for (int c = 0; c < classes; ++c) input.add(at, {0.1, 0.1, 0.1}, c);
        }
        const Bvh bvh = Built(input, 1, std::array<LeafCost, 2>{}).bvh;
        EXPECT_LE(bvh.nodes.size() * sizeof(BvhNode), 28 * input.items.size()) << classes << " classes";
    }
}

TEST(Bvh, CrossedBarsDoNotShareALeaf) {
    // The box around two of them is mostly empty.
    Input input;
    for (int i = 0; i < 12; ++i) {
        input.add({0, i * 0.1, 0}, i % 2 == 0 ? Vec3{5, 0.01, 0.01} : Vec3{0.01, 0.01, 5});
    }
    const Bvh bvh = Built(input, 1, std::array<LeafCost, 1>{}).bvh;
    const BvhNode& root = bvh.nodes[0];
    for (int c = 0; c < k_bvh_width; ++c) {
        if (root.child[c].is_leaf()) {
            EXPECT_TRUE(root.hi[0][c] < 1 || root.hi[2][c] < 1) << "child " << c;
        }
    }
}

}  // namespace
}  // namespace glint::test
