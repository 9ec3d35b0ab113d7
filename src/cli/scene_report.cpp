// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/text.h"
#include "cli/text.h"
#include "scene/fog_fields.h"
#include "scene/light_fields.h"
#include "scene/sky_fields.h"

namespace glint::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t k_max_listed = 20;  // lights and materials listed in the text

// To six digits.
std::string rounded(Vec3 v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z); }
std::string rounded(Color c) {
    return c.r == c.g && c.g == c.b ? fmt::format("{:.6g}", c.r)
                                    : fmt::format("({:.6g}, {:.6g}, {:.6g})", c.r, c.g, c.b);
}
Json vec_json(Vec3 v) { return {v.x, v.y, v.z}; }
Json color_json(Color c) { return {c.r, c.g, c.b}; }

// The shapes with a color of their own.
std::size_t count_colored(const Scene& scene) {
    return static_cast<std::size_t>(std::count_if(scene.shape_colors.begin(), scene.shape_colors.end(),
                                                  [](const ShapeColor& c) { return c.is_set(); }));
}

std::array<std::size_t, k_shape_kinds> shape_counts(const Scene& scene) {
    std::array<std::size_t, k_shape_kinds> counts{};
    for (const Shape& shape : scene.shapes) ++counts[static_cast<std::size_t>(shape.kind)];
    return counts;
}

std::array<std::size_t, k_light_kinds> light_counts(const Scene& scene) {
    std::array<std::size_t, k_light_kinds> counts{};
    for (const Light& light : scene.lights) ++counts[static_cast<std::size_t>(light.kind)];
    return counts;
}

std::string place_text(const Scene& scene, SourcePlace place) {
    if (place.line == 0 || place.file >= scene.files.size()) return {};
    return fmt::format("{}:{}:{}", scene.files[place.file], place.line, place.column);
}

bool is_bounded(const Bounds& box) { return box.min.x <= box.max.x; }

// A value in six digits.
std::string text_of(double x) { return fmt::format("{:.6g}", x); }
std::string text_of(std::int32_t n) { return fmt::format("{}", n); }
std::string text_of(bool value) { return value ? "true" : "false"; }
std::string text_of(const auto& value) { return fmt::format("({:.6g})", fmt::join(numbers_of(value), ", ")); }

// What a light's kind needs beyond its color.
std::string light_details(const Light& light) {
    std::string text;
    for (const ItemField<Light>& field : k_light_fields) {
        const bool is_shown = field.required || !same_bits(field, light, Light{});
        if (is_light_color(field) || !is_shown || !applies(field, light)) continue;
        visit_field(field, light, [&](const auto&, const auto& value) {
            text += fmt::format("{}{} {}", text.empty() ? "" : "  ",
                                field.phrase.empty() ? field.label : field.phrase, text_of(value));
        });
    }
    if (light.has_specular_color() && !(light.specular_color == light.color)) {
        text += "  specular " + rounded(light.specular_color);
    }
    return text;
}

// A word, then each field that applies.
template <class Item, std::size_t n>
std::string block_text(std::string_view word, const Item& item, const ItemField<Item> (&fields)[n]) {
    std::string text(word);
    for (const ItemField<Item>& field : fields) {
        if (!applies(field, item)) continue;
        visit_field(field, item, [&](const auto&, const auto& value) {
            text += fmt::format("  {} {}", field.label, text_of(value));
        });
    }
    return text;
}
template <class Item, std::size_t n>
Json block_json(std::string_view key, std::string_view word, const Item& item,
                const ItemField<Item> (&fields)[n]) {
    Json json = {{std::string(key), word}};
    for (const ItemField<Item>& field : fields) {
        if (applies(field, item)) json[std::string(field.name)] = field_json<Json>(field, item);
    }
    return json;
}

std::string camera_text(const Camera& camera) {
    std::string text = camera.projection == Projection::perspective ? "perspective" : "orthographic";
    text += " at " + rounded(camera.position);
    if (camera.frame) {
        text += fmt::format(", frame right {} up {} forward {}", rounded(camera.frame->right),
                            rounded(camera.frame->up), rounded(camera.frame->forward));
    } else {
        text += fmt::format(" to {}, up {}, ", rounded(camera.look_at), rounded(camera.up));
        text += camera.projection == Projection::orthographic
                    ? fmt::format("{:.6g} wide", camera.width)
                    : fmt::format("fov {:.6g} degrees along {}", camera.fov_degrees,
                                  camera.fov_axis == FovAxis::x ? "x" : "y");
    }
    if (camera.lighting_eye) text += ", lit for an eye at " + rounded(*camera.lighting_eye);
    return text;
}

// "3 spheres, 1 plane  (4)".
template <class Word, std::size_t N>
std::string counts_text(const std::array<std::size_t, N>& counts, Word word_of) {
    std::string text;
    std::size_t total = 0;
    for (std::size_t i = 0; i < N; ++i) {
        total += counts[i];
        if (counts[i] != 0) text += fmt::format("{}{}", text.empty() ? "" : ", ", word_of(counts[i], i));
    }
    return text.empty() ? "none" : fmt::format("{}  ({})", text, with_commas(total));
}

}  // namespace

Color sum_of_lights(const Scene& scene) {
    Color sum;
    for (const Light& light : scene.lights) sum = sum + light.color;
    return sum;
}

std::string origin_text(const Scene& scene, std::size_t key) {
    const SettingOrigin origin = key < scene.origins.size() ? scene.origins[key] : SettingOrigin{};
    switch (origin.kind) {
        case SettingOrigin::Kind::profile:
            return "profile " + scene.profile;
        case SettingOrigin::Kind::file: {
            const std::string place = place_text(scene, origin.place);
            return place.empty() ? "file" : place;
        }
        case SettingOrigin::Kind::command:
            return "command line";
        case SettingOrigin::Kind::code:
            break;
    }
    return "code";
}

std::string text_report(const SceneReport& report) {
    const Scene& scene = report.scene;
    std::string text;
    auto out = std::back_inserter(text);
    fmt::format_to(out, "scene       {}\n", fmt::join(scene.files, " "));
    for (const SceneText& text_of_scene : report.texts) {
        const FormatChoice choice = choose_format(text_of_scene);
        fmt::format_to(out, "format      {}: {}\n", choice.format, choice.reason);
    }
    fmt::format_to(out, "shapes      {}\n",
                   counts_text(shape_counts(scene), [](std::size_t n, std::size_t kind) {
                       return counted(n, to_string(static_cast<ShapeKind>(kind)));
                   }));
    const Bounds box = scene_bounds(report.world);
    fmt::format_to(
        out, "bounds      {}\n",
        is_bounded(box) ? fmt::format("{} to {}", rounded(box.min), rounded(box.max)) : "no bounded shapes");
    fmt::format_to(out, "camera      {}\n", camera_text(scene.camera));
    fmt::format_to(out, "background  {}\n", rounded(scene.background));
    if (scene.gradient)
        fmt::format_to(out, "gradient    {}\n",
                       block_text(to_string(scene.gradient->kind), *scene.gradient, k_gradient_fields) +
                           (scene.gradient->color_map.empty()
                                ? ""
                                : fmt::format("  color map of {}", scene.gradient->color_map.size())));
    if (scene.fog)
        fmt::format_to(out, "fog         {}\n",
                       block_text(to_string(scene.fog->kind), *scene.fog, k_fog_fields));
    if (scene.occlusion)
        fmt::format_to(out, "occlusion   {}\n",
                       block_text(to_string(scene.occlusion->method), *scene.occlusion, k_occlusion_fields));
    fmt::format_to(out, "lights      {}\n",
                   counts_text(light_counts(scene), [](std::size_t n, std::size_t kind) {
                       return fmt::format("{} {}", n, to_string(static_cast<LightKind>(kind)));
                   }));
    for (std::size_t i = 0; i < scene.lights.size() && i < k_max_listed; ++i) {
        const Light& light = scene.lights[i];
        const auto index = static_cast<std::uint32_t>(i);
        std::string line = fmt::format("  {:11} {:10} {}", to_string(light.kind), rounded(light.color),
                                       light_details(light));
        if (!scene.light_texts.name(index).empty())
            line += fmt::format("  \"{}\"", printable(scene.light_texts.name(index)));
        const std::string place = place_text(scene, scene.light_texts.place(index));
        if (!place.empty()) line += "  " + place;
        fmt::format_to(out, "{}\n", line);
    }
    if (scene.lights.size() > k_max_listed) {
        fmt::format_to(out, "  and {} more\n", with_commas(scene.lights.size() - k_max_listed));
    }
    fmt::format_to(out, "  sum of intensities {}\n", rounded(sum_of_lights(scene)));
    fmt::format_to(out, "materials   {}", with_commas(scene.materials.size()));
    std::size_t named = 0;
    for (std::uint32_t i = 0; i < scene.materials.size() && named < k_max_listed; ++i) {
        const std::string_view name = scene.material_texts.name(i);
        if (!name.empty()) fmt::format_to(out, "{}{}", named++ == 0 ? ": " : ", ", printable(name));
    }
    if (const std::size_t colored = count_colored(scene); colored != 0)
        fmt::format_to(out, "; {} with a color of its own", counted(colored, "shape"));
    const WorldMemory used = memory_usage(report.world);
    const std::string colors =
        used.colors == 0 ? std::string() : fmt::format(" colors {},", bytes_text(double(used.colors)));
    fmt::format_to(out,
                   "\nmemory      shapes {}, boxes {}, indices {}, hierarchy {},{} materials {}, total {}\n",
                   bytes_text(double(used.shapes)), bytes_text(double(used.boxes)),
                   bytes_text(double(used.indices)), bytes_text(double(used.hierarchy)), colors,
                   bytes_text(double(used.materials)), bytes_text(double(used.total())));
    fmt::format_to(out,
                   "  {:.1f} bytes per shape of {} (polygons and meshes are triangles), without materials\n",
                   used.each(), with_commas(used.packed));
    for (const bool conventions : {false, true}) {
        fmt::format_to(out, "{}\n", conventions ? "conventions" : "settings");
        const auto keys = setting_keys();
        for (std::size_t key = 0; key < keys.size(); ++key) {
            if (keys[key].is_convention != conventions) continue;
            fmt::format_to(out, "  {:22} {:12} {}\n", keys[key].name, get_setting(scene, key),
                           origin_text(scene, key));
        }
    }
    fmt::format_to(out, "warnings    {}\n", count_warnings(report.warnings));
    for (const Diagnostic& warning : report.warnings) text += to_string(warning);
    return text;
}

std::string json_report(const SceneReport& report) {
    const Scene& scene = report.scene;
    Json json;
    json["files"] = scene.files;
    json["profile"] = scene.profile;
    json["formats"] = Json::array();
    for (const SceneText& text : report.texts) {
        const FormatChoice choice = choose_format(text);
        json["formats"].push_back({{"name", choice.format}, {"reason", choice.reason}});
    }
    Json shapes = Json::object();
    const auto counts = shape_counts(scene);
    for (std::size_t i = 0; i < counts.size(); ++i)
        shapes[std::string(to_string(static_cast<ShapeKind>(i)))] = counts[i];
    json["shapes"] = std::move(shapes);
    json["shape_count"] = scene.shapes.size();
    json["shape_color_count"] = count_colored(scene);
    const Bounds box = scene_bounds(report.world);
    if (is_bounded(box)) {
        json["bounds"] = {{"min", vec_json(box.min)}, {"max", vec_json(box.max)}};
    } else {
        json["bounds"] = nullptr;
    }
    json["background"] = color_json(scene.background);
    if (scene.gradient)
        json["background_gradient"] =
            block_json("kind", to_string(scene.gradient->kind), *scene.gradient, k_gradient_fields);
    if (scene.fog) json["fog"] = block_json("kind", to_string(scene.fog->kind), *scene.fog, k_fog_fields);
    if (scene.occlusion)
        json["occlusion"] =
            block_json("method", to_string(scene.occlusion->method), *scene.occlusion, k_occlusion_fields);
    json["lights"] = Json::array();
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        Json item = {{"kind", to_string(light.kind)}, {"color", color_json(light.color)}};
        for (const ItemField<Light>& field : k_light_fields) {
            if (!is_light_color(field) && applies(field, light))
                item[std::string(field.name)] = field_json<Json>(field, light);
        }
        if (light.has_specular_color()) item["specular_color"] = color_json(light.specular_color);
        if (!scene.light_texts.name(i).empty()) item["name"] = scene.light_texts.name(i);
        const std::string place = place_text(scene, scene.light_texts.place(i));
        if (!place.empty()) item["place"] = place;
        json["lights"].push_back(std::move(item));
    }
    json["light_sum"] = color_json(sum_of_lights(scene));
    json["material_count"] = scene.materials.size();
    const WorldMemory used = memory_usage(report.world);
    json["memory_bytes"] = {{"shapes", used.shapes},   {"boxes", used.boxes},
                            {"indices", used.indices}, {"hierarchy", used.hierarchy},
                            {"colors", used.colors},   {"materials", used.materials},
                            {"total", used.total()}};
    json["packed_shapes"] = used.packed;
    json["bytes_a_shape"] = used.each();
    const auto keys = setting_keys();
    for (std::size_t key = 0; key < keys.size(); ++key) {
        json[keys[key].is_convention ? "conventions" : "settings"][std::string(keys[key].name)] = {
            {"value", get_setting(scene, key)}, {"from", origin_text(scene, key)}};
    }
    json["warnings"] = Json::array();
    for (const Diagnostic& warning : report.warnings) {
        json["warnings"].push_back({{"file", warning.file},
                                    {"line", warning.line},
                                    {"column", warning.column},
                                    {"severity", warning.severity == Severity::note ? "note" : "warning"},
                                    {"message", warning.message}});
    }
    // File names need not be UTF-8.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace glint::cli
