// SPDX-License-Identifier: Apache-2.0
// Refraction: POV-Ray's `ior` of transparent objects.
#include <algorithm>

#include "formats/povray/reach.h"
#include "formats/povray/scene_builder.h"
#include "math/number.h"
#include "math/transform.h"
#include "scene/validate_solid.h"

namespace glint::povray {
namespace {

constexpr std::uint64_t k_max_tests = 10'000'000;

// What three objects within each other may be of the picture: four times as wide in a lens, it is less than a
// hundredth.
constexpr double k_least_seen = 5e-4;

// The square of the part of the picture's width or height that what three shapes have in common may be.
double seen_part(const Scene& scene, std::initializer_list<const Shape*> shapes) {
    ReachBox common{{-1e300, -1e300, -1e300}, {1e300, 1e300, 1e300}};
    for (const Shape* shape : shapes) {
        ReachBox own;
        own.add(scene, *shape);
        if (own.is_unbounded) return 1;
        for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
            common.least.*axis = std::max(common.least.*axis, own.least.*axis);
            common.most.*axis = std::min(common.most.*axis, own.most.*axis);
        }
    }
    const Camera& camera = scene.camera;
    if (!camera.frame) return 1;
    const double size = length(common.most - common.least),
                 side = std::min(length(camera.frame->right), length(camera.frame->up));
    double part = size / side;
    if (camera.projection == Projection::perspective) {
        double beside = 0;  // of the camera, squared
        for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
            const double at = camera.position.*axis;
            const double off = std::max({0.0, common.least.*axis - at, at - common.most.*axis});
            beside += off * off;
        }
        part *= length(camera.frame->forward) / number::sqrt(beside);
    }
    return part < 1 ? part * part : 1;
}

// Whether light passes, or may.
bool is_passed(const Material& m) { return m.is_transparent() || m.texture != k_none; }

}  // namespace

// 1: no refraction. An opaque object around the camera counts, too. (Measured)
double SceneBuilder::ior_of(const Inherited& own) {
    return own.interior && own.interior->ior > 0 ? std::min(own.interior->ior, 1e6) : 1;
}

bool SceneBuilder::refracts_light() const {
    const auto& all = scene_.materials;
    const auto refracts = [](const Material& m) { return m.refracts; };
    return std::any_of(all.begin(), all.end(), refracts) && std::any_of(all.begin(), all.end(), is_passed);
}

// Whether a texture and those below it let light through somewhere.
bool SceneBuilder::is_clear_texture(std::uint32_t texture) const {
    if (texture == k_none) return false;
    for (; texture != k_none; texture = scene_.textures[texture].over)
        if (!scene_.textures[texture].has_alpha()) return false;
    return true;
}

// A transparent object within one that refracts has an index of refraction, too: 1. (Measured)
void SceneBuilder::make_all_refract() {
    for (Material& m : scene_.materials) {
        if (m.refracts || !(m.is_transparent() || is_clear_texture(m.texture))) continue;
        m.refracts = true;
        m.ior = 1;
    }
}

void SceneBuilder::forget_refraction() {
    for (Material& m : scene_.materials) {
        if (m.refracts && !m.mirror_fresnel) m.ior = Material{}.ior;
        m.refracts = false;
    }
}

// After use_interiors(). Rays in three objects at a time do not know in which order they have entered these.
void SceneBuilder::check_refraction() {
    if (!refracts_at_) return;
    const auto& shapes = scene_.shapes;
    const auto refracting_material = [&](std::uint32_t number) -> const Material* {
        if (number >= scene_.materials.size()) return nullptr;
        const Material& m = scene_.materials[number];
        return m.refracts && (is_passed(m) || m.mirror_fresnel) ? &m : nullptr;
    };
    const auto material_of = [&](const Shape& shape) {
        const Material* found = refracting_material(shape.material);
        if (found || shape.kind != ShapeKind::solid) return found;
        for (const Shape& operand : scene_.solids[scene_.get<Solid>()[shape.index].solid].operands)
            found = found ? found : refracting_material(operand.material);
        return found;
    };
    CountedVector<std::uint32_t> all;
    for (std::uint32_t i = 0; i < shapes.size(); ++i) {
        if (material_of(shapes[i])) all.push_back(i);
    }
    std::uint64_t tests = 0;
    const auto are_together = [&](std::uint32_t a, std::uint32_t b) {
        tests += reach_steps(scene_, shapes[a]) + reach_steps(scene_, shapes[b]);
        const std::int32_t body = material_of(shapes[a])->interior;
        if (body > 0 && body == material_of(shapes[b])->interior) return false;
        return tests > k_max_tests || !are_apart(scene_, shapes[a], shapes[b]);
    };
    CountedVector<std::uint32_t> around;
    double seen = 0;  // of the picture, where three are together
    for (std::size_t i = 0; i < all.size(); ++i) {
        around.clear();
        for (std::size_t k = i + 1; k < all.size(); ++k) {
            if (!are_together(all[i], all[k])) continue;
            const Material &a = *material_of(shapes[all[i]]), &b = *material_of(shapes[all[k]]);
            if (!is_passed(a) && !is_passed(b)) continue;
            if (a.mirror_fresnel || b.mirror_fresnel)
                return report({"fresnel", "of an object within a transparent one", *refracts_at_});
            if (scene_.fog && hollow_at_)
                return report(
                    {"fog", "inside of hollow objects that refract, within another one", *hollow_at_});
            for (const std::uint32_t other : around) {
                if (!are_together(other, all[k])) continue;
                seen += seen_part(scene_, {&shapes[all[i]], &shapes[other], &shapes[all[k]]});
                if (tests > k_max_tests || seen > k_least_seen)
                    return report({"ior", "of three transparent objects within each other", *refracts_at_});
            }
            around.push_back(all[k]);
        }
    }
}

// In POV-Ray light fades where a ray has entered an object before: not in open shapes, and also where it is
// inside of a union for the second time. Glint's rule by normals does not know that.
void SceneBuilder::check_fading() {
    if (!fades_at_) return;
    const auto fades = [&](std::uint32_t material) {
        return material < scene_.materials.size() && scene_.materials[material].fade_distance > 0;
    };
    const auto is_faded = [&](const Shape& shape) {
        if (shape.kind != ShapeKind::solid) return fades(shape.material);
        const auto& operands = scene_.solids[scene_.get<Solid>()[shape.index].solid].operands;
        return std::any_of(operands.begin(), operands.end(),
                           [&](const Shape& operand) { return fades(operand.material); });
    };
    for (const Shape& shape : scene_.shapes) {
        if (shape.kind == ShapeKind::mesh || encloses_space(scene_, shape) || !is_faded(shape)) continue;
        report({"fade_distance", "of an open shape", *fades_at_});
        break;
    }
    // Measured: it fades only after a ray has entered the mesh.
    for (const ShapesWithInside& mesh : fading_meshes_) {
        if (!is_around_camera(mesh)) continue;
        report({"fade_distance", "of a mesh around the camera without `inside_vector`",
                stream_.call_place(mesh.at)});
        break;
    }
    if (overlapping_operands_)
        report({"fade_distance", "of a union in a solid whose parts overlap", *overlapping_operands_});
    std::uint64_t tests = 0;
    for (auto a = interiors_.begin(); a != interiors_.end(); ++a) {
        if (!a->is_union) continue;
        for (auto b = a; b != interiors_.end() && b->body == a->body; ++b) {
            for (std::size_t i = a->first; i < a->end; ++i) {
                if (!is_faded(scene_.shapes[i])) continue;
                for (std::size_t k = std::max(i + 1, b->first); k < b->end; ++k) {
                    const Shape &one = scene_.shapes[i], &other = scene_.shapes[k];
                    tests += (reach_steps(scene_, one) + reach_steps(scene_, other)) / 2;
                    if (tests <= k_max_tests && are_apart(scene_, one, other)) continue;
                    return report({"fade_distance", "of a union whose parts overlap", *fades_at_});
                }
            }
        }
    }
}

}  // namespace glint::povray
