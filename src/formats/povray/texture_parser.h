// SPDX-License-Identifier: Apache-2.0
#pragma once
// Textures, materials and transforms, and blocks that are read over. In textures.cpp, finishes.cpp,
// patterns.cpp, pattern_maps.cpp, averages.cpp, sky.cpp, image_maps.cpp, blocks.cpp and transforms.cpp.
#include <memory>
#include <optional>
#include <string_view>

#include "formats/povray/image_gamma.h"
#include "formats/povray/object.h"
#include "formats/povray/value_parser.h"

namespace glint::povray {

/// What an `image_map` has.
struct ImageItems {
    Token name_at;
    std::string name;
    int map_type = 0, interpolate = 0;
    bool is_once = false;
    double filter = 0, transmit = 0;
    std::optional<ImageCurve> curve;  ///< `gamma`
    std::optional<Missing> missing;
};

/// What a block has after a pattern's word.
struct PatternItems {
    CountedVector<ColorMapEntry> map;
    double frequency = 1, phase = 0;
    std::optional<bool> is_triangle;  ///< else a ramp
    Vec3 brick_size{8, 3, 4.5};
    double mortar = 0.5;
    Vec3 turbulence;
    double octaves = 6, omega = 0.5, lambda = 2;
    bool is_known = true;  ///< nothing that the engine does not draw

    bool changes_u() const { return frequency != 1 || phase != 0 || is_triangle || !(turbulence == Vec3{}); }
};

struct PatternRow;
/// A pattern of a pigment, which one that has its name can change.
struct PatternSource {
    const PatternRow* row = nullptr;
    Token at;
    glint::Texture texture;  ///< its mapping, and the colors of `checker` and the like
    Vec3 axis{1, 0, 0};      ///< of `gradient`
    double number = 0;       ///< after the word: of `spiral1` the arms, of `mandel` the steps; whole
    bool has_filter = false;
    PatternItems items{};
};

/// The colors of a pattern of pigments or of whole textures.
struct PatternParts {
    bool are_textures = false;
    std::optional<Texture> first{};  ///< of textures: its finish is that of all
    MissingList missing{};           ///< of the textures
    bool have_one_finish = true;
    bool are_plain = true;  ///< pigments of one color, and of at most one pattern
    /// The one with a pattern, which is seen where the others let it.
    std::shared_ptr<const Pigment> under{};
    bool are_opaque = true;  ///< those of one color
};

/// An entry of the map of `average`.
struct WeightedPigment {
    double weight = 1;
    Pigment pigment;
};

class TextureParser : public ValueParser {
  protected:
    using ValueParser::ValueParser;

    // Each is called after the word: `texture`, `pigment` ...

    Texture read_texture();
    void read_pigment(Pigment& pigment);
    void read_finish(Finish& finish);
    MaterialValue read_material(std::shared_ptr<const Opaque> before = nullptr);
    std::shared_ptr<const Texture> layered(const std::shared_ptr<const Texture>& below, Texture top);
    void transform_image(Pigment& pigment, const std::optional<Affine>& step);
    void transform_below(Texture& texture, const std::optional<Affine>& step);
    void add_layer(Object& object, Texture top);
    Texture& own_texture(Object& object);
    /// What #default changes.
    Texture& default_texture() { return default_texture_; }

    /// also: a second map that the transform is added to; found: the transform by itself.
    bool read_transform_item(std::optional<Affine>& map, std::optional<Affine>* also = nullptr,
                             Affine* found = nullptr);
    Affine read_transform_block();

    static bool is_opaque(Word word);
    SkyItems read_sky_items();
    /// The block of this word that a name stands for; nullptr: none.
    const Opaque* named_block(const Token& name, Word word);
    std::shared_ptr<const Opaque> read_opaque(Word word, const Token& at);
    Opaque read_interior(const Token& at, const Opaque* before = nullptr);
    void skip_block();
    /// To the `}` or `]` that ends what is being read.
    void skip_rest();
    /// To its `}`; a `]` is an error.
    void skip_rest_of_block();
    Missing missing(const Token& at, std::string_view name);

  private:
    void read_pigment_items(Pigment& pigment, char end);
    void read_texture_items(Texture& texture, char end);
    void read_texture_pattern(Texture& texture, const Token& item);
    void read_image_map(Pigment& pigment, const Token& at);
    void read_image_item(const Token& at, ImageItems& items);
    std::shared_ptr<const TextureImage> open_image(const ImageItems& items, glint::Texture& texture);
    bool accept_albedo();
    void read_reflection(Finish& finish);
    void read_pattern(Pigment& pigment, const Token& item, std::optional<Affine>& map, PatternParts& parts);
    static const PatternRow* find_pattern(std::string_view word);
    static CountedVector<ColorMapEntry> map_without_own(const Pigment& before, const PatternRow* row);
    static CountedVector<ColorMapEntry> default_map(std::string_view word);
    void read_average(Pigment& pigment, std::optional<Affine>& map);
    void average(Pigment& pigment, const CountedVector<WeightedPigment>& parts);
    void change_pattern(Pigment& pigment, std::optional<Affine>& map);
    void draw_pattern(Pigment& pigment, PatternSource source, bool are_plain);
    bool read_block_colors(glint::Texture& texture, PatternParts& parts);
    std::optional<std::array<double, 5>> read_block_color(PatternParts& parts);
    void read_pattern_items(PatternItems& items, std::optional<Affine>& map, PatternParts& parts);
    static bool use_from_0_to_1(CountedVector<ColorMapEntry>& map);
    bool read_part_map(CountedVector<ColorMapEntry>& map, PatternParts& parts);
    static void use_colors_beside(CountedVector<ColorMapEntry>& map);
    void put_under(Pigment& pigment, const PatternParts& parts);
    std::array<double, 5> color_of(const Pigment& pigment, PatternParts& parts);
    std::array<double, 5> color_of(const Texture& texture, PatternParts& parts);
    bool read_color_map(CountedVector<ColorMapEntry>& map);
    Affine read_matrix();

    Texture default_texture_;
    double images_ = 0;  // the last Pigment::image_number
    CountedVector<GradedImage> graded_;
};

}  // namespace glint::povray
