// SPDX-License-Identifier: Apache-2.0
// A matrix of bits, written by rows and read by columns.
#if defined(GLINT_SIMD_BIT_MATRIX_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_SIMD_BIT_MATRIX_INL_H_
#undef GLINT_SIMD_BIT_MATRIX_INL_H_
#else
#define GLINT_SIMD_BIT_MATRIX_INL_H_
#endif

#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// 64 rows of 16 bits. All bits are 0 at first.
struct BitMatrix {
    alignas(64) std::uint16_t row[64] = {};

    /// Bit r of the result: bit c of row r, 0 <= c < 16.
    HWY_INLINE std::uint64_t column(int c) const {
        std::uint64_t bits = 0;
#if HWY_TARGET == HWY_SCALAR
        for (int r = 0; r < 64; ++r) bits |= std::uint64_t{row[r] >> c & 1u} << r;
#else
        const hn::ScalableTag<std::uint16_t> d;
        constexpr int lanes = static_cast<int>(hn::MaxLanes(d));
        const auto bit = hn::Set(d, static_cast<std::uint16_t>(1u << c));
        for (int r = 0; r < 64; r += lanes) {
            std::uint64_t here = 0;
            hn::StoreMaskBits(d, hn::TestBit(hn::Load(d, row + r), bit),
                              reinterpret_cast<std::uint8_t*>(&here));
            bits |= here << r;
        }
#endif
        return bits;
    }
};

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
