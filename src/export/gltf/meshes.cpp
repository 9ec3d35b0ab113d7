// SPDX-License-Identifier: Apache-2.0
#include "export/gltf/meshes.h"

#include <algorithm>

#include "formats/single_vertices.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::gltf_export {
namespace {

// A vertex color's channel in the file: a color that glint shows, divided by that of the material.
double channel_of(double shown, double of_material) {
    return of_material > 0 ? shown / of_material : shown > 0 ? 2 : 0;
}

double shown_of(float channel, const ColorRule& rule) {
    const double c = number::max(0.0, static_cast<double>(channel));
    return rule.keeps_colors() ? c : rule.linear(number::min(c, 1.0));
}

Color divided(const Float3& value, Color of_material, const ColorRule& rule) {
    return {channel_of(shown_of(value.x, rule), of_material.r),
            channel_of(shown_of(value.y, rule), of_material.g),
            channel_of(shown_of(value.z, rule), of_material.b)};
}

// glTF's normals have the length 1; those that nearly have it stay as they are.
Float3 unit(const Float3& normal) {
    const Vec3 n = to_vec3(normal);
    return number::abs(dot(n, n) - 1) < 0.005 ? normal : to_single(normalize(n));
}

// For the coordinates of glTF, whose v goes down.
Float3 mapped(const Float3& uv, const UvMap& map) {
    const auto& m = map.m;
    const double u = uv.x, v = uv.y;
    return to_single({m[0][0] * u + m[0][1] * v + m[0][2], 1 - (m[1][0] * u + m[1][1] * v + m[1][2]), 0});
}

void append(std::vector<float>& to, const Float3& f) { to.insert(to.end(), {f.x, f.y, f.z}); }

bool is_baked(const Texture& texture) {
    return texture.mapping != TextureMapping::uv || !transform_of(texture.uv_map);
}

}  // namespace

// The material stays if the colors are not brighter than it; else, a white one has them.
MaterialUse MeshList::colored_use(const MeshData& mesh, MaterialUse use, const ColorRule& rule) {
    const Color of_material = materials_.color(use);
    const auto is_bright = [&](const Float3& value) {
        return greatest(divided(value, of_material, rule)) > 1;
    };
    use.is_white = std::any_of(mesh.colors.values.begin(), mesh.colors.values.end(), is_bright);
    return use;
}

const MeshList::Numbers& MeshList::numbers(const MeshData& mesh, Kind kind,
                                           const std::vector<std::uint32_t>* triangles, Color of_material,
                                           const Texture* texture, const ColorRule& rule) {
    if (!kind.colors) of_material = {};
    const bool bakes = texture != nullptr && is_baked(*texture);
    Map map{};
    if (bakes) std::copy_n(&texture->uv_map.m[0][0], 6, map.begin());
    const auto [known, is_new] =
        numbers_.try_emplace({&mesh, kind.number(), {of_material.r, of_material.g, of_material.b}, map});
    if (!is_new) return known->second;
    const SingleVertices single =
        single_vertices(mesh, {kind.normals, kind.colors, kind.textured}, triangles);
    Json attributes = Json::object();
    std::vector<float> values;
    values.reserve(3 * single.vertices.size());
    const bool is_single = !mesh.single_positions.empty();
    for (const SingleVertex& v : single.vertices)
        append(values, is_single ? mesh.single_positions[v[0]] : to_single(mesh.positions[v[0]]));
    attributes["POSITION"] = file_.add_floats(values, 3, true);
    if (kind.normals) {
        values.clear();
        for (const SingleVertex& v : single.vertices) append(values, unit(mesh.normals.values[v[1]]));
        attributes["NORMAL"] = file_.add_floats(values, 3, false);
    }
    if (kind.textured) {
        values.clear();
        for (const SingleVertex& v : single.vertices) {
            const Float3& uv = mesh.texture_coordinates.values[v[3]];
            const Float3 written = bakes ? mapped(uv, texture->uv_map) : uv;
            values.insert(values.end(), {written.x, written.y});
        }
        attributes["TEXCOORD_0"] = file_.add_floats(values, 2, false);
    }
    if (kind.colors) {
        values.clear();
        bool is_limited = false;
        for (const SingleVertex& v : single.vertices) {
            const Color c = divided(mesh.colors.values[v[2]], of_material, rule);
            is_limited = is_limited || greatest(c) > 1;
            append(values, to_single({number::min(c.r, 1.0), number::min(c.g, 1.0), number::min(c.b, 1.0)}));
        }
        if (is_limited) losses_.add("colors of vertices above 1", "they are limited");
        attributes["COLOR_0"] = file_.add_floats(values, 3, false);
    }
    known->second = {std::move(attributes), file_.add_indices(single.triangles, single.vertices.size())};
    return known->second;
}

std::uint32_t MeshList::use(const MeshData& mesh, std::uint32_t material, const std::optional<Color>& color,
                            const std::string& name, const ColorRule& rule) {
    const Color c = color.value_or(Color{});
    const auto [known, is_new] =
        meshes_.try_emplace({&mesh, material, color.has_value(), {c.r, c.g, c.b}}, k_no_index);
    if (!is_new) return known->second;
    const Texture* const texture = materials_.texture(material);
    Kinds kinds;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Kind kind{mesh.corner_normals(i).has_value(), mesh.corner_values(mesh.colors, i).has_value(),
                        texture != nullptr && mesh.corner_values(mesh.texture_coordinates, i).has_value()};
        kinds[kind.number()].push_back(i);
    }
    Json primitives = Json::array();
    for (std::size_t number = 0; number < kinds.size(); ++number) {
        const std::vector<std::uint32_t>& triangles = kinds[number];
        if (triangles.empty()) continue;
        const Kind kind{(number & 1) != 0, (number & 2) != 0, (number & 4) != 0};
        MaterialUse use{material, color, kind.textured, false};
        if (kind.colors) use = colored_use(mesh, use, rule);
        const bool is_all = triangles.size() == mesh.triangles.size();
        const Numbers& of = numbers(mesh, kind, is_all ? nullptr : &triangles, materials_.color(use),
                                    kind.textured ? texture : nullptr, rule);
        primitives.push_back(
            {{"attributes", of.attributes}, {"indices", of.indices}, {"material", materials_.use(use)}});
    }
    if (primitives.empty()) return k_no_index;
    Json item = Json::object();
    if (!name.empty()) item["name"] = name;
    item["primitives"] = std::move(primitives);
    known->second = file_.add(List::meshes, item);
    return known->second;
}

}  // namespace glint::gltf_export
