// SPDX-License-Identifier: Apache-2.0
#pragma once
// What should follow from the values of a logged ray: each quantity is computed from the log's own earlier
// values, where it has them, and otherwise from what these should be. With a mistake, the computation of one
// quantity is changed.
#include <array>
#include <map>
#include <memory>
#include <optional>

#include "diagnose/log_model.h"

namespace glint {

using Maybe = std::optional<ApproxVec>;
inline constexpr double k_pi = 3.14159265358979323846;

/// The least distance of hits from the start of a secondary ray, which may lie a little below the surface.
inline double least_distance(Vec3 origin) { return 1e-9 * std::max(1.0, length(ApproxVec(origin)).v); }

/// How far the origin of a ray may be away from the surface that it leaves.
inline double leaving_distance(Vec3 origin) { return 2e-3 * std::max(1.0, length(ApproxVec(origin)).v); }

/// A length by which a curved shape's normal changes; 0 for flat shapes and others.
double radius_of(const Scene& scene, const Shape& shape);

/// The nearest hit of a ray. shape k_none: it hits nothing; `known` false: it cannot be said.
struct HitModel {
    bool known = false;
    std::uint32_t shape = k_none;
    Approx t;                    ///< in world units
    std::optional<Vec3> normal;  ///< the shape's own, unit
};

class RayModel {
  public:
    RayModel(const LogModel& model, std::uint32_t pixel, std::int32_t ray, Trial trial = {});

    /// What the quantity should be. Nothing: it cannot be said, or does not exist. Numbers and flags are in
    /// x.
    Maybe expected(Quantity quantity) const;
    Maybe expected(Quantity quantity, std::uint32_t light) const;
    /// The log's value, in glint's conventions; nothing if it has none, or one that is not a number.
    Maybe logged(Quantity quantity) const;
    Maybe logged(Quantity quantity, std::uint32_t light) const;
    /// The log's value, else the expected one.
    Maybe value(Quantity quantity) const;
    Maybe value(Quantity quantity, std::uint32_t light) const;

    /// glint's values over the log's: signs, units of t, the scale of colors.
    double factor(Quantity quantity) const;
    double light_factor(Quantity quantity) const;

    const HitModel& expected_hit() const;
    /// The shape that the log says, else the expected one; k_none: a miss; nothing: unknown.
    std::optional<std::uint32_t> shape() const;
    std::optional<Material> material() const;
    /// Whether a mirror ray (or glass ray) should start at the hit.
    std::optional<bool> has_child(LoggedRayKind kind) const;
    /// The vectors as they are used in products: unit, unless the mistake says otherwise.
    Maybe used_normal() const;
    Maybe used_view() const;
    Maybe used_light(std::uint32_t light) const;
    const ExplainedRay* reference() const { return reference_; }
    /// Whether the ray is that of the explanation, so far as the log says.
    bool is_reference() const;
    const LoggedRay& ray() const { return ray_; }
    const RayModel* parent() const { return parent_.get(); }
    /// The light's row of the log, if there is one.
    const LoggedLight* logged_light(std::uint32_t light) const;
    /// Whether a shape blocks the light at the log's P, as the mistake says.
    std::optional<bool> is_blocked(std::uint32_t light) const;
    /// The same from a moved point, towards a moved direction.
    bool is_blocked_from(std::uint32_t light, Vec3 point, Vec3 to_light, bool ends_at_light = true) const;

  private:
    bool is(TracerMistake mistake) const { return trial_.mistake == mistake; }
    Maybe camera_origin() const;
    Maybe camera_direction() const;
    std::optional<std::array<double, 2>> mistaken_viewport() const;
    Maybe secondary_direction() const;
    Maybe refracted() const;
    /// False: total reflection. Nothing: rounding decides, or it is not known.
    std::optional<bool> is_refracted() const;
    std::optional<Approx> under_root() const;
    /// Index of refraction of the side that a ray comes from over that of the other.
    double index_ratio(double ior, bool leaves) const;
    HitModel find_hit() const;
    HitModel mistaken_hit(Vec3 origin, Vec3 direction, double t_min) const;
    double hit_error(const HitModel& hit, Vec3 origin, Vec3 unit_direction) const;
    Maybe own_normal() const;
    Maybe turned_normal() const;
    std::optional<Approx> attenuation(std::uint32_t light) const;
    std::optional<Approx> spot(std::uint32_t light) const;
    std::optional<Approx> highlight_cosine(std::uint32_t light) const;
    std::optional<Approx> power(std::uint32_t light) const;
    Maybe term(Quantity quantity, std::uint32_t light) const;
    Maybe sum(Quantity quantity) const;
    int lights_with_direction() const;
    Maybe local() const;
    Maybe weight() const;
    Maybe relative_weight() const;
    Maybe color() const;
    Maybe chain_color() const;
    std::optional<double> local_share() const;

    const LogModel& model_;
    const LoggedPixel& pixel_;
    const LoggedRay& ray_;
    std::uint32_t pixel_index_;
    std::int32_t ray_index_;
    Trial trial_;
    const ExplainedRay* reference_ = nullptr;
    std::unique_ptr<RayModel> parent_;
    // What value() has found: each value is needed by several others.
    mutable std::array<std::optional<Maybe>, k_quantities> values_;
    mutable std::map<std::pair<Quantity, std::uint32_t>, Maybe> light_values_;
    mutable std::optional<HitModel> hit_;
    mutable std::optional<bool> is_reference_;
};

/// What a pixel's color, clamped color and bytes should be.
Maybe expected_of_pixel(const LogModel& model, std::uint32_t pixel, Quantity quantity, Trial trial);
/// The log's value for a pixel, in glint's conventions.
Maybe logged_of_pixel(const LogModel& model, std::uint32_t pixel, Quantity quantity);

}  // namespace glint
