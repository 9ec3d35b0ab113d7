// SPDX-License-Identifier: Apache-2.0
// Values of lights that are probably mistakes: colors, lights that are equal or on a surface, spheres that
// contain shapes.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "check/light_effects.h"
#include "math/number.h"
#include "math/transform.h"
#include "scene/light_fields.h"
#include "world/geometry/primitive_bounds-inl.h"
#include "world/geometry/primitives.h"

namespace glint {
namespace {

constexpr double k_max_intensity = 10;  // without attenuation; 255 is a byte's
// Copies are at most this far apart, as a part of the distance to the nearest visible point (radians, for
// directions); lights with one color that are a lamp together are farther apart.
constexpr double k_copy_distance = 0.001;
constexpr std::size_t k_max_compared = 64;  // lights of one color, with each further one
constexpr std::size_t k_max_copies_named = 3;
// A millionth of a unit, in a direction that no surface has.
constexpr Vec3 k_beside{0.5773e-6, 0.6211e-6, 0.5301e-6};

// Whether the field says where a light is, or where it points: copies may differ there by rounding.
bool is_placing(const ItemField<Light>& field) {
    return is_field_of(field, &Light::position) || is_field_of(field, &Light::axis) ||
           is_field_of(field, &Light::to_light);
}

// The kind and the fields that it uses; those of its place only if they are asked for.
std::vector<std::uint64_t> bits_of(const Light& light, bool with_place) {
    std::vector<std::uint64_t> bits{static_cast<std::uint64_t>(light.kind)};
    for (const ItemField<Light>& field : k_light_fields) {
        if (applies(field, light) && (with_place || !is_placing(field)))
            visit_bits(field, light, [&](std::uint64_t b) { bits.push_back(b); });
    }
    return bits;
}

bool is_same_direction(Vec3 a, Vec3 b) { return length(b - a) <= k_copy_distance * length(a); }

// Whether two lights, equal in all else, are so near to each other that no visible point could tell them
// apart.
bool is_same_place(const Light& a, const Light& b, const VisibleHits& visible) {
    if (a.has_axis() && !is_same_direction(a.axis, b.axis)) return false;
    if (a.has_direction()) return is_same_direction(a.to_light, b.to_light);
    const double apart = length(b.position - a.position);
    return std::all_of(visible.seen().begin(), visible.seen().end(), [&](const SurfaceHit& h) {
        return apart <= k_copy_distance * length(h.point - a.position);
    });
}

// Lights that are one: the first, and its copies.
struct EqualLights {
    std::vector<std::uint32_t> lights;
    bool to_the_bit = true;
};

std::vector<EqualLights> find_equal_lights(const Scene& scene, const VisibleHits& visible) {
    std::vector<EqualLights> all;
    std::map<std::vector<std::uint64_t>, std::size_t> known;                   // in `all`, by all bits
    std::map<std::vector<std::uint64_t>, std::vector<std::size_t>> elsewhere;  // by those without the place
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        if (is_black(light.color) && (!light.has_specular_color() || is_black(light.specular_color)))
            continue;
        const auto [at, is_new] = known.emplace(bits_of(light, true), all.size());
        if (is_new && !light.is_ambient()) {
            std::vector<std::size_t>& others = elsewhere[bits_of(light, false)];
            const auto near = std::find_if(others.begin(), others.end(), [&](std::size_t other) {
                return is_same_place(scene.lights[all[other].lights.front()], light, visible);
            });
            if (near != others.end()) {
                at->second = *near;
                all[*near].to_the_bit = false;
            } else if (others.size() < k_max_compared) {
                others.push_back(all.size());
            }
        }
        if (at->second == all.size()) all.emplace_back();
        all[at->second].lights.push_back(i);
    }
    return all;
}

Vec3 absolute(Vec3 v) { return {number::abs(v.x), number::abs(v.y), number::abs(v.z)}; }

// Whether a shape with this box is inside the light.
bool is_inside_light(const Bounds& box, ShapeKind kind, const Light& light) {
    const Vec3 half = (box.max - box.min) * 0.5, way = absolute(box.min + half - light.position);
    // Of a sphere, the greatest radius; else the corner that is farthest away.
    if (kind == ShapeKind::sphere)
        return length(way) + number::max(half.x, number::max(half.y, half.z)) < light.radius;
    return length(way + half) < light.radius;
}

// The bulb of a lamp may be inside its light: it glows, lets the light through, or casts no shadow.
bool is_bulb(const Material& m) {
    return brightest(m.diffuse) <= 0 || brightest(m.emission) > 0 || !m.casts_shadow || m.is_transparent() ||
           m.transmission > 0;
}

}  // namespace

bool check_light_color(CheckContext& context, std::uint32_t index) {
    const Light& light = context.scene().lights[index];
    const FindingPlace place = context.at_light(index);
    if (is_black(light.color) && (!light.has_specular_color() || is_black(light.specular_color))) {
        context.report("light-without-color", place,
                       fmt::format("{} is black: it adds nothing", context.light(index)),
                       "give it a color or an intensity, or remove it");
        return false;
    }
    if (least(light.color) < 0) {
        context.report("light-negative", place,
                       fmt::format("{} has the color ({:.4g}, {:.4g}, {:.4g}): it removes light",
                                   context.light(index), light.color.r, light.color.g, light.color.b),
                       "give it a color and an intensity of 0 or more");
    }
    if (brightest(light.color) > k_max_intensity && !light.falls_off()) {
        const auto [r, g, b] = light.color;
        const bool is_white = r == g && g == b;
        context.report(
            "light-color-255", place,
            is_white
                ? fmt::format("{} has the intensity {:.4g}, where 1 is usual, and no attenuation: is it a "
                              "byte from 0 to 255, or a percentage?",
                              context.light(index), r)
                : fmt::format("{} has the color ({:.4g}, {:.4g}, {:.4g}), where 1 is the maximum, and no "
                              "attenuation: are these bytes from 0 to 255?",
                              context.light(index), r, g, b),
            is_white ? "write an intensity of at most about 1" : "divide the color by 255");
    }
    return true;
}

void check_equal_lights(CheckContext& context, const VisibleHits& visible) {
    constexpr std::string_view k_numbers[] = {"two", "three", "four"},
                               k_times[] = {"twice", "three times", "four times"};
    for (const auto& [lights, to_the_bit] : find_equal_lights(context.scene(), visible)) {
        const std::size_t count = lights.size(), word = count - 2;
        if (count < 2) continue;
        std::string copies = context.light(lights[1]);
        for (std::size_t i = 2; i < count && i <= k_max_copies_named; ++i)
            copies += (i + 1 == count ? " and " : ", ") + context.light_and_line(lights[i]);
        if (count > k_max_copies_named + 1)
            copies += fmt::format(" and {} more", count - k_max_copies_named - 1);
        const bool named = word < std::size(k_numbers);
        context.report("light-written-twice", context.at_light(lights[1]),
                       fmt::format("{} {} equal to {}, {}: the {} are one light of {} the intensity", copies,
                                   count == 2 ? "is" : "are", context.light_and_line(lights[0]),
                                   to_the_bit ? "also in place and color" : "and in almost the same place",
                                   named ? std::string(k_numbers[word]) : fmt::format("{}", count),
                                   named ? std::string(k_times[word]) : fmt::format("{} times", count)),
                       "keep one of them, or move the others to their intended places");
    }
}

bool check_place(CheckContext& context, std::uint32_t index) {
    const Light& light = context.scene().lights[index];
    const WorldParts& world = context.world();
    if (!light.has_position() || light.is_area() || !light.casts_shadows || !world.settings.shadows)
        return true;
    RayList ray;
    ray.add(light.position - k_beside, k_beside, 0, 2);
    const SurfaceId id = nearest_occluders(world, ray, 1).surface[0];
    if (!id.exists()) return true;
    const std::uint32_t shape = world.geometry->shape_of(id);
    // A disc may be the lamp that gives the light.
    const bool may_be_lamp =
        context.scene().shapes[shape].kind != ShapeKind::plane && !is_closed(context.scene(), shape);
    if (may_be_lamp || is_bulb(context.material_of(shape))) return true;
    context.report("light-on-surface", context.at_light(index),
                   fmt::format("{} is on {}, which gets no light from it", context.light(index),
                               context.shape_and_line(shape)),
                   "move the light off the surface");
    return false;
}

void check_lights_around(CheckContext& context, const VisibleHits& visible) {
    const Scene& scene = context.scene();
    const WorldParts& world = context.world();
    std::vector<bool> seen(scene.shapes.size());
    for (const SurfaceHit& h : visible.seen()) seen[h.shape] = true;
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        if (!light.is_sphere()) continue;
        for (std::uint32_t slot = 0; slot < world.geometry->bounded; ++slot) {
            const std::uint32_t shape = world.geometry->shape_index[slot];
            // Of a mesh, a part may be inside.
            if (!seen[shape] || (context.is_model() && !is_closed(scene, shape))) continue;
            if (!is_inside_light(to_bounds(HWY_NAMESPACE::primitive_bounds(*world.geometry, slot)),
                                 scene.shapes[shape].kind, light) ||
                is_bulb(context.material_of(shape)))
                continue;
            context.report(
                "light-around-shape", context.at_light(i),
                fmt::format("{} is a sphere of radius {:.4g} around {}: the shape is inside the light, "
                            "which shines on it from all sides",
                            context.light(i), light.radius, context.shape_and_line(shape)),
                "move the light away from the shape, or make its radius smaller");
            break;
        }
    }
}

}  // namespace glint
