// SPDX-License-Identifier: Apache-2.0
#pragma once
// The nodes of a scene of glTF: where meshes, cameras and lights are.
#include <optional>

#include "formats/gltf/accessors.h"

namespace glint::gltf {

struct PlacedNode {
    std::uint32_t node = 0;
    Affine world_from_node;
};

/// The nodes of the scene that the options choose, a node before its children, and where each one is. Nothing
/// after an error.
class Nodes {
  public:
    explicit Nodes(File& file) : file_(file) {}

    bool place();
    const CountedVector<PlacedNode>& placed() const { return placed_; }
    /// Where a node of the scene is; null if it is not in the scene.
    const Affine* world_from(std::uint32_t node) const {
        return numbers_[node] == k_none ? nullptr : &placed_[numbers_[node]].world_from_node;
    }

  private:
    bool choose_scene(CountedVector<std::uint32_t>& roots);
    bool choose_by_name(std::optional<std::uint32_t>& scene);
    bool add_children(JsonValue list, CountedVector<std::uint32_t>& to);
    bool local(JsonValue node, Affine& to);
    bool place_below(CountedVector<std::uint32_t>& roots);

    File& file_;
    CountedVector<PlacedNode> placed_;
    CountedVector<std::uint32_t> numbers_;  // by node: its number in placed_, or k_none
};

/// Translation, rotation by a quaternion (x, y, z, w) and scale, in this order from the left.
Affine trs(const std::array<double, 3>& translation, const std::array<double, 4>& rotation,
           const std::array<double, 3>& scale);

}  // namespace glint::gltf
