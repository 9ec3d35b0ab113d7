// SPDX-License-Identifier: Apache-2.0
#pragma once
// Elementary functions of plain numbers. The C library's functions differ between machines
// (docs/architecture.md). The formulas in elementary_templates-inl.h give lanes the same bits
// (simd/elementary-inl.h).

namespace glint {

/// Natural logarithm of a finite x >= 2^-1022, else minus infinity. Error below 0.51 ulp.
double log(double x);

/// e^x for finite x; infinity above the largest double, 0 below 2^-1022. Error below 0.68 ulp.
double exp(double x);

/// x^y for finite y and finite x >= 0: x^0 = 1; 0^y = 0 for y > 0, infinity for y < 0; infinity above the
/// largest double. Numbers below 2^-1022, x or the result, count as 0. For x < 0 the result is 0. Error below
/// 0.66 ulp.
double pow(double x, double y);

/// For |x| <= 1e5 radians; other angles count as 0. The tangent is infinite at its poles. Error below 0.81
/// ulp, of the tangent below 0.95 ulp.
double sin(double x);
double cos(double x);
double tan(double x);

/// For |x| <= 2^45 degrees; other angles count as 0. Exact if the value is 0, +-1/2 or +-1:
/// cos_degrees(60) = 0.5. The tangent is infinite at its poles. Error below 0.81 ulp, of the tangent below
/// 0.95 ulp.
double sin_degrees(double x);
double cos_degrees(double x);
double tan_degrees(double x);

/// The angle from 0 to pi, in radians, whose cosine is x. Numbers beyond -1 and 1 count as -1 and 1. Error
/// below 0.66 ulp.
double acos(double x);

/// The angle of the point (x, y), in radians from -pi to pi: 0 on the positive x axis, pi on the negative
/// one, positive for y > 0. 0 for (0, 0). -0 counts as 0. |x| and |y| at most 1e300. Error below 0.70 ulp; it
/// may be larger if both are below 1e-270, or if the angle is below 1e-270.
double atan2(double y, double x);

}  // namespace glint
