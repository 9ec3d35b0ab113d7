// SPDX-License-Identifier: Apache-2.0
// The list of layers.
#include "glint/layers.h"

#include <charconv>

#include "glint/scene.h"

namespace glint {
namespace {

constexpr std::string_view k_light = "light:", k_nothing = "none";

// A light's number from 1, as an index.
std::optional<std::uint32_t> parse_number(std::string_view text) {
    std::uint32_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [read, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || read != end || number < 1 || number > k_max_light_layers) return std::nullopt;
    return number - 1;
}

}  // namespace

std::span<const LayerInfo> layer_infos() {
    static constexpr LayerInfo list[k_layers] = {
        {Layer::background, "background", "RGB", "light of camera rays that hit nothing"},
        {Layer::ambient, "ambient", "RGB", "k_a I_a of the first surfaces; all of an unlit shading mode"},
        {Layer::diffuse, "diffuse", "RGB", "k_d terms of the first surfaces"},
        {Layer::specular, "specular", "RGB", "k_s terms of the first surfaces"},
        {Layer::reflection, "reflection", "RGB", "what mirrors show"},
        {Layer::transmission, "transmission", "RGB", "what glass and transparent surfaces let through"},
        {Layer::emission, "emission", "RGB", "k_e of the first surfaces"},
        {Layer::sky, "sky", "RGB", "light from all directions that the first surfaces reflect"},
        {Layer::fog, "fog", "RGB", "light of the fog in front of the first surfaces and of the background"},
        {Layer::normal, "normal", "XYZ", "unit normal of the first surface"},
        {Layer::depth, "depth", "Z", "its distance from the camera; infinity: nothing is hit"},
        {Layer::position, "position", "XYZ", "its point in world space"},
        {Layer::albedo, "albedo", "RGB", "its k_d"},
        {Layer::shadow, "shadow", "Y",
         "of the lights that would add something, how many are blocked, 0 to 1"},
        {Layer::occlusion, "occlusion", "Y", "of the occlusion samples, how many are blocked, 0 to 1"},
        {Layer::object, "object", "I", "its number in the scene, from 1; 0: nothing is hit"},
        {Layer::material, "material", "I", "its material's number in the scene, from 1; 0: nothing is hit"},
        {Layer::alpha, "alpha", "A",
         "1 minus the part of the pixel that shows the background, directly or through glass"},
    };
    return list;
}

std::optional<Layer> find_layer(std::string_view name) {
    for (const LayerInfo& info : layer_infos()) {
        if (info.name == name) return info.layer;
    }
    if (!name.starts_with(k_light)) return std::nullopt;
    name.remove_prefix(k_light.size());
    if (name == k_nothing) return Layer::no_light;
    const std::optional<std::uint32_t> light = parse_number(name);
    if (!light) return std::nullopt;
    return light_layer(*light);
}

std::optional<Layer> find_layer(std::string_view name, const Scene& scene) {
    const std::optional<Layer> layer = find_layer(name);
    if (layer && !light_of(*layer)) return layer;
    if (!name.starts_with(k_light) || name == k_light) return std::nullopt;
    const auto count = static_cast<std::uint32_t>(scene.lights.size());
    for (std::uint32_t i = 0; i < count; ++i) {
        if (scene.light_texts.name(i) == name.substr(k_light.size())) return light_layer(i);
    }
    if (!layer || *light_of(*layer) >= count) return std::nullopt;
    return layer;
}

std::string layer_name(Layer layer) {
    const auto number = static_cast<std::size_t>(layer);
    if (number < k_layers) return std::string(layer_infos()[number].name);
    if (layer == Layer::no_light) return std::string(k_light) + std::string(k_nothing);
    const std::optional<std::uint32_t> light = light_of(layer);
    return light ? std::string(k_light) + std::to_string(std::uint64_t{*light} + 1) : std::string();
}

std::string_view layer_channels(Layer layer) {
    const auto number = static_cast<std::size_t>(layer);
    if (number < k_layers) return layer_infos()[number].channels;
    return is_light_layer(layer) ? "RGB" : "";
}

}  // namespace glint
