// SPDX-License-Identifier: Apache-2.0
// TGA files, byte by byte.
#include <gtest/gtest.h>

#include "glint/image.h"

namespace glint {
namespace {

Image two_by_two() {
    Image image;
    image.width = 2;
    image.height = 2;
    image.rgb = {1, 0.5f, 0, 0, 0, 1, 0, 1, 0, 2, -1, 0.25f};
    return image;
}

TEST(Tga, IsUncompressedFromTheTop) {
    const auto bytes = encode(two_by_two(), {FileFormat::tga}).value();
    ASSERT_EQ(bytes.size(), 18u + 12u);
    const std::vector<std::uint8_t> header = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 24, 0x20};
    EXPECT_EQ(std::vector<std::uint8_t>(bytes.begin(), bytes.begin() + 18), header);
    const std::vector<std::uint8_t> pixels = {0, 128, 255, 255, 0, 0, 0, 255, 0, 64, 0, 255};
    EXPECT_EQ(std::vector<std::uint8_t>(bytes.begin() + 18, bytes.end()), pixels) << "blue, green, red";
}

TEST(Tga, SizesHaveTwoBytes) {
    Image image;
    image.width = 300;
    image.height = 1;
    image.rgb.resize(900);
    const auto bytes = encode(image, {FileFormat::tga}).value();
    EXPECT_EQ(bytes[12], 44);
    EXPECT_EQ(bytes[13], 1);
}

TEST(Tga, DoesNotDependOnThreads) {
    Image image;
    image.width = 3;
    image.height = 200;
    for (int i = 0; i < 3 * 3 * 200; ++i) image.rgb.push_back(static_cast<float>(i) / 1800.0f);
    EXPECT_EQ(encode(image, {FileFormat::tga, 8, Transfer::none, 1}).value(),
              encode(image, {FileFormat::tga, 8, Transfer::none, 4}).value());
}

TEST(Tga, Has8BitsAndNoAlpha) {
    EXPECT_EQ(encode(two_by_two(), {FileFormat::tga, 16}).message, "TGA has 8 bits a channel");
    const std::vector<float> alpha(4, 1.0f);
    EXPECT_EQ(encode(two_by_two(), alpha, {FileFormat::tga}).message, "glint writes TGA without alpha");
}

}  // namespace
}  // namespace glint
