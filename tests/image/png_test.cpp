// SPDX-License-Identifier: Apache-2.0
// PNG: decoding gives the quantised values, for all sizes and numbers of threads.
#include <gtest/gtest.h>

#include "image/pictures.h"
#include "image/quantize.h"
#include "image/read_png.h"
#include "math/srgb.h"

namespace glint::test {
namespace {

using test::make_picture;

class Png : public ::testing::TestWithParam<std::pair<std::int32_t, std::int32_t>> {};

INSTANTIATE_TEST_SUITE_P(Sizes, Png,
                         ::testing::Values(std::pair{1, 1}, std::pair{1, 1000}, std::pair{1000, 1},
                                           std::pair{333, 77}, std::pair{640, 640}, std::pair{5, 32},
                                           std::pair{5, 33}, std::pair{65536, 2}),
                         [](const auto& size) {
                             return std::to_string(size.param.first) + "x" +
                                    std::to_string(size.param.second);
                         });

TEST_P(Png, ReadsBackWhatWasQuantised) {
    const Image image = make_picture(GetParam().first, GetParam().second);
    for (const Transfer transfer : {Transfer::none, Transfer::srgb}) {
        for (const int bits : {8, 16}) {
            const Result<std::vector<std::uint8_t>> encoded =
                encode(image, {FileFormat::png, bits, transfer, 1});
            ASSERT_EQ(encoded.message, "");
            const test::Picture picture = test::decode_png(*encoded);
            ASSERT_EQ(picture.error, "");
            ASSERT_EQ(picture.width, image.width);
            ASSERT_EQ(picture.height, image.height);
            ASSERT_EQ(picture.bits, bits);
            for (std::size_t i = 0; i < image.rgb.size(); ++i) {
                const double value = static_cast<double>(image.rgb[i]);
                const double shown = transfer == Transfer::srgb ? srgb_encode(value) : value;
                ASSERT_EQ(picture.samples[i], quantize(shown, bits == 8 ? 255 : 65535)) << i;
            }
        }
    }
}

TEST_P(Png, HasTheSameBytesForAnyThreads) {
    const Image image = make_picture(GetParam().first, GetParam().second);
    for (const int bits : {8, 16}) {
        const auto one = encode(image, {FileFormat::png, bits, Transfer::none, 1}).value();
        EXPECT_EQ(one, encode(image, {FileFormat::png, bits, Transfer::none, 2}).value());
        EXPECT_EQ(one, encode(image, {FileFormat::png, bits, Transfer::none, 7}).value());
    }
}

TEST(Encode, RejectsInvalidPictures) {
    EXPECT_NE(encode(Image{}).message, "");
    EXPECT_NE(encode(Image{2, 2, std::vector<float>(11)}).message, "");
    EXPECT_NE(encode(Image{-1, -1, std::vector<float>(3)}).message, "");
    EXPECT_NE(encode(make_picture(1, 1), {FileFormat::png, 7}).message, "");
    EXPECT_EQ(encode(Image{}).code, ErrorCode::invalid_argument);
}

TEST(Encode, SrgbPicturesAreMarked) {
    const auto text = [](Transfer transfer) {
        const auto bytes = encode(make_picture(3, 3), {FileFormat::png, 8, transfer}).value();
        return std::string(bytes.begin(), bytes.end());
    };
    EXPECT_EQ(text(Transfer::none).find("sRGB"), std::string::npos);
    EXPECT_NE(text(Transfer::srgb).find("sRGB"), std::string::npos);
}

}  // namespace
}  // namespace glint::test
