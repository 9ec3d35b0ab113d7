// SPDX-License-Identifier: Apache-2.0
// Two ways to find where a solid has a surface, which leave parts of its tree out, equal the whole tree.
#include <gtest/gtest.h>
#include <hwy/highway.h>

#include "geometry/random_values.h"
#include "trace/hits/solid_states-inl.h"
#include "trace/hits/solid_sweep.h"
#include "world/geometry/surface_id.h"

namespace glint::test {
namespace {

using HWY_NAMESPACE::find_surface;
using HWY_NAMESPACE::reduce_items;

void add_random_tree(Random& random, int depth, std::vector<SolidItem>& items, std::uint32_t& parts) {
    if (depth == 0 || chance(random, 0.3)) {
        items.push_back({SolidItem::Kind::operand, SolidOperation::operand, parts++});
        return;
    }
    constexpr SolidOperation k_operations[] = {SolidOperation::unite,        SolidOperation::merge,
                                               SolidOperation::intersection, SolidOperation::difference,
                                               SolidOperation::inverse,      SolidOperation::clip};
    const SolidOperation operation = k_operations[below(random, 6)];
    items.push_back({SolidItem::Kind::begin, operation, 0});
    const int count = operation == SolidOperation::inverse ? 1 : 1 + below(random, 4);
    for (int i = 0; i < count; ++i) add_random_tree(random, depth - 1, items, parts);
    items.push_back({SolidItem::Kind::end, operation, 0});
}

TEST(SolidSweep, EqualsTheWholeTree) {
    Random random(4011);
    int surfaces = 0;
    for (int round = 0; round < 3000; ++round) {
        std::vector<SolidItem> items;
        std::uint32_t parts = 0;
        add_random_tree(random, 5, items, parts);
        // No ray meets some parts.
        std::vector<std::uint32_t> position(parts, k_none);
        std::uint32_t met = 0;
        for (std::uint32_t& at : position) {
            if (chance(random, 0.7)) at = met++;
        }
        const std::vector<SolidItem> reduced = reduce_items(items, position);
        SolidSweep sweep(reduced, met);
        std::vector<std::uint32_t> before(parts), after(parts);
        for (int event = 0; event < 12; ++event) {
            before = after;
            std::vector<SolidEvent> events;
            for (std::uint32_t i = 0; i < parts; ++i) {
                if (position[i] == k_none || !chance(random, event == 0 ? 0.5 : 0.2)) continue;
                after[i] = 1 - after[i];
                events.push_back({0, position[i], after[i] != 0 ? 1 : -1});
            }
            const bool is_surface = find_surface(items, before.data(), after.data()) == 1;
            ASSERT_EQ(sweep.meet(events), is_surface) << "round " << round;
            std::vector<std::uint32_t> was(met), is(met);
            for (std::uint32_t i = 0; i < parts; ++i) {
                if (position[i] == k_none) continue;
                was[position[i]] = before[i], is[position[i]] = after[i];
                ASSERT_EQ(sweep.before()[position[i]], before[i]);
                ASSERT_EQ(sweep.after()[position[i]], after[i]);
            }
            ASSERT_EQ(find_surface(reduced, was.data(), is.data()) == 1, is_surface) << "round " << round;
            surfaces += is_surface;
        }
    }
    EXPECT_GT(surfaces, 3000);
}

TEST(SolidSweep, IntervalsOfAPartMayTouch) {
    const SolidItem item{SolidItem::Kind::operand, SolidOperation::operand, 0};
    SolidSweep sweep({&item, 1}, 1);
    const auto meets = [&](std::vector<SolidEvent> events) { return sweep.meet(events); };
    EXPECT_FALSE(meets({}));
    EXPECT_TRUE(meets({{1, 0, 1}}));
    EXPECT_FALSE(meets({{2, 0, -1}, {2, 0, 1}})) << "it ends and begins again";
    EXPECT_FALSE(meets({{3, 0, 1}, {3, 0, -1}, {3, 0, 0}}));
    EXPECT_TRUE(meets({{4, 0, -1}}));
}

}  // namespace
}  // namespace glint::test
