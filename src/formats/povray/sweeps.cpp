// SPDX-License-Identifier: Apache-2.0
// lathe and sphere_sweep, as groups of other shapes: a segment of a lathe's line makes a cone, a cylinder or
// a disc with a hole. A sphere_sweep is the merge of its spheres with the cones that touch two of them from
// outside: the center of the circle where such a cone touches a sphere of radius r is r sin a from the
// sphere's center, and the circle's radius r cos a, where sin a = (r0 - r1) / d, and d the distance of the
// spheres. If it is not below 1, one sphere holds the other one.
#include <fmt/format.h>

#include "formats/povray/object_parser.h"
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

constexpr int k_pieces = 64;  // of the curve of four spheres

// Spheres of the curve of a cubic_spline (Catmull and Rom's) or b_spline through or near the given ones, from
// the second to the last but one. Measured with 64 of each four: 0.01% of the pixels of a thick curve differ
// from POV-Ray's by more than 2.
CountedVector<SweptSphere> spheres_between(const CountedVector<SweptSphere>& given, bool is_b_spline) {
    CountedVector<SweptSphere> all;
    for (std::size_t i = 0; i + 3 < given.size(); ++i) {
        for (int k = 0; k <= k_pieces; ++k) {
            if (k == k_pieces && i + 4 < given.size()) break;  // the first one of the next four
            const double t = static_cast<double>(k) / k_pieces, u = 1 - t;
            const double uniform[] = {u * u * u / 6, (3 * t - 6) * t * t / 6 + 4.0 / 6,
                                      (3 * u - 6) * u * u / 6 + 4.0 / 6, t * t * t / 6};
            const double through[] = {-t * u * u / 2, ((3 * t - 5) * t * t + 2) / 2,
                                      ((3 * u - 5) * u * u + 2) / 2, -u * t * t / 2};
            SweptSphere sphere;
            for (std::size_t of = 0; of < 4; ++of) {
                const double weight = is_b_spline ? uniform[of] : through[of];
                sphere.center = sphere.center + given[i + of].center * weight;
                sphere.radius += given[i + of].radius * weight;
            }
            all.push_back(sphere);
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
    read_spline(object, spline, 4);
    if (spline == Spline::refused) return object;
    FlatLoop given;
    read_flat_points(2, spline, given);
    if (failed()) return object;
    PartList parts(word);
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
    }
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
    const Token kind = peek();
    const std::string_view name = kind.kind == TokenKind::word ? text_of(kind) : std::string_view();
    const bool is_curve = name == "b_spline" || name == "cubic_spline";
    Spline spline = Spline::linear;
    if (is_curve) {
        take();
        object.is_curve = true;
    } else {
        read_spline(object, spline, 1);
    }
    if (spline == Spline::refused) return object;
    accept(',');
    const Token count_at = peek();
    const std::size_t count = read_count(), least = is_curve ? 4 : 2;
    if (!failed() && count < least)
        error(count_at,
              fmt::format("expected at least {} spheres of a sphere_sweep", is_curve ? "four" : "two"));
    CountedVector<SweptSphere> spheres;
    for (std::size_t i = 0; i < count && !failed(); ++i) {
        SweptSphere& sphere = spheres.emplace_back();
        sphere.center = vector();
        accept(',');
        sphere.radius = number();
        accept(',');
    }
    if (failed()) return object;
    if (is_curve) {
        constexpr std::uint64_t bytes = k_pieces * (sizeof(SweptSphere) + 2 * sizeof(Object));
        if (!spend(k_pieces * spheres.size()) || !has_room(bytes * spheres.size(), word)) return object;
        spheres = spheres_between(spheres, name == "b_spline");
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
