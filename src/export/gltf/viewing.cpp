// SPDX-License-Identifier: Apache-2.0
#include "export/gltf/viewing.h"

#include "export/gltf/colors.h"
#include "export/gltf/placement.h"
#include "math/elementary.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::gltf_export {
namespace {

constexpr double k_pi = 3.14159265358979323846;
constexpr double k_brightest = 1e12;       // that glint reads
constexpr double k_narrowest_yfov = 1e-9;  // 0 is no angle

// The node at `position` that looks along `forward`. y is as near to `up` as it can be.
Affine looking(Vec3 position, Vec3 forward, Vec3 up) {
    const Vec3 ahead = normalize(forward);
    Vec3 x = normalize(cross(ahead, up));
    if (x == Vec3{}) x = normalize(cross(ahead, number::abs(ahead.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    const Vec3 y = normalize(cross(x, ahead)), z = -ahead;
    return {{{x.x, y.x, z.x, position.x}, {x.y, y.y, z.y, position.y}, {x.z, y.z, z.z, position.z}}};
}

struct Sight {
    Vec3 forward, up;
    double tangent = 0;  // perspective: of half the angle of the picture's height
    double width = 0;    // orthographic
};

Sight sight_of(const Camera& camera, double aspect, Losses& losses) {
    if (camera.frame) {
        const CameraFrame& f = *camera.frame;
        const double height = length(f.up), right = length(f.right);
        const Vec3 x = normalize(f.right), y = normalize(f.up), z = normalize(f.forward);
        constexpr double k_close = 1e-6;
        if (number::abs(dot(x, y)) > k_close || number::abs(dot(x, z)) > k_close ||
            number::abs(dot(y, z)) > k_close || number::abs(right - height * aspect) > k_close * right)
            losses.add("cameras that are sheared or whose pixels are not square", "it is the nearest one");
        return {f.forward, f.up, height / (2 * length(f.forward)), right};
    }
    Sight sight{camera.look_at - camera.position, camera.up, 0, camera.width};
    sight.tangent = tan_degrees(camera.fov_degrees / 2);
    if (camera.fov_axis == FovAxis::x) sight.tangent /= aspect;
    return sight;
}

// f_att at a distance, without the limit of 1.
double attenuation_at(const Light& light, double distance) {
    const Attenuation& a = light.attenuation;
    const double c = a.c0 + a.c1 * distance + a.c2 * distance * distance;
    double factor = c > 0 ? 1 / c : 1;
    if (light.fades()) factor *= 2 / (1 + pow(distance / light.fade_distance, light.fade_power));
    return factor;
}

// The intensity in candela for each unit of the light's color.
double candela(const Light& light, double distance, bool clamps, Losses& losses) {
    const Attenuation& a = light.attenuation;
    if (a.c0 == 0 && a.c1 == 0 && a.c2 > 0 && !light.fades()) return k_pi / a.c2;
    losses.add("fall-offs of lights other than 1 / d^2",
               "they are as bright as they were, at the distance of most shapes");
    double factor = attenuation_at(light, distance);
    if (clamps) factor = number::min(factor, 1.0);
    return k_pi * factor * distance * distance;
}

void warn_of(const Light& light, Losses& losses) {
    if (light.is_area()) losses.add("area lights", "each is a point light at its middle");
    if (!light.casts_shadows) losses.add("lights without shadows", "they have shadows");
    if (!(light.specular_color == light.color))
        losses.add("specular colors of lights", "highlights have the color of the light");
    if (light.is_spot() && (light.tightness > 0 || light.outer_angle > 90))
        losses.add("`tightness` and angles above 90 degrees of spots", "they are left out");
}

Json spot_of(const Light& light) {
    const double outer = number::min(light.outer_angle / 180 * k_pi, k_pi / 2);
    // The inner angle has to be smaller.
    const double inner = number::min(light.inner_angle / 180 * k_pi, outer * (1 - 1e-6));
    return {{"innerConeAngle", inner}, {"outerConeAngle", outer}};
}

}  // namespace

bool is_left_handed(const Camera& camera) {
    if (!camera.frame) return false;
    return dot(cross(camera.frame->forward, camera.frame->up), camera.frame->right) < 0;
}

void add_camera(File& file, const Scene& scene, const Affine& file_from_world, const Extent& box,
                Losses& losses) {
    const Camera& camera = scene.camera;
    const double aspect = static_cast<double>(scene.settings.width) / scene.settings.height;
    const Sight sight = sight_of(camera, aspect, losses);
    const Vec3 position = transform_point(file_from_world, camera.position);
    const bool is_empty = !(box.lo.x <= box.hi.x);
    const double reach =
        is_empty ? 1 : number::max(length(position - (box.lo + box.hi) / 2), 1e-9) + length(box.hi - box.lo);
    // glint has no such planes: far beyond the shapes, and near enough for what is close to the eye.
    const double near = reach / 1000, far = reach * 100;
    Json item;
    if (camera.projection == Projection::perspective) {
        // An angle of the height stays as it is.
        const bool is_given = camera.has_fov() && camera.fov_axis == FovAxis::y;
        const double yfov = is_given ? camera.fov_degrees / (180 / k_pi) : 2 * atan2(sight.tangent, 1);
        item = {
            {"type", "perspective"},
            {"perspective", {{"yfov", number::max(yfov, k_narrowest_yfov)}, {"znear", near}, {"zfar", far}}}};
    } else {
        item = {{"type", "orthographic"},
                {"orthographic",
                 {{"xmag", sight.width / 2},
                  {"ymag", sight.width / aspect / 2},
                  {"znear", near},
                  {"zfar", far}}}};
    }
    if (camera.lighting_eye) losses.add("eyes of highlights (`lighting_eye`)", "they are left out");
    const Affine node = looking(position, transform_vector(file_from_world, sight.forward),
                                transform_vector(file_from_world, sight.up));
    Json place{{"name", "camera"}, {"camera", file.add(List::cameras, item)}};
    add_placement(place, node);
    file.add(List::nodes, place);
}

void add_lights(File& file, const Scene& scene, const Affine& file_from_world, const ShapeMeshes& shapes,
                Losses& losses) {
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        if (light.is_ambient()) {
            losses.add("ambient light", "it is left out");
            continue;
        }
        warn_of(light, losses);
        const Vec3 position =
            light.has_position() ? transform_point(file_from_world, light.position) : Vec3{};
        const Vec3 forward = light.has_direction() ? -light.to_light
                             : light.has_axis()    ? light.axis
                                                   : Vec3{0, 0, -1};
        const double unit = light.has_position() ? candela(light, shapes.distance_from(position),
                                                           scene.conventions.clamp_attenuation, losses)
                                                 : k_pi;
        const double strongest = greatest(light.color);
        const auto channel = [&](double c) { return strongest > 0 ? number::max(c / strongest, 0.0) : 0; };
        Json item = Json::object();
        const std::string name(scene.light_texts.name(i));
        if (!name.empty()) item["name"] = name;
        item["type"] = light.is_spot() ? "spot" : light.has_position() ? "point" : "directional";
        item["color"] = {channel(light.color.r), channel(light.color.g), channel(light.color.b)};
        item["intensity"] = number::min(number::max(strongest, 0.0) * unit, k_brightest);
        if (light.is_spot()) item["spot"] = spot_of(light);
        Json node = Json::object();
        if (!name.empty()) node["name"] = name;
        add_placement(node, looking(position, transform_vector(file_from_world, forward), {0, 1, 0}));
        node["extensions"] = {{"KHR_lights_punctual", {{"light", file.add(List::lights, item)}}}};
        file.add(List::nodes, node);
        file.use_extension("KHR_lights_punctual");
    }
}

}  // namespace glint::gltf_export
