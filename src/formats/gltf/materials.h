// SPDX-License-Identifier: Apache-2.0
#pragma once
// Materials of glTF as those of a Phong model. docs/formats/gltf.md states the convention.
#include <array>
#include <optional>
#include <string>

#include "formats/gltf/textures.h"
#include "scene/material_color.h"

namespace glint::gltf {

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

struct MaterialUse {
    std::uint32_t material = k_none;  ///< into Scene::materials
    Color factor{1, 1, 1};            ///< of the colors of vertices
    bool is_visible = true;           ///< false: its alpha is below the cutoff
    bool is_unlit = false;
    bool is_transparent = false;    ///< its alpha counts
    std::uint32_t texture_set = 0;  ///< of texture coordinates
    bool has_texture = false;
};

class Materials {
  public:
    Materials(File& file, Textures& textures) : file_(file), textures_(textures) {
        for (auto& known : known_) known.resize(std::size_t{file.count(List::materials)} + 1);
    }

    /// The material of a primitive, or the default one. Nothing after an error. With COLOR_0, the highlights
    /// of what is no metal do not take the colors of the vertices.
    std::optional<MaterialUse> use(JsonValue primitive);

  private:
    // The color of the surface, its alpha and its texture.
    struct Base {
        Color color{1, 1, 1};
        double alpha = 1;
        JsonValue texture;
        bool has_vertex_colors = false;
        bool is_metal = false;  // and nothing else

        // What the coefficients are multiples of.
        Color reflected() const { return has_vertex_colors && !is_metal ? k_color_of_vertices : color; }
    };
    std::optional<MaterialUse> read(JsonValue at, bool has_vertex_colors);
    bool read_alpha(JsonValue at, AlphaMode& mode, double& cutoff, Material& material);
    bool read_reflection(JsonValue at, Base& base, Material& material);
    bool read_glossiness(JsonValue from, Base& base, Material& material);
    bool read_metal(JsonValue at, Base& base, Material& material);
    bool read_emission(JsonValue at, Material& material);
    bool read_transmission(JsonValue at, const Base& base, Material& material);
    void warn_about_maps(JsonValue at);

    struct Known {
        bool is_read = false;
        std::optional<MaterialUse> use;
    };
    File& file_;
    Textures& textures_;
    // Without and with colors of vertices; the last one is the default material.
    std::array<CountedVector<Known>, 2> known_;
};

/// What a surface reflects. metal: the part of f0, the light that it reflects at a right angle, that has the
/// metal's color.
struct Reflection {
    Color diffuse, metal, f0;
    double roughness = 1;  ///< 0 to 1
};
/// Sets color, ambient, diffuse, specular and shininess.
void set_reflection(Material& material, const Reflection& reflection);

}  // namespace glint::gltf
