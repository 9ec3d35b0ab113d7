// SPDX-License-Identifier: Apache-2.0
// log_positive, exp, pow, sin, cos, tan, acos and atan2 of lanes (math/elementary_templates-inl.h), once per
// target like lanes-inl.h.
#if defined(GLINT_SIMD_ELEMENTARY_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_SIMD_ELEMENTARY_INL_H_
#undef GLINT_SIMD_ELEMENTARY_INL_H_
#else
#define GLINT_SIMD_ELEMENTARY_INL_H_
#endif

#include "simd/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
#define GLINT_NUMBER_NAMESPACE HWY_NAMESPACE
#include "math/elementary_templates-inl.h"
HWY_AFTER_NAMESPACE();

#endif
