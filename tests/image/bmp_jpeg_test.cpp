// SPDX-License-Identifier: Apache-2.0
// BMP files, byte by byte, and JPEG files, decoded again.
#include <gtest/gtest.h>

#include <cmath>

#include "glint/image.h"

namespace glint {
namespace {

Image four_pixels() { return {2, 2, {1, 0.5f, 0, 0, 0, 1, 0, 1, 0, 2, -1, 0.25f}}; }

TEST(Bmp, IsUncompressedFromTheBottom) {
    const auto bytes = encode(four_pixels(), {FileFormat::bmp}).value();
    const std::vector<std::uint8_t> expected = {
        'B', 'M', 70, 0,  0, 0,   0, 0, 0, 0,   54,  0,   0, 0,                     // the file
        40,  0,   0,  0,  2, 0,   0, 0, 2, 0,   0,   0,   1, 0, 24, 0, 0, 0, 0, 0,  // the picture
        16,  0,   0,  0,  0, 0,   0, 0, 0, 0,   0,   0,   0, 0, 0,  0, 0, 0, 0, 0,  //
        0,   255, 0,  64, 0, 255, 0, 0, 0, 128, 255, 255, 0, 0, 0,  0};  // blue, green, red; rows of 8 bytes
    EXPECT_EQ(bytes, expected);
}

TEST(Bmp, DoesNotDependOnThreads) {
    Image image{3, 200, {}};
    for (int i = 0; i < 3 * 3 * 200; ++i) image.rgb.push_back(static_cast<float>(i) / 1800.0f);
    EXPECT_EQ(encode(image, {FileFormat::bmp, 8, Transfer::none, 1}).value(),
              encode(image, {FileFormat::bmp, 8, Transfer::none, 4}).value());
}

TEST(Jpeg, KeepsSmoothPicturesNearly) {
    Image image{50, 70, {}};
    for (int y = 0; y < 70; ++y) {
        for (int x = 0; x < 50; ++x)
            image.rgb.insert(image.rgb.end(),
                             {static_cast<float>(x) / 50, static_cast<float>(y) / 70, 0.25f});
    }
    const auto bytes = encode(image, {FileFormat::jpeg});
    if (!bytes) GTEST_SKIP() << bytes.message;
    EXPECT_EQ((*bytes)[0], 0xff);
    EXPECT_EQ((*bytes)[1], 0xd8);
    const auto decoded = decode(*bytes).value();
    ASSERT_EQ(decoded.image.width, 50);
    ASSERT_EQ(decoded.image.height, 70);
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        ASSERT_LT(std::abs(decoded.image.rgb[i] - image.rgb[i]), 6.0f / 255) << i;
    EncodeOptions worse{FileFormat::jpeg};
    worse.jpeg_quality = 20;
    EXPECT_LT(encode(image, worse).value().size(), bytes->size());
}

TEST(Jpeg, RefusesWhatItCannotHold) {
    EXPECT_EQ(encode(four_pixels(), {FileFormat::jpeg, 16}).message, "JPEG has 8 bits a channel");
    EXPECT_EQ(encode(four_pixels(), {FileFormat::bmp, 16}).message, "BMP has 8 bits a channel");
    const std::vector<float> alpha(4, 1.0f);
    EXPECT_EQ(encode(four_pixels(), alpha, {FileFormat::jpeg}).message, "JPEG has no alpha channel");
    EXPECT_EQ(encode(four_pixels(), alpha, {FileFormat::bmp}).message, "glint writes BMP without alpha");
    EncodeOptions options{FileFormat::jpeg};
    for (const int quality : {0, 101}) {
        options.jpeg_quality = quality;
        EXPECT_EQ(encode(four_pixels(), options).message, "JPEG's quality is from 1 to 100");
    }
    const Image wide{65501, 1, std::vector<float>(3 * 65501)};
    EXPECT_EQ(encode(wide, {FileFormat::jpeg}).message, "JPEG has at most 65500 pixels a side");
}

}  // namespace
}  // namespace glint
