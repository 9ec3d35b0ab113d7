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
#include "explain/terms.h"
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

// Adds the terms of a table that are given.
template <class Of, std::size_t n>
void add_terms(Json& json, const ExplainedTerm<Of> (&table)[n], const Of& of, const TermContext& context) {
    for (const ExplainedTerm<Of>& term : table) {
        if (term.is_given != nullptr && !term.is_given(of, context)) continue;
        json[std::string(term.name)] = std::visit(
            [&](auto member) -> Json {
                if constexpr (std::is_same_v<decltype(member), double Of::*>) {
                    return finite(of.*member);
                } else if constexpr (std::is_same_v<decltype(member), int Of::*> ||
                                     std::is_same_v<decltype(member), bool Of::*>) {
                    return of.*member;
                } else {
                    return to_json(of.*member);
                }
            },
            term.member);
    }
}

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
    const auto operands = operands_of(scene, scene.shapes[hit.shape]);
    if (hit.element < operands.size()) {
        item["operand"] = hit.element;
        item["operand_kind"] = to_string(operands[hit.element].kind);
    }
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

Json filters_json(const Scene& scene, std::span<const ShadowFilter> filters) {
    Json list = Json::array();
    for (const ShadowFilter& filter : filters) {
        list.push_back({{"shape", shape_json(scene, filter.shape)},
                        {"distance", filter.distance},
                        {"point", to_json(filter.point)},
                        {"factor", to_json(filter.factor)}});
        if (!(filter.fade == Color{1, 1, 1})) list.back()["fade"] = to_json(filter.fade);
    }
    return list;
}

Json samples_json(const Scene& scene, const LightTerms& terms) {
    Json list = Json::array();
    for (const ShadowSample& sample : terms.samples) {
        Json json;
        add_terms(json, k_shadow_sample_terms, sample, {scene});
        json["shadow_ray"] = shadow_ray_json(sample);
        if (sample.blocker) json["blocker"] = blocker_json(scene, *sample.blocker);
        if (!sample.filters.empty()) json["filters"] = filters_json(scene, sample.filters);
        list.push_back(std::move(json));
    }
    return list;
}

Json terms_json(const Scene& scene, const ExplainedHit& hit, const LightTerms& terms) {
    Json json = {{"light", light_json(scene, terms.light)},
                 {"reason", to_string(reason(terms))},
                 {"highlight", to_string(highlight_reason(terms, hit, scene))}};
    add_terms(json, k_light_terms, terms, {scene, &hit});
    if (!terms.filters.empty()) json["filters"] = filters_json(scene, terms.filters);
    if (terms.sample >= 0) {
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
    Json json;
    add_terms(json, k_occlusion_terms, occlusion, {scene});
    json["direct"] = scene.occlusion->direct;
    json["color"] = to_json(scene.occlusion->color);
    json["occluders"] = std::move(occluders);
    return json;
}

Json texture_json(const Scene& scene, const ExplainedTexture& texture) {
    Json json = {{"index", texture.texture}, {"mix", to_string(scene.textures[texture.texture].mix)}};
    if (const std::string_view name = scene.texture_texts.name(texture.texture); !name.empty())
        json["name"] = name;
    add_terms(json, k_texture_terms, texture, {scene});
    for (const ExplainedTexture& layer : texture.layers) json["layers"].push_back(texture_json(scene, layer));
    return json;
}

Json hole_json(const Scene& scene, const ExplainedHole& hole) {
    Json json = {{"shape", shape_json(scene, hole.shape)}};
    add_terms(json, k_hole_terms, hole, {scene});
    if (hole.texture) json["texture"] = texture_json(scene, *hole.texture);
    return json;
}

Json hit_json(const Scene& scene, const ExplainedHit& hit) {
    Json lights = Json::array();
    for (const LightTerms& terms : hit.lights) lights.push_back(terms_json(scene, hit, terms));
    Json json = {{"shape", hit_shape_json(scene, hit)},
                 {"material", material_json(scene, hit)},
                 {"side", hit.behind ? "back" : "front"}};
    add_terms(json, k_hit_terms, hit, {scene});
    json["lights"] = std::move(lights);
    json["parts"] = {{"ambient", to_json(hit.parts[0])},
                     {"diffuse", to_json(hit.parts[1])},
                     {"specular", to_json(hit.parts[2])},
                     {"emission", to_json(hit.parts[3])}};
    json["reflected"] = secondary_ray_json(hit.reflected);
    json["transmitted"] = secondary_ray_json(hit.transmitted);
    if (hit.texture) json["texture"] = texture_json(scene, *hit.texture);
    for (const ExplainedCrossing& crossing : hit.crossings)
        add_terms(json["crossings"].emplace_back(Json::object()), k_crossing_terms, crossing, {scene});
    if (hit.occlusion) json["occlusion"] = occlusion_json(scene, *hit.occlusion);
    return json;
}

Json ray_json(const Explanation& e, const Scene& scene, std::size_t number) {
    const ExplainedRay& ray = e.rays[number];
    Json json = {{"kind", ray.parent < 0    ? "camera"
                          : ray.transmitted ? "transmitted"
                                            : "mirror"},
                 {"sample", {ray.sample % e.samples, ray.sample / e.samples}},
                 {"parent", ray.parent < 0 ? Json() : Json(ray.parent)}};
    const auto layer = layer_of(e, number);
    json["layer"] = layer ? Json(layer_infos()[static_cast<std::size_t>(*layer)].name) : Json();
    add_terms(json, k_ray_terms, ray, {scene});
    if (scene.fog) json["fog"] = {{"visibility", ray.visibility}, {"added", to_json(ray.fog)}};
    for (const ExplainedHole& hole : ray.holes) json["holes"].push_back(hole_json(scene, hole));
    if (ray.hit) json["hit"] = hit_json(scene, *ray.hit);
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
