// SPDX-License-Identifier: Apache-2.0
#include "formats/gltf/materials.h"

#include <fmt/format.h>

#include "base/text.h"
#include "math/number.h"
#include "scene/ranges.h"

namespace glint::gltf {
namespace {

constexpr double k_dielectric = 0.04;  // reflected at a right angle, with an index of refraction of 1.5
constexpr double k_index = 1.5;
constexpr double k_max_shininess = 10000;
constexpr Range k_strength{0, 1e6, false, false, "a number from 0 to 1e6"};

Color limited(Color c) {
    const auto channel = [](double x) { return number::min(x, k_tint.max); };
    return {channel(c.r), channel(c.g), channel(c.b)};
}
double greatest(Color c) { return number::max(c.r, number::max(c.g, c.b)); }

}  // namespace

// Walter et al. 2007 and Karis 2013: Blinn-Phong's exponent for a roughness alpha is 2 / alpha^2 - 2, and
// with it the highlight's height is (n + 2) / 8 of f0, in units of light that a white surface reflects.
void set_reflection(Material& material, const Reflection& r) {
    const double alpha = r.roughness * r.roughness;
    const double exponent = 2 / number::max(alpha * alpha, 1e-9) - 2;
    material.shininess = number::max(0.0, number::min(exponent, k_max_shininess));
    // There are no surroundings that a metal shows, and its widest highlights have no direction: this part of
    // its light is drawn as diffuse.
    const double share = (1 + alpha) / 2;
    material.color = material.ambient = limited(r.diffuse + r.metal);
    material.diffuse = limited(r.diffuse + r.metal * share);
    const Color highlight = r.f0 * ((1 - alpha) * (material.shininess + 2) / 8);
    const double brightest = greatest(highlight);
    material.specular = brightest > 1 ? highlight * (1 / brightest) : highlight;
}

std::optional<MaterialUse> Materials::use(JsonValue primitive) {
    const bool has_vertex_colors = primitive.find("attributes").find("COLOR_0").exists();
    auto& all = known_[has_vertex_colors];
    const JsonValue value = primitive.find("material");
    std::optional<std::uint32_t> index;
    if (value.exists() && !(index = file_.index(value, List::materials))) return std::nullopt;
    Known& known = index ? all[*index] : all.back();
    if (!known.is_read) {
        known.is_read = true;
        known.use = read(index ? file_.item(List::materials, *index) : JsonValue{}, has_vertex_colors);
    }
    return known.use;
}

bool Materials::read_alpha(JsonValue at, AlphaMode& mode, double& cutoff, Material& material) {
    const JsonValue value = at.find("alphaMode");
    const std::string name = value.exists() ? value.string() : "OPAQUE";
    if (name == "MASK") {
        mode = AlphaMode::mask;
    } else if (name == "BLEND") {
        mode = AlphaMode::blend;
    } else if (name != "OPAQUE") {
        return file_.expected(value, "OPAQUE, MASK or BLEND", "alphaMode");
    }
    bool is_double_sided = false;
    if (!file_.number(at, "alphaCutoff", cutoff, k_not_negative) ||
        !file_.flag(at, "doubleSided", is_double_sided))
        return false;
    material.one_sided = !is_double_sided;
    return true;
}

bool Materials::read_metal(JsonValue at, Base& base, Material& material) {
    const JsonValue metal = at.find("pbrMetallicRoughness");
    double color[4] = {1, 1, 1, 1}, metallic = 1, roughness = 1, index = k_index, specular = 1;
    Color specular_color{1, 1, 1};
    const JsonValue specular_extension = File::extension(at, "KHR_materials_specular");
    constexpr Range index_range{0, k_index_of_refraction.max, false, false, "a number from 0 to 1e6"};
    if (!file_.numbers(metal, "baseColorFactor", color, k_tint) ||
        !file_.number(metal, "metallicFactor", metallic, k_fraction) ||
        !file_.number(metal, "roughnessFactor", roughness, k_fraction) ||
        !file_.number(File::extension(at, "KHR_materials_ior"), "ior", index, index_range) ||
        !file_.number(specular_extension, "specularFactor", specular, k_fraction) ||
        !file_.color(specular_extension, "specularColorFactor", specular_color))
        return false;
    if (const JsonValue map = metal.find("metallicRoughnessTexture"); map.exists()) {
        file_.warn_once("gltf metal map", map,
                        "glint has no maps of metal and roughness: each surface has the mean of its map");
        const std::optional<Color> mean = textures_.mean(map);
        roughness *= mean ? mean->g : 1;
        metallic *= mean ? mean->b : 0;  // without the map, a factor of 1 says nothing
    }
    base.color = {color[0], color[1], color[2]};
    base.alpha = number::min(color[3], 1.0);
    base.texture = metal.find("baseColorTexture");
    const double reflected = (index - 1) / (index + 1);
    const Color dielectric = index == k_index ? specular_color * (k_dielectric * specular)
                                              : specular_color * (reflected * reflected * specular);
    base.is_metal = metallic == 1;
    set_reflection(material, {base.reflected() * (1 - metallic), base.reflected() * metallic,
                              dielectric * (1 - metallic) + base.color * metallic, roughness});
    return true;
}

// KHR_materials_pbrSpecularGlossiness, of older files.
bool Materials::read_glossiness(JsonValue from, Base& base, Material& material) {
    double color[4] = {1, 1, 1, 1}, glossiness = 1;
    Color specular{1, 1, 1};
    if (!file_.numbers(from, "diffuseFactor", color, k_tint) ||
        !file_.number(from, "glossinessFactor", glossiness, k_fraction) ||
        !file_.color(from, "specularFactor", specular))
        return false;
    base.color = {color[0], color[1], color[2]};
    base.alpha = number::min(color[3], 1.0);
    base.texture = from.find("diffuseTexture");
    if (const JsonValue map = from.find("specularGlossinessTexture"); map.exists()) {
        specular = {k_dielectric, k_dielectric, k_dielectric};
        file_.warn_once("gltf specular map", map, "glint ignores the maps of specular color and glossiness");
    }
    const auto beyond = [](double channel) { return number::max(channel - k_dielectric, 0.0); };
    set_reflection(material, {base.reflected(),
                              {beyond(specular.r), beyond(specular.g), beyond(specular.b)},
                              specular,
                              1 - glossiness});
    return true;
}

bool Materials::read_reflection(JsonValue at, Base& base, Material& material) {
    const JsonValue glossiness = File::extension(at, "KHR_materials_pbrSpecularGlossiness");
    return glossiness.exists() ? read_glossiness(glossiness, base, material) : read_metal(at, base, material);
}

bool Materials::read_emission(JsonValue at, Material& material) {
    double strength = 1;
    Color factor{0, 0, 0};
    if (!file_.color(at, "emissiveFactor", factor) ||
        !file_.number(File::extension(at, "KHR_materials_emissive_strength"), "emissiveStrength", strength,
                      k_strength))
        return false;
    if (const JsonValue map = at.find("emissiveTexture"); map.exists() && greatest(factor) > 0) {
        file_.warn_once("gltf emissive map", map,
                        "glint ignores the maps of emission: their surfaces do not glow");
        return true;
    }
    material.emission = limited(factor * strength);
    return true;
}

// The light that passes is tinted by the color. Of a volume it is refracted.
bool Materials::read_transmission(JsonValue at, const Base& base, Material& material) {
    const JsonValue extension = File::extension(at, "KHR_materials_transmission");
    double factor = 0, index = k_index, thickness = 0;
    if (!file_.number(extension, "transmissionFactor", factor, k_fraction) ||
        !file_.number(File::extension(at, "KHR_materials_ior"), "ior", index, k_not_negative) ||
        !file_.number(File::extension(at, "KHR_materials_volume"), "thicknessFactor", thickness,
                      k_not_negative))
        return false;
    if (!(factor > 0)) return true;
    if (thickness > 0) {
        material.transmit = 0;
        material.transmission = factor;
        material.transmission_tint = limited(base.color);
        material.one_sided = false;  // refracted rays leave through the back
        material.ior = index >= 1 ? number::min(index, k_index_of_refraction.max) : 1;
    } else {
        material.filter = factor * (1 - material.transmit);
    }
    return true;
}

void Materials::warn_about_maps(JsonValue at) {
    if (const JsonValue map = at.find("normalTexture"); map.exists())
        file_.warn_once("gltf normal map", map, "glint ignores the normal maps");
    if (const JsonValue map = at.find("occlusionTexture"); map.exists())
        file_.warn_once("gltf occlusion map", map, "glint ignores the occlusion maps");
}

std::optional<MaterialUse> Materials::read(JsonValue at, bool has_vertex_colors) {
    Material material;
    MaterialUse use;
    Base base;
    base.has_vertex_colors = has_vertex_colors;
    AlphaMode mode = AlphaMode::opaque;
    double cutoff = 0.5;
    if (!read_reflection(at, base, material) || !read_alpha(at, mode, cutoff, material) ||
        !read_emission(at, material))
        return std::nullopt;
    warn_about_maps(at);
    use.factor = base.color;
    use.is_transparent = mode != AlphaMode::opaque;
    if (mode == AlphaMode::mask) {
        use.is_visible = base.alpha >= cutoff;
    } else if (mode == AlphaMode::blend) {
        material.transmit = 1 - base.alpha;
    }
    if (!read_transmission(at, base, material)) return std::nullopt;
    const bool is_unlit = File::extension(at, "KHR_materials_unlit").exists();
    if (use.is_visible && base.texture.exists()) {
        const TextureAlpha alpha = mode == AlphaMode::opaque ? TextureAlpha::ignore
                                   : mode == AlphaMode::mask ? TextureAlpha::mask
                                                             : TextureAlpha::blend;
        const double least = base.alpha > 0 ? number::min(cutoff / base.alpha, 1.0) : 0;
        // The highlights of a metal have its color. Multiplied colors leave them as they are.
        const bool tints_highlights = base.is_metal && base.color == Color{1, 1, 1} && !has_vertex_colors;
        const TextureMix mix = is_unlit           ? TextureMix::multiply_all
                               : tints_highlights ? TextureMix::replace
                                                  : TextureMix::multiply;
        const std::optional<TextureUse> texture = textures_.use(base.texture, alpha, least, mix);
        if (!texture) return std::nullopt;
        material.texture = texture->texture;
        use.has_texture = texture->texture != k_none;
        use.texture_set = texture->set;
    }
    if (is_unlit) {
        use.is_unlit = true;
        material.emission = material.color = limited(base.color);
        material.ambient = material.diffuse = material.specular = {};
    }
    Scene& scene = file_.reading.scene;
    use.material = static_cast<std::uint32_t>(scene.materials.size());
    note(scene.material_texts, use.material, at.exists() ? file_.place(at) : SourcePlace{},
         file_.string(at, "name"));
    scene.materials.push_back(material);
    return use;
}

}  // namespace glint::gltf
