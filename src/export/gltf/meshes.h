// SPDX-License-Identifier: Apache-2.0
#pragma once
// Meshes of a scene as those of glTF: a primitive for each kind of triangles.
#include <array>
#include <map>
#include <tuple>

#include "export/gltf/materials.h"

namespace glint::gltf_export {

class MeshList {
  public:
    MeshList(File& file, MaterialList& materials, Losses& losses)
        : file_(file), materials_(materials), losses_(losses) {}

    /// The number of the mesh with this material and color; k_no_index if it has no triangles. The mesh must
    /// live as long as this object; its vertices and those with another material share their numbers.
    std::uint32_t use(const MeshData& mesh, std::uint32_t material, const std::optional<Color>& color,
                      const std::string& name, const ColorRule& rule);

  private:
    // Triangles that have the same of these are a primitive.
    struct Kind {
        bool normals = false, colors = false, textured = false;
        std::size_t number() const { return (normals ? 1u : 0) + (colors ? 2u : 0) + (textured ? 4u : 0); }
    };
    using Kinds = std::array<std::vector<std::uint32_t>, 8>;
    struct Numbers {  // NOLINT(bugprone-exception-escape): the JSON library moves without exceptions
        Json attributes;
        std::uint32_t indices = 0;
    };
    using Factor = std::array<double, 3>;
    using Map = std::array<double, 6>;
    // Which numbers a primitive has: the mesh, its kind, the color of its material, and its map of u and
    // v.
    using Key = std::tuple<const MeshData*, std::size_t, Factor, Map>;

    const Numbers& numbers(const MeshData& mesh, Kind kind, const std::vector<std::uint32_t>* triangles,
                           Color of_material, const Texture* texture, const ColorRule& rule);
    MaterialUse colored_use(const MeshData& mesh, MaterialUse use, const ColorRule& rule);

    File& file_;
    MaterialList& materials_;
    Losses& losses_;
    std::map<Key, Numbers> numbers_;
    std::map<std::tuple<const MeshData*, std::uint32_t, bool, Factor>, std::uint32_t> meshes_;
};

}  // namespace glint::gltf_export
