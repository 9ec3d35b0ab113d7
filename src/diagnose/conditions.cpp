// SPDX-License-Identifier: Apache-2.0
#include "diagnose/conditions.h"

#include <fmt/format.h>

#include <algorithm>

namespace glint {
namespace {

const LoggedRay* ray_of(const LogModel& model, const ObservedPlace& place) {
    return place.ray < 0 ? nullptr : &model.log.pixels[place.pixel].rays[static_cast<std::size_t>(place.ray)];
}

std::optional<std::uint32_t> shape_of(const LogModel& model, const ObservedPlace& place) {
    if (place.ray < 0) return std::nullopt;
    const auto shape = RayModel(model, place.pixel, place.ray).shape();
    return shape && *shape != k_none ? shape : std::nullopt;
}

}  // namespace

std::vector<Condition> place_conditions(const LogModel& model) {
    std::vector<Condition> list;
    list.push_back({"in mirror and glass rays", [&model](const ObservedPlace& p) {
                        const LoggedRay* r = ray_of(model, p);
                        return r != nullptr && r->generation > 0;
                    }});
    list.push_back({"in camera rays", [&model](const ObservedPlace& p) {
                        const LoggedRay* r = ray_of(model, p);
                        return r != nullptr && r->generation == 0;
                    }});
    list.push_back({"in glass rays", [&model](const ObservedPlace& p) {
                        const LoggedRay* r = ray_of(model, p);
                        return r != nullptr && r->kind == LoggedRayKind::glass;
                    }});
    list.push_back({"where the ray comes from inside", [&model](const ObservedPlace& p) {
                        if (p.ray < 0) return false;
                        const RayModel r(model, p.pixel, p.ray);
                        const Maybe inside = r.expected(Quantity::inside);
                        return inside && inside->x.v != 0;
                    }});
    for (int k = 0; k < k_shape_kinds; ++k) {
        const auto kind = static_cast<ShapeKind>(k);
        list.push_back({fmt::format("on shapes of the kind {}", to_string(kind)),
                        [&model, kind](const ObservedPlace& p) {
                            const auto s = shape_of(model, p);
                            return s && model.scene.shapes[*s].kind == kind;
                        },
                        true});
    }
    for (int k = 0; k < k_light_kinds; ++k) {
        const auto kind = static_cast<LightKind>(k);
        list.push_back({fmt::format("with lights of the kind {}", to_string(kind)),
                        [&model, kind](const ObservedPlace& p) {
                            return p.light != k_none && model.scene.lights[p.light].kind == kind;
                        }});
    }
    list.push_back({"where N.L is below 0", [&model](const ObservedPlace& p) {
                        if (p.light == k_none) return false;
                        const Maybe n_l = RayModel(model, p.pixel, p.ray).value(Quantity::n_l, p.light);
                        return n_l && n_l->x.v < 0;
                    }});
    for (std::uint32_t l = 0; l < std::min<std::size_t>(model.scene.lights.size(), 16); ++l)
        list.push_back({fmt::format("with light {} of the scene", l + 1),
                        [l](const ObservedPlace& p) { return p.light == l; }});
    return list;
}

}  // namespace glint
