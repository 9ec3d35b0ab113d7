// SPDX-License-Identifier: Apache-2.0
// Where rays start and go: through a pixel, from a mirror, through glass.
#include "diagnose/ray_model.h"
#include "math/elementary.h"
#include "world/camera_projection.h"
#include "world/world.h"

namespace glint {

Maybe RayModel::camera_origin() const {
    if (reference_ == nullptr) return std::nullopt;
    const PreparedCamera& camera = model_.world.parts().camera;
    if (!is_of_camera(trial_.mistake) || camera.projection != Projection::orthographic)
        return ApproxVec(reference_->origin);
    const std::optional<std::array<double, 2>> at = mistaken_viewport();
    if (!at) return ApproxVec(reference_->origin);
    return ApproxVec(camera.position + camera.right * (*at)[0] + camera.up * (*at)[1]);
}

Maybe RayModel::camera_direction() const {
    if (reference_ == nullptr) return std::nullopt;
    const PreparedCamera& camera = model_.world.parts().camera;
    if (!is_of_camera(trial_.mistake)) return ApproxVec(reference_->direction);
    if (is(TracerMistake::camera_backwards)) return -ApproxVec(reference_->direction);
    if (camera.projection == Projection::orthographic) return ApproxVec(reference_->direction);
    if (is(TracerMistake::viewport_point)) return ApproxVec(camera.position + reference_->direction);
    const std::optional<std::array<double, 2>> at = mistaken_viewport();
    if (!at) return ApproxVec(reference_->direction);
    if (is(TracerMistake::camera_not_rotated))
        return ApproxVec(Vec3{(*at)[0] * length(ApproxVec(camera.right)).v,
                              (*at)[1] * length(ApproxVec(camera.up)).v,
                              (trial_.variant == 0 ? -1 : 1) * length(ApproxVec(camera.forward)).v});
    if (is(TracerMistake::camera_up_not_orthogonal)) {
        if (!model_.scene.camera.has_target()) return std::nullopt;
        const ApproxVec up = unit(ApproxVec(model_.scene.camera.up)) * length(ApproxVec(camera.up));
        return ApproxVec(camera.forward + camera.right * (*at)[0]) + up * Approx((*at)[1]);
    }
    return ApproxVec(camera.forward + camera.right * (*at)[0] + camera.up * (*at)[1]);
}

// The place in the viewport, -1/2 to 1/2 from left to right and from the bottom to the top, with the mistake.
std::optional<std::array<double, 2>> RayModel::mistaken_viewport() const {
    const PreparedCamera& camera = model_.world.parts().camera;
    const double width = model_.scene.settings.width, height = model_.scene.settings.height;
    const bool is_parallel = camera.projection == Projection::orthographic;
    const CameraCoordinates at = CameraProjection(camera).coordinates(
        is_parallel ? reference_->origin : reference_->origin + reference_->direction);
    double u = is_parallel ? at.x : at.x / at.depth, v = is_parallel ? at.y : at.y / at.depth;
    const double size_x = length(ApproxVec(camera.right)).v, size_y = length(ApproxVec(camera.up)).v,
                 ahead = length(ApproxVec(camera.forward)).v;
    const double aspect = size_x / size_y, half = (trial_.variant == 0 ? size_x : size_y) / (2 * ahead);
    const auto scale = [&](double by) { u *= by, v *= by; };
    const double x = pixel_.x, y = model_.row(pixel_);
    switch (trial_.mistake) {
        case TracerMistake::columns_mirrored:
            u = -u;
            break;
        case TracerMistake::rows_flipped:
            v = -v;
            break;
        case TracerMistake::pixel_corner:
            if (trial_.variant != 2) u = x / width - 0.5;
            if (trial_.variant != 1) v = 0.5 - y / height;
            break;
        case TracerMistake::pixel_center:
            u = (x + 0.5) / width - 0.5, v = 0.5 - (y + 0.5) / height;
            break;
        case TracerMistake::pixel_opposite_corner:
            u = (trial_.variant == 2 ? x : x + 1) / width - 0.5,
            v = 0.5 - (trial_.variant == 1 ? y : y + 1) / height;
            break;
        case TracerMistake::pixel_over_last:
            if (width < 2 || height < 2) return std::nullopt;
            u = x / (width - 1) - 0.5, v = 0.5 - y / (height - 1);
            break;
        case TracerMistake::aspect_ignored:
            trial_.variant == 0 ? v *= aspect : u /= aspect;
            break;
        case TracerMistake::aspect_inverted:
            trial_.variant == 0 ? u /= aspect* aspect : v *= aspect * aspect;
            break;
        case TracerMistake::aspect_twice:
            trial_.variant == 0 ? u *= width / height : v *= height / width;
            break;
        case TracerMistake::pixel_transposed:
            u = (y + 0.5) / width - 0.5, v = 0.5 - (x + 0.5) / height;
            break;
        case TracerMistake::fov_not_halved:
            scale(2 / (1 - half * half));
            break;
        case TracerMistake::fov_halved_twice:
            scale(tan(atan2(half, 1) / 2) / half);
            break;
        case TracerMistake::fov_in_degrees:
            scale(tan(atan2(half, 1) * 180 / k_pi) / half);
            break;
        case TracerMistake::fov_other_axis:
            scale(trial_.variant == 0 ? aspect : 1 / aspect);
            break;
        case TracerMistake::camera_not_rotated:
        case TracerMistake::camera_up_not_orthogonal:
            break;
        default:
            return std::nullopt;
    }
    return std::array{u, v};
}

Maybe RayModel::secondary_direction() const {
    const Maybe d = parent_->value(Quantity::direction), n = parent_->value(Quantity::normal);
    if (!d || !n) return std::nullopt;
    const ApproxVec along = about_unit(*d), normal = about_unit(*n);
    if (ray_.kind == LoggedRayKind::glass) return refracted();
    if (is(TracerMistake::mirror_into_surface)) return along + normal * (Approx(2) * dot(normal, along));
    if (is(TracerMistake::mirror_backwards)) return mirrored(along, normal);
    if (is(TracerMistake::mirror_not_doubled)) return along - normal * dot(normal, along);
    if (is(TracerMistake::mirror_along_normal)) return normal;
    if (is(TracerMistake::mirror_straight_on)) return along;
    if (is(TracerMistake::mirror_of_light)) {
        const auto light = static_cast<std::uint32_t>(trial_.variant);
        if (light >= model_.scene.lights.size() || model_.scene.lights[light].is_ambient())
            return std::nullopt;
        const Maybe l = parent_->value(Quantity::to_light, light);
        return l ? Maybe(mirrored(unit(*l), normal)) : std::nullopt;
    }
    return -mirrored(along, normal);
}

double RayModel::index_ratio(double ior, bool leaves) const {
    if (is(TracerMistake::refraction_ignored)) return 1;
    if (is(TracerMistake::refraction_from_outside)) return 1 / ior;
    return leaves != is(TracerMistake::refraction_inverted) ? ior : 1 / ior;
}

// The number under the root of Snell's law, for a glass ray that starts at this hit.
std::optional<Approx> RayModel::under_root() const {
    const std::optional<Material> glass = material();
    const Maybe own = own_normal(), d = value(Quantity::direction);
    if (!glass || !own || !d) return std::nullopt;
    const Approx cosine = dot(*own, about_unit(*d));
    const double eta = index_ratio(glass->ior, cosine.v > 0);
    return Approx(1) - Approx(eta * eta) * (Approx(1) - cosine * cosine);
}

std::optional<bool> RayModel::is_refracted() const {
    const std::optional<Approx> under = under_root();
    if (!under || std::fabs(under->v) <= under->e + 1e-4) return std::nullopt;
    return under->v > 0;
}

// Snell's law; total reflection has no direction.
Maybe RayModel::refracted() const {
    const std::optional<Material> glass = parent_->material();
    const Maybe own = parent_->own_normal(), d = parent_->value(Quantity::direction);
    if (!glass || !own || !d) return std::nullopt;
    const ApproxVec along = about_unit(*d);
    if (!(glass->transmission > 0) || is(TracerMistake::refraction_ignored)) return along;
    const bool leaves = dot(*own, along).v > 0;
    const Maybe logged_normal = parent_->logged(Quantity::normal);
    const ApproxVec either = logged_normal ? about_unit(*logged_normal) : *own;
    const ApproxVec normal = dot(either, along).v > 0 ? -either : either;
    const double eta = index_ratio(glass->ior, leaves);
    const Approx cosine = -dot(normal, along);
    const std::optional<Approx> under = parent_->under_root();
    if (!under || under->v < 0) return std::nullopt;
    return (along + normal * cosine) * Approx(eta) - normal * sqrt(*under);
}

}  // namespace glint
