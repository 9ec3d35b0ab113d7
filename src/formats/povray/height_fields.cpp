// SPDX-License-Identifier: Apache-2.0
// height_field: the heights of a picture over the square from 0 to 1 in x and z.
#include "formats/povray/field_mesh.h"
#include "formats/povray/height_words.h"
#include "formats/povray/object_parser.h"
#include "formats/texture_file.h"
#include "image/palette_numbers.h"

namespace glint::povray {

// type "name" items; false after an error, or if it is refused.
bool ObjectParser::read_field_items(Object& object, FieldItems& items) {
    const auto refuse = [&](std::string_view why) {
        object.kind = ObjectKind::refused;
        object.missing.add({"height_field", why, call_place(object.at), true});
        skip_rest();
        expect('}');
        return false;
    };
    if (peek().word() == Word::k_function) return refuse("of a function");
    if (peek().kind == TokenKind::word && !begins_string(peek())) take();  // the file itself says its type
    items.name_at = peek();
    items.name = std::string(*string());
    while (!failed() && peek().kind == TokenKind::word) {
        const std::string_view name = text_of(peek());
        if (name == "gamma") return refuse("with a gamma");
        if (name == "water_level") {
            take();
            items.water_level = number();
        } else if (name == "smooth") {
            take();
            items.is_smooth = true;
        } else if (name == "premultiplied" || name == "hierarchy") {
            take();
            flag();
        } else {
            break;
        }
    }
    return !failed();
}

// { type "name" items modifiers }
Object ObjectParser::read_height_field(const Token& word) {
    Object object;
    object.kind = ObjectKind::height_field;
    object.at = word;
    object.stands_for = "height_field";
    if (!expect('{')) return object;
    if (begins_declared(peek()) && begins_object(peek())) return read_copy();
    FieldItems items;
    if (!read_field_items(object, items)) return object;
    LoadState& state = reading();
    const Token at = call_place(items.name_at);
    glint::Token place;
    place.offset = at.offset, place.length = text_of(at).size();
    std::string file;
    auto image = texture_image_of_file(state, {state.texts[at.text], at.text, true}, place, items.name, file,
                                       "the height_field has no heights");
    std::string_view bytes;
    for (std::size_t i = 0; i < state.scene.files.size(); ++i)
        if (state.scene.files[i] == file) bytes = state.texts[i].text;
    if (const std::string numbers = png_of_palette_numbers(bytes); image && !numbers.empty()) {
        std::string why;
        image = decode_texture_image(state, numbers, why);
        if (image) state.memory.remove(std::get<0>(image->words).size());  // which is not kept
    }
    if (!image) {
        object.missing.add({"height_field", "without its picture", call_place(word), true});
        read_modifiers(object);
        return object;
    }
    auto field = make_counted<HeightField>();
    field->width = image->width;
    field->depth = image->height;
    field->water = items.water_level * 65536;
    field->is_smooth = items.is_smooth;
    const std::uint64_t count = std::uint64_t{image->width} * image->height;
    if (image->width < 2 || image->height < 2) {
        error(items.name_at, "expected a picture of at least 2 x 2 texels");
        return object;
    }
    if (!has_room(count * sizeof(std::uint16_t), items.name_at)) return object;
    if (!spend(count / 16)) return object;
    if (!read_heights(*image, bytes, field->heights))
        object.missing.add({"height_field", "of a picture of this kind", call_place(word), true});
    object.field = std::move(field);
    read_modifiers(object);
    return object;
}

}  // namespace glint::povray
