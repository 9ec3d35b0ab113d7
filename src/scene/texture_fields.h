// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string_view>

#include "scene/fields.h"

namespace glint {

inline constexpr std::string_view k_wrap_words[] = {"repeat", "mirror", "clamp", "once", "clip"};
inline constexpr std::string_view k_filter_words[] = {"nearest", "bilinear", "distance"};
inline constexpr std::string_view k_mix_words[] = {"multiply", "replace", "multiply_all"};
inline constexpr std::string_view k_encoding_words[] = {"linear", "srgb"};
inline constexpr std::string_view k_alpha_words[] = {"blend", "mask", "ignore"};
inline constexpr std::string_view k_mapping_words[] = {
    "uv",      "planar", "spherical", "cylindrical", "checker", "onion",    "rings",  "boxes",     "slabs",
    "leopard", "bricks", "hexagons",  "noise",       "granite", "wrinkles", "spiral", "mandelbrot"};
inline constexpr Range k_octaves{0, 10, false, false, "a number from 0 to 10"};
inline constexpr Range k_iterations{1, 1e6, false, false, "a number from 1 to 1e6"};

template <> struct FieldMembers<Texture> {
    template <class Choice> using Chosen = FieldMember<Texture, Choice, ChoiceType>;
    using Any = std::variant<Chosen<TextureMapping>, Chosen<TextureWrap>, Chosen<TextureFilter>,
                             Chosen<TextureMix>, Chosen<TextureEncoding>, Chosen<TextureAlpha>,
                             FieldMember<Texture, double, NumberType>, FieldMember<Texture, bool, BoolType>,
                             FieldMember<Texture, Vec3, PointType>, FieldMember<Texture, UvMap, UvMapType>,
                             FieldMember<Texture, std::uint32_t, TextureType>>;
};

/// .glint also has `file`, `texels` or `color_map`, and the keys of transforms.
inline constexpr ItemField<Texture> k_texture_fields[] = {
    {"mapping", "mapping", "mapping", choice_field(&Texture::mapping, k_mapping_words),
     "where u and v come from: a mesh's vertices, or the point in the texture's coordinates"},
    {"from_uv", "from_uv", "from u and v", bool_field(&Texture::from_uv),
     "true: the mapping's point is (u, v, 0), of a mesh's vertices; with a color_map"},
    {"wrap_u", "wrap_u", "wrap of u", choice_field(&Texture::wrap_u, k_wrap_words),
     "what is to the left and right of the picture"},
    {"wrap_v", "wrap_v", "wrap of v", choice_field(&Texture::wrap_v, k_wrap_words),
     "what is below and above it"},
    {"filter", "filter", "filter", choice_field(&Texture::filter, k_filter_words),
     "the texel at the point, or a mean of four"},
    {"mix", "mix", "mix", choice_field(&Texture::mix, k_mix_words),
     "whether the material's color, k_a and k_d are multiplied by the texture's color (multiply_all: k_e, "
     "too), or the color is replaced"},
    {"encoding", "encoding", "encoding", choice_field(&Texture::encoding, k_encoding_words),
     "whether the texels are decoded by the sRGB curve"},
    {"alpha", "alpha", "alpha", choice_field(&Texture::alpha, k_alpha_words),
     "whether the surface is transparent where texels are, or has holes there, or neither"},
    {"alpha_cutoff", "alpha_cutoff", "cutoff of alpha", number_field(&Texture::alpha_cutoff, k_fraction),
     "with mask: texels of less alpha are holes"},
    {"mortar", "mortar", "mortar", point_field(&Texture::mortar),
     "of bricks: the parts of their length, height and depth that are mortar, 0 to 1"},
    {"turbulence", "turbulence", "turbulence", point_field(&Texture::turbulence),
     "how far noise moves the point, in the texture's coordinates; not with uv"},
    {"octaves", "octaves", "octaves", number_field(&Texture::octaves, k_octaves),
     "of turbulence: how many sizes of noise are added"},
    {"gain", "gain", "gain", number_field(&Texture::gain, k_fraction),
     "of turbulence: the strength of each size in that of the size before"},
    {"lacunarity", "lacunarity", "lacunarity", number_field(&Texture::lacunarity, k_length),
     "of turbulence: how many times finer each size is than the size before"},
    {"iterations", "iterations", "iterations", number_field(&Texture::iterations, k_iterations),
     "of mandelbrot: the greatest number of steps"},
    {"uv_map", "uv_map", "map of u and v", uv_map_field(&Texture::uv_map),
     "two rows of three numbers: a u + b v + c and d u + e v + f are used instead of u and v"},
    {"over", "over", "over", texture_field(&Texture::over),
     "the texture that is seen where this one is transparent, or is not; not with mask"},
    {"ambient", "ambient", "ambient", number_field(&Texture::ambient, k_fraction),
     "the factor of its color in the surface's k_a: of layers that reflect light differently"},
    {"diffuse", "diffuse", "diffuse", number_field(&Texture::diffuse, k_fraction),
     "the factor of its color in the surface's k_d"},
};

}  // namespace glint
