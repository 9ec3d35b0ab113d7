// SPDX-License-Identifier: Apache-2.0
// The padding of boxes, as a template over the kind of number. No include guard and no fixed namespace, as in
// math/elementary_templates-inl.h: a file opens it where the names of math/number.h are known.
#ifndef GLINT_NUMBER_NAMESPACE
#error "define GLINT_NUMBER_NAMESPACE to the namespace that the function is wanted in"
#endif

#include "math/number.h"

namespace glint {
namespace GLINT_NUMBER_NAMESPACE {

/// The distance by which the sides lo and hi of a box are moved outwards along an axis: two to four ulp of a
/// float, the distance by which rounding may move a shape's surface. The error of a formula is relative to
/// the largest magnitude in it, so both sides are padded for the larger one.
template <class T> GLINT_INLINE T box_padding(T lo, T hi) {
    return max(abs(lo), abs(hi)) * T(0x1p-23) + T(1e-30);
}

}  // namespace GLINT_NUMBER_NAMESPACE
}  // namespace glint

#undef GLINT_NUMBER_NAMESPACE
