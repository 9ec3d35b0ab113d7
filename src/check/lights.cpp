// SPDX-License-Identifier: Apache-2.0
// Lights that add nothing to the picture, found by rendering it with each of them alone; and the reason.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <unordered_map>

#include "check/checks.h"
#include "check/light_effects.h"
#include "math/number.h"

namespace glint {
namespace {

constexpr std::size_t k_max_groups =
    256;  // of lights that are rendered together: one light each, if there are at most 256
constexpr std::size_t k_max_dark = 256;  // whose reasons are looked for
constexpr std::size_t k_max_weak_named = 5;
constexpr double k_max_leak = 0.01;  // of the picture, and of the points that face the light
constexpr std::size_t k_max_lit_points = 4096;
constexpr std::size_t k_edge = 1000;  // points of which at most one is on an edge that a light behind reaches
constexpr double k_handful = 0.0002, k_dim = 0.15;  // of the picture, and in a channel

// Why points that the camera sees get no light from a light.
struct Blockage {
    std::size_t points = 0, facing = 0, in_cone = 0, reflecting = 0, blocked = 0;
    std::uint32_t blocker = k_none;  // the shape that most shadow rays of reflecting points meet
    std::size_t by_blocker = 0;
    bool beyond = false;  // most of those meet it beyond the light
};

bool reflects(const WorldParts& world, SurfaceId id, const Light& light) {
    const auto m = surface_values(world, id);
    const Color diffuse{m[k_diffuse], m[k_diffuse + 1], m[k_diffuse + 2]};
    const Color specular{m[k_specular], m[k_specular + 1], m[k_specular + 2]};
    return !is_black(diffuse * light.color) || !is_black(specular * light.specular_color);
}

Blockage find_blockage(const CheckContext& context, const VisibleHits& visible, const Light& light) {
    struct Count {
        std::size_t all = 0, beyond = 0;
    };
    const WorldParts& world = context.world();
    const ShadowRays shadows = shadow_rays(world, visible, light, k_max_lit_points);
    Blockage found;
    found.points = shadows.points;
    found.facing = shadows.rays.size();
    found.in_cone = shadows.in_cone;
    for (const SurfaceId id : shadows.surface) found.reflecting += reflects(world, id, light) ? 1 : 0;
    if (!world.settings.shadows || !light.casts_shadows) return found;
    const HitList hits = nearest_occluders(world, shadows.rays, context.threads());
    const bool may_pass = light.has_position() && !shadows.from_light;
    std::unordered_map<std::uint32_t, Count> counts;
    for (std::size_t i = 0; i < hits.surface.size(); ++i) {
        if (!hits.surface[i].exists() || !reflects(world, shadows.surface[i], light)) continue;
        ++found.blocked;
        const std::uint32_t shape = world.geometry->shape_of(hits.surface[i]);
        Count& count = counts[shape];
        ++count.all;
        count.beyond += may_pass && hits.t[i] > 1 ? 1 : 0;
        if (count.all > found.by_blocker || (count.all == found.by_blocker && shape < found.blocker)) {
            found.by_blocker = count.all;
            found.blocker = shape;
        }
    }
    if (found.blocker != k_none) found.beyond = 2 * counts[found.blocker].beyond > counts[found.blocker].all;
    return found;
}

// Whether next to none of the points faces the light: on an edge, rounding may turn a pixel to it.
bool is_behind(const Blockage& b) { return k_edge * b.facing <= b.points; }

// The closed shape that encloses a light, or k_none: the light is inside and the visible points are not.
std::uint32_t case_of(const CheckContext& context, const Light& light, const Blockage& b) {
    const Scene& scene = context.scene();
    if (!light.has_position() || !light.casts_shadows || !context.world().settings.shadows || b.beyond)
        return k_none;
    std::vector<std::uint32_t> around_camera;
    if (b.facing == 0) around_camera = shapes_around(context, scene.camera.position);
    for (const std::uint32_t shape : shapes_around(context, light.position)) {
        if (b.facing > 0) {
            if (shape == b.blocker) return shape;
            continue;
        }
        const Material& material = context.material_of(shape);
        const Conventions& rules = scene.conventions;
        const bool clear =
            (material.transmission > 0 && rules.glass_shadow == GlassShadow::none) ||
            (material.is_transparent() && rules.transparent_shadow != TransparentShadow::opaque);
        const bool sees_in =
            std::find(around_camera.begin(), around_camera.end(), shape) != around_camera.end();
        if (!clear && !sees_in) return shape;
    }
    return k_none;
}

// True if almost no visible point gets the light. A shadow ray that starts a little off its surface can pass
// the blocker where two shapes touch, so a few points may be lit.
bool is_shut_off(const CheckContext& context, const VisibleHits& visible, std::uint32_t index) {
    const Blockage b = find_blockage(context, visible, context.scene().lights[index]);
    return b.blocker != k_none &&
           static_cast<double>(b.blocked) >= (1 - k_max_leak) * static_cast<double>(b.reflecting);
}

// True if the light is behind everything, but for a handful of pixels on edges. A small shape that is turned
// to the light has more of it.
bool lights_only_edges(const CheckContext& context, const VisibleHits& visible, Effects& effects,
                       std::uint32_t index, const Effect& first_look) {
    return first_look.share < k_handful && first_look.most < k_dim &&
           is_behind(find_blockage(context, visible, context.scene().lights[index])) &&
           effects.of({&index, 1}, k_second_look).share < k_handful;
}

std::string blocked_remedy(Effects& effects, const Light& light, bool plane) {
    if (light.has_position()) {
        return plane ? "move the light to the other side of the plane"
                     : "move the light, or the shape that blocks it";
    }
    Light negated = light;
    negated.to_light = -light.to_light;
    if (!(effects.of(std::vector{negated}, k_first_look).most >= k_half_byte))
        return "turn the light's direction, or move the shape that blocks it";
    return fmt::format("negate the direction, which points from the surface towards the light: write {}",
                       vector_text(negated.to_light));
}

void report_dark(CheckContext& context, const VisibleHits& visible, Effects& effects, std::uint32_t index) {
    const Light& light = context.scene().lights[index];
    const FindingPlace place = context.at_light(index);
    const std::string name = context.light(index);
    const Blockage b = find_blockage(context, visible, light);
    const std::uint32_t around = case_of(context, light, b);
    if (around != k_none) {
        return context.report(
            "light-inside-shape", place,
            fmt::format("{} is inside {}, which blocks its light from all that the camera sees", name,
                        context.shape_and_line(around)),
            "move the light out of the shape");
    }
    if (is_behind(b)) {
        return context.report(
            "light-behind-everything", place,
            fmt::format("{} is behind every surface that the camera sees: N.L <= 0 at all {}of {} points",
                        name, b.facing == 0 ? "" : fmt::format("but {} ", b.facing), b.points),
            light.has_position() ? "move the light to the side of the surfaces that the camera sees"
                                 : "negate the direction: it points from the surface towards the light");
    }
    if (b.in_cone == 0 && light.has_emitter_cosine()) {
        return context.report(
            "area-light-faces-away", place,
            fmt::format("{} gives light on one side only, and none of {} points that face it is on that side",
                        name, b.facing),
            light.is_disc() ? "negate its axis, or set one_sided = false"
                            : "exchange side_u and side_v, or set one_sided = false");
    }
    if (b.in_cone == 0) {
        return context.report(
            "spot-aimed-elsewhere", place,
            fmt::format(
                "{} lights nothing that the camera sees: none of {} points that face it is within {:.4g} "
                "degrees of its axis",
                name, b.facing, light.outer_angle),
            "turn the axis, aim the spot with `target`, or raise `outer_angle`");
    }
    const auto& occlusion = context.scene().occlusion;
    if (occlusion && occlusion->direct == 0) {
        return context.report(
            "light-adds-nothing", place,
            fmt::format("{} adds nothing to the picture: `direct` of the occlusion is 0, so that lights "
                        "with a place or a direction are not used",
                        name),
            "give the occlusion a `direct` above 0, or remove the light");
    }
    if (b.reflecting == 0) {
        return context.report(
            "light-adds-nothing", place,
            fmt::format("{} adds nothing to the picture: no material that the camera sees reflects its color",
                        name),
            "give the materials diffuse or specular coefficients, or remove the light");
    }
    // The rays of the small picture differ from these: a few may pass an edge.
    if (b.blocker == k_none || 2 * b.blocked < b.reflecting) {
        return context.report(
            "light-adds-nothing", place,
            fmt::format("{} adds nothing to the picture, although {} visible points face it, reflect its "
                        "color and are not in shadow",
                        name, b.reflecting - b.blocked),
            "`glint explain` at one of its pixels says what the light is multiplied by");
    }
    if (b.beyond) {
        return context.report(
            "light-blocked", place,
            fmt::format("{} lights nothing that the camera sees: {} is beyond it, from {} of {} points, and "
                        "shadow rays do not stop at the light",
                        name, context.shape_and_line(b.blocker), b.by_blocker, b.reflecting),
            "set shadow_stops_at_light = true");
    }
    const bool plane = context.scene().shapes[b.blocker].kind == ShapeKind::plane;
    context.report(plane ? "light-behind-plane" : "light-blocked", place,
                   fmt::format("{} lights nothing that the camera sees: {} is between it and {} of {} points",
                               name, context.shape_and_line(b.blocker), b.by_blocker, b.reflecting),
                   blocked_remedy(effects, light, plane));
}

void check_ambient(CheckContext& context, std::uint32_t index) {
    const Scene& scene = context.scene();
    if (scene.shapes.empty() || context.is_implied_light(index)) return;
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i)
        if (!is_black(context.material_of(i).ambient)) return;
    context.report(
        "light-adds-nothing", context.at_light(index),
        fmt::format("{} adds nothing: no shape's material has an ambient coefficient", context.light(index)),
        "give the materials `ambient`, or remove the light");
}

// Lights each of which adds too little to be visible: a mistake unless their sum is visible.
void report_weak(CheckContext& context, Effects& effects, std::span<const std::uint32_t> weak) {
    if (weak.empty()) return;
    const double effect = effects.of(weak, weak.size() == 1 ? k_second_look : k_first_look).most;
    if (effect >= k_half_byte) return;
    const Scene& scene = context.scene();
    bool attenuated = true;
    for (const std::uint32_t index : weak) attenuated = attenuated && scene.lights[index].falls_off();
    std::string what = context.light(weak[0]) + " adds";
    if (weak.size() > 1) {
        what = fmt::format("{} lights (", weak.size());
        for (std::size_t i = 0; i < weak.size() && i < k_max_weak_named; ++i)
            what += (i == 0 ? "" : ", ") + context.light(weak[i]);
        what += weak.size() > k_max_weak_named ? "...) add together" : ") add together";
    }
    context.report(
        "light-too-weak", context.at_light(weak[0]),
        fmt::format("{} {:.2g} of 255 to the brightest pixel, which is not visible", what, effect * 255),
        attenuated ? "raise the intensity, or reduce the attenuation" : "raise the intensity");
}

}  // namespace

void check_lights(CheckContext& context, const VisibleHits& visible) {
    const Scene& scene = context.scene();
    const Shading shading = scene.settings.shading;
    if (shading == Shading::color || shading == Shading::normals) return;
    std::vector<std::uint32_t> lights, weak;
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        if (!check_light_color(context, i)) continue;
        if (!scene.lights[i].is_ambient())
            lights.push_back(i);
        else if (shading != Shading::diffuse)
            check_ambient(context, i);
    }
    check_equal_lights(context, visible);
    if (shading != Shading::diffuse) check_only_ambient(context, visible);
    check_lights_around(context, visible);
    Effects effects(context);
    std::erase_if(lights, [&](std::uint32_t i) {
        return !check_place(context, i) || !check_spot_angle(context, effects, i) ||
               !check_spot_tightness(context, effects, i);
    });
    const std::size_t groups = std::min(lights.size(), k_max_groups);
    std::int32_t longest = k_first_look;
    for (std::size_t n = groups; n > k_full_looks; n /= 4) longest /= 2;
    std::size_t looked_twice = 0, dark = 0;
    std::vector<std::uint32_t> faint;
    const auto note_if_faint = [&](std::span<const std::uint32_t> group, double effect) {
        if (group.size() == 1 && effect < k_faint && scene.lights[group[0]].falls_off())
            faint.push_back(group[0]);
    };
    for (std::size_t g = 0; g < groups; ++g) {
        const std::size_t first = g * lights.size() / groups, end = (g + 1) * lights.size() / groups;
        const auto group = std::span<const std::uint32_t>(lights).subspan(first, end - first);
        const Effect first_look = effects.of(group, longest);
        if (first_look.most >= k_half_byte) {
            if (group.size() == 1 &&
                ((first_look.share < k_max_leak && is_shut_off(context, visible, group[0])) ||
                 lights_only_edges(context, visible, effects, group[0], first_look)))
                report_dark(context, visible, effects, group[0]);
            else
                note_if_faint(group, first_look.most);
            continue;
        }
        // A highlight may lie between the pixels of a small picture.
        const double effect =
            effects.of(group, looked_twice++ < k_full_looks ? k_second_look : k_first_look).most;
        if (effect >= k_half_byte) {
            note_if_faint(group, effect);
            continue;
        }
        for (const std::uint32_t index : group) {
            const bool is_dark = effect == 0 || (group.size() == 1 && is_shut_off(context, visible, index));
            if (is_dark && dark++ < k_max_dark)
                report_dark(context, visible, effects, index);
            else
                weak.push_back(index);
        }
    }
    report_weak(context, effects, weak);
    check_attenuation(context, visible, effects, faint);
    check_light_samples(context);
}

}  // namespace glint
