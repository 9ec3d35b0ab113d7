// SPDX-License-Identifier: Apache-2.0
#include "diagnose/observe.h"

#include <algorithm>

namespace glint {
namespace {

// Differences below these are never a mistake: of vectors, relative to their length; of colors and cosines.
constexpr double k_slack = 2e-6;

double slack_of(Quantity quantity, const ApproxVec& expected) {
    const double size = std::max({std::fabs(expected.x.v), std::fabs(expected.y.v), std::fabs(expected.z.v)});
    switch (quantity) {
        case Quantity::origin:
            return 1e-5 * std::max(1.0, size);
        case Quantity::point:
        case Quantity::t:
        case Quantity::distance:
            return k_slack * std::max(1.0, size);
        case Quantity::bytes:
            return 0;
        default:
            return k_slack * std::max(1.0, size);
    }
}

// The values in the order of the enumeration, which is that of the computation.
template <class Visit>
bool visit_values(const LoggedValues& of, const Visit& visit, Quantity first, Quantity last) {
    for (int q = static_cast<int>(first); q <= static_cast<int>(last); ++q)
        if (of.find(static_cast<Quantity>(q)) != nullptr && !visit(static_cast<Quantity>(q))) return false;
    return true;
}

// Rays that start at the hit, where the log has any such ray at all.
bool logs_children(const TraceLog& log) {
    return std::any_of(log.pixels.begin(), log.pixels.end(), [](const LoggedPixel& pixel) {
        return std::any_of(pixel.rays.begin(), pixel.rays.end(),
                           [](const LoggedRay& ray) { return ray.parent >= 0; });
    });
}

// 1: a mirror ray starts at the hit; 2: a glass ray; 3: both.
int logged_children(const LogModel& model, const ObservedPlace& place) {
    int children = 0;
    for (const LoggedRay& ray : model.log.pixels[place.pixel].rays)
        if (ray.parent == place.ray) children |= ray.kind == LoggedRayKind::mirror ? 1 : 2;
    return children;
}

// How far the next surface may be away from the place where the student's program and glint differ.
bool decides_by_rounding(const LogModel& model, const ObservedPlace& place, double yours) {
    const RayModel ray(model, place.pixel, place.ray);
    if (place.quantity == Quantity::blocked) {
        const Maybe p = ray.value(Quantity::point), n = ray.value(Quantity::normal);
        if (!p || !n) return true;
        const Vec3 point = p->value(), normal = unit(*n).value();
        const Vec3 to_light = model.scene.lights[place.light].way_from(point);
        const Vec3 side =
            unit(ApproxVec(cross(normal, std::fabs(normal.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}))).value();
        const Vec3 other = cross(normal, side);
        double by =
            std::max(p->error(), (ray.ray().generation > 1 ? 1e-3 : 2e-4) * std::max(1.0, length(*p).v));
        // Programs begin the ray above the surface or at it, and direct it from there to the light or as L.
        const Conventions& rules = model.scene.conventions;
        if (rules.offset != Offset::ray && rules.offset != Offset::scale)
            by = std::max(by, std::min(rules.epsilon, 2e-3 * std::max(1.0, length(*p).v)));
        const Vec3 up = normal * (dot(normal, to_light) < 0 ? -by : by);
        for (const Vec3 moved : {side * by, side * -by, other * by, other * -by, up})
            if (ray.is_blocked_from(place.light, point + moved, to_light) == (yours != 0)) return true;
        return false;
    }
    if (place.quantity == Quantity::hit) {
        const Maybe o = ray.value(Quantity::origin), d = ray.value(Quantity::direction);
        if (!o || !d || !ray.ray().shape) return !o || !d;
        const Vec3 along = unit(*d).value();
        const Vec3 side =
            unit(ApproxVec(cross(along, std::fabs(along.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}))).value();
        const Vec3 other = cross(along, side);
        const double by = 1e-5 + 4 * unit(*d).error();
        for (const Vec3 turned : {side * by, side * -by, other * by, other * -by}) {
            const RayHit hit = model.nearest(o->value(), along + turned,
                                             ray.parent() == nullptr ? 0 : leaving_distance(o->value()));
            if ((hit.shape == k_none ? -1.0 : hit.shape) == yours) return true;
        }
    }
    return false;
}

}  // namespace

namespace {

class PlaceVisitor {
  public:
    PlaceVisitor(const LogModel& model, const std::function<bool(const ObservedPlace&)>& visit)
        : model_(model), visit_(visit), has_children_(logs_children(model.log)) {}

    bool visit_pixel(std::uint32_t p) {
        place_ = {p, -1, k_none};
        const LoggedPixel& pixel = model_.log.pixels[p];
        children_.assign(pixel.rays.size(), {});
        std::vector<std::int32_t> roots;
        for (std::size_t r = 0; r < pixel.rays.size(); ++r) {
            const std::int32_t parent = pixel.rays[r].parent;
            (parent < 0 ? roots : children_[static_cast<std::size_t>(parent)])
                .push_back(static_cast<std::int32_t>(r));
        }
        for (const std::int32_t root : roots)
            if (!visit_tree(pixel, root)) return false;
        place_.ray = -1;
        return visit_values(
            pixel, [&](Quantity q) { return at(q); }, Quantity::pixel_color, Quantity::bytes);
    }

  private:
    bool at(Quantity q) {
        place_.quantity = q;
        return visit_(place_);
    }

    // The color of a ray comes after the rays that start at its hit. Without recursion: a log may be deep.
    bool visit_tree(const LoggedPixel& pixel, std::int32_t root) {
        struct Step {
            std::int32_t ray;
            bool is_return;
        };
        std::vector<Step> steps = {{root, false}};
        while (!steps.empty()) {
            const Step step = steps.back();
            steps.pop_back();
            place_.ray = step.ray;
            place_.light = k_none;
            const LoggedRay& ray = pixel.rays[static_cast<std::size_t>(step.ray)];
            if (step.is_return) {
                if (ray.find(Quantity::color) != nullptr && !at(Quantity::color)) return false;
                continue;
            }
            if (!visit_ray(ray)) return false;
            steps.push_back({step.ray, true});
            const std::vector<std::int32_t>& next = children_[static_cast<std::size_t>(step.ray)];
            std::for_each(next.rbegin(), next.rend(), [&](std::int32_t child) {
                steps.push_back({child, false});
            });
        }
        return true;
    }

    bool visit_ray(const LoggedRay& ray) {
        const auto visit = [&](Quantity q) { return at(q); };
        if (ray.find(Quantity::weight) != nullptr && !at(Quantity::weight)) return false;
        if (!visit_values(ray, visit, Quantity::origin, Quantity::inside)) return false;
        for (std::uint32_t l = 0; l < model_.scene.lights.size() && !ray.lights.empty(); ++l) {
            const auto light =
                std::find_if(ray.lights.begin(), ray.lights.end(),
                             [&](const LoggedLight& one) { return model_.rules.light_of[one.label] == l; });
            if (light == ray.lights.end()) continue;
            place_.light = l;
            if (!visit_values(*light, visit, Quantity::to_light, Quantity::specular)) return false;
        }
        place_.light = k_none;
        return visit_values(ray, visit, Quantity::diffuse_sum, Quantity::local) &&
               (!has_children_ || at(Quantity::children));
    }

    const LogModel& model_;
    const std::function<bool(const ObservedPlace&)>& visit_;
    bool has_children_;
    ObservedPlace place_;
    std::vector<std::vector<std::int32_t>> children_;
};

}  // namespace

void for_each_place(const LogModel& model, const std::function<bool(const ObservedPlace&)>& visit) {
    PlaceVisitor visitor(model, visit);
    for (std::uint32_t p = 0; p < model.log.pixels.size(); ++p)
        if (model.references[p].explanation && !visitor.visit_pixel(p)) return;
}

namespace {

Maybe finite(const Maybe& value) { return value && is_finite(*value) ? value : std::nullopt; }

Maybe expected_of_ray(const LogModel& model, const ObservedPlace& place, const RayModel& ray) {
    if (place.quantity == Quantity::children) {
        // 1: a mirror ray; 2: a glass ray; 3: both. What is not known is as the log has it.
        const std::optional<bool> mirror = ray.has_child(LoggedRayKind::mirror),
                                  glass = ray.has_child(LoggedRayKind::glass);
        if (!mirror && !glass) return std::nullopt;
        const int own = logged_children(model, place);
        return ApproxVec((mirror ? *mirror : own % 2 != 0) + 2.0 * (glass ? *glass : own > 1), 0, 0);
    }
    return finite(place.light != k_none ? ray.expected(place.quantity, place.light)
                                        : ray.expected(place.quantity));
}

Maybe logged_of_ray(const LogModel& model, const ObservedPlace& place, const RayModel& ray) {
    if (place.quantity == Quantity::children) return ApproxVec(logged_children(model, place), 0, 0);
    return place.light != k_none ? ray.logged(place.quantity, place.light) : ray.logged(place.quantity);
}

}  // namespace

Maybe expected_at(const LogModel& model, const ObservedPlace& place, Trial trial) {
    if (place.ray < 0) return finite(expected_of_pixel(model, place.pixel, place.quantity, trial));
    return expected_of_ray(model, place, RayModel(model, place.pixel, place.ray, trial));
}

Maybe logged_at(const LogModel& model, const ObservedPlace& place) {
    if (place.ray < 0) return logged_of_pixel(model, place.pixel, place.quantity);
    return logged_of_ray(model, place, RayModel(model, place.pixel, place.ray));
}

bool is_same(Quantity quantity, const ApproxVec& yours, const ApproxVec& expected) {
    const QuantityKind kind = info_of(quantity).kind;
    if (kind == QuantityKind::label || kind == QuantityKind::flag) return yours.x.v == expected.x.v;
    if (kind == QuantityKind::direction) return agree(unit(yours), unit(expected), k_slack);
    const double slack = slack_of(quantity, expected);
    if (kind == QuantityKind::number) {
        const bool is_cosine =
            quantity == Quantity::n_l || quantity == Quantity::r_v || quantity == Quantity::n_h;
        if (is_cosine && yours.x.v == 0 && expected.x.v <= expected.x.e) return true;  // clamped
        return agree(yours.x, expected.x, slack);
    }
    return agree(yours, expected, slack);
}

Observation observe(const LogModel& model, const ObservedPlace& place, const RayModel* of) {
    Observation seen;
    seen.place = place;
    const Maybe yours = of != nullptr ? logged_of_ray(model, place, *of) : logged_at(model, place),
                expected = of != nullptr ? expected_of_ray(model, place, *of) : expected_at(model, place, {});
    if (expected) seen.expected = *expected;
    if (!yours) {
        // Not a number; or a shape whose label could not be matched.
        if (place.quantity == Quantity::hit) return seen;
        seen.is_number = false;
        seen.verdict = Verdict::wrong;
        return seen;
    }
    seen.yours = *yours;
    if (!expected) return seen;
    if (of != nullptr && place.light != k_none) {
        const RayModel& ray = *of;
        // Behind the surface, programs need not look for shadows; of a black highlight, for its power.
        const Maybe n_l = ray.value(Quantity::n_l, place.light),
                    cone = ray.value(Quantity::spot, place.light);
        const bool is_dark = !n_l || n_l->x.v <= 1e-6 + n_l->x.e || !cone || cone->x.v <= 0;
        if (place.quantity == Quantity::blocked && is_dark) return seen;
        const bool is_highlight = place.quantity == Quantity::power;
        if (is_highlight) {
            const Maybe blocked = ray.value(Quantity::blocked, place.light);
            const std::optional<Material> surface = ray.material();
            if (!surface || surface->specular == Color{}) return seen;
            if (yours->x.v == 0 && (is_dark || !blocked || blocked->x.v != 0)) return seen;
        }
    }
    seen.verdict = is_same(place.quantity, *yours, *expected) ? Verdict::right : Verdict::wrong;
    if (seen.verdict == Verdict::wrong && place.quantity == Quantity::origin && place.ray > 0 &&
        model.log.pixels[place.pixel].rays[static_cast<std::size_t>(place.ray)].parent >= 0) {
        // Moved off the surface by an epsilon.
        const double most = 2e-2 * std::max(1.0, length(*expected).v);
        if (length(*yours - *expected).v <= most) seen.verdict = Verdict::right;
    }
    if (seen.verdict == Verdict::wrong &&
        (place.quantity == Quantity::blocked || place.quantity == Quantity::hit) &&
        decides_by_rounding(model, place, yours->x.v))
        seen.verdict = Verdict::unknown;
    return seen;
}

}  // namespace glint
