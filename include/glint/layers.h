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

/// The first eight are light: their sum, as floats and in this order, is exactly the picture. Light seen in a
/// mirror belongs to reflection, light seen through glass to transmission; the first secondary ray of the
/// path decides. The other layers but shadow, occlusion and alpha describe the first hit of the pixel's
/// middle sample (row and column n / 2 of n).
enum class Layer : std::uint8_t {
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
};
inline constexpr int k_light_layers = 9, k_layers = 18;

struct LayerInfo {
    Layer layer;
    std::string_view name;      ///< "ambient"
    std::string_view channels;  ///< one letter per channel: "RGB", "XYZ", "Z" ...
    std::string_view description;
};
/// All layers, in the order of Layer.
GLINT_API std::span<const LayerInfo> layer_infos();
GLINT_API std::optional<Layer> find_layer(std::string_view name);

/// One layer: `channels` floats per pixel, row by row from the top.
struct LayerImage {
    Layer layer = Layer::background;
    std::int32_t width = 0, height = 0;
    int channels = 3;
    std::vector<float> values;
};

/// A layer as a picture for display: light and albedo unchanged; normals as 0.5 (N + 1); depth from white
/// (nearest) to dark (farthest), black for no hit; position scaled to the layer's range; shadow and alpha as
/// grey; a distinct colour for each object and material. An error if the layer's channels or values do not
/// match its kind and size. Never throws.
GLINT_API Result<Image> viewable(const LayerImage& layer);

/// One OpenEXR file of several parts: `beauty` (the picture), then each layer under its name. Each layer may
/// occur once, and must have the picture's size and the channels and values of its kind. alpha: the alpha
/// channel of `beauty`, as for encode(); empty: none. Never throws.
GLINT_API Result<std::vector<std::uint8_t>> encode_layers(const Image& picture,
                                                          std::span<const LayerImage> layers,
                                                          std::span<const float> alpha = {});

}  // namespace glint
