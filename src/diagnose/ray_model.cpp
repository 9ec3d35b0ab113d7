// SPDX-License-Identifier: Apache-2.0
// Rays: their origin and direction, and what they hit.
#include "diagnose/ray_model.h"

#include <limits>

#include "math/elementary.h"
#include "world/camera_projection.h"
#include "world/world.h"

namespace glint {
namespace {

bool is_of_camera(TracerMistake mistake) {
    return mistake >= TracerMistake::columns_mirrored && mistake <= TracerMistake::viewport_point;
}

// A length by which P may be off without a mistake of the surface that a ray leaves.
double leaving_distance(Vec3 origin) { return 2e-3 * std::max(1.0, length(ApproxVec(origin)).v); }

double radius_of(const Scene& scene, const Shape& shape) {
    switch (shape.kind) {
        case ShapeKind::sphere:
            return scene.get<Sphere>()[shape.index].radius;
        case ShapeKind::cylinder:
            return scene.get<Cylinder>()[shape.index].radius;
        case ShapeKind::cone:
            return std::max(scene.get<Cone>()[shape.index].from_radius,
                            scene.get<Cone>()[shape.index].to_radius) /
                   4;
        default:
            return 0;  // flat, or not known
    }
}

}  // namespace

RayModel::RayModel(const LogModel& model, std::uint32_t pixel, std::int32_t ray, Trial trial)
    : model_(model),
      pixel_(model.log.pixels[pixel]),
      ray_(pixel_.rays[static_cast<std::size_t>(ray)]),
      pixel_index_(pixel),
      ray_index_(ray),
      trial_(trial) {
    const PixelReference& reference = model.references[pixel];
    const std::int32_t paired = reference.explanation ? reference.ray[static_cast<std::size_t>(ray)] : -1;
    if (paired >= 0) reference_ = &reference.explanation->rays[static_cast<std::size_t>(paired)];
    if (ray_.parent >= 0) parent_ = std::make_unique<RayModel>(model, pixel, ray_.parent, trial);
}

Maybe RayModel::logged(Quantity quantity) const {
    const LoggedValue* value = ray_.find(quantity);
    if (value == nullptr) return std::nullopt;
    if (quantity == Quantity::hit) {
        const std::optional<std::uint32_t> of = shape();
        return of ? Maybe(ApproxVec(*of == k_none ? -1.0 : *of, 0, 0)) : std::nullopt;
    }
    const Vec3 v = value->value.value();
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return std::nullopt;
    if (quantity == Quantity::normal && model_.rules.turns_normals) {
        const Maybe expected = this->expected(quantity);
        return expected && dot(value->value, *expected).v < 0 ? -value->value : value->value;
    }
    return value->value * Approx(factor(quantity));
}

double RayModel::factor(Quantity quantity) const {
    if (quantity == Quantity::t && !model_.rules.has_unit_t) {
        const LoggedValue* d = ray_.find(Quantity::direction);
        if (d != nullptr) return length(d->value).v;
        return reference_ != nullptr ? length(ApproxVec(reference_->direction)).v : 1;
    }
    if (quantity == Quantity::view) return model_.rules.view_sign;
    return 1 / model_.rules.white[static_cast<std::size_t>(quantity)];
}

Maybe RayModel::value(Quantity quantity) const {
    const Maybe own = logged(quantity);
    return own ? own : expected(quantity);
}

Maybe RayModel::expected(Quantity quantity) const {
    switch (quantity) {
        case Quantity::origin:
            if (!parent_) return camera_origin();
            if (is(TracerMistake::secondary_from_camera)) return ApproxVec(model_.scene.camera.position);
            return parent_->value(Quantity::point);
        case Quantity::direction:
            return parent_ ? secondary_direction() : camera_direction();
        case Quantity::hit: {
            const HitModel& hit = expected_hit();
            if (!hit.known) return std::nullopt;
            return ApproxVec(hit.shape == k_none ? -1.0 : hit.shape, 0, 0);
        }
        case Quantity::t: {
            const HitModel& hit = expected_hit();
            if (!hit.known || hit.shape == k_none || shape() != hit.shape) return std::nullopt;
            return ApproxVec(hit.t, {}, {});
        }
        case Quantity::point: {
            if (is(TracerMistake::self_hit) && expected_hit().known && expected_hit().shape == k_none)
                return std::nullopt;
            if (shape() == k_none || !shape()) return std::nullopt;
            const Maybe o = value(Quantity::origin), d = value(Quantity::direction), t = value(Quantity::t);
            if (!o || !d || !t) return std::nullopt;
            if (is(TracerMistake::point_without_origin)) return unit(*d) * t->x;
            if (is(TracerMistake::point_from_camera))
                return ApproxVec(model_.scene.camera.position) + unit(*d) * t->x;
            if (is(TracerMistake::point_unit_direction)) {
                const Approx size = length(*d);
                return std::fabs(size.v - 1) > 1e-3 ? Maybe(*o + unit(*d) * (t->x / size))
                                                    : *o + unit(*d) * t->x;
            }
            return *o + unit(*d) * t->x;
        }
        case Quantity::normal:
            return turned_normal();
        case Quantity::view: {
            const Maybe p = value(Quantity::point);
            if (!p) return std::nullopt;
            if (model_.scene.camera.lighting_eye && !is(TracerMistake::view_is_eye))
                return unit(ApproxVec(*model_.scene.camera.lighting_eye) - *p);
            if (is(TracerMistake::view_is_eye))
                return ApproxVec(model_.scene.camera.lighting_eye.value_or(model_.scene.camera.position));
            if (is(TracerMistake::view_to_camera)) return unit(ApproxVec(model_.scene.camera.position) - *p);
            const Maybe d = value(Quantity::direction);
            if (!d) return std::nullopt;
            return is(TracerMistake::view_reversed) ? unit(*d) : -unit(*d);
        }
        case Quantity::inside: {
            const std::optional<std::uint32_t> of = shape();
            if (!of || *of == k_none) return std::nullopt;
            const ShapeKind kind = model_.scene.shapes[*of].kind;
            if (kind != ShapeKind::sphere && kind != ShapeKind::box) return std::nullopt;
            const Maybe n = own_normal(), d = value(Quantity::direction);
            if (!n || !d) return std::nullopt;
            const Approx cosine = dot(*n, unit(*d));
            if (std::fabs(cosine.v) < 0.01 + cosine.e) return std::nullopt;
            return ApproxVec(cosine.v > 0 ? 1.0 : 0.0, 0, 0);
        }
        default:
            return sum(quantity);
    }
}

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
            u = x / width - 0.5, v = 0.5 - y / height;
            break;
        case TracerMistake::pixel_center:
            u = (x + 0.5) / width - 0.5, v = 0.5 - (y + 0.5) / height;
            break;
        case TracerMistake::pixel_opposite_corner:
            u = (trial_.variant == 2 ? x : x + 1) / width - 0.5,
            v = 0.5 - (trial_.variant == 1 ? y : y + 1) / height;
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

// The number under the root of Snell's law, for a glass ray that starts at this hit.
std::optional<Approx> RayModel::under_root() const {
    const std::optional<Material> glass = material();
    const Maybe own = own_normal(), d = value(Quantity::direction);
    if (!glass || !own || !d) return std::nullopt;
    const Approx cosine = dot(*own, about_unit(*d));
    double eta = cosine.v > 0 ? glass->ior : 1 / glass->ior;
    if (is(TracerMistake::refraction_inverted)) eta = 1 / eta;
    if (is(TracerMistake::refraction_from_outside)) eta = 1 / glass->ior;
    if (is(TracerMistake::refraction_ignored)) eta = 1;
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
    double eta = leaves ? glass->ior : 1 / glass->ior;
    if (is(TracerMistake::refraction_inverted)) eta = 1 / eta;
    if (is(TracerMistake::refraction_from_outside)) eta = 1 / glass->ior;
    const Approx cosine = -dot(normal, along);
    const std::optional<Approx> under = parent_->under_root();
    if (!under || under->v < 0) return std::nullopt;
    return (along + normal * cosine) * Approx(eta) - normal * sqrt(*under);
}

bool RayModel::is_reference() const {
    if (is_reference_) return *is_reference_;
    const auto decide = [&] {
        if (reference_ == nullptr || (parent_ && !parent_->is_reference())) return false;
        const Maybe o = value(Quantity::origin), d = value(Quantity::direction);
        if (!o || !d) return false;
        const double slack = parent_ ? leaving_distance(reference_->origin)
                                     : 1e-5 * std::max(1.0, length(ApproxVec(reference_->origin)).v);
        return agree(*o, ApproxVec(reference_->origin), slack) &&
               agree(unit(*d), unit(ApproxVec(reference_->direction)), 2e-5);
    };
    is_reference_ = decide();
    return *is_reference_;
}

const HitModel& RayModel::expected_hit() const {
    if (!hit_) hit_ = find_hit();
    return *hit_;
}

HitModel RayModel::find_hit() const {
    HitModel hit;
    const Maybe o = value(Quantity::origin), d = value(Quantity::direction);
    if (!o || !d) return hit;
    const Vec3 origin = o->value(), along = unit(*d).value();
    if (!(dot(along, along) > 0.5)) return hit;
    const bool at_hit = trial_.mistake != TracerMistake::none && info_of(trial_.mistake).at == Quantity::hit;
    if (!at_hit && is_reference()) {
        hit.known = hit.is_reference = true;
        if (!reference_->hit) return hit;
        hit.shape = reference_->hit->shape;
        const Vec3 used = reference_->hit->normal;
        hit.normal = reference_->hit->turned ? -used : used;
        hit.t = reference_->t * length(ApproxVec(reference_->direction)).v;
        hit.t.e = hit_error(hit, origin, along);
        const Vec3 moved = origin - reference_->origin,
                   turned = along - unit(ApproxVec(reference_->direction)).value();
        const double cosine = std::max(1e-3, std::fabs(dot(used, along)));
        hit.t.e += (length(ApproxVec(moved)).v + o->error() +
                    hit.t.v * (length(ApproxVec(turned)).v + unit(*d).error())) /
                   cosine;
        if (parent_ && !logged(Quantity::origin)) hit.t.e += leaving_distance(origin) / cosine;
        return hit;
    }
    double t_min = parent_ ? least_distance(origin) : model_.scene.conventions.camera_t_min;
    if (at_hit) {
        hit = mistaken_hit(origin, along, t_min);
    } else {
        hit.known = true;
        const std::optional<std::uint32_t> left = parent_ ? parent_->shape() : std::nullopt;
        for (int i = 0; i < 4; ++i) {
            const RayHit found = model_.nearest(origin, along, t_min);
            hit.shape = found.shape;
            if (found.shape == k_none) return hit;
            hit.t = found.t;
            hit.normal = found.normal;
            // The surface that the ray leaves, beside which its origin is not exactly.
            if (!left || found.shape != *left || found.t > leaving_distance(origin)) break;
            t_min = found.t + least_distance(origin);
        }
    }
    if (hit.known && hit.shape != k_none) {
        hit.t.e += hit_error(hit, origin, along);
        if (hit.normal)
            hit.t.e += (o->error() + hit.t.v * unit(*d).error()) /
                       std::max(1e-3, std::fabs(dot(*hit.normal, along)));
    }
    return hit;
}

HitModel RayModel::mistaken_hit(Vec3 origin, Vec3 along, double t_min) const {
    HitModel hit;
    if (is(TracerMistake::self_hit)) {
        // From the origin as it is, with the rounding that it has.
        if (!parent_) return hit;
        const RayHit found = model_.nearest(origin, along, 0);
        hit.known = true;
        hit.shape = found.shape;
        hit.t = {found.t, found.shape == parent_->shape() && found.t < leaving_distance(origin)
                              ? leaving_distance(origin)
                              : 0};
        hit.normal = found.normal;
        return hit;
    }
    const ShapeWorlds& worlds = model_.shape_worlds();
    if (!worlds.exists()) return hit;
    const Maybe logged_d = value(Quantity::direction);
    const double size = length(*logged_d).v;
    if (is(TracerMistake::quadratic_of_unit) && std::fabs(size - 1) < 1e-3) return hit;
    hit.known = true;
    const std::optional<std::uint32_t> left = parent_ ? parent_->shape() : std::nullopt;
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        const double begin = is(TracerMistake::behind_origin) || is(TracerMistake::near_root_only) ? -1e9
                             : left == i ? leaving_distance(origin)
                                         : t_min;
        std::vector<double> all = worlds.hits(i, origin, along, begin);
        const Shape& shape = model_.scene.shapes[i];
        if (is(TracerMistake::quadratic_of_unit) && shape.kind == ShapeKind::sphere &&
            shape.transform == k_none) {
            const Sphere& sphere = model_.scene.get<Sphere>()[shape.index];
            const Vec3 oc = origin - sphere.center, d = along * size;
            const double a = trial_.variant == 0 ? 1 : size * size, b = dot(oc, d),
                         c = dot(oc, oc) - sphere.radius * sphere.radius;
            all.clear();
            if (b * b - a * c < 0) continue;
            const double root = std::sqrt(b * b - a * c);
            for (const double t : {-b - root, -b + root})
                if (t * size > begin) all.push_back((trial_.variant == 0 ? t : t * size * size) * size);
        }
        if (all.empty() || (is(TracerMistake::near_root_only) && all[0] < t_min)) continue;
        const double t = is(TracerMistake::far_root) && all.size() > 1 ? all[1] : all[0];
        const bool is_first = hit.shape == k_none;
        const bool replaces = is(TracerMistake::first_shape)      ? is_first
                              : is(TracerMistake::last_shape)     ? true
                              : is(TracerMistake::farthest_shape) ? is_first || t > hit.t.v
                                                                  : is_first || t < hit.t.v;
        if (!replaces) continue;
        hit.shape = static_cast<std::uint32_t>(i);
        hit.t = t;
    }
    return hit;
}

// The rounding of single precision in the usual formulas: that of a sphere takes the root of a difference of
// squares, of which little may be left.
double RayModel::hit_error(const HitModel& hit, Vec3 origin, Vec3 along) const {
    const Shape& shape = model_.scene.shapes[hit.shape];
    const double cosine = hit.normal ? std::max(1e-3, std::fabs(dot(*hit.normal, along))) : 0.1;
    const double far = std::max({1.0, length(ApproxVec(origin)).v, std::fabs(hit.t.v),
                                 length(ApproxVec(origin + along * hit.t.v)).v});
    const double radius = radius_of(model_.scene, shape);
    double squares = 16 * far;
    if (radius > 0) {
        const double away = shape.kind == ShapeKind::sphere
                                ? length(ApproxVec(origin - model_.scene.get<Sphere>()[shape.index].center)).v
                                : far;
        squares += 4 * (away * away + radius * radius) / radius;
    }
    // Programs that take D as a unit vector do not divide by D.D, which rounding moves off 1.
    const Maybe d = logged(Quantity::direction);
    const double off = d ? std::fabs(length(*d).v - 1) : 0;
    return (k_single_rounding * squares + (off < 1e-3 ? 2 * off * std::fabs(hit.t.v) : 0)) / cosine;
}

std::optional<std::uint32_t> RayModel::shape() const {
    if (ray_.is_miss) return k_none;
    if (ray_.shape) {
        const std::uint32_t of = model_.rules.shape_of[*ray_.shape];
        return of == k_none ? std::nullopt : std::optional(of);
    }
    const HitModel& hit = expected_hit();
    return hit.known ? std::optional(hit.shape) : std::nullopt;
}

std::optional<Material> RayModel::material() const {
    const std::optional<std::uint32_t> of = shape();
    if (!of || *of == k_none) return std::nullopt;
    ExplainedHit hit;
    hit.shape = *of;
    hit.material = model_.scene.shapes[*of].material;
    hit.color = model_.scene.shape_color(*of);
    if (is_reference() && reference_->hit && reference_->hit->shape == *of)
        hit.material = reference_->hit->material, hit.color = reference_->hit->color;
    return material_of(hit, model_.scene);
}

Maybe RayModel::own_normal() const {
    const std::optional<std::uint32_t> of = shape();
    if (!of || *of == k_none) return std::nullopt;
    const Shape& shape = model_.scene.shapes[*of];
    const Maybe p = value(Quantity::point);
    if (!p) return std::nullopt;
    if (shape.kind == ShapeKind::sphere && shape.transform == k_none) {
        const Sphere& sphere = model_.scene.get<Sphere>()[shape.index];
        return unit(is(TracerMistake::normal_of_origin) ? *p : *p - ApproxVec(sphere.center));
    }
    const HitModel& hit = expected_hit();
    if (hit.known && hit.shape == *of && hit.normal) {
        const double radius = radius_of(model_.scene, shape);
        const bool is_flat = shape.kind == ShapeKind::plane || shape.kind == ShapeKind::disc ||
                             shape.kind == ShapeKind::triangle || shape.kind == ShapeKind::polygon ||
                             shape.kind == ShapeKind::box;
        const double moved = p->error() + hit.t.e;
        const double error = is_flat ? 2e-6 : radius > 0 ? 1e-5 + 2 * moved / radius : 1e-3;
        ApproxVec normal(*hit.normal);
        normal.x.e = normal.y.e = normal.z.e = error;
        return normal;
    }
    if (shape.transform != k_none) return std::nullopt;
    if (shape.kind == ShapeKind::plane) return unit(ApproxVec(model_.scene.get<Plane>()[shape.index].normal));
    if (shape.kind == ShapeKind::disc) return unit(ApproxVec(model_.scene.get<Disc>()[shape.index].normal));
    if (shape.kind == ShapeKind::triangle) {
        const Triangle& triangle = model_.scene.get<Triangle>()[shape.index];
        return unit(ApproxVec(
            cross(triangle.vertices[1] - triangle.vertices[0], triangle.vertices[2] - triangle.vertices[0])));
    }
    return std::nullopt;
}

Maybe RayModel::turned_normal() const {
    const Maybe own = own_normal(), d = value(Quantity::direction);
    if (!own || !d) return std::nullopt;
    const Shape& shape = model_.scene.shapes[*this->shape()];
    const auto is_open = [&] {
        switch (shape.kind) {
            case ShapeKind::sphere:
            case ShapeKind::box:
                return false;
            case ShapeKind::cylinder:
                return !model_.scene.get<Cylinder>()[shape.index].caps;
            case ShapeKind::cone:
                return !model_.scene.get<Cone>()[shape.index].caps;
            default:
                return true;
        }
    };
    const Facing facing = model_.scene.conventions.facing;
    const bool turns = facing != Facing::none && (facing != Facing::open || is_open()) && dot(*own, *d).v > 0;
    const ApproxVec normal = turns && !is(TracerMistake::normal_not_turned) ? -*own : *own;
    if (is(TracerMistake::normal_from_center) && shape.kind == ShapeKind::cylinder &&
        shape.transform == k_none) {
        const Cylinder& cylinder = model_.scene.get<Cylinder>()[shape.index];
        const Maybe p = value(Quantity::point);
        const ApproxVec away =
            unit(*p - ApproxVec(trial_.variant == 0 ? (cylinder.from + cylinder.to) * 0.5 : cylinder.from));
        return dot(away, normal).v < 0 ? -away : away;
    }
    if ((is(TracerMistake::normal_transform) || is(TracerMistake::normal_untransformed)) &&
        shape.transform != k_none) {
        // M n in place of M^-T n: the shape's own n is M^T times the world's.
        const auto& m = model_.scene.transforms[shape.transform].m;
        const Vec3 n = normal.value();
        const Vec3 own_n{m[0][0] * n.x + m[1][0] * n.y + m[2][0] * n.z,
                         m[0][1] * n.x + m[1][1] * n.y + m[2][1] * n.z,
                         m[0][2] * n.x + m[1][2] * n.y + m[2][2] * n.z};
        const Vec3 turned{m[0][0] * own_n.x + m[0][1] * own_n.y + m[0][2] * own_n.z,
                          m[1][0] * own_n.x + m[1][1] * own_n.y + m[1][2] * own_n.z,
                          m[2][0] * own_n.x + m[2][1] * own_n.y + m[2][2] * own_n.z};
        ApproxVec result = unit(ApproxVec(is(TracerMistake::normal_untransformed) ? own_n : turned));
        for (Approx* c : {&result.x, &result.y, &result.z}) c->e += 3 * normal.error();
        return result;
    }
    return is(TracerMistake::normal_reversed) ? -normal : normal;
}

Maybe RayModel::used_normal() const {
    const Maybe n = value(Quantity::normal);
    if (!n || !is(TracerMistake::normal_not_unit)) return n ? Maybe(about_unit(*n)) : n;
    if (logged(Quantity::normal)) return n;
    const std::optional<std::uint32_t> of = shape();
    if (!of || *of == k_none) return n;
    const Shape& shape = model_.scene.shapes[*of];
    if (shape.kind == ShapeKind::sphere) return *n * Approx(model_.scene.get<Sphere>()[shape.index].radius);
    if (shape.kind == ShapeKind::plane)
        return *n * length(ApproxVec(model_.scene.get<Plane>()[shape.index].normal));
    return n;
}

Maybe RayModel::used_view() const {
    const Maybe v = value(Quantity::view);
    if (!v || !is(TracerMistake::view_not_unit)) return v ? Maybe(about_unit(*v)) : v;
    if (logged(Quantity::view)) return v;
    const Maybe d = value(Quantity::direction);
    return d ? Maybe(-*d) : v;
}

}  // namespace glint
