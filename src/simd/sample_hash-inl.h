// SPDX-License-Identifier: Apache-2.0
// The hash of math/sample_hash.h for lanes, once per target like lanes-inl.h.
#if defined(GLINT_SIMD_SAMPLE_HASH_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_SIMD_SAMPLE_HASH_INL_H_
#undef GLINT_SIMD_SAMPLE_HASH_INL_H_
#else
#define GLINT_SIMD_SAMPLE_HASH_INL_H_
#endif

#include "math/sample_hash.h"
#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// 32-bit words, as many as Doubles has lanes: each in the low half of a 64-bit lane, whose high half is 0.
struct Words {
    using D = hn::RebindToUnsigned<Tag<double>>;
    hn::Vec<D> v;

    HWY_INLINE explicit Words(hn::Vec<D> x) : v(x) {}
    HWY_INLINE Words(std::uint32_t x) : v(hn::Set(D(), x)) {}  // implicit: formulas mix lanes and constants

    friend HWY_INLINE Words operator^(Words a, Words b) { return Words(hn::Xor(a.v, b.v)); }
    friend HWY_INLINE Words operator>>(Words a, int bits) { return Words(hn::ShiftRightSame(a.v, bits)); }
    /// Modulo 2^32.
    friend HWY_INLINE Words operator*(Words a, std::uint32_t b) {
        const D d;
#if HWY_TARGET == HWY_SCALAR
        return Words(hn::Set(d, static_cast<std::uint32_t>(hn::GetLane(a.v)) * b));
#else
        const hn::Repartition<std::uint32_t, D> halves;
        const auto product = hn::MulEven(hn::BitCast(halves, a.v), hn::Set(halves, b));
        return Words(hn::And(product, hn::Set(d, 0xffffffffu)));
#endif
    }
};

/// Whole numbers from 0 to 2^32 - 1.
HWY_INLINE Words to_words(Doubles x) {
    const Words::D d;
    const auto bits = hn::BitCast(d, (x + Doubles(4503599627370496.0)).v);  // 2^52: the low bits are x
    return Words(hn::And(bits, hn::Set(d, 0xffffffffu)));
}
/// The words as numbers.
HWY_INLINE Doubles to_doubles(Words x) {
    const Words::D d;
    const auto bits = hn::Or(x.v, hn::Set(d, 0x4330000000000000u));
    return Doubles(hn::BitCast(Tag<double>(), bits)) - Doubles(4503599627370496.0);
}

/// See math/sample_hash.h.
HWY_INLINE Doubles unit_number(Words hash) { return to_doubles(hash >> 8) * Doubles(0x1p-24); }

}  // namespace HWY_NAMESPACE
}  // namespace glint
#define GLINT_NUMBER_NAMESPACE HWY_NAMESPACE
#include "math/sample_hash_templates-inl.h"
HWY_AFTER_NAMESPACE();

#endif
