// SPDX-License-Identifier: Apache-2.0
#include "trace/lighting/ground_fog.h"

#include <limits>

#include "math/elementary.h"
#include "math/number.h"

namespace glint {
namespace {

// Of the whole density: nothing is seen through it.
constexpr double k_endless = 1e200;

}  // namespace

// The density is 1 up to height 0, and 1 / (1 + z^2) above, whose integral is atan(z). The difference of two
// arcs is one arc, which keeps its digits where the heights are near each other.
double fog_along(FogLine line, double begin, double end) {
    const double first = line.height + line.slope * begin;
    if (end == std::numeric_limits<double>::infinity()) {
        if (!(line.slope > 0)) return k_endless;
        return number::min((atan2(1, number::max(first, 0.0)) - number::min(first, 0.0)) / line.slope,
                           k_endless);
    }
    const double last = line.height + line.slope * end;
    const double low = number::min(first, last), high = number::max(first, last);
    const double from = number::max(low, 0.0), to = number::max(high, 0.0);
    if (!(high > low)) return (end - begin) / (1 + from * from);
    const double below = number::min(high, 0.0) - number::min(low, 0.0);
    return (end - begin) * ((below + atan2(to - from, 1 + from * to)) / (high - low));
}

}  // namespace glint
