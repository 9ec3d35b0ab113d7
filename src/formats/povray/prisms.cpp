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

// The end of the points of the closed line that begins with points[first]: the first point of its curve, when
// it comes again, ends the curve. A bezier spline's ends where the next curve begins elsewhere.
std::size_t end_of_line(const FlatLoop& points, std::size_t first, Spline spline) {
    if (spline == Spline::bezier) {
        for (first += 4; first < points.size() && is_same_point(points[first], points[first - 1]);)
            first += 4;
        return std::min(first, points.size());
    }
    const std::size_t begin = first + (spline == Spline::linear ? 0 : 1);
    for (std::size_t i = begin + 1; i < points.size(); ++i) {
        if (is_same_point(points[i], points[begin]))
            return std::min(i + (spline == Spline::cubic ? 2 : 1), points.size());
    }
    return points.size();
}

// Empty if a curve is not closed: an error for POV-Ray, or nothing is drawn.
CountedVector<FlatLoop> loops_of(const FlatLoop& points, Spline spline,
                                 const std::function<bool(std::uint64_t)>& spend) {
    CountedVector<FlatLoop> loops;
    for (std::size_t first = 0; first + 1 < points.size();) {
        const std::size_t end = end_of_line(points, first, spline);
        FlatLoop loop;
        add_curve(points, first, end, spline, spend, loop);
        if (loop.size() > 1 && is_same_point(loop.back(), loop.front())) {
            loop.pop_back();
        } else if (spline != Spline::linear) {
            return {};
        }
        // For the normals of trace(): those of bezier splines are on the other side.
        if (spline == Spline::bezier) std::reverse(loop.begin(), loop.end());
        if (loop.size() >= 2) loops.push_back(std::move(loop));
        first = end;
    }
    return loops;
}

}  // namespace

// The words before the numbers of a prism or lathe. If the spline is refused, so is the object, and its block
// is read over.
bool ObjectParser::read_spline(Object& object, Spline& spline, unsigned allowed) {
    static constexpr std::string_view k_names[] = {"linear_spline", "quadratic_spline", "cubic_spline",
                                                   "bezier_spline", "b_spline",         "natural_spline"};
    const Token word = peek();
    if (word.kind != TokenKind::word) return false;
    const auto* const name = std::find(std::begin(k_names), std::end(k_names), text_of(word));
    if (name == std::end(k_names)) return false;
    const auto number = static_cast<std::size_t>(name - k_names);
    spline = Spline::refused;
    if ((allowed >> number & 1) != 0) {
        take();
        spline = static_cast<Spline>(number);
        return true;
    }
    object.kind = ObjectKind::refused;
    object.missing.add({*name, object.stands_for, call_place(word), true});
    skip_rest();
    expect('}');
    return false;
}

// number, points of two coordinates
void ObjectParser::read_flat_points(std::size_t least, Spline spline, FlatLoop& points) {
    static constexpr std::string_view k_kinds[] = {"linear", "quadratic", "cubic", "bezier"};
    if (spline != Spline::linear) least = spline == Spline::quadratic ? 3 : 4;
    const Token count_at = peek();
    const std::size_t count = read_count();
    if (!failed() && count < least)
        error(count_at, fmt::format("expected at least {} points of a {} spline", least,
                                    k_kinds[static_cast<std::size_t>(spline)]));
    if (!failed() && spline == Spline::bezier && count % 4 != 0)
        error(count_at, "expected four points for each curve of a bezier spline");
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
    Spline spline = Spline::linear;
    for (Token item = peek(); !failed() && item.kind == TokenKind::word; item = peek()) {
        const std::string_view name = text_of(item);
        if (name == "linear_sweep" || name == "conic_sweep") {
            take();
            is_conic = name == "conic_sweep";
            continue;
        }
        if (!read_spline(object, spline, k_flat_splines)) break;
    }
    if (spline == Spline::refused) return object;
    const double first = number();
    accept(',');
    const double second = number();
    accept(',');
    FlatLoop points;
    read_flat_points(3, spline, points);
    const bool is_open = accept(Word::k_open);
    if (failed()) return object;
    const auto spend_on = [&](std::uint64_t n) { return spend(n); };
    CountedVector<FlatLoop> loops;
    CountedVector<FlatTriangle> cap;
    bool is_filled = points.size() <= k_max_loop_points;
    if (is_filled) {
        loops = loops_of(points, spline, spend_on);
        if (loops.empty() && spline != Spline::linear && !failed())
            object.missing.add({"prism", "whose curve is not closed", call_place(word), true});
        is_filled = is_open || fill_even_odd(loops, spend_on, cap);
    }
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
