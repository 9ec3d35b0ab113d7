// SPDX-License-Identifier: Apache-2.0
// Pictures to files and back.
#include "misuse/misused.h"

namespace glint::test {
namespace {

void expect_error(const Result<std::vector<std::uint8_t>>& result, const char* what) {
    EXPECT_EQ(result.code, ErrorCode::invalid_argument) << what;
    EXPECT_NE(result.message, "") << what;
    EXPECT_FALSE(result) << what;
}

TEST(Misuse, OfPixel) {
    const Image good = picture(2, 3);
    EXPECT_EQ(good.pixel(1, 2), (Color{0.5, 0.5, 0.5}));
    for (const auto& [x, y] : {std::pair{2, 0}, {0, 3}, {-1, 1}, {1, -1}, {1000000, 1000000}})
        EXPECT_EQ(good.pixel(x, y), Color{});
    for (const std::int32_t odd : k_odd_sizes) EXPECT_EQ(good.pixel(odd, odd == 0 ? -1 : odd), Color{});
    for (const Image& image : misfits()) {
        for (const std::int32_t at : {0, 1, 3, -1, std::numeric_limits<std::int32_t>::max() - 1})
            EXPECT_GE(image.pixel(at, at).r, 0);
    }
    EXPECT_EQ((Image{2, 2, std::vector<float>(11, 1)}.pixel(1, 1)), Color{}) << "one number is missing";
}

TEST(Misuse, OfEncode) {
    for (const FileFormat format : {FileFormat::png, FileFormat::ppm, FileFormat::exr}) {
        EncodeOptions options;
        options.format = format;
        for (const Image& image : misfits())
            expect_error(encode(image, options), "a picture that does not fit");
        Image odd = picture(4, 1);
        for (int i = 0; i < 5; ++i)
            odd.rgb[static_cast<std::size_t>(i)] = static_cast<float>(k_odd_numbers[i] * 1e-270);
        odd.rgb[6] = std::numeric_limits<float>::quiet_NaN();
        odd.rgb[7] = std::numeric_limits<float>::infinity();
        options.threads = -7;
        EXPECT_FALSE(encode(odd, options).value().empty());
    }
    const Image good = picture(2, 2);
    EncodeOptions options;
    options.format = beyond<FileFormat>();
    expect_error(encode(good, options), "no such format");
    options = {};
    options.transfer = beyond<Transfer>();
    expect_error(encode(good, options), "no such transfer");
    options = {};
    options.rounding = beyond<Rounding>();
    expect_error(encode(good, options), "no such rounding");
    EXPECT_EQ(EncodeOptions{}.rule(), Conventions{}.byte_rule());
    for (const double gamma : {0.0, -1.0, 101.0, std::numeric_limits<double>::quiet_NaN()}) {
        options = {};
        options.set_rule({Transfer::none, gamma, Rounding::down});
        expect_error(encode(good, options), "gamma");
    }
    for (const int bits : {0, -8, 7, 9, 17, 32, std::numeric_limits<int>::max()}) {
        options = {};
        options.bits = bits;
        expect_error(encode(good, options), "bits");
    }
}

TEST(Misuse, OfNumbers) {
    const float nan = std::numeric_limits<float>::quiet_NaN(),
                infinity = std::numeric_limits<float>::infinity();
    for (const Transfer transfer : {Transfer::none, Transfer::srgb, beyond<Transfer>()}) {
        EXPECT_EQ(to_byte(nan, transfer), 0);
        EXPECT_EQ(to_byte(-infinity, transfer), 0);
        EXPECT_EQ(to_byte(infinity, transfer), 255);
        for (const Rounding rounding : {Rounding::half_up, Rounding::down, beyond<Rounding>()}) {
            EXPECT_EQ(to_byte(nan, ByteRule{transfer, 2.2, rounding}), 0);
            EXPECT_EQ(to_byte(infinity, ByteRule{transfer, 2.2, rounding}), 255);
            EXPECT_LE(to_byte(0.5f, ByteRule{transfer, infinity, rounding}), 255);
        }
        for (const int bits : {16, 0, -1, 7, 64}) {
            EXPECT_EQ(to_number(nan, bits, transfer), 0u);
            EXPECT_EQ(to_number(infinity, bits, transfer), 65535u);
        }
    }
}

TEST(Misuse, OfDecode) {
    const auto refused = [](std::span<const std::uint8_t> bytes, const DecodeOptions& options = {}) {
        const Result<DecodedImage> result = decode(bytes, options);
        EXPECT_EQ(result.code, ErrorCode::parse);
        EXPECT_NE(result.message, "");
        EXPECT_FALSE(result);
    };
    refused({});
    const std::uint8_t nothing[64] = {};
    refused(nothing);
    for (const FileFormat format : {FileFormat::png, FileFormat::ppm, FileFormat::exr}) {
        EncodeOptions options;
        options.format = format;
        const std::vector<std::uint8_t> bytes = encode(picture(9, 7), options).value();
        ASSERT_FALSE(bytes.empty());
        EXPECT_TRUE(decode(bytes));
        for (const std::size_t cut : {std::size_t{3}, std::size_t{8}, bytes.size() / 2})
            refused(std::span(bytes).first(cut));
        for (const std::int64_t most :
             {std::int64_t{0}, std::int64_t{-1}, std::int64_t{62}, std::numeric_limits<std::int64_t>::min()})
            refused(bytes, {most});
    }
}

}  // namespace
}  // namespace glint::test
