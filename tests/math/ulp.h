// SPDX-License-Identifier: Apache-2.0
#pragma once
// Errors in units in the last place, relative to long double.
#include <cmath>
#include <cstdint>

namespace glint::test {

/// |got - exact| in ulps of the double nearest to exact; exact is not 0 and its double is normal.
inline double ulps(double got, long double exact) {
    int exponent = 0;
    std::frexp(static_cast<double>(exact), &exponent);
    return static_cast<double>(std::fabs(static_cast<long double>(got) - exact) /
                               std::ldexp(1.0L, exponent - 53));
}

/// The largest error and its argument.
struct WorstError {
    double ulp = 0, x = 0, y = 0;
    std::int64_t points = 0;
    void add(double error, double at_x, double at_y = 0) {
        ++points;
        if (!(error <= ulp)) ulp = error, x = at_x, y = at_y;  // a NaN stays
    }
};

/// A fixed sequence of random numbers, the same with every standard library.
class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t bits() {  // splitmix64
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    double uniform(double from, double to) {
        return from + (to - from) * (static_cast<double>(bits() >> 11) * 0x1p-53);
    }

  private:
    std::uint64_t state_;
};

}  // namespace glint::test
