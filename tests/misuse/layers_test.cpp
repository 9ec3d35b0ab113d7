// SPDX-License-Identifier: Apache-2.0
// Invalid layers, and layers whose values do not fit.
#include "misuse/misused.h"

namespace glint::test {
namespace {

std::vector<LayerImage> odd_layers() {
    std::vector<LayerImage> layers;
    for (const LayerInfo& info : layer_infos()) {
        const auto channels = static_cast<int>(info.channels.size());
        const std::size_t values = info.channels.size() * 6;
        layers.push_back({info.layer, 3, 2, channels, std::vector<float>(values - 1)});
        layers.push_back({info.layer, 3, 2, channels, std::vector<float>(values + 1)});
        layers.push_back({info.layer, 3, 2, channels, {}});
        for (const int wrong : {0, -1, 4, 4 - channels, std::numeric_limits<int>::max()}) {
            layers.push_back({info.layer, 3, 2, wrong, std::vector<float>(values)});
            layers.push_back(
                {info.layer, 3, 2, wrong, std::vector<float>(std::size_t{6} * (wrong == 4 ? 4 : 1))});
        }
        for (const std::int32_t size : k_odd_sizes) {
            layers.push_back({info.layer, size, 2, channels, std::vector<float>(values)});
            layers.push_back({info.layer, 3, size, channels, std::vector<float>(values)});
            layers.push_back({info.layer, size, size, channels, {}});
        }
    }
    layers.push_back({beyond<Layer>(), 3, 2, 3, std::vector<float>(18)});
    layers.push_back({static_cast<Layer>(k_layers), 3, 2, 1, std::vector<float>(6)});
    return layers;
}

TEST(Misuse, OfViewable) {
    for (const LayerImage& layer : odd_layers()) {
        // Among the sizes of `wrong` channels, one may be right.
        const auto number = static_cast<std::size_t>(layer.layer);
        const Result<Image> image = viewable(layer);
        const bool fits = number < layer_infos().size() && layer.width == 3 && layer.height == 2 &&
                          layer.channels == static_cast<int>(layer_infos()[number].channels.size()) &&
                          layer.values.size() == std::size_t{6} * static_cast<std::size_t>(layer.channels);
        ASSERT_EQ(image.code, fits ? ErrorCode::none : ErrorCode::invalid_argument)
            << number << ' ' << layer.channels;
        if (!fits) continue;
        EXPECT_EQ(image->rgb.size(), 18u);
        EXPECT_EQ(image->width, 3);
    }
    // Values that render() never returns.
    for (const LayerInfo& info : layer_infos()) {
        const std::size_t channels = info.channels.size();
        LayerImage layer{info.layer, 5, 1, static_cast<int>(channels), {}};
        for (std::size_t i = 0; i < 5 * channels; ++i)
            layer.values.push_back(static_cast<float>(k_odd_numbers[i % 5] * (i % 2 == 0 ? 1 : 1e-265)));
        EXPECT_EQ(viewable(layer).value().rgb.size(), 15u) << info.name;
    }
}

TEST(Misuse, OfEncodeLayers) {
    for (const LayerImage& layer : odd_layers()) {
        if (viewable(layer)) continue;
        const Result<std::vector<std::uint8_t>> result = encode_layers(picture(3, 2), {&layer, 1});
        EXPECT_EQ(result.code, ErrorCode::invalid_argument);
        EXPECT_NE(result.message, "");
    }
    for (const Image& image : misfits()) EXPECT_NE(encode_layers(image, {}).message, "");
    const LayerImage depth{Layer::depth, 3, 2, 1, std::vector<float>(6)};
    const LayerImage twice[] = {depth, depth};
    EXPECT_NE(encode_layers(picture(3, 2), twice).message, "");
    EXPECT_NE(encode_layers(picture(2, 3), {&depth, 1}).message, "");
    EXPECT_EQ(encode_layers(picture(3, 2), {&depth, 1}).message, "");
}

TEST(Misuse, OfFindLayer) {
    for (const char* const name : {"", "Depth", "depth ", "shadows"}) EXPECT_FALSE(find_layer(name)) << name;
    EXPECT_EQ(find_layer("depth"), Layer::depth);
    const Scene scene = some_scene();
    for (const char* const name : {"", "light:", "light:0", "light:99999999999", "light:1 ", "Light:1"})
        EXPECT_FALSE(find_layer(name, scene)) << name;
}

TEST(Misuse, OfTheLayersOfLights) {
    for (const Layer layer :
         {beyond<Layer>(), static_cast<Layer>(k_layers), static_cast<Layer>(0xfffe),
          light_layer(k_max_light_layers), light_layer(0xffffffff), static_cast<Layer>(0xffffffff)}) {
        EXPECT_FALSE(is_light_layer(layer));
        EXPECT_FALSE(light_of(layer));
        EXPECT_EQ(layer_name(layer), "");
        EXPECT_EQ(layer_channels(layer), "");
    }
    EXPECT_EQ(light_of(light_layer(k_max_light_layers - 1)), k_max_light_layers - 1);
}

}  // namespace
}  // namespace glint::test
