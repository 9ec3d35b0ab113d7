// SPDX-License-Identifier: Apache-2.0
// The terms of the lighting equation, compared with the numbers of the sources and with plain formulas.
#include <gtest/gtest.h>

#include <cmath>

#include "geometry/random_values.h"
#include "lighting/phong-inl.h"

namespace glint::test {
namespace {

namespace plain = HWY_NAMESPACE;
using plain::LightingRules;
using T3 = plain::Vector3<double>;
using L3 = plain::Vector3<long double>;

T3 vector3(Vec3 v) { return {v.x, v.y, v.z}; }
Vec3 vec(T3 v) { return {v.x, v.y, v.z}; }
L3 longer(T3 v) { return {v.x, v.y, v.z}; }

void expect_near(Vec3 got, Vec3 expected, double tolerance) {
    EXPECT_NEAR(got.x, expected.x, tolerance);
    EXPECT_NEAR(got.y, expected.y, tolerance);
    EXPECT_NEAR(got.z, expected.z, tolerance);
}

LightingRules rules(Shading shading, bool gate = true, bool clamp = true, bool normalize = true) {
    return {shading, gate, clamp, normalize};
}

struct Terms {
    double diffuse, specular;
};

/// The factors of k_d I_l,d and k_s I_l,s for one visible light.
Terms terms(const plain::Cosines<double>& c, double shininess, const LightingRules& rule) {
    const bool highlight = plain::has_highlight(c, rule);
    return {plain::diffuse_term(c.n_l, rule), highlight ? plain::highlight_power(c.s, shininess, rule) : 0};
}

TEST(Lighting, MirroredIsTheReflection) {
    Random random(61);
    for (int i = 0; i < 10000; ++i) {
        const Vec3 n = unit_direction(random), l = point_in_cube(random, 5);
        const Vec3 r = vec(plain::mirrored(vector3(l), vector3(n)));
        EXPECT_NEAR(dot(r, n), dot(l, n), 1e-14);
        EXPECT_NEAR(dot(r, r), dot(l, l), 1e-13);
        expect_near(cross(r + l, n), {0, 0, 0}, 1e-13);
    }
}

TEST(Lighting, PhongAndBlinnPhongAsWritten) {
    Random random(62);
    for (int i = 0; i < 20000; ++i) {
        const Vec3 n = unit_direction(random), l = unit_direction(random), v = unit_direction(random);
        const double shininess = chance(random, 0.5) ? below(random, 200) : log_uniform(random, 0.1, 1000);
        const double n_l = dot(n, l), r_v = dot(n * (2 * n_l) - l, v);
        const Vec3 h = l + v;
        const double n_h = dot(n, h) / std::sqrt(dot(h, h));
        for (const Shading shading : {Shading::phong, Shading::blinn_phong, Shading::diffuse}) {
            for (const bool gate : {true, false}) {
                const auto rule = rules(shading, gate);
                const auto c = plain::cosines(vector3(n), vector3(l), vector3(v), rule);
                const auto t = terms(c, shininess, rule);
                const double s = shading == Shading::phong ? r_v : n_h;
                EXPECT_NEAR(t.diffuse, std::max(0.0, n_l), 1e-15);
                const bool shines = shading != Shading::diffuse && s > 0 && (!gate || n_l > 0);
                const double expected = shines ? std::pow(s, shininess) : 0;
                ASSERT_NEAR(t.specular, expected, 1e-13 * (1 + shininess)) << "case " << i;
                if (!shines) {
                    ASSERT_EQ(t.specular, 0);
                }
            }
        }
    }
}

TEST(Lighting, GatesAndClamps) {
    const auto specular = [](double n_l, double s, double n, LightingRules r) {
        return terms(plain::Cosines<double>{n_l, s}, n, r).specular;
    };
    const auto diffuse = [](double n_l, LightingRules r) {
        return terms(plain::Cosines<double>{n_l, 0}, 1.0, r).diffuse;
    };
    const auto gated = rules(Shading::phong), open = rules(Shading::phong, false);
    EXPECT_EQ(specular(-0.1, 0.5, 1, gated), 0);
    EXPECT_EQ(specular(0, 0.5, 1, gated), 0);
    EXPECT_EQ(specular(-0.1, 0.5, 1, open), 0.5);
    EXPECT_EQ(specular(0.1, -0.5, 1, open), 0);
    EXPECT_EQ(specular(0.1, 0, 1, open), 0);
    // S^0 is 1, but only where there is a highlight.
    EXPECT_EQ(specular(0.1, 0.5, 0, gated), 1);
    EXPECT_EQ(specular(0.1, -0.5, 0, gated), 0);
    EXPECT_EQ(diffuse(-0.25, gated), 0);
    EXPECT_EQ(diffuse(-0.25, rules(Shading::phong, false, false)), -0.25);
}

TEST(Lighting, PowersOfNegativeCosinesWithoutClamps) {
    const auto free = rules(Shading::phong, false, false), gated = rules(Shading::phong, true, false);
    const auto specular = [](double n_l, double s, double n, LightingRules r) {
        return terms(plain::Cosines<double>{n_l, s}, n, r).specular;
    };
    EXPECT_EQ(specular(0.5, -0.5, 1, free), -0.5);
    EXPECT_EQ(specular(0.5, -0.5, 2, free), 0.25);
    EXPECT_EQ(specular(0.5, -0.5, 3, free), -0.125);
    EXPECT_EQ(specular(0.5, -0.5, 10, free), 0x1p-10);
    EXPECT_EQ(specular(0.5, -0.5, 11, free), -0x1p-11);
    EXPECT_EQ(specular(0.5, -0.5, 2.5, free), 0);  // does not exist
    EXPECT_EQ(specular(0.5, 0, 0, free), 0);
    EXPECT_EQ(specular(-0.5, -0.5, 3, free), -0.125);
    EXPECT_EQ(specular(-0.5, -0.5, 3, gated), 0);
    // Large exponents have a parity too, as long as they have a last bit.
    EXPECT_EQ(specular(0.5, -1, 1000000001.0, free), -1);
    EXPECT_EQ(specular(0.5, -1, 1e300, free), 1);
}

TEST(Lighting, WithoutNormalisationTheFilmStaysFinite) {
    const auto fault = rules(Shading::blinn_phong, false, false, false);
    // H is L + V without normalisation.
    const auto c = plain::cosines(T3{0, 1, 0}, T3{3, 40, 0}, T3{0, 2, 5}, fault);
    EXPECT_EQ(c.n_l, 40);
    EXPECT_EQ(c.s, 42);
    EXPECT_EQ(
        plain::cosines(T3{0, 1, 0}, T3{3, 40, 0}, T3{0, 2, 5}, rules(Shading::phong, true, true, false)).s,
        2 * 40.0 * 2 - 40 * 2);
    for (const double s : {42.0, -42.0}) {
        for (const double n : {500.0, 501.0, 500.5}) {
            const auto t = terms(plain::Cosines<double>{40, s}, n, fault);
            EXPECT_TRUE(std::fabs(t.specular) <= 1e30) << s << "^" << n << " = " << t.specular;
        }
    }
    // A direction that does not exist gives no light.
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(terms(plain::Cosines<double>{0.5, nan}, 10.0, fault).specular, 0);
}

TEST(Lighting, LightFromStraightBehindHasNoHighlight) {
    const auto c = plain::cosines(T3{0, 1, 0}, T3{0, 0, 1}, T3{0, 0, -1}, rules(Shading::blinn_phong));
    EXPECT_EQ(c.s, 0);
}

TEST(Lighting, Attenuation) {
    EXPECT_EQ(plain::attenuation(1.0, 0.0, 0.0, 1e9), 1);
    EXPECT_EQ(plain::attenuation(0.0, 2.0, 0.0, 4.0), 0.125);
    EXPECT_EQ(plain::attenuation(0.0, 0.0, 1.0, 4.0), 0.0625);
    EXPECT_EQ(plain::attenuation(1.0, 1.0, 1.0, 1.0), 1.0 / 3);
    EXPECT_EQ(plain::attenuation(0.0, 0.0, 1.0, 0.5), 1);  // never above 1
    EXPECT_EQ(plain::attenuation(0.0, 1.0, 0.0, 0.0), 1);
    EXPECT_EQ(plain::attenuation(0.25, 0.0, 0.0, 3.0), 1);
}

TEST(Lighting, FadingIsOneAtItsDistance) {
    EXPECT_EQ(plain::fading(3.0, 2.0, 3.0), 1);
    EXPECT_EQ(plain::fading(3.0, 2.0, 6.0), 0.4);
    EXPECT_EQ(plain::fading(1.0, 1.0, 1e-300), 2);
    EXPECT_EQ(plain::fading(1e-300, 1e9, 1e300), 0);  // the power overflows
}

TEST(Lighting, SpotFactorAtTheEndsOfItsRange) {
    const double ci = std::cos(0.3), co = std::cos(0.7);
    for (const double tightness : {0.0, 2.0}) {
        const SpotCone cone{ci, co, 0.3, 0.7, tightness};
        for (const SpotFalloff falloff : {SpotFalloff::cubic, SpotFalloff::linear}) {
            const double power = falloff == SpotFalloff::cubic ? tightness : 0;
            EXPECT_EQ(plain::spot_factor(1.0, cone, falloff), 1);
            EXPECT_EQ(plain::spot_factor(ci, cone, falloff), plain::pow(ci, power));
            EXPECT_EQ(plain::spot_factor(co, cone, falloff), 0);
            EXPECT_EQ(plain::spot_factor(-1.0, cone, falloff), 0);
            double last = 1;
            for (double angle = 0.3; angle < 0.7; angle += 0.001) {
                const double factor = plain::spot_factor(std::cos(angle), cone, falloff);
                EXPECT_LE(factor, last);
                EXPECT_GE(factor, 0);
                last = factor;
            }
            EXPECT_LT(last, 0.01);
        }
        EXPECT_NEAR(plain::spot_factor(std::cos(0.4), cone, SpotFalloff::linear), 0.75, 1e-15);
        const double s = (std::cos(0.5) - co) / (ci - co);
        EXPECT_NEAR(plain::spot_factor(std::cos(0.5), cone, SpotFalloff::cubic),
                    s * s * (3 - 2 * s) * std::pow(std::cos(0.5), tightness), 1e-15);
    }
    const SpotCone all{-2, -1, 3.15, 3.15, 0};  // 180 degrees
    EXPECT_EQ(plain::spot_factor(-1 - 1e-15, all, SpotFalloff::linear), 1);
    EXPECT_EQ(plain::spot_factor(-0.5, all, SpotFalloff::cubic), 1);
}

TEST(Lighting, DoubleAgreesWithLongDouble) {
    Random random(63);
    double worst = 0;
    for (int i = 0; i < 100000; ++i) {
        const T3 n = vector3(unit_direction(random)), l = vector3(unit_direction(random)),
                 v = vector3(unit_direction(random));
        for (const Shading shading : {Shading::phong, Shading::blinn_phong}) {
            const auto rule = rules(shading);
            const auto c = plain::cosines(n, l, v, rule);
            const auto exact = plain::cosines(longer(n), longer(l), longer(v), rule);
            worst = std::max(worst, static_cast<double>(std::fabs(c.n_l - exact.n_l)));
            // H of nearly opposite directions is short, and its direction is inaccurate.
            const double size = shading == Shading::phong ? 1 : plain::length(l + v);
            worst = std::max(worst, static_cast<double>(std::fabs(c.s - exact.s)) * size);
        }
    }
    EXPECT_LT(worst, 12 * 0x1p-53);
}

}  // namespace
}  // namespace glint::test
