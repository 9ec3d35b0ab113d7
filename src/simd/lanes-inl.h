// SPDX-License-Identifier: Apache-2.0
// Lanes<T>: a vector of as many T as fit a register, with the operators and the names of math/number.h.
// The only file that includes highway.h; its neighbours include this one. Compiled once per target by
// foreach_target.h (trace/kernels.cpp, trace/hits/hit_kernels.cpp). Of Highway, only operations that IEEE 754
// defines exactly: no MulAdd family, no Approximate*, no SumOfLanes; Min and Max only if they equal a
// comparison and a select.
#if defined(GLINT_SIMD_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_SIMD_LANES_INL_H_
#undef GLINT_SIMD_LANES_INL_H_
#else
#define GLINT_SIMD_LANES_INL_H_
#endif

#include <hwy/highway.h>

#include <bit>
#include <cstdint>
#include <type_traits>

#include "math/number.h"
#if HWY_TARGET == HWY_WASM
#include "simd/wasm_vectors-inl.h"
#endif

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

#if HWY_TARGET != HWY_WASM
namespace hn = hwy::HWY_NAMESPACE;
#endif

template <class T> using Tag = hn::ScalableTag<T>;

/// How many T fit in a vector of this instruction set.
template <class T> HWY_INLINE constexpr int lane_count() { return static_cast<int>(hn::MaxLanes(Tag<T>())); }

template <class T> struct LaneMask {
    hn::Mask<Tag<T>> m;
    friend HWY_INLINE LaneMask operator&&(LaneMask a, LaneMask b) { return {hn::And(a.m, b.m)}; }
    friend HWY_INLINE LaneMask operator||(LaneMask a, LaneMask b) { return {hn::Or(a.m, b.m)}; }
    friend HWY_INLINE LaneMask operator!(LaneMask a) { return {hn::Not(a.m)}; }
};

template <class T> struct Lanes {
    hn::Vec<Tag<T>> v;

    HWY_INLINE Lanes() : v(hn::Zero(Tag<T>())) {}
    HWY_INLINE Lanes(T x) : v(hn::Set(Tag<T>(), x)) {}  // implicit: formulas mix lanes and constants
    HWY_INLINE explicit Lanes(hn::Vec<Tag<T>> x) : v(x) {}
    // Integer constants in formulas (T(0), 2) are exact in every number type.
    HWY_INLINE Lanes(int x) requires(!std::is_same_v<T, int>) : v(hn::Set(Tag<T>(), static_cast<T>(x))) {}

    friend HWY_INLINE Lanes operator+(Lanes a, Lanes b) { return Lanes(hn::Add(a.v, b.v)); }
    friend HWY_INLINE Lanes operator-(Lanes a, Lanes b) { return Lanes(hn::Sub(a.v, b.v)); }
    friend HWY_INLINE Lanes operator*(Lanes a, Lanes b) { return Lanes(hn::Mul(a.v, b.v)); }
    friend HWY_INLINE Lanes operator/(Lanes a, Lanes b) { return Lanes(hn::Div(a.v, b.v)); }
    friend HWY_INLINE Lanes operator-(Lanes a) { return Lanes(hn::Neg(a.v)); }
    HWY_INLINE Lanes& operator+=(Lanes b) { return *this = *this + b; }
    HWY_INLINE Lanes& operator*=(Lanes b) { return *this = *this * b; }

    friend HWY_INLINE LaneMask<T> operator<(Lanes a, Lanes b) { return {hn::Lt(a.v, b.v)}; }
    friend HWY_INLINE LaneMask<T> operator<=(Lanes a, Lanes b) { return {hn::Le(a.v, b.v)}; }
    friend HWY_INLINE LaneMask<T> operator>(Lanes a, Lanes b) { return {hn::Gt(a.v, b.v)}; }
    friend HWY_INLINE LaneMask<T> operator>=(Lanes a, Lanes b) { return {hn::Ge(a.v, b.v)}; }
    friend HWY_INLINE LaneMask<T> operator==(Lanes a, Lanes b) { return {hn::Eq(a.v, b.v)}; }
};

using Doubles = Lanes<double>;
using Floats = Lanes<float>;

// The names of math/number.h for plain numbers: formulas inside this namespace find both.
using number::abs;
using number::all;
using number::and_not;
using number::any;
using number::exp2_integer;
using number::head;
using number::k_infinity;
using number::max;
using number::min;
using number::round_to_integer;
using number::select;
using number::split_exponent;
using number::sqrt;
using number::with_sign_of;

template <class T> HWY_INLINE Lanes<T> select(LaneMask<T> m, Lanes<T> yes, Lanes<T> no) {
    return Lanes<T>(hn::IfThenElse(m.m, yes.v, no.v));
}
template <class T> HWY_INLINE bool any(LaneMask<T> m) { return !hn::AllFalse(Tag<T>(), m.m); }
template <class T> HWY_INLINE bool all(LaneMask<T> m) { return hn::AllTrue(Tag<T>(), m.m); }
template <class T> HWY_INLINE LaneMask<T> and_not(LaneMask<T> a, LaneMask<T> b) {
    return {hn::AndNot(b.m, a.m)};
}
template <class T> HWY_INLINE Lanes<T> sqrt(Lanes<T> x) { return Lanes<T>(hn::Sqrt(x.v)); }
template <class T> HWY_INLINE Lanes<T> abs(Lanes<T> x) { return Lanes<T>(hn::Abs(x.v)); }
#if (HWY_ARCH_X86 && HWY_TARGET != HWY_SCALAR) || HWY_TARGET == HWY_WASM
// On x86 and in WebAssembly these are exactly minimum(a, b) = a < b ? a : b, maximum(a, b) = a > b ? a : b.
template <class T> HWY_INLINE Lanes<T> min(Lanes<T> a, Lanes<T> b) { return Lanes<T>(hn::Min(a.v, b.v)); }
template <class T> HWY_INLINE Lanes<T> max(Lanes<T> a, Lanes<T> b) { return Lanes<T>(hn::Max(b.v, a.v)); }
#else
template <class T> HWY_INLINE Lanes<T> min(Lanes<T> a, Lanes<T> b) { return select(a < b, a, b); }
template <class T> HWY_INLINE Lanes<T> max(Lanes<T> a, Lanes<T> b) { return select(a < b, b, a); }
#endif
template <class T> HWY_INLINE Lanes<T> with_sign_of(Lanes<T> x, Lanes<T> s) {
    return select(s < Lanes<T>(0), -x, x);
}

HWY_INLINE Doubles split_exponent(Doubles x, Doubles& mantissa) {
    const Tag<double> d;
    const hn::RebindToUnsigned<Tag<double>> du;
    const auto bits = hn::BitCast(du, x.v);
    const auto fraction = hn::And(bits, hn::Set(du, 0x000fffffffffffffu));
    mantissa = Doubles(hn::BitCast(d, hn::Or(fraction, hn::Set(du, 0x3ff0000000000000u))));
    // The biased exponent, as the low bits of 2^52 + e: exact without an integer conversion.
    const auto biased = hn::Or(hn::ShiftRight<52>(bits), hn::Set(du, 0x4330000000000000u));
    return Doubles(hn::BitCast(d, biased)) - Doubles(4503599627370496.0 + 1023.0);
}

HWY_INLINE Doubles exp2_integer(Doubles k) {
    const Tag<double> d;
    const hn::RebindToUnsigned<Tag<double>> du;
    const auto biased = hn::BitCast(du, (k + Doubles(4503599627370496.0 + 1023.0)).v);  // low bits: k + 1023
    return Doubles(hn::BitCast(d, hn::ShiftLeft<52>(biased)));
}

HWY_INLINE Doubles head(Doubles x) {
    const Tag<double> d;
    const hn::RebindToUnsigned<Tag<double>> du;
    return Doubles(hn::And(x.v, hn::BitCast(d, hn::Set(du, 0xfffffffff8000000u))));
}

HWY_INLINE Doubles round_to_integer(Doubles x) {
    const Doubles shift(6755399441055744.0);
    return (x + shift) - shift;
}

template <class T> HWY_INLINE Lanes<T> load(const T* from) { return Lanes<T>(hn::LoadU(Tag<T>(), from)); }
template <class T> HWY_INLINE void store(Lanes<T> x, T* to) { hn::StoreU(x.v, Tag<T>(), to); }

/// Loads lane_count<double>() floats as doubles.
HWY_INLINE Doubles widen(const float* from) {
    const hn::Rebind<float, Tag<double>> d;
    return Doubles(hn::PromoteTo(Tag<double>(), hn::LoadU(d, from)));
}

/// Rounds to nearest and stores lane_count<double>() floats.
HWY_INLINE void store_narrow(Doubles x, float* to) {
    const hn::Rebind<float, Tag<double>> d;
    hn::StoreU(hn::DemoteTo(d, x.v), d, to);
}

/// A vector of floats with as many lanes as Doubles.
struct NarrowFloats {
    using D = hn::Rebind<float, Tag<double>>;
    hn::Vec<D> v;
    HWY_INLINE NarrowFloats() : v(hn::Zero(D())) {}
    /// Adds x, rounded to nearest.
    HWY_INLINE void add(Doubles x) { v = hn::Add(v, hn::DemoteTo(D(), x.v)); }
    HWY_INLINE void store(float* to) const { hn::StoreU(v, D(), to); }
};
/// Stores a[0] b[0] c[0] a[1] b[1] c[1] ...
HWY_INLINE void store_interleaved(NarrowFloats a, NarrowFloats b, NarrowFloats c, float* to) {
    hn::StoreInterleaved3(a.v, b.v, c.v, NarrowFloats::D(), to);
}

/// The minimum of the lanes; no lane is NaN.
HWY_INLINE float min_of_lanes(Floats x) { return hn::GetLane(hn::MinOfLanes(Tag<float>(), x.v)); }
template <class T> HWY_INLINE T max_of_lanes(Lanes<T> x) {
    return hn::GetLane(hn::MaxOfLanes(Tag<T>(), x.v));
}

/// The tag for lane_count<double>() numbers from 32-bit arrays.
using IndexTag = hn::Rebind<std::uint32_t, Tag<double>>;
HWY_INLINE bool all_same(const std::uint32_t* x) {
    const IndexTag d;
    return hn::AllTrue(d, hn::Eq(hn::LoadU(d, x), hn::Set(d, x[0])));
}

/// A vector of array positions: stride * index[i].
struct GatherIndices {
    using D = hn::RebindToSigned<Tag<double>>;
    hn::Vec<D> v;
    HWY_INLINE explicit GatherIndices(const std::uint32_t* index, std::uint32_t stride = 1) {
#if HWY_TARGET == HWY_SCALAR
        v = hn::Set(D(), static_cast<std::int64_t>(std::uint64_t{index[0]} * stride));
#else
        const hn::Repartition<std::uint32_t, D> halves;
        const hn::RebindToUnsigned<D> wide;
        const auto indices = hn::BitCast(halves, hn::PromoteTo(wide, hn::LoadU(IndexTag(), index)));
        v = hn::BitCast(D(), hn::MulEven(indices, hn::Set(halves, stride)));
#endif
    }
};
/// Lane i of the result is base[places[i]].
HWY_INLINE Doubles gather(const double* base, const GatherIndices& places) {
    return Doubles(hn::GatherIndex(Tag<double>(), base, places.v));
}

/// The same for floats, below 2^31.
struct SingleGatherIndices {
    using Single = hn::Rebind<float, Tag<double>>;
    using D = hn::RebindToSigned<Single>;
    hn::Vec<D> v;
    HWY_INLINE SingleGatherIndices(const std::uint32_t* index, std::int32_t stride)
        : v(hn::Mul(hn::BitCast(D(), hn::LoadU(IndexTag(), index)), hn::Set(D(), stride))) {}
};
HWY_INLINE Doubles gather(const float* base, const SingleGatherIndices& places) {
    return Doubles(
        hn::PromoteTo(Tag<double>(), hn::GatherIndex(SingleGatherIndices::Single(), base, places.v)));
}

/// An integer with the same order as the float, -0 before 0; f is not NaN.
HWY_INLINE std::int32_t ordered_bits(float f) {
    const auto bits = std::bit_cast<std::int32_t>(f);
    return bits ^ static_cast<std::int32_t>(static_cast<std::uint32_t>(bits >> 31) >> 1);
}
HWY_INLINE void store_ordered_bits(Floats f, std::int32_t* to) {
    const hn::RebindToSigned<Tag<float>> d;
    const hn::RebindToUnsigned<Tag<float>> du;
    const auto bits = hn::BitCast(d, f.v);
    const auto sign = hn::BitCast(du, hn::ShiftRight<31>(bits));
    hn::StoreU(hn::Xor(bits, hn::BitCast(d, hn::ShiftRight<1>(sign))), d, to);
}

/// 0, 1, 2, ...
HWY_INLINE Doubles iota() { return Doubles(hn::Iota(Tag<double>(), 0.0)); }

/// The number of lanes that are set.
template <class T> HWY_INLINE int count(LaneMask<T> m) {
    return static_cast<int>(hn::CountTrue(Tag<T>(), m.m));
}

/// Bit i of the result is lane i.
template <class T> HWY_INLINE std::uint32_t to_bits(LaneMask<T> m) {
    if constexpr (lane_count<T>() == 1) {
        return hn::AllTrue(Tag<T>(), m.m) ? 1 : 0;
    } else {
        static_assert(std::endian::native == std::endian::little);
        // Of the size that is written: reading more bytes would wait for the write to the cache.
        std::conditional_t<(lane_count<T>() <= 8), std::uint8_t, std::uint16_t> bits = 0;
        hn::StoreMaskBits(Tag<T>(), m.m, reinterpret_cast<std::uint8_t*>(&bits));
        return bits & ((1u << lane_count<T>()) - 1);
    }
}
/// The first n lanes, n >= 0 (all lanes if n is larger than their number).
template <class T> HWY_INLINE LaneMask<T> first_lanes(int n) {
    return {hn::FirstN(Tag<T>(), static_cast<std::size_t>(n))};
}
/// The lowest n bits, 0 <= n < 32.
HWY_INLINE std::uint32_t first_bits(int n) { return (1u << n) - 1; }

template <class T> HWY_INLINE LaneMask<T> from_bits(std::uint32_t bits) {
    const std::uint8_t bytes[8] = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8)};
    return {hn::LoadMaskBits(Tag<T>(), bytes)};
}

/// Sets to[i] = x for the bits i of `where`, i < lane_count<double>(). Rewrites the other numbers of the
/// vector.
HWY_INLINE void store_where(std::uint32_t where, std::uint32_t x, std::uint32_t* to) {
    const IndexTag d;
    const auto bits = static_cast<std::uint8_t>(where);
    const std::uint8_t bytes[8] = {bits};
    hn::StoreU(hn::IfThenElse(hn::LoadMaskBits(d, bytes), hn::Set(d, x), hn::LoadU(d, to)), d, to);
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
