// SPDX-License-Identifier: Apache-2.0
// The lanes after the last prepared ray, for every instruction set of this machine: a vector that starts at
// any ray may read them.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <memory>
#include <vector>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "bvh/slab_test.cpp"
#include <hwy/foreach_target.h>

#include "bvh/slab-inl.h"
#include "simd/targets.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

// The contents of lanes [count, count + k_ray_padding) after preparing rays [0, count) in memory of all ones.
struct Padding {
    std::vector<float> numbers;  // of all columns but t_max
    std::vector<float> t_max;
};

Padding pad(const RaySpan& rays, int count) {
    const auto slab_rays = std::make_unique<SlabRays>();
    std::memset(static_cast<void*>(slab_rays.get()), 0xff, sizeof(SlabRays));
    prepare_rays(rays, count, *slab_rays);
    Padding padding;
    const auto take = [&](const float* column, std::vector<float>& to) {
        to.insert(to.end(), column + count, column + count + k_ray_padding);
    };
    for (int a = 0; a < 3; ++a) {
        for (const auto* columns : {slab_rays->near_origin, slab_rays->far_origin, slab_rays->near_inverse,
                                    slab_rays->far_inverse, slab_rays->origin, slab_rays->direction})
            take(columns[a], padding.numbers);
    }
    take(slab_rays->t_min, padding.numbers);
    take(slab_rays->t_max, padding.t_max);
    return padding;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint {
namespace {

template <class Pad> void check(Pad pad) {
    constexpr int most = 256;
    std::vector<double> columns[8];
    for (auto& column : columns)
        column.assign(most + k_ray_padding, std::numeric_limits<double>::quiet_NaN());
    for (int i = 0; i < most; ++i) {
        const double values[8] = {1.0 + i, 2, 3, 1, 0.5, -0.25 * i, 0, 100};
        for (int c = 0; c < 8; ++c) columns[c][static_cast<std::size_t>(i)] = values[c];
    }
    const RaySpan rays{columns[0].data(), columns[1].data(), columns[2].data(), columns[3].data(),
                       columns[4].data(), columns[5].data(), columns[6].data(), columns[7].data()};
    for (int count = 1; count <= most; ++count) {
        const auto padding = pad(rays, count);
        for (const float number : padding.numbers) ASSERT_EQ(number, 0) << count << " rays";
        // No interval ends before it.
        for (const float t : padding.t_max)
            ASSERT_EQ(t, -std::numeric_limits<float>::infinity()) << count << " rays";
    }
}

TEST(PreparedRays, ArePaddedWithRaysThatMissEveryBox) {
    [[maybe_unused]] const auto supported = supported_targets();
#if HWY_TARGETS & HWY_AVX3
    if (supported & HWY_AVX3) check(N_AVX3::pad);
#endif
#if HWY_TARGETS & HWY_AVX2
    if (supported & HWY_AVX2) check(N_AVX2::pad);
#endif
#if HWY_TARGETS & HWY_SSE4
    if (supported & HWY_SSE4) check(N_SSE4::pad);
#endif
#if HWY_TARGETS & HWY_SCALAR
    check(N_SCALAR::pad);
#endif
}

}  // namespace
}  // namespace glint
#endif
