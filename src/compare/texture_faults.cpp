// SPDX-License-Identifier: Apache-2.0
// Faults of textures: where in the picture a point is, what its texels are, and what is beside it.
#include <cmath>
#include <utility>

#include "compare/scene_faults.h"
#include "math/srgb.h"

namespace glint {
namespace {

constexpr std::size_t k_max_decoded = std::size_t{1} << 21;  // texels of a scene that are decoded again

template <class Test> bool any_texture(const Scene& s, Test&& test) {
    return s.settings.shading != Shading::normals && any_material(s, [&](const Material& m) {
               return m.texture < s.textures.size() && test(s.textures[m.texture]);
           });
}
bool has_textures(const Scene& s) {
    return any_texture(s, [](const Texture&) { return true; });
}
template <TextureEncoding encoding> bool has_texels(const Scene& s) {
    return any_texture(s, [](const Texture& t) { return t.encoding == encoding; });
}
template <TextureMix mix> bool has_mix_of(const Scene& s) {
    return any_texture(s, [](const Texture& t) { return t.mix == mix; });
}
template <TextureWrap wrap> bool has_other_wrap(const Scene& s) {
    return any_texture(s, [](const Texture& t) { return t.wrap_u != wrap || t.wrap_v != wrap; });
}
template <TextureFilter filter> bool has_filter_of(const Scene& s) {
    return any_texture(s, [](const Texture& t) { return t.filter == filter; });
}
bool has_texel_alpha(const Scene& s) {
    return any_texture(s, [](const Texture& t) { return t.has_alpha(); });
}
template <TextureAlpha alpha> bool has_alpha_of(const Scene& s) {
    return any_texture(s, [](const Texture& t) { return t.has_alpha() && t.alpha == alpha; });
}
bool has_uv_map(const Scene& s) {
    return any_texture(s, [](const Texture& t) { return !(t.uv_map == UvMap{}); });
}
// u and v exchanged before the map, as a map.
UvMap exchanged_before(UvMap map) {
    for (auto& row : map.m) std::swap(row[0], row[1]);
    return map;
}
UvMap exchanged_after(UvMap map) {
    std::swap(map.m[0], map.m[1]);
    return map;
}
bool has_exchange_before(const Scene& s) {
    return any_texture(
        s, [](const Texture& t) { return !(exchanged_before(t.uv_map) == exchanged_after(t.uv_map)); });
}
bool has_few_encoded_texels(const Scene& s) {
    std::size_t texels = 0;
    for (const Texture& t : s.textures)
        if (t.image) texels += std::size_t{t.image->width} * t.image->height;
    return texels <= k_max_decoded && has_texels<TextureEncoding::srgb>(s);
}

template <class Change> void for_each_texture(Scene& s, Change&& change) {
    for (Texture& texture : s.textures) change(texture);
}
// Of the maps of u and of v.
void reverse(double (&row)[3]) {
    row[0] = -row[0];
    row[1] = -row[1];
    row[2] = 1 - row[2];
}
template <int row> void reverse_direction(Scene& s) {
    for_each_texture(s, [](Texture& t) { reverse(t.uv_map.m[row]); });
}
template <TextureEncoding encoding> void set_encoding(Scene& s) {
    for_each_texture(s, [](Texture& t) { t.encoding = encoding; });
}
template <TextureMix mix> void set_mix(Scene& s) {
    for_each_texture(s, [](Texture& t) { t.mix = mix; });
}
template <TextureWrap wrap> void set_wrap(Scene& s) {
    for_each_texture(s, [](Texture& t) { t.wrap_u = t.wrap_v = wrap; });
}
// Of those that have the other one: a texture without alpha, or whose alpha is ignored, stays as it is.
template <TextureAlpha from, TextureAlpha to> void change_alpha(Scene& s) {
    for_each_texture(s, [](Texture& t) {
        if (t.alpha == from) t.alpha = to;
    });
}
template <TextureFilter filter> void set_filter(Scene& s) {
    for_each_texture(s, [](Texture& t) { t.filter = filter; });
}
void shift_half_texel(Scene& s) {
    for_each_texture(s, [](Texture& t) {
        if (t.filter == TextureFilter::nearest || !t.image) return;
        t.uv_map.m[0][2] += 0.5 / t.image->width;
        t.uv_map.m[1][2] -= 0.5 / t.image->height;
    });
}

// An image whose words are those of the other one, decoded.
TextureImage decoded(const TextureImage& image) {
    TextureImage to{image.width, image.height, image.has_alpha, {}};
    std::visit(
        [&](const auto& words) {
            constexpr double k_most = sizeof(words[0]) == 1 ? 255 : 65535;
            std::vector<std::uint16_t> table;
            for (double i = 0; i <= k_most; ++i)
                table.push_back(
                    static_cast<std::uint16_t>(std::floor(65535 * srgb_decode(i / k_most) + 0.5)));
            std::vector<std::uint16_t> made(words.size());
            for (std::size_t i = 0; i < words.size(); ++i) {
                const bool is_alpha = image.has_alpha && i % 4 == 3;
                made[i] =
                    is_alpha ? static_cast<std::uint16_t>(words[i] * (65535 / k_most)) : table[words[i]];
            }
            to.words = std::move(made);
        },
        image.words);
    return to;
}
void decode_again(Scene& s) {
    for_each_texture(s, [](Texture& t) {
        if (t.encoding == TextureEncoding::srgb && t.image)
            t.image = std::make_shared<const TextureImage>(decoded(*t.image));
    });
}

constexpr SceneFault k_textures[] = {
    {"texture-missing", has_textures,
     [](Scene& s) { for_each_material(s, [](Material& m) { m.texture = k_none; }); },
     "Textures are missing: the color, k_a and k_d of a surface are multiplied by that of its texture, or "
     "replaced."},
    {"texture-upside-down", has_textures, reverse_direction<1>,
     "Textures are upside down: v = 0 is the lower edge of the picture, and its rows begin at the upper "
     "one."},
    {"texture-mirrored", has_textures, reverse_direction<0>,
     "Left and right of textures are exchanged: u = 0 is the left edge of the picture."},
    {"texture-swapped", has_textures,
     [](Scene& s) { for_each_texture(s, [](Texture& t) { t.uv_map = exchanged_after(t.uv_map); }); },
     "u and v of textures are exchanged: u goes to the right in the picture, and v up."},
    {"texture-swapped", has_exchange_before,
     [](Scene& s) { for_each_texture(s, [](Texture& t) { t.uv_map = exchanged_before(t.uv_map); }); },
     "u and v of textures are exchanged before `uv_map`: u goes to the right in the picture, and v up."},
    {"texture-map-missing", has_uv_map,
     [](Scene& s) { for_each_texture(s, [](Texture& t) { t.uv_map = {}; }); },
     "u and v of textures are not mapped by `uv_map`."},
    {"texture-alpha-ignored", has_texel_alpha,
     [](Scene& s) { for_each_texture(s, [](Texture& t) { t.alpha = TextureAlpha::ignore; }); },
     "The alpha of textures is ignored: surfaces are transparent, or have holes, where it is low."},
    {"texture-alpha-mode", has_alpha_of<TextureAlpha::mask>,
     change_alpha<TextureAlpha::mask, TextureAlpha::blend>,
     "Surfaces are as transparent as the alpha of their texture says, and in the reference they have holes "
     "where it is below a cutoff, and are opaque elsewhere."},
    {"texture-alpha-mode", has_alpha_of<TextureAlpha::blend>,
     change_alpha<TextureAlpha::blend, TextureAlpha::mask>,
     "Surfaces have holes where the alpha of their texture is low, and in the reference they are as "
     "transparent as it says."},
    {"texture-replaces", has_mix_of<TextureMix::multiply>, set_mix<TextureMix::replace>,
     "A texture's color replaces that of the material, and in the reference it multiplies it."},
    {"texture-multiplies", has_mix_of<TextureMix::replace>, set_mix<TextureMix::multiply>,
     "A texture's color multiplies that of the material, and in the reference it replaces it."},
    {"texture-not-decoded", has_texels<TextureEncoding::srgb>, set_encoding<TextureEncoding::linear>,
     "The texels are not decoded: apply the sRGB curve to them before they are multiplied."},
    {"texture-decoded", has_texels<TextureEncoding::linear>, set_encoding<TextureEncoding::srgb>,
     "The texels are decoded by the sRGB curve, and in the reference they are not."},
    {"texture-decoded-twice", has_few_encoded_texels, decode_again,
     "The texels are decoded twice by the sRGB curve, and in the reference once."},
    {"texture-wrap", has_other_wrap<TextureWrap::repeat>, set_wrap<TextureWrap::repeat>,
     "Where u or v is below 0 or above 1, a texture's picture is repeated, unlike in the reference."},
    {"texture-wrap", has_other_wrap<TextureWrap::mirror>, set_wrap<TextureWrap::mirror>,
     "Where u or v is below 0 or above 1, a texture's picture is repeated, every other time reversed, unlike "
     "in the reference."},
    {"texture-wrap", has_other_wrap<TextureWrap::clamp>, set_wrap<TextureWrap::clamp>,
     "Where u or v is below 0 or above 1, the border of a texture's picture is continued, unlike in the "
     "reference."},
    {"texture-wrap", has_other_wrap<TextureWrap::once>, set_wrap<TextureWrap::once>,
     "Where u or v is below 0 or above 1, surfaces have no texture, unlike in the reference."},
    {"texture-filter", has_filter_of<TextureFilter::bilinear>, set_filter<TextureFilter::nearest>,
     "A texture's color is that of the nearest texel, and in the reference it is a mean of the nearest "
     "four."},
    {"texture-filter", has_filter_of<TextureFilter::nearest>, set_filter<TextureFilter::bilinear>,
     "A texture's color is a mean of the nearest four texels, and in the reference it is the nearest one's."},
    {"texture-half-texel", has_filter_of<TextureFilter::bilinear>, shift_half_texel,
     "Textures are shifted by half a texel: the color of texel i is that at (i + 0.5) / width, not at i / "
     "width."},
};

}  // namespace

std::span<const SceneFault> texture_faults() { return k_textures; }

}  // namespace glint
