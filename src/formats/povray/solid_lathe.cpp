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
    object.depth = 2;
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

std::shared_ptr<const Object> merged(const Object& lathe) {
    CountedVector<FlatTrapezoid> trapezoids;
    std::uint64_t steps = 0;
    constexpr std::uint64_t k_most = 10'000'000;
    const auto spend = [&](std::uint64_t n) { return (steps += n) <= k_most; };
    if (!fill_even_odd(lathe.lathe->loops, spend, trapezoids)) return nullptr;
    CountedVector<ObjectPart> parts;
    for (const FlatTrapezoid& of : trapezoids) {
        const ObjectPart outer = inside_of(lathe.at, of.low_right, of.high_right),
                         inner = inside_of(lathe.at, of.low_left, of.high_left);
        if (!outer) continue;
        parts.push_back(
            inner ? part_of(lathe.at, ObjectKind::solid, SolidOperation::difference, {outer, inner}) : outer);
    }
    if (parts.empty() || parts.size() > k_max_solid_operands / 2) return nullptr;
    return part_of(lathe.at, ObjectKind::group, SolidOperation::unite, std::move(parts));
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

bool is_closed_lathe(const LatheLines& lines) {
    const auto is_on_axis = [](FlatPoint p) { return number::abs(p.x) <= k_on_axis; };
    for (const FlatLoop& loop : lines.loops) {
        const bool is_closed = is_same_point(loop.front(), loop.back());
        if (!is_closed && !(is_on_axis(loop.front()) && is_on_axis(loop.back()))) return false;
    }
    return !lines.loops.empty();
}

std::shared_ptr<const Object> solid_lathe(const Object& lathe) {
    const LatheLines& lines = *lathe.lathe;
    if (!lines.is_known) {
        lines.is_known = true;
        if (is_closed_lathe(lines)) lines.solid = merged(lathe);
    }
    return lines.solid;
}

}  // namespace glint::povray
