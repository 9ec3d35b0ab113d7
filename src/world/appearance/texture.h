// SPDX-License-Identifier: Apache-2.0
#pragma once
// The colors of textures. docs/lighting.md defines them to the bit.
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "glint/scene.h"
#include "world/geometry/packed_geometry.h"

namespace glint {

/// The values of an image's words: word / 255 or word / 65535, or decoded by the sRGB curve.
using TexelValues = std::shared_ptr<const std::vector<double>>;

struct PreparedTexture : Texture {
    Affine texture_from_world;
    TexelValues colors, alphas;  // by word
    bool shows_behind = false;   // with `over`: whether all layers may be transparent

    /// In place of that of Texture, which knows one layer.
    bool has_alpha() const { return over == k_none ? Texture::has_alpha() : shows_behind; }
};

/// Throws std::bad_alloc.
std::vector<PreparedTexture> prepare_textures(std::span<const Texture> textures);

/// The place of a surface point in a texture's picture.
struct TexturePlace {
    double u = 0, v = 0;  // after Texture::uv_map; any numbers
};

/// A texture at a place: the texels, and how they are mixed.
struct TextureSample {
    TexturePlace place;
    /// The texels' columns from the left and rows from the top; with TextureFilter::nearest, the first ones;
    /// -1 beside the picture, with TextureWrap::clip. With a color_map: columns are the numbers of its
    /// colors.
    std::array<std::int32_t, 2> columns{}, rows{};
    double right = 0, lower = 0;  // weights of the second column and of the second row
    Color color;
    double alpha = 1;
    Color ambient{}, diffuse{};  // color times Texture::ambient and diffuse; of layers, the sums of these
};

/// The place that a mapping other than `uv` gives a point in the texture's coordinates, before
/// Texture::uv_map.
TexturePlace place_on(const Texture& texture, Vec3 p);

/// The place of a surface's point. Nothing without texture coordinates.
std::optional<TexturePlace> texture_place(const PackedGeometry& geometry, const PreparedTexture& texture,
                                          SurfaceId id, Vec3 point);

/// The texture at a place. Nothing beside the picture, with TextureWrap::once.
std::optional<TextureSample> sample_texture(const PreparedTexture& texture, TexturePlace place);

/// A texture at a point, and what it adds.
struct TextureLayer {
    std::uint32_t texture;
    TextureSample sample;
    double weight;  ///< its opacity, times what is left of those in front
};
/// The sum of the layers of a texture with Texture::over at a surface's point, with the place of the front
/// one (columns of -1 where it is not). layers: gets them from the front on; may be null.
std::optional<TextureSample> sample_layers(const PackedGeometry& geometry,
                                           std::span<const PreparedTexture> textures, std::uint32_t front,
                                           SurfaceId id, Vec3 point,
                                           std::vector<TextureLayer>* layers = nullptr);

}  // namespace glint
