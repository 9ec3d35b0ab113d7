// SPDX-License-Identifier: Apache-2.0
#pragma once
// What an .obj contains, as its lines number it, and its meshes.
#include <cstdint>
#include <memory>
#include <string>

#include "formats/load_state.h"
#include "glint/mesh.h"

namespace glint {

/// The triangles of one material.
struct ObjPart {
    std::string material;                       ///< empty: none
    std::size_t usemtl = 0, usemtl_length = 1;  ///< the place of the material's name
    SourcePlace place;                          ///< of the first face
    std::string name;  ///< the object's that all faces are of; empty: none, or several
    CountedVector<TriangleCorners> triangles;
    /// By triangle: numbers of normals. If the first is k_none, the triangle has none, and the second is its
    /// smoothing group, or 0. Shorter than `triangles`, or empty: the others have neither.
    CountedVector<TriangleCorners> normals;
    /// By triangle: numbers of texture coordinates, k_none three times for a triangle without. Shorter than
    /// `triangles`, or empty: the others have none.
    CountedVector<TriangleCorners> textures;
};

struct ObjData {
    CountedVector<Vec3> positions;
    bool is_single = true;                ///< no position needs more than single precision
    CountedVector<Float3> vertex_colors;  ///< by vertex; a shorter list: the others have none
    CountedVector<Float3> normals;
    CountedVector<Float3> texture_coordinates;  ///< u, v, 0
    CountedVector<ObjPart> parts;

    static constexpr Float3 k_no_color{-1, -1, -1};
    bool has_color(std::uint32_t vertex) const {
        return vertex < vertex_colors.size() && vertex_colors[vertex] != k_no_color;
    }
};

/// Gives the triangles that have a smoothing group normals: at each vertex the sum of (b - a) × (c - a) of
/// the group's triangles there, so that each counts by its area. False after an error.
bool smooth_groups(ObjData& data, LoadState& reading, InputText where);

/// Makes the parts' meshes, each with the vertices and normals that it uses.
class ObjMeshes {
  public:
    ObjMeshes(ObjData& data, LoadState& reading, InputText where)
        : data_(data), reading_(reading), where_(where) {}
    /// Frees the part's lists. Null after an error. What is made counts in the budget once it is in the
    /// scene.
    std::shared_ptr<const MeshData> make(ObjPart& part);

  private:
    /// The numbers in the mesh of what it uses, in the order of their first use.
    struct Used {
        CountedVector<std::uint32_t> numbers;  ///< by the file's; k_none: not used
        CountedVector<std::uint32_t> order;    ///< the file's
        std::uint32_t number_of(std::uint32_t in_file);
        void clear();
    };
    void add_values(const CountedVector<TriangleCorners>& part, const CountedVector<Float3>& all, Used& used,
                    const MeshData& mesh, CornerValues& values);
    void add_colors(const ObjPart& part, MeshData& mesh);
    bool has_room(const ObjPart& part);

    ObjData& data_;
    LoadState& reading_;
    InputText where_;
    Used vertices_, normals_, textures_;
};

}  // namespace glint
