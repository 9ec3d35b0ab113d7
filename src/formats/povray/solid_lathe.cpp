// SPDX-License-Identifier: Apache-2.0
#include "formats/povray/solid_lathe.h"

#include <utility>

#include "glint/solid.h"

namespace glint::povray {
namespace {

constexpr double k_on_axis = 1e-9;

ObjectPart part_of(const Token& at, ObjectKind kind, SolidOperation operation,
                   CountedVector<ObjectPart> parts) {
    Object object;
    object.kind = kind;
    object.operation = operation;
    object.at = at;
    if (kind == ObjectKind::group) {
        object.is_merge = true;
        object.stands_for = "lathe";
    }
    object.count = 0;
    for (const ObjectPart& part : parts) object.count += part->count;
    object.depth = kind == ObjectKind::group ? 3 : 2;
    object.parts = make_counted<CountedVector<ObjectPart>>(std::move(parts));
    return make_counted<const Object>(std::move(object));
}

// What is inside of an edge, between its ends. Null: nothing.
ObjectPart inside_of(const Token& at, FlatPoint low, FlatPoint high) {
    if (low.x <= k_on_axis && high.x <= k_on_axis) return nullptr;
    Object object;
    object.kind = ObjectKind::cone;
    object.at = at;
    object.a = {0, low.y, 0};
    object.b = {0, high.y, 0};
    object.r = number::max(low.x, 0.0);
    object.s = number::max(high.x, 0.0);
    return make_counted<const Object>(std::move(object));
}

// Whether all lines are closed or end on the axis.
bool is_closed(const LatheLines& lines) {
    const auto is_on_axis = [](FlatPoint p) { return number::abs(p.x) <= k_on_axis; };
    for (const FlatLoop& loop : lines.loops) {
        const bool is_loop = is_same_point(loop.front(), loop.back());
        if (!is_loop && !(is_on_axis(loop.front()) && is_on_axis(loop.back()))) return false;
    }
    return !lines.loops.empty();
}

void find_solid(const Object& lathe) {
    const LatheLines& lines = *lathe.lathe;
    lines.is_known = true;
    if (!is_closed(lines)) {
        lines.reason = "that is open, in a solid";
        return;
    }
    CountedVector<FlatTrapezoid> trapezoids;
    constexpr std::uint64_t k_most = 10'000'000;
    const auto spend = [&](std::uint64_t n) { return (lines.steps += n) <= k_most; };
    if (!fill_even_odd(lines.loops, spend, trapezoids)) {
        lines.reason = "whose line crosses itself too often, in a solid";
        return;
    }
    CountedVector<ObjectPart> parts;
    for (const FlatTrapezoid& of : trapezoids) {
        const ObjectPart outer = inside_of(lathe.at, of.low_right, of.high_right),
                         inner = inside_of(lathe.at, of.low_left, of.high_left);
        if (!outer) continue;
        parts.push_back(
            inner ? part_of(lathe.at, ObjectKind::solid, SolidOperation::difference, {outer, inner}) : outer);
    }
    if (parts.empty())
        lines.reason = "that encloses nothing, in a solid";
    else
        lines.solid = part_of(lathe.at, ObjectKind::group, SolidOperation::unite, std::move(parts));
}

}  // namespace

void add_lathe_line(const FlatLoop& line, LatheLines& lines) {
    if (line.size() < 2) return;
    const bool goes_on = !lines.loops.empty() &&
                         !is_same_point(lines.loops.back().front(), lines.loops.back().back()) &&
                         is_same_point(lines.loops.back().back(), line.front());
    if (!goes_on) lines.loops.emplace_back();
    FlatLoop& loop = lines.loops.back();
    loop.insert(loop.end(), line.begin() + (goes_on ? 1 : 0), line.end());
}

std::shared_ptr<const Object> solid_lathe(const Object& lathe) {
    if (!lathe.lathe->is_known) find_solid(lathe);
    return lathe.lathe->solid;
}

std::uint64_t count_operands(const Object& object) {
    if (object.lathe) return solid_lathe(object) ? solid_lathe(object)->count : 0;
    if (object.kind != ObjectKind::group && object.kind != ObjectKind::solid) return 1;
    std::uint64_t count = 0;
    for (const ObjectPart& part : *object.parts) count += count_operands(*part);
    return count;
}

std::uint64_t take_lathe_steps(const Object& object) {
    if (object.lathe) return std::exchange(object.lathe->steps, 0);
    if (object.kind != ObjectKind::group && object.kind != ObjectKind::solid) return 0;
    std::uint64_t steps = 0;
    for (const ObjectPart& part : *object.parts) steps += take_lathe_steps(*part);
    return steps;
}

}  // namespace glint::povray
