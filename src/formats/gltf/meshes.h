// SPDX-License-Identifier: Apache-2.0
#pragma once
// Meshes of glTF: a mesh of glint for each primitive that has triangles.
#include <memory>
#include <optional>
#include <span>

#include "formats/gltf/accessors.h"
#include "formats/gltf/materials.h"
#include "glint/mesh.h"
#include "math/extent.h"

namespace glint::gltf {

/// A primitive.
struct MeshPart {
    std::uint32_t mesh = 0;  ///< into Scene::meshes
    std::uint32_t material = k_none;
    Extent box{};  ///< of its vertices
};

class Meshes {
  public:
    Meshes(File& file, Accessors& accessors, Materials& materials)
        : file_(file), accessors_(accessors), materials_(materials), known_(file.count(List::meshes)) {}

    /// The parts of a mesh, which are read once. Empty after an error.
    std::span<const MeshPart> parts(std::uint32_t mesh);

  private:
    struct Known {
        bool is_read = false;
        CountedVector<MeshPart> parts;
    };
    // The accessors of a primitive; null: there is none.
    struct Attributes {
        const Accessor *positions = nullptr, *normals = nullptr, *colors = nullptr, *coordinates = nullptr;
    };
    // The vertices of a mesh that shares its accessors with others: their numbers in the accessors.
    struct Used {
        CountedVector<std::uint32_t> order;
        bool is_all = true;
    };

    void read_primitive(JsonValue primitive, CountedVector<MeshPart>& parts);
    bool open_attributes(JsonValue attributes, const MaterialUse& use, Attributes& to);
    const Accessor* open_attribute(JsonValue attributes, std::string_view name, std::uint32_t least,
                                   std::uint32_t most, std::uint64_t count, bool& is_right);
    bool read_triangles(JsonValue primitive, std::uint64_t mode, const Accessor& positions, MeshData& mesh);
    bool has_room(std::uint64_t bytes, JsonValue at);
    Used use_vertices(std::uint64_t count, MeshData& mesh);
    bool read_values(const Accessor& accessor, const Used& used, const Range& range,
                     std::vector<Float3>& values);
    bool read_colors(const Accessor& accessor, const Used& used, const MaterialUse& use, MeshData& mesh);

    File& file_;
    Accessors& accessors_;
    Materials& materials_;
    CountedVector<Known> known_;
    CountedVector<std::uint32_t> numbers_;  // by vertex of an accessor: its number in the mesh, or k_none
};

}  // namespace glint::gltf
