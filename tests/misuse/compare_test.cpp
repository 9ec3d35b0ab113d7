// SPDX-License-Identifier: Apache-2.0
// Pictures that cannot be compared.
#include "misuse/misused.h"

namespace glint::test {
namespace {

TEST(Misuse, OfCompare) {
    const Image good = picture(2, 2);
    for (const Image& odd : misfits()) {
        EXPECT_NE(compare(odd, good).message, "");
        EXPECT_NE(compare(good, odd).message, "");
        EXPECT_NE(compare(odd, odd).message, "");
        EXPECT_FALSE(difference_image(odd, good));
        EXPECT_FALSE(difference_image(good, odd));
    }
    EXPECT_NE(compare(picture(2, 3), picture(3, 2)).message, "");
    EXPECT_FALSE(difference_image(picture(2, 3), picture(3, 2)));

    Image odd = picture(15, 15);
    for (std::size_t i = 0; i < odd.rgb.size(); ++i)
        odd.rgb[i] = static_cast<float>(k_odd_numbers[i % 5] * (i % 2 ? 1 : 1e-265));
    for (const bool as_floats : {false, true}) {
        for (const double within : k_odd_numbers) {
            CompareOptions options;
            options.as_floats = as_floats;
            options.within = within;
            options.threads = -9;
            const PictureDifference d = compare(odd, picture(15, 15), options).value();
            EXPECT_GT(d.not_finite, 0u);
            EXPECT_TRUE(d.mean >= 0 && d.rms >= 0) << "no NaN";
        }
    }
    for (const double gain : {0.0, -1.0, 5e-324, k_nan, k_infinity, -k_infinity, 1e300}) {
        for (const float value : difference_image(odd, picture(15, 15), gain).value().rgb)
            ASSERT_TRUE(value >= 0 && value <= 1) << "gain " << gain;
        for (const float value : difference_image(picture(15, 15), picture(15, 15), gain).value().rgb)
            ASSERT_EQ(value, 0) << "gain " << gain;
    }
    for (const float value : difference_image(picture(2, 2, 1e-45f), picture(2, 2, 0)).value().rgb)
        EXPECT_TRUE(value >= 0 && value <= 1);
}

TEST(Misuse, OfFindCauses) {
    const Image good = picture(16, 12);
    for (const Image& odd : misfits()) {
        EXPECT_NE(find_causes(odd, good).message, "");
        EXPECT_NE(find_causes(good, odd).message, "");
    }
    EXPECT_NE(find_causes(picture(3, 16), good).message, "");
    EXPECT_TRUE(find_causes(std::span<const Image>(), good, nullptr).empty());
    const std::vector<Image> mixed{good, picture(1, 1), {}};
    const auto reports = find_causes(mixed, good, nullptr);
    ASSERT_EQ(reports.size(), 3u);
    EXPECT_EQ(reports[0].message, "");
    EXPECT_NE(reports[1].message, "");
    EXPECT_NE(reports[2].message, "");
    EXPECT_EQ(find_causes(mixed, Image{}, nullptr).size(), 3u);

    Scene scene = some_scene();
    Image dark = render(world_of(scene)).value().image;
    const Image right = dark;
    for (float& value : dark.rgb) value *= 0.5f;
    scene.shapes[0].index = 99;  // cannot be drawn
    EXPECT_EQ(find_causes(dark, right, &scene).code, ErrorCode::invalid_scene);
    scene = some_scene();
    scene.settings.width = -1;  // the pictures' size is taken
    const std::atomic<bool> cancel{true};
    CauseOptions options;
    options.cancel = &cancel;
    options.threads = -1;
    EXPECT_EQ(find_causes(dark, right, &scene, options).code, ErrorCode::cancelled);

    Image odd = good;
    for (std::size_t i = 0; i < odd.rgb.size(); ++i)
        odd.rgb[i] = static_cast<float>(k_odd_numbers[i % 5] * (i % 2 ? 1 : 1e-265));
    for (const bool as_floats : {false, true}) {
        CauseOptions floats;
        floats.as_floats = as_floats;
        const Result<CauseReport> report = find_causes(odd, good, nullptr, floats);
        EXPECT_TRUE(!report || report->difference >= 0);
        EXPECT_NE(find_causes(good, odd, nullptr, floats).code, ErrorCode::internal);
    }
}

}  // namespace
}  // namespace glint::test
