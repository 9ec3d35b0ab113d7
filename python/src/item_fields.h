// SPDX-License-Identifier: Apache-2.0
#pragma once
/// Attributes of Python objects from the tables of fields (src/scene/*_fields.h).
#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "base/text.h"
#include "items.h"
#include "scene/fields.h"

namespace glint::python {

/// The table of an Item. Each file that binds one specialises it.
template <class Item> std::span<const ItemField<Item>> fields_of();

/// The value of a field from Python.
inline Vec3 from_python(const PointType&, const py::handle& value, std::string_view name) {
    return to_point(value, name);
}
inline Vec3 from_python(const DirectionType&, const py::handle& value, std::string_view name) {
    return to_direction(value, name);
}
inline double from_python(const NumberType& type, const py::handle& value, std::string_view name) {
    return to_number(value, name, type.range);
}
inline std::int32_t from_python(const WholeType& type, const py::handle& value, std::string_view name) {
    const double number = to_number(value, name, type.range);
    const auto whole = static_cast<std::int32_t>(number);
    if (whole == number) return whole;
    throw py::value_error(fmt::format("{}: expected {}, found {}", name, type.range.text, repr_of(value)));
}
/// Python's materials refer to an object instead: materials.cpp sets it.
inline std::uint32_t from_python(const TextureType&, const py::handle& value, std::string_view name) {
    throw py::type_error(fmt::format("{}: expected a Texture or None, found {}", name, repr_of(value)));
}
UvMap from_python(const UvMapType&, const py::handle& value, std::string_view name);
/// Two tuples of three numbers.
py::object to_python(const UvMap& map);
template <class Choice>
Choice from_python(const ChoiceType& type, const py::handle& value, std::string_view name) {
    const std::string word = py::isinstance<py::str>(value) ? value.cast<std::string>() : std::string();
    const auto at = std::find(type.words.begin(), type.words.end(), word);
    if (at != type.words.end()) return static_cast<Choice>(at - type.words.begin());
    throw py::value_error(
        fmt::format("{}: expected one of {}, found {}", name, fmt::join(type.words, ", "), repr_of(value)));
}
inline bool from_python(const BoolType&, const py::handle& value, std::string_view name) {
    if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
    throw py::value_error(fmt::format("{}: expected True or False, found {}", name, repr_of(value)));
}
inline Color from_python(const ColorType& type, const py::handle& value, std::string_view name) {
    return to_color(value, name, type.range);
}
inline Attenuation from_python(const AttenuationType&, const py::handle& value, std::string_view name) {
    return to_attenuation(value, name);
}

template <class Item> py::object get_field(const ItemField<Item>& field, const Item& item) {
    return std::visit(
        [&](const auto& member) -> py::object {
            const auto& value = item.*member.at;
            if constexpr (requires { member.type.words; }) {
                return py::str(std::string(member.type.words[static_cast<std::size_t>(value)]));
            } else if constexpr (requires { value.has_value(); }) {
                if (!value) return py::none();
                return to_python(*value);
            } else {
                return to_python(value);
            }
        },
        field.member);
}

/// In materials, a number for ambient, diffuse or specular is a factor of the color, as in the scene
/// language.
void set_field(const ItemField<Material>& field, Material& material, const py::handle& value);

template <class Item> void set_field(const ItemField<Item>& field, Item& item, const py::handle& value) {
    std::visit(
        [&](const auto& member) {
            auto& to = item.*member.at;
            if constexpr (requires { to.has_value(); }) {
                if (value.is_none()) {
                    to.reset();
                    return;
                }
            }
            if constexpr (requires { member.type.words; }) {
                to = from_python<std::remove_cvref_t<decltype(to)>>(member.type, value, field.name);
            } else {
                to = from_python(member.type, value, field.name);
            }
        },
        field.member);
}

template <class Item> bool same_fields(const Item& a, const Item& b) {
    const auto fields = fields_of<Item>();
    return std::all_of(fields.begin(), fields.end(),
                       [&](const ItemField<Item>& field) { return same_bits(field, a, b); });
}

/// "name=value" of each field that differs from the default.
template <class Item>
std::string changed_fields(const Item& item, const Item& usual, const std::string& name = {}) {
    std::string text = name.empty() ? "" : "name=" + repr_of(py::str(name));
    for (const ItemField<Item>& field : fields_of<Item>()) {
        if (same_bits(field, item, usual) || !applies(field, item)) continue;
        const py::object value = get_field(field, item);
        const bool is_word = py::isinstance<py::str>(value);
        text += fmt::format("{}{}={}", text.empty() ? "" : ", ", field.name,
                            is_word ? repr_of(value) : py::str(value).template cast<std::string>());
    }
    return text;
}

/// "Position of the light. ..." for Python's help().
template <class Item> std::string docstring(const ItemField<Item>& field) {
    const auto type = std::visit(
        [](const auto& member) {
            const auto& t = member.type;
            if constexpr (requires { t.range; }) {
                return fmt::format("{}: {}", t.word, t.range.text);
            } else if constexpr (requires { t.words; }) {
                return fmt::format("{}", fmt::join(t.words, ", "));
            } else {
                return std::string(t.word);
            }
        },
        field.member);
    return fmt::format("{} ({})", field.description, type);
}

/// Property or method, the owner's value first.
template <class Item, class Class, class Owner> void bind_fields(Class& cls, Item Owner::*value) {
    for (const ItemField<Item>& field : fields_of<Item>()) {
        cls.def_property(
            std::string(field.name).c_str(),
            [&field, value](const Owner& owner) { return get_field(field, owner.*value); },
            [&field, value](Owner& owner, const py::object& to) { set_field(field, owner.*value, to); },
            docstring(field).c_str());
    }
}

/// Sets the fields that the keywords name. `others`: keywords that the caller sets itself.
template <class Item>
void set_fields(Item& item, const py::kwargs& keywords, std::string_view class_name,
                std::span<const std::string_view> others = {}) {
    for (const auto& [key, value] : keywords) {
        const std::string name = py::str(key);
        if (std::find(others.begin(), others.end(), name) != others.end()) continue;
        const auto fields = fields_of<Item>();
        const auto field = std::find_if(fields.begin(), fields.end(),
                                        [&](const ItemField<Item>& f) { return f.name == name; });
        if (field == fields.end()) {
            std::vector<std::string_view> known(others.begin(), others.end());
            for (const ItemField<Item>& f : fields) known.push_back(f.name);
            throw py::type_error(
                fmt::format("{} has no attribute '{}'{}", class_name, name, did_you_mean(name, known)));
        }
        set_field(*field, item, value);
    }
}

inline double largest(const Color& c) { return std::max({c.r, c.g, c.b}); }

inline std::string name_in(const py::kwargs& keywords) {
    return keywords.contains("name") ? keywords["name"].cast<std::string>() : std::string();
}

/// copy.copy and copy.deepcopy.
template <class Class, class T> void bind_copies(Class& cls, T (*copy)(const T&)) {
    cls.def("__copy__", [copy](const T& self) { return std::make_shared<T>(copy(self)); });
    cls.def(
        "__deepcopy__", [copy](const T& self, const py::dict&) { return std::make_shared<T>(copy(self)); },
        py::arg("memo"));
}

}  // namespace glint::python
