// SPDX-License-Identifier: Apache-2.0
// The worked example of "Lighting Models in Computer Graphics", to its four decimals.
#include <gtest/gtest.h>

#include "lighting/phong-inl.h"
#include "math/elementary.h"

namespace glint::HWY_NAMESPACE {
namespace {

using Vector = Vector3<double>;

void expect_four_decimals(Vector v, double x, double y, double z) {
    EXPECT_NEAR(v.x, x, 0.5e-4);
    EXPECT_NEAR(v.y, y, 0.5e-4);
    EXPECT_NEAR(v.z, z, 0.5e-4);
}

TEST(WorkedExample, OfLight) {
    const Vector p{16, 8, 11}, source{5, 20, 30}, observer{40, -10, 25};
    const Vector l = normalize(source - p), n = normalize(p), v = normalize(observer - p);
    EXPECT_EQ(length(p), 21);  // on the sphere around the origin
    expect_four_decimals(l, -0.4396, 0.4796, 0.7594);
    expect_four_decimals(n, 0.7619, 0.3810, 0.5238);
    expect_four_decimals(v, 0.7249, -0.5437, 0.4229);
    expect_four_decimals(mirrored(l, n), 0.8138, -0.2926, -0.5022);

    LightingRules rules;
    rules.shading = Shading::phong;
    const auto phong = cosines(n, l, v, rules);
    EXPECT_NEAR(phong.n_l, 0.2455, 0.5e-4);
    EXPECT_NEAR(phong.s, 0.5366, 0.5e-4);
    rules.shading = Shading::blinn_phong;
    EXPECT_NEAR(cosines(n, l, v, rules).s, 0.6669, 0.5e-4);
}

// In the plane of incidence, H rotates by half the angle of V; across it, by 1 / (2 cos theta) of it.
TEST(HalfVector, AngleComparedWithTheMirroredAngle) {
    LightingRules phong, blinn_phong;
    phong.shading = Shading::phong;
    const Vector n{0, 0, 1};
    const double tiny = 1e-3;
    for (const double degrees : {0.0, 30.0, 60.0, 80.0}) {
        const double sine = glint::sin_degrees(degrees), cosine = glint::cos_degrees(degrees);
        const Vector l{-sine, 0, cosine};
        const Vector along{sine + tiny * cosine, 0, cosine - tiny * sine}, across{sine, tiny, cosine};
        const auto angles = [&](Vector v) {
            const Vector unit = normalize(v);
            const double s = 1 - cosines(n, l, unit, phong).s, h = 1 - cosines(n, l, unit, blinn_phong).s;
            return s / h;  // the square of the angles' ratio, for small angles
        };
        EXPECT_NEAR(angles(along), 4, 1e-3) << degrees;
        EXPECT_NEAR(angles(across), 4 * cosine * cosine, 1e-3) << degrees;
    }
}

}  // namespace
}  // namespace glint::HWY_NAMESPACE
