// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "image/pictures.h"
#include "image/quantize.h"

namespace glint::test {
namespace {

TEST(Ppm, IsAHeaderAndTheSamples) {
    const Image image = test::make_picture(7, 5);
    const auto bytes = encode(image, {FileFormat::ppm}).value();
    const std::string header = "P6\n7 5\n255\n";
    ASSERT_EQ(bytes.size(), header.size() + 7 * 5 * 3);
    EXPECT_EQ(std::string(bytes.begin(), bytes.begin() + static_cast<long>(header.size())), header);
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
        EXPECT_EQ(bytes[header.size() + i], to_byte(image.rgb[i]));
}

TEST(Ppm, SixteenBitsAreBigEndian) {
    const Image image = test::make_picture(7, 5);
    const auto bytes = encode(image, {FileFormat::ppm, 16}).value();
    const std::string header = "P6\n7 5\n65535\n";
    ASSERT_EQ(bytes.size(), header.size() + 2 * 7 * 5 * 3);
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        const std::uint32_t word = bytes[header.size() + 2 * i] * 256u + bytes[header.size() + 2 * i + 1];
        EXPECT_EQ(word, quantize(static_cast<double>(image.rgb[i]), 65535));
    }
    for (const int threads : {2, 7})
        EXPECT_EQ(bytes, encode(image, {FileFormat::ppm, 16, Transfer::none, threads}).value());
}

}  // namespace
}  // namespace glint::test
