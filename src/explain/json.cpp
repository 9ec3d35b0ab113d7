// SPDX-License-Identifier: Apache-2.0
// An explanation as JSON; docs/explain.schema.json is its schema.
// The JSON library must not use <filesystem>, which the browser build lacks.
#define JSON_HAS_FILESYSTEM 0
#define JSON_HAS_EXPERIMENTAL_FILESYSTEM 0
#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "base/status.h"
#include "explain/references.h"
#include "glint/explain.h"
#include "scene/material_fields.h"

namespace glint {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(Vec3 v) { return {v.x, v.y, v.z}; }
Json to_json(Color c) { return {c.r, c.g, c.b}; }
// As a float: of a double, the library would print more digits than the float needs.
Json to_json(const float (&v)[3]) { return {v[0], v[1], v[2]}; }
// JSON has no infinity.
Json finite(double number) { return number < 1e308 ? Json(number) : Json(); }

void add_item(Json& item, const Scene& scene, const ItemTexts& texts, std::uint32_t index) {
    item["index"] = index;
    if (const auto name = texts.name(index); !name.empty()) item["name"] = name;
    const SourcePlace place = texts.place(index);
    if (place.line == 0 || place.file >= scene.files.size()) return;
    item["file"] = scene.files[place.file];
    item["line"] = place.line;
    item["column"] = place.column;
}

Json shape_json(const Scene& scene, std::uint32_t index) {
    Json item = {{"kind", to_string(scene.shapes[index].kind)}};
    add_item(item, scene, scene.shape_texts, index);
    return item;
}

Json hit_shape_json(const Scene& scene, const ExplainedHit& hit) {
    Json item = shape_json(scene, hit.shape);
    if (hit.color) item["color"] = to_json(*hit.color);
    return item;
}

Json material_json(const Scene& scene, const ExplainedHit& hit) {
    Json item = Json::object();
    if (hit.material != k_none) add_item(item, scene, scene.material_texts, hit.material);
    const Material m = material_of(hit, scene);
    for (const ItemField<Material>& field : k_material_fields)
        item[std::string(field.name)] = field_json<Json>(field, m);
    return item;
}

Json light_json(const Scene& scene, std::uint32_t index) {
    const Light& light = scene.lights[index];
    Json item = {{"kind", to_string(light.kind)}, {"has_position", light.has_position()}};
    add_item(item, scene, scene.light_texts, index);
    item["color"] = to_json(light.color);
    item["specular_color"] = to_json(light.specular_color);
    return item;
}

Json blocker_json(const Scene& scene, const Blocker& blocker) {
    return {{"shape", shape_json(scene, blocker.shape)},
            {"distance", blocker.distance},
            {"point", to_json(blocker.point)}};
}

// terms: LightTerms or a ShadowSample.
template <class Terms> Json shadow_ray_json(const Terms& terms) {
    return {{"origin", to_json(terms.origin)},
            {"direction", to_json(terms.direction)},
            {"t_min", terms.t_min},
            {"t_max", finite(terms.t_max)}};
}

/// Whether transparent surfaces color the light.
bool is_filtered(const LightTerms& terms) {
    return !terms.filters.empty() || std::any_of(terms.samples.begin(), terms.samples.end(),
                                                 [](const auto& sample) { return !sample.filters.empty(); });
}

Json filters_json(const Scene& scene, std::span<const ShadowFilter> filters) {
    Json list = Json::array();
    for (const ShadowFilter& filter : filters) {
        list.push_back({{"shape", shape_json(scene, filter.shape)},
                        {"distance", filter.distance},
                        {"point", to_json(filter.point)},
                        {"factor", to_json(filter.factor)}});
    }
    return list;
}

Json samples_json(const Scene& scene, const LightTerms& terms) {
    Json list = Json::array();
    for (const ShadowSample& sample : terms.samples) {
        Json json = {{"sample", sample.sample},
                     {"weight", sample.weight},
                     {"position", to_json(sample.position)},
                     {"blocked", sample.blocked},
                     {"shadow_ray", shadow_ray_json(sample)}};
        if (sample.blocker) json["blocker"] = blocker_json(scene, *sample.blocker);
        if (!sample.filters.empty()) {
            json["filter"] = to_json(sample.filter);
            json["filters"] = filters_json(scene, sample.filters);
        }
        list.push_back(std::move(json));
    }
    return list;
}

Json terms_json(const Scene& scene, const ExplainedHit& hit, const LightTerms& terms) {
    Json json = {{"light", light_json(scene, terms.light)},
                 {"reason", to_string(reason(terms))},
                 {"highlight", to_string(highlight_reason(terms, hit, scene))},
                 {"to_light", to_json(terms.to_light)},
                 {"distance", terms.distance},
                 {"attenuation", terms.attenuation},
                 {"spot", terms.spot},
                 {"emitter", terms.emitter},
                 {"visible", terms.visible},
                 {"n_l", finite(terms.n_l)},
                 {"s", finite(terms.s)},
                 {"power", terms.power},
                 {"diffuse_factor", finite(terms.diffuse_factor)},
                 {"diffuse", to_json(terms.diffuse)},
                 {"specular", to_json(terms.specular)}};
    const Material& material = material_of(hit, scene);
    if (!(material.phong == Color{})) {
        json["phong_s"] = terms.phong_s;
        json["phong_power"] = terms.phong_power;
    }
    if (material.metallic > 0) json["highlight_tint"] = to_json(terms.highlight_tint);
    if (is_filtered(terms)) json["filter"] = to_json(terms.filter);
    if (!terms.filters.empty()) json["filters"] = filters_json(scene, terms.filters);
    if (terms.sample >= 0) {
        json["sample"] = terms.sample;
        const Light& light = scene.lights[terms.light];
        json["weight"] = 1.0 / (light.samples_u * light.samples_v);
    }
    if (terms.has_ray) json["shadow_ray"] = shadow_ray_json(terms);
    if (terms.blocker) json["blocker"] = blocker_json(scene, *terms.blocker);
    if (!terms.samples.empty()) json["samples"] = samples_json(scene, terms);
    return json;
}

Json secondary_ray_json(const ExplainedSecondaryRay& ray) {
    Json json = {{"state", to_string(ray.state)}};
    if (ray.state != SecondaryRayState::none && ray.state != SecondaryRayState::limit)
        json["weight"] = to_json(ray.weight);
    if (ray.ray >= 0) json["ray"] = ray.ray;
    return json;
}

Json occlusion_json(const Scene& scene, const ExplainedOcclusion& occlusion) {
    Json occluders = Json::array();
    for (const ExplainedOcclusion::Occluder& o : occlusion.occluders)
        occluders.push_back(
            {{"shape", shape_json(scene, o.shape)}, {"samples", o.samples}, {"weight", o.weight}});
    return {{"samples", occlusion.samples},      {"blocked", occlusion.blocked},
            {"factor", occlusion.factor},        {"factors", to_json(occlusion.factors)},
            {"light", to_json(occlusion.light)}, {"part", to_json(occlusion.part)},
            {"direct", scene.occlusion->direct}, {"color", to_json(scene.occlusion->color)},
            {"occluders", std::move(occluders)}};
}

Json hit_json(const Scene& scene, const ExplainedHit& hit) {
    Json lights = Json::array();
    for (const LightTerms& terms : hit.lights) lights.push_back(terms_json(scene, hit, terms));
    Json json = {{"shape", hit_shape_json(scene, hit)},
                 {"material", material_json(scene, hit)},
                 {"point", to_json(hit.point)},
                 {"normal", to_json(hit.normal)},
                 {"to_eye", to_json(hit.to_eye)},
                 {"side", hit.behind ? "back" : "front"},
                 {"normal_turned", hit.turned},
                 {"weight", to_json(hit.weight)},
                 {"local_share", hit.local_share},
                 {"ambient", to_json(hit.ambient)},
                 {"lights", std::move(lights)},
                 {"diffuse", to_json(hit.diffuse)},
                 {"specular", to_json(hit.specular)},
                 {"emission", to_json(hit.emission)},
                 {"parts",
                  {{"ambient", to_json(hit.parts[0])},
                   {"diffuse", to_json(hit.parts[1])},
                   {"specular", to_json(hit.parts[2])},
                   {"emission", to_json(hit.parts[3])}}},
                 {"fresnel", hit.fresnel},
                 {"reflected", secondary_ray_json(hit.reflected)},
                 {"transmitted", secondary_ray_json(hit.transmitted)}};
    if (hit.transparent) {
        json["opacity"] = hit.opacity;
        json["highlight_share"] = hit.highlight_share;
    }
    if (hit.outline != 1) json["outline"] = hit.outline;
    if (hit.occlusion) json["occlusion"] = occlusion_json(scene, *hit.occlusion);
    return json;
}

Json ray_json(const Explanation& e, const Scene& scene, std::size_t number) {
    const ExplainedRay& ray = e.rays[number];
    Json json = {{"kind", ray.parent < 0    ? "camera"
                          : ray.transmitted ? "transmitted"
                                            : "mirror"},
                 {"sample", {ray.sample % e.samples, ray.sample / e.samples}},
                 {"generation", ray.generation},
                 {"parent", ray.parent < 0 ? Json() : Json(ray.parent)}};
    const auto layer = layer_of(e, number);
    json["layer"] = layer ? Json(layer_infos()[static_cast<std::size_t>(*layer)].name) : Json();
    json["origin"] = to_json(ray.origin);
    json["direction"] = to_json(ray.direction);
    json["t_min"] = ray.t_min;
    json["t"] = finite(ray.t);
    json["weight"] = to_json(ray.weight);
    if (ray.straight) json["straight"] = true;
    if (ray.beyond_limit) json["beyond_limit"] = true;
    if (scene.fog) json["fog"] = {{"visibility", ray.visibility}, {"added", to_json(ray.fog)}};
    if (ray.inside_object) json["inside_object"] = true;
    if (ray.hit) {
        json["hit"] = hit_json(scene, *ray.hit);
    } else {
        json["background"] = to_json(ray.background);
        json["transparent"] = ray.transparent;
    }
    return json;
}

Json adaptive_json(const Explanation& e) {
    const SampleDifference& d = *e.adaptive;
    return {{"refined", e.samples > 1},
            {"neighbor", {d.x, d.y}},
            {"difference", d.difference},
            {"one_sample", to_json(d.own)},
            {"neighbor_one_sample", to_json(d.neighbor)}};
}

}  // namespace

Result<std::string> explanation_json(const Explanation& e, const Scene& scene, const EncodeOptions& file) {
    return result_of([&]() -> Result<std::string> {
        if (file.bits != 8 && file.bits != 16) return invalid_argument("a channel has 8 or 16 bits");
        if (std::string fault = explanation_fault(e, scene); !fault.empty())
            return invalid_argument(std::move(fault));
        Json json = {{"pixel", {e.x, e.y}}, {"samples", e.samples}};
        if (e.adaptive) json["adaptive"] = adaptive_json(e);
        json["value"] = to_json(e.value);
        json["alpha"] = e.alpha;
        json["transfer"] = file.transfer == Transfer::srgb ? "srgb" : "none";
        json["gamma"] = file.gamma;
        json["rounding"] = file.rounding == Rounding::down      ? "down"
                           : file.rounding == Rounding::half_up ? "half_up"
                                                                : "half_even";
        for (const float v : e.value)
            json[file.bits == 8 ? "bytes" : "words"].push_back(to_number(v, file.bits, file.rule()));
        for (int l = 0; l < k_light_layers; ++l)
            json["layers"][std::string(layer_infos()[static_cast<std::size_t>(l)].name)] =
                to_json(e.layers[l]);
        json["rays"] = Json::array();
        for (std::size_t i = 0; i < e.rays.size(); ++i) json["rays"].push_back(ray_json(e, scene, i));
        return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    });
}

}  // namespace glint
