// SPDX-License-Identifier: Apache-2.0
// Compresses and expands lanes: the streams between the stages of a tile have no gaps.
#if defined(GLINT_SIMD_COMPRESS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_SIMD_COMPRESS_INL_H_
#undef GLINT_SIMD_COMPRESS_INL_H_
#else
#define GLINT_SIMD_COMPRESS_INL_H_
#endif

#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

#if HWY_TARGET == HWY_AVX2
/// Half i of the result, 32 bits, is half order[i] of x.
HWY_INLINE Doubles in_order(Doubles x, const std::uint32_t* order) {
    const hn::Repartition<std::uint32_t, Tag<double>> halves;
    const auto indices = hn::IndicesFromVec(halves, hn::Load(halves, order));
    return Doubles(hn::BitCast(Tag<double>(), hn::TableLookupLanes(hn::BitCast(halves, x.v), indices)));
}
#endif

/// The lanes that are set, at the front; the remaining lanes are unspecified. Does the same as hn::Compress,
/// whose table g++ 12 copies to the stack in every call.
HWY_INLINE Doubles compress(Doubles x, LaneMask<double> m) {
#if HWY_TARGET == HWY_AVX3
    return Doubles(hn::Vec<Tag<double>>{_mm512_maskz_compress_pd(m.m.raw, x.v.raw)});
#elif HWY_TARGET == HWY_AVX2
    alignas(32) static constexpr std::uint32_t k_order[16][8] = {
        {0, 1, 2, 3, 4, 5, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}, {2, 3, 0, 1, 4, 5, 6, 7},
        {0, 1, 2, 3, 4, 5, 6, 7}, {4, 5, 0, 1, 2, 3, 6, 7}, {0, 1, 4, 5, 2, 3, 6, 7},
        {2, 3, 4, 5, 0, 1, 6, 7}, {0, 1, 2, 3, 4, 5, 6, 7}, {6, 7, 0, 1, 2, 3, 4, 5},
        {0, 1, 6, 7, 2, 3, 4, 5}, {2, 3, 6, 7, 0, 1, 4, 5}, {0, 1, 2, 3, 6, 7, 4, 5},
        {4, 5, 6, 7, 0, 1, 2, 3}, {0, 1, 4, 5, 6, 7, 2, 3}, {2, 3, 4, 5, 6, 7, 0, 1},
        {0, 1, 2, 3, 4, 5, 6, 7}};
    return in_order(x, k_order[to_bits(m)]);
#elif HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_WASM
    return to_bits(m) == 2 ? Doubles(hn::Reverse(Tag<double>(), x.v)) : x;
#else
    return Doubles(hn::Compress(x.v, m.m));
#endif
}

/// Stores the lanes that are set, one after the other. `to` must have room for a whole vector.
HWY_INLINE void compress_store(Doubles x, LaneMask<double> m, double* to) { store(compress(x, m), to); }
/// The same for lane_count<double>() integers.
HWY_INLINE void compress_store(const std::uint32_t* from, LaneMask<double> m, std::uint32_t* to) {
#if HWY_TARGET == HWY_AVX3
    const IndexTag d;
    hn::StoreU(decltype(hn::Zero(d)){_mm256_maskz_compress_epi32(m.m.raw, hn::LoadU(d, from).raw)}, d, to);
#else
    for (std::uint32_t bits = to_bits(m); bits != 0; bits &= bits - 1) *to++ = from[__builtin_ctz(bits)];
#endif
}

/// The inverse: loads consecutive numbers into the lanes that are set, and 0 into the others. May read a
/// whole vector.
HWY_INLINE Doubles expand_load(const double* from, LaneMask<double> m) {
#if HWY_TARGET == HWY_AVX3
    return Doubles(hn::Vec<Tag<double>>{_mm512_maskz_expandloadu_pd(m.m.raw, from)});
#elif HWY_TARGET == HWY_AVX2
    alignas(32) static constexpr std::uint32_t k_order[16][8] = {
        {0, 1, 0, 1, 0, 1, 0, 1}, {0, 1, 0, 1, 0, 1, 0, 1}, {0, 1, 0, 1, 0, 1, 0, 1},
        {0, 1, 2, 3, 0, 1, 0, 1}, {0, 1, 0, 1, 0, 1, 0, 1}, {0, 1, 0, 1, 2, 3, 0, 1},
        {0, 1, 0, 1, 2, 3, 0, 1}, {0, 1, 2, 3, 4, 5, 0, 1}, {0, 1, 0, 1, 0, 1, 0, 1},
        {0, 1, 0, 1, 0, 1, 2, 3}, {0, 1, 0, 1, 0, 1, 2, 3}, {0, 1, 2, 3, 0, 1, 4, 5},
        {0, 1, 0, 1, 0, 1, 2, 3}, {0, 1, 0, 1, 2, 3, 4, 5}, {0, 1, 0, 1, 2, 3, 4, 5},
        {0, 1, 2, 3, 4, 5, 6, 7}};
    return select(m, in_order(load(from), k_order[to_bits(m)]), Doubles(0));
#else
    alignas(64) double lanes[lane_count<double>()] = {};
    for (std::uint32_t bits = to_bits(m); bits != 0; bits &= bits - 1) lanes[__builtin_ctz(bits)] = *from++;
    return load(lanes);
#endif
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
