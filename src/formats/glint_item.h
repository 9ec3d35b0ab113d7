#pragma once
// What every shape and group of glint's own language may say: its material and its transforms.
#include <optional>

#include "formats/glint_material.h"
#include "glint/vec.h"

namespace glint {

/// The keys that shapes and groups have in common. The transforms are applied in the order written.
inline constexpr Field k_item_fields[] = {{"material"},
                                          {"color"},
                                          {"shininess"},
                                          {"mirror"},
                                          {"ambient"},
                                          {"diffuse"},
                                          {"specular"},
                                          {"ambient_color"},
                                          {"diffuse_color"},
                                          {"specular_color"},
                                          {"mirror_color"},
                                          {"transmission"},
                                          {"transmission_color"},
                                          {"ior"},
                                          {"translate", false, true},
                                          {"rotate", false, true},
                                          {"scale", false, true},
                                          {"matrix", false, true}};

struct GlintItem {
    std::uint32_t material = k_none;  ///< the one that is named
    MaterialKeys keys;                ///< what is said of it in place
    std::optional<Affine> map;        ///< the item's own coordinates to those around it
};

/// Reads the value of one of those keys.
bool read_item_key(GlintText& t, int field, const Token& key, GlintItem& item);

/// Of two, one that is the identity gives way to the other.
std::optional<Affine> compose_maps(const std::optional<Affine>& outer, const std::optional<Affine>& inner);

/// What a shape takes over from the groups around it.
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
