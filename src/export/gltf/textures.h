// SPDX-License-Identifier: Apache-2.0
#pragma once
// Textures: pictures as PNG in the buffer, samplers, and the maps of u and v.
#include <map>
#include <optional>
#include <tuple>

#include "export/gltf/colors.h"
#include "export/gltf/file.h"
#include "export/gltf/losses.h"

namespace glint::gltf_export {

/// How KHR_texture_transform has a map of u and v.
struct UvTransform {
    double offset[2] = {0, 0}, scale[2] = {1, 1}, rotation = 0;
    bool is_identity() const {
        return offset[0] == 0 && offset[1] == 0 && scale[0] == 1 && scale[1] == 1 && rotation == 0;
    }
};

/// The extension's numbers for Texture::uv_map, as the reader of glTF makes it. Nothing for other maps: they
/// are applied to the coordinates in the file. Among them is the usual map of glint, whose v goes up.
std::optional<UvTransform> transform_of(const UvMap& map);

class TextureList {
  public:
    TextureList(const Scene& scene, const ColorRule& rule, File& file, Losses& losses)
        : scene_(scene), rule_(rule), file_(file), losses_(losses) {}

    /// The textureInfo of Scene::textures[texture]; null if this build cannot write pictures.
    Json info(std::uint32_t texture);

  private:
    std::uint32_t image(const Texture& texture);
    std::uint32_t sampler(const Texture& texture);
    void warn(const Texture& texture);

    const Scene& scene_;
    const ColorRule& rule_;
    File& file_;
    Losses& losses_;
    std::map<std::tuple<const TextureImage*, TextureEncoding, bool>, std::uint32_t> images_;
    std::map<std::tuple<TextureWrap, TextureWrap, TextureFilter>, std::uint32_t> samplers_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> textures_;  // by image and sampler
    std::map<std::uint32_t, Json> infos_;
};

}  // namespace glint::gltf_export
