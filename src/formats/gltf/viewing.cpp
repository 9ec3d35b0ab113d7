// SPDX-License-Identifier: Apache-2.0
// Cameras, and the lights of KHR_lights_punctual. Both look along -z of their node.
#include <fmt/format.h>

#include "base/text.h"
#include "formats/gltf/contents.h"
#include "formats/profile_file.h"
#include "math/number.h"
#include "math/transform.h"
#include "scene/ranges.h"

namespace glint::gltf {
namespace {

constexpr double k_pi = 3.14159265358979323846;
constexpr double k_degrees = 180 / k_pi;
constexpr Range k_fov{0, k_pi, true, true, "an angle between 0 and pi"};
constexpr Range k_intensity{0, 1e12, false, false, "a number from 0 to 1e12"};
constexpr Range k_cone{0, k_pi / 2, false, false, "an angle from 0 to pi/2"};

constexpr double k_brightest = 10;  // that lights are left as they are: times white

Vec3 axis_of(const Affine& world_from_node, Vec3 axis) {
    return normalize(transform_vector(world_from_node, axis));
}

bool read_perspective(File& file, JsonValue from, Camera& camera) {
    double yfov = 0;
    if (!from.find("yfov").exists()) return file.expected(from, "an object with `yfov`");
    if (!file.number(from, "yfov", yfov, k_fov)) return false;
    camera.fov_degrees = yfov * k_degrees;
    camera.fov_axis = FovAxis::y;
    return true;
}

bool read_orthographic(File& file, JsonValue from, Camera& camera) {
    double xmag = 0, ymag = 0;
    if (!from.find("xmag").exists()) return file.expected(from, "an object with `xmag`");
    if (!file.number(from, "xmag", xmag, k_coordinate) || !file.number(from, "ymag", ymag, k_coordinate))
        return false;
    if (xmag == 0) return file.expected(from.find("xmag"), "a number other than 0", "xmag");
    camera.projection = Projection::orthographic;
    camera.width = 2 * number::abs(xmag);
    return true;
}

}  // namespace

void set_camera(File& file, JsonValue value, const Affine& world_from_node) {
    const std::optional<std::uint32_t> index = file.index(value, List::cameras);
    LoadState& reading = file.reading;
    if (!index || reading.camera_given) return;
    const JsonValue at = file.item(List::cameras, *index), type = at.find("type");
    Camera camera;
    if (type.string() == "perspective") {
        if (!read_perspective(file, at.find("perspective"), camera)) return;
    } else if (type.string() == "orthographic") {
        if (!read_orthographic(file, at.find("orthographic"), camera)) return;
    } else {
        file.expected(type.exists() ? type : at, "`perspective` or `orthographic`", "type");
        return;
    }
    const Vec3 forward = axis_of(world_from_node, {0, 0, -1}), up = axis_of(world_from_node, {0, 1, 0});
    if (is_zero(cross(forward, up)))
        return file.warn_once("gltf camera", value, "a camera with a scale of 0 is left out");
    camera.position = transform_point(world_from_node, {0, 0, 0});
    // Far from the origin, a point one unit ahead would have few digits.
    camera.look_at = camera.position + forward * number::max(1.0, length(camera.position));
    camera.up = up;
    reading.scene.camera = camera;
    reading.scene.camera_place = file.place(at);
    reading.camera_given = true;
}

// Intensities are in lux and candela. A white surface that is lit by pi lux reflects 1, the greatest number
// of a picture.
void add_light(File& file, JsonValue value, const Affine& world_from_node) {
    const std::optional<std::uint32_t> index = file.index(value, List::lights);
    if (!index) return;
    const JsonValue at = file.item(List::lights, *index), type = at.find("type"), spot = at.find("spot");
    Color color{1, 1, 1};
    double intensity = 1, inner = 0, outer = k_pi / 4, range = 0;
    if (!file.color(at, "color", color) || !file.number(at, "intensity", intensity, k_intensity) ||
        !file.number(at, "range", range, k_not_negative) ||
        !file.number(spot, "innerConeAngle", inner, k_cone) ||
        !file.number(spot, "outerConeAngle", outer, k_cone))
        return;
    Light light;
    light.position = transform_point(world_from_node, {0, 0, 0});
    light.axis = axis_of(world_from_node, {0, 0, -1});
    light.to_light = -light.axis;
    const std::string kind = type.string();
    if (kind == "directional") {
        light.kind = LightKind::directional;
    } else if (kind == "point" || kind == "spot") {
        light.kind = kind == "spot" ? LightKind::spot : LightKind::point;
        light.attenuation = {0, 0, 1};
    } else {
        file.expected(type.exists() ? type : at, "`directional`, `point` or `spot`", "type");
        return;
    }
    if (is_zero(light.axis))
        return file.warn_once("gltf light", value, "a light with a scale of 0 is left out");
    if (kind == "spot") {
        if (!(outer > 0 && inner <= outer)) {
            file.expected(spot.exists() ? spot : at, "an `innerConeAngle` of at most the `outerConeAngle`");
            return;
        }
        light.outer_angle = outer * k_degrees;
        light.inner_angle = number::min(inner * k_degrees, light.outer_angle);
    }
    const auto channel = [&](double c) { return number::min(c * (intensity / k_pi), k_channel.max); };
    light.color = light.specular_color = {channel(color.r), channel(color.g), channel(color.b)};
    Scene& scene = file.reading.scene;
    if (light.has_attenuation())
        set_named_setting(scene, "clamp_attenuation", "false", {SettingOrigin::Kind::file, file.place(at)});
    note(scene.light_texts, scene.lights.size(), file.place(at), file.string(at, "name"));
    scene.lights.push_back(light);
}

// A camera or an eye adapts to the light, and files have that of the sun (100000 lux), or of lamps in metres
// for scenes in any unit.
void limit_exposure(File& file, std::size_t first, const Extent& box) {
    std::vector<Light>& lights = file.reading.scene.lights;
    if (first >= lights.size() || !(box.lo.x <= box.hi.x)) return;
    const Vec3 middle = (box.lo + box.hi) / 2;
    const double radius = length(box.hi - box.lo) / 2;
    double sum = 0;  // of what a white surface in the middle reflects
    for (std::size_t i = first; i < lights.size(); ++i) {
        const Light& light = lights[i];
        const double strongest = number::max(light.color.r, number::max(light.color.g, light.color.b));
        // Near a light, the surfaces around it count.
        const double distance = number::max(length(light.position - middle), radius / 2);
        sum += light.has_position() ? strongest / number::max(distance * distance, 1e-300) : strongest;
    }
    if (!(sum > k_brightest)) return;
    for (std::size_t i = first; i < lights.size(); ++i)
        lights[i].color = lights[i].specular_color = lights[i].color * (1 / sum);
    const JsonValue at = file.root().find("extensions").find("KHR_lights_punctual");
    file.warn(at,
              fmt::format("the lights make a white surface {:.0f} times as bright as white: glint divides "
                          "all of them by {:.6g}",
                          number::min(sum, 1e18), sum));
}

}  // namespace glint::gltf
