// SPDX-License-Identifier: Apache-2.0
// The memory that a process keeps when it renders again and again.
#include <gtest/gtest.h>

#include <fstream>

#include "glint/render.h"

// Sanitizers do not reuse freed memory.
#if defined(__linux__) && !defined(GLINT_SANITIZED)

namespace glint::test {
namespace {

double resident_megabytes() {
    long all = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> all >> resident;
    return static_cast<double>(resident) * 4096 / 1e6;
}

class Memory : public testing::TestWithParam<int> {};

TEST_P(Memory, DoesNotGrowWithEveryRender) {
    Scene scene;
    scene.add(Sphere{.center = {0, 0, -4}, .radius = 1});
    scene.lights.push_back({.position = {4, 5, 0}});
    scene.settings.width = scene.settings.height = 64;
    const auto prepared = prepare(scene);
    ASSERT_TRUE(prepared);
    RenderOptions options;
    options.threads = GetParam();
    const auto render_some = [&](int pictures) {
        for (int i = 0; i < pictures; ++i) ASSERT_TRUE(render(*prepared, options).has_value());
    };
    // Each thread allocates its scratch memory once, of about a megabyte, when it first gets a tile.
    render_some(2000);
    const double before = resident_megabytes();
    ASSERT_GT(before, 0);
    render_some(2000);
    EXPECT_LT(resident_megabytes() - before, options.threads) << "megabytes in 2000 renders";
}

INSTANTIATE_TEST_SUITE_P(Threads, Memory, testing::Values(2, 8, 16),
                         [](const auto& threads) { return "Of" + std::to_string(threads.param); });

}  // namespace
}  // namespace glint::test

#endif
