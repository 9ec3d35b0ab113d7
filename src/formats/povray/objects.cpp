// SPDX-License-Identifier: Apache-2.0
// Objects: which one begins, groups, and those that are declared.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/object_parser.h"
#include "formats/povray_keywords.h"

namespace glint::povray {

Value ObjectParser::other_value(const Token& first) {
    switch (first.word()) {
        case Word::k_texture: {
            // Several textures are the layers of one.
            std::shared_ptr<const Texture> texture;
            while (!failed() && accept(Word::k_texture)) texture = layered(texture, read_texture());
            return texture;
        }
        case Word::k_pigment: {
            take();
            Pigment pigment = default_texture().pigment;
            read_pigment(pigment);
            return make_counted<const Pigment>(std::move(pigment));
        }
        case Word::k_finish: {
            take();
            Finish finish = default_texture().finish;
            read_finish(finish);
            return make_counted<const Finish>(std::move(finish));
        }
        case Word::k_material:
            take();
            return make_counted<const MaterialValue>(read_material());
        case Word::k_camera:
            take();
            return make_counted<const CameraItems>(read_camera(first));
        case Word::k_transform:
            take();
            return make_counted<const Affine>(read_transform_block());
        default:
            break;
    }
    if (begins_object(first)) return read_part();
    const bool is_named = !Names::is_reserved(first.name) && !povray_meaning(name_of(first.name)).empty() &&
                          has_raw() && raw().is('{');  // media, a map, ...
    if (!is_named && !is_opaque(first.word())) return {};
    const Token word = take();
    return read_opaque(is_named ? Word::k_none : word.word(), word);
}

// Whether an object begins here: one that is rendered, or another of POV-Ray's.
bool ObjectParser::begins_object(const Token& token) {
    if (token.kind != TokenKind::word) return false;
    switch (token.word()) {
#define GLINT_POV_WORD(word) case Word::k_##word:
        GLINT_POV_OBJECT_WORDS(GLINT_POV_WORD)
#undef GLINT_POV_WORD
        return true;
        default:
            break;
    }
    if (Names::is_reserved(token.name)) return false;
    if (const Value* value = find_value(token)) {
        if (const auto* array = std::get_if<std::shared_ptr<Array>>(value)) {
            return !(*array)->elements.empty() &&
                   std::holds_alternative<std::shared_ptr<const Object>>((*array)->elements.front());
        }
        return std::holds_alternative<std::shared_ptr<const Object>>(*value);
    }
    const std::string_view name = name_of(token.name);
    return povray_meaning(name) == "a shape" || name == "light_group";
}

// Whether an object begins here that may be a declared one: its name, or `object`.
bool ObjectParser::begins_declared(const Token& word) {
    return word.word() == Word::k_object || find_value(word) != nullptr;
}

Object ObjectParser::read_object() {
    const Token word = peek();
    if (begins_declared(word)) {
        const ObjectPart part = read_part();
        return part ? *part : Object();
    }
    const Deeper deeper(*this);
    if (!deeper.ok) return {};
    take();
    if (!Names::is_reserved(word.name)) return refuse_object(word);
    switch (word.word()) {
        case Word::k_difference:
        case Word::k_intersection:
        case Word::k_union:
        case Word::k_merge:
            return read_group(word);
        case Word::k_mesh:
            return read_mesh(word);
        case Word::k_mesh2:
            return read_mesh2(word);
        case Word::k_polygon:
            return read_polygon(word);
        case Word::k_prism:
            return read_prism(word);
        case Word::k_lathe:
            return read_lathe(word);
        case Word::k_sphere_sweep:
            return read_sphere_sweep(word);
        case Word::k_height_field:
            return read_height_field(word);
        case Word::k_light_source:
            return read_light(word);
        default:
            return read_shape(word);
    }
}

// An object of a group. One that is declared is shared unless modifiers follow. Null after an error.
ObjectPart ObjectParser::read_part() {
    const Token word = peek();
    if (!begins_declared(word)) return make_counted<const Object>(read_object());
    const Deeper deeper(*this);
    if (!deeper.ok) return nullptr;
    take();
    if (word.word() != Word::k_object) return object_of(word);
    // The object itself with further modifiers.
    if (!expect('{')) return nullptr;
    if (!begins_object(peek())) {
        expected("an object");
        return nullptr;
    }
    ObjectPart part = read_part();
    accept(',');
    if (failed() || accept('}')) return part;
    auto changed = make_counted<Object>(*part);
    read_modifiers(*changed);
    return changed;
}

// NAME modifiers }, after the word of its kind: `sphere { Ball translate x }`.
Object ObjectParser::read_copy() {
    const ObjectPart part = read_part();
    if (!part) return {};
    Object copy = *part;
    read_modifiers(copy);
    return copy;
}

// The object that an identifier or an element of an array stands for. Null after an error.
ObjectPart ObjectParser::object_of(const Token& name) {
    const Value* found = find_value(name);
    Value value = found != nullptr ? *found : Value();
    if (std::holds_alternative<std::shared_ptr<Array>>(value)) value = read_element(name, std::move(value));
    if (failed()) return nullptr;
    if (const auto* held = std::get_if<ObjectPart>(&value)) return *held;
    error(name, fmt::format("expected an object, found {}, {}", describe(name), povray::describe(value)));
    return nullptr;
}

// A shape of POV-Ray that glint does not render: an error if it becomes part of the scene.
Object ObjectParser::refuse_object(const Token& word) {
#if defined(GLINT_WITH_FREETYPE)
    if (text_of(word) == "text") return read_text(word);
#endif
    Object object;
    object.kind = ObjectKind::refused;
    object.at = word;
    Missing shape = missing(word, text_of(word));
    shape.is_error = true;
#if !defined(GLINT_WITH_FREETYPE)
    if (shape.name == "text") shape.meaning = "this build of glint reads no fonts";
#endif
    object.missing.add(shape);
    skip_block();
    return object;
}

// union, merge, intersection, difference: objects and modifiers.
Object ObjectParser::read_group(const Token& word) {
    Object group;
    group.at = word;
    if (!expect('{')) return group;
    const bool is_difference = word.word() == Word::k_difference;
    if (is_difference || word.word() == Word::k_intersection) {
        group.kind = ObjectKind::solid;
        group.operation = is_difference ? SolidOperation::difference : SolidOperation::intersection;
    }
    group.is_merge = word.word() == Word::k_merge;
    group.count = 0;
    auto parts = make_counted<CountedVector<ObjectPart>>();
    while (!failed() && begins_object(peek())) {
        ObjectPart part = read_part();
        if (failed()) return group;
        group.count += part->count;
        allow_steps(part->mesh.use_count() == 1 ? part->mesh->triangles.size() : part->count);
        group.depth = std::max(group.depth, part->depth + 1);
        if (group.count > max_shapes()) {
            error(word, fmt::format("more than {} shapes", max_shapes()));
        } else if (group.depth > k_max_depth) {
            error(word, fmt::format("groups are nested more than {} deep", k_max_depth));
        }
        parts->push_back(std::move(part));
        accept(',');
    }
    if (!failed() && parts->empty()) expected("an object or the name of one");
    if (failed()) return group;
    parts->shrink_to_fit();
    group.parts = std::move(parts);
    if (group.kind == ObjectKind::solid) check_operands(group);
    read_modifiers(group);
    return group;
}

}  // namespace glint::povray
