// SPDX-License-Identifier: Apache-2.0
// lathe and sphere_sweep, as groups of other shapes: a segment of a lathe's line makes a cone, a cylinder or
// a disc with a hole. A sphere_sweep is the merge of its spheres with the cones that touch two of them from
// outside: the center of the circle where such a cone touches a sphere of radius r is r sin a from the
// sphere's center, and the circle's radius r cos a, where sin a = (r0 - r1) / d, and d the distance of the
// spheres. If it is not below 1, one sphere holds the other one.
#include "formats/povray/object_parser.h"
#include "formats/povray/solid_lathe.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

// Radii that rounding errors leave below 0.
constexpr double k_rounded = 1e-9;

class PartList {
  public:
    explicit PartList(const Token& at) : at_(at) {}

    void add(ObjectKind kind, Vec3 a, Vec3 b, double r, double s, bool is_open) {
        Object part;
        part.kind = kind;
        part.at = at_;
        part.a = a;
        part.b = b;
        part.r = r;
        part.s = s;
        part.is_open = is_open;
        parts_->push_back(make_counted<const Object>(std::move(part)));
    }

    /// They become those of the object.
    void move_to(Object& object) {
        object.count = parts_->size();
        object.depth = 2;
        object.parts = std::move(parts_);
    }

  private:
    Token at_;
    std::shared_ptr<CountedVector<ObjectPart>> parts_ = make_counted<CountedVector<ObjectPart>>();
};

void add_turned_segment(FlatPoint from, FlatPoint to, PartList& parts) {
    const double r = std::max(from.x, 0.0), s = std::max(to.x, 0.0);
    const Vec3 a{0, from.y, 0}, b{0, to.y, 0};
    if (r == 0 && s == 0) return;
    if (from.y == to.y) {
        if (r != s) parts.add(ObjectKind::disc, a, {0, 1, 0}, std::max(r, s), std::min(r, s), false);
    } else {
        parts.add(ObjectKind::cone, a, b, r, s, true);
    }
}

struct SweptSphere {
    Vec3 center;
    double radius = 0;
};

void add_swept_segment(const SweptSphere& from, const SweptSphere& to, PartList& parts) {
    const Vec3 between = to.center - from.center;
    const double distance = length(between);
    if (!(number::abs(from.radius - to.radius) < distance)) return;
    const Vec3 axis = between / distance;
    const double sine = (from.radius - to.radius) / distance, cosine = number::sqrt(1 - sine * sine);
    parts.add(ObjectKind::cone, from.center + axis * (from.radius * sine),
              to.center + axis * (to.radius * sine), from.radius * cosine, to.radius * cosine, false);
}

constexpr std::size_t k_pieces = 64;  // of the curve of four spheres

// The weights of four spheres as polynomials of t from 0 to 1, from t^3 to 1, times 6.
using CurveWeights = signed char[4][4];
constexpr CurveWeights k_b_spline = {{-1, 3, -3, 1}, {3, -6, 0, 4}, {-3, 3, 3, 1}, {1, 0, 0, 0}},
                       k_catmull_rom = {{-3, 6, -3, 0}, {9, -15, 0, 6}, {-9, 12, 3, 0}, {3, -3, 0, 0}};

// Spheres of the curve from the second to the last but one of the given ones. Measured with 64 for each part:
// 0.01% of the pixels of a thick curve differ from POV-Ray's by more than 2.
CountedVector<SweptSphere> spheres_between(const CountedVector<SweptSphere>& given,
                                           const CurveWeights& weights) {
    CountedVector<SweptSphere> all;
    const std::size_t count = (given.size() - 3) * k_pieces;
    for (std::size_t i = 0; i <= count; ++i) {
        const std::size_t first = std::min(i / k_pieces, given.size() - 4);
        const double t = static_cast<double>(i - first * k_pieces) / k_pieces;
        SweptSphere& sphere = all.emplace_back();
        for (std::size_t of = 0; of < 4; ++of) {
            double weight = 0;
            for (const signed char factor : weights[of]) weight = weight * t + factor;
            sphere.center = sphere.center + given[first + of].center * (weight / 6);
            sphere.radius += given[first + of].radius * (weight / 6);
        }
    }
    return all;
}

}  // namespace

// { spline number, points modifiers }
Object ObjectParser::read_lathe(const Token& word) {
    Object object;
    object.at = word;
    object.stands_for = "lathe";
    if (!expect('{')) return object;
    if (begins_declared(peek()) && begins_object(peek())) return read_copy();
    Spline spline = Spline::linear;
    read_spline(object, spline, k_flat_splines);
    if (spline == Spline::refused) return object;
    FlatLoop given;
    read_flat_points(2, spline, given);
    if (failed()) return object;
    PartList parts(word);
    auto lines = make_counted<LatheLines>();
    bool is_below = false;
    // Curves of a bezier spline need not meet.
    const std::size_t step = spline == Spline::bezier ? 4 : given.size();
    for (std::size_t first = 0; first < given.size(); first += step) {
        FlatLoop points;
        add_curve(
            given, first, first + step, spline, [&](std::uint64_t n) { return spend(n); }, points);
        for (std::size_t i = 0; i + 1 < points.size() && !failed(); ++i)
            add_turned_segment(points[i], points[i + 1], parts);
        for (const FlatPoint& p : points) is_below |= p.x < -k_rounded;
        add_lathe_line(points, *lines);
    }
    object.lathe = std::move(lines);
    parts.move_to(object);
    // POV-Ray draws parts of it (measured).
    if (is_below) object.missing.add({"lathe", "with a radius below 0", call_place(word), true});
    read_modifiers(object);
    return object;
}

// { spline number, centers, radii tolerance modifiers }
Object ObjectParser::read_sphere_sweep(const Token& word) {
    Object object;
    object.at = word;
    object.stands_for = "sphere_sweep";
    object.is_merge = true;
    if (!expect('{')) return object;
    if (begins_declared(peek()) && begins_object(peek())) return read_copy();
    Spline spline = Spline::linear;
    read_spline(object, spline, splines(Spline::linear, Spline::cubic, Spline::b_spline));
    if (spline == Spline::refused) return object;
    object.is_curve = spline != Spline::linear;
    accept(',');
    const Token count_at = peek();
    const std::size_t count = read_count();
    if (!failed() && count < (object.is_curve ? 4 : 2))
        error(count_at, object.is_curve ? "expected at least four spheres of a curved sphere_sweep"
                                        : "expected at least two spheres of a sphere_sweep");
    CountedVector<SweptSphere> spheres;
    for (std::size_t i = 0; i < count && !failed(); ++i) {
        SweptSphere& sphere = spheres.emplace_back();
        sphere.center = vector();
        accept(',');
        sphere.radius = number();
        accept(',');
    }
    if (failed()) return object;
    if (object.is_curve) {
        constexpr std::uint64_t bytes = k_pieces * (sizeof(SweptSphere) + 2 * sizeof(Object));
        if (!spend(k_pieces * count) || !has_room(bytes * count, word)) return object;
        spheres = spheres_between(spheres, spline == Spline::cubic ? k_catmull_rom : k_b_spline);
    }
    PartList parts(word);
    bool is_below = false;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        const SweptSphere& sphere = spheres[i];
        is_below |= sphere.radius < 0;
        if (sphere.radius > 0) parts.add(ObjectKind::sphere, sphere.center, {}, sphere.radius, 0, false);
        if (i > 0) add_swept_segment(spheres[i - 1], sphere, parts);
        if (!spend() || (i % 256 == 0 && !is_within_memory(word))) return object;
    }
    if (peek().kind == TokenKind::word && text_of(peek()) == "tolerance") {
        take();
        number();
    }
    parts.move_to(object);
    // POV-Ray draws noise (measured).
    if (is_below) object.missing.add({"sphere_sweep", "with a radius below 0", call_place(word), true});
    read_modifiers(object);
    return object;
}

}  // namespace glint::povray
