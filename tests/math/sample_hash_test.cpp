// SPDX-License-Identifier: Apache-2.0
// The hash of sampled numbers: fixed values, distribution, independence of its words; lanes give the same
// bits.
#include "math/sample_hash.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <set>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "math/sample_hash_test.cpp"
#include <hwy/foreach_target.h>

#include "simd/sample_hash-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

// hash[i] and unit[i]: of ray_hash's words (a, b), as numbers; count is a multiple of 8.
void hash_lanes(const double* a, const double* b, double* hash, double* unit, std::size_t count) {
    for (std::size_t i = 0; i < count; i += lane_count<double>()) {
        const Words h =
            hash_with(hash_with(Words(seed_hash(7)), to_words(load(a + i))), to_words(load(b + i)));
        store(to_doubles(h), hash + i);
        store(unit_number(h), unit + i);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint {
namespace {

// Every compiler and the browser build must give these numbers.
TEST(SampleHash, HasTheSameBitsEverywhere) {
    EXPECT_EQ(lowbias32(std::uint32_t{0}), 0u);
    EXPECT_EQ(lowbias32(std::uint32_t{1}), 1753845952u);
    EXPECT_EQ(ray_hash(0, 0, 0, 0, k_camera_path), 1618519239u);
    EXPECT_EQ(ray_hash(5, 639, 479, 3, child_path(k_camera_path, true)), 3814482537u);
    EXPECT_EQ(unit_number(0), 0);
    EXPECT_EQ(unit_number(0xffffffffu), 1 - 0x1p-24);
    EXPECT_EQ(unit_number(0x800000ffu), 0.5);
}

TEST(SampleHash, DependsOnEachWord) {
    std::set<std::uint32_t> found;
    const std::uint32_t base[] = {0, 1, 2, 100, 65535};
    for (const std::uint32_t seed : base)
        for (const std::uint32_t x : base)
            for (const std::uint32_t y : base)
                for (const std::uint32_t sample : base)
                    found.insert(ray_hash(seed, x, y, sample, k_camera_path));
    EXPECT_EQ(found.size(), 625u);  // x and y exchanged, for one, differ
    EXPECT_NE(child_path(k_camera_path, false), child_path(k_camera_path, true));
    EXPECT_NE(purpose_word(SamplePurpose::light, 1), purpose_word(SamplePurpose::occlusion, 1));
}

// The chi-squared statistic of n numbers in 64 classes.
template <class Number> double chi_squared(int n, const Number& number) {
    int counts[64] = {};
    for (int i = 0; i < n; ++i) ++counts[static_cast<int>(number(i) * 64)];
    double sum = 0;
    for (const int count : counts) sum += (count - n / 64.0) * (count - n / 64.0) / (n / 64.0);
    return sum;
}

// With 63 degrees of freedom 1 of 1000 statistics exceeds 103.4, and 1 of 1000 is below 33.
TEST(SampleHash, IsUniformAlongEachWord) {
    constexpr int n = 64000;
    const auto check = [](const char* name, auto&& number) {
        const double statistic = chi_squared(n, number);
        EXPECT_LT(statistic, 103.4) << name;
        EXPECT_GT(statistic, 33) << name;
    };
    check("x", [](int i) { return unit_number(ray_hash(0, static_cast<std::uint32_t>(i), 3, 0, 1)); });
    check("y", [](int i) { return unit_number(ray_hash(0, 3, static_cast<std::uint32_t>(i), 0, 1)); });
    check("sample", [](int i) { return unit_number(ray_hash(0, 3, 3, static_cast<std::uint32_t>(i), 1)); });
    check("path", [](int i) { return unit_number(ray_hash(0, 3, 3, 0, static_cast<std::uint32_t>(i))); });
    check("seed", [](int i) { return unit_number(ray_hash(static_cast<std::uint32_t>(i), 3, 3, 0, 1)); });
    // Neighbouring pixels: the fractional part of the sum of both numbers is uniform, too.
    check("neighbours", [](int i) {
        const auto x = static_cast<std::uint32_t>(i);
        const double sum = unit_number(ray_hash(0, x, 0, 0, 1)) + unit_number(ray_hash(0, x + 1, 0, 0, 1));
        return sum < 1 ? sum : sum - 1;
    });
}

using Hash = void (*)(const double*, const double*, double*, double*, std::size_t);
struct Target {
    const char* name;
    std::int64_t bit;
    Hash hash;
};
const Target k_targets[] = {
#if (HWY_TARGETS) & HWY_AVX3
    {"avx512", HWY_AVX3, N_AVX3::hash_lanes},
#endif
#if (HWY_TARGETS) & HWY_AVX2
    {"avx2", HWY_AVX2, N_AVX2::hash_lanes},
#endif
#if (HWY_TARGETS) & HWY_SSE4
    {"sse4", HWY_SSE4, N_SSE4::hash_lanes},
#endif
#if (HWY_TARGETS) & HWY_NEON
    {"neon", HWY_NEON, N_NEON::hash_lanes},
#endif
#if (HWY_TARGETS) & HWY_SCALAR
    {"scalar", HWY_SCALAR, N_SCALAR::hash_lanes},
#endif
};

TEST(SampleHash, OfLanesHasTheBitsOfWords) {
    constexpr std::size_t n = 8000;
    std::vector<double> a(n), b(n), hash(n), unit(n);
    std::uint32_t word = 1;
    for (std::size_t i = 0; i < n; ++i) {
        a[i] =
            i < 8 ? 4294967295.0 - static_cast<double>(i) : static_cast<double>(word = lowbias32(word + 1));
        b[i] = i % 3 == 0 ? static_cast<double>(i) : static_cast<double>(word = lowbias32(word + 1));
    }
    int tested = 0;
    for (const Target& target : k_targets) {
        if (!(hwy::SupportedTargets() & target.bit)) continue;
        ++tested;
        target.hash(a.data(), b.data(), hash.data(), unit.data(), n);
        for (std::size_t i = 0; i < n; ++i) {
            const std::uint32_t want = hash_with(hash_with(seed_hash(7), static_cast<std::uint32_t>(a[i])),
                                                 static_cast<std::uint32_t>(b[i]));
            ASSERT_EQ(hash[i], static_cast<double>(want)) << target.name;
            ASSERT_EQ(unit[i], unit_number(want)) << target.name;
        }
    }
    EXPECT_GE(tested, 1);
}

}  // namespace
}  // namespace glint
#endif
