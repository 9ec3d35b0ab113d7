// SPDX-License-Identifier: Apache-2.0
// Faults of the camera's rays and of the eye in the lighting equation.
#include "compare/scene_faults.h"
#include "math/elementary.h"
#include "math/transform.h"
#include "world/prepare_camera.h"

namespace glint {
namespace {

constexpr double k_degrees_per_radian = 57.29577951308232;
constexpr double k_eye_far = 1e6;  // of an eye that is in one direction from everywhere

bool is_wide_or_high(const Scene& s) {
    return s.camera.projection == Projection::perspective && s.settings.width != s.settings.height;
}
bool has_angle(const Scene& s) { return s.camera.has_fov(); }

// Scales the picture plane.
void scale_view(Scene& s, double right, double up) {
    const PreparedCamera camera = prepare_camera(s.camera, s.settings);
    s.camera.frame = {camera.right * right, camera.up * up, camera.forward};
}
double aspect(const Scene& s) { return static_cast<double>(s.settings.width) / s.settings.height; }

// Uses a tangent in place of that of half the angle.
void put_tangent(Scene& s, double tangent) {
    const double factor = tangent / tan_degrees(s.camera.fov_degrees / 2);
    scale_view(s, factor, factor);
}

// The rows of the plane of a picture whose y is divided by its width.
void divide_y_by_width(Scene& s) {
    const PreparedCamera camera = prepare_camera(s.camera, s.settings);
    const double part = 1 / aspect(s);
    s.camera.frame = {camera.right, camera.up * part, camera.forward + camera.up * (0.5 * (1 - part))};
}
void keep_up(Scene& s) {
    const PreparedCamera camera = prepare_camera(s.camera, s.settings);
    s.camera.frame = {camera.right, normalize(s.camera.up) * length(camera.up), camera.forward};
}

bool sees_highlights(const Scene& s) { return has_highlights(s) && !s.camera.lighting_eye; }

void put_eye_at_origin(Scene& s) { s.camera.lighting_eye = Vec3{0, 0, 0}; }
void fix_eye_direction(Scene& s) {
    const PreparedCamera camera = prepare_camera(s.camera, s.settings);
    s.camera.lighting_eye = camera.position - normalize(camera.forward) * k_eye_far;
}

constexpr SceneFault k_camera[] = {
    {"field-of-view",
     [](const Scene& s) {
         return !s.camera.frame && s.camera.projection == Projection::perspective &&
                s.settings.width != s.settings.height;
     },
     [](Scene& s) { s.camera.fov_axis = s.camera.fov_axis == FovAxis::x ? FovAxis::y : FovAxis::x; },
     "The field of view is that of the other side of the picture: its width instead of its height, or the "
     "reverse."},
    {"aspect-missing", is_wide_or_high, [](Scene& s) { scale_view(s, 1 / aspect(s), 1); },
     "The picture is stretched: the aspect ratio is missing. Multiply x by width / height."},
    {"aspect-missing", is_wide_or_high, [](Scene& s) { scale_view(s, 1, aspect(s)); },
     "The picture is stretched: the aspect ratio is missing. Divide y by width / height."},
    {"aspect-inverted", is_wide_or_high, [](Scene& s) { scale_view(s, 1 / (aspect(s) * aspect(s)), 1); },
     "The picture is stretched: the aspect ratio is inverted. It is width / height, and multiplies x."},
    {"aspect-inverted", is_wide_or_high, [](Scene& s) { scale_view(s, 1, aspect(s) * aspect(s)); },
     "The picture is stretched: the aspect ratio is inverted. It is width / height, and divides y."},
    {"aspect-inverted", is_wide_or_high, divide_y_by_width,
     "The y of a pixel is divided by the picture's width: divide it by the height."},
    {"up-not-orthogonal", [](const Scene& s) { return !s.camera.frame; }, keep_up,
     "The camera's up vector is used as it is: it must be at right angles to the view and to the right."},
    {"pixel-step",
     [](const Scene& s) {
         return s.camera.projection == Projection::perspective && s.settings.width > 1 &&
                s.settings.height > 1;
     },
     [](Scene& s) {
         const double w = s.settings.width, h = s.settings.height;
         scale_view(s, w / (w - 1), h / (h - 1));
     },
     "Pixels are too far apart: x is 2 (i + 0.5) / W - 1, not 2 i / (W - 1) - 1."},
    {"field-of-view-radians", has_angle,
     [](Scene& s) { put_tangent(s, tan_degrees(s.camera.fov_degrees / 2 * k_degrees_per_radian)); },
     "The tangent is of degrees taken as radians: multiply the field of view by pi / 180."},
    {"field-of-view-doubled", has_angle, [](Scene& s) { put_tangent(s, tan_degrees(s.camera.fov_degrees)); },
     "The field of view is too large: the picture's half size is the tangent of half the angle, not of the "
     "whole."},
    {"field-of-view-halved", has_angle,
     [](Scene& s) { put_tangent(s, tan_degrees(s.camera.fov_degrees / 4)); },
     "The field of view is too small: the angle is halved twice."},
    {"eye-at-origin",
     [](const Scene& s) {
         return sees_highlights(s) && !(s.camera.position == Vec3{0, 0, 0});
     },
     put_eye_at_origin,
     "Highlights are seen from the origin: V is -P. It is the vector from P to the camera."},
    {"eye-direction-fixed", sees_highlights, fix_eye_direction,
     "Highlights have the same V everywhere, the camera's direction. It is the vector from P to the camera."},
    {"eye-not-from-point",
     [](const Scene& s) {
         return sees_highlights(s) && !(s.camera.position == Vec3{0, 0, 0});
     },
     [](Scene& s) { s.camera.lighting_eye = s.camera.position * k_eye_far; },
     "V is the position of the eye: subtract P, as V goes from P to the eye."},
    {.name = "eye-of-camera-in-mirrors",
     .applies =
         [](const Scene& s) {
             return sees_highlights(s) && has_mirrors(s) && s.camera.projection == Projection::perspective;
         },
     .put = [](Scene& s) { s.camera.lighting_eye = s.camera.position; },
     .explanation =
         "Highlights in mirrors are seen from the camera: V is the vector from P to where the ray comes "
         "from, which is the point on the mirror.",
     .fault = TracerFault::eye_everywhere},
    {.name = "eye-at-origin",
     .applies =
         [](const Scene& s) {
             return sees_highlights(s) && has_mirrors(s) && !(s.camera.position == Vec3{0, 0, 0});
         },
     .put = put_eye_at_origin,
     .explanation =
         "Highlights are seen from the origin, in mirrors, too: V is -P. It is the vector from P to "
         "where the ray comes from.",
     .fault = TracerFault::eye_everywhere},
    {.name = "eye-direction-fixed",
     .applies = [](const Scene& s) { return sees_highlights(s) && has_mirrors(s); },
     .put = fix_eye_direction,
     .explanation =
         "Highlights have the same V everywhere, in mirrors, too, the camera's direction. It is the "
         "vector from P to where the ray comes from.",
     .fault = TracerFault::eye_everywhere},
};

}  // namespace

std::span<const SceneFault> camera_faults() { return k_camera; }

}  // namespace glint
