// SPDX-License-Identifier: Apache-2.0
// The list of layers.
#include "glint/layers.h"

namespace glint {

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
    return std::nullopt;
}

}  // namespace glint
