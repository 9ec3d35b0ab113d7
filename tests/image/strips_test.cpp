// SPDX-License-Identifier: Apache-2.0
// Pictures that are encoded strip by strip have the bytes of encode().
#include "image/strip_encoder.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "base/status.h"
#include "image/memory_file.h"

namespace glint::test {
namespace {

Image some_picture(std::int32_t width, std::int32_t height) {
    Image image{width, height, {}};
    std::uint32_t state = 7;
    for (std::int32_t i = 0; i < 3 * width * height; ++i) {
        state = state * 1664525u + 1013904223u;
        image.rgb.push_back(i % 50 < 30 ? 0.25f : static_cast<float>(state >> 8) / 0x1p24f);
    }
    return image;
}

std::span<const float> strip_of(const Image& image, std::int32_t strip) {
    const std::size_t row = std::size_t{3} * static_cast<std::size_t>(image.width);
    const std::size_t first = row * static_cast<std::size_t>(strip) * k_strip_rows;
    return std::span(image.rgb).subspan(first, std::min(row * k_strip_rows, image.rgb.size() - first));
}

TEST(Strips, GiveTheBytesOfTheWhole) {
    for (const auto& [width, height] : {std::pair{1, 1}, {50, 32}, {33, 65}, {7, 100}}) {
        const Image image = some_picture(width, height);
        for (const EncodeOptions& options :
             {EncodeOptions{FileFormat::png, 8, Transfer::none},
              EncodeOptions{FileFormat::png, 16, Transfer::srgb},
              EncodeOptions{FileFormat::ppm, 16, Transfer::none}, EncodeOptions{FileFormat::bmp},
              EncodeOptions{FileFormat::jpeg}, EncodeOptions{FileFormat::exr}}) {
            const auto whole = encode(image, options);
            if (!whole) continue;  // a build without the format
            std::vector<std::uint8_t> bytes;
            MemoryFile file(bytes);
            const auto encoder = make_strip_encoder(width, height, options, file);
            ASSERT_NE(encoder, nullptr);
            // Encoded in any order, and appended in order.
            std::vector<EncodedStrip> strips(static_cast<std::size_t>(count_strips(height)));
            for (std::size_t i = strips.size(); i-- > 0;) {
                const auto strip = static_cast<std::int32_t>(i);
                strips[i] = encoder->encode(strip, strip_of(image, strip));
            }
            for (EncodedStrip& strip : strips) encoder->append(std::move(strip));
            encoder->finish();
            EXPECT_EQ(bytes, *whole) << width << "x" << height << " " << static_cast<int>(options.format);
        }
    }
}

TEST(Strips, OfLayersGiveTheBytesOfTheWhole) {
    const Image image = some_picture(40, 70);
    LayerImage depth{Layer::depth, 40, 70, 1, std::vector<float>(40 * 70, 3)};
    LayerImage normal{Layer::normal, 40, 70, 3, image.rgb};
    const std::vector<LayerImage> layers{depth, normal};
    const auto whole = encode_layers(image, layers);
    if (!whole) GTEST_SKIP() << whole.message;
    std::vector<std::uint8_t> bytes;
    MemoryFile file(bytes);
    const Layer kinds[] = {Layer::depth, Layer::normal};
    const auto encoder = make_parts_encoder(40, 70, kinds, file);
    const std::vector<float>* values[] = {&image.rgb, &depth.values, &normal.values};
    for (std::size_t part = 0; part < 3; ++part) {
        const std::size_t channels = part == 1 ? 1 : 3;
        for (std::int32_t first = 0; first < 70; first += k_strip_rows) {
            encoder->append(part, first, std::min(k_strip_rows, 70 - first),
                            values[part]->data() + channels * 40 * static_cast<std::size_t>(first));
        }
    }
    encoder->finish();
    EXPECT_EQ(bytes, *whole);
}

TEST(Strips, AreRefusedAsTheWhole) {
    std::vector<std::uint8_t> bytes;
    MemoryFile file(bytes);
    for (const FileFormat format : {FileFormat::tga, FileFormat::bmp, FileFormat::jpeg})
        EXPECT_THROW(make_strip_encoder(8, 8, {format, 16}, file), StatusError);
    EXPECT_THROW(make_strip_encoder(8, 8, {FileFormat::ppm}, file, true), StatusError);
    EXPECT_THROW(make_strip_encoder(65501, 8, {FileFormat::jpeg}, file), StatusError);
    EXPECT_TRUE(bytes.empty());
}

// After more bytes than libjpeg's first buffer has: an error while a picture is written.
TEST(Strips, MayEndBeforeTheFileDoes) {
    Image image{256, 256, std::vector<float>(std::size_t{3} * 256 * 256)};
    std::uint32_t state = 1;
    for (float& v : image.rgb)
        v = static_cast<float>((state = state * 1664525 + 1013904223) >> 8) / (1 << 24);
    for (const FileFormat format : {FileFormat::png, FileFormat::bmp, FileFormat::jpeg, FileFormat::exr}) {
        if (!encode(image, {format})) continue;  // a build without the format
        std::vector<std::uint8_t> bytes;
        MemoryFile file(bytes);
        const auto encoder = make_strip_encoder(256, 256, {format}, file);
        for (std::int32_t strip = 0; strip < 4; ++strip)
            encoder->append(encoder->encode(strip, strip_of(image, strip)));
        if (format == FileFormat::jpeg) {
            EXPECT_GT(bytes.size(), 10000u) << "written while it is encoded";
        }
    }
}

// The library of OpenEXR ignores errors at the end of a file, where it writes its table of lines.
TEST(Strips, ReportAFullDisk) {
    struct FullFile : ByteFile {
        std::uint64_t left = 0, written = 0;
        void write(std::span<const std::uint8_t> bytes) override {
            if (bytes.size() > left) throw std::runtime_error("full");
            left -= bytes.size();
            written += bytes.size();
        }
        std::uint64_t position() const override { return written; }
        void seek(std::uint64_t) override { left = 0; }
    };
    const Image image = some_picture(64, 4);
    for (const FileFormat format : {FileFormat::png, FileFormat::ppm, FileFormat::exr}) {
        FullFile file;
        EncodeOptions options;
        options.format = format;
        options.bits = 16;
        const auto write = [&](std::uint64_t room) {
            file.left = room;
            const auto encoder = make_strip_encoder(64, 4, options, file);
            if (encoder == nullptr) throw std::runtime_error("not built");
            encoder->append(encoder->encode(0, image.rgb));
            encoder->finish();
        };
        EXPECT_THROW(write(600), std::exception) << static_cast<int>(format);
        if (format == FileFormat::exr) {
            EXPECT_THROW(write(1 << 20), std::exception) << "the table";
        }
    }
}

}  // namespace
}  // namespace glint::test
