// SPDX-License-Identifier: Apache-2.0
#include "check/solid_faces.h"

#include <algorithm>
#include <utility>

#include "base/sort_stably.h"
#include "math/number.h"
#include "math/transform.h"
#include "trace/hits/solid_states-inl.h"
#include "world/appearance/appearance.h"
#include "world/geometry/primitive_bounds-inl.h"

namespace glint {
namespace {

// Within these parts of the coordinates, rounding decides which face is first. The convention's epsilon does
// not: a cut that reaches further by less is drawn as it is meant.
constexpr double k_one_face = 1e-9;
constexpr double k_same_direction = 2e-5, k_flattest = 0.02;  // radians; cosine
constexpr double k_side_step = 1e-4;                          // of the solid's size
constexpr std::size_t k_most_beside = 8;                      // crossings that one is compared with

double largest(Vec3 v) {
    return number::max(number::abs(v.x), number::max(number::abs(v.y), number::abs(v.z)));
}

}  // namespace

SolidFaces::SolidFaces(const WorldParts& world, const Kernels& kernels, std::uint32_t slot)
    : world_(world),
      geometry_(*world.geometry),
      kernels_(kernels),
      packed_(geometry_.solids[static_cast<std::size_t>(geometry_.class_of(slot).value(0, slot))]),
      shape_(geometry_.shape_index[slot]),
      box_(to_bounds(HWY_NAMESPACE::primitive_bounds(geometry_, slot))),
      step_(k_side_step * largest(box_.max - box_.min)),
      crossings_(count()) {
    for (const std::uint32_t operand : packed_.slots) looks_.push_back(look_of(operand));
}

void SolidFaces::look_along(const SightLine& line) {
    std::vector<Crossing> all;
    for (std::uint32_t i = 0; i < count(); ++i) {
        find_crossings(i, line.origin, line.direction, crossings_[i]);
        all.insert(all.end(), crossings_[i].begin(), crossings_[i].end());
    }
    sort_stably(all, [](const Crossing& a, const Crossing& b) { return a.t < b.t; });
    std::vector<OperandPair> done;  // a line counts once for a pair
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Crossing& first = all[i];
        if (first.t <= 0) continue;
        const Vec3 point = line.origin + line.direction * first.t;
        const double near = k_one_face * (largest(line.origin) + largest(point));
        if (first.t <= near / k_flattest) continue;  // the surface that the ray leaves
        // Of the shape that is hit, the face itself counts; behind another shape nothing is seen.
        if (first.t > line.end + (line.shape == shape_ ? near : -near)) break;
        const std::size_t end = std::min(all.size(), i + 1 + k_most_beside);
        for (std::size_t k = i + 1; k < end && all[k].t <= first.t + near / k_flattest; ++k) {
            const std::uint32_t a = first.operand, b = all[k].operand;
            const OperandPair pair{std::min(a, b), std::max(a, b)};
            if (a == b || std::find(done.begin(), done.end(), pair) != done.end()) continue;
            const Difference difference = difference_of(first, all[k], near);
            if (difference == Difference::none || !are_one_face(line, first, all[k], near)) continue;
            done.push_back(pair);
            FacesFound& of = found_[pair];
            ++of.lines;
            of.changes_surface = of.changes_surface || difference == Difference::surface;
        }
    }
}

SolidFaces::Look SolidFaces::look_of(std::uint32_t slot) const {
    const SurfaceId id = geometry_.surface_of(slot);
    const std::uint32_t row = material_row(world_, id);
    const auto values = surface_values(world_, id);
    return {values, world_.texture_of(row), values[k_transmission] > 0 || world_.is_transparent(row)};
}

void SolidFaces::find_crossings(std::uint32_t operand, Vec3 origin, Vec3 direction,
                                std::vector<Crossing>& to) {
    to.clear();
    kernels_.operand_intervals(geometry_, packed_.slots[operand], origin, direction, ends_);
    for (std::size_t k = 0; k + 1 < ends_.size(); k += 2) {
        if (!(ends_[k] < ends_[k + 1])) continue;
        to.push_back({ends_[k], operand, true});
        to.push_back({ends_[k + 1], operand, false});
    }
}

SolidFaces::States SolidFaces::states_at(double t) const {
    States states;
    for (const std::vector<Crossing>& of : crossings_) {
        std::uint32_t inside = 0;
        for (const Crossing& crossing : of)
            if (crossing.t <= t) inside = crossing.is_entry ? 1 : 0;
        states.push_back(inside);
    }
    return states;
}

// What a ray sees that crosses the faces of operands one after the other: the operands whose faces are
// surfaces, up to one that is opaque.
SolidFaces::Operands SolidFaces::seen_in(States states, const std::vector<Operands>& order,
                                         const States& last) const {
    Operands seen;
    for (const Operands& together : order) {
        States next = states;
        for (const std::uint32_t operand : together) next[operand] = last[operand];
        if ((HWY_NAMESPACE::find_surface(packed_.items, states.data(), next.data()) & 1) != 0) {
            seen.push_back(static_cast<std::uint32_t>(
                HWY_NAMESPACE::find_face(packed_.items, states.data(), next.data(), count(), 1)));
            if (!looks_[seen.back()].is_clear) break;
        }
        states = std::move(next);
    }
    return seen;
}

// What the order of two crossings changes. Others that are near are taken to be in front of them, or behind.
SolidFaces::Difference SolidFaces::difference_of(const Crossing& first, const Crossing& second, double near) {
    steps_ += 8 * (count() + packed_.items.size());
    const std::uint32_t a = first.operand, b = second.operand;
    const States before = states_at(first.t - near), after = states_at(second.t + near);
    if (before[a] == after[a] || before[b] == after[b]) return Difference::none;  // an edge
    Difference difference = Difference::none;
    for (States from : {before, after}) {
        from[a] = before[a], from[b] = before[b];
        const Operands one = seen_in(from, {{a}, {b}}, after);
        for (const Operands& other : {seen_in(from, {{b}, {a}}, after), seen_in(from, {{a, b}}, after)}) {
            if (one.size() != other.size()) return Difference::surface;
            for (std::size_t i = 0; i < one.size(); ++i)
                if (looks_[one[i]] != looks_[other[i]]) difference = Difference::material;
        }
    }
    return difference;
}

// Whether the faces are near each other, and remain so beside the line: those that meet in an edge, or touch
// in a point, do not. How the way to a face changes beside the line gives its normal.
bool SolidFaces::are_one_face(const SightLine& line, const Crossing& a, const Crossing& b, double near) {
    const Vec3 d = line.direction;
    const Vec3 u = normalize(cross(d, number::abs(d.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
    double slopes = 0, differences = 0;  // squared
    for (const Vec3 side : {u, cross(d, u)}) {
        const Vec3 origin = line.origin + side * step_;
        const double slope = (nearest(a, origin, d) - a.t) / step_;
        const double of_other = (nearest(b, origin, d) - b.t) / step_;
        slopes += slope * slope;
        differences += (slope - of_other) * (slope - of_other);
    }
    // False if something is not a number.
    return 1 + slopes < 1 / (k_flattest * k_flattest) &&
           differences <= k_same_direction * k_same_direction * (1 + slopes) &&
           b.t - a.t <= near * number::sqrt(1 + slopes);
}

// The operand's crossing of another line in the same direction that is nearest to that one, or infinity.
double SolidFaces::nearest(const Crossing& to, Vec3 origin, Vec3 direction) {
    find_crossings(to.operand, origin, direction, beside_);
    double t = number::k_infinity;
    for (const Crossing& crossing : beside_) {
        if (crossing.is_entry == to.is_entry && number::abs(crossing.t - to.t) < number::abs(t - to.t))
            t = crossing.t;
    }
    return t;
}

}  // namespace glint
