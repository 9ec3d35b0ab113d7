// SPDX-License-Identifier: Apache-2.0
// Pictures of floats, whose difference a picture of bytes need not show.
#include "compare/planted_faults.h"

namespace glint::test {
namespace {

Image filled(float value) { return {20, 20, std::vector<float>(1200, value)}; }

// From `least` to `most`, row by row.
Image graded(float least, float most) {
    Image out = filled(0);
    for (std::size_t i = 0; i < out.rgb.size(); ++i)
        out.rgb[i] = least + (most - least) * static_cast<float>(i) / 1199;
    return out;
}

CauseReport find(const Image& a, const Image& b) {
    CauseOptions options;
    options.as_floats = true;
    return find_causes(a, b, nullptr, options).value();
}

TEST(CausesInFloats, FarAboveWhiteIsNoNegative) {
    const CauseReport report = find(filled(3e38f), filled(0));
    EXPECT_TRUE(report.causes.empty()) << all_causes(report);
    EXPECT_NE(report.remark.find("Nearly all of the difference is outside 0 to 1"), std::string::npos)
        << report.remark;
}

TEST(CausesInFloats, AFactorAboveWhite) {
    const Image b = graded(2, 40);
    Image a = b;
    for (float& v : a.rgb) v *= 3;
    const CauseReport report = find(a, b);
    ASSERT_EQ(first_cause(report), "light-intensity") << report.remark;
    EXPECT_NE(report.causes.front().explanation.find("Everything is 3 times"), std::string::npos)
        << all_causes(report);
    EXPECT_GT(report.causes.front().explained, 0.999);
}

TEST(CausesInFloats, AboveWhiteAlone) {
    Image a = graded(0, 4);
    const Image b = a;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        if (a.rgb[i] > 2 && i % 2 == 0) a.rgb[i] = 2;
    }
    const CauseReport report = find(a, b);
    EXPECT_TRUE(report.causes.empty()) << all_causes(report);
    EXPECT_EQ(report.remark.find("All of the difference is outside 0 to 1"), 0u) << report.remark;
}

TEST(CausesInFloats, LessThanAByte) {
    const Image b = filled(0.5f);
    Image a = b;
    a.rgb[600] += 1e-4f;
    const CauseReport report = find(a, b);
    EXPECT_TRUE(report.causes.empty()) << all_causes(report);
    EXPECT_EQ(report.remark.find("They differ by less than a byte shows"), 0u) << report.remark;
}

TEST(CausesInFloats, WhatBytesShowIsLookedForThere) {
    const TestScene& scene = test_scenes()[0];
    const Scene reference_scene = read_scene(scene.text);
    const Image right = draw(reference_scene);
    Image faulty = right;
    for (std::size_t i = 0; i < faulty.rgb.size(); i += 3) std::swap(faulty.rgb[i], faulty.rgb[i + 2]);
    EXPECT_EQ(first_cause(find(faulty, right)), "red-blue-swapped");
}

TEST(CausesInFloats, WhatIsNotFiniteIsPassedOver) {
    Image a = filled(0);
    a.rgb[5] = std::nanf("");
    const CauseReport report = find(a, filled(0));
    EXPECT_TRUE(report.causes.empty()) << all_causes(report);
}

}  // namespace
}  // namespace glint::test
