// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the nodes contain: shapes, cameras and lights.
#include "formats/gltf/meshes.h"
#include "formats/gltf/nodes.h"

namespace glint::gltf {

class Contents {
  public:
    Contents(File& file, Accessors& accessors, Meshes& meshes, const Nodes& nodes)
        : file_(file), accessors_(accessors), meshes_(meshes), nodes_(nodes) {}

    /// Adds those of all nodes to the scene.
    void add();

  private:
    void add_mesh(JsonValue node, const Affine& world_from_node);
    void add_instances(JsonValue node, JsonValue attributes, std::span<const MeshPart> parts,
                       const Affine& world_from_node);
    void add_shapes(JsonValue node, std::span<const MeshPart> parts, const Affine& world_from_mesh,
                    const std::string& name);
    bool skinned(JsonValue node, Affine& world_from_mesh);
    bool read_skin(JsonValue skin, std::optional<Affine>& world_from_mesh);

    File& file_;
    Accessors& accessors_;
    Meshes& meshes_;
    const Nodes& nodes_;
    CountedMap<std::uint32_t, std::optional<Affine>> skins_;  // the places of meshes that have them
    std::uint64_t shapes_ = 0;
    Extent box_;  // of the boxes of all shapes
};

/// Sets the scene's camera to camera `index`. The first of a file counts.
void set_camera(File& file, JsonValue index, const Affine& world_from_node);
/// Adds a light of KHR_lights_punctual.
void add_light(File& file, JsonValue index, const Affine& world_from_node);
/// Makes all lights from number `first` on weaker by one factor, with a warning, if they are so strong for a
/// scene of this extent that its picture would be white.
void limit_exposure(File& file, std::size_t first, const Extent& box);

}  // namespace glint::gltf
