// SPDX-License-Identifier: Apache-2.0
// Textures and lights to the Scene's materials and lights.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/povray/add_shape.h"
#include "formats/povray/parts.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

Color times(const std::array<double, 5>& pigment, Color by) {
    return {pigment[0] * by.r, pigment[1] * by.g, pigment[2] * by.b};
}

// The parts of a face along a side, and the strips of one with two colors.
constexpr int k_max_parts = 32, k_max_fine_parts = 64, k_max_strips = 171;
constexpr std::uint64_t k_few_shapes = 1'000'000;

bool same_light(const Finish& a, const Finish& b) {
    return a.ambient == b.ambient && a.emission == b.emission &&
           a.brightest_diffuse() == b.brightest_diffuse() && a.brilliance == b.brilliance &&
           a.brightest_phong() == b.brightest_phong() && a.phong_size == b.phong_size &&
           a.brightest_specular() == b.brightest_specular() && a.roughness == b.roughness &&
           a.metallic == b.metallic && a.reflection_max == b.reflection_max &&
           a.reflection_min == b.reflection_min;
}

// Whether a shape of the same material has the same warnings: those that the material does not decide are of
// what these have.
bool has_nothing_else(const Texture& texture, const Opaque* interior, bool is_merge) {
    return texture.missing.empty() && !texture.pigment.missing && texture.finish.missing.empty() &&
           !texture.finish.has_no_refraction && !texture.is_layered && interior == nullptr && !is_merge;
}

double largest(Color c) { return std::max({c.r, c.g, c.b}); }

}  // namespace

std::uint32_t Reader::material_of(const Inherited& own, const Token& at) {
    const Texture& texture = *own.texture;
    const Finish& f = texture.finish;
    const std::array<double, 5>& p = texture.pigment.color;
    const double glass = glass_of(own);
    const NumberTable<33>::Key key{p[0],
                                   p[1],
                                   p[2],
                                   p[3],
                                   p[4],
                                   f.ambient.r,
                                   f.ambient.g,
                                   f.ambient.b,
                                   f.brightest_diffuse(),
                                   f.brightest_phong(),
                                   f.phong_size,
                                   f.brightest_specular(),
                                   f.roughness,
                                   f.emission.r,
                                   f.emission.g,
                                   f.emission.b,
                                   f.brilliance,
                                   f.metallic,
                                   f.reflection_min.r,
                                   f.reflection_min.g,
                                   f.reflection_min.b,
                                   f.reflection_max.r,
                                   f.reflection_max.g,
                                   f.reflection_max.b,
                                   f.reflection_metallic,
                                   f.reflection_falloff,
                                   f.crand,
                                   f.diffuse_back,
                                   own.is_no_shadow ? 1.0 : 0.0,
                                   f.reflection_exponent,
                                   f.reflection_fresnel ? 1.0 : 0.0,
                                   f.conserve_energy ? 1.0 : 0.0,
                                   glass > 0 ? own.interior->ior : 0.0};
    const bool is_last = last_material_ != k_none && key == last_key_;
    if (is_last && is_last_plain_ && has_nothing_else(texture, own.interior, own.is_merge))
        return last_material_;
    report_texture(own, at);
    is_last_plain_ = has_nothing_else(texture, own.interior, own.is_merge);
    if (is_last) return last_material_;
    last_key_ = key;
    if (const std::uint32_t* known = materials_.find(key)) return last_material_ = *known;
    Material m;
    const Color pigment{p[0], p[1], p[2]};
    m.color = pigment;
    m.ambient = times(p, f.ambient);
    m.emission = times(p, f.emission);
    m.diffuse = pigment * f.brightest_diffuse();
    m.specular = {0, 0, 0};
    m.brilliance = std::max(f.brilliance, 0.0);
    m.metallic = std::clamp(f.metallic, 0.0, 1.0);
    if (f.specular > 0 && f.roughness > 0) {
        m.specular = Color{1, 1, 1} * f.brightest_specular();
        m.shininess = std::min(1 / f.roughness, 1e9);
    }
    // phong at or below 0 is no highlight.
    if (f.phong > 0) {
        m.phong = Color{1, 1, 1} * f.brightest_phong();
        m.phong_shininess = std::clamp(f.phong_size, 0.0, 1e9);
    }
    if (const double most = largest(f.reflection_max); most > 0) {
        m.mirror = std::min(most, 1.0);
        m.mirror_tint = f.reflection_max * (1 / most);
        m.mirror_metallic = std::clamp(f.reflection_metallic, 0.0, 1.0);
        if (!(f.reflection_min == f.reflection_max)) {
            m.mirror_min = std::clamp(largest(f.reflection_min), 0.0, 1.0);
            m.mirror_falloff = std::max(f.reflection_falloff, 1e-6);
        }
    }
    m.filter = std::clamp(p[3], 0.0, 1.0);
    m.transmit = std::clamp(p[4], 0.0, 1.0 - m.filter);
    m.casts_shadow = !own.is_no_shadow;
    if (glass > 0) {
        m.filter = m.transmit = 0;
        m.transmission = glass;
        m.ior = own.interior->ior;
        for (Color* matte : {&m.ambient, &m.diffuse, &m.emission}) *matte = *matte * (1 - glass);
        m.casts_shadow = false;
    }
    last_material_ = static_cast<std::uint32_t>(scene_.materials.size());
    note(scene_.material_texts, last_material_, place_of(call_place(at)));
    scene_.materials.push_back(m);
    materials_.add(key, last_material_);
    return last_material_;
}

// What a texture has that is not rendered.
void Reader::report_texture(const Inherited& own, const Token& at) {
    const Texture& texture = *own.texture;
    const Finish& f = texture.finish;
    const std::array<double, 5>& p = texture.pigment.color;
    report(texture.missing);
    if (texture.pigment.missing) report(*texture.pigment.missing);
    report(f.missing);
    const bool is_transparent = p[3] != 0 || p[4] != 0;
    const auto check = [&](bool is_used, std::string_view name, std::string_view meaning) {
        if (is_used && !reading_.diagnostics.warned(name)) report({name, meaning, call_place(at)});
    };
    check(p[3] < 0 || p[4] < 0 || p[3] + p[4] > 1 + 1e-9, "filter, transmit", "with a sum beyond 0 and 1");
    if (is_transparent && own.interior) report(own.interior->missing);
    check(is_transparent && own.interior && own.interior->ior != 1 && !(glass_of(own) > 0), "ior",
          "refraction");
    check(is_transparent && f.has_no_refraction, "refraction", "of 0");
    check(is_transparent && own.is_merge, "merge", "of transparent surfaces");
    check(is_transparent && texture.is_layered, "layered textures", "transparent textures over others");
    check(f.metallic < 0 || f.metallic > 1 || f.reflection_metallic < 0 || f.reflection_metallic > 1,
          "metallic", "beyond 0 and 1");
    check(f.brilliance < 0, "brilliance", "below 0");
    check(f.crand != 0, "crand", "a property of a finish");
    check(f.diffuse_back != 0, "diffuse", "of the far side");
    const bool is_mirror = largest(f.reflection_max) > 0;
    check(is_mirror && f.reflection_fresnel, "fresnel", "of a reflection");
    check(is_mirror && largest(f.reflection_max) > 1, "reflection", "above 1");
    // The two colors are the same but for their size.
    const double least = largest(f.reflection_min), most = largest(f.reflection_max);
    const Color a = f.reflection_min * most, b = f.reflection_max * least;
    const double apart = number::abs(a.r - b.r) + number::abs(a.g - b.g) + number::abs(a.b - b.b);
    check(is_mirror && least > 0 && apart > 1e-9, "reflection", "of two colors");
    check(is_mirror && f.reflection_exponent != 1, "reflection_exponent", "");
    check(is_mirror && is_transparent && f.conserve_energy, "conserve_energy", "");
}

void Reader::place_light(const Object& object, const Inherited& own) {
    const LightSource& source = *object.light;
    report(source.missing);
    Light light = source.light;
    Vec3 point_at = source.point_at;
    if (own.map) {
        light.position = transform_point(*own.map, light.position);
        point_at = transform_point(*own.map, point_at);
    }
    // Lights without shadows give no highlights (POV-Ray, measured).
    if (!light.casts_shadows) light.specular_color = {0, 0, 0};
    const Vec3 axis = point_at - light.position;
    const bool has_axis = !(axis == Vec3{0, 0, 0});
    if (source.is_parallel) {
        if (light.is_spot()) report({"spotlight", "that is parallel", call_place(object.at)});
        light.kind = LightKind::directional;
        light.to_light = has_axis ? -axis : Vec3{0, 0, -1};
        if (light.fade_distance > 0 && light.fade_power > 0)
            report({"fade_distance", "of a parallel light", call_place(object.at)});
        light.fade_distance = light.fade_power = 0;
        if (light.casts_shadows) {
            parallel_lights_.push_back({light.position, normalize(light.to_light), call_place(object.at)});
        }
    } else if (light.is_spot()) {
        light.axis = has_axis ? axis : Vec3{0, 0, 1};
        // POV-Ray takes the cosines of both.
        light.inner_angle = std::min(number::abs(light.inner_angle), 180.0);
        // A radius beyond the falloff counts.
        light.outer_angle =
            std::clamp(number::abs(light.outer_angle), std::max(light.inner_angle, 1e-6), 180.0);
    }
    if (source.is_area) {
        if (light.has_position() && !light.is_spot()) {
            light.kind = LightKind::parallelogram;
            if (own.map) {
                light.side_u = transform_vector(*own.map, light.side_u);
                light.side_v = transform_vector(*own.map, light.side_v);
            }
            // A side with one sample has no length in POV-Ray.
            if (light.samples_u == 1 && light.samples_v == 1) light.kind = LightKind::point;
        } else {
            report({"area_light", "of a spotlight or parallel light", call_place(object.at)});
        }
    }
    light.fade_distance = std::max(light.fade_distance, 0.0);
    light.fade_power = std::max(light.fade_power, 0.0);
    note(scene_.light_texts, scene_.lights.size(), place_of(call_place(object.at)));
    scene_.lights.push_back(light);
    place_look(object, own);
}

// looks_like.
void Reader::place_look(const Object& object, const Inherited& own) {
    if (!object.parts) return;
    Inherited look = own;
    const Affine to_light = translation(object.light->light.position);
    const Affine map = own.map ? compose(*own.map, to_light) : to_light;
    look.map = &map;
    for (const ObjectPart& part : *object.parts) place(*part, look);
}

// The three textures of a face are blended between its corners: by parts of one color each, whose colors
// differ by at most 1.5 of 255, or more if the three corners have very different ones.
void Reader::add_blended_face(const Object& o, const Inherited& own, const Mesh::Face& face,
                              std::span<const Vec3> points, std::span<const Vec3> normals) {
    const Mesh& mesh = *o.mesh;
    std::array<const Texture*, 3> textures{};
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i) textures[i] = mesh.textures[face.textures[i]].get();
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 5; ++k) {
            const double d = textures[i]->pigment.color[k] - textures[(i + 1) % 3]->pigment.color[k];
            most = std::max(most, number::abs(d));
        }
    }
    for (const Texture* texture : textures) {
        if (texture->pigment.missing) report(*texture->pigment.missing);
        report(texture->missing);
        if (!same_light(texture->finish, textures[0]->finish)) {
            report({"texture_list", "with different finishes at the corners of a face", call_place(o.at)});
        }
    }
    const auto corner = [&](std::span<const Vec3> from, const std::array<std::uint32_t, 3>& of,
                            const CornerWeights& w) {
        return mixed(from[of[0]], from[of[1]], from[of[2]], w);
    };
    using Corners = std::array<CornerWeights, 3>;
    // colors: the part's color is their mean.
    const auto add_part = [&](const Corners& corners, const Corners& colors) {
        Texture texture = *textures[0];
        texture.pigment.color.fill(0);
        SmoothTriangle part;
        for (std::size_t k = 0; k < 3; ++k) {
            part.vertices[k] = corner(points, face.vertices, corners[k]);
            if (face.has_normals) part.normals[k] = corner(normals, face.normals, corners[k]);
            for (std::size_t c = 0; c < 5; ++c) {
                const auto at = [&](std::size_t i) { return textures[i]->pigment.color[c]; };
                texture.pigment.color[c] += mixed(at(0), at(1), at(2), colors[k]) / 3;
            }
        }
        Inherited part_own = own;
        part_own.texture = &texture;
        const std::uint32_t material = material_of(part_own, o.at);
        if (face.has_normals) {
            add(part, material, nullptr, o.at);
        } else {
            add(Triangle{{part.vertices[0], part.vertices[1], part.vertices[2]}}, material, nullptr, o.at);
        }
        return !failed_;
    };
    const auto has_room = [&](int parts) {
        shapes_ += static_cast<std::uint64_t>(parts);
        if (shapes_ > max_shapes()) {
            error(o.at, fmt::format("the colors of this mesh take more than {} triangles: glint draws a face "
                                    "with several colors as many small triangles of one color; try fewer "
                                    "faces, or one texture for each face",
                                    max_shapes()));
        }
        return !failed_;
    };
    const int steps = static_cast<int>(std::min(most, 10.0) * 170) + 1;
    for (std::size_t i = 0; i < 3 && steps > k_max_parts; ++i) {
        if (!(textures[(i + 1) % 3]->pigment == textures[(i + 2) % 3]->pigment)) continue;
        // Only one corner has another color: strips along the side opposite to it.
        const int strips = std::min(steps, k_max_strips);
        if (!has_room(2 * strips)) return;
        return for_each_strip(strips, i, [&](const Corners& corners, const CornerWeights& middle) {
            return add_part(corners, {middle, middle, middle});
        });
    }
    const int n = std::clamp(steps, 1, shapes_ < k_few_shapes ? k_max_fine_parts : k_max_parts);
    if (!has_room(n * n)) return;
    for_each_part(n, [&](const Corners& corners) { return add_part(corners, corners); });
}

}  // namespace glint::povray
