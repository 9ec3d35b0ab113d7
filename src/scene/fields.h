// SPDX-License-Identifier: Apache-2.0
#pragma once
// The fields of lights, materials and cameras: one row each, in light_fields.h, material_fields.h and
// camera_fields.h. The reader and the writer of .glint, validate(), `glint info`, the JSON of explanations,
// the page's controls and the tests of docs/formats/glint.md use these rows.
#include <array>
#include <bit>
#include <compare>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>

#include "glint/scene.h"
#include "scene/ranges.h"

namespace glint {

/// The use of a color. It decides from which channel value on a warning asks whether the numbers are bytes.
enum class ColorUse : std::uint8_t { surface, coefficient, light };

// The types of fields. A visitor must have a function for each, or it does not compile.

struct NumberType {
    static constexpr std::string_view word = "number";
    Range range;
};
/// A whole number. The range is one of whole numbers.
struct WholeType {
    static constexpr std::string_view word = "whole";
    Range range;
};
/// One of the words; the value is an enumerator, whose number is that of its word.
struct ChoiceType {
    static constexpr std::string_view word = "choice";
    std::span<const std::string_view> words;
};
/// The number of an item of the scene; k_none: none.
struct TextureType {
    static constexpr std::string_view word = "texture";
};
struct UvMapType {
    static constexpr std::string_view word = "uv map";
};
struct BoolType {
    static constexpr std::string_view word = "boolean";
};
struct PointType {
    static constexpr std::string_view word = "point";
};
/// Any length but 0.
struct DirectionType {
    static constexpr std::string_view word = "direction";
};
struct ColorType {
    static constexpr std::string_view word = "color";
    Range range;  ///< of each channel
    ColorUse use;
};
/// Each coefficient in k_attenuation, and one of them above 0.
struct AttenuationType {
    static constexpr std::string_view word = "attenuation";
};

/// The member that holds the value, and its type.
template <class Item, class Value, class Type> struct FieldMember {
    Value Item::*at;
    Type type;
};
/// The types of an Item's fields. Items with further types specialise this next to their fields.
template <class Item> struct FieldMembers {
    using Any = std::variant<FieldMember<Item, double, NumberType>, FieldMember<Item, Vec3, PointType>,
                             FieldMember<Item, Vec3, DirectionType>, FieldMember<Item, Color, ColorType>>;
};

/// A field of an Item (Light, Material, Camera, CameraFrame). Its default is that of Item{}.
template <class Item> struct ItemField {
    std::string_view key;    ///< in .glint: "mirror_color"
    std::string_view name;   ///< in C++ and JSON: "mirror_tint"
    std::string_view label;  ///< in messages and on the page: "mirror tint"
    typename FieldMembers<Item>::Any member;
    std::string_view description;  ///< one line for the documentation: meaning and unit

    bool (Item::*applies)() const = nullptr;  ///< whether the item uses the value; nullptr: always
    bool required = false;                    ///< where it applies, .glint must give it
    std::string_view other_key = {};          ///< a second key in .glint
    std::string_view phrase = {};             ///< before the value in `glint info`: "at"; empty: the label
    std::string_view otherwise =
        {};  ///< the value in .glint of a field that is not given; empty: the default
};

template <class Item> constexpr auto number_field(double Item::*at, const Range& range) {
    return FieldMember<Item, double, NumberType>{at, {range}};
}
template <class Item> constexpr auto whole_field(std::int32_t Item::*at, const Range& range) {
    return FieldMember<Item, std::int32_t, WholeType>{at, {range}};
}
template <class Item> constexpr auto bool_field(bool Item::*at) {
    return FieldMember<Item, bool, BoolType>{at, {}};
}
template <class Item, class Choice>
constexpr auto choice_field(Choice Item::*at, std::span<const std::string_view> words) {
    return FieldMember<Item, Choice, ChoiceType>{at, {words}};
}
template <class Item> constexpr auto texture_field(std::uint32_t Item::*at) {
    return FieldMember<Item, std::uint32_t, TextureType>{at, {}};
}
template <class Item> constexpr auto uv_map_field(UvMap Item::*at) {
    return FieldMember<Item, UvMap, UvMapType>{at, {}};
}
template <class Item, class Point> constexpr auto point_field(Point Item::*at) {
    return FieldMember<Item, Point, PointType>{at, {}};
}
template <class Item> constexpr auto direction_field(Vec3 Item::*at) {
    return FieldMember<Item, Vec3, DirectionType>{at, {}};
}
template <class Item> constexpr auto color_field(Color Item::*at, const Range& range, ColorUse use) {
    return FieldMember<Item, Color, ColorType>{at, {range, use}};
}
template <class Item> constexpr auto attenuation_field(Attenuation Item::*at) {
    return FieldMember<Item, Attenuation, AttenuationType>{at, {}};
}

/// Calls visit(type, value) with the item's value, and returns its result.
template <class Item, class Visit>
constexpr decltype(auto) visit_field(const ItemField<Item>& field, Item& item, Visit&& visit) {
    return std::visit(
        [&](const auto& member) -> decltype(auto) { return visit(member.type, item.*member.at); },
        field.member);
}
/// The same for a const item. visit() is not called for an absent value.
template <class Item, class Visit>
constexpr void visit_field(const ItemField<Item>& field, const Item& item, Visit&& visit) {
    std::visit(
        [&](const auto& member) {
            const auto& value = item.*member.at;
            if constexpr (requires { value.has_value(); }) {
                if (value) visit(member.type, *value);
            } else {
                visit(member.type, value);
            }
        },
        field.member);
}

template <class Item> constexpr bool applies(const ItemField<Item>& field, const Item& item) {
    return field.applies == nullptr || (item.*field.applies)();
}

/// Whether it is the field of this member, as in is_field_of(row, &Light::color).
template <class Item, class Value>
constexpr bool is_field_of(const ItemField<Item>& field, Value Item::*member) {
    return std::visit(
        [&](const auto& row) {
            if constexpr (std::same_as<std::remove_cvref_t<decltype(row.at)>, Value Item::*>) {
                return row.at == member;
            } else {
                return false;
            }
        },
        field.member);
}

constexpr std::array<double, 1> numbers_of(double x) { return {x}; }
constexpr std::array<double, 1> numbers_of(std::int32_t n) { return {static_cast<double>(n)}; }
constexpr std::array<double, 1> numbers_of(std::uint32_t n) { return {static_cast<double>(n)}; }
constexpr std::array<double, 1> numbers_of(bool b) { return {b ? 1.0 : 0.0}; }
constexpr std::array<double, 3> numbers_of(const Vec3& v) { return {v.x, v.y, v.z}; }
constexpr std::array<double, 3> numbers_of(const Color& c) { return {c.r, c.g, c.b}; }
constexpr std::array<double, 3> numbers_of(const Attenuation& a) { return {a.c0, a.c1, a.c2}; }

constexpr std::array<double, 6> numbers_of(const UvMap& map) {
    const auto& m = map.m;
    return {m[0][0], m[0][1], m[0][2], m[1][0], m[1][1], m[1][2]};
}
template <class Choice>
requires std::is_enum_v<Choice>
constexpr std::array<double, 1> numbers_of(Choice choice) { return {static_cast<double>(choice)}; }

/// True if two values have the same bits.
template <class Value> constexpr bool same_bits(const Value& a, const Value& b) {
    using Bits = std::array<std::uint64_t, numbers_of(Value{}).size()>;
    return std::bit_cast<Bits>(numbers_of(a)) == std::bit_cast<Bits>(numbers_of(b));
}

/// Calls visit with the bits of each number of a field.
template <class Item, class Visit>
constexpr void visit_bits(const ItemField<Item>& field, const Item& item, Visit&& visit) {
    visit_field(field, item, [&](const auto&, const auto& value) {
        for (const double x : numbers_of(value)) visit(std::bit_cast<std::uint64_t>(x));
    });
}

/// The order of the field's bits in two items.
template <class Item>
constexpr std::strong_ordering compare_bits(const ItemField<Item>& field, const Item& a, const Item& b) {
    std::array<std::uint64_t, 6> of_a{}, of_b{};
    std::size_t n = 0, m = 0;
    visit_bits(field, a, [&](std::uint64_t bits) { of_a[n++] = bits; });
    visit_bits(field, b, [&](std::uint64_t bits) { of_b[m++] = bits; });
    if (n != m) return n <=> m;
    if (of_a == of_b) return std::strong_ordering::equal;
    return of_a < of_b ? std::strong_ordering::less : std::strong_ordering::greater;
}
/// True if the field has the same bits in both items.
template <class Item> constexpr bool same_bits(const ItemField<Item>& field, const Item& a, const Item& b) {
    return std::is_eq(compare_bits(field, a, b));
}

/// The value as a number, a word, true or false, or as a list of numbers; null if it is absent. Json: the
/// JSON library's, which this module does not include.
template <class Json, class Item> Json field_json(const ItemField<Item>& field, const Item& item) {
    Json json;
    visit_field(field, item, [&](const auto& type, const auto& value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        using Type = std::remove_cvref_t<decltype(type)>;
        if constexpr (std::is_same_v<Type, TextureType>) {
            if (value != k_none) json = value;
        } else if constexpr (std::is_same_v<Type, ChoiceType>) {
            json = type.words[static_cast<std::size_t>(value)];
        } else if constexpr (std::is_arithmetic_v<Value>) {
            json = value;
        } else {
            json = numbers_of(value);
        }
    });
    return json;
}

}  // namespace glint
