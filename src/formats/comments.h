// SPDX-License-Identifier: Apache-2.0
#pragma once
// The comments of the texts that a scene was read from, and which of its items each stands by.
#include <cstdint>
#include <span>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "formats/block_writer.h"
#include "glint/load.h"

namespace glint {

enum class ItemKind : std::uint8_t { shape, light, camera, background, material };

/// Views of the texts, a line each, without the comment's own signs.
struct ItemComments {
    std::vector<std::string_view> above;  ///< lines by themselves, before the item or within it
    std::vector<std::string_view> after;  ///< behind the item or one of its parts
};

/// Which comments belong where. A comment by itself belongs to the item that follows; one within an item's
/// brackets, or behind it in its last line, to that item. Where a material and a shape stand in one place,
/// the shape has the comments. What is in the brackets of something else is left out.
class SceneComments {
  public:
    SceneComments(const Scene& scene, std::span<const SceneText> texts);

    /// Before all items of a text: the first comment, unless it stands right above an item.
    const std::vector<std::string_view>& heading() const { return heading_; }
    /// Behind all items.
    const std::vector<std::string_view>& tail() const { return tail_; }
    /// Null if there are none.
    const ItemComments* of(ItemKind kind, std::uint32_t index) const;
    /// Ends the item's block, with its comments.
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
