// SPDX-License-Identifier: Apache-2.0
// Pictures that keep the numbers of their files are compared as those with floats.
#include <gtest/gtest.h>

#include "image/decoders.h"
#include "image/levels.h"
#include "image/pictures.h"

namespace glint::test {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct File {
    const char* name;
    Bytes bytes;
    std::size_t channel_bytes;  // as stored
};

Bytes odd_ppm(std::uint32_t most) {
    const std::string header = "P6 60 50 " + std::to_string(most) + "\n";
    Bytes file(header.begin(), header.end());
    for (std::uint32_t i = 0; i < 3 * 60 * 50; ++i) {
        const std::uint32_t value = i * i % (most + 3);  // above the maximum, too
        if (most > 255) file.push_back(static_cast<std::uint8_t>(value >> 8));
        file.push_back(static_cast<std::uint8_t>(value));
    }
    return file;
}

std::vector<File> files() {
    const Image image = make_picture(60, 50);
    return {{"PNG of 8 bits", encode(image).value(), 1},
            {"PNG of 16 bits", encode(image, {FileFormat::png, 16}).value(), 2},
            {"PPM of 8 bits", encode(image, {FileFormat::ppm}).value(), 1},
            {"PPM of 16 bits", encode(image, {FileFormat::ppm, 16}).value(), 2},
            {"PPM up to 100", odd_ppm(100), 1},
            {"PPM up to 1000", odd_ppm(1000), 2},
            {"OpenEXR", encode(image, {FileFormat::exr}).value(), 4}};
}

std::string text_of(const PixelCounts& c) {
    return testing::PrintToString(std::vector{c.pixels, c.equal, c.within_1, c.within});
}

// All figures, exactly.
std::string text_of(const PictureDifference& d) {
    const auto& l = d.largest;
    return text_of(d.all) + text_of(d.edges) + text_of(d.interiors) +
           testing::PrintToString(std::vector<std::uint64_t>{
               d.not_finite, std::bit_cast<std::uint64_t>(d.mean), std::bit_cast<std::uint64_t>(d.rms),
               std::bit_cast<std::uint64_t>(d.psnr.value_or(-1)),
               std::bit_cast<std::uint64_t>(d.ssim.value_or(-2)), std::bit_cast<std::uint64_t>(l.value)}) +
           testing::PrintToString(std::vector<float>{static_cast<float>(l.x), static_cast<float>(l.y), l.a[0],
                                                     l.a[1], l.a[2], l.b[0]});
}

TEST(StoredPicture, KeepsTheNumbersOfItsFile) {
    for (const File& file : files()) {
        SCOPED_TRACE(file.name);
        const Result<DecodedImage> image = decode(file.bytes);
        const Result<DecodedPicture> stored = decode_stored(file.bytes, {});
        ASSERT_TRUE(image && stored) << image.message << stored.message;
        const std::size_t count = image->image.rgb.size();
        EXPECT_EQ(stored->picture.bytes(), count * file.channel_bytes);
        EXPECT_EQ(stored->bits, image->bits);
        std::vector<float> buffer(count);
        const float* values = PictureView(stored->picture).values(0, count, buffer.data());
        EXPECT_EQ(std::vector<float>(values, values + count), image->image.rgb);
    }
}

TEST(StoredPicture, IsComparedAsTheImage) {
    for (const File& a : files()) {
        for (const File& b : files()) {
            for (const bool as_floats : {false, true}) {
                SCOPED_TRACE(std::string(a.name) + ", " + b.name);
                const CompareOptions options{as_floats};
                const DecodedPicture stored_a = *decode_stored(a.bytes, {}),
                                     stored_b = *decode_stored(b.bytes, {});
                const auto by_images = compare(decode(a.bytes)->image, decode(b.bytes)->image, options),
                           stored =
                               compare(PictureView(stored_a.picture), PictureView(stored_b.picture), options);
                ASSERT_TRUE(by_images && stored);
                EXPECT_EQ(text_of(*stored), text_of(*by_images));
            }
        }
    }
}

TEST(StoredPicture, HasTheRowsOfTheDifference) {
    const Image a = make_picture(30, 20);
    Image b = a;
    for (float& value : b.rgb) value *= 0.5f;
    for (const double gain : {0.0, 3.0}) {
        const Image whole = difference_image(a, b, gain).value();
        const DifferenceRows rows(a, b, gain);
        std::vector<float> all, row(90), buffer(90);
        for (std::int32_t y = 0; y < 20; ++y) {
            rows.read(y, row.data(), buffer.data());
            all.insert(all.end(), row.begin(), row.end());
        }
        EXPECT_EQ(all, whole.rgb);
    }
}

// ---- Limits of memory ----

TEST(MaxMemory, IsALimitOfDecoding) {
    for (const File& file : files()) {
        SCOPED_TRACE(file.name);
        DecodeOptions options;
        options.max_memory = 60 * 50 * 12;  // the floats alone
        const Result<DecodedImage> refused = decode(file.bytes, options);
        EXPECT_EQ(refused.code, ErrorCode::out_of_memory);
        EXPECT_NE(refused.message.find("max_memory"), std::string::npos) << refused.message;
        options.max_memory *= 20;
        EXPECT_TRUE(decode(file.bytes, options));
    }
}

TEST(MaxMemory, IsALimitOfComparing) {
    const Image a = make_picture(300, 200), b = make_picture(300, 200);
    CompareOptions options;
    options.max_memory = 100'000;
    const Result<PictureDifference> refused = compare(a, b, options);
    EXPECT_EQ(refused.code, ErrorCode::out_of_memory);
    EXPECT_NE(refused.message.find("are allowed"), std::string::npos) << refused.message;
    options.threads = 64;
    options.max_memory = 2'000'000;  // enough for few of the threads
    const Result<PictureDifference> with_few = compare(a, b, options);
    ASSERT_TRUE(with_few) << with_few.message;
    EXPECT_EQ(text_of(*with_few), text_of(*compare(a, b)));
}

TEST(MaxMemory, IsALimitOfCauses) {
    const Image a = make_picture(300, 200);
    Image b = a;
    for (float& value : b.rgb) value *= 0.5f;
    CauseOptions options;
    options.max_memory = 10 * 300 * 200 - 1;
    const Result<CauseReport> refused = find_causes(a, b, nullptr, options);
    EXPECT_EQ(refused.code, ErrorCode::out_of_memory);
    EXPECT_NE(refused.message.find("max_memory"), std::string::npos) << refused.message;
    ++options.max_memory;
    EXPECT_TRUE(find_causes(a, b, nullptr, options));
    const Scene scene;
    EXPECT_EQ(find_causes(a, b, &scene, options).code, ErrorCode::out_of_memory);
}

}  // namespace
}  // namespace glint::test
