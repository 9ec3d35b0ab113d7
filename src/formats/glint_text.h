// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shared by the parts of the .glint reader: the text being read, and the types of its values.
#include "base/text.h"
#include "formats/block_reader.h"
#include "formats/load_state.h"
#include "scene/fields.h"

namespace glint {

class GlintMaterials;
class GlintTextures;

struct GlintText {
    GlintText(LoadState& of, const ReadText& read_text);

    LoadState& reading;
    Scene& scene;
    const ReadText& text;
    GlintMaterials& materials;
    GlintTextures& textures;
    Parser p;
    BlockReader blocks;
};

/// (r, g, b), rgb255(r, g, b), "#rrggbb" or "#rgb".
bool read_color(GlintText& t, Color& color, const Range& range, ColorUse use);

/// (x, y, z).
inline bool read_point(GlintText& t, Vec3& point) { return t.p.point(point, k_coordinate, '(', ')'); }

/// (x, y, z) other than (0, 0, 0).
bool read_direction(GlintText& t, Vec3& direction);

/// A whole number within a range of whole numbers.
bool read_whole(GlintText& t, std::int32_t& value, const Range& range);

/// true or false.
bool read_bool(GlintText& t, bool& value);

/// Reads a value by its type. False if there is no such value.
struct ValueReader {
    GlintText& t;
    bool operator()(const NumberType& type, double& value) const { return t.p.number(value, type.range); }
    bool operator()(const WholeType& type, std::int32_t& value) const {
        return read_whole(t, value, type.range);
    }
    template <class Choice> bool operator()(const ChoiceType& type, Choice& value) const {
        int index = 0;
        if (!t.p.choice(type.words, one_of(type.words), index)) return false;
        value = static_cast<Choice>(index);
        return true;
    }
    bool operator()(TextureType, std::uint32_t& texture) const;
    bool operator()(UvMapType, UvMap& map) const;
    bool operator()(BoolType, bool& value) const { return read_bool(t, value); }
    bool operator()(PointType, Vec3& point) const { return read_point(t, point); }
    bool operator()(PointType, std::optional<Vec3>& point) const { return read_point(t, point.emplace()); }
    bool operator()(DirectionType, Vec3& direction) const { return read_direction(t, direction); }
    bool operator()(const ColorType& type, Color& color) const {
        return read_color(t, color, type.range, type.use);
    }
    bool operator()(AttenuationType, Attenuation& attenuation) const;
};

/// Reads the value of a field. False if there is no such value.
template <class Item> bool read_field(GlintText& t, const ItemField<Item>& field, Item& item) {
    return visit_field(field, item, ValueReader{t});
}

/// A nonempty name, bare or quoted. If there is none, reports an error and returns false.
bool read_name(GlintText& t, std::string_view what, Token& name);

/// The text of a setting's value, for set_setting(): `640 x 480`, `blinn-phong`.
bool read_setting_text(GlintText& t, std::string& value);

/// The name of the block that was just begun, or an empty string.
std::string block_name(const GlintText& t);

/// ( item, item, ... ); read_item() reads one. False if there is no list.
template <class ReadItem> bool read_list(GlintText& t, std::string_view what, ReadItem&& read_item) {
    if (!t.p.accept('(')) {
        t.p.expected(fmt::format("`(` and {}", what));
        return false;
    }
    while (!t.p.accept(')')) {
        if (!read_item()) {
            t.p.skip_to_close(')');
            return true;
        }
        t.p.accept(',');
    }
    return true;
}

void read_glint_camera(GlintText& t, const Token& word);
void read_glint_light(GlintText& t, const Token& word);
void read_glint_fog(GlintText& t, const Token& word);
void read_glint_occlusion(GlintText& t, const Token& word);
void read_glint_gradient(GlintText& t, const Token& word);

}  // namespace glint
