// SPDX-License-Identifier: Apache-2.0
#include "compare/soft_shadow_causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/item_texts.h"
#include "compare/scene_faults.h"
#include "math/elementary.h"
#include "math/transform.h"

namespace glint {
namespace {

using Values = std::span<const double>;

constexpr std::size_t k_max_lights = 8;
constexpr double k_first_unit = 0.02;  // of the distance
constexpr double k_next_unit = 0.05;   // of a size that is known approximately
// A directional light becomes a light that is so much further away than the camera is from what it looks at.
constexpr double k_far = 1000;
constexpr double k_min_size = 1e-4;         // of the distance
constexpr double k_min_soft = 0.6;          // lights of another form leave more than other causes
constexpr std::size_t k_max_sizes = 6;      // that are fitted together
constexpr std::int32_t k_many_samples = 8;  // along each side: nearly as smooth as an infinite number
constexpr double k_degrees = 180 / 3.14159265358979;

// Rings and samples in each ring of the first sphere, whose radius is fitted coarsely.
constexpr std::int32_t k_first_rings = 2, k_first_around = 4;
// Radii and sides of lights with about the same second moments as a sphere of radius 1.
constexpr double k_disc_radius = 1.15, k_side = 2;

// A light that becomes an area light. Its sizes are in units of `unit`: 1, or the distance of a light that is
// far away, so that a size is the tangent of an angle.
struct HardLight {
    std::uint32_t index = 0;
    Vec3 position{};
    Vec3 axis{};  // unit vector towards what the camera looks at
    double distance = 1, unit = 1;
};

bool is_hard(const Light& l) {
    return !is_ambient(l) && !is_off(l) && !l.is_spot() && !l.is_area() && l.casts_shadows;
}

HardLight hard_light(const Scene& scene, std::uint32_t index) {
    const Light& light = scene.lights[index];
    const Vec3 target = scene.camera.look_at;
    HardLight hard{index, light.position, {}, 1, 1};
    if (light.has_direction()) {
        hard.unit = k_far * std::max(length(scene.camera.position - target), 1.0);
        hard.position = target + normalize(light.to_light) * hard.unit;
    } else {
        hard.distance = std::max(length(light.position - target), 1e-3);
    }
    const Vec3 way = target - hard.position;
    hard.axis = length(way) > 0 ? normalize(way) : Vec3{0, -1, 0};
    return hard;
}

// A kind of area light, of any size. Panels have two sizes, along u and v, others a radius.
struct Form {
    bool is_panel = false, is_disc = false;  // neither: a sphere
    bool is_facing = false;  // what the camera looks at: then axis, u and v depend on the light
    Vec3 axis{0, -1, 0}, u{1, 0, 0}, v{0, 0, 1};
    std::int32_t columns = k_first_rings, rows = k_first_around;
    bool jitter = false;

    std::size_t sizes() const { return is_panel ? 2 : 1; }
    LightKind kind() const {
        return is_panel ? LightKind::parallelogram : is_disc ? LightKind::disc : LightKind::sphere;
    }
};

void soften(const HardLight& hard, const Form& form, Values sizes, Light& light) {
    if (std::all_of(sizes.begin(), sizes.end(), [](double size) { return size == 0; })) return;
    const auto size = [&](std::size_t i) {
        return std::max(std::fabs(sizes[i]), k_min_size * hard.distance) * hard.unit;
    };
    if (light.has_direction()) light.attenuation = {};
    light.position = hard.position;
    light.kind = form.kind();
    light.samples_u = form.columns;
    light.samples_v = form.rows;
    light.jitter = form.jitter;
    if (!form.is_panel) {
        light.radius = size(0);
        light.axis = form.is_facing ? hard.axis : form.axis;
        return;
    }
    Vec3 u = form.u, v = form.v;
    if (form.is_facing) {
        const Vec3 other = std::fabs(hard.axis.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0};
        u = normalize(cross(hard.axis, other));
        v = cross(hard.axis, u);
    }
    light.side_u = u * size(0);
    light.side_v = v * size(1);
}

std::string light_text(const Scene& scene, const HardLight& hard, const Form& form, Values sizes,
                       bool with_samples) {
    const auto text = [&](double size) {
        return hard.unit > 1 ? fmt::format("{:.2g} degrees", k_degrees * atan2(std::fabs(size), 1))
                             : fmt::format("{:.2g}", std::fabs(size));
    };
    const std::string what =
        form.is_panel
            ? fmt::format("a panel of about {} x {}", text(sizes[0]), text(sizes[1]))
            : fmt::format("a {} with a radius of about {}", form.is_disc ? "disc" : "light", text(sizes[0]));
    std::string text_of_light =
        fmt::format("{} in place of {}", what, item_text(scene, "light", hard.index, scene.light_texts));
    if (with_samples) text_of_light += fmt::format(", with {} x {} samples", form.columns, form.rows);
    return text_of_light;
}

// The lights that become soft, each with its own sizes, or all with the same.
struct SoftLights {
    const Scene& scene;
    std::vector<HardLight> lights;
    bool same_sizes = false;

    Values sizes(Values all, std::size_t light, const Form& form) const {
        return all.subspan(same_sizes ? 0 : light * form.sizes(), form.sizes());
    }
};

enum class Step : std::uint8_t { first, form, samples };

FittedCause soft_cause(const SoftLights& soft, const Form& form, std::vector<double> start, Step step);

// The same lights in each form, with sizes near those that a sphere's radius suggests.
std::vector<FittedCause> other_forms(const SoftLights& soft, Values radii) {
    constexpr Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    const Form forms[] = {{},
                          {.is_panel = true, .is_facing = true},
                          {.is_panel = true, .u = x, .v = z},
                          {.is_panel = true, .u = x, .v = y},
                          {.is_panel = true, .u = z, .v = y},
                          {.is_disc = true, .is_facing = true},
                          {.is_disc = true, .axis = {0, -1, 0}},
                          {.is_disc = true, .axis = {0, 0, -1}}};
    SoftLights own = soft;
    own.same_sizes = soft.same_sizes && 2 * soft.lights.size() > k_max_sizes;
    const std::size_t lights = own.same_sizes ? 1 : own.lights.size();
    std::vector<FittedCause> causes;
    for (Form form : forms) {
        form.columns = form.rows = k_many_samples;
        const double by = form.is_panel ? k_side : form.is_disc ? k_disc_radius : 1;
        for (const double scale : {1.0, 0.8, 1.25}) {
            std::vector<double> start;
            for (std::size_t i = 0; i < lights; ++i)
                start.insert(start.end(), form.sizes(),
                             scale * by * std::fabs(radii[soft.same_sizes ? 0 : i]));
            causes.push_back(soft_cause(own, form, std::move(start), Step::form));
        }
    }
    return causes;
}

std::vector<FittedCause> other_samples(const SoftLights& soft, Form form, Values sizes) {
    std::vector<FittedCause> causes;
    const auto add = [&](std::int32_t columns, std::int32_t rows, bool jitter) {
        form.columns = columns;
        form.rows = rows;
        form.jitter = jitter;
        causes.push_back(soft_cause(soft, form, {sizes.begin(), sizes.end()}, Step::samples));
    };
    for (const std::int32_t n : {2, 3, 4, 5, 6, 8}) {
        add(n, n, false);
        add(n, n, true);
        add(n, 2 * n, false);
    }
    return causes;
}

FittedCause soft_cause(const SoftLights& soft, const Form& form, std::vector<double> start, Step step) {
    FittedCause cause{"shadows-soft", {}, {}, {}, k_min_soft};
    for (std::size_t i = 0; i < start.size(); ++i) {
        const HardLight& light = soft.lights[soft.same_sizes ? 0 : i / form.sizes()];
        cause.units.push_back(step == Step::first ? k_first_unit * light.distance
                                                  : k_next_unit * std::max(start[i], k_min_size));
    }
    cause.start = std::move(start);
    cause.put = [soft, form](FaultyScene& s, Values v) {
        for (std::size_t i = 0; i < soft.lights.size(); ++i)
            soften(soft.lights[i], form, soft.sizes(v, i, form), s.shading.lights[soft.lights[i].index]);
    };
    cause.text = [soft, form, step](Values v, bool) {
        std::vector<std::string> lights;
        for (std::size_t i = 0; i < soft.lights.size(); ++i)
            lights.push_back(
                light_text(soft.scene, soft.lights[i], form, soft.sizes(v, i, form), step == Step::samples));
        return fmt::format("Shadows have soft edges, as of {}: a light without an extent has one shadow ray.",
                           fmt::join(lights, ", and "));
    };
    if (step == Step::first) cause.refined = [soft](Values v) { return other_forms(soft, v); };
    if (step == Step::form) cause.refined = [soft, form](Values v) { return other_samples(soft, form, v); };
    return cause;
}

}  // namespace

void add_soft_shadows(const Scene& scene, std::vector<FittedCause>& causes) {
    if (!has_shadows(scene)) return;
    SoftLights points{scene, {}, true};
    for (std::uint32_t i = 0; i < scene.lights.size() && points.lights.size() < k_max_lights; ++i) {
        if (!is_hard(scene.lights[i])) continue;
        const SoftLights one{scene, {hard_light(scene, i)}};
        causes.push_back(soft_cause(one, {}, {0}, Step::first));
        if (scene.lights[i].has_position()) points.lights.push_back(one.lights.front());
    }
    if (points.lights.size() > 1) causes.push_back(soft_cause(points, {}, {0}, Step::first));
}

}  // namespace glint
