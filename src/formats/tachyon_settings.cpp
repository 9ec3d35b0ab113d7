// SPDX-License-Identifier: Apache-2.0
// Tachyon's camera, lights, background, fog and shader modes.
#include <fmt/format.h>

#include "base/text.h"
#include "formats/profile_file.h"
#include "formats/tachyon_reader.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint {
namespace {

constexpr Range k_sky_samples{0, k_max_occlusion_samples, false, false, "a whole number from 0 to 4096"};
constexpr Range k_direct{0, 1e6, false, false, "a number from 0 to 1e6"};
constexpr Range k_samples{0, 1e6, false, false, "a whole number from 0 to 1e6"};
constexpr Range k_depth{0, 1e6, false, false, "a whole number from 0 to 1e6"};
constexpr Range k_surfaces{0, 1e9, false, false, "a whole number from 0 to 1e9"};

}  // namespace

void TachyonReader::set(std::string_view key, std::string_view value, const Token& place) {
    const std::string wrong =
        set_named_setting(scene_, key, value, {SettingOrigin::Kind::file, source_place(text_, place)});
    if (!wrong.empty()) error(place, wrong);
}

bool TachyonReader::read_camera() {
    reading_.camera_given = true;
    TachyonCamera camera;
    if (scanner_.accept("PROJECTION")) {
        const Token at = scanner_.token();
        if (scanner_.accept("ORTHOGRAPHIC")) {
            camera.projection = Projection::orthographic;
        } else if (scanner_.accept("FISHEYE")) {
            error(at, "glint does not render the projection `Fisheye`");
        } else if (scanner_.accept("PERSPECTIVE_DOF")) {
            double ignored = 0;
            error(at,
                  "glint does not render depth of field (`Perspective_DoF`); `Perspective` is sharp "
                  "everywhere, without FocalLength and Aperture");
            if (!number("FOCALLENGTH", "FocalLength", ignored, k_coordinate) ||
                !number("APERTURE", "Aperture", ignored, k_coordinate)) {
                return false;
            }
        } else if (!scanner_.accept("PERSPECTIVE")) {
            return expected("`Perspective`, `Perspective_DoF`, `Orthographic` or `Fisheye`");
        }
    }
    double samples = 0, depth = 0;
    if (!number("ZOOM", "Zoom", camera.zoom, k_length) ||
        !number("ASPECTRATIO", "Aspectratio", camera.aspect_ratio, k_length) ||
        !expect("ANTIALIASING", "Antialiasing")) {
        return false;
    }
    const Token samples_at = scanner_.token();
    if (!whole_number(samples, k_samples) || !expect("RAYDEPTH", "Raydepth")) return false;
    const Token depth_at = scanner_.token();
    if (!whole_number(depth, k_depth) || !point("CENTER", "Center", camera.center) ||
        !expect("VIEWDIR", "Viewdir") || !direction(camera.view) || !expect("UPDIR", "Updir")) {
        return false;
    }
    const Token up_at = scanner_.token();
    if (!direction(camera.up)) return false;
    if (is_zero(cross(camera.up, camera.view)))
        return error(up_at, "the camera's `Updir` is along its `Viewdir`: they must differ");
    if (scanner_.accept("FRUSTUM")) {
        const Token sides_at = scanner_.token();
        TachyonCamera::Frustum f{};
        if (!number(f.left) || !number(f.right) || !number(f.bottom) || !number(f.top)) return false;
        if (f.left == f.right || f.bottom == f.top)
            return error(sides_at, "expected a frustum whose left and right, and bottom and top differ");
        camera.frustum = f;
    }
    if (!expect("END_CAMERA", "End_Camera")) return false;

    // Tachyon takes one sample, and `Antialiasing` more: the nearest grid has at least as many.
    int side = 1;
    while (side < k_max_samples && side * side < samples + 1) ++side;
    set("aa", std::to_string(side), samples_at);
    const double generations =
        number::min(number::max(depth - 1, 0.0), static_cast<double>(k_max_reflections));
    set("reflections", std::to_string(static_cast<int>(generations)), depth_at);
    state_.camera = camera;
    scene_.camera_place = source_place(text_, object_);
    return true;
}

bool TachyonReader::read_shader_mode() {
    const Token at = scanner_.token();
    bool is_given = true;
    if (scanner_.accept("FULL")) {
        state_.shader = TachyonShader::full;
    } else if (scanner_.accept("MEDIUM")) {
        state_.shader = TachyonShader::medium;
    } else if (scanner_.accept("LOW")) {
        state_.shader = TachyonShader::low;
    } else if (scanner_.accept("LOWEST")) {
        state_.shader = TachyonShader::lowest;
    } else if (is_further_) {
        is_given = false;
    } else {
        return expected("`Full`, `Medium`, `Low` or `Lowest`");
    }
    if (is_given) set_shader(at);
    while (!scanner_.accept("END_SHADER_MODE")) {
        object_ = scanner_.token();
        if (!read_mode()) return false;
    }
    return true;
}

void TachyonReader::set_shader(const Token& at) {
    set("shadows", state_.shader == TachyonShader::full ? "true" : "false", at);
    state_.shader_place = source_place(text_, at);
}

// One of the words in Shader_Mode.
bool TachyonReader::read_mode() {
    const Token mode = object_;
    double surfaces = 0;
    if (scanner_.accept("SHADOW_FILTER_ON")) {
        set("transparent_shadow", "colored", mode);
    } else if (scanner_.accept("SHADOW_FILTER_OFF")) {
        set("transparent_shadow", "none", mode);
    } else if (scanner_.accept("TRANS_MAX_SURFACES")) {
        if (!whole_number(surfaces, k_surfaces)) return false;
        surfaces = number::min(surfaces, static_cast<double>(k_max_sample_rays));
        set("transparent_surfaces", std::to_string(static_cast<int>(surfaces)), mode);
    } else if (scanner_.accept("TRANS_ORIG")) {
        state_.is_raster3d = false;
        set("transparency", "add", mode);
    } else if (scanner_.accept("TRANS_RASTER3D")) {
        state_.is_raster3d = true;
    } else if (scanner_.accept("TRANS_VMD")) {
        set("transparency", "blend", mode);
    } else if (scanner_.accept("FOG_VMD")) {
        set("fog_distance", "depth", mode);
        set("fog_background", "false", mode);
    } else if (scanner_.accept("AMBIENT_OCCLUSION")) {
        return read_occlusion();
    } else if (is_further_ && scanner_.accept("FOG_RADIAL")) {
        set("fog_distance", "ray", mode);
        set("fog_background", "true", mode);
    } else if (is_further_ && scanner_.accept("RESCALE_DIRECT")) {
        return number(state_.light_scale, k_direct);
    } else if (scanner_.accept("FULL") || scanner_.accept("MEDIUM") || scanner_.accept("LOW") ||
               scanner_.accept("LOWEST")) {
        return error(mode,
                     "`Full`, `Medium`, `Low` or `Lowest` stands before the other modes, directly after "
                     "`Shader_Mode`");
    } else {
        return expected(
            "`Shadow_Filter_On`, `Shadow_Filter_Off`, `Trans_Max_Surfaces`, `Trans_Orig`, `Trans_Raster3D`, "
            "`Trans_VMD`, `Fog_VMD`, `Ambient_Occlusion` or `End_Shader_Mode`");
    }
    return true;
}

bool TachyonReader::read_occlusion() {
    Color light;
    double samples = 0;
    if (!color("AMBIENT_COLOR", "Ambient_Color", light) ||
        !number("RESCALE_DIRECT", "Rescale_Direct", state_.light_scale, k_direct) ||
        !expect("SAMPLES", "Samples") || !whole_number(samples, k_sky_samples)) {
        return false;
    }
    set_occlusion(light, samples);
    return true;
}

bool TachyonReader::read_sky_light() {
    Color light;
    double samples = 0;
    if (!expect("NUMSAMPLES", "NumSamples") || !whole_number(samples, k_sky_samples) ||
        !color("COLOR", "Color", light)) {
        return false;
    }
    set_occlusion(light, samples);
    return true;
}

void TachyonReader::set_occlusion(const Color& light, double samples) {
    state_.occlusion.reset();
    if (samples == 0) return;
    state_.occlusion = Occlusion{
        .method = OcclusionMethod::fixed, .samples = static_cast<std::int32_t>(samples), .color = light};
    state_.occlusion_place = source_place(text_, object_);
}

// [Attenuation Constant c Linear l Quadratic q] Color r g b
bool TachyonReader::read_light_color(Light& light) {
    if (scanner_.accept("ATTENUATION")) {
        Attenuation& a = light.attenuation;
        const Token at = scanner_.token();
        if (!number("CONSTANT", "Constant", a.c0, k_attenuation) ||
            !number("LINEAR", "Linear", a.c1, k_attenuation) ||
            !number("QUADRATIC", "Quadratic", a.c2, k_attenuation)) {
            return false;
        }
        if (a.c0 == 0 && a.c1 == 0 && a.c2 == 0) return error(at, "expected an attenuation above 0");
    }
    if (!color("COLOR", "Color", light.color)) return false;
    light.specular_color = light.color;
    return true;
}

bool TachyonReader::read_light() {
    Light light;
    double radius = 0;
    if (!point("CENTER", "Center", light.position) || !number("RAD", "Rad", radius, k_coordinate) ||
        !read_light_color(light)) {
        return false;
    }
    add_light(light, radius);
    return true;
}

bool TachyonReader::read_directional_light() {
    Light light;
    light.kind = LightKind::directional;
    Vec3 away;
    if (!expect("DIRECTION", "Direction") || !direction(away) || !color("COLOR", "Color", light.color))
        return false;
    light.to_light = Vec3{0, 0, 0} - away;
    light.specular_color = light.color;
    add_light(light, 0);
    return true;
}

bool TachyonReader::read_spot_light() {
    Light light;
    light.kind = LightKind::spot;
    double radius = 0;
    if (!point("CENTER", "Center", light.position) || !number("RAD", "Rad", radius, k_coordinate) ||
        !expect("DIRECTION", "Direction") || !direction(light.axis) ||
        !number("FALLOFF_START", "Falloff_Start", light.inner_angle, k_cone_angle) ||
        !number("FALLOFF_END", "Falloff_End", light.outer_angle, k_cone_limit) || !read_light_color(light)) {
        return false;
    }
    if (light.inner_angle > light.outer_angle) light.inner_angle = light.outer_angle;
    add_light(light, radius);
    return true;
}

bool TachyonReader::read_background() {
    if (!color(scene_.background)) return false;
    scene_.background_place = source_place(text_, object_);
    reading_.background_given = true;
    return true;
}

bool TachyonReader::read_gradient() {
    BackgroundGradient gradient;
    if (scanner_.accept("SKY_ORTHO_PLANE")) {
        gradient.kind = GradientKind::plane;
    } else if (!scanner_.accept("SKY_SPHERE")) {
        return expected("`Sky_Sphere` or `Sky_Ortho_Plane`");
    }
    if (!expect("UPDIR", "Updir") || !direction(gradient.up) ||
        !number("TOPVAL", "TopVal", gradient.top, k_coordinate) ||
        !number("BOTTOMVAL", "BottomVal", gradient.bottom, k_coordinate) ||
        !color("TOPCOLOR", "TopColor", gradient.top_color) ||
        !color("BOTTOMCOLOR", "BottomColor", gradient.bottom_color)) {
        return false;
    }
    // Tachyon does not normalise Updir; glint does.
    const double size = length(gradient.up);
    gradient.top = gradient.top / size;
    gradient.bottom = gradient.bottom / size;
    scene_.gradient = gradient;
    scene_.gradient_place = source_place(text_, object_);
    return true;
}

bool TachyonReader::read_fog() {
    Fog fog;
    const Token kind = scanner_.token();
    bool is_off = false;
    if (scanner_.accept("LINEAR")) {
        fog.kind = FogKind::linear;
    } else if (scanner_.accept("EXP")) {
        fog.kind = FogKind::exp;
    } else if (scanner_.accept("EXP2")) {
        fog.kind = FogKind::exp2;
    } else if (scanner_.accept("OFF")) {
        is_off = true;
    } else {
        return expected("`Linear`, `Exp`, `Exp2` or `Off`");
    }
    if (!number("START", "Start", fog.start, k_coordinate) || !number("END", "End", fog.end, k_coordinate) ||
        !number("DENSITY", "Density", fog.density, k_not_negative) || !color("COLOR", "Color", fog.color)) {
        return false;
    }
    if (fog.kind == FogKind::linear && !(fog.end > fog.start) && !is_off)
        return error(kind, "expected an `End` of the fog above its `Start`");
    scene_.fog.reset();
    if (is_off) return true;
    scene_.fog = fog;
    scene_.fog_place = source_place(text_, object_);
    return true;
}

}  // namespace glint
