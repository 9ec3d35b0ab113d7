// SPDX-License-Identifier: Apache-2.0
// The values of a logged ray, and what they should be.
#include "diagnose/ray_model.h"

#include "math/elementary.h"

namespace glint {

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
    std::optional<Maybe>& known = values_[static_cast<std::size_t>(quantity)];
    if (!known) {
        const Maybe own = logged(quantity);
        known = own ? own : expected(quantity);
    }
    return *known;
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

}  // namespace glint
