// SPDX-License-Identifier: Apache-2.0
// prism: closed lines of points, as a mesh. What was measured of POV-Ray: the lines are as those of `polygon`
// (even_odd.h), and also the sides within others are there; the heights may be in any order; in a conic_sweep
// the points are those at height 1, and the apex is at 0; `open` stands after the points.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/object_parser.h"

namespace glint::povray {
namespace {

// A mesh that grows by the sides and the caps of a prism.
class PrismMesh {
  public:
    PrismMesh(ReadMesh& mesh, bool is_conic) : mesh_(mesh), is_conic_(is_conic) {}

    void add_sides(const FlatLoop& loop, double low, double high) {
        if (is_conic_ && low < 0 && high > 0) {
            add_sides(loop, low, 0);
            return add_sides(loop, 0, high);
        }
        const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
        for (const FlatPoint& p : loop) {
            add(p, low);
            add(p, high);
        }
        const auto count = static_cast<std::uint32_t>(2 * loop.size());
        for (std::uint32_t i = 0; i < count; i += 2) {
            const std::uint32_t a = first + i, b = first + (i + 2) % count;
            // At the apex of a cone, two of the corners are the same.
            const bool is_apex_below = is_conic_ && low == 0, is_apex_above = is_conic_ && high == 0;
            if (!is_apex_below) mesh_.triangles.push_back({a, b, b + 1});
            if (!is_apex_above) mesh_.triangles.push_back({a, b + 1, a + 1});
        }
    }

    void add_cap(const CountedVector<FlatTriangle>& triangles, double height) {
        for (const FlatTriangle& t : triangles)
            mesh_.triangles.push_back({add(t[0], height), add(t[1], height), add(t[2], height)});
    }

  private:
    std::uint32_t add(FlatPoint p, double height) {
        const double scale = is_conic_ ? height : 1;
        return mesh_.add_vertex({p.x * scale, height, p.y * scale});
    }

    ReadMesh& mesh_;
    bool is_conic_;
};

CountedVector<FlatLoop> loops_of(const FlatLoop& points) {
    CountedVector<FlatLoop> loops;
    for_each_loop(
        points,
        [](FlatPoint a, FlatPoint b) { return is_same_coordinate(a.x, b.x) && is_same_coordinate(a.y, b.y); },
        [&](std::size_t first, std::size_t end) {
            const auto begin = points.begin();
            if (end - first >= 2)
                loops.push_back(FlatLoop(begin + static_cast<std::ptrdiff_t>(first),
                                         begin + static_cast<std::ptrdiff_t>(end)));
        });
    return loops;
}

}  // namespace

// The words before the numbers of a prism or lathe. False if the spline is not linear: the object is refused,
// and its block read over.
bool ObjectParser::read_spline(Object& object) {
    const Token word = peek();
    const std::string_view name = word.kind == TokenKind::word ? text_of(word) : "";
    if (name == "linear_spline") {
        take();
        return true;
    }
    for (const std::string_view other :
         {"quadratic_spline", "cubic_spline", "bezier_spline", "b_spline", "natural_spline"}) {
        if (name != other) continue;
        object.kind = ObjectKind::refused;
        object.missing.add({other, object.stands_for, call_place(word), true});
        skip_rest();
        expect('}');
        return false;
    }
    return true;
}

// number, points of two coordinates
void ObjectParser::read_flat_points(std::size_t least, FlatLoop& points) {
    const Token count_at = peek();
    const std::size_t count = read_count();
    if (!failed() && count < least)
        error(count_at, fmt::format("expected at least {} points of a linear spline", least));
    for (std::size_t i = 0; i < count && !failed(); ++i) {
        const Token at = peek();
        const Numbers point = promoted(expression(), 2);
        if (point.terms > 2 && !failed()) error(at, "expected a vector of two numbers");
        points.push_back({point.v[0], point.v[1]});
        if (i + 1 < count) accept(',');
    }
}

// { sweep spline height, height, number, points open modifiers }
Object ObjectParser::read_prism(const Token& word) {
    Object object;
    object.kind = ObjectKind::mesh;
    object.at = word;
    object.stands_for = "prism";
    if (!expect('{')) return object;
    if (begins_declared(peek()) && begins_object(peek())) return read_copy();
    bool is_conic = false;
    for (Token item = peek(); !failed() && item.kind == TokenKind::word; item = peek()) {
        const std::string_view name = text_of(item);
        if (name == "linear_sweep" || name == "conic_sweep") {
            take();
            is_conic = name == "conic_sweep";
            continue;
        }
        if (!read_spline(object)) return object;
        if (name != "linear_spline") break;
    }
    const double first = number();
    accept(',');
    const double second = number();
    accept(',');
    FlatLoop points;
    read_flat_points(3, points);
    const bool is_open = accept(Word::k_open);
    if (failed()) return object;
    const CountedVector<FlatLoop> loops = loops_of(points);
    CountedVector<FlatTriangle> cap;
    const bool is_filled = points.size() <= k_max_loop_points &&
                           (is_open || fill_even_odd(
                                           loops, [&](std::uint64_t n) { return spend(n); }, cap));
    if (failed()) return object;
    auto mesh = make_counted<ReadMesh>();
    if (is_filled) {
        const double low = std::min(first, second), high = std::max(first, second);
        PrismMesh prism(*mesh, is_conic);
        for (const FlatLoop& loop : loops) prism.add_sides(loop, low, high);
        prism.add_cap(cap, low);
        prism.add_cap(cap, high);
    } else {
        object.missing.add({"prism", "with too many points or crossings", call_place(word), true});
    }
    object.mesh = std::move(mesh);
    read_modifiers(object);
    return object;
}

}  // namespace glint::povray
