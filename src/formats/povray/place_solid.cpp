// SPDX-License-Identifier: Apache-2.0
// Groups, solids and what clipped_by cuts off. (Measured: tests/peers/solids.py)
//   - A union in a solid keeps its inner surfaces, unless the solid is outside of it; a merge has none.
//   - clipped_by cuts the shapes of a group one by one, and a solid as a whole. The cut is open, and what is
//     cut off is not inside any more.
#include <algorithm>
#include <vector>

#include "formats/povray/clip.h"
#include "formats/povray/closed_mesh.h"
#include "formats/povray/object_parser.h"
#include "formats/povray/reach.h"
#include "formats/povray/scene_builder.h"
#include "formats/povray/solid_lathe.h"
#include "math/transform.h"
#include "scene/validate_solid.h"

namespace glint::povray {
namespace {

// Why it cannot be a part of a solid; empty: it can.
std::string_view reason_against(const Object& object) {
    constexpr std::string_view in_solid = "in a solid";
    switch (object.kind) {
        case ObjectKind::disc:
        case ObjectKind::triangle:
        case ObjectKind::smooth_triangle:
        case ObjectKind::polygon:
        case ObjectKind::height_field:
        case ObjectKind::light:
            return in_solid;
        case ObjectKind::cylinder:
        case ObjectKind::cone:
            return object.is_open ? in_solid : std::string_view();
        case ObjectKind::mesh:
            if (!object.mesh) return {};
            if (object.stands_for.empty() && !object.mesh->has_inside)
                return "without `inside_vector` in a solid";
            if (!object.mesh->textures.empty()) return "with textures of its faces in a solid";
            return closed_mesh(object.mesh) ? std::string_view() : "that is open, in a solid";
        default:
            return !object.lathe || solid_lathe(object) ? std::string_view() : object.lathe->reason;
    }
}

std::string_view name_of_open(ObjectKind kind) {
    switch (kind) {
        case ObjectKind::disc:
            return "disc";
        case ObjectKind::polygon:
            return "polygon";
        case ObjectKind::mesh:
            return "mesh";
        case ObjectKind::light:
            return "light_source";
        case ObjectKind::cylinder:
        case ObjectKind::cone:
            return "open";
        default:
            return "triangle";
    }
}

bool has_parts(const Object& object) {
    return object.kind == ObjectKind::group || object.kind == ObjectKind::solid;
}

// Whether light may pass surfaces of the object. texture: of those without one.
bool may_be_clear(const Object& object, const Texture* texture) {
    if (object.texture) texture = object.texture.get();
    if (has_parts(object)) {
        return std::any_of(object.parts->begin(), object.parts->end(),
                           [&](const ObjectPart& part) { return may_be_clear(*part, texture); });
    }
    const Pigment& pigment = texture->pigment;
    return pigment.image || pigment.color[3] != 0 || pigment.color[4] != 0;
}

bool has_clips(const Object& object) {
    if (!object.clips.empty()) return true;
    return has_parts(object) && std::any_of(object.parts->begin(), object.parts->end(),
                                            [](const ObjectPart& part) { return has_clips(*part); });
}

// Whether some of the shapes from `first` on may overlap.
bool have_overlap(const Scene& scene, std::size_t first) {
    constexpr std::size_t k_most = 1000;
    constexpr std::uint64_t k_most_steps = 100'000'000;
    const std::size_t end = scene.shapes.size();
    if (end - first > k_most) return true;
    std::uint64_t steps = 0;
    for (std::size_t i = first; i < end; ++i) {
        for (std::size_t k = i + 1; k < end; ++k) {
            const Shape &a = scene.shapes[i], &b = scene.shapes[k];
            steps += reach_steps(scene, a) + reach_steps(scene, b);
            if (steps > k_most_steps || !are_apart(scene, a, b)) return true;
        }
    }
    return false;
}

}  // namespace

void add_operand_errors(const Object& object, MissingList& missing, std::string_view stands_for) {
    if (!object.stands_for.empty()) stands_for = object.stands_for;
    for (const Missing& each : object.missing) {
        if (each.is_error) missing.add(each);
    }
    if (const std::string_view reason = reason_against(object); !reason.empty()) {
        Missing open{stands_for.empty() ? name_of_open(object.kind) : stands_for, reason, object.at};
        open.is_error = true;
        missing.add(open);
    }
    if (!has_parts(object) || object.lathe) return;
    for (const ObjectPart& part : *object.parts) add_operand_errors(*part, missing, stands_for);
}

bool encloses_space(const Object& object) {
    MissingList errors;
    add_operand_errors(object, errors);
    return errors.empty();
}

void ObjectParser::check_operands(Object& solid) {
    for (std::size_t i = 0; i < solid.parts->size(); ++i) {
        const Object& part = *(*solid.parts)[i];
        spend(part.count);
        add_operand_errors(part, solid.missing);
        spend(take_lathe_steps(part));
        // POV-Ray turns the part inside out, but not what cuts it.
        if (solid.operation != SolidOperation::difference || i == 0 || !has_clips(part)) continue;
        Missing clipped{"clipped_by", "of what is cut out", part.at};
        clipped.is_error = true;
        solid.missing.add(clipped);
    }
    if (count_operands(solid) <= k_max_solid_operands) return;
    Missing large{to_string(solid.operation), "of more than 4096 shapes, as those of curved lathes",
                  solid.at};
    large.is_error = true;
    solid.missing.add(large);
}

// The shapes from `first` on become one.
void SceneBuilder::combine_from(std::size_t first, SolidOperation operation, const Token& at) {
    scene_.shape_texts.places.resize(first);
    scene_.shape_texts.places.push_back(shape_place(at));
    combine_last(scene_, operation, static_cast<std::uint32_t>(first), scene_.shapes[first].material);
}

// A shape, or a solid, that is an operand or is cut off.
void SceneBuilder::finish_operand(const Object& object, const Inherited& own, std::size_t first) {
    if (scene_.shapes.size() == first || stream_.failed()) return;
    if (own.in_solid && object.is_inverse) combine_from(first, SolidOperation::inverse, object.at);
    if (!own.clips) return;
    for (const PlacedClip& clip : *own.clips) {
        Inherited cutting;
        cutting.texture = own.texture;
        cutting.map = clip.map ? &*clip.map : nullptr;
        cutting.in_solid = true;
        const std::size_t before = scene_.shapes.size();
        place(*clip.object, cutting);
        if (scene_.shapes.size() == before) {  // a shape without an extent
            scene_.shapes.resize(first);
            scene_.shape_texts.places.resize(first);
            return;
        }
    }
    combine_from(first, SolidOperation::clip, object.at);
}

// A shape that has been placed whole.
void SceneBuilder::cut(const UncutShape& uncut) {
    const Texture unseen;
    Inherited cutting;
    cutting.texture = &unseen;
    cutting.in_solid = true;
    const std::size_t end = scene_.shapes.size();
    std::vector<Shape> parts{scene_.shapes[uncut.shape]};
    for (const ClipObject& clip : uncut.objects) place(*clip.object, cutting);
    parts.insert(parts.end(), scene_.shapes.begin() + static_cast<std::ptrdiff_t>(end), scene_.shapes.end());
    scene_.solids.push_back(combine(scene_, SolidOperation::clip, parts));
    scene_.shapes.resize(end);
    scene_.shape_texts.places.resize(end);
    auto& solids = scene_.get<Solid>();
    solids.push_back({static_cast<std::uint32_t>(scene_.solids.size() - 1)});
    scene_.shapes[uncut.shape] = {ShapeKind::solid, static_cast<std::uint32_t>(solids.size() - 1),
                                  parts[0].material, k_none};
}

// Clips of shapes that have an inside. False if one has none.
bool SceneBuilder::add_clips(const Object& object, const Inherited& from, Inherited& own) {
    if (!encloses_space(object)) return false;
    auto all = make_counted<CountedVector<PlacedClip>>();
    if (own.clips) *all = *own.clips;
    for (const ClipObject& clip : object.clips) {
        if (!encloses_space(*clip.object)) return false;
        std::optional<Affine> map = object.map;
        if (clip.map) {
            const auto back = inverse(*clip.map);
            if (!back || !map) return false;
            map = object.map == clip.map ? std::nullopt : std::optional(compose(*map, *back));
        }
        if (from.map) map = map ? compose(*from.map, *map) : *from.map;
        all->push_back({clip.object, map});
    }
    own.clips = std::move(all);
    return true;
}

// The solid is whole.
void SceneBuilder::note_solid(std::size_t index, const Inherited& own) {
    Shape& shape = scene_.shapes[index];
    if (shape.kind == ShapeKind::solid) {
        auto& operands = scene_.solids[scene_.get<Solid>()[shape.index].solid].operands;
        const bool is_of_one = std::all_of(operands.begin(), operands.end(), [&](const Shape& operand) {
            return operand.material == shape.material;
        });
        for (Shape& operand : operands) {
            if (is_of_one) operand.material = k_none;
        }
    }
    note_interior(index, own);
}

void SceneBuilder::place_parts(const Object& object, const Inherited& own) {
    if (object.lathe && (own.in_solid || own.clips)) {
        Object whole = *solid_lathe(object);
        whole.is_inverse = object.is_inverse;
        return place_parts(whole, own);
    }
    const bool is_solid = object.kind == ObjectKind::solid;
    if (is_solid && std::any_of(object.missing.begin(), object.missing.end(),
                                [](const Missing& missing) { return missing.is_error; }))
        return;
    Inherited parts = own;
    // A sphere_sweep or lathe is one shape, which clips cut as a whole.
    const bool is_cut_sweep = own.clips && !object.stands_for.empty();
    const bool shows_inside = is_cut_sweep || (!own.clips && may_be_clear(object, own.texture));
    const bool merges = object.is_merge && shows_inside && encloses_space(object) &&
                        count_operands(object) <= k_max_solid_operands;
    const bool makes_solid = is_solid || own.in_solid || merges;
    if (makes_solid) {
        parts.in_solid = true;
    } else if (object.is_merge) {
        parts.is_merge = true;
    }
    const bool is_cut_whole = is_solid || (merges && is_cut_sweep);
    if (is_cut_whole) parts.clips.reset();
    const std::size_t first = scene_.shapes.size();
    bool is_empty = false;
    for (std::size_t i = 0; i < object.parts->size(); ++i) {
        const Object& part = *(*object.parts)[i];
        const std::size_t before = scene_.shapes.size();
        // Surfaces of what cuts have the texture of what is cut.
        if (object.is_cutaway && i == 1 && object.parts->front()->texture) {
            parts.texture = object.parts->front()->texture.get();
            parts.texture_map = own.map;
        }
        parts.is_cut_out =
            own.is_cut_out || (is_solid && object.operation == SolidOperation::difference && i > 0);
        place(part, parts);
        const bool decides = is_solid && (i == 0 || object.operation == SolidOperation::intersection);
        if (decides) is_empty |= scene_.shapes.size() == before;
    }
    if (stream_.failed() || scene_.shapes.size() == first) return;
    if (!makes_solid) return;
    const bool is_union = !is_solid && !object.is_merge && object.stands_for.empty();
    if (is_union && own.in_solid && !own.is_cut_out && fade_of(own).distance > 0 &&
        have_overlap(scene_, first))
        overlapping_operands_ = stream_.call_place(object.at);
    if (is_empty) {
        scene_.shapes.resize(first);
        scene_.shape_texts.places.resize(first);
        return;
    }
    const SolidOperation group = object.is_merge ? SolidOperation::merge : SolidOperation::unite;
    combine_from(first, is_solid ? object.operation : group, object.at);
    Inherited whole = own;
    if (!is_cut_whole) whole.clips.reset();
    finish_operand(object, whole, first);
    if (!own.in_solid) note_solid(first, own);
}

}  // namespace glint::povray
