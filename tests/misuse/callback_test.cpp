// SPDX-License-Identifier: Apache-2.0
// Callbacks and flags in options, and lists of names.
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <memory>

#include "glint/glint.h"

namespace glint {
namespace {

int twice(int x) { return 2 * x; }

TEST(Misuse, CallbacksHoldNothingOrACallable) {
    const Function<int(int)> none, null = nullptr, of_null = static_cast<int (*)(int)>(nullptr),
                                   of_empty = std::function<int(int)>();
    EXPECT_FALSE(none || null || of_null || of_empty);
    const Function<int(int)> of_function = twice, of_lambda = [](int x) { return x + 1; },
                             of_std = std::function<int(int)>(twice);
    EXPECT_EQ(of_function(4), 8);
    EXPECT_EQ(of_lambda(4), 5);
    EXPECT_EQ(of_std(4), 8);
}

TEST(Misuse, CallbacksOwnTheirObjects) {
    const auto held = std::make_shared<int>(7);
    {
        Function<int()> a = [held] { return *held; };
        const Function<int()> b = a;
        EXPECT_EQ(held.use_count(), 3);
        Function<int()> c = std::move(a);
        a = b;
        EXPECT_EQ(a() + b() + c(), 21);
        a = {};
        EXPECT_FALSE(a);
        Function<int()>& self = c;
        c = self;
        EXPECT_EQ(c(), 7);
    }
    EXPECT_EQ(held.use_count(), 1);
}

TEST(Misuse, CancelFlags) {
    const CancelFlag none;
    EXPECT_FALSE(none.is_set());
    EXPECT_TRUE(none == nullptr);
    std::atomic<bool> flag = false;
    const CancelFlag of_flag = &flag;
    EXPECT_FALSE(of_flag.is_set());
    flag = true;
    EXPECT_TRUE(of_flag.is_set());
    EXPECT_FALSE(of_flag == nullptr);
    const std::atomic<bool>* const null = nullptr;
    EXPECT_FALSE(CancelFlag(null).is_set());
}

TEST(Misuse, NamesInAnyOrder) {
    ItemNames names = {{5, "e"}, {2, "b"}, {5, "another"}};
    ASSERT_EQ(names.size(), 2u);
    EXPECT_EQ(names.begin()->second, "b");
    EXPECT_EQ(names.find(5)->second, "e");
    EXPECT_EQ(names.find(4), names.end());
    names.emplace(0xffffffff, "z");
    names.emplace(2, "other");
    names[4] = "d";
    EXPECT_EQ(names.find(2)->second, "b");
    EXPECT_EQ(names[4], "d");
    EXPECT_EQ(names[9], "");
    names.erase(5);
    names.erase(77);
    EXPECT_EQ(names.find(5), names.end());
    EXPECT_EQ(names.size(), 4u);
    names.clear();
    EXPECT_TRUE(names.empty());
}

TEST(Misuse, DefaultLimitsOfMemory) {
    EXPECT_GT(default_max_memory(0), 0u);
    EXPECT_GE(default_max_memory(UINT64_MAX), default_max_memory(0));
}

}  // namespace
}  // namespace glint
