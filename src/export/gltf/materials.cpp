// SPDX-License-Identifier: Apache-2.0
#include "export/gltf/materials.h"

#include "export/gltf/reflection.h"
#include "math/number.h"

namespace glint::gltf_export {
namespace {

constexpr double k_dielectric = 0.04;  // reflected at a right angle, with an index of refraction of 1.5
constexpr double k_index = 1.5;

Json to_json(Color c) { return {c.r, c.g, c.b}; }

// Whether it only emits its color, as materials of KHR_materials_unlit are read.
bool is_unlit(const Material& m) {
    const Color black{};
    return m.emission != black && m.color == m.emission && greatest(m.emission) <= 1 && m.ambient == black &&
           m.diffuse == black && m.specular == black && m.mirror == 0 && m.transmission == 0 && m.filter == 0;
}

bool has_finish(const Material& m) {
    return m.brilliance != 1 || m.metallic != 0 || m.phong != Color{} || !m.tinted_highlight ||
           m.angled_opacity || m.outline != 0 || (m.mirror > 0 && m.has_angled_mirror()) ||
           (m.mirror > 0 && m.conserve_energy);
}

double along_normal(double index) {
    const double reflected = (index - 1) / (index + 1);
    return reflected * reflected;
}

double mirror_of(const Material& m) {
    if (!m.has_angled_mirror()) return m.mirror;
    return m.mirror_min + (m.mirror_fresnel ? (m.mirror - m.mirror_min) * along_normal(m.ior) : 0);
}

// A mirror of half the light or more is a metal, which programs show best. A weaker one is what a
// dielectric reflects at a right angle: its own color is seen beside it.
MetalRoughness mirror_as_metal(const Material& m, double mirror, MirrorRule rule) {
    MetalRoughness to{m.diffuse, 0, m.specular == Color{} ? 0 : roughness_of(m.shininess), {}, true};
    if (mirror < 0.5) {
        to.specular = m.mirror_tint * (mirror / k_dielectric);
    } else {
        to.base = m.diffuse * (rule == MirrorRule::blend ? 1 - mirror : 1) + m.mirror_tint * mirror;
        to.metallic = mirror;
    }
    return to;
}

double dielectric_of(const Material& m) {
    if (!(m.transmission > 0) || m.ior == k_index) return k_dielectric;
    return along_normal(m.ior);
}

}  // namespace

Color MaterialList::limited(Color c) {
    if (greatest(c) > 1) losses_.add("surfaces that reflect more than all light", "the rest is left out");
    const auto channel = [](double x) { return number::max(0.0, number::min(x, 1.0)); };
    return {channel(c.r), channel(c.g), channel(c.b)};
}

const Texture* MaterialList::texture(std::uint32_t material) const {
    if (material == k_none || scene_.materials[material].texture == k_none) return nullptr;
    return &scene_.textures[scene_.materials[material].texture];
}

const MaterialList::Item& MaterialList::item_of(const MaterialUse& use) {
    const Color c = use.color.value_or(Color{});
    const Key key{use.material, use.color.has_value(), c.r, c.g, c.b, use.is_textured, use.is_white};
    const auto [known, is_new] = items_.try_emplace(key);
    if (is_new) known->second = write(use);
    return known->second;
}

std::uint32_t MaterialList::use(const MaterialUse& use) { return item_of(use).number; }

// Colors of vertices replace the material's, and so do those of a texture with TextureMix::replace; glTF
// multiplies both, so that the material is white.
Material MaterialList::colored(const MaterialUse& use) const {
    Material m = use.material == k_none ? Material{} : scene_.materials[use.material];
    const Texture* const texture = use.is_textured ? this->texture(use.material) : nullptr;
    if (use.is_white || (texture != nullptr && texture->mix == TextureMix::replace)) {
        m = with_color(m, {1, 1, 1});
    } else if (use.color) {
        m = with_color(m, *use.color);
    }
    return rule_.linear(m);
}

void MaterialList::warn(const Material& m) {
    if (m.mirror > 0 && !(m.transmission > 0))
        losses_.add("mirrors",
                    "they are metal or reflect at a right angle, which glint reads without what they show");
    if (has_finish(m)) {
        losses_.add("`brilliance`, `metallic`, `phong`, `outline` and the like of finishes",
                    "they are left out");
    }
    if (m.refracts)
        losses_.add("refraction of `filter` and `transmit` (`refracts`)", "rays go straight through");
    if (m.fade_distance > 0) losses_.add("light lost in shapes (`fade_distance`)", "they are clear");
    if (m.caustics > 0) losses_.add("light that shapes concentrate (`caustics`)", "it is left out");
    if (!m.casts_shadow) losses_.add("surfaces without shadows", "they have shadows");
}

void MaterialList::write_alpha(const Material& m, const Texture* texture, Json& to) {
    const bool is_masked = texture != nullptr && texture->has_alpha() && texture->alpha == TextureAlpha::mask;
    if (is_masked && m.transmit > 0)
        losses_.add("transparency of materials whose texture has a mask", "the mask is kept");
    if (is_masked) {
        to["alphaMode"] = "MASK";
        to["alphaCutoff"] = texture->alpha_cutoff;
    } else if (m.transmit > 0 || (texture != nullptr && texture->has_alpha())) {
        to["alphaMode"] = "BLEND";
    }
}

void MaterialList::write_transmission(const Material& m, Json& extensions) {
    const double factor = m.transmission > 0 ? m.transmission
                          : m.transmit < 1   ? number::min(m.filter / (1 - m.transmit), 1.0)
                                             : 0;
    if (!(factor > 0)) return;
    extensions["KHR_materials_transmission"] = {{"transmissionFactor", factor}};
    if (!(m.transmission > 0)) return;
    extensions["KHR_materials_volume"] = {{"thicknessFactor", 1}};
    if (m.ior == k_index) return;
    const bool is_allowed = m.ior >= 1;
    if (!is_allowed) losses_.add("indices of refraction below 1", "they are written as 1");
    extensions["KHR_materials_ior"] = {{"ior", is_allowed ? m.ior : 1}};
}

void MaterialList::write_emission(const Material& m, Json& to, Json& extensions) {
    const double strength = greatest(m.emission);
    if (!(strength > 0)) return;
    const auto channel = [&](double x) { return number::max(x, 0.0) / number::max(strength, 1.0); };
    to["emissiveFactor"] = {channel(m.emission.r), channel(m.emission.g), channel(m.emission.b)};
    if (strength > 1) extensions["KHR_materials_emissive_strength"] = {{"emissiveStrength", strength}};
}

MaterialList::Item MaterialList::write(const MaterialUse& use) {
    const Material m = colored(use);
    const Texture* const texture = use.is_textured ? this->texture(use.material) : nullptr;
    warn(m);
    Json to = Json::object(), extensions = Json::object();
    if (use.material != k_none) {
        if (const std::string_view name = scene_.material_texts.name(use.material); !name.empty())
            to["name"] = std::string(name);
    }
    const bool colors_emission = texture != nullptr && texture->mix == TextureMix::multiply_all;
    const bool unlit = is_unlit(m) && (texture == nullptr || colors_emission);
    MetalRoughness found = metal_roughness(m, dielectric_of(m));
    if (unlit) {
        found = {m.emission, 0, 1, {}, true};
        extensions["KHR_materials_unlit"] = Json::object();
    } else if (m.transmission > 0) {
        found.base = m.transmission_tint;
        found.metallic = 0;
    } else if (m.filter > 0) {
        found.base = m.color;
    } else if (const double mirror = mirror_of(m); mirror > 0) {
        found = mirror_as_metal(m, mirror, scene_.conventions.mirror);
    }
    if (!found.is_exact) {
        losses_.add("highlights with an exponent of 0 or above 10000, or brighter than the light",
                    "they are the nearest that it has");
    }
    Item item;
    item.color = m.color;
    Json base = to_json(limited(found.base));
    base.push_back(1 - m.transmit);
    Json metal{{"baseColorFactor", std::move(base)},
               {"metallicFactor", found.metallic},
               {"roughnessFactor", found.roughness}};
    if (texture != nullptr) {
        const std::uint32_t number = scene_.materials[use.material].texture;
        if (const Json info = textures_.info(number); !info.is_null()) {
            metal["baseColorTexture"] = info;
            if (colors_emission && !unlit && greatest(m.emission) > 0) to["emissiveTexture"] = info;
        }
    }
    to["pbrMetallicRoughness"] = std::move(metal);
    write_alpha(m, texture, to);
    if (!unlit) {
        write_emission(m, to, extensions);
        write_transmission(m, extensions);
    }
    if (found.specular) {
        extensions["KHR_materials_specular"] = {{"specularColorFactor", to_json(*found.specular)}};
    }
    // What encloses a volume has to have one side in glTF.
    if (!m.one_sided && !(m.transmission > 0)) to["doubleSided"] = true;
    for (const auto& [name, value] : extensions.items()) file_.use_extension(name);
    if (!extensions.empty()) to["extensions"] = std::move(extensions);
    item.number = file_.add(List::materials, to);
    return item;
}

}  // namespace glint::gltf_export
