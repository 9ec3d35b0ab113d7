// SPDX-License-Identifier: Apache-2.0
#include "formats/write_textures.h"

#include <fmt/format.h>

#include <iterator>

#include "scene/texture_fields.h"

namespace glint {
namespace {

void write_texels(BlockWriter& block, const TextureImage& image) {
    std::string& text = block.key("texels");
    text += '(';
    std::visit(
        [&](const auto& words) {
            const int digits = 2 * static_cast<int>(sizeof(words[0]));
            auto word = words.begin();
            for (std::uint32_t row = 0; row < image.height; ++row) {
                if (row > 0) text += ", ";
                block.allow_break();
                text += '"';
                for (std::uint32_t column = 0; column < image.width; ++column) {
                    if (column > 0) text += ' ';
                    for (std::uint32_t c = 0; c < image.channels(); ++c)
                        fmt::format_to(std::back_inserter(text), "{:0{}x}", *word++, digits);
                }
                text += '"';
            }
        },
        image.words);
    text += ')';
}

}  // namespace

void write_color_map(BlockWriter& block, const std::vector<TextureColor>& colors) {
    if (colors.empty()) return;
    std::string& text = block.key("color_map");
    text += '(';
    for (const TextureColor& color : colors) {
        if (&color != &colors.front()) text += ", ";
        block.allow_break();
        fmt::format_to(std::back_inserter(text), "({}, ", color.at);
        append(text, color.color);
        if (color.alpha < 1) fmt::format_to(std::back_inserter(text), ", {}", color.alpha);
        text += ')';
    }
    text += ')';
}

void write_textures(BlockWriter& block, const Scene& scene, const MaterialPlan& plan,
                    const SceneComments& comments) {
    for (std::uint32_t i = 0; i < scene.textures.size(); ++i) {
        const Texture& texture = scene.textures[i];
        std::string head = "texture ";
        append_name(head, plan.texture_name(i));
        block.begin(head);
        if (!texture.image) {
            write_color_map(block, texture.color_map);
        } else if (texture.file.empty()) {
            write_texels(block, *texture.image);
        } else {
            append_quoted(block.key("file"), texture.file);
        }
        for (const ItemField<Texture>& field : k_texture_fields) {
            if (is_field_of(field, &Texture::over) || same_bits(field, texture, Texture{})) continue;
            write_field(block, field, texture);
        }
        if (texture.over != k_none) append_name(block.key("over"), plan.texture_name(texture.over));
        if (!(texture.world_from_texture == Affine{})) write_map(block, texture.world_from_texture);
        comments.end_block(block, ItemKind::texture, i);
    }
}

}  // namespace glint
