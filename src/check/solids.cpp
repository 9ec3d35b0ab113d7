// SPDX-License-Identifier: Apache-2.0
// Solids that are empty, and operands that cut nothing.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "check/checks.h"
#include "math/aabb.h"
#include "math/extent.h"
#include "math/sample_hash.h"
#include "scene/solid_steps.h"
#include "world/geometry/contains.h"

namespace glint {
namespace {

constexpr std::uint32_t k_points = 20000;
constexpr std::uint64_t k_most_tests = 30'000'000;  // of a point and an operand: a second
constexpr std::uint64_t k_mesh_tests = 20;          // a mesh takes the time of so many other operands
constexpr std::uint32_t k_seed = 0x50a1d;

// Point i of those that fill a box evenly: its corners, the middles of its edges, sides and of itself, all a
// little inside, then hashed ones.
Vec3 point_in(const Bounds& box, std::uint32_t i) {
    const Vec3 size = box.max - box.min;
    if (i < 27) {
        constexpr double k_places[] = {0.001, 0.5, 0.999};
        return box.min +
               Vec3{k_places[i % 3] * size.x, k_places[i / 3 % 3] * size.y, k_places[i / 9] * size.z};
    }
    const auto part = [&](std::uint32_t axis) { return unit_number(ray_hash(k_seed, i, axis, 0, 0)); };
    return box.min + Vec3{part(0) * size.x, part(1) * size.y, part(2) * size.z};
}

class ExaminedSolid {
  public:
    ExaminedSolid(const CheckContext& context, std::uint32_t slot)
        : geometry_(*context.world().geometry),
          tree_(tree_of(context, slot)),
          steps_(tree_),
          packed_(geometry_.solids[static_cast<std::size_t>(geometry_.class_of(slot).value(0, slot))]),
          inside_(tree_.operands.size()),
          neutral_(tree_.operands.size(), k_needed),
          is_left_out_(tree_.operands.size()) {
        for (std::size_t step = 0; step < tree_.steps.size(); ++step) parts_.push_back(steps_.parts(step));
        find_neutral(steps_.root());
        for (std::size_t operand = 0; operand < packed_.slots.size(); ++operand) {
            if (const auto box = box_of(operand)) all_.add(box->min), all_.add(box->max);
        }
        const Vec3 half = (all_.hi - all_.lo) * 0.5;
        room_ = {all_.lo - half, all_.hi + half};
    }

    /// Whether an operand has a box.
    bool is_bounded() const { return all_.lo.x <= all_.hi.x; }

    bool is_empty() {
        for (std::uint32_t operand = 0; operand <= inside_.size(); ++operand) {
            const auto box = operand < inside_.size() ? box_of(operand) : std::nullopt;
            for (std::uint32_t i = 0; i < k_points; ++i) {
                look_at(point_in(box ? *box : all(), i));
                if (holds(steps_.root())) return false;
            }
        }
        return true;
    }

    /// Whether it can be left out of a difference, intersection or clip without a change at any point that
    /// is tried. It is then left out for the next ones: of two equal cuts, one is needed.
    bool cuts_nothing(std::uint32_t operand) {
        if (neutral_[operand] == k_needed) return false;
        const bool neutral = neutral_[operand] != 0;
        const auto own = box_of(operand);
        // Where something taken away has an effect, it is itself; what is kept ends something else there.
        const Bounds others = box_of_others(operand);
        if (neutral && !(others.min.x <= others.max.x)) return false;
        for (std::uint32_t i = 0; i < k_points; ++i) {
            const Bounds& far = i % 2 == 0 ? others : room_;
            look_at(neutral ? point_in(far, i / 2) : point_in(own ? *own : room_, i));
            if (inside_[operand] == neutral) continue;
            const bool with = holds(steps_.root());
            inside_[operand] = neutral;
            if (holds(steps_.root()) != with) return false;
        }
        is_left_out_[operand] = true;
        return true;
    }

    std::uint32_t slot_of(std::uint32_t operand) const { return packed_.slots[operand]; }
    const SolidTree& tree() const { return tree_; }

  private:
    static constexpr std::int8_t k_needed = -1;

    static const SolidTree& tree_of(const CheckContext& context, std::uint32_t slot) {
        const Scene& scene = context.scene();
        const Shape& shape = scene.shapes[context.world().geometry->shape_index[slot]];
        return scene.solids[scene.get<Solid>()[shape.index].solid];
    }
    std::optional<Bounds> box_of(std::size_t operand) const {
        const auto& lo = packed_.lo;
        const auto& hi = packed_.hi;
        if (!(hi[0][operand] < k_endless)) return std::nullopt;
        return Bounds{{lo[0][operand], lo[1][operand], lo[2][operand]},
                      {hi[0][operand], hi[1][operand], hi[2][operand]}};
    }
    Bounds all() const { return {all_.lo, all_.hi}; }
    // Of all operands with a box but this one. Empty without any.
    Bounds box_of_others(std::uint32_t operand) const {
        Extent others;
        for (std::size_t i = 0; i < inside_.size(); ++i) {
            if (i == operand) continue;
            if (const auto box = box_of(i)) others.add(box->min), others.add(box->max);
        }
        return {others.lo, others.hi};
    }

    // What an operand is as if it were not there.
    void find_neutral(std::size_t step) {
        const std::vector<std::size_t>& parts = parts_[step];
        for (const std::size_t part : parts) {
            if (!steps_.is_operand(part)) {
                find_neutral(part);
                continue;
            }
            const SolidOperation operation = steps_.operation(step);
            const bool is_first = part == parts.front();
            std::int8_t& neutral = neutral_[steps_.operand(part)];
            if (operation == SolidOperation::intersection && parts.size() > 1) neutral = 1;
            if (operation == SolidOperation::clip && !is_first) neutral = 1;
            if (operation == SolidOperation::difference && !is_first) neutral = 0;
        }
    }
    void look_at(Vec3 point) {
        for (std::size_t i = 0; i < inside_.size(); ++i)
            inside_[i] = is_left_out_[i] ? neutral_[i] != 0 : contains(geometry_, packed_.slots[i], point);
    }
    bool holds(std::size_t step) const {
        const SolidOperation operation = steps_.operation(step);
        if (steps_.is_operand(step)) return inside_[steps_.operand(step)];
        const std::vector<std::size_t>& parts = parts_[step];
        const bool first = holds(parts.front());
        if (operation == SolidOperation::inverse) return !first;
        const bool is_any = operation == SolidOperation::merge || operation == SolidOperation::unite,
                   is_difference = operation == SolidOperation::difference;
        for (std::size_t i = 1; i < parts.size(); ++i) {
            if (holds(parts[i]) == (is_any || is_difference)) return is_any;
        }
        return first;
    }

    const PackedGeometry& geometry_;
    const SolidTree& tree_;
    const SolidSteps steps_;
    const PackedSolid& packed_;
    std::vector<std::vector<std::size_t>> parts_;  // by step
    std::vector<bool> inside_;                     // by operand
    std::vector<std::int8_t> neutral_;             // by operand: 0 or 1, or k_needed
    std::vector<bool> is_left_out_;                // by operand
    Extent all_;
    Bounds room_;  // that of all operands, with as much beside it
};

// Whether it is empty.
bool check_solid(CheckContext& context, std::uint32_t slot, const std::vector<bool>& hit) {
    const std::uint32_t shape = context.world().geometry->shape_index[slot];
    ExaminedSolid solid(context, slot);
    if (!solid.is_bounded()) return false;
    const std::vector<Shape>& operands = solid.tree().operands;
    bool is_hit = false;
    for (std::uint32_t i = 0; i < operands.size(); ++i) is_hit = is_hit || hit[solid.slot_of(i)];
    if (!is_hit && solid.is_empty()) {
        context.report(
            "solid-empty", context.at_shape(shape),
            fmt::format("{} seems to be empty: of {} points in its box and in those of its shapes, none is "
                        "inside",
                        context.shape(shape), k_points),
            "correct the places of its shapes, or the operation");
        return true;
    }
    for (std::uint32_t i = 0; i < operands.size(); ++i) {
        if (hit[solid.slot_of(i)] || !solid.cuts_nothing(i)) continue;
        context.report("operand-cuts-nothing", context.at_shape(shape),
                       fmt::format("shape {} of {}, a {}, seems to cut nothing off: without it, each of {} "
                                   "points tried stays inside or outside of the solid",
                                   i + 1, context.shape(shape), to_string(operands[i].kind), k_points),
                       "move or enlarge it, or remove it if it is not needed");
    }
    return false;
}

}  // namespace

void check_solids(CheckContext& context, const VisibleHits& visible, std::vector<bool>& explained) {
    const PackedGeometry& geometry = *context.world().geometry;
    if (context.scene().solids.empty()) return;
    std::vector<bool> hit(geometry.count);  // by slot
    for (const std::vector<SurfaceHit>& hits : visible.generations)
        for (const SurfaceHit& h : hits) hit[h.surface.slot] = true;
    std::uint64_t tests = 0;
    for (std::uint32_t slot = 0; slot < geometry.bounded; ++slot) {
        if (geometry.class_of(slot).kind != ShapeKind::solid) continue;
        const std::uint32_t shape = geometry.shape_index[slot];
        const auto operands = operands_of(context.scene(), context.scene().shapes[shape]);
        const std::uint64_t count = operands.size();
        const auto meshes = static_cast<std::uint64_t>(std::count_if(
            operands.begin(), operands.end(), [](const Shape& s) { return s.kind == ShapeKind::mesh; }));
        const std::uint64_t own = (count + 1) * (count + k_mesh_tests * meshes) * k_points;
        if (count == 0 || tests + own > k_most_tests) continue;
        tests += own;
        if (check_solid(context, slot, hit)) explained[shape] = true;
    }
}

}  // namespace glint
