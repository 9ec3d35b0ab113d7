// SPDX-License-Identifier: Apache-2.0
#include "wasm/describe.h"

#include "formats/glint_blocks.h"
#include "scene/camera_fields.h"
#include "scene/fog_fields.h"
#include "scene/light_fields.h"
#include "scene/material_fields.h"
#include "scene/sky_fields.h"
#include "scene/texture_fields.h"
#include "world/prepare_camera.h"

namespace glint::wasm {
namespace {

using Json = nlohmann::ordered_json;

Json vec(Vec3 v) { return {v.x, v.y, v.z}; }
Json color(Color c) { return {c.r, c.g, c.b}; }

/// {"file", "line", "column"}, or null for an item without a place.
Json place_json(const Scene& scene, SourcePlace place) {
    if (place.line == 0 || place.file >= scene.files.size()) return nullptr;
    return {{"file", scene.files[place.file]}, {"line", place.line}, {"column", place.column}};
}

Json camera_json(const Scene& scene) {
    const Camera& camera = scene.camera;
    Json json = {
        {"projection", camera.projection == Projection::perspective ? "perspective" : "orthographic"},
        {"place", place_json(scene, scene.camera_place)},
        {"has_frame", camera.frame.has_value()}};
    for (const ItemField<Camera>& field : k_camera_fields) {
        if (!camera.frame || applies(field, camera))
            json[std::string(field.name)] = field_json<Json>(field, camera);
    }
    if (!camera.frame) json["fov_axis"] = camera.fov_axis == FovAxis::x ? "x" : "y";
    const PreparedCamera prepared = prepare_camera(camera, scene.settings);
    json["view"] = {
        {"right", vec(prepared.right)}, {"up", vec(prepared.up)}, {"forward", vec(prepared.forward)}};
    return json;
}

Json light_json(const Scene& scene, std::uint32_t index) {
    const Light& light = scene.lights[index];
    Json json = {{"kind", to_string(light.kind)},
                 {"name", scene.light_texts.name(index)},
                 {"place", place_json(scene, scene.light_texts.place(index))}};
    for (const ItemField<Light>& field : k_light_fields) {
        if (applies(field, light)) json[std::string(field.name)] = field_json<Json>(field, light);
    }
    return json;
}

/// A block that a scene has at most once. Null: it has none.
template <class Item, std::size_t n>
Json block_json(const Scene& scene, const std::optional<Item>& item, std::string_view kind, SourcePlace place,
                const ItemField<Item> (&fields)[n]) {
    if (!item) return nullptr;
    Json json = {{"kind", kind}, {"place", place_json(scene, place)}};
    for (const ItemField<Item>& field : fields) {
        if (applies(field, *item)) json[std::string(field.name)] = field_json<Json>(field, *item);
    }
    return json;
}
template <class Item> std::string_view kind_of(const std::optional<Item>& item) {
    return item ? to_string(item->kind) : "";
}
std::string_view kind_of(const std::optional<Occlusion>& item) { return item ? to_string(item->method) : ""; }

/// Of a field of any item: what describes it.
struct AnyField {
    std::string_view name, key, other_key, label, description, type;
    bool required;
    std::span<const std::string_view> words;
    const Range* range;
};
Json any_field_json(const AnyField& field, Json value) {
    Json keys = {field.key};
    if (!field.other_key.empty()) keys.push_back(field.other_key);
    Json json = {{"name", field.name},         {"keys", std::move(keys)},
                 {"label", field.label},       {"description", field.description},
                 {"required", field.required}, {"default", std::move(value)},
                 {"type", field.type}};
    if (!field.words.empty()) json["words"] = field.words;
    if (field.range != nullptr) {
        json["min"] = field.range->min;
        json["max"] = field.range->max;
    }
    return json;
}

/// The data for a page's controls of a kind of item.
template <class Item> Json fields_json(std::span<const ItemField<Item>> fields) {
    Json list = Json::array();
    for (const ItemField<Item>& field : fields) {
        AnyField any{field.name,     field.key, field.other_key, field.label, field.description, {},
                     field.required, {},        nullptr};
        std::visit(
            [&](const auto& member) {
                any.type = member.type.word;
                if constexpr (requires { member.type.words; }) any.words = member.type.words;
                if constexpr (requires { member.type.range; }) any.range = &member.type.range;
            },
            field.member);
        list.push_back(any_field_json(any, field_json<Json>(field, Item{})));
    }
    return list;
}

/// {"sphere": ["center", "radius", ...], ...}: the keys of each block of .glint.
const Json& blocks_json() {
    static const Json blocks = [] {
        Json json = Json::object();
        for (const GlintBlock& block : glint_blocks()) json[std::string(block.word)] = block.keys;
        return json;
    }();
    return blocks;
}

/// Every setting: its value, the profile's value, and its origin.
Json settings_json(const Scene& scene) {
    Scene plain;
    apply_profile(plain, scene.profile);
    constexpr const char* words[] = {"profile", "file", "command", "code"};
    Json list = Json::array();
    const auto keys = setting_keys();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const SettingOrigin origin = i < scene.origins.size() ? scene.origins[i] : SettingOrigin{};
        list.push_back({{"name", keys[i].name},
                        {"values", keys[i].values},
                        {"description", keys[i].description},
                        {"is_convention", keys[i].is_convention},
                        {"value", get_setting(scene, i)},
                        {"profile_value", get_setting(plain, i)},
                        {"origin", words[static_cast<std::size_t>(origin.kind)]},
                        {"place", place_json(scene, origin.place)}});
    }
    return list;
}

/// The word of an item's kind, or null.
Json item_json(SceneItem item) {
    constexpr const char* words[] = {"",         "camera",    "background", "setting", "light",
                                     "material", "transform", "shape",      "fog",     "texture"};
    return item == SceneItem::none ? Json() : Json(words[static_cast<std::size_t>(item)]);
}

Json shapes_json(const Scene& scene) {
    std::size_t counts[k_shape_kinds] = {};
    for (const Shape& shape : scene.shapes) ++counts[static_cast<std::size_t>(shape.kind)];
    Json json = Json::object();
    for (std::size_t kind = 0; kind < k_shape_kinds; ++kind) {
        if (counts[kind] != 0) json[std::string(to_string(static_cast<ShapeKind>(kind)))] = counts[kind];
    }
    return json;
}

}  // namespace

Json to_json(const Diagnostic& d) {
    return {{"severity", d.severity == Severity::error ? "error" : "warning"},
            {"file", d.file},
            {"line", d.line},
            {"column", d.column},
            {"length", d.length},
            {"message", d.message},
            {"item", item_json(d.item)},
            {"index", d.index},
            {"can_skip", d.can_skip},
            {"text", to_string(d)}};
}

Json describe(const Scene& scene, const World& world) {
    const Bounds box = scene_bounds(world);
    Json lights = Json::array();
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) lights.push_back(light_json(scene, i));
    return {{"profile", scene.profile},
            {"files", scene.files},
            {"width", scene.settings.width},
            {"height", scene.settings.height},
            {"shapes", shapes_json(scene)},
            {"material_count", scene.materials.size()},
            {"bounds", box.min.x <= box.max.x ? Json{{"min", vec(box.min)}, {"max", vec(box.max)}} : Json()},
            {"background", color(scene.background)},
            {"gradient", block_json(scene, scene.gradient, kind_of(scene.gradient), scene.gradient_place,
                                    k_gradient_fields)},
            {"fog", block_json(scene, scene.fog, kind_of(scene.fog), scene.fog_place, k_fog_fields)},
            {"occlusion", block_json(scene, scene.occlusion, kind_of(scene.occlusion), scene.occlusion_place,
                                     k_occlusion_fields)},
            {"camera", camera_json(scene)},
            {"lights", std::move(lights)},
            {"light_fields", fields_json<Light>(k_light_fields)},
            {"camera_fields", fields_json<Camera>(k_camera_fields)},
            {"material_fields", fields_json<Material>(k_material_fields)},
            {"texture_fields", fields_json<Texture>(k_texture_fields)},
            {"gradient_fields", fields_json<BackgroundGradient>(k_gradient_fields)},
            {"fog_fields", fields_json<Fog>(k_fog_fields)},
            {"occlusion_fields", fields_json<Occlusion>(k_occlusion_fields)},
            {"blocks", blocks_json()},
            {"settings", settings_json(scene)}};
}

}  // namespace glint::wasm
