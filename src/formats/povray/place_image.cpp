// SPDX-License-Identifier: Apache-2.0
// Pictures and patterns on surfaces, at their place in the scene.
#include <algorithm>

#include "formats/povray/scene_builder.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

// In POV-Ray, around the y axis u = 0 is at +x and u = 0.25 at +z.
constexpr Affine k_pattern_from_round{{{0, 0, -1, 0}, {0, 1, 0, 0}, {-1, 0, 0, 0}}};

Affine after(const Affine* outer, const Affine& inner) { return outer ? compose(*outer, inner) : inner; }

}  // namespace

// The scene's texture for a surface whose pigment has an image.
std::uint32_t SceneBuilder::texture_of(const Inherited& own, const Token& at, std::uint32_t over) {
    const Pigment& pigment = own.texture->pigment;
    const glint::Texture& image = *pigment.image;
    const Affine pattern = pigment.map.value_or(Affine{});
    const bool is_pattern = !image.image;
    const bool is_uv = own.is_uv || own.texture->has_own_place();
    glint::Texture texture = image;
    texture.over = over;
    const Color& emission = own.texture->finish.emission;
    set_shares(own.texture->finish, texture);
    if (!(emission == Color{0, 0, 0})) texture.mix = TextureMix::multiply_all;
    texture.from_uv = is_uv && is_pattern && own.uv_source == UvSource::vertices;
    if (texture.from_uv) {
        // The pattern at (u, v, 0), with the pigment's transforms only. (Measured)
        texture.world_from_texture = compose(pattern, image.world_from_texture);
        // `radial` at z = 0 and x > 0 is at the end of its period, not at the start. (Measured)
        if (texture.mapping == TextureMapping::cylindrical) texture.uv_map.m[0][2] -= 1e-9;
        return add_texture(std::move(texture), pigment.image_number, at);
    }
    if (is_uv && is_pattern)
        report({"uv_mapping", "of a pattern, of what is no mesh with uv_vectors", stream_.call_place(at)});
    if (is_uv && !is_pattern) {
        if (image.mapping != TextureMapping::planar)
            report({"uv_mapping", "of an image_map with a map_type", stream_.call_place(at)});
        // u and v are the pattern's x and y.
        const auto uv_from_pattern = inverse(pattern);
        if (!uv_from_pattern) {
            stream_.error(at, "the transform of the texture leaves nothing of it");
            return k_none;
        }
        const auto& m = uv_from_pattern->m;
        texture.uv_map = {{{m[0][0], m[0][1], m[0][3]}, {m[1][0], m[1][1], m[1][3]}}};
        texture.mapping = TextureMapping::planar;
        if (own.uv_source == UvSource::vertices) texture.mapping = TextureMapping::uv;
        if (own.uv_source == UvSource::sphere) {
            texture.mapping = TextureMapping::spherical;
            texture.world_from_texture = compose(*own.sphere, k_pattern_from_round);
        }
        if (own.uv_source == UvSource::unknown)
            report({"uv_mapping", "of a box, or of a mesh without uv_vectors", stream_.call_place(at)});
    } else {
        const bool is_round = !is_pattern && image.mapping != TextureMapping::planar;
        texture.world_from_texture = after(
            own.texture_map, compose(pattern, is_round ? k_pattern_from_round : image.world_from_texture));
    }
    return add_texture(std::move(texture), pigment.image_number, at);
}

// The number of a texture whose colors this number stands for; 0: of one color.
std::uint32_t SceneBuilder::add_texture(glint::Texture texture, double image_number, const Token& at) {
    NumberTable<23>::Key key{image_number, static_cast<double>(texture.mapping),
                             static_cast<double>(texture.mix), texture.over + 1.0};
    key[20] = texture.ambient, key[21] = texture.diffuse, key[22] = texture.from_uv ? 1 : 0;
    if (image_number == 0) {
        const TextureColor& c = texture.color_map.front();
        key[4] = c.color.r, key[5] = c.color.g, key[6] = c.color.b, key[7] = c.alpha;
    }
    double* number = key.data() + 8;
    for (const auto& row : texture.world_from_texture.m) number = std::copy(row, row + 4, number);
    if (const std::uint32_t* known = textures_.find(key)) return *known;
    if (!inverse(texture.world_from_texture)) {
        stream_.error(at, "the transform of the texture leaves nothing of it");
        return k_none;
    }
    const auto number_of_texture = static_cast<std::uint32_t>(scene_.textures.size());
    textures_.add(key, number_of_texture);
    note(scene_.texture_texts, number_of_texture, stream_.place_of(stream_.call_place(at)));
    scene_.textures.push_back(std::move(texture));
    return number_of_texture;
}

}  // namespace glint::povray
