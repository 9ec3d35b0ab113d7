// SPDX-License-Identifier: Apache-2.0
// Which shapes are one object, for refraction and for fog, which is only outside of objects, and which are
// hollow.
#include <algorithm>
#include <map>
#include <tuple>

#include "formats/povray/reach.h"
#include "formats/povray/scene_builder.h"
#include "math/aabb.h"
#include "math/transform.h"

namespace glint::povray {

// `ior` in a finish counts for the whole object and its parts, the last one of the text. (Measured)
const Opaque* SceneBuilder::finish_interior_of(const Object& object) {
    if (object.texture && object.texture->finish.interior) return object.texture->finish.interior.get();
    if (!object.parts) return nullptr;
    const auto& parts = *object.parts;
    for (std::size_t i = parts.size(); i-- > 0;) {
        if (const Opaque* found = finish_interior_of(*parts[i])) return found;
    }
    return nullptr;
}

// An object without an interior of its own has that of the group around it, with its `hollow`. The outermost
// `hollow` counts. (Measured)
void SceneBuilder::inherit_interior(const Object& object, Inherited& own) {
    if (!own.hollow) own.hollow = object.hollow;
    if (own.has_interior && !object.interior) return;
    own.has_interior = true;
    own.is_hollow = own.hollow.value_or(false);
    const bool has_parts = object.kind == ObjectKind::group || object.kind == ObjectKind::mesh ||
                           object.kind == ObjectKind::height_field;
    own.body = has_parts ? ++bodies_ : 0;
    own.is_union = object.kind == ObjectKind::group && object.stands_for.empty();
}

// The shapes from `first` on have been added.
void SceneBuilder::note_interior(std::size_t first, const Inherited& own) {
    const std::size_t end = scene_.shapes.size();
    if (first == end || (own.body == 0 && !own.is_hollow)) return;
    if (!interiors_.empty()) {
        ShapeInteriors& last = interiors_.back();
        if (last.end == first && last.body == own.body && last.is_hollow == own.is_hollow) {
            last.end = end;
            return;
        }
    }
    interiors_.push_back({first, end, own.body, own.is_hollow, own.is_union});
}

// Whether the camera is within its box.
bool SceneBuilder::is_around_camera(const ShapesWithInside& object) const {
    const Camera& camera = scene_.camera;
    const bool is_flat = camera.frame && camera.projection == Projection::orthographic;
    const double room = is_flat ? (length(camera.frame->right) + length(camera.frame->up)) / 2 : 0;
    const auto is_beside = [&](Vec3 d) {
        double most = -k_endless;
        for (std::size_t i = object.first; i < object.end; ++i)
            most = std::max(most, reach(scene_, scene_.shapes[i], d).value_or(k_endless));
        return most <= dot(d, camera.position) - room;
    };
    const Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    return std::none_of(std::begin(axes), std::end(axes),
                        [&](Vec3 d) { return is_beside(d) || is_beside(-d); });
}

// Warns of what is around the camera and has an inside in POV-Ray, but not here.
void SceneBuilder::check_camera_inside() {
    for (const ShapesWithInside& object : with_inside_) {
        if (!is_around_camera(object)) continue;
        return stream_.warn_once("camera inside", object.at,
                                 scene_.fog
                                     ? "the camera may be inside of this object, where POV-Ray has no fog: "
                                       "the picture may differ"
                                     : "the camera may be inside of this object, which POV-Ray counts "
                                       "for refraction: the picture may differ");
    }
}

// The shapes from `first` on are a whole object: those that become operands of a solid lose their numbers.
void SceneBuilder::note_inside(const Object& object, const Inherited& own, std::size_t first) {
    const bool is_inverse = object.is_inverse && !own.is_hollow;
    const bool has_inside = object.stands_for.empty()
                                ? object.mesh && object.mesh->has_inside
                                : object.stands_for != "polygon" && object.stands_for != "height_field";
    const bool is_mesh = has_inside && !(scene_.fog && own.is_hollow);
    if (is_inverse || is_mesh) with_inside_.push_back({first, scene_.shapes.size(), object.at});
}

// Gives the shapes materials with their interiors, if the scene has fog or refraction.
void SceneBuilder::use_interiors() {
    const bool refracts = refracts_light();
    if (refracts)
        make_all_refract();
    else
        forget_refraction();
    if (!scene_.fog && !refracts) return;
    check_camera_inside();
    if (interiors_.empty()) return;
    using Kind = std::tuple<std::uint32_t, std::int32_t, bool>;  // material, body, hollow
    CountedMap<Kind, std::uint32_t> materials;
    const std::size_t given = scene_.materials.size();
    std::vector<bool> used(given);
    auto range = interiors_.begin();
    // Returns false if there is not enough memory.
    const auto use = [&](std::uint32_t& material, bool has) {
        if (material >= given) return true;
        const Material& m = scene_.materials[material];
        const bool lets_through = scene_.fog ? m.is_transparent() : m.refracts;
        const Kind kind{material, has && lets_through ? range->body : 0,
                        has && scene_.fog && range->is_hollow};
        const auto [known, is_new] = materials.try_emplace(kind, material);
        if (is_new) {
            // The first kind keeps the material's number.
            if (used[material]) {
                known->second = static_cast<std::uint32_t>(scene_.materials.size());
                note(scene_.material_texts, known->second, scene_.material_texts.place(material));
                scene_.materials.push_back(m);
                const bool is_time = scene_.materials.size() % 256 == 0;
                if (is_time && !stream_.is_within_memory(stream_.own_tokens().back())) return false;
            }
            used[material] = true;
            Material& own = scene_.materials[known->second];
            own.interior = std::get<1>(kind);
            own.hollow = std::get<2>(kind);
        }
        material = known->second;
        return true;
    };
    for (std::size_t i = 0; i < scene_.shapes.size(); ++i) {
        while (range != interiors_.end() && range->end <= i) ++range;
        const bool has = range != interiors_.end() && range->first <= i;
        Shape& shape = scene_.shapes[i];
        if (!use(shape.material, has)) return;
        if (shape.kind != ShapeKind::solid) continue;
        for (Shape& operand : scene_.solids[scene_.get<Solid>()[shape.index].solid].operands) {
            if (!use(operand.material, has)) return;
        }
    }
}

}  // namespace glint::povray
