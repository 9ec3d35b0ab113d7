// SPDX-License-Identifier: Apache-2.0
#pragma once
// The keys that every shape and group of .glint may have: its material and its transforms.
#include <algorithm>
#include <array>
#include <optional>

#include "formats/glint_material.h"
#include "glint/vec.h"

namespace glint {

inline constexpr Field k_transform_fields[] = {
    {"translate", false, true}, {"rotate", false, true}, {"scale", false, true}, {"matrix", false, true}};

/// The keys that shapes and groups have in common: `material`, a material's own, and the transforms, which
/// are applied in the order written.
inline constexpr auto k_item_fields = [] {
    std::array<Field, 1 + k_material_keys.size() + std::size(k_transform_fields)> all{{{"material"}}};
    const auto next = std::copy(k_material_keys.begin(), k_material_keys.end(), all.begin() + 1);
    std::copy(std::begin(k_transform_fields), std::end(k_transform_fields), next);
    return all;
}();
// A quartic has the most keys of its own in addition, and `shape_color`.
static_assert(k_item_fields.size() + std::size(k_quartic_terms) + 1 <= k_max_keys);

struct GlintItem {
    std::uint32_t material = k_none;  ///< the named material
    MaterialKeys keys;                ///< the material's keys in the block
    std::optional<Affine> map;        ///< the item's coordinates to those of the enclosing group
};

/// Reads the value of one of those keys.
bool read_item_key(GlintText& t, int field, const Token& key, GlintItem& item);

/// The same for a key of k_transform_fields.
bool read_transform_key(GlintText& t, int field, const Token& key, GlintItem& item);

/// Composes two maps; if one is the identity, the result has the bits of the other.
std::optional<Affine> compose_maps(const std::optional<Affine>& outer, const std::optional<Affine>& inner);

/// What a shape inherits from the enclosing groups.
struct GlintContext {
    std::uint32_t material = k_none;
    std::uint32_t transform = k_none;  ///< the index of `map`, once something uses it
    std::optional<Affine> map;         ///< world_from_group
};

/// The index of the context's map.
std::uint32_t transform_index(Scene& scene, GlintContext& context);

/// True if `word` begins a shape's block.
bool is_shape_word(std::string_view word);

/// Reads the block of a shape, whose word is `word`, and adds it to the scene.
void read_glint_shape(GlintText& t, const Token& word, GlintContext& context);

}  // namespace glint
