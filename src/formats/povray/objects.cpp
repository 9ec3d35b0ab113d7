// SPDX-License-Identifier: Apache-2.0
// Objects: shapes, groups and their modifiers.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/povray/reader.h"
#include "formats/povray_keywords.h"

namespace glint::povray {

// Whether an object begins here: one that is rendered, or another of POV-Ray's.
bool Reader::begins_object(const Token& token) {
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
    if (const Value* value = find_value(token.name)) {
        if (const auto* array = std::get_if<std::shared_ptr<Array>>(value)) {
            return !(*array)->elements.empty() &&
                   std::holds_alternative<std::shared_ptr<const Object>>((*array)->elements.front());
        }
        return std::holds_alternative<std::shared_ptr<const Object>>(*value);
    }
    const std::string_view name = names_.name(token.name);
    return povray_meaning(name) == "a shape" || name == "light_group";
}

// Whether an object begins here that may be a declared one: its name, or `object`.
bool Reader::begins_declared(const Token& word) {
    if (word.kind != TokenKind::word) return false;
    if (Names::is_reserved(word.name)) return word.word() == Word::k_object;
    return find_value(word.name) != nullptr;
}

Object Reader::read_object() {
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
            return refuse_object(word);
        case Word::k_union:
        case Word::k_merge:
            return read_group(word);
        case Word::k_mesh:
            return read_mesh(word);
        case Word::k_mesh2:
            return read_mesh2(word);
        case Word::k_polygon:
            return read_polygon(word);
        case Word::k_light_source:
            return read_light(word);
        default:
            return read_shape(word);
    }
}

// An object of a group. One that is declared is shared unless modifiers follow. Null after an error.
ObjectPart Reader::read_part() {
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
    if (failed_ || accept('}')) return part;
    auto changed = make_counted<Object>(*part);
    read_modifiers(*changed);
    return changed;
}

// NAME modifiers }, after the word of its kind: `sphere { Ball translate x }`.
Object Reader::read_copy() {
    const ObjectPart part = read_part();
    if (!part) return {};
    Object copy = *part;
    read_modifiers(copy);
    return copy;
}

// The object that an identifier or an element of an array stands for. Null after an error.
ObjectPart Reader::object_of(const Token& name) {
    const Value* found = find_value(name.name);
    Value value = found != nullptr ? *found : Value();
    if (std::holds_alternative<std::shared_ptr<Array>>(value)) value = read_element(name, std::move(value));
    if (failed_) return nullptr;
    if (const auto* held = std::get_if<ObjectPart>(&value)) return *held;
    error(name, fmt::format("expected an object, found {}, {}", describe(name), povray::describe(value)));
    return nullptr;
}

// A shape of POV-Ray that glint does not render: an error if it becomes part of the scene.
Object Reader::refuse_object(const Token& word) {
    Object object;
    object.kind = ObjectKind::refused;
    object.at = word;
    Missing shape = missing(word, text_of(word));
    shape.is_error = true;
    object.missing.add(shape);
    skip_block();
    return object;
}

Object Reader::read_shape(const Token& word) {
    Object object;
    object.at = word;
    if (!expect('{')) return object;
    if (begins_declared(peek()) && begins_object(peek())) return read_copy();
    const auto next = [&] { return accept(','); };
    switch (word.word()) {
        case Word::k_sphere:
            object.kind = ObjectKind::sphere;
            object.a = vector();
            next();
            object.r = number();
            break;
        case Word::k_cylinder:
        case Word::k_cone:
            object.kind = word.word() == Word::k_cone ? ObjectKind::cone : ObjectKind::cylinder;
            object.a = vector();
            next();
            if (word.word() == Word::k_cone) {
                object.r = number();
                next();
            }
            object.b = vector();
            next();
            (word.word() == Word::k_cone ? object.s : object.r) = number();
            object.is_open = accept(Word::k_open);
            break;
        case Word::k_box:
            object.kind = ObjectKind::box;
            object.a = vector();
            next();
            object.b = vector();
            break;
        case Word::k_plane:
            object.kind = ObjectKind::plane;
            object.b = vector();
            next();
            object.s = number();
            break;
        case Word::k_disc:
            object.kind = ObjectKind::disc;
            object.a = vector();
            next();
            object.b = vector();
            next();
            object.r = number();
            if (next()) object.s = number();
            break;
        case Word::k_triangle:
            object.kind = ObjectKind::triangle;
            object.a = vector();
            next();
            object.b = vector();
            next();
            object.c = vector();
            break;
        default: {
            object.kind = ObjectKind::smooth_triangle;
            std::array<Vec3, 3> normals;
            object.a = vector();
            next();
            normals[0] = vector();
            next();
            object.b = vector();
            next();
            normals[1] = vector();
            next();
            object.c = vector();
            next();
            normals[2] = vector();
            object.normals = make_counted<const std::array<Vec3, 3>>(normals);
        }
    }
    check_shape(object);
    read_modifiers(object);
    return object;
}

// What POV-Ray refuses, and what glint has no shape for.
void Reader::check_shape(Object& object) {
    if (failed_) return;
    const bool has_axis = object.kind == ObjectKind::cylinder || object.kind == ObjectKind::cone;
    if (has_axis && object.a == object.b) {
        error(object.at, fmt::format("expected two ends at different points of a {}", text_of(object.at)));
    }
    if (object.kind == ObjectKind::plane || object.kind == ObjectKind::disc) {
        if (object.b == Vec3{0, 0, 0}) error(object.at, "expected a normal other than 0");
    }
    if (object.kind == ObjectKind::disc && object.s > 0) {
        object.missing.add({"disc", "with a hole", call_place(object.at), true});
    }
    if (object.r < 0) object.r = -object.r;
    if (object.s < 0 && object.kind == ObjectKind::cone) object.s = -object.s;
}

// union and merge: objects and modifiers.
Object Reader::read_group(const Token& word) {
    Object group;
    group.at = word;
    if (!expect('{')) return group;
    group.kind = ObjectKind::group;
    group.is_merge = word.word() == Word::k_merge;
    group.count = 0;
    auto parts = make_counted<CountedVector<ObjectPart>>();
    while (!failed_ && begins_object(peek())) {
        ObjectPart part = read_part();
        if (failed_) return group;
        group.count += part->count;
        allow_steps(part->count);
        group.depth = std::max(group.depth, part->depth + 1);
        if (group.count > max_shapes()) {
            error(word, fmt::format("more than {} shapes", max_shapes()));
        } else if (group.depth > k_max_depth) {
            error(word, fmt::format("groups are nested more than {} deep", k_max_depth));
        }
        parts->push_back(std::move(part));
        accept(',');
    }
    if (!failed_ && parts->empty()) expected("an object or the name of one");
    if (failed_) return group;
    parts->shrink_to_fit();
    group.parts = std::move(parts);
    read_modifiers(group);
    return group;
}

}  // namespace glint::povray
