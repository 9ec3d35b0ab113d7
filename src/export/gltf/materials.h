// SPDX-License-Identifier: Apache-2.0
#pragma once
// Materials of a Phong model as those of glTF. docs/formats/gltf.md states the convention.
#include <compare>
#include <map>
#include <optional>

#include "export/gltf/textures.h"

namespace glint::gltf_export {

/// A material as some shapes have it.
struct MaterialUse {
    std::uint32_t material = k_none;  ///< into Scene::materials
    std::optional<Color> color;       ///< of the shape
    bool is_textured = false;         ///< the surface has texture coordinates
    bool is_white = false;            ///< its color is that of the vertices alone
};

class MaterialList {
  public:
    MaterialList(const Scene& scene, const ColorRule& rule, File& file, TextureList& textures, Losses& losses)
        : scene_(scene), rule_(rule), file_(file), textures_(textures), losses_(losses) {}

    /// The number of a material in the file.
    std::uint32_t use(const MaterialUse& use);
    /// Its color, by which the colors of vertices are multiplied.
    Color color(const MaterialUse& use) { return item_of(use).color; }
    /// The texture of the scene's material; null: none.
    const Texture* texture(std::uint32_t material) const;

  private:
    struct Item {
        std::uint32_t number = k_no_index;
        Color color;
    };
    const Item& item_of(const MaterialUse& use);
    Material colored(const MaterialUse& use) const;
    Item write(const MaterialUse& use);
    void write_alpha(const Material& m, const Texture* texture, Json& to);
    void write_transmission(const Material& m, Json& extensions);
    void write_emission(const Material& m, Json& to, Json& extensions);
    void warn(const Material& m);
    Color limited(Color c);

    const Scene& scene_;
    const ColorRule& rule_;
    File& file_;
    TextureList& textures_;
    Losses& losses_;
    using Key = std::tuple<std::uint32_t, bool, double, double, double, bool, bool>;
    std::map<Key, Item> items_;
};

}  // namespace glint::gltf_export
