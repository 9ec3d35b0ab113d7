// SPDX-License-Identifier: Apache-2.0
#include "formats/write_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "base/sort_stably.h"
#include "scene/material_color.h"
#include "scene/material_fields.h"

namespace glint {
namespace {

void write_term(BlockWriter& block, Color color, Color k, const MaterialCoefficient& coefficient,
                std::string_view absolute_key) {
    std::string absolute, relative;
    append(absolute, k);
    const auto c = find_coefficient(color, k);
    if (c) append(relative, *c);
    // A coefficient with many digits was not chosen by the author.
    if (c && relative.size() <= absolute.size()) {
        block.key(coefficient.key) += relative;
    } else {
        block.key(absolute_key) += absolute;
    }
}

}  // namespace

bool same_bits(const Material& a, const Material& b) {
    return std::all_of(std::begin(k_material_fields), std::end(k_material_fields),
                       [&](const ItemField<Material>& field) { return same_bits(field, a, b); });
}

MaterialPlan::MaterialPlan(const Scene& scene) : named_(scene.materials.size()) {
    use_own_names(scene);
    merge_unnamed(scene);
    name_shared(scene);
    name_textures(scene);
}

// If several materials have the same name, the first one that is used by a shape keeps it.
void MaterialPlan::use_own_names(const Scene& scene) {
    std::vector<bool> is_used(scene.materials.size());
    for (const Shape& shape : scene.shapes) {
        if (shape.material != k_none) is_used[shape.material] = true;
        for (const Shape& operand : operands_of(scene, shape)) {
            if (operand.material != k_none) is_used[operand.material] = true;
        }
    }
    for (const bool used : {true, false}) {
        for (std::uint32_t i = 0; i < named_.size(); ++i) {
            const auto own = scene.material_texts.name(i);
            if (own.empty() || is_used[i] != used || !taken_.emplace(own).second) continue;
            names_.emplace_back(own);
            named_[i] = static_cast<std::uint32_t>(names_.size());
        }
    }
}

// Sorts, so that no choice of materials makes it slow.
void MaterialPlan::merge_unnamed(const Scene& scene) {
    std::vector<std::uint32_t> unnamed;
    written_.resize(scene.materials.size());
    for (std::uint32_t i = 0; i < written_.size(); ++i) {
        written_[i] = i;
        if (named_[i] == 0) unnamed.push_back(i);
    }
    sort_stably(unnamed, [&](std::uint32_t a, std::uint32_t b) {
        return less_bits(scene.materials[a], scene.materials[b]);
    });
    for (std::size_t i = 1; i < unnamed.size(); ++i) {
        const std::uint32_t before = unnamed[i - 1], after = unnamed[i];
        if (same_bits(scene.materials[before], scene.materials[after])) written_[after] = written_[before];
    }
}

// Materials without a name that several shapes have get one, and those of operands: without any, an operand
// has its solid's.
void MaterialPlan::name_shared(const Scene& scene) {
    std::vector<std::uint32_t> uses(scene.materials.size());
    for (const Shape& shape : scene.shapes) {
        if (shape.material != k_none) ++uses[written_[shape.material]];
        for (const Shape& operand : operands_of(scene, shape)) {
            if (operand.material != k_none) uses[written_[operand.material]] += 2;
        }
    }
    std::size_t number = 0;
    for (std::uint32_t i = 0; i < uses.size(); ++i) {
        if (named_[i] != 0 || uses[i] < 2) continue;
        std::string text;
        do {
            text = fmt::format("material_{}", ++number);
        } while (!taken_.insert(text).second);
        names_.push_back(std::move(text));
        named_[i] = static_cast<std::uint32_t>(names_.size());
    }
}

void MaterialPlan::name_textures(const Scene& scene) {
    std::set<std::string, std::less<>> taken;
    std::size_t number = 0;
    for (std::uint32_t i = 0; i < scene.textures.size(); ++i) {
        std::string name(scene.texture_texts.name(i));
        while (name.empty() || taken.contains(name)) name = fmt::format("texture_{}", ++number);
        taken.insert(name);
        texture_names_.push_back(std::move(name));
    }
}

std::string_view MaterialPlan::name(std::uint32_t material) const {
    const std::uint32_t named = named_[written_[material]];
    return named == 0 ? std::string_view() : std::string_view(names_[named - 1]);
}

void write_material_keys(BlockWriter& block, const MaterialPlan& plan, const Material& m) {
    const Material usual;
    for (const ItemField<Material>& field : k_material_fields) {
        const MaterialCoefficient* coefficient = coefficient_of(field);
        if (coefficient != nullptr && !(coefficient->if_given && same_bits(field, m, usual))) {
            write_term(block, m.color, m.*coefficient->field, *coefficient, field.key);
        } else if (is_field_of(field, &Material::texture)) {
            if (m.texture != k_none) append_name(block.key(field.key), plan.texture_name(m.texture));
        } else if (is_field_of(field, &Material::color) || !same_bits(field, m, usual)) {
            write_field(block, field, m);
        }
    }
}

}  // namespace glint
