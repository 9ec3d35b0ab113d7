// SPDX-License-Identifier: Apache-2.0
// Layered textures. Measured in POV-Ray's pictures (tests/peers/layers.py): each layer shows the part of its
// color that its filter and transmit leave, and lets through filter times its color, and transmit, of what is
// below it.
#include <algorithm>

#include "formats/povray/scene_builder.h"

namespace glint::povray {
namespace {

bool have_one_light(const Finish& a, const Finish& b) {
    return a.ambient == b.ambient && a.diffuse == b.diffuse && a.emission == b.emission;
}

}  // namespace

SceneBuilder::LayerLight SceneBuilder::light_of_layers(const Texture& texture) {
    LayerLight light;
    const Texture* layer = &texture;
    while (layer) {
        const Finish& f = layer->finish;
        if (largest(f.ambient) > largest(light.ambient)) light.ambient = f.ambient;
        light.diffuse = std::max(light.diffuse, f.diffuse);
        layer = is_clear(*layer) ? layer->below.get() : nullptr;
    }
    return light;
}

// The parts of the material's ambient and diffuse color that a layer with this finish has.
void SceneBuilder::set_shares(const Finish& finish, glint::Texture& texture) const {
    if (!layer_light_) return;
    const auto part = [](double x, double most) { return most > 0 ? std::clamp(x / most, 0.0, 1.0) : 1; };
    texture.ambient = part(largest(finish.ambient), largest(layer_light_->ambient));
    texture.diffuse = part(finish.diffuse, layer_light_->diffuse);
}

SceneBuilder::Look SceneBuilder::look_of(const Inherited& own, const Token& at) {
    const Texture& texture = *own.texture;
    if (texture.pigment.under) {
        Texture others = texture;
        others.pigment = *texture.pigment.under;
        Inherited below = own;
        below.texture = &others;
        return over(own, look_of(below, at), at);
    }
    if (texture.below && is_clear(texture)) {
        Inherited below = own;
        below.texture = texture.below.get();
        return over(own, look_of(below, at), at);
    }
    return {texture.pigment.color, texture.pigment.image ? texture_of(own, at) : k_none, &texture.finish};
}

// The top layer over what those below look like.
SceneBuilder::Look SceneBuilder::over(const Inherited& own, const Look& below, const Token& at) {
    const Pigment& pigment = own.texture->pigment;
    const std::array<double, 5>&top = pigment.color, &c = below.color;
    const Finish& finish = own.texture->finish;
    const bool is_plain = !pigment.image && below.image == k_none && have_one_light(finish, *below.finish);
    const bool is_opaque = below.image == k_none && c[3] == 0 && c[4] == 0;
    if (c[3] != 0 || (top[3] != 0 && !(is_plain && is_opaque)))
        report({"filter", "of a layer of a texture: it is drawn as transmit", stream_.call_place(at)});
    const double left = opacity_of(top), seen = 1 - left;
    if (is_plain) {
        const double filter = is_opaque ? top[3] : 0, opacity = opacity_of(c);
        Look look;
        look.finish = &finish;
        look.color[4] = seen * (1 - opacity);
        const double sum = 1 - look.color[4];
        for (std::size_t i = 0; i < 3 && sum > 0; ++i)
            look.color[i] = (left * top[i] + (seen - filter + filter * top[i]) * opacity * c[i]) / sum;
        return look;
    }
    const bool is_changed = pigment.image && (top[3] != 0 || top[4] != 0);
    if (is_changed || (below.image != k_none && (c[3] != 0 || c[4] != 0)))
        report({"filter, transmit", "of a picture that is a layer of a texture", stream_.call_place(at)});
    const std::uint32_t lower =
        below.image == k_none ? texture_of_color(*below.finish, c, k_none, at) : below.image;
    int layers = 1;
    for (std::uint32_t i = lower; i != k_none; i = scene_.textures[i].over) ++layers;
    if (layers > k_max_texture_layers) {
        report(
            {"layered textures", "more of them than 16: the highest are left out", stream_.call_place(at)});
        return {{1, 1, 1, 0, 0}, lower};
    }
    return {{1, 1, 1, 0, 0},
            pigment.image ? texture_of(own, at, lower) : texture_of_color(finish, top, lower, at)};
}

// A texture of one color.
std::uint32_t SceneBuilder::texture_of_color(const Finish& finish, const std::array<double, 5>& color,
                                             std::uint32_t over, const Token& at) {
    glint::Texture texture;
    texture.mapping = TextureMapping::planar;
    texture.color_map = {{0, rgb_of(color), opacity_of(color)}};
    texture.over = over;
    set_shares(finish, texture);
    if (!(finish.emission == Color{0, 0, 0})) texture.mix = TextureMix::multiply_all;
    return add_texture(std::move(texture), 0, at);
}

}  // namespace glint::povray
