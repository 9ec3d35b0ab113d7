// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "scene/fields.h"

namespace glint {

template <> struct FieldMembers<Camera> {
    using Any = std::variant<FieldMember<Camera, double, NumberType>, FieldMember<Camera, Vec3, PointType>,
                             FieldMember<Camera, std::optional<Vec3>, PointType>,
                             FieldMember<Camera, Vec3, DirectionType>>;
};

/// .glint also has `projection`. `fov_x` and `fov_y` also set fov_axis.
inline constexpr ItemField<Camera> k_camera_fields[] = {
    {"position", "position", "position", point_field(&Camera::position), "where the camera is"},
    {"look_at", "look_at", "target", point_field(&Camera::look_at),
     "a point in the middle of the picture, not equal to the position", &Camera::has_target},
    {"up", "up", "up", direction_field(&Camera::up), "what is upright in the picture, not along the view",
     &Camera::has_target},
    {.key = "fov_x",
     .name = "fov",
     .label = "field of view",
     .member = number_field(&Camera::fov_degrees, k_angle),
     .description = "perspective: the full angle across the picture's width, or its height; one of them",
     .applies = &Camera::has_fov,
     .other_key = "fov_y"},
    {"width", "width", "width", number_field(&Camera::width, k_length),
     "orthographic: world units across the picture's width", &Camera::has_width},
    {.key = "lighting_eye",
     .name = "lighting_eye",
     .label = "lighting eye",
     .member = point_field(&Camera::lighting_eye),
     .description = "highlights are computed for an observer at this point",
     .otherwise = "the ray's origin"},
};

/// In .glint, these are keys of the camera.
inline constexpr ItemField<CameraFrame> k_frame_fields[] = {
    {.key = "right",
     .name = "right",
     .label = "right",
     .member = direction_field(&CameraFrame::right),
     .description = "spans the picture's width at `forward` from the position",
     .otherwise = "none"},
    {.key = "up",
     .name = "up",
     .label = "up",
     .member = direction_field(&CameraFrame::up),
     .description = "with `right` and `forward`: spans the picture's height there",
     .otherwise = "none"},
    {.key = "forward",
     .name = "forward",
     .label = "forward",
     .member = direction_field(&CameraFrame::forward),
     .description = "from the position to the picture's middle",
     .otherwise = "none"},
};

}  // namespace glint
