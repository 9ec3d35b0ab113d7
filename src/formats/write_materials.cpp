// SPDX-License-Identifier: Apache-2.0
#include "formats/write_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <set>

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

MaterialPlan::MaterialPlan(const Scene& scene) {
    merge_unnamed(scene);
    std::vector<std::uint32_t> uses(scene.materials.size());
    for (const Shape& shape : scene.shapes) {
        if (shape.material != k_none) ++uses[written_[shape.material]];
    }
    choose_names(scene, uses);
}

// Sorts, so that no choice of materials makes it slow.
void MaterialPlan::merge_unnamed(const Scene& scene) {
    std::vector<std::uint32_t> unnamed;
    written_.resize(scene.materials.size());
    for (std::uint32_t i = 0; i < written_.size(); ++i) {
        written_[i] = i;
        if (scene.material_texts.name(i).empty()) unnamed.push_back(i);
    }
    std::stable_sort(unnamed.begin(), unnamed.end(), [&](std::uint32_t a, std::uint32_t b) {
        return less_bits(scene.materials[a], scene.materials[b]);
    });
    for (std::size_t i = 1; i < unnamed.size(); ++i) {
        const std::uint32_t before = unnamed[i - 1], after = unnamed[i];
        if (same_bits(scene.materials[before], scene.materials[after])) written_[after] = written_[before];
    }
}

// If several materials have the same name, the first one that is used by a shape keeps it.
void MaterialPlan::choose_names(const Scene& scene, const std::vector<std::uint32_t>& uses) {
    named_.resize(uses.size());
    std::set<std::string, std::less<>> taken;
    const auto set_name = [&](std::uint32_t i, std::string text) {
        names_.push_back(std::move(text));
        named_[i] = static_cast<std::uint32_t>(names_.size());
    };
    for (const bool used : {true, false}) {
        for (std::uint32_t i = 0; i < uses.size(); ++i) {
            const auto own = scene.material_texts.name(i);
            if (own.empty() || (uses[i] > 0) != used) continue;
            if (taken.emplace(own).second) set_name(i, std::string(own));
        }
    }
    std::size_t number = 0;
    for (std::uint32_t i = 0; i < uses.size(); ++i) {
        if (named_[i] != 0 || uses[i] < 2) continue;
        std::string text;
        do {
            text = fmt::format("material_{}", ++number);
        } while (!taken.insert(text).second);
        set_name(i, std::move(text));
    }
}

std::string_view MaterialPlan::name(std::uint32_t material) const {
    const std::uint32_t named = named_[written_[material]];
    return named == 0 ? std::string_view() : std::string_view(names_[named - 1]);
}

void write_material_keys(BlockWriter& block, const Material& m) {
    const Material usual;
    for (const ItemField<Material>& field : k_material_fields) {
        const MaterialCoefficient* coefficient = coefficient_of(field);
        if (coefficient != nullptr && !(coefficient->if_given && same_bits(field, m, usual))) {
            write_term(block, m.color, m.*coefficient->field, *coefficient, field.key);
        } else if (is_field_of(field, &Material::color) || !same_bits(field, m, usual)) {
            write_field(block, field, m);
        }
    }
}

}  // namespace glint
