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

/// What the alpha of a material does to that of its texture: OPAQUE removes it, MASK makes it 0 or 1.
struct TextureAlpha {
    bool is_kept = false;
    std::optional<double> cutoff;  ///< of the texture's alpha
    friend bool operator==(const TextureAlpha&, const TextureAlpha&) = default;
};

struct TextureUse {
    std::uint32_t texture = k_none;  ///< into Scene::textures
    std::uint32_t set = 0;           ///< TEXCOORD_n
};

class Textures {
  public:
    Textures(File& file, Buffers& buffers) : file_(file), buffers_(buffers) {}

    /// The texture of a textureInfo object. Nothing after an error; a use without texture if its picture
    /// cannot be read, which is a warning.
    std::optional<TextureUse> use(JsonValue info, const TextureAlpha& alpha);

  private:
    /// An image, as a material's alpha needs it.
    using PictureKey = std::tuple<std::uint32_t, bool, double>;
    /// A texture, its picture's alpha, and uv_map.
    using TextureKey = std::tuple<std::uint32_t, bool, double, std::array<double, 6>>;
    struct Picture {
        std::shared_ptr<const TextureImage> texels;  ///< null: it cannot be read
        std::string file;
    };
    bool read_sampler(JsonValue texture, Texture& to);
    bool read_wrap(JsonValue sampler, std::string_view key, TextureWrap& wrap);
    bool read_place(JsonValue info, Texture& to, TextureUse& use);
    const Picture* picture(JsonValue source, const TextureAlpha& alpha);
    std::optional<std::string_view> bytes_of(JsonValue image, std::string& name);

    File& file_;
    Buffers& buffers_;
    CountedMap<PictureKey, Picture> pictures_;
    CountedMap<TextureKey, std::uint32_t> textures_;  // into Scene::textures
};

}  // namespace glint::gltf
