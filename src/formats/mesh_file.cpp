// SPDX-License-Identifier: Apache-2.0
#include "formats/mesh_file.h"

#include <fmt/format.h>

#include "base/text.h"
#include "formats/include.h"
#include "formats/registry.h"
#include "math/extent.h"
#include "math/transform.h"
#include "scene/ranges.h"

namespace glint {
namespace {

// A mesh without a camera is seen from the front, a little from the right and from above, at the distance
// from which a sphere around it touches two sides of the picture.
constexpr double k_fov_degrees = 40;
constexpr double k_distance = 2.9238044001630876;  // 1 / sin(k_fov_degrees / 2), of the sphere's radius
constexpr Vec3 k_to_eye{0.5, 0.4, 1};
// The main light is above the eye, to its left. A weaker one, without shadows, comes from the eye.
constexpr Vec3 k_to_light{-0.25, 1.2, 1};
constexpr double k_light_up = 0.75,
                 k_light_left = 0.6;  // almost the same for other views, in the eye's frame
constexpr double k_main_light = 0.8, k_eye_light = 0.2;

std::optional<std::uint32_t> mesh_of_text(LoadState& reading, const ReadText& text, MeshReader read) {
    if (const auto known = reading.meshes.find(text.file); known != reading.meshes.end())
        return known->second;
    std::shared_ptr<const MeshData> mesh = read(reading, text.place);
    if (!mesh) return std::nullopt;
    const auto index = static_cast<std::uint32_t>(reading.scene.meshes.size());
    reading.scene.meshes.push_back(std::move(mesh));
    reading.scene.mesh_files.resize(index, Scene::k_no_file);
    reading.scene.mesh_files.push_back(text.file);
    reading.meshes.emplace(text.file, index);
    return index;
}

// "`.ply`, `.stl` or `.obj`".
std::string mesh_extensions() {
    std::vector<std::string_view> all;
    for (const Format& format : all_formats()) {
        if (format.read_mesh != nullptr) all.push_back(format.info.extensions);
    }
    return one_of(all);
}

// Beyond this, the vertices of many shapes with transforms are too many to look at each.
constexpr std::uint64_t k_max_vertices = 1u << 24;

// Visits the vertices of the meshes as shapes place them; of the last shapes of very many, the corners of
// their boxes.
template <class Visit> void for_each_vertex(const Scene& scene, const Visit& visit) {
    struct Seen {
        bool is_whole = false;  // without a transform
        Extent box{};
    };
    std::vector<Seen> meshes(scene.meshes.size());
    std::uint64_t visited = 0;
    for (const Shape& shape : scene.shapes) {
        if (shape.kind != ShapeKind::mesh) continue;
        const std::uint32_t index = scene.get<Mesh>()[shape.index].mesh;
        const MeshData& mesh = *scene.meshes[index];
        Seen& seen = meshes[index];
        const bool is_whole = shape.transform == k_none;
        if (is_whole && seen.is_whole) continue;
        const auto place = [&](Vec3 p) {
            visit(is_whole ? p : transform_point(scene.transforms[shape.transform], p));
        };
        const Vec3 lo = seen.box.lo, hi = seen.box.hi;
        const auto count = static_cast<std::uint32_t>(mesh.vertex_count());
        visited += count;
        if (is_whole || visited <= k_max_vertices || !(lo.x <= hi.x)) {
            for (std::uint32_t v = 0; v < count; ++v) {
                seen.box.add(mesh.position(v));
                place(mesh.position(v));
            }
        } else {
            for (unsigned i = 0; i < 8; ++i)
                place({(i & 1) != 0 ? hi.x : lo.x, (i & 2) != 0 ? hi.y : lo.y, (i & 4) != 0 ? hi.z : lo.z});
        }
        seen.is_whole = seen.is_whole || is_whole;
    }
}

struct View {
    Vec3 to_eye = k_to_eye, to_light = k_to_light, up{0, 1, 0};
};

View view_from(const std::optional<Vec3>& direction) {
    if (!direction) return {};
    const Vec3 to_eye = normalize(*direction);
    Vec3 up{0, 1, 0}, right = cross(up, to_eye);
    if (!(length(right) > 1e-6)) up = {0, 0, to_eye.y > 0 ? -1.0 : 1.0}, right = cross(up, to_eye);
    right = normalize(right);
    return {to_eye, to_eye + cross(to_eye, right) * k_light_up - right * k_light_left, up};
}

void place_camera(Scene& scene, const View& view) {
    Extent box;
    for_each_vertex(scene, [&](Vec3 v) { box.add(v); });
    const Vec3 middle = (box.lo + box.hi) / 2;
    double radius = 0;
    for_each_vertex(scene, [&](Vec3 v) { radius = number::max(radius, length(v - middle)); });
    if (!(radius > 0)) radius = 1;
    // A smaller one would be lost in the camera's position.
    radius = number::max(radius, length(middle) * 1e-9);
    scene.camera.look_at = middle;
    scene.camera.position = middle + normalize(view.to_eye) * (radius * k_distance);
    scene.camera.up = view.up;
    scene.camera.fov_degrees = k_fov_degrees;
    scene.camera.fov_axis = scene.settings.width <= scene.settings.height ? FovAxis::x : FovAxis::y;
}

}  // namespace

void read_mesh_text(LoadState& reading, const ReadText& text, MeshReader read) {
    const auto mesh = mesh_of_text(reading, text, read);
    if (!mesh) return;
    const std::uint32_t shape = reading.scene.add(Mesh{*mesh});
    note(reading.scene.shape_texts, shape, {1, 1, text.file});
    if (!text.is_included) reading.lone_mesh = text.file;
}

std::optional<std::uint32_t> mesh_of_file(LoadState& reading, const ReadText& from, const Token& at,
                                          const std::string& name) {
    std::string why;
    const Format* const format = find_format({name, {}, {}}, why);
    if (format == nullptr || format->read_mesh == nullptr) {
        reading.diagnostics.error(
            from.place, at.offset, at.length,
            fmt::format("{}: expected the name of a file that ends in {}", quoted(name), mesh_extensions()));
        return std::nullopt;
    }
    const auto text = open_text(reading, from, at, name);
    return text ? mesh_of_text(reading, *text, format->read_mesh) : std::nullopt;
}

void set_mesh_defaults(Scene&) {}

void finish_mesh(LoadState& reading) {
    if (!reading.lone_mesh || reading.diagnostics.any_errors()) return;
    const InputText text = reading.texts[*reading.lone_mesh];
    reading.lone_mesh.reset();  // this is called for each format of meshes
    Scene& scene = reading.scene;
    const View view = view_from(reading.options.view);
    if (!reading.camera_given) {
        reading.is_view_used = true;
        place_camera(scene, view);
        if (!is_coordinate(scene.camera.position)) {
            reading.diagnostics.error(text, 0, 1,
                                      "the mesh is so large that a camera which shows all of it is beyond "
                                      "1e12: expected smaller coordinates, or a camera");
            return;
        }
    }
    if (!scene.lights.empty()) return;
    Light ambient;
    ambient.kind = LightKind::ambient;
    ambient.color = Color{1, 1, 1} * reading.mesh_ambient_light;
    const auto directional = [](Vec3 to_light, double strength, bool casts_shadows) {
        Light light;
        light.kind = LightKind::directional;
        light.to_light = to_light;
        light.color = light.specular_color = Color{strength, strength, strength};
        light.casts_shadows = casts_shadows;
        return light;
    };
    scene.lights = {ambient, directional(view.to_light, k_main_light, true),
                    directional(view.to_eye, k_eye_light, false)};
}

std::vector<std::string> mesh_file_names(const Scene& scene) {
    std::vector<std::string> names(scene.meshes.size());
    for (std::size_t i = 0; i < names.size() && i < scene.mesh_files.size(); ++i) {
        if (scene.mesh_files[i] != Scene::k_no_file) names[i] = scene.files[scene.mesh_files[i]];
    }
    return names;
}

}  // namespace glint
