// SPDX-License-Identifier: Apache-2.0
// Vectors of 128 bits in WebAssembly, by the names of Highway that lanes-inl.h uses: Highway 1.0 has no lanes
// of double there. Each operation is one that the standard defines exactly (no relaxed instructions).
#if defined(GLINT_SIMD_WASM_VECTORS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_SIMD_WASM_VECTORS_INL_H_
#undef GLINT_SIMD_WASM_VECTORS_INL_H_
#else
#define GLINT_SIMD_WASM_VECTORS_INL_H_
#endif

#include <wasm_simd128.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {
namespace hn {

/// N lanes of T, in the low N * sizeof(T) bytes of a vector.
template <class T, int N> struct Simd {
    using Lane = T;
    static constexpr int k_lanes = N;
};
template <class T> using ScalableTag = Simd<T, 16 / sizeof(T)>;
template <class T, class D> using Rebind = Simd<T, D::k_lanes>;
template <class T, class D>
using Repartition = Simd<T, D::k_lanes* int{sizeof(typename D::Lane)} / int{sizeof(T)}>;
template <class D>
using RebindToUnsigned =
    Rebind<std::conditional_t<sizeof(typename D::Lane) == 8, std::uint64_t, std::uint32_t>, D>;
template <class D>
using RebindToSigned =
    Rebind<std::conditional_t<sizeof(typename D::Lane) == 8, std::int64_t, std::int32_t>, D>;

template <class T, int N> struct Vec128 { v128_t raw; };
/// All bits of a lane are set or none.
template <class T, int N> struct Mask128 { v128_t raw; };
template <class D> using Vec = Vec128<typename D::Lane, D::k_lanes>;
template <class D> using Mask = Mask128<typename D::Lane, D::k_lanes>;

template <class D> constexpr std::size_t MaxLanes(D) { return D::k_lanes; }

template <class T> constexpr bool k_is_float = std::is_same_v<T, float>;
template <class T> constexpr bool k_is_double = std::is_same_v<T, double>;

template <class D> HWY_INLINE Vec<D> Zero(D) { return {wasm_i64x2_const_splat(0)}; }
template <class D, class X> HWY_INLINE Vec<D> Set(D, X x) {
    using T = typename D::Lane;
    const T lane = static_cast<T>(x);
    if constexpr (k_is_float<T>)
        return {wasm_f32x4_splat(lane)};
    else if constexpr (k_is_double<T>)
        return {wasm_f64x2_splat(lane)};
    else if constexpr (sizeof(T) == 8)
        return {wasm_i64x2_splat(static_cast<std::int64_t>(lane))};
    else if constexpr (sizeof(T) == 4)
        return {wasm_i32x4_splat(static_cast<std::int32_t>(lane))};
    else
        return {wasm_i16x8_splat(static_cast<std::int16_t>(lane))};
}

template <class D> HWY_INLINE Vec<D> LoadU(D, const typename D::Lane* from) {
    if constexpr (D::k_lanes * sizeof(typename D::Lane) == 16)
        return {wasm_v128_load(from)};
    else
        return {wasm_v128_load64_zero(from)};
}
template <class D> HWY_INLINE Vec<D> Load(D d, const typename D::Lane* from) { return LoadU(d, from); }
template <class D> HWY_INLINE void StoreU(Vec<D> x, D, typename D::Lane* to) {
    if constexpr (D::k_lanes * sizeof(typename D::Lane) == 16)
        wasm_v128_store(to, x.raw);
    else
        wasm_v128_store64_lane(to, x.raw, 0);
}
template <class D, class From> HWY_INLINE Vec<D> BitCast(D, From x) { return {x.raw}; }

// Arithmetic of float and double.
#define GLINT_WASM_BINARY(Name, name)                                             \
    HWY_INLINE Vec128<float, 4> Name(Vec128<float, 4> a, Vec128<float, 4> b) {    \
        return {wasm_f32x4_##name(a.raw, b.raw)};                                 \
    }                                                                             \
    HWY_INLINE Vec128<float, 2> Name(Vec128<float, 2> a, Vec128<float, 2> b) {    \
        return {wasm_f32x4_##name(a.raw, b.raw)};                                 \
    }                                                                             \
    HWY_INLINE Vec128<double, 2> Name(Vec128<double, 2> a, Vec128<double, 2> b) { \
        return {wasm_f64x2_##name(a.raw, b.raw)};                                 \
    }
#define GLINT_WASM_UNARY(Name, name)                                                            \
    HWY_INLINE Vec128<float, 4> Name(Vec128<float, 4> a) { return {wasm_f32x4_##name(a.raw)}; } \
    HWY_INLINE Vec128<double, 2> Name(Vec128<double, 2> a) { return {wasm_f64x2_##name(a.raw)}; }
#define GLINT_WASM_COMPARE(Name, name)                                             \
    HWY_INLINE Mask128<float, 4> Name(Vec128<float, 4> a, Vec128<float, 4> b) {    \
        return {wasm_f32x4_##name(a.raw, b.raw)};                                  \
    }                                                                              \
    HWY_INLINE Mask128<double, 2> Name(Vec128<double, 2> a, Vec128<double, 2> b) { \
        return {wasm_f64x2_##name(a.raw, b.raw)};                                  \
    }
GLINT_WASM_BINARY(Add, add)
GLINT_WASM_BINARY(Sub, sub)
GLINT_WASM_BINARY(Mul, mul)
GLINT_WASM_BINARY(Div, div)
GLINT_WASM_UNARY(Neg, neg)
GLINT_WASM_UNARY(Abs, abs)
GLINT_WASM_UNARY(Sqrt, sqrt)
GLINT_WASM_COMPARE(Lt, lt)
GLINT_WASM_COMPARE(Le, le)
GLINT_WASM_COMPARE(Gt, gt)
GLINT_WASM_COMPARE(Ge, ge)
GLINT_WASM_COMPARE(Eq, eq)
#undef GLINT_WASM_BINARY
#undef GLINT_WASM_UNARY
#undef GLINT_WASM_COMPARE
template <int N>
HWY_INLINE Mask128<std::uint32_t, N> Eq(Vec128<std::uint32_t, N> a, Vec128<std::uint32_t, N> b) {
    return {wasm_i32x4_eq(a.raw, b.raw)};
}
template <int N>
HWY_INLINE Vec128<std::int32_t, N> Mul(Vec128<std::int32_t, N> a, Vec128<std::int32_t, N> b) {
    return {wasm_i32x4_mul(a.raw, b.raw)};
}
/// a < b ? a : b, and a > b ? a : b: the operands of pmin and pmax are exchanged, as for minps and maxps.
HWY_INLINE Vec128<float, 4> Min(Vec128<float, 4> a, Vec128<float, 4> b) {
    return {wasm_f32x4_pmin(b.raw, a.raw)};
}
HWY_INLINE Vec128<float, 4> Max(Vec128<float, 4> a, Vec128<float, 4> b) {
    return {wasm_f32x4_pmax(b.raw, a.raw)};
}
HWY_INLINE Vec128<double, 2> Min(Vec128<double, 2> a, Vec128<double, 2> b) {
    return {wasm_f64x2_pmin(b.raw, a.raw)};
}
HWY_INLINE Vec128<double, 2> Max(Vec128<double, 2> a, Vec128<double, 2> b) {
    return {wasm_f64x2_pmax(b.raw, a.raw)};
}

// Bits.
template <class T, int N> HWY_INLINE Vec128<T, N> And(Vec128<T, N> a, Vec128<T, N> b) {
    return {wasm_v128_and(a.raw, b.raw)};
}
template <class T, int N> HWY_INLINE Vec128<T, N> Or(Vec128<T, N> a, Vec128<T, N> b) {
    return {wasm_v128_or(a.raw, b.raw)};
}
template <class T, int N> HWY_INLINE Vec128<T, N> Xor(Vec128<T, N> a, Vec128<T, N> b) {
    return {wasm_v128_xor(a.raw, b.raw)};
}
template <class T, int N> HWY_INLINE Vec128<T, N> ShiftRightSame(Vec128<T, N> x, int bits) {
    if constexpr (std::is_same_v<T, std::uint64_t>)
        return {wasm_u64x2_shr(x.raw, static_cast<std::uint32_t>(bits))};
    else if constexpr (std::is_same_v<T, std::uint32_t>)
        return {wasm_u32x4_shr(x.raw, static_cast<std::uint32_t>(bits))};
    else {
        static_assert(std::is_same_v<T, std::int32_t>);
        return {wasm_i32x4_shr(x.raw, static_cast<std::uint32_t>(bits))};
    }
}
template <int k_bits, class T, int N> HWY_INLINE Vec128<T, N> ShiftRight(Vec128<T, N> x) {
    return ShiftRightSame(x, k_bits);
}
template <int k_bits> HWY_INLINE Vec128<std::uint64_t, 2> ShiftLeft(Vec128<std::uint64_t, 2> x) {
    return {wasm_i64x2_shl(x.raw, k_bits)};
}
/// The products of lanes 0 and 2, with 64 bits.
HWY_INLINE Vec128<std::uint64_t, 2> MulEven(Vec128<std::uint32_t, 4> a, Vec128<std::uint32_t, 4> b) {
    return {wasm_u64x2_extmul_low_u32x4(wasm_i32x4_shuffle(a.raw, a.raw, 0, 2, 0, 2),
                                        wasm_i32x4_shuffle(b.raw, b.raw, 0, 2, 0, 2))};
}

// Masks.
template <class T, int N> HWY_INLINE Mask128<T, N> And(Mask128<T, N> a, Mask128<T, N> b) {
    return {wasm_v128_and(a.raw, b.raw)};
}
template <class T, int N> HWY_INLINE Mask128<T, N> Or(Mask128<T, N> a, Mask128<T, N> b) {
    return {wasm_v128_or(a.raw, b.raw)};
}
template <class T, int N> HWY_INLINE Mask128<T, N> Not(Mask128<T, N> a) { return {wasm_v128_not(a.raw)}; }
/// b without a.
template <class T, int N> HWY_INLINE Mask128<T, N> AndNot(Mask128<T, N> a, Mask128<T, N> b) {
    return {wasm_v128_andnot(b.raw, a.raw)};
}
template <class T, int N>
HWY_INLINE Vec128<T, N> IfThenElse(Mask128<T, N> m, Vec128<T, N> yes, Vec128<T, N> no) {
    return {wasm_v128_bitselect(yes.raw, no.raw, m.raw)};
}
/// Bit i of the result is lane i.
template <class T, int N> HWY_INLINE std::uint32_t bits_of(Mask128<T, N> m) {
    std::uint32_t bits = 0;
    if constexpr (sizeof(T) == 8)
        bits = static_cast<std::uint32_t>(wasm_i64x2_bitmask(m.raw));
    else if constexpr (sizeof(T) == 4)
        bits = static_cast<std::uint32_t>(wasm_i32x4_bitmask(m.raw));
    else
        bits = static_cast<std::uint32_t>(wasm_i16x8_bitmask(m.raw));
    return N * sizeof(T) == 16 ? bits : bits & ((1u << N) - 1);
}
template <class D> HWY_INLINE bool AllFalse(D, Mask<D> m) { return bits_of(m) == 0; }
template <class D> HWY_INLINE bool AllTrue(D, Mask<D> m) { return bits_of(m) == (1u << D::k_lanes) - 1; }
template <class D> HWY_INLINE std::size_t CountTrue(D, Mask<D> m) {
    return static_cast<std::size_t>(__builtin_popcount(bits_of(m)));
}
template <class D> HWY_INLINE std::size_t StoreMaskBits(D, Mask<D> m, std::uint8_t* bytes) {
    bytes[0] = static_cast<std::uint8_t>(bits_of(m));
    return 1;
}
template <class D> HWY_INLINE Mask<D> LoadMaskBits(D, const std::uint8_t* bytes) {
    if constexpr (sizeof(typename D::Lane) == 8) {
        const v128_t bit = wasm_i64x2_const(1, 2);
        return {wasm_i64x2_eq(wasm_v128_and(wasm_i64x2_splat(bytes[0]), bit), bit)};
    } else {
        const v128_t bit = wasm_i32x4_const(1, 2, 4, 8);
        return {wasm_i32x4_eq(wasm_v128_and(wasm_i32x4_splat(bytes[0]), bit), bit)};
    }
}
template <class D> HWY_INLINE Mask<D> FirstN(D, std::size_t n) {
    if constexpr (sizeof(typename D::Lane) == 8)
        return {wasm_i64x2_gt(wasm_i64x2_splat(static_cast<std::int64_t>(n)), wasm_i64x2_const(0, 1))};
    else
        return {wasm_i32x4_gt(wasm_i32x4_splat(static_cast<std::int32_t>(n)), wasm_i32x4_const(0, 1, 2, 3))};
}
HWY_INLINE Mask128<std::uint16_t, 8> TestBit(Vec128<std::uint16_t, 8> x, Vec128<std::uint16_t, 8> bit) {
    return {wasm_i16x8_eq(wasm_v128_and(x.raw, bit.raw), bit.raw)};
}

// Conversions.
HWY_INLINE Vec128<double, 2> PromoteTo(Simd<double, 2>, Vec128<float, 2> x) {
    return {wasm_f64x2_promote_low_f32x4(x.raw)};
}
HWY_INLINE Vec128<std::uint64_t, 2> PromoteTo(Simd<std::uint64_t, 2>, Vec128<std::uint32_t, 2> x) {
    return {wasm_u64x2_extend_low_u32x4(x.raw)};
}
HWY_INLINE Vec128<float, 2> DemoteTo(Simd<float, 2>, Vec128<double, 2> x) {
    return {wasm_f32x4_demote_f64x2_zero(x.raw)};
}

// Lanes.
HWY_INLINE float GetLane(Vec128<float, 4> x) { return wasm_f32x4_extract_lane(x.raw, 0); }
HWY_INLINE double GetLane(Vec128<double, 2> x) { return wasm_f64x2_extract_lane(x.raw, 0); }
HWY_INLINE Vec128<double, 2> Reverse(Simd<double, 2>, Vec128<double, 2> x) {
    return {wasm_i64x2_shuffle(x.raw, x.raw, 1, 0)};
}
HWY_INLINE Vec128<double, 2> Iota(Simd<double, 2>, double first) {
    return {wasm_f64x2_make(first, first + 1)};
}
HWY_INLINE Vec128<float, 4> swap_pairs(Vec128<float, 4> x) {
    return {wasm_i32x4_shuffle(x.raw, x.raw, 2, 3, 0, 1)};
}
HWY_INLINE Vec128<float, 4> swap_neighbours(Vec128<float, 4> x) {
    return {wasm_i32x4_shuffle(x.raw, x.raw, 1, 0, 3, 2)};
}
HWY_INLINE Vec128<float, 4> MinOfLanes(Simd<float, 4>, Vec128<float, 4> x) {
    const auto pairs = Min(x, swap_pairs(x));
    return Min(pairs, swap_neighbours(pairs));
}
HWY_INLINE Vec128<float, 4> MaxOfLanes(Simd<float, 4>, Vec128<float, 4> x) {
    const auto pairs = Max(x, swap_pairs(x));
    return Max(pairs, swap_neighbours(pairs));
}
HWY_INLINE Vec128<double, 2> MaxOfLanes(Simd<double, 2> d, Vec128<double, 2> x) {
    return Max(x, Reverse(d, x));
}

HWY_INLINE Vec128<double, 2> GatherIndex(Simd<double, 2>, const double* base,
                                         Vec128<std::int64_t, 2> places) {
    const v128_t low = wasm_v128_load64_zero(base + wasm_i64x2_extract_lane(places.raw, 0));
    return {wasm_v128_load64_lane(base + wasm_i64x2_extract_lane(places.raw, 1), low, 1)};
}
HWY_INLINE Vec128<float, 2> GatherIndex(Simd<float, 2>, const float* base, Vec128<std::int32_t, 2> places) {
    const v128_t low = wasm_v128_load32_zero(base + wasm_i32x4_extract_lane(places.raw, 0));
    return {wasm_v128_load32_lane(base + wasm_i32x4_extract_lane(places.raw, 1), low, 1)};
}
/// Stores a[0] b[0] c[0] a[1] b[1] c[1].
HWY_INLINE void StoreInterleaved3(Vec128<float, 2> a, Vec128<float, 2> b, Vec128<float, 2> c, Simd<float, 2>,
                                  float* to) {
    const v128_t ab = wasm_i32x4_shuffle(a.raw, b.raw, 0, 4, 1, 5);  // a0 b0 a1 b1
    wasm_v128_store(to, wasm_i32x4_shuffle(ab, c.raw, 0, 1, 4, 2));
    wasm_v128_store64_lane(to + 4, wasm_i32x4_shuffle(ab, c.raw, 3, 5, 3, 5), 0);
}

}  // namespace hn
}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
