// SPDX-License-Identifier: Apache-2.0
#pragma once
// A mesh as the scene has it: one MeshData for each look, whose colors are those of the corners.
#include <cstdint>
#include <memory>
#include <vector>

#include "formats/povray/object.h"

namespace glint::povray {

/// The faces of a mesh whose textures look the same but for their colors.
struct MeshPart {
    std::shared_ptr<const MeshData> data;
    /// Null: that of the object. If the data has colors, the texture's own color is not seen.
    std::shared_ptr<const Texture> texture;
    std::uint32_t index = CornerValues::k_none;  ///< in Scene::meshes, once it is there
};

struct MeshParts {
    CountedVector<MeshPart> parts;
    CountedVector<std::uint32_t> blended;  ///< triangles whose corners differ in more than color
    /// Textures of faces that have warnings of their own.
    CountedVector<std::shared_ptr<const Texture>> warned;
};

/// Textures by their look: those with the same number differ at most in color.
class Looks {
  public:
    /// Of the textures that its faces have.
    explicit Looks(const ReadMesh& mesh);
    /// CornerValues::k_none: no face has it.
    std::uint32_t of(std::uint32_t texture) const { return of_[texture]; }
    std::uint32_t count() const { return static_cast<std::uint32_t>(first_.size()); }
    /// The first texture with this look.
    std::uint32_t first(std::uint32_t look) const { return first_[look]; }

  private:
    CountedVector<std::uint32_t> of_, first_;
};

/// Whether the light of a surface with this texture is linear in its color, and depends on nothing else of
/// it.
bool is_linear_in_color(const Texture& texture);

/// The texture of surfaces whose colors are given separately.
Texture without_color(const Texture& texture);

/// What mesh_parts() may hold beside the mesh.
std::uint64_t bytes_of_parts(const ReadMesh& mesh);

MeshParts mesh_parts(const ReadMesh& mesh);

}  // namespace glint::povray
