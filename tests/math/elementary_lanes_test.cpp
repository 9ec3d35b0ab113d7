// SPDX-License-Identifier: Apache-2.0
// Lanes of every instruction set of this machine give the same bits as the plain functions.
#include <gtest/gtest.h>

#include <bit>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <vector>

#include "math/elementary.h"
#include "math/ulp.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "math/elementary_lanes_test.cpp"
#include <hwy/foreach_target.h>

#include "simd/elementary-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

// out[i] = function number `which` of x[i], y[i]; count is a multiple of 8.
void apply(int which, const double* x, const double* y, double* out, std::size_t count) {
    for (std::size_t i = 0; i < count; i += lane_count<double>()) {
        const Doubles a = load(x + i), b = load(y + i);
        Doubles r;
        switch (which) {
            case 0:
                r = pow(a, b);
                break;
            case 1:
                r = exp(a);
                break;
            case 2:
                r = log_positive(a);
                break;
            case 3:
                r = sin(a);
                break;
            case 4:
                r = cos(a);
                break;
            case 5:
                r = tan(a);
                break;
            case 6:
                r = sin_degrees(a);
                break;
            case 7:
                r = cos_degrees(a);
                break;
            case 8:
                r = tan_degrees(a);
                break;
            case 9:
                r = acos(a);
                break;
            case 10:
                r = atan2(a, b);
                break;
        }
        store(r, out + i);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glint {
namespace {

using Apply = void (*)(int, const double*, const double*, double*, std::size_t);

struct Target {
    const char* name;
    std::int64_t bit;
    Apply apply;
};

const Target k_targets[] = {
#if (HWY_TARGETS) & HWY_AVX3
    {"avx512", HWY_AVX3, N_AVX3::apply},
#endif
#if (HWY_TARGETS) & HWY_AVX2
    {"avx2", HWY_AVX2, N_AVX2::apply},
#endif
#if (HWY_TARGETS) & HWY_SSE4
    {"sse4", HWY_SSE4, N_SSE4::apply},
#endif
#if (HWY_TARGETS) & HWY_NEON
    {"neon", HWY_NEON, N_NEON::apply},
#endif
#if (HWY_TARGETS) & HWY_SCALAR
    {"scalar", HWY_SCALAR, N_SCALAR::apply},
#endif
};

double plain(int which, double x, double y) {
    switch (which) {
        case 0:
            return pow(x, y);
        case 1:
            return exp(x);
        case 2:
            return log(x);
        case 3:
            return sin(x);
        case 4:
            return cos(x);
        case 5:
            return tan(x);
        case 6:
            return sin_degrees(x);
        case 7:
            return cos_degrees(x);
        case 8:
            return tan_degrees(x);
        case 9:
            return acos(x);
        default:
            return atan2(x, y);
    }
}

TEST(ElementaryLanes, HaveTheBitsOfPlainNumbers) {
    constexpr std::size_t k_count = 100000;
    test::Random random(20);
    int tested = 0;
    for (int which = 0; which < 11; ++which) {
        std::vector<double> x(k_count), y(k_count), out(k_count);
        for (std::size_t i = 0; i < k_count; ++i) {
            const double wide = std::exp(random.uniform(which == 2 ? -708 : -744, 709));
            x[i] = which == 2 ? wide : i % 4 == 0 ? wide : i % 4 == 1 ? -wide : random.uniform(-1e5, 1e5);
            if (which == 0 && i % 4 >= 2) x[i] = random.uniform(-0.01, 1);
            if (which >= 9 && i % 4 >= 2) x[i] = random.uniform(-1, 1);
            y[i] = i % 3 == 0 ? random.uniform(-1e300, 1e300) : std::exp(random.uniform(-3, 13.8));
            if (which == 10 && i % 3 == 1) y[i] = random.uniform(-1, 1);
        }
        const double specials[] = {0.0, -0.0, 1,  0.5,   2,   30,      45,     60,
                                   90,  180,  -1, 1e300, 1e5, DBL_MIN, 5e-324, 1e308};
        for (std::size_t i = 0; i < 16 && which != 2; ++i) {
            for (std::size_t k = 0; k < 16; ++k)
                x[16 * i + k] = specials[i], y[16 * i + k] = specials[k] * (k % 2 ? 1 : -1);
        }
        for (const Target& target : k_targets) {
            if (!(hwy::SupportedTargets() & target.bit)) continue;
            ++tested;
            target.apply(which, x.data(), y.data(), out.data(), k_count);
            for (std::size_t i = 0; i < k_count; ++i) {
                const double want = plain(which, x[i], y[i]);
                ASSERT_EQ(std::bit_cast<std::uint64_t>(out[i]), std::bit_cast<std::uint64_t>(want))
                    << target.name << " function " << which << " of " << x[i] << ", " << y[i] << ": "
                    << out[i] << " instead of " << want;
            }
        }
    }
    EXPECT_GE(tested, 11);
}

}  // namespace
}  // namespace glint
#endif
