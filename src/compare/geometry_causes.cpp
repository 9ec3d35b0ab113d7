// SPDX-License-Identifier: Apache-2.0
#include "compare/geometry_causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compare/item_texts.h"
#include "compare/scene_faults.h"
#include "compare/soft_shadow_causes.h"
#include "math/elementary.h"
#include "math/transform.h"
#include "world/prepare_camera.h"

namespace glint {
namespace {

using Values = std::span<const double>;

constexpr std::size_t k_max_shapes = 6, k_max_moved_lights = 8;
constexpr double k_light_unit = 0.02, k_camera_unit = 0.01, k_sphere_unit = 0.05;  // of distance or radius
constexpr double k_axis_unit = 0.02;                                               // of the unit axis
constexpr double k_view_unit = 0.01, k_color_unit = 0.05;
constexpr double k_widest_start = 150;  // from which the field of view is fitted
constexpr double k_said = 0.05;         // a part of a way that is worth a word

Vec3 vec_of(Values v) { return {v[0], v[1], v[2]}; }

// Numbers that a reader can take in, with 3 digits or more.
std::string text_of(double v, int digits = 3) {
    double unit = 0.5;
    for (int i = 0; i < digits; ++i) unit /= 10;
    return fmt::format("{:.{}g}", std::fabs(v) < unit ? 0 : v, digits);
}
std::string text_of(Vec3 v, int digits = 3) {
    return fmt::format("({}, {}, {})", text_of(v.x, digits), text_of(v.y, digits), text_of(v.z, digits));
}
std::string text_of(Color c) { return text_of(Vec3{c.r, c.g, c.b}); }

// "(0, 1, 2), and in the reference at (0, 1, 2.5)": with the digits that tell them apart.
std::string places_text(Vec3 here, Vec3 there) {
    int digits = 3;
    while (digits < 9 && text_of(here, digits) == text_of(there, digits)) ++digits;
    return fmt::format("{}, and in the reference at {}", text_of(here, digits), text_of(there, digits));
}

// "seen from the camera 0.4 further right, 0.2 higher"
std::string way_text(const Scene& scene, Vec3 by) {
    const PreparedCamera camera = prepare_camera(scene.camera, scene.settings);
    const double whole = length(by);
    std::vector<std::string> parts;
    const auto add = [&](Vec3 axis, const char* there, const char* back) {
        const double along = dot(by, normalize(axis));
        if (std::fabs(along) >= k_said * whole)
            parts.push_back(fmt::format("{:.2g} {}", std::fabs(along), along > 0 ? there : back));
    };
    add(camera.right, "further right", "further left");
    add(camera.up, "higher", "lower");
    add(camera.forward, "further away", "nearer");
    return fmt::format("seen from the camera {}", fmt::join(parts, ", "));
}

void add_lights(const Scene& scene, std::vector<FittedCause>& causes) {
    if (!is_lit(scene)) return;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < scene.lights.size() && count < k_max_moved_lights; ++i) {
        const Light& light = scene.lights[i];
        if (is_ambient(light)) continue;
        ++count;
        const std::string name = capitalized(item_text(scene, "light", i, scene.light_texts));
        const bool is_point = light.has_position();
        const Vec3 was = is_point ? light.position : normalize(light.to_light);
        const double far = is_point ? length(light.position - scene.camera.look_at) : 1;
        const double unit = k_light_unit * std::max(far, 1e-3);
        causes.push_back(
            {"light-moved",
             {unit, unit, unit},
             [i, was, is_point](FaultyScene& s, Values v) {
                 (is_point ? s.shading.lights[i].position : s.shading.lights[i].to_light) = was + vec_of(v);
             },
             [&scene, name, was, is_point](Values v, bool) {
                 if (!is_point)
                     return fmt::format(
                         "{} shines from the direction {}, and in the reference "
                         "from {} (the vector to the light).",
                         name, text_of(normalize(was + vec_of(v))), text_of(was));
                 return fmt::format("{} stands at {}: {}.", name, places_text(was + vec_of(v), was),
                                    way_text(scene, vec_of(v)));
             }});
    }
}

void add_spots(const Scene& scene, std::vector<FittedCause>& causes) {
    if (!is_lit(scene)) return;
    std::size_t count = 0;
    for (std::uint32_t i = 0; i < scene.lights.size() && count < k_max_moved_lights; ++i) {
        if (!scene.lights[i].is_spot()) continue;
        ++count;
        const Vec3 was = normalize(scene.lights[i].axis);
        causes.push_back(
            {"spot-turned",
             {k_axis_unit, k_axis_unit, k_axis_unit},
             [i, was](FaultyScene& s, Values v) { s.shading.lights[i].axis = was + vec_of(v); },
             [was, name = capitalized(item_text(scene, "light", i, scene.light_texts))](Values v, bool) {
                 return fmt::format("{} has the axis {}, and in the reference {}.", name,
                                    text_of(normalize(was + vec_of(v))), text_of(was));
             }});
    }
}

void add_camera(const Scene& scene, std::vector<FittedCause>& causes) {
    const Camera& camera = scene.camera;
    const std::string name = camera.frame || scene.camera_place.line == 0
                                 ? "The camera"
                                 : fmt::format("The camera ({})", line_text(scene, scene.camera_place));
    const double far = camera.frame ? 1 : length(camera.look_at - camera.position);
    const double unit = k_camera_unit * std::max(far, 1e-3);
    const auto position_text = [&scene, name](Values v, const char* more) {
        const Vec3 was = scene.camera.position;
        return fmt::format("{} stands at {}: {}{}.", name, places_text(was + vec_of(v), was),
                           way_text(scene, vec_of(v)), more);
    };
    causes.push_back({"camera-moved",
                      {unit, unit, unit},
                      [](FaultyScene& s, Values v) {
                          s.shading.camera.position = s.shading.camera.position + vec_of(v);
                          if (!s.shading.camera.frame)
                              s.shading.camera.look_at = s.shading.camera.look_at + vec_of(v);
                      },
                      [=](Values v, bool) { return position_text(v, "; it looks in the same direction"); }});
    if (camera.frame) return;
    causes.push_back(
        {"camera-moved",
         {unit, unit, unit},
         [](FaultyScene& s, Values v) { s.shading.camera.position = s.shading.camera.position + vec_of(v); },
         [=](Values v, bool) { return position_text(v, ""); }});
    causes.push_back(
        {"camera-turned",
         {unit, unit, unit},
         [](FaultyScene& s, Values v) { s.shading.camera.look_at = s.shading.camera.look_at + vec_of(v); },
         [&scene, name](Values v, bool) {
             const Vec3 was = scene.camera.look_at;
             return fmt::format("{} looks at {}.", name, places_text(was + vec_of(v), was));
         }});
}

// Also from the angles of the rows field-of-view-halved and -doubled: edges are too far from there at the
// scene's own.
void add_view(const Scene& scene, std::vector<FittedCause>& causes) {
    const Camera& camera = scene.camera;
    if (camera.projection != Projection::perspective) return;
    const bool has_angle = !camera.frame;
    const double unit = has_angle ? k_view_unit * camera.fov_degrees : k_view_unit;
    for (const double start : {1.0, 0.5, 2.0}) {
        if (start > 1 && has_angle && start * camera.fov_degrees > k_widest_start) continue;
        FittedCause cause{
            "field-of-view-scaled",
            {unit},
            [has_angle](FaultyScene& s, Values v) {
                Camera& c = s.shading.camera;
                if (has_angle) {
                    c.fov_degrees = std::clamp(c.fov_degrees + v[0], 0.1, 179.0);
                    return;
                }
                c.frame->right = c.frame->right * (1 + v[0]);
                c.frame->up = c.frame->up * (1 + v[0]);
            },
            [=, was = camera.fov_degrees](Values v, bool) {
                return has_angle
                           ? fmt::format("The field of view is {:.3g} degrees, and in the reference {:.3g}.",
                                         was + v[0], was)
                           : fmt::format("The viewport is {:.3g} times as large as in the reference.",
                                         1 + v[0]);
            }};
        cause.starts_far = start != 1;
        if (cause.starts_far) cause.start = {(start - 1) * (has_angle ? camera.fov_degrees : 1)};
        causes.push_back(std::move(cause));
    }
}

void add_sphere(const SceneRenderer& renderer, std::uint32_t shape, std::vector<FittedCause>& causes) {
    const Scene& scene = *renderer.with_shapes();
    if (scene.shapes[shape].kind != ShapeKind::sphere) return;
    const Sphere& sphere = scene.get<Sphere>()[scene.shapes[shape].index];
    const std::string name = capitalized(shape_text(scene, shape));
    const double unit = k_sphere_unit * sphere.radius;
    causes.push_back({"shape-moved",
                      {unit, unit, unit},
                      [shape](FaultyScene& s, Values v) {
                          s.spheres.push_back({shape, vec_of(v), 1});
                      },
                      [&scene, name, was = sphere.center](Values v, bool) {
                          return fmt::format("{} has its centre at {}: {}.", name,
                                             places_text(was + vec_of(v), was), way_text(scene, vec_of(v)));
                      }});
    causes.push_back({"shape-scaled",
                      {unit},
                      [shape, was = sphere.radius](FaultyScene& s, Values v) {
                          s.spheres.push_back({shape, {}, std::max(1 + v[0] / was, 0.01)});
                      },
                      [name, was = sphere.radius](Values v, bool) {
                          return fmt::format("{} has the radius {:.3g}, and in the reference {:.3g}.", name,
                                             was + v[0], was);
                      }});
}

// A coefficient as so much of the material's color.
double ratio(const Color& coefficient, const Color& color) {
    return largest(color) > 0 ? largest(coefficient) / largest(color) : 1;
}
bool is_proportional(const Color& a, const Color& color) {
    const double by = ratio(a, color);
    return std::fabs(a.r - by * color.r) + std::fabs(a.g - by * color.g) + std::fabs(a.b - by * color.b) <
           1e-6;
}

// Below 0 a fit does not see a difference.
Color clamped(Color c) { return {std::max(c.r, 0.0), std::max(c.g, 0.0), std::max(c.b, 0.0)}; }
Color moved(const Color& was, Values v) { return clamped(was + Color{v[0], v[1], v[2]}); }

void add_material(const Scene& scene, std::uint32_t index, std::vector<FittedCause>& causes) {
    if (index >= scene.materials.size()) return;
    const Material was = scene.materials[index];
    const std::string name = capitalized(item_text(scene, "material", index, scene.material_texts));
    causes.push_back({"material-color",
                      {k_color_unit, k_color_unit, k_color_unit},
                      [=](FaultyScene& s, Values v) {
                          const Color by{v[0], v[1], v[2]};
                          Material& m = s.shading.materials[index];
                          m.color = clamped(was.color + by);
                          m.ambient = clamped(m.ambient + by * ratio(was.ambient, was.color));
                          m.diffuse = clamped(m.diffuse + by * ratio(was.diffuse, was.color));
                          if (is_proportional(was.specular, was.color))
                              m.specular = clamped(m.specular + by * ratio(was.specular, was.color));
                      },
                      [=](Values v, bool) {
                          return fmt::format("{} has the color {}, and in the reference {}.", name,
                                             text_of(moved(was.color, v)), text_of(was.color));
                      }});
}

void add_background(const Scene& scene, std::vector<FittedCause>& causes) {
    if (scene.fog) {
        causes.push_back(
            {"fog-color",
             {k_color_unit, k_color_unit, k_color_unit},
             [](FaultyScene& s, Values v) { s.shading.fog->color = moved(s.shading.fog->color, v); },
             [was = scene.fog->color](Values v, bool) {
                 return fmt::format("The fog has the color {}, and in the reference {}.",
                                    text_of(moved(was, v)), text_of(was));
             }});
    }
    causes.push_back({"background",
                      {k_color_unit, k_color_unit, k_color_unit},
                      [](FaultyScene& s, Values v) { s.shading.background = moved(s.shading.background, v); },
                      [was = scene.background](Values v, bool) {
                          return fmt::format("The background is {}, and in the reference {}.",
                                             text_of(moved(was, v)), text_of(was));
                      }});
}

}  // namespace

std::vector<FittedCause> geometry_causes(const SceneRenderer& renderer,
                                         const std::vector<ShapeShare>& shares) {
    const Scene& scene = renderer.scene().shading;
    std::vector<FittedCause> causes;
    add_lights(scene, causes);
    add_spots(scene, causes);
    add_soft_shadows(scene, causes);
    add_view(scene, causes);
    add_camera(scene, causes);
    add_background(scene, causes);
    if (!renderer.with_shapes()) return causes;
    std::vector<std::uint32_t> materials;
    for (std::size_t i = 0; i < std::min(shares.size(), k_max_shapes); ++i) {
        if (shares[i].shape == k_none) continue;
        const std::uint32_t material = renderer.with_shapes()->shapes[shares[i].shape].material;
        add_sphere(renderer, shares[i].shape, causes);
        if (std::find(materials.begin(), materials.end(), material) != materials.end()) continue;
        materials.push_back(material);
        add_material(scene, material, causes);
    }
    return causes;
}

}  // namespace glint
