// SPDX-License-Identifier: Apache-2.0
#include "formats/glint_material.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstdint>

namespace glint {
namespace {

using Keys = MaterialKeys;

constexpr SpellingHint k_hints[] = {{"reflective", "`mirror`"},
                                    {"reflection", "`mirror`"},
                                    {"reflectivity", "`mirror`"},
                                    {"reflect", "`mirror`"},
                                    {"phong", "`specular`"},
                                    {"phong_size", "`shininess`"},
                                    {"exponent", "`shininess`"},
                                    {"specular_exponent", "`shininess`"},
                                    {"shine", "`shininess`"},
                                    {"roughness", "`shininess`, the exponent: 2/roughness^2 - 2"},
                                    {"refraction", "`transmission`, and `ior`"},
                                    {"transparency", "`transmission`"},
                                    {"filter", "`transmission`"},
                                    {"transmit", "`transmission`"},
                                    {"opacity", "`transmission`, which is 1 - opacity"},
                                    {"refractive_index", "`ior`"},
                                    {"index", "`ior`"},
                                    {"colour", "`color`"},
                                    {"pigment", "`color`"},
                                    {"albedo", "`color`"},
                                    {"rgb", "`color`"}};

constexpr Range k_coefficient{0, 1e6, false, false, "a coefficient from 0 to 1e6"};

bool read_specular(GlintText& t, double& value) {
    const Token at = t.p.token();
    if (at.kind == TokenKind::number && at.number > 1) {
        t.p.error(at, fmt::format("expected a number from 0 to 1, found {}: `specular` is a coefficient; the "
                                  "exponent is called shininess",
                                  t.p.describe(at)));
        t.p.take();
        return true;
    }
    return t.p.number(value, k_fraction);
}

Color channel(const Keys& k, int absolute, Color value, int coefficient, double factor, Color otherwise) {
    if (k.has(absolute)) return value;
    return k.has(Keys::k_color) || k.has(coefficient) ? k.color * factor : otherwise;
}

// What the keys do not say is the default material's.
Material made_of(const Keys& k) {
    Material m;
    m.ambient = channel(k, Keys::k_ambient_color, k.ambient_color, Keys::k_ambient, k.ambient, m.ambient);
    m.diffuse = channel(k, Keys::k_diffuse_color, k.diffuse_color, Keys::k_diffuse, k.diffuse, m.diffuse);
    m.specular =
        channel(k, Keys::k_specular_color, k.specular_color, Keys::k_specular, k.specular, m.specular);
    if (k.has(Keys::k_color)) m.color = k.color;
    if (k.has(Keys::k_shininess)) m.shininess = k.shininess;
    if (k.has(Keys::k_mirror)) m.mirror = k.mirror;
    if (k.has(Keys::k_mirror_color)) m.mirror_tint = k.mirror_color;
    if (k.has(Keys::k_transmission)) m.transmission = k.transmission;
    if (k.has(Keys::k_transmission_color)) m.transmission_tint = k.transmission_color;
    if (k.has(Keys::k_ior)) m.ior = k.ior;
    return m;
}

// The keys that say all of a material, such as another format made.
Keys all_of(const Material& m) {
    Keys k;
    k.given = (1u << (Keys::k_ior + 1)) - 1;
    k.given &= ~(1u << Keys::k_ambient | 1u << Keys::k_diffuse | 1u << Keys::k_specular);
    k.color = m.color;
    k.ambient_color = m.ambient, k.diffuse_color = m.diffuse, k.specular_color = m.specular;
    k.shininess = m.shininess;
    k.mirror = m.mirror, k.mirror_color = m.mirror_tint;
    k.transmission = m.transmission, k.transmission_color = m.transmission_tint, k.ior = m.ior;
    return k;
}

// The keys of `over` in place of those of `k`; a coefficient replaces the absolute value too.
Keys changed_keys(Keys k, const Keys& over) {
    const auto take = [&](int key, auto Keys::*member) {
        if (over.has(key)) k.*member = over.*member;
    };
    take(Keys::k_color, &Keys::color);
    take(Keys::k_ambient, &Keys::ambient);
    take(Keys::k_diffuse, &Keys::diffuse);
    take(Keys::k_specular, &Keys::specular);
    take(Keys::k_ambient_color, &Keys::ambient_color);
    take(Keys::k_diffuse_color, &Keys::diffuse_color);
    take(Keys::k_specular_color, &Keys::specular_color);
    take(Keys::k_shininess, &Keys::shininess);
    take(Keys::k_mirror, &Keys::mirror);
    take(Keys::k_mirror_color, &Keys::mirror_color);
    take(Keys::k_transmission, &Keys::transmission);
    take(Keys::k_transmission_color, &Keys::transmission_color);
    take(Keys::k_ior, &Keys::ior);
    if (over.has(Keys::k_ambient)) k.given &= ~(1u << Keys::k_ambient_color);
    if (over.has(Keys::k_diffuse)) k.given &= ~(1u << Keys::k_diffuse_color);
    if (over.has(Keys::k_specular)) k.given &= ~(1u << Keys::k_specular_color);
    k.given |= over.given;
    return k;
}

}  // namespace

std::span<const SpellingHint> material_hints() { return k_hints; }

bool read_material_key(GlintText& t, int key, MaterialKeys& keys) {
    keys.given |= 1u << key;
    switch (key) {
        case Keys::k_color:
            return read_color(t, keys.color, k_channel, ColorUse::surface);
        case Keys::k_ambient:
            return t.p.number(keys.ambient, k_coefficient);
        case Keys::k_diffuse:
            return t.p.number(keys.diffuse, k_coefficient);
        case Keys::k_specular:
            return read_specular(t, keys.specular);
        case Keys::k_ambient_color:
            return read_color(t, keys.ambient_color, k_channel, ColorUse::coefficient);
        case Keys::k_diffuse_color:
            return read_color(t, keys.diffuse_color, k_channel, ColorUse::coefficient);
        case Keys::k_specular_color:
            return read_color(t, keys.specular_color, k_channel, ColorUse::coefficient);
        case Keys::k_shininess:
            return t.p.number(keys.shininess, k_exponent);
        case Keys::k_mirror:
            return t.p.number(keys.mirror, k_fraction);
        case Keys::k_mirror_color:
            return read_color(t, keys.mirror_color, k_tint, ColorUse::surface);
        case Keys::k_transmission:
            return t.p.number(keys.transmission, k_fraction);
        case Keys::k_transmission_color:
            return read_color(t, keys.transmission_color, k_tint, ColorUse::surface);
        default:
            return t.p.number(keys.ior, k_index_of_refraction);
    }
}

bool GlintMaterials::Less::operator()(std::uint32_t a, std::uint32_t b) const {
    using Bits = std::array<std::uint64_t, sizeof(Material) / sizeof(double)>;  // any order will do
    return std::bit_cast<Bits>((*materials)[a]) < std::bit_cast<Bits>((*materials)[b]);
}

GlintMaterials& GlintMaterials::of(LoadState& reading) {
    if (!reading.glint_materials) reading.glint_materials.reset(new GlintMaterials(reading.scene));
    return *reading.glint_materials;
}

std::uint32_t GlintMaterials::add(const GlintText& t, const Token& at, const Material& material) {
    const auto index = static_cast<std::uint32_t>(scene_.materials.size());
    scene_.materials.push_back(material);
    note(scene_.material_texts, index, source_place(t.text, at));
    return index;
}

void GlintMaterials::keep_origin(std::uint32_t index, const MaterialKeys& keys) {
    origins_.insert_or_assign(index, Origin{keys.given, keys.ambient, keys.diffuse, keys.specular});
}

MaterialKeys GlintMaterials::keys_of(std::uint32_t index) const {
    if (index == k_none) return {};
    MaterialKeys keys = all_of(scene_.materials[index]);
    if (const auto at = origins_.find(index); at != origins_.end()) {
        keys.given = at->second.given;
        keys.ambient = at->second.ambient;
        keys.diffuse = at->second.diffuse;
        keys.specular = at->second.specular;
    }
    return keys;
}

std::uint32_t GlintMaterials::named(GlintText& t, const Token& name) {
    const bool is_bare = name.kind == TokenKind::word;
    const std::string held = is_bare ? std::string() : t.p.name(name);
    const std::string_view key = is_bare ? t.p.text(name) : std::string_view(held);
    if (last_index_ != k_none && key == last_name_) return last_index_;
    auto& known = t.reading.materials;
    if (const auto at = known.find(key); at != known.end()) {
        last_index_ = at->second;
    } else if (const auto use = undefined_.find(key); use != undefined_.end()) {
        last_index_ = use->second.index;
    } else {
        last_index_ = add(t, name, {});
        undefined_.emplace(key, Use{last_index_, t.text.place, name});
        unknown_.insert(last_index_);
    }
    last_name_ = key;
    return last_index_;
}

void GlintMaterials::define(GlintText& t, const Token& word, const Token& name, const MaterialKeys& keys) {
    const std::string key = t.p.name(name);
    const SourcePlace place = source_place(t.text, word);
    if (const auto at = t.reading.materials.find(key); at != t.reading.materials.end()) {
        const SourcePlace first = scene_.material_texts.place(at->second);
        if (first == place) return;  // a file that is included twice
        const std::string in = first.file == t.text.file || first.file >= scene_.files.size()
                                   ? std::string()
                                   : fmt::format(" of {}", scene_.files[first.file]);
        return t.p.error(name, fmt::format("a second material called {}: the first is in line {}{}",
                                           quoted(key), first.line, in));
    }
    std::uint32_t index = k_none;
    if (const auto use = undefined_.find(key); use != undefined_.end()) {
        index = use->second.index;
        unknown_.erase(index);
        undefined_.erase(use);
        scene_.materials[index] = made_of(keys);
        scene_.material_texts.places[index] = place;
    } else {
        index = add(t, word, made_of(keys));
    }
    scene_.material_texts.names.emplace(index, key);
    t.reading.materials.emplace(key, index);
    keep_origin(index, keys);
}

std::uint32_t GlintMaterials::changed(GlintText& t, const Token& word, std::uint32_t base,
                                      const MaterialKeys& keys, bool is_shared) {
    if (keys.given == 0) return base;
    if (unknown_.contains(base)) {
        const std::uint32_t index = add(t, word, {});
        unknown_.insert(index);
        changes_.push_back({index, base, keys});
        return index;
    }
    const MaterialKeys all = changed_keys(keys_of(base), keys);
    const std::uint32_t index = add(t, word, made_of(all));
    if (!is_shared) {
        keep_origin(index, all);
        return index;
    }
    const auto [at, is_new] = unnamed_.insert(index);
    if (is_new) return index;
    scene_.materials.pop_back();
    scene_.material_texts.places.pop_back();
    return *at;
}

void GlintMaterials::finish(LoadState& reading) {
    std::vector<std::string_view> names;
    for (const auto& [name, index] : reading.materials) names.push_back(name);
    for (const auto& [name, use] : undefined_) {
        // A text of another format may have defined it later.
        if (const auto at = reading.materials.find(name); at != reading.materials.end()) {
            scene_.materials[use.index] = scene_.materials[at->second];
            continue;
        }
        reading.diagnostics.error(
            use.place, use.token.offset, use.token.length,
            fmt::format("no material is called {}{}", quoted(name), did_you_mean(name, names)));
    }
    for (const Change& change : changes_) {
        const MaterialKeys all = changed_keys(keys_of(change.base), change.keys);
        scene_.materials[change.index] = made_of(all);
        keep_origin(change.index, all);
    }
}

}  // namespace glint
