// SPDX-License-Identifier: Apache-2.0
#pragma once
// Textures, materials and transforms, and blocks that are read over. In textures.cpp, finishes.cpp,
// gradients.cpp, blocks.cpp and transforms.cpp.
#include <memory>
#include <optional>
#include <string_view>

#include "formats/povray/object.h"
#include "formats/povray/value_parser.h"

namespace glint::povray {

class TextureParser : public ValueParser {
  protected:
    using ValueParser::ValueParser;

    // Each is called after the word: `texture`, `pigment` ...

    Texture read_texture();
    void read_pigment(Pigment& pigment);
    void read_finish(Finish& finish);
    MaterialValue read_material();
    std::shared_ptr<const Texture> layered(const std::shared_ptr<const Texture>& below, Texture top);
    Texture& own_texture(Object& object);
    /// What #default changes.
    Texture& default_texture() { return default_texture_; }

    bool read_transform_item(std::optional<Affine>& map);
    Affine read_transform_block();

    static bool is_opaque(Word word);
    std::shared_ptr<const Opaque> read_opaque(Word word, const Token& at);
    void skip_block();
    void skip_rest();
    Missing missing(const Token& at, std::string_view name);

  private:
    void read_texture_items(Texture& texture);
    bool accept_albedo();
    void read_reflection(Finish& finish);
    std::shared_ptr<const GradientPattern> read_gradient(std::optional<Affine> map);
    bool read_color_map(CountedVector<ColorMapEntry>& map);
    Opaque read_interior(const Token& at);
    Affine read_matrix();

    Texture default_texture_;
};

}  // namespace glint::povray
