// SPDX-License-Identifier: Apache-2.0
// The tables of docs/formats/glint.md and docs/conventions.md against the tables of fields and settings.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>

#include "glint/load.h"
#include "scene/camera_fields.h"
#include "scene/fog_fields.h"
#include "scene/light_fields.h"
#include "scene/material_fields.h"
#include "scene/sky_fields.h"
#include "scene/texture_fields.h"

namespace glint::test {
namespace {

std::string read_document(const std::string& name) {
    std::ifstream file(GLINT_SOURCE_DIR "/docs/" + name);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// The rows of the tables below a heading, without the headings of the tables.
std::vector<std::string> rows_below(const std::string& document, const std::string& heading) {
    const std::size_t begin = document.find("\n## " + heading + "\n");
    if (begin == std::string::npos) return {};
    const std::string section = document.substr(begin, document.find("\n## ", begin + 4) - begin);
    std::vector<std::string> rows;
    std::istringstream lines(section);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("|---")) rows.pop_back();  // the line before it is the table's heading
        if (line.starts_with("| ")) rows.push_back(line);
    }
    return rows;
}

std::string value_text(const NumberType& type) { return std::string(type.range.text); }
std::string value_text(const WholeType& type) { return std::string(type.range.text); }
std::string value_text(const ChoiceType& type) { return fmt::format("{}", fmt::join(type.words, ", ")); }
std::string value_text(TextureType) { return "the name of a texture"; }
std::string value_text(UvMapType) { return "two rows of three numbers"; }
std::string value_text(BoolType) { return "true or false"; }
std::string value_text(PointType) { return "(x, y, z)"; }
std::string value_text(DirectionType) { return "(x, y, z), any length but 0"; }
std::string value_text(const ColorType&) { return "a color"; }
std::string value_text(AttenuationType) { return "(c0, c1, c2), each >= 0, not all 0"; }

std::string default_text(std::uint32_t n) { return n == k_none ? "none" : fmt::format("{}", n); }
std::string default_text(double x) { return fmt::format("{}", x); }
std::string default_text(std::int32_t value) { return fmt::format("{}", value); }
std::string default_text(bool value) { return value ? "true" : "false"; }
std::string default_text(const auto& value) {
    return fmt::format("({})", fmt::join(numbers_of(value), ", "));
}

// | key | value | default |
template <class Item> std::string row_start(const ItemField<Item>& field) {
    std::string row = fmt::format("| {}", field.key);
    if (!field.other_key.empty()) row += fmt::format(", {}", field.other_key);
    std::visit([&](const auto& member) { row += fmt::format(" | {}", value_text(member.type)); },
               field.member);
    if (field.required) {
        row += " | required";
    } else if (!field.otherwise.empty()) {
        row += fmt::format(" | {}", field.otherwise);
    } else {
        visit_field(field, Item{},
                    [&](const auto&, const auto& value) { row += " | " + default_text(value); });
    }
    return row;
}
template <class Item> std::string row_of(const ItemField<Item>& field) {
    return fmt::format("{} | {} |", row_start(field), field.description);
}

// The kinds of light that have a field.
std::string kinds_of(const ItemField<Light>& field) {
    std::string kinds;
    int count = 0;
    for (int k = 0; k < k_light_kinds; ++k) {
        Light light;
        light.kind = static_cast<LightKind>(k);
        if (!applies(field, light)) continue;
        kinds += fmt::format("{}{}", count++ == 0 ? "" : ", ", to_string(light.kind));
    }
    return count == k_light_kinds ? "all" : kinds;
}

// Every row is expected, or belongs to one of the other keys.
void expect_rows(const std::vector<std::string>& rows, const std::vector<std::string>& expected,
                 const std::vector<std::string>& other_keys) {
    for (const std::string& row : expected)
        EXPECT_EQ(std::count(rows.begin(), rows.end(), row), 1) << "the row is missing in the document\n"
                                                                << row;
    for (const std::string& row : rows) {
        const auto is_of = [&](const std::string& key) { return row.starts_with("| " + key + " |"); };
        EXPECT_TRUE(std::find(expected.begin(), expected.end(), row) != expected.end() ||
                    std::any_of(other_keys.begin(), other_keys.end(), is_of))
            << "there is no field for the row\n"
            << row;
    }
    EXPECT_EQ(rows.size(), expected.size() + other_keys.size());
}

// The lists of formats and profiles in prose.
TEST(DocumentedFormats, AreAllOfThem) {
    const std::string conventions = read_document("conventions.md"), readme = read_document("../README.md"),
                      package = read_document("../src/wasm/README.md");
    for (const FormatInfo& format : formats()) {
        std::istringstream extensions{std::string(format.extensions)};
        for (std::string extension; extensions >> extension;) {
            EXPECT_NE(package.find("`" + extension + "`"), std::string::npos) << extension;
            EXPECT_NE(readme.find(extension + (extension == ".js" ? "](docs/formats/" : "")),
                      std::string::npos)
                << extension;
            EXPECT_NE(conventions.find(extension), std::string::npos) << extension;
        }
        EXPECT_NE(readme.find("](docs/formats/" + std::string(format.name) + ".md)"), std::string::npos)
            << format.name;
        const std::size_t places = conventions.find("A key gets its value"),
                          end = conventions.find("2. your own");
        EXPECT_NE(conventions.substr(places, end - places).find("`" + std::string(format.profile) + "`"),
                  std::string::npos)
            << format.profile;
    }
    for (const std::string_view profile : profile_names())
        EXPECT_NE(conventions.find("\n| " + std::string(profile) + " |"), std::string::npos) << profile;
}

TEST(DocumentedFields, OfLights) {
    std::vector<std::string> expected;
    for (const ItemField<Light>& field : k_light_fields)
        expected.push_back(
            fmt::format("{} | {} | {} |", row_start(field), kinds_of(field), field.description));
    std::string kinds;
    for (int k = 0; k < k_light_kinds; ++k)
        kinds += fmt::format("{}{}", k == 0 ? "" : ", ", to_string(static_cast<LightKind>(k)));
    expected.push_back(fmt::format("| type | {} | point | all | the kind of light |", kinds));
    expect_rows(rows_below(read_document("formats/glint.md"), "light"), expected, {"intensity"});
}

TEST(DocumentedFields, OfFog) {
    std::vector<std::string> expected;
    const auto kinds_with = [](const ItemField<Fog>& field) {
        std::string kinds;
        int count = 0;
        for (const FogKind kind : {FogKind::linear, FogKind::exp, FogKind::exp2}) {
            Fog fog;
            fog.kind = kind;
            fog.falloff = 1;
            if (!applies(field, fog)) continue;
            kinds += fmt::format("{}{}", count++ == 0 ? "" : ", ", to_string(kind));
        }
        return count == 3 ? std::string("all") : kinds;
    };
    for (const ItemField<Fog>& field : k_fog_fields)
        expected.push_back(
            fmt::format("{} | {} | {} |", row_start(field), kinds_with(field), field.description));
    expect_rows(rows_below(read_document("formats/glint.md"), "fog"), expected, {"type"});
}

TEST(DocumentedFields, OfOcclusion) {
    std::vector<std::string> expected;
    for (const ItemField<Occlusion>& field : k_occlusion_fields) expected.push_back(row_of(field));
    expect_rows(rows_below(read_document("formats/glint.md"), "occlusion"), expected, {"method"});
}

TEST(DocumentedFields, OfBackgroundGradient) {
    std::vector<std::string> expected;
    for (const ItemField<BackgroundGradient>& field : k_gradient_fields) expected.push_back(row_of(field));
    expect_rows(rows_below(read_document("formats/glint.md"), "background_gradient"), expected, {"type"});
}

TEST(DocumentedFields, OfMaterials) {
    std::vector<std::string> expected;
    for (const ItemField<Material>& field : k_material_fields) expected.push_back(row_of(field));
    for (const MaterialCoefficient& c : k_material_coefficients)
        expected.push_back(fmt::format("| {} | {} | {} | {} |", c.key, c.range.text, c.usual, c.description));
    expect_rows(rows_below(read_document("formats/glint.md"), "material"), expected, {});
}

TEST(DocumentedFields, OfTextures) {
    std::vector<std::string> expected;
    for (const ItemField<Texture>& field : k_texture_fields) {
        std::string row = fmt::format("| {} | ", field.key);
        std::visit([&](const auto& member) { row += value_text(member.type); }, field.member);
        visit_field(field, Texture{}, [&](const auto& type, const auto& value) {
            if constexpr (requires { type.words; }) {
                row += fmt::format(" | {} | {} |", type.words[static_cast<std::size_t>(value)],
                                   field.description);
            } else if constexpr (std::is_arithmetic_v<std::remove_cvref_t<decltype(value)>>) {
                row += fmt::format(" | {} | {} |", default_text(value), field.description);
            } else if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, Vec3>) {
                row += fmt::format(" | ({}, {}, {}) | {} |", value.x, value.y, value.z, field.description);
            } else {
                row += fmt::format(" | ((1, 0, 0), (0, 1, 0)) | {} |", field.description);
            }
        });
        expected.push_back(row);
    }
    expect_rows(rows_below(read_document("formats/glint.md"), "texture"), expected, {});
}

TEST(DocumentedFields, OfTheCamera) {
    std::vector<std::string> expected;
    for (const ItemField<Camera>& field : k_camera_fields) expected.push_back(row_of(field));
    for (const ItemField<CameraFrame>& field : k_frame_fields) expected.push_back(row_of(field));
    expect_rows(rows_below(read_document("formats/glint.md"), "camera"), expected, {"projection"});
}

TEST(DocumentedFields, OfTheSettings) {
    std::vector<std::string> expected;
    for (const SettingKey& key : setting_keys()) {
        std::string values(key.values);
        for (std::size_t at = 0; (at = values.find(" | ", at)) != std::string::npos;)
            values.replace(at, 3, ", ");
        expected.push_back(fmt::format("| `{}` | {} | {} |", key.name, values, key.description));
    }
    expect_rows(rows_below(read_document("conventions.md"), "The keys"), expected, {});
}

// The tables that the readers use contain every field once, with distinct keys and names.
template <class Item> void expect_distinct(std::span<const ItemField<Item>> fields) {
    std::set<std::string_view> keys, names;
    for (const ItemField<Item>& field : fields) {
        EXPECT_TRUE(keys.insert(field.key).second) << field.key;
        EXPECT_TRUE(field.other_key.empty() || keys.insert(field.other_key).second) << field.other_key;
        EXPECT_TRUE(names.insert(field.name).second) << field.name;
        EXPECT_FALSE(field.label.empty());
        EXPECT_FALSE(field.description.empty());
    }
}
TEST(Fields, AreDistinct) {
    expect_distinct<Light>(k_light_fields);
    expect_distinct<Material>(k_material_fields);
    expect_distinct<Texture>(k_texture_fields);
    expect_distinct<Camera>(k_camera_fields);
    expect_distinct<CameraFrame>(k_frame_fields);
}

// A member without a row would be lost by `glint convert`: the rows have all of a struct's numbers.
TEST(Fields, HaveAllNumbersOfAMaterial) {
    std::size_t numbers = 0;
    for (const ItemField<Material>& field : k_material_fields)
        visit_bits(field, Material{}, [&](std::uint64_t) { ++numbers; });
    // `interior` and `texture` have four bytes, `one_sided` to `conserve_energy` have one.
    EXPECT_EQ(sizeof(Material), (numbers - 4) * sizeof(double));
}

TEST(LightKinds, HaveWords) {
    for (int k = 0; k < k_light_kinds; ++k) EXPECT_NE(to_string(static_cast<LightKind>(k)), "unknown light");
    EXPECT_EQ(to_string(static_cast<LightKind>(k_light_kinds)), "unknown light");
}

TEST(LightKinds, HaveTheirProperties) {
    Light light;
    light.position = {1, 2, 3};
    light.to_light = {0, 0, 5};
    light.kind = LightKind::ambient;
    EXPECT_TRUE(light.is_ambient());
    EXPECT_FALSE(light.has_position() || light.has_direction() || light.has_attenuation() ||
                 light.has_specular_color());
    light.kind = LightKind::point;
    EXPECT_TRUE(light.has_position() && light.has_attenuation() && light.has_specular_color());
    EXPECT_FALSE(light.is_ambient() || light.has_direction());
    EXPECT_EQ(light.way_from({1, 0, 0}), (Vec3{0, 2, 3}));
    light.kind = LightKind::directional;
    EXPECT_TRUE(light.has_direction() && light.has_specular_color());
    EXPECT_FALSE(light.is_ambient() || light.has_position() || light.has_attenuation());
    EXPECT_EQ(light.way_from({1, 0, 0}), (Vec3{0, 0, 5}));
    EXPECT_FALSE(light.is_spot());
    light.kind = LightKind::spot;
    EXPECT_TRUE(light.is_spot() && light.has_position() && light.has_attenuation() &&
                light.has_specular_color());
    EXPECT_FALSE(light.is_ambient() || light.has_direction());
    EXPECT_EQ(light.way_from({1, 0, 0}), (Vec3{0, 2, 3}));
    EXPECT_TRUE(light.has_axis());
    EXPECT_FALSE(light.is_area() || light.has_radius() || light.is_flat());
    for (const LightKind kind : {LightKind::parallelogram, LightKind::disc, LightKind::sphere}) {
        light.kind = kind;
        EXPECT_TRUE(light.is_area() && light.has_position() && light.has_attenuation() &&
                    light.has_specular_color());
        EXPECT_FALSE(light.is_ambient() || light.has_direction() || light.is_spot());
        EXPECT_EQ(light.has_radius(), kind != LightKind::parallelogram);
        EXPECT_EQ(light.is_flat(), kind != LightKind::sphere);
        EXPECT_EQ(light.has_axis(), kind == LightKind::disc);
        light.one_sided = true;
        EXPECT_EQ(light.has_emitter_cosine(), light.is_flat());
        EXPECT_EQ(light.way_from({1, 0, 0}), (Vec3{0, 2, 3}));
    }
}

TEST(LightKinds, FallOffWhereAttenuationIsBelowOne) {
    Light light;
    EXPECT_FALSE(light.falls_off());
    light.attenuation = {0.5, 0, 0};
    EXPECT_FALSE(light.falls_off());
    for (const Attenuation& a : {Attenuation{2, 0, 0}, Attenuation{1, 0.1, 0}, Attenuation{0, 0, 1}}) {
        light.attenuation = a;
        light.kind = LightKind::point;
        EXPECT_TRUE(light.falls_off());
        light.kind = LightKind::directional;
        EXPECT_FALSE(light.falls_off());
    }
    light = {};
    light.fade_distance = 2;
    EXPECT_FALSE(light.fades() || light.falls_off());
    light.fade_power = 1;
    EXPECT_TRUE(light.fades() && light.falls_off());
    light.kind = LightKind::directional;
    EXPECT_FALSE(light.fades() || light.falls_off());
}

}  // namespace
}  // namespace glint::test
