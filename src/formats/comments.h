// SPDX-License-Identifier: Apache-2.0
#pragma once
// The comments of the texts that a scene was read from, and the items that they belong to.
#include <cstdint>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "formats/block_writer.h"
#include "glint/load.h"

namespace glint {

enum class ItemKind : std::uint8_t {
    shape,
    light,
    camera,
    background,
    material,
    fog,
    gradient,
    occlusion,
    texture
};

/// Views of the texts, one per line, without the comment signs.
struct ItemComments {
    std::vector<std::string_view> above;  ///< on lines of their own, before the item or inside it
    std::vector<std::string_view> after;  ///< after the item or one of its parts, on the same line
};

/// Assigns comments to items. A comment on its own line belongs to the next item; a comment inside an item's
/// brackets, or after it on its last line, belongs to that item. If a material and a shape are in one place,
/// the comments belong to the shape. Comments in other brackets are omitted.
class SceneComments {
  public:
    SceneComments(const Scene& scene, std::span<const SceneText> texts);

    /// The first comment of a text, before all items, unless it is directly above an item.
    const std::vector<std::string_view>& heading() const { return heading_; }
    /// Comments after all items.
    const std::vector<std::string_view>& tail() const { return tail_; }
    /// Null if there are none.
    const ItemComments* of(ItemKind kind, std::uint32_t index) const;
    /// Ends the item's block and writes its comments.
    void end_block(BlockWriter& block, ItemKind kind, std::uint32_t index) const;

  private:
    struct Item;
    struct Source;
    class Scanner;
    static std::vector<Source> find_sources(const Scene& scene, std::span<const SceneText> texts);
    ItemComments& make(ItemKind kind, std::uint32_t index);

    std::vector<std::string_view> heading_, tail_;
    std::unordered_map<std::uint64_t, ItemComments> items_;
};

}  // namespace glint
