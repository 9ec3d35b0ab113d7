// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures on surfaces: images, samplers, and where they are on the surface.
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "formats/gltf/buffers.h"
#include "glint/texture.h"

namespace glint::gltf {

struct TextureUse {
    std::uint32_t texture = k_none;  ///< into Scene::textures
    std::uint32_t set = 0;           ///< TEXCOORD_n
};

class Textures {
  public:
    Textures(File& file, Buffers& buffers) : file_(file), buffers_(buffers) {}

    /// The texture of a textureInfo object. Nothing after an error; a use without texture if its picture
    /// cannot be read, which is a warning. cutoff: Texture::alpha_cutoff, for TextureAlpha::mask.
    std::optional<TextureUse> use(JsonValue info, TextureAlpha alpha, double cutoff, TextureMix mix);

    /// The mean over the texels of a textureInfo object's picture, 0 to 1, not decoded. Nothing if there is
    /// no picture that can be read: an error, or a warning.
    std::optional<Color> mean(JsonValue info);

  private:
    /// A texture, what its alpha does, the cutoff, and uv_map.
    using TextureKey = std::tuple<std::uint32_t, TextureAlpha, TextureMix, double, std::array<double, 6>>;
    struct Picture {
        std::shared_ptr<const TextureImage> texels;  ///< null: it cannot be read
        std::string file;
        std::optional<Color> mean;  // once it was asked for
    };
    struct Source {
        std::uint32_t texture = k_none;  // in the file
        JsonValue image;                 // does not exist: the texture has none that glint reads
    };
    std::optional<Source> source(JsonValue info);
    bool read_sampler(JsonValue texture, Texture& to);
    bool read_wrap(JsonValue sampler, std::string_view key, TextureWrap& wrap);
    bool read_place(JsonValue info, Texture& to, TextureUse& use);
    Picture* picture(JsonValue source);
    std::shared_ptr<const TextureImage> decoded(JsonValue image, std::string_view bytes);
    bool read_picture(JsonValue image, Picture& picture);

    File& file_;
    Buffers& buffers_;
    CountedMap<std::uint32_t, Picture> pictures_;     // by image
    CountedMap<TextureKey, std::uint32_t> textures_;  // into Scene::textures
};

}  // namespace glint::gltf
