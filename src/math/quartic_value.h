// SPDX-License-Identifier: Apache-2.0
#pragma once
// The function that is 0 on a quartic.
#include "glint/shapes.h"

namespace glint {

/// The degree of term i of k_quartic_terms.
inline int quartic_degree(std::size_t i) {
    const std::string_view term = k_quartic_terms[i];
    if (term == "constant") return 0;
    int degree = 0;
    for (const char c : term) degree += c <= '9' ? c - '1' : 1;
    return degree;
}

/// The sum of the terms of k_quartic_terms at p, by Horner's rule for each coordinate.
inline double quartic_value(const double* coefficients, Vec3 p) {
    double sum = 0;
    for (int i = 0; i <= 4; ++i) {
        double of_yz = 0;
        for (int j = 0; j <= i; ++j) {
            double of_z = 0;
            for (int k = 0; k <= j; ++k) of_z = of_z * p.z + *coefficients++;
            of_yz = of_yz * p.y + of_z;
        }
        sum = sum * p.x + of_yz;
    }
    return sum;
}

}  // namespace glint
