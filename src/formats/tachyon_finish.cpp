// SPDX-License-Identifier: Apache-2.0
// What depends on modes that a Tachyon text may set anywhere: the materials, the lights, the camera's frame;
// and the warnings about what glint has not.
#include <fmt/format.h>

#include "base/diagnostics.h"
#include "formats/profile_file.h"
#include "formats/registry.h"
#include "formats/tachyon.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint {
namespace {

// A weaker highlight, mirror or transparency is left out.
constexpr double k_min_contribution = 0.001959;

constexpr std::string_view k_limit_texts[] = {
    "the spheres of lights are in the fog here; in Tachyon they are not",
    "the endless cylinder ends a million radii from its Center",
    "near the edges of a box that is no cube Tachyon takes the normal of a neighbouring face; glint does not",
    ("the normals of this triangle have different lengths: glint interpolates unit normals, Tachyon the "
     "normals as they are"),
};
static_assert(std::size(k_limit_texts) == static_cast<std::size_t>(TachyonLimit::count));

// metal: the factor of the highlights of metal, which do not depend on the light's color.
Material material_of(const TachyonTexture& t, const TachyonState& state, double metal) {
    const double highlight = t.phong > k_min_contribution ? t.phong : 0;
    Material m;
    m.color = state.shader == TachyonShader::lowest ? Color{1, 1, 1} : t.color;
    m.ambient = t.color * t.ambient;
    m.diffuse = t.color * t.diffuse;
    m.specular = t.is_metal ? t.color * (highlight * metal) : Color{highlight, highlight, highlight};
    m.tinted_highlight = !t.is_metal;
    m.shininess = t.phong_size;
    m.mirror = t.specular > k_min_contribution ? t.specular : 0;
    m.outline = t.outline;
    m.outline_width = t.outline > 0 ? t.outline_width : 0;
    m.transmit = t.opacity < 1 - k_min_contribution ? 1 - t.opacity : 0;
    m.angled_opacity = m.transmit > 0 && (t.fades_at_angles || state.is_raster3d);
    return m;
}

void set_camera(LoadState& reading, const TachyonCamera& given) {
    Scene& scene = reading.scene;
    // The frame has the proportions of the picture, whose size an option may set.
    double width = scene.settings.width, height = scene.settings.height;
    for (const auto& [key, value] : reading.options.settings) {
        Scene probe;
        const auto setting = find_setting("size");
        if (key != "size" || !setting || !set_setting(probe, *setting, value, {})) continue;
        width = probe.settings.width;
        height = probe.settings.height;
    }
    const Vec3 view = normalize(given.view);
    const Vec3 x = normalize(cross(given.up, view));
    const Vec3 y = cross(view, x);
    Vec3 right = x * (width / height / given.aspect_ratio / given.zoom), up = y * (1 / given.zoom);
    if (given.frustum) {
        const TachyonCamera::Frustum& f = *given.frustum;
        right = x * (f.right - f.left);
        up = y * (f.top - f.bottom);
    }
    // Tachyon's rays pass the upper right corners of the pixels, and its further samples lie around these.
    Vec3 shift = right * (0.5 / width) + up * (0.5 / height);
    if (const auto& f = given.frustum)
        shift = shift + x * ((f->left + f->right) / 2) + y * ((f->bottom + f->top) / 2);
    Camera camera;
    camera.projection = given.projection;
    camera.position = given.center;
    camera.frame = CameraFrame{right, up, view};
    if (given.projection == Projection::orthographic) {
        camera.position = camera.position + shift;
    } else {
        camera.frame->forward = view + shift;
    }
    scene.camera = camera;
}

}  // namespace

void finish_tachyon(LoadState& reading) {
    if (!reading.tachyon) return;
    TachyonState& state = *reading.tachyon;
    Scene& scene = reading.scene;
    const bool has_occlusion = state.occlusion && state.shader == TachyonShader::full;
    for (const auto& [material, texture] : state.textures)
        scene.materials[material] = material_of(texture, state, has_occlusion ? 1 : state.light_scale);
    if (has_occlusion) {
        scene.occlusion = *state.occlusion;
        scene.occlusion->direct = state.light_scale;
        scene.occlusion_place = state.occlusion_place;
    } else {
        for (const std::uint32_t i : state.lights) {
            scene.lights[i].color = scene.lights[i].color * state.light_scale;
            scene.lights[i].specular_color = scene.lights[i].color;
        }
    }
    if (state.shader == TachyonShader::lowest) {
        // Everything is white, whatever colors the vertices have.
        for (auto& mesh : scene.meshes) {
            if (mesh->colors.empty()) continue;
            auto white = std::make_shared<MeshData>(*mesh);
            white->colors = {};
            mesh = std::move(white);
        }
    }
    if (state.shader == TachyonShader::low || state.shader == TachyonShader::lowest) {
        const SettingOrigin origin{SettingOrigin::Kind::file, state.shader_place};
        set_named_setting(scene, "shading", "color", origin);
        set_named_setting(scene, "reflections", "0", origin);
        if (state.shader == TachyonShader::lowest) {
            scene.background = {0, 0, 0};
            scene.gradient.reset();
        }
    }
    if (state.camera) set_camera(reading, *state.camera);
    // A texture's Ambient needs no light.
    Light ambient;
    ambient.kind = LightKind::ambient;
    note(scene.light_texts, scene.lights.size(), {});
    scene.lights.push_back(ambient);

    const bool is_shaded = state.shader == TachyonShader::full || state.shader == TachyonShader::medium;
    const auto drop = [&](TachyonLimit which, bool matters) {
        if (!matters) state.limit(which).reset();
    };
    drop(TachyonLimit::box_normals, is_shaded);
    drop(TachyonLimit::normal_lengths, is_shaded);
    drop(TachyonLimit::fogged_light, scene.fog.has_value());
    for (std::size_t i = 0; i < state.limits.size(); ++i) {
        const auto& at = state.limits[i];
        if (at) reading.diagnostics.warn(at->text, at->offset, at->length, std::string(k_limit_texts[i]));
    }
}

}  // namespace glint
