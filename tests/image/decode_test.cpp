// SPDX-License-Identifier: Apache-2.0
// decode() reads the files of encode() and of other programs, and is robust against hostile files.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>
#include <half.h>

#include <limits>

#include "image/foreign_files.h"
#include "image/memory_output.h"
#include "image/pictures.h"

namespace glint::test {
namespace {

using test::Bytes;
using test::make_jpeg;
using test::make_picture;
using test::make_png;

Bytes bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

// The picture as bytes, 3 per pixel; the test fails if there is none.
Bytes read_bytes_of(const Bytes& file) {
    const Result<DecodedImage> result = decode(file);
    EXPECT_EQ(result.message, "");
    if (!result) return {};
    Bytes bytes;
    for (const float value : result->image.rgb) bytes.push_back(to_byte(value));
    return bytes;
}

std::string error_of(const Bytes& file, const DecodeOptions& options = {}) {
    const Result<DecodedImage> result = decode(file, options);
    EXPECT_FALSE(result.has_value());
    return result.message;
}

TEST(Decode, RoundTrips) {
    const Image image = make_picture(77, 45);
    for (const FileFormat format : {FileFormat::png, FileFormat::ppm}) {
        for (const int bits : {8, 16}) {
            const EncodeOptions options{format, bits};
            const Bytes file = encode(image, options).value();
            const Result<DecodedImage> read = decode(file);
            ASSERT_TRUE(read.has_value()) << read.message;
            EXPECT_EQ(read->bits, bits);
            EXPECT_EQ(read->note, "");
            EXPECT_EQ(read->image.width, 77);
            EXPECT_EQ(read->image.height, 45);
            EXPECT_EQ(encode(read->image, options).value(), file);
        }
    }
    Image floats = image;
    floats.rgb[5] = 1e30f;
    const Result<DecodedImage> exr = decode(encode(floats, {FileFormat::exr}).value());
    ASSERT_TRUE(exr.has_value()) << exr.message;
    EXPECT_EQ(exr->bits, 32);
    EXPECT_EQ(exr->image.rgb, floats.rgb);
}

TEST(Decode, EveryKindOfPng) {
    using Row = std::vector<Bytes>;
    const Row grey = {{0xa5}, {0x0f}};
    EXPECT_EQ(read_bytes_of(make_png(4, {{0x1b}}, {PNG_COLOR_TYPE_GRAY, 2})),
              (Bytes{0, 0, 0, 85, 85, 85, 170, 170, 170, 255, 255, 255}));
    EXPECT_EQ(read_bytes_of(make_png(2, {{0, 200}}, {PNG_COLOR_TYPE_GRAY, 8})),
              (Bytes{0, 0, 0, 200, 200, 200}));
    EXPECT_EQ(read_bytes_of(make_png(2, {{0x2f}}, {PNG_COLOR_TYPE_PALETTE, 4})),
              (Bytes{32, 253, 2, 240, 240, 15}));
    EXPECT_EQ(read_bytes_of(make_png(8, grey, {PNG_COLOR_TYPE_GRAY, 1})).size(), 48u);
    // The same for interlaced files.
    Row rows;
    for (int y = 0; y < 13; ++y) {
        rows.emplace_back();
        for (int i = 0; i < 17 * 3; ++i) rows.back().push_back(static_cast<std::uint8_t>(7 * i + 31 * y));
    }
    EXPECT_EQ(read_bytes_of(make_png(17, rows, {PNG_COLOR_TYPE_RGB, 8, true})),
              read_bytes_of(make_png(17, rows, {PNG_COLOR_TYPE_RGB, 8, false})));
    const Bytes wide = make_png(1, {{0x12, 0x34, 0xff, 0xff, 0, 0}}, {PNG_COLOR_TYPE_RGB, 16});
    EXPECT_EQ(decode(wide)->image.rgb, (std::vector<float>{0x1234 / 65535.0f, 1, 0}));
}

TEST(Decode, IgnoresTransparencyWithANote) {
    const Bytes holes = make_png(2, {{10, 20, 30, 255, 40, 50, 60, 0}}, {PNG_COLOR_TYPE_RGB_ALPHA, 8});
    EXPECT_EQ(read_bytes_of(holes), (Bytes{10, 20, 30, 40, 50, 60}));
    EXPECT_EQ(decode(holes)->note, "its transparency is left out");
    EXPECT_EQ(decode(make_png(1, {{10, 20, 30, 255}}, {PNG_COLOR_TYPE_RGB_ALPHA, 8}))->note, "");
}

TEST(Decode, PpmAndPgmAsTextAndRaw) {
    EXPECT_EQ(read_bytes_of(bytes_of("P3 # a comment\n2 # another\n1\n5\n0 1 2\n5 4 3")),
              (Bytes{0, 51, 102, 255, 204, 153}));
    EXPECT_EQ(read_bytes_of(bytes_of("P2 2 1 255 0 200 ")), (Bytes{0, 0, 0, 200, 200, 200}));
    EXPECT_EQ(read_bytes_of(bytes_of("P5 2 1 255\nAB")), (Bytes{65, 65, 65, 66, 66, 66}));
    EXPECT_EQ(read_bytes_of(bytes_of("P6 1 1 255\n#AB")), (Bytes{35, 65, 66}));
}

TEST(Decode, BrokenPpm) {
    const std::pair<const char*, const char*> cases[] = {
        {"P6", "ends before the width"},
        {"P6 2 2 255\nabc", "cut off"},
        {"P6 0 2 255\n", "0 x 2 pixels"},
        {"P6 2 2 0\nabcdefghijkl", "the maximum is 0"},
        {"P6 2 2 65536\n", "the maximum is more than 65535"},
        {"P6 -2 2 255\n", "no number: expected the width"},
        {"P6 1 1 255", "no space follows"},
        {"P6 999999999999 1 255\n", "the width is more than"},
        {"P3 1 1 255 1 2 x3456", "no number: expected a sample"},
        {"P3 1 1 255 1 2 256", "a sample is more than 255"},
        {"P7 1 1", "no PNG, PPM"},
        {"", "an empty file"}};
    for (const auto& [text, message] : cases)
        EXPECT_NE(error_of(bytes_of(text)).find(message), std::string::npos)
            << text << ": " << error_of(bytes_of(text));
}

TEST(Decode, Jpeg) {
    const int width = 40, height = 24;
    Bytes samples;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            samples.push_back(static_cast<std::uint8_t>(5 * x));
            samples.push_back(static_cast<std::uint8_t>(9 * y));
            samples.push_back(static_cast<std::uint8_t>(255 - 3 * x - 2 * y));
        }
    }
    for (const bool progressive : {false, true}) {
        const Bytes read = read_bytes_of(make_jpeg(width, height, 3, samples, progressive));
        ASSERT_EQ(read.size(), samples.size());
        for (std::size_t i = 0; i < read.size(); ++i) ASSERT_NEAR(read[i], samples[i], 4) << i;
    }
    const Bytes grey(samples.begin(), samples.begin() + width * height);
    const Bytes read = read_bytes_of(make_jpeg(width, height, 1, grey, false));
    ASSERT_EQ(read.size(), 3 * grey.size());
    for (std::size_t i = 0; i < read.size(); ++i) ASSERT_NEAR(read[i], grey[i / 3], 4) << i;
    Bytes cut = make_jpeg(width, height, 3, samples, false);
    cut.resize(cut.size() / 2);
    EXPECT_NE(error_of(cut).find("JPEG: "), std::string::npos);
}

// A data window of 2 x 1 pixels at (1, 1) of a display window of 4 x 3.
template <class T> Bytes make_exr(const std::vector<const char*>& names, const std::vector<T>& values) {
    MemoryOutput out;
    const Imath::Box2i shown({0, 0}, {3, 2}), data({1, 1}, {2, 1});
    Imf::Header header(shown, data);
    Imf::FrameBuffer buffer;
    const auto type = sizeof(T) == 2 ? Imf::HALF : Imf::FLOAT;
    for (std::size_t c = 0; c < names.size(); ++c) {
        header.channels().insert(names[c], Imf::Channel(type));
        buffer.insert(names[c], Imf::Slice::Make(type, &values[c], data, names.size() * sizeof(T)));
    }
    {
        Imf::OutputFile file(out, header, 0);
        file.setFrameBuffer(buffer);
        file.writePixels(1);
    }
    return out.bytes;
}

TEST(Decode, OpenExrOfOtherPrograms) {
    const std::vector<half> halves = {half(0.5f),  half(2.0f), half(-1.0f),
                                      half(0.25f), half(0.0f), half(8.0f)};
    const Result<DecodedImage> colors = decode(make_exr(std::vector<const char*>{"R", "G", "B"}, halves));
    ASSERT_TRUE(colors.has_value()) << colors.message;
    ASSERT_EQ(colors->image.width, 4);
    ASSERT_EQ(colors->image.height, 3);
    std::vector<float> expected(36);
    for (std::size_t i = 0; i < 6; ++i) expected[3 * 5 + i] = halves[i];
    EXPECT_EQ(colors->image.rgb, expected);

    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Result<DecodedImage> grey =
        decode(make_exr(std::vector<const char*>{"Y"}, std::vector<float>{0.5f, nan}));
    ASSERT_TRUE(grey.has_value()) << grey.message;
    EXPECT_EQ(grey->image.rgb[3 * 5 + 1], 0.5f);
    EXPECT_TRUE(std::isnan(grey->image.rgb[3 * 6 + 1]));
    EXPECT_NE(grey->note.find("NaN"), std::string::npos);
    EXPECT_NE(error_of(make_exr(std::vector<const char*>{"Z"}, std::vector<float>{1, 2})).find("no channels"),
              std::string::npos);
}

TEST(Decode, RejectsTruncatedFiles) {
    const Image image = make_picture(9, 7);
    for (const FileFormat format : {FileFormat::png, FileFormat::ppm, FileFormat::exr}) {
        const Bytes file = encode(image, {format}).value();
        for (std::size_t size = 0; size < file.size(); ++size) {
            const Result<DecodedImage> result = decode(std::span(file).first(size));
            EXPECT_FALSE(result.has_value()) << size << " of " << file.size();
            EXPECT_NE(result.message, "");
        }
    }
}

// Small files that claim to be large are rejected at once, before memory is allocated.
TEST(Decode, RejectsFilesThatClaimToBeHuge) {
    EXPECT_NE(error_of(bytes_of("P6 65536 65536 255\n")).find("at most 67108864 in all"), std::string::npos);
    EXPECT_NE(error_of(bytes_of("P6 65537 1 255\n")).find("1 to 65536 a side"), std::string::npos);
    EXPECT_NE(error_of(bytes_of("P6 8000 8000 255\n")).find("cut off"), std::string::npos);
    Bytes png = encode(make_picture(2, 2)).value();
    for (int i = 16; i < 24; ++i) png[i] = i % 4 == 2 ? 0x1f : 0;  // 7936 x 7936, and the checksum is wrong
    EXPECT_NE(error_of(png), "");
    const Bytes honest = make_png(4000, std::vector<Bytes>(4000, Bytes(500)), {PNG_COLOR_TYPE_GRAY, 1});
    EXPECT_LT(honest.size(), 10000u);
    EXPECT_TRUE(decode(honest));
    DecodeOptions small;
    small.max_pixels = 1000;
    EXPECT_NE(error_of(honest, small).find("at most 1000 in all"), std::string::npos);
}

}  // namespace
}  // namespace glint::test
