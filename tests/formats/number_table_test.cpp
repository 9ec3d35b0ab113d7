// SPDX-License-Identifier: Apache-2.0
// The table of materials by their numbers.
#include "formats/number_table.h"

#include <gtest/gtest.h>

namespace glint::test {
namespace {

using Table = NumberTable<2>;

TEST(NumberTable, FindsWhatWasAdded) {
    Table table;
    EXPECT_EQ(table.find({1, 2}), nullptr);
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const Table::Key key{1.0 / (1 + i), 0.5 * i};
        ASSERT_EQ(table.find(key), nullptr);
        table.add(key, i);
    }
    for (std::uint32_t i = 0; i < 20000; ++i) {
        const std::uint32_t* found = table.find({1.0 / (1 + i), 0.5 * i});
        ASSERT_NE(found, nullptr) << i;
        ASSERT_EQ(*found, i);
    }
    EXPECT_EQ(table.find({1, 0.5}), nullptr);
}

TEST(NumberTable, TakesZerosOfBothSignsAsOne) {
    Table table;
    table.add({0.0, 3}, 7);
    ASSERT_NE(table.find({-0.0, 3}), nullptr);
    EXPECT_EQ(*table.find({-0.0, 3}), 7u);
}

// The last number undoes what the first one has made of the hash.
TEST(NumberTable, KeepsKeysOfOneHash) {
    const auto key_of = [](std::uint64_t i) {
        const std::uint64_t first = 0x3ff0000000000000 + i;
        std::uint64_t hash = first * 0x9e3779b97f4a7c15u;
        hash ^= hash >> 32;
        return Table::Key{std::bit_cast<double>(first), std::bit_cast<double>(hash ^ 0x4000000000000000u)};
    };
    Table table;
    std::uint32_t count = 0;
    for (std::uint64_t i = 0; i < 20000; ++i) table.add(key_of(i), count++);
    for (std::uint64_t i = 0; i < 20000; ++i) {
        const std::uint32_t* found = table.find(key_of(i));
        ASSERT_NE(found, nullptr) << i;
        ASSERT_EQ(*found, i);
    }
}

}  // namespace
}  // namespace glint::test
