// SPDX-License-Identifier: Apache-2.0
// OpenEXR: all floats are read back unchanged.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "image/memory_input.h"
#include "image/pictures.h"

namespace glint::test {
namespace {

TEST(Exr, ReadsBackEqual) {
    for (const auto& [width, height] :
         {std::pair{1, 1}, std::pair{1, 100}, std::pair{33, 77}, std::pair{300, 20}}) {
        Image image = test::make_picture(width, height);
        image.rgb[0] = 1e30f;
        image.rgb[1] = -1e-40f;
        const Result<std::vector<std::uint8_t>> encoded = encode(image, {FileFormat::exr});
        ASSERT_EQ(encoded.message, "");
        test::MemoryInput stream(*encoded);
        Imf::InputFile file(stream, 0);
        std::vector<float> read(image.rgb.size());
        Imf::FrameBuffer channels;
        const char* names[] = {"R", "G", "B"};
        for (int c = 0; c < 3; ++c) {
            ASSERT_NE(file.header().channels().findChannel(names[c]), nullptr);
            EXPECT_EQ(file.header().channels()[names[c]].type, Imf::FLOAT);
            channels.insert(names[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&read[c]), 12,
                                                 12 * static_cast<std::size_t>(width)));
        }
        const auto window = file.header().dataWindow();
        ASSERT_EQ(window.max.x - window.min.x + 1, width);
        ASSERT_EQ(window.max.y - window.min.y + 1, height);
        file.setFrameBuffer(channels);
        file.readPixels(window.min.y, window.max.y);
        EXPECT_EQ(std::memcmp(read.data(), image.rgb.data(), read.size() * sizeof(float)), 0);
    }
}

TEST(Exr, HasTheSameBytesForAnyThreads) {
    const Image image = test::make_picture(100, 100);
    const auto one = encode(image, {FileFormat::exr, 8, Transfer::none, 1}).value();
    EXPECT_EQ(one, encode(image, {FileFormat::exr, 8, Transfer::none, 7}).value());
    EXPECT_EQ(one, encode(image, {FileFormat::exr, 16, Transfer::srgb, 2}).value()) << "always linear floats";
}

}  // namespace
}  // namespace glint::test
