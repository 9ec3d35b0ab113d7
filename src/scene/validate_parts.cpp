// SPDX-License-Identifier: Apache-2.0
#include "scene/validate_parts.h"

#include <fmt/format.h>

#include "math/number.h"
#include "scene/camera_fields.h"
#include "scene/fog_fields.h"
#include "scene/light_fields.h"
#include "scene/material_fields.h"
#include "scene/parallel.h"
#include "scene/settings.h"
#include "scene/sky_fields.h"
#include "scene/texture_fields.h"
#include "scene/validate_texture.h"
#include "scene/validate_transform.h"

namespace glint {
namespace {

constexpr double k_rounding = 1e-9;  // of a sum of decimal numbers

}  // namespace

void PartValidator::check_part(ScenePart part) {
    switch (part) {
        case ScenePart::settings:
            return check_settings();
        case ScenePart::camera:
            begin(SceneItem::camera);
            return check_camera();
        case ScenePart::background:
            begin(SceneItem::background);
            check_color(k_channel, scene_.background, scene_.background_place, "the scene", "background");
            check_fog();
            check_gradient();
            return check_occlusion();
        case ScenePart::lights:
            for (std::uint32_t i = 0; !full() && i < scene_.lights.size(); ++i) check_light(i);
            return;
        case ScenePart::materials:
            for (std::uint32_t i = 0; !full() && i < scene_.materials.size(); ++i)
                check_material(scene_.materials[i], i);
    }
}

// A setting is valid if its text form is.
void PartValidator::check_settings() {
    Scene copy;
    const auto keys = setting_keys();
    for (std::size_t i = 0; i < keys.size(); ++i) {
        begin(SceneItem::setting, i);
        const std::string wrong = set_setting(copy, i, get_setting(scene_, i), {}).message;
        const SourcePlace place = i < scene_.origins.size() ? scene_.origins[i].place : SourcePlace{};
        if (!wrong.empty()) error(place, fmt::format("{}: {}", keys[i].name, wrong));
    }
}

void PartValidator::check_fog() {
    if (!scene_.fog) return;
    begin(SceneItem::fog);
    const Fog& fog = *scene_.fog;
    if (fog.kind > FogKind::exp2) error(scene_.fog_place, "the fog: no such kind of fog");
    check_fields<Fog>(k_fog_fields, fog, scene_.fog_place, "the fog");
    if (fog.has_end() && !(fog.end > fog.start))
        error(scene_.fog_place,
              fmt::format("the fog: end: expected a number above start {}, found {}", fog.start, fog.end));
}

void PartValidator::check_gradient() {
    if (!scene_.gradient) return;
    begin(SceneItem::background);
    const BackgroundGradient& gradient = *scene_.gradient;
    const SourcePlace place = scene_.gradient_place;
    constexpr std::string_view of = "the background gradient";
    if (gradient.kind > GradientKind::plane) error(place, fmt::format("{}: no such kind", of));
    check_fields<BackgroundGradient>(k_gradient_fields, gradient, place, of);
    if (const std::string mistake = glint::mistake_in(gradient.color_map); !mistake.empty())
        error(place, fmt::format("{}: {}", of, mistake));
    for (const TextureColor& color : gradient.color_map) {
        if (color.alpha == 1) continue;
        error(place, fmt::format("{}: color_map: expected colors without alpha, found an alpha of {}", of,
                                 color.alpha));
        break;
    }
    if (!(gradient.top > gradient.bottom))
        error(place, fmt::format("{}: top: expected a number above bottom {}, found {}", of, gradient.bottom,
                                 gradient.top));
}

void PartValidator::check_occlusion() {
    if (!scene_.occlusion) return;
    begin(SceneItem::background);
    const SourcePlace place = scene_.occlusion_place;
    if (scene_.occlusion->method > OcclusionMethod::fixed) error(place, "the occlusion: no such method");
    check_fields<Occlusion>(k_occlusion_fields, *scene_.occlusion, place, "the occlusion");
}

void PartValidator::check_camera() {
    const Camera& c = scene_.camera;
    const SourcePlace place = scene_.camera_place;
    constexpr std::string_view of = "the camera";
    if (c.projection > Projection::orthographic || c.fov_axis > FovAxis::y) {
        error(place, "the camera: no such projection or fov axis");
    }
    check_fields<Camera>(k_camera_fields, c, place, of);
    if (c.frame) {
        check_frame(*c.frame, place);
        return;
    }
    const Vec3 forward = c.look_at - c.position;
    if (is_zero(forward)) {
        error(place, "the camera is at the point that it looks at: the two must differ");
    } else if (!is_zero(c.up) && are_parallel(forward, c.up)) {
        error(place,
              fmt::format("the camera's up {} is along its view direction {}", text(c.up), text(forward)));
    }
}

void PartValidator::check_frame(const CameraFrame& frame, SourcePlace place) {
    check_fields<CameraFrame>(k_frame_fields, frame, place, "the camera");
    if (is_zero(frame.right) || is_zero(frame.up) || is_zero(frame.forward)) return;
    const Vec3 normal = cross(unit_or_zero(frame.right), unit_or_zero(frame.up));
    const double volume = dot(normal, unit_or_zero(frame.forward));
    if (!(number::abs(volume) >= k_parallel)) {
        error(place, fmt::format("the camera's right {}, up {} and forward {} lie in one plane",
                                 text(frame.right), text(frame.up), text(frame.forward)));
    }
}

void PartValidator::check_light(std::uint32_t i) {
    begin(SceneItem::light, i);
    const Light& l = scene_.lights[i];
    const SourcePlace place = scene_.light_texts.place(i);
    const std::string of = item("light", i, scene_.light_texts.name(i));
    if (static_cast<int>(l.kind) >= k_light_kinds) error(place, of + ": no such kind of light");
    check_fields<Light>(k_light_fields, l, place, of);
    if (l.is_spot() && l.inner_angle > l.outer_angle)
        error(place, fmt::format("{}: inner angle: expected at most the outer angle of {} degrees, found {}",
                                 of, l.outer_angle, l.inner_angle));
    if (l.is_parallelogram() && !is_zero(l.side_u) && !is_zero(l.side_v) && are_parallel(l.side_u, l.side_v))
        error(place, fmt::format("{}: expected sides that are not parallel, found {} and {}", of,
                                 text(l.side_u), text(l.side_v)));
}

void PartValidator::check_texture(std::uint32_t i) {
    begin(SceneItem::texture, i);
    const Texture& texture = scene_.textures[i];
    const SourcePlace place = scene_.texture_texts.place(i);
    const std::string of = item("texture", i, scene_.texture_texts.name(i));
    check_fields<Texture>(k_texture_fields, texture, place, of);
    if (const std::string mistake = mistake_in(texture); !mistake.empty())
        error(place, fmt::format("{}: {}", of, mistake));
    if (const std::string_view mistake = mistake_in(texture.world_from_texture); !mistake.empty())
        error(place, fmt::format("{}: its transform{}", of, mistake));
    check_layers(i, place, of);
}

// The layers from this texture on.
void PartValidator::check_layers(std::uint32_t i, SourcePlace place, const std::string& of) {
    int layers = 1;
    for (std::uint32_t below = i; (below = scene_.textures[below].over) != k_none;) {
        if (below >= scene_.textures.size()) return error(place, of + ": over: no such texture");
        if (below == i) return error(place, of + ": over: the texture is over itself");
        if (++layers > k_max_texture_layers)
            return error(place, fmt::format("{}: over: expected at most {} layers, found more, or a circle",
                                            of, k_max_texture_layers));
    }
    if (layers > 1 && scene_.textures[i].alpha == TextureAlpha::mask)
        error(place, of + ": over: expected an alpha other than mask");
}

void PartValidator::check_texture_index(std::uint32_t i) {
    const Material& m = scene_.materials[i];
    if (m.texture == k_none || m.texture < scene_.textures.size()) return;
    begin(SceneItem::material, i);
    error(scene_.material_texts.place(i),
          item("material", i, scene_.material_texts.name(i)) + ": no such texture");
}

void PartValidator::check_material(const Material& m, std::uint32_t i) {
    begin(SceneItem::material, i);
    const SourcePlace place = scene_.material_texts.place(i);
    const std::string of = item("material", i, scene_.material_texts.name(i));
    check_fields<Material>(k_material_fields, m, place, of);
    if (m.filter + m.transmit > 1 + k_rounding)
        error(place, fmt::format("{}: filter + transmit: expected at most 1, found {} + {}", of, m.filter,
                                 m.transmit));
    if (m.angled_opacity && m.filter > 0)
        error(place, fmt::format("{}: expected `angled_opacity` or `filter`, found both: the angle changes "
                                 "`transmit` alone",
                                 of));
    if (m.is_transparent() && m.transmission > 0)
        error(place, fmt::format("{}: expected `transmission` (with refraction) or `filter` and `transmit` "
                                 "(without), found both",
                                 of));
}

}  // namespace glint
