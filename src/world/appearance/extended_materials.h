// SPDX-License-Identifier: Apache-2.0
#pragma once
// The second table of materials: the fields of Material that few scenes use. A World has it only if one of
// its materials needs it (WorldParts::extended). A new field needs a row in scene/material_fields.h, and the
// stages that use it.
#include <cstdint>

#include "scene/material_fields.h"

namespace glint {

constexpr int count_numbers(const ItemField<Material>& field) {
    int numbers = 0;
    visit_field(field, Material{}, [&](const auto&, const auto& value) {
        numbers = static_cast<int>(numbers_of(value).size());
    });
    return numbers;
}

/// The number of doubles in a row of the table.
inline constexpr int k_extended_values = [] {
    int sum = 0;
    for (const ItemField<Material>& field : k_extended_fields) sum += count_numbers(field);
    return sum;
}();

/// The index of a field's first number in a row, as in k_extended_value<&Material::emission>.
template <auto Member>
inline constexpr int k_extended_value = [] {
    int sum = 0;
    for (const ItemField<Material>& field : k_extended_fields) {
        if (is_field_of(field, Member)) break;
        sum += count_numbers(field);
    }
    return sum;
}();

/// A set of extended fields, one bit each.
using ExtendedFields = std::uint64_t;
template <auto Member>
inline constexpr ExtendedFields k_extended_field =
    ExtendedFields{1} << (material_field(Member) - k_first_extended_field);
static_assert(k_extended_fields.size() <= 64);

/// The fields in which the material differs from the default Material.
ExtendedFields extended_fields_of(const Material& material);
/// Writes one row of the table.
void pack_extended(const Material& material, double* row);

}  // namespace glint
