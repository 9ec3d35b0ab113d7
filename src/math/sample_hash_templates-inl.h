// SPDX-License-Identifier: Apache-2.0
// The hash from which sampled numbers come, as templates over the type of a 32-bit word: std::uint32_t
// (math/sample_hash.h), or lanes (simd/sample_hash-inl.h). Included like math/elementary_templates-inl.h; the
// same bits with every type of word.
#ifndef GLINT_NUMBER_NAMESPACE
#error "define GLINT_NUMBER_NAMESPACE to the namespace that the functions are wanted in"
#endif

#include "math/number.h"

namespace glint {
namespace GLINT_NUMBER_NAMESPACE {

/// A bijection of 32-bit words in which every bit of x changes each bit of the result with a probability near
/// 1/2 (Chris Wellons, lowbias32).
template <class Word> GLINT_INLINE Word lowbias32(Word x) {
    x = x ^ (x >> 16);
    x = x * 0x7feb352du;
    x = x ^ (x >> 15);
    x = x * 0x846ca68bu;
    return x ^ (x >> 16);
}

/// The hash of a sequence of words, from the hash of all but the last.
template <class Word> GLINT_INLINE Word hash_with(Word hash, Word next) { return lowbias32(hash ^ next); }

}  // namespace GLINT_NUMBER_NAMESPACE
}  // namespace glint

#undef GLINT_NUMBER_NAMESPACE
