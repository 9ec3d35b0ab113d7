// SPDX-License-Identifier: Apache-2.0
// Layers as parts of an OpenEXR file, and as pictures.
#include "glint/layers.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <gtest/gtest.h>

#include <limits>

#include "image/memory_input.h"
#include "image/pictures.h"

namespace glint::test {
namespace {

LayerImage make_layer(Layer layer, int width, int height) {
    const auto channels = static_cast<int>(layer_infos()[static_cast<std::size_t>(layer)].channels.size());
    LayerImage image{layer, width, height, channels, {}};
    for (int i = 0; i < width * height * channels; ++i)
        image.values.push_back(static_cast<float>(i % 97) - 3);
    return image;
}

TEST(Layers, AreThePartsOfOneExrFile) {
    const Image picture = test::make_picture(31, 17);
    std::vector<LayerImage> layers{make_layer(Layer::normal, 31, 17), make_layer(Layer::depth, 31, 17),
                                   make_layer(Layer::object, 31, 17)};
    layers[1].values[5] = std::numeric_limits<float>::infinity();
    const Result<std::vector<std::uint8_t>> encoded = encode_layers(picture, layers);
    ASSERT_EQ(encoded.message, "");
    test::MemoryInput stream(*encoded);
    Imf::MultiPartInputFile file(stream, 0);
    ASSERT_EQ(file.parts(), 4);
    EXPECT_EQ(file.header(0).name(), "beauty");
    for (int i = 0; i < 3; ++i) {
        const LayerInfo& info =
            layer_infos()[static_cast<std::size_t>(layers[static_cast<std::size_t>(i)].layer)];
        EXPECT_EQ(file.header(i + 1).name(), info.name);
        std::vector<float> read(layers[static_cast<std::size_t>(i)].values.size());
        Imf::FrameBuffer frame;
        const std::size_t pixel = info.channels.size() * sizeof(float);
        for (std::size_t c = 0; c < info.channels.size(); ++c) {
            const std::string name(1, info.channels[c]);
            ASSERT_NE(file.header(i + 1).channels().findChannel(name), nullptr) << info.name << " " << name;
            frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&read[c]), pixel, pixel * 31));
        }
        Imf::InputPart part(file, i + 1);
        part.setFrameBuffer(frame);
        part.readPixels(0, 16);
        EXPECT_EQ(read, layers[static_cast<std::size_t>(i)].values) << info.name;
    }
}

TEST(Layers, OfAnotherSizeAreRejected) {
    const std::vector<LayerImage> layers{make_layer(Layer::depth, 30, 17)};
    EXPECT_NE(encode_layers(test::make_picture(31, 17), layers).message, "");
    EXPECT_NE(encode_layers(Image{}, {}).message, "");
}

TEST(Layers, AsPicturesForDisplay) {
    LayerImage depth{Layer::depth, 3, 1, 1, {2, std::numeric_limits<float>::infinity(), 12}};
    const Image far = viewable(depth).value();
    EXPECT_FLOAT_EQ(far.rgb[0], 1);
    EXPECT_EQ(far.rgb[3], 0);
    EXPECT_FLOAT_EQ(far.rgb[6], 0.1f);
    const LayerImage normal{Layer::normal, 2, 1, 3, {0, 0, 1, 0, 0, 0}};
    EXPECT_EQ(viewable(normal).value().rgb, (std::vector<float>{0.5f, 0.5f, 1, 0, 0, 0}));
    const LayerImage object{Layer::object, 3, 1, 1, {0, 1, 2}};
    const Image ids = viewable(object).value();
    EXPECT_EQ(ids.rgb[0], 0);
    EXPECT_NE(ids.rgb[3], ids.rgb[6]);
}

}  // namespace
}  // namespace glint::test
