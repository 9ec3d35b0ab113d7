// SPDX-License-Identifier: Apache-2.0
// Textures to the Scene's materials.
#include <algorithm>

#include "formats/povray/scene_builder.h"
#include "math/number.h"

namespace glint::povray {
namespace {

Color times(const std::array<double, 5>& pigment, Color by) {
    return {pigment[0] * by.r, pigment[1] * by.g, pigment[2] * by.b};
}

// Whether a shape of the same material has the same warnings: those that the material does not decide are of
// what these have.
bool has_nothing_else(const Texture& texture, const Opaque* interior, bool is_merge) {
    return !has_warnings(texture) && interior == nullptr && !is_merge;
}

// Whether a layer below that of the finish `top` looks as if it had this finish, but for ambient and diffuse.
bool looks_the_same_below(const Finish& below, const Finish& top) {
    const auto has_highlight = [](const Finish& f) { return f.phong > 0 || f.specular > 0; };
    const bool is_matte = !has_highlight(below) && below.reflection_max == Color{0, 0, 0};
    const bool has_color = (top.metallic != 0 && has_highlight(top)) || top.reflection_metallic != 0;
    return is_matte && !has_color && below.emission == top.emission && below.brilliance == top.brilliance;
}

// Whether a color is `most` times a number from 0 on.
bool is_part(Color color, Color most) {
    const double x = largest(color), y = largest(most);
    const Color off = color * y + most * -x;
    return x >= 0 && number::abs(off.r) + number::abs(off.g) + number::abs(off.b) <= 1e-9 * y;
}

}  // namespace

TextureNumbers numbers_of(const Texture& texture) {
    const Finish& f = texture.finish;
    const std::array<double, 5>& p = texture.pigment.color;
    return {p[0],
            p[1],
            p[2],
            p[3],
            p[4],
            f.ambient.r,
            f.ambient.g,
            f.ambient.b,
            f.diffuse,
            f.phong,
            f.phong_size,
            f.specular,
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
            f.reflection_exponent,
            f.reflection_fresnel ? 1.0 : 0.0,
            f.conserve_energy ? 1.0 : 0.0,
            texture.pigment.image_number,
            texture.layers_number};
}

bool has_warnings(const Texture& texture) {
    return !texture.missing.empty() || texture.pigment.missing || !texture.finish.missing.empty() ||
           texture.finish.refraction != 1 || texture.below;
}

Fade SceneBuilder::fade_of(const Inherited& own) {
    // Measured: light does not fade by shorter distances.
    if (!own.interior || !(own.interior->fade.distance >= 1e-10)) return {};
    Fade fade = own.interior->fade;
    fade.distance = std::min(fade.distance, k_not_negative.max);
    fade.power = std::clamp(fade.power, 0.0, k_not_negative.max);
    return fade;
}

// Measured: the power of the cosine is 45 times POV-Ray's number.
double SceneBuilder::caustics_of(const Inherited& own) {
    return own.interior ? std::clamp(45 * own.interior->caustics, 0.0, k_not_negative.max) : 0;
}

std::uint32_t SceneBuilder::material_of(const Inherited& own, const Token& at) {
    const Texture& texture = *own.texture;
    const Finish& f = texture.finish;
    layer_light_.reset();
    if (texture.below) layer_light_ = light_of_layers(texture);
    const Color ambient = layer_light_ ? layer_light_->ambient : f.ambient;
    const double diffuse = layer_light_ ? layer_light_->diffuse : f.diffuse;
    const Look look = look_of(own, at);
    const std::array<double, 5>& p = look.color;
    const double ior = ior_of(own);
    NumberTable<41>::Key key;
    const TextureNumbers numbers = numbers_of(texture);
    *std::copy(numbers.begin(), numbers.end(), key.begin()) = own.is_no_shadow ? 1.0 : 0.0;
    std::copy(p.begin(), p.end(), key.begin());
    key[5] = ambient.r, key[6] = ambient.g, key[7] = ambient.b, key[8] = diffuse;
    key[numbers.size() - 2] = look.image == k_none ? 0 : look.image + 1.0;
    key[numbers.size() - 1] = 0;
    const Fade fade = fade_of(own);
    const double caustics = caustics_of(own);
    const double inside[] = {ior,          fade.distance, fade.power, fade.color.r,
                             fade.color.g, fade.color.b,  caustics};
    std::copy(std::begin(inside), std::end(inside), key.end() - std::ssize(inside));
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
    m.texture = look.image;
    m.ambient = times(p, ambient);
    m.emission = times(p, f.emission);
    m.diffuse = pigment * diffuse;
    m.specular = {0, 0, 0};
    m.brilliance = std::max(f.brilliance, 0.0);
    m.metallic = std::clamp(f.metallic, 0.0, 1.0);
    if (f.specular > 0 && f.roughness > 0) {
        m.specular = Color{1, 1, 1} * f.specular;
        m.shininess = std::min(1 / f.roughness, 1e9);
    }
    // phong at or below 0 is no highlight.
    if (f.phong > 0) {
        m.phong = Color{1, 1, 1} * f.phong;
        m.phong_shininess = std::clamp(f.phong_size, 0.0, 1e9);
    }
    if (const double most = largest(f.reflection_max); most > 0) {
        m.mirror = std::min(most, 1.0);
        m.mirror_tint = f.reflection_max * (1 / most);
        m.mirror_metallic = std::clamp(f.reflection_metallic, 0.0, 1.0);
        if (!(f.reflection_min == f.reflection_max)) {
            m.mirror_min = std::clamp(largest(f.reflection_min), 0.0, 1.0);
            m.mirror_fresnel = f.reflection_fresnel;
            if (!m.mirror_fresnel) m.mirror_falloff = std::max(f.reflection_falloff, 1e-6);
        }
    }
    m.conserve_energy = f.conserve_energy && m.mirror > 0 && (p[3] > 0 || p[4] > 0 || m.texture != k_none);
    m.filter = std::clamp(p[3], 0.0, 1.0);
    m.transmit = std::clamp(p[4], 0.0, 1.0 - m.filter);
    m.casts_shadow = !own.is_no_shadow;
    m.refracts = ior != 1;
    if (m.refracts) m.ior = ior;
    m.fade_distance = fade.distance;
    if (fade.distance > 0) m.fade_power = fade.power, m.fade_color = fade.color;
    m.caustics = caustics;
    last_material_ = static_cast<std::uint32_t>(scene_.materials.size());
    note(scene_.material_texts, last_material_, stream_.place_of(stream_.call_place(at)));
    scene_.materials.push_back(m);
    materials_.add(key, last_material_);
    return last_material_;
}

// What a texture has that is not rendered.
void SceneBuilder::report_texture(const Inherited& own, const Token& at) {
    const Texture& texture = *own.texture;
    const Finish& f = texture.finish;
    const std::array<double, 5>& p = texture.pigment.color;
    bool is_transparent = true, is_one_finish = true;  // of the layers that are seen
    const Color all_ambient = texture.below ? light_of_layers(texture).ambient : f.ambient;
    for (const Texture* layer = &texture; layer && is_transparent; layer = layer->below.get()) {
        report(layer->missing);
        if (layer->pigment.missing) report(*layer->pigment.missing);
        report(layer->finish.missing);
        is_one_finish = is_one_finish && (layer == &texture || looks_the_same_below(layer->finish, f)) &&
                        is_part(layer->finish.ambient, all_ambient) && layer->finish.diffuse >= 0;
        is_transparent = is_clear(*layer);
    }
    const auto check = [&](bool is_used, std::string_view name, std::string_view meaning) {
        if (is_used && !reading_.diagnostics.warned(name)) report({name, meaning, stream_.call_place(at)});
    };
    check(p[3] < 0 || p[4] < 0 || p[3] + p[4] > 1 + 1e-9, "filter, transmit", "with a sum beyond 0 and 1");
    if (is_transparent && own.interior) report(own.interior->missing);
    check(is_transparent && own.interior && !(own.interior->ior > 0), "ior", "of 0 or less");
    if (is_transparent && own.is_hollow) hollow_at_ = stream_.call_place(at);
    if (is_transparent && fade_of(own).distance > 0) fades_at_ = stream_.call_place(at);
    if (is_transparent && own.interior) {
        const Fade& fade = own.interior->fade;
        check(fade.distance < 0 || fade.power < 0, "fade_distance, fade_power", "below 0");
        check(own.interior->caustics < 0, "caustics", "below 0");
        check(own.interior->caustics > 0 && texture.below, "caustics", "of layered textures");
    }
    if (ior_of(own) != 1) refracts_at_ = stream_.call_place(at);
    check(is_transparent && f.interior && f.interior->ior != 1 && own.interior != own.finish_interior, "ior",
          "of a finish beside an interior");
    check(is_transparent && f.refraction != 1, "refraction", "of a finish, other than 1");
    check(is_transparent && own.is_merge, "merge", "of transparent surfaces");
    check(!is_one_finish, "layered textures",
          "that differ in more than how bright ambient and diffuse are, or whose metallic highlights have "
          "the color "
          "of the top layer: the rest of the finish is that of this layer");
    check(f.metallic < 0 || f.metallic > 1 || f.reflection_metallic < 0 || f.reflection_metallic > 1,
          "metallic", "beyond 0 and 1");
    check(f.brilliance < 0, "brilliance", "below 0");
    check(f.crand != 0, "crand", "a property of a finish");
    check(f.diffuse_back != 0, "diffuse", "of the far side");
    const bool is_mirror = largest(f.reflection_max) > 0;
    check(is_mirror && largest(f.reflection_max) > 1, "reflection", "above 1");
    // The two colors are the same but for their size.
    const double least = largest(f.reflection_min), most = largest(f.reflection_max);
    const Color a = f.reflection_min * most, b = f.reflection_max * least;
    const double apart = number::abs(a.r - b.r) + number::abs(a.g - b.g) + number::abs(a.b - b.b);
    check(is_mirror && least > 0 && apart > 1e-9, "reflection", "of two colors");
    check(is_mirror && f.reflection_exponent != 1, "reflection_exponent", "");
    check(is_mirror && texture.below && f.conserve_energy, "conserve_energy", "of layered textures");
    // POV-Ray's weight of a ray is a number, not a color: it follows such rays further (measured).
    const Color r = f.reflection_max;
    check(is_mirror && is_transparent && f.conserve_energy && !(r.r == r.g && r.g == r.b), "conserve_energy",
          "of a colored reflection");
    // A ray that is reflected totally has all light, but its weight is that of what is let through: POV-Ray
    // follows it less far (measured). Fresnel mirrors of 1 let nothing through there.
    const bool loses_weight = f.reflection_fresnel ? most > 0.25 && most < 1 : most > 0.15;
    check(loses_weight && is_transparent && f.conserve_energy && ior_of(own) != 1 && !own.is_ball,
          "conserve_energy", "with total reflection in an object");
}

}  // namespace glint::povray
