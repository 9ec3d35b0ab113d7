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
    ("glint has its own noise for grit and marble (`TexFunc` 2 and 3), with another grain: the picture will "
     "differ"),
    "the rings of wood (`TexFunc` 4) are round here; in Tachyon they have waves of 3 units",
    ("highlights of metals whose Phong, Ambient or Diffuse is above 1 are white here, without the colors of "
     "their patterns (`TexFunc`): the picture will differ"),
};
static_assert(std::size(k_limit_texts) == static_cast<std::size_t>(TachyonLimit::count));

// Whether a pattern changes the color of the highlight. Factors of the color above 1 are none that it
// replaces.
bool tints_highlight(const TachyonTexture& t, double metal) {
    return t.is_metal && k_fraction.contains(t.phong * metal) && k_fraction.contains(t.ambient) &&
           k_fraction.contains(t.diffuse);
}

// metal: the factor of the highlights of metal, which do not depend on the light's color.
Material material_of(const TachyonTexture& t, const TachyonState& state, double metal) {
    const double highlight = t.phong > k_min_contribution ? t.phong : 0;
    // A pattern replaces this color.
    const Color color =
        t.function != TachyonFunction::none && tints_highlight(t, metal) ? Color{1, 1, 1} : t.color;
    Material m;
    m.color = state.shader == TachyonShader::lowest ? Color{1, 1, 1} : color;
    m.ambient = color * t.ambient;
    m.diffuse = color * t.diffuse;
    m.specular = t.is_metal ? color * (highlight * metal) : Color{highlight, highlight, highlight};
    m.tinted_highlight = !t.is_metal;
    m.shininess = t.phong_size;
    m.mirror = t.specular > k_min_contribution ? t.specular : 0;
    m.outline = t.outline;
    m.outline_width = t.outline > 0 ? t.outline_width : 0;
    m.transmit = t.opacity < 1 - k_min_contribution ? 1 - t.opacity : 0;
    m.angled_opacity = m.transmit > 0 && (t.fades_at_angles || state.is_raster3d);
    return m;
}

// The textures of the materials' patterns.
void add_patterns(Scene& scene, const TachyonState& state, double metal) {
    NumberTable<8> numbers;
    for (const auto& [material, texture] : state.textures) {
        if (texture.function == TachyonFunction::none) continue;
        const bool is_tinting = tints_highlight(texture, metal);
        const Color tint = is_tinting ? texture.color : Color{1, 1, 1};
        const NumberTable<8>::Key key{static_cast<double>(texture.function),
                                      texture.center.x,
                                      texture.center.y,
                                      texture.center.z,
                                      is_tinting ? 1. : 0.,
                                      tint.r,
                                      tint.g,
                                      tint.b};
        const std::uint32_t* const known = numbers.find(key);
        const auto number = known ? *known : static_cast<std::uint32_t>(scene.textures.size());
        scene.materials[material].texture = number;
        if (known) continue;
        numbers.add(key, number);
        note(scene.texture_texts, number, scene.material_texts.place(material));
        scene.textures.push_back(tachyon_pattern(texture.function, texture.center, tint,
                                                 is_tinting ? TextureMix::replace : TextureMix::multiply));
    }
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
    const double metal = has_occlusion ? 1 : state.light_scale;
    for (const auto& [material, texture] : state.textures)
        scene.materials[material] = material_of(texture, state, metal);
    if (state.shader != TachyonShader::lowest) add_patterns(scene, state, metal);
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
    const bool has_bright_highlight =
        std::any_of(state.textures.begin(), state.textures.end(), [&](const auto& of) {
            return of.second.function != TachyonFunction::none && of.second.is_metal &&
                   !tints_highlight(of.second, metal);
        });
    const auto drop = [&](TachyonLimit which, bool matters) {
        if (!matters) state.limit(which).reset();
    };
    drop(TachyonLimit::box_normals, is_shaded);
    drop(TachyonLimit::normal_lengths, is_shaded);
    drop(TachyonLimit::grain, state.shader != TachyonShader::lowest);
    drop(TachyonLimit::rings, state.shader != TachyonShader::lowest);
    drop(TachyonLimit::bright_highlight, is_shaded && has_bright_highlight);
    drop(TachyonLimit::fogged_light, scene.fog.has_value());
    for (std::size_t i = 0; i < state.limits.size(); ++i) {
        const auto& at = state.limits[i];
        if (at) reading.diagnostics.warn(at->text, at->offset, at->length, std::string(k_limit_texts[i]));
    }
}

}  // namespace glint
