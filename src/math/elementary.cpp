// SPDX-License-Identifier: Apache-2.0
#include "math/elementary.h"

#include "math/number.h"

namespace glint::plain {
using namespace number;  // the names that the templates below use
}

#define GLINT_NUMBER_NAMESPACE plain
#include "math/elementary_templates-inl.h"

namespace glint {

double log(double x) { return x >= 0x1p-1022 ? plain::log_positive(x) : -number::k_infinity; }
double exp(double x) { return plain::exp(x); }
double pow(double x, double y) { return plain::pow(x, y); }
double sin(double x) { return plain::sin(x); }
double cos(double x) { return plain::cos(x); }
double tan(double x) { return plain::tan(x); }
double sin_degrees(double x) { return plain::sin_degrees(x); }
double cos_degrees(double x) { return plain::cos_degrees(x); }
double tan_degrees(double x) { return plain::tan_degrees(x); }
double acos(double x) { return plain::acos(x); }
double atan2(double y, double x) { return plain::atan2(y, x); }

}  // namespace glint
