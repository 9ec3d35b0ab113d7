// SPDX-License-Identifier: Apache-2.0
#include "formats/glint_material.h"

#include <fmt/format.h>

#include <cstdint>

namespace glint {
namespace {

constexpr SpellingHint k_material_hints[] = {{"reflective", "`mirror`"},
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
                                             {"opacity", "`transmit`, which is 1 - opacity"},
                                             {"refractive_index", "`ior`"},
                                             {"index", "`ior`"},
                                             {"colour", "`color`"},
                                             {"pigment", "`color`"},
                                             {"albedo", "`color`"},
                                             {"rgb", "`color`"}};

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

constexpr std::size_t k_color = material_field(&Material::color);

void copy_field(std::size_t field, const Material& from, Material& to) {
    std::visit([&](const auto& member) { to.*member.at = from.*member.at; }, k_material_fields[field].member);
}

// Values without a key are those of the default material.
Material made_of(const MaterialKeys& k) {
    Material m;
    for (std::size_t i = 0; i < k_coefficients; ++i) {
        const MaterialCoefficient& coefficient = k_material_coefficients[i];
        if (k.has(i) || (k.has_field(k_color) && !coefficient.if_given))
            m.*coefficient.field = k.fields.color * k.coefficients[i];
    }
    for (std::size_t i = 0; i < std::size(k_material_fields); ++i) {
        if (k.has_field(i)) copy_field(i, k.fields, m);
    }
    return m;
}

// The keys that describe a material completely, for materials from other formats.
MaterialKeys all_of(const Material& m) {
    MaterialKeys k;
    for (std::size_t i = 0; i < std::size(k_material_fields); ++i)
        k.given |= std::uint64_t{1} << (k_coefficients + i);
    k.fields = m;
    return k;
}

// Replaces keys of `k` by those of `over`; a coefficient also replaces the absolute value.
MaterialKeys changed_keys(MaterialKeys k, const MaterialKeys& over) {
    for (std::size_t i = 0; i < std::size(k_material_fields); ++i) {
        if (over.has_field(i)) copy_field(i, over.fields, k.fields);
    }
    for (std::size_t i = 0; i < k_coefficients; ++i) {
        if (!over.has(i)) continue;
        k.coefficients[i] = over.coefficients[i];
        k.given &= ~(std::uint64_t{1} << (k_coefficients + material_field(k_material_coefficients[i].field)));
    }
    k.given |= over.given;
    return k;
}

}  // namespace

std::span<const SpellingHint> material_hints() { return k_material_hints; }

bool read_material_key(GlintText& t, int key, MaterialKeys& keys) {
    keys.given |= std::uint64_t{1} << key;
    if (key >= k_coefficients) return read_field(t, k_material_fields[key - k_coefficients], keys.fields);
    const MaterialCoefficient& coefficient = k_material_coefficients[key];
    double& value = keys.coefficients[static_cast<std::size_t>(key)];
    return coefficient.field == &Material::specular ? read_specular(t, value)
                                                    : t.p.number(value, coefficient.range);
}

bool GlintMaterials::Less::operator()(std::uint32_t a, std::uint32_t b) const {
    return less_bits((*materials)[a], (*materials)[b]);
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
    origins_.insert_or_assign(index, Origin{keys.given, keys.coefficients});
}

MaterialKeys GlintMaterials::keys_of(std::uint32_t index) const {
    if (index == k_none) return {};
    MaterialKeys keys = all_of(scene_.materials[index]);
    if (const auto at = origins_.find(index); at != origins_.end()) {
        keys.given = at->second.given;
        keys.coefficients = at->second.coefficients;
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
        if (first == place) return;  // the file is included twice
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
    if (base != k_none) bases_.insert(base);
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
    scene_.base_materials.assign(bases_.begin(), bases_.end());
    for (const Change& change : changes_) {
        const MaterialKeys all = changed_keys(keys_of(change.base), change.keys);
        scene_.materials[change.index] = made_of(all);
        keep_origin(change.index, all);
    }
}

}  // namespace glint
