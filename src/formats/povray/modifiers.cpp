// SPDX-License-Identifier: Apache-2.0
// The modifiers of objects.
#include "formats/povray/clip.h"
#include "formats/povray/extents.h"
#include "formats/povray/object_parser.h"
#include "formats/povray_keywords.h"

namespace glint::povray {

// Up to and including the `}`.
void ObjectParser::read_modifiers(Object& object) {
    while (!failed() && !accept('}')) {
        if (accept(',') || read_modifier(object)) continue;
        const Token item = peek();
        const std::string_view name = text_of(item);
        if (item.kind == TokenKind::word && !povray_meaning(name).empty() && !find_value(item)) {
            take();
            object.missing.add(missing(item, name));
            if (peek().is('{')) skip_block();
        } else {
            expected("a modifier of an object or `}`");
        }
    }
}

bool ObjectParser::read_modifier(Object& object) {
    const Token item = peek();
    Affine step;
    if (read_transform_item(object.map, object.texture ? &object.texture_map : nullptr, &step)) {
        object.is_moved_by_matrix |= item.word() == Word::k_matrix || item.word() == Word::k_transform;
        const bool has_steps = object.kind == ObjectKind::group || object.kind == ObjectKind::solid ||
                               object.kind == ObjectKind::mesh;
        if (has_steps) object.steps.push_back(step);
        return true;
    }
    switch (item.word()) {
        case Word::k_texture:
            take();
            add_layer(object, read_texture());
            return true;
        case Word::k_pigment:
            take();
            read_pigment(own_texture(object).pigment);
            object.texture_map.reset();
            return true;
        case Word::k_finish:
            take();
            read_finish(own_texture(object).finish);
            return true;
        case Word::k_normal:
            take();
            skip_block();
            own_texture(object).missing.add(missing(item, "normal"));
            return true;
        case Word::k_material: {
            take();
            const MaterialValue material = read_material(object.interior);
            if (material.texture) {
                add_layer(object, *material.texture);
            }
            object.interior = material.interior;
            for (const Missing& of : material.missing) object.missing.add(of);
            return true;
        }
        case Word::k_interior:
            take();
            object.interior = make_counted<const Opaque>(read_interior(item, object.interior.get()));
            return true;
        case Word::k_uv_mapping:
            take();
            object.is_uv = flag();
            return true;
        case Word::k_no_shadow:
            take();
            object.is_no_shadow = flag();
            return true;
        case Word::k_open:
            take();
            object.is_open = true;
            return true;
        case Word::k_cutaway_textures:
            take();
            object.is_cutaway = true;
            return true;
        case Word::k_clipped_by:
            take();
            read_clip(object);
            return true;
        case Word::k_bounded_by:
            take();
            read_bounds(object);
            return true;
        case Word::k_photons:
        case Word::k_radiosity:
            take();
            skip_block();
            return true;
        case Word::k_interior_texture:
            take();
            skip_block();
            object.missing.add(missing(item, "interior_texture"));
            return true;
        case Word::k_double_illuminate:
        case Word::k_no_image:
            take();
            if (flag()) object.missing.add(missing(item, to_string(item.word())));
            return true;
        case Word::k_no_reflection:
            take();
            object.no_reflection = flag() ? std::optional(item) : std::nullopt;
            return true;
        case Word::k_hollow:
            take();
            object.hollow = flag();
            return true;
        case Word::k_inverse:
            take();
            if (flag()) object.is_inverse = !object.is_inverse;
            return true;
        // Without effect on surfaces that cut nothing.
        case Word::k_sturm:
        case Word::k_hierarchy:
        case Word::k_split_union:
        case Word::k_no_radiosity:
            take();
            flag();
            return true;
        default:
            return false;
    }
}

// { objects }, after bounded_by.
void ObjectParser::read_bounds(Object& object) {
    if (!expect('{')) return;
    const bool is_clip = accept(Word::k_clipped_by);
    while (!failed() && !accept('}')) {
        if (is_clip || !begins_object(peek())) return expected(is_clip ? "`}`" : "an object or `}`");
        const Object bounds = read_object();
        accept(',');
        object.leaves_bounds |=
            !failed() && leaves_bounds(object, bounds, [&](std::uint64_t steps) { return spend(steps); });
    }
    object.is_bounded = true;
}

// { objects }, after clipped_by: reported unless the objects hold the whole shape.
void ObjectParser::read_clip(Object& object) {
    const Token at = taken();
    if (!expect('{')) return;
    if (accept(Word::k_bounded_by)) {
        expect('}');
        return;
    }
    while (!failed() && !accept('}')) {
        if (!begins_object(peek())) return expected("an object or `}`");
        Object clip = read_object();
        accept(',');
        if (clip.is_inverse && clip.kind == ObjectKind::plane) {
            clip.b = -clip.b;
            clip.s = -clip.s;
            clip.is_inverse = false;
        }
        if (object.mesh) spend(object.mesh->vertices.size() + object.mesh->triangles.size());
        if (!failed() && !holds(clip, object) && !clip_mesh(clip, object)) {
            Missing clipped = missing(at, "clipped_by");
            clipped.is_error = !reading().options.skip_unsupported;
            const auto cut = clip_of(clip, object, clipped);
            object.clip = cut;
            object.clips.push_back({make_counted<const Object>(std::move(clip)), object.map});
        }
    }
}

}  // namespace glint::povray
