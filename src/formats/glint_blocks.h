// SPDX-License-Identifier: Apache-2.0
#pragma once
// The blocks of .glint and the keys of each, from the reader's own tables, for editors.
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "formats/parser.h"
#include "glint/solid.h"

namespace glint {

struct GlintBlock {
    std::string_view word;
    std::vector<std::string_view> keys;
};

/// All blocks: the shapes' first.
std::vector<GlintBlock> glint_blocks();

/// The operation of a solid whose block has this word; nothing for other words.
std::optional<SolidOperation> solid_operation(std::string_view word);

/// The names of some keys.
std::vector<std::string_view> key_names(std::span<const Field> fields);

// The parts of glint_blocks(), each beside its reader.
void add_shape_blocks(std::vector<GlintBlock>& blocks);
std::span<const Field> glint_light_keys();
std::span<const Field> glint_camera_keys();
std::span<const Field> glint_fog_keys();
std::span<const Field> glint_occlusion_keys();
std::span<const Field> glint_gradient_keys();
std::span<const Field> glint_texture_keys();

}  // namespace glint
