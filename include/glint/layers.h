// SPDX-License-Identifier: Apache-2.0
#pragma once
// The layers of a picture: the parts of its light, and properties of the first surfaces.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glint/export.h"
#include "glint/image.h"

namespace glint {

struct Scene;

/// The first nine are light: their sum, as floats and in this order, is exactly the picture. Light seen in a
/// mirror belongs to reflection, light seen through glass to transmission; the first secondary ray of the
/// path decides. The other layers but shadow, occlusion and alpha describe the first hit of the pixel's
/// middle sample (row and column n / 2 of n).
///
/// Beyond the layers of layer_infos(), each light has a layer (light_layer()): the picture with this light
/// alone. It takes a render of its own.
enum class Layer : std::uint32_t {
    background,
    ambient,
    diffuse,
    specular,
    reflection,
    transmission,
    emission,   ///< k_e of the first surfaces
    sky,        ///< the light from all directions (Occlusion) that the first surfaces reflect
    fog,        ///< the light of the fog in front of the first surfaces and of the background
    normal,     ///< unit, as used for shading; 0 if nothing is hit
    depth,      ///< distance from the camera ray's origin, in world units; infinity if nothing is hit
    position,   ///< in world space; 0 if nothing is hit
    albedo,     ///< k_d; 0 if nothing is hit
    shadow,     ///< 0 to 1: the blocked fraction of the lights that would add light
    occlusion,  ///< 0 to 1: the fraction of the occlusion samples that are blocked
    object,     ///< index in Scene::shapes + 1 (exact up to 2^24); 0: no hit
    material,   ///< index in Scene::materials + 1, their number + 1 for the default; 0: no hit
    alpha,      ///< 1 - the part of the pixel that shows the background, directly or through glass; 0 to 1

    no_light = 0xffff,  ///< the picture without lights: background, emission, light from all directions, fog
};
inline constexpr int k_light_layers = 9, k_layers = 18;

struct LayerInfo {
    Layer layer;
    std::string_view name;      ///< "ambient"
    std::string_view channels;  ///< one letter per channel: "RGB", "XYZ", "Z" ...
    std::string_view description;
};
/// All layers but those of lights, in the order of Layer.
GLINT_API std::span<const LayerInfo> layer_infos();
/// The layer of this name; of a light by its number, counted from 1, as "light:2". "light:none" is no_light.
GLINT_API std::optional<Layer> find_layer(std::string_view name);
/// The same, and of a light of the scene by its name, as "light:lamp": the first one of this name. Nothing if
/// the scene has no such light.
GLINT_API std::optional<Layer> find_layer(std::string_view name, const Scene& scene);

/// The picture with light number `light` of Scene::lights alone: all other lights, the background, the
/// emission, the light from all directions and the fog's color are black. The layers of all lights and
/// no_light add up to the picture, but for rounding: within 1e-5 of it, times the largest value of a layer
/// where that is above 1. A light that is not below k_max_light_layers has no layer.
inline constexpr std::uint32_t k_max_light_layers = 0x7fff0000;
constexpr Layer light_layer(std::uint32_t light) {
    // The last number stands for every light beyond the limit: no layer has it, so that rendering refuses it.
    return static_cast<Layer>(0x10000 + (light < k_max_light_layers ? light : k_max_light_layers));
}
/// Whether the layer is one of light_layer(), or no_light.
constexpr bool is_light_layer(Layer layer) {
    const auto number = static_cast<std::uint32_t>(layer);
    return number >= 0xffff && number < 0x10000 + k_max_light_layers;
}
/// The index in Scene::lights of a light_layer(); nothing for others.
constexpr std::optional<std::uint32_t> light_of(Layer layer) {
    if (!is_light_layer(layer) || layer == Layer::no_light) return std::nullopt;
    return static_cast<std::uint32_t>(layer) - 0x10000;
}
/// "ambient", "light:2"; empty if there is no such layer.
GLINT_API std::string layer_name(Layer layer);
/// LayerInfo::channels; of lights "RGB"; empty if there is no such layer.
GLINT_API std::string_view layer_channels(Layer layer);

/// One layer: `channels` floats per pixel, row by row from the top.
struct LayerImage {
    Layer layer = Layer::background;
    std::int32_t width = 0, height = 0;
    int channels = 3;
    std::vector<float> values;
};

/// A layer as a picture for display: light and albedo unchanged; normals as 0.5 (N + 1); depth from white
/// (nearest) to dark (farthest), black for no hit; position scaled to the layer's range; shadow and alpha as
/// grey; a distinct color for each object and material. An error if the layer's channels or values do not
/// match its kind and size. Never throws.
GLINT_API Result<Image> viewable(const LayerImage& layer);

/// One OpenEXR file of several parts: `beauty` (the picture), then each layer under its name. Each layer may
/// occur once, and must have the picture's size and the channels and values of its kind. alpha: the alpha
/// channel of `beauty`, as for encode(); empty: none. Never throws.
GLINT_API Result<std::vector<std::uint8_t>> encode_layers(const Image& picture,
                                                          std::span<const LayerImage> layers,
                                                          std::span<const float> alpha = {});

}  // namespace glint
