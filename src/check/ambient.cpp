// SPDX-License-Identifier: Apache-2.0
// Ambient light that is as bright as the light of the lights, or that is the only light.
#include <fmt/format.h>

#include <algorithm>

#include "check/checks.h"
#include "world/geometry/primitives.h"

namespace glint {
namespace {

// Of the material's color: the ambient term, the diffuse term of one light, and both.
constexpr double k_much_ambient = 0.7, k_some_diffuse = 0.2, k_both = 1.25;
constexpr double k_flat_part = 0.4;   // ambient, of both: shadows have at least this part of the light
constexpr double k_min_shapes = 0.5;  // of the pixels that show bounded shapes

constexpr double k_one_side = 0.9;  // cosine: surfaces that face one way look the same in any light

struct Terms {
    double ambient = 0, diffuse = 0, color = 0;
    bool too_much() const {
        return color > 0 && ambient >= k_much_ambient * color && diffuse >= k_some_diffuse * color &&
               ambient + diffuse >= k_both * color && ambient >= k_flat_part * (ambient + diffuse);
    }
};

Terms terms_of(const CheckContext& context, SurfaceId id) {
    const WorldParts& world = context.world();
    const auto m = surface_values(world, id);
    const auto color_at = [&](int k) { return Color{m[k], m[k + 1], m[k + 2]}; };
    Terms terms;
    terms.ambient = brightest(color_at(k_ambient) * world.ambient);
    terms.color = brightest(color_at(k_color));
    for (const Light& light : context.scene().lights) {
        if (light.is_ambient()) continue;
        terms.diffuse =
            number::max(terms.diffuse, world.direct * brightest(color_at(k_diffuse) * light.color));
    }
    return terms;
}

// Whether the surface reflects the light of lights, but all that it shows is the ambient term of one color.
bool shows_only_ambient(const CheckContext& context, const SurfaceHit& h) {
    const WorldParts& world = context.world();
    if (world.texture_of(h.material) != nullptr) return false;  // a picture in even light may be wanted
    const auto m = surface_values(world, h.surface);
    const auto color_at = [&](int k) { return Color{m[k], m[k + 1], m[k + 2]}; };
    return brightest(color_at(k_diffuse)) > 0 && brightest(color_at(k_ambient) * world.ambient) > k_half_byte;
}

}  // namespace

void check_only_ambient(CheckContext& context, const VisibleHits& visible) {
    const Scene& scene = context.scene();
    const WorldParts& world = context.world();
    const bool is_lit = std::any_of(scene.lights.begin(), scene.lights.end(),
                                    [](const Light& light) { return !light.is_ambient(); });
    // Fog shows distances, a lamp that glows may be all that is meant to be bright, and the colors of
    // vertices may have the light in them.
    if (is_lit || world.ambient_lights->empty() || scene.fog || scene.occlusion ||
        world.uses<&Material::emission>() || world.geometry->has_mesh_colors)
        return;
    std::size_t flat = 0, all = 0;
    const SurfaceHit* first = nullptr;
    bool turns = false;  // drawings in one plane lose nothing
    for (const SurfaceHit& h : visible.seen()) {
        if (!world.geometry->is_bounded(h.surface) || (h.behind && is_closed(scene, h.shape))) continue;
        ++all;
        if (!shows_only_ambient(context, h)) continue;
        ++flat;
        if (first == nullptr) first = &h;
        turns = turns || dot(h.normal, first->normal) < k_one_side;
    }
    if (!turns || static_cast<double>(flat) < k_min_shapes * static_cast<double>(all)) return;
    context.report("light-only-ambient", context.at_light(world.ambient_lights->front().index),
                   "the only light is ambient: the shapes are flat patches of color, without shading, "
                   "highlights and shadows",
                   "add a light of another kind, such as a point light; if the picture is meant to be flat, "
                   "set shading = color");
}

void check_ambient_light(CheckContext& context, const VisibleHits& visible) {
    const Scene& scene = context.scene();
    const WorldParts& world = context.world();
    const Shading shading = scene.settings.shading;
    if ((shading != Shading::phong && shading != Shading::blinn_phong) || visible.seen().empty()) return;
    std::vector<std::int8_t> known(scene.shapes.size(), -1);
    std::size_t flat = 0, all = 0;
    SurfaceId first;
    for (const SurfaceHit& h : visible.seen()) {
        // Not skies: planes, and spheres around the camera.
        if (!world.geometry->is_bounded(h.surface) || (h.behind && is_closed(scene, h.shape))) continue;
        ++all;
        std::int8_t& is_flat = known[h.shape];
        if (is_flat < 0) is_flat = terms_of(context, h.surface).too_much() ? 1 : 0;
        if (is_flat == 0) continue;
        ++flat;
        if (!first.exists()) first = h.surface;
    }
    if (!first.exists() || static_cast<double>(flat) < k_min_shapes * static_cast<double>(all)) return;
    const Terms terms = terms_of(context, first);
    const std::uint32_t material = material_row(world, first);
    // Where the light is written in the file, else the material.
    FindingPlace place = context.at_material(material);
    for (const AmbientLight& light : *world.ambient_lights)
        if (scene.light_texts.place(light.index).line != 0) place = context.at_light(light.index);
    context.report(
        "ambient-too-strong", place,
        fmt::format(
            "ambient light is too strong: k_a I_a of {} is {:.2g} times its color, and a light adds only "
            "{:.2g} times: shadows are {:.0f}% as bright as what is lit, and the shapes look flat",
            context.material(material), terms.ambient / terms.color, terms.diffuse / terms.color,
            100 * terms.ambient / (terms.ambient + terms.diffuse)),
        "lower the intensity of the ambient light, or k_a, so that their product is about 0.1 to 0.3 of the "
        "color");
}

}  // namespace glint
