// SPDX-License-Identifier: Apache-2.0
#pragma once
// The keys of a mesh's block in .glint.
#include <optional>

#include "formats/glint_text.h"
#include "glint/mesh.h"

namespace glint {

class MeshText {
  public:
    explicit MeshText(GlintText& t) : t_(t) {}

    /// Reads the value of key number `field`: file, vertices, triangles, normals, normal_corners, colors,
    /// color_corners, texture_coordinates, texture_corners. False if there is none.
    bool read_key(int field, const Token& key);
    /// The index in Scene::meshes, once all keys are read. Nothing after an error, reported at the block's
    /// word if it is of the block.
    std::optional<std::uint32_t> mesh_index(const Token& word);

  private:
    bool read_points(std::vector<Vec3>& points);
    bool read_values(std::vector<Float3>& values);
    bool read_pairs(std::vector<Float3>& values);
    bool read_corners(std::vector<TriangleCorners>& corners, bool may_be_none);

    GlintText& t_;
    std::optional<Token> file_;
    bool has_lists_ = false;
    MeshData mesh_;
};

}  // namespace glint
