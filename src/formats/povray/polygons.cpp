// SPDX-License-Identifier: Apache-2.0
// polygon: closed lists of points in a plane. What was measured of POV-Ray: the first point, when it comes
// again, ends a part, and the next point begins another one; a part that is not closed is closed; points
// count that are in the plane within about 3e-10, else nothing is drawn; inside is what an odd number of
// edges surrounds.
#include <algorithm>

#include "formats/povray/object_parser.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::povray {

// A closed line of points. Each point but the last is followed by another one.
struct Outline {
    CountedVector<Vec3> points;
    FlatLoop flat;
    FlatPoint low{1e300, 1e300}, high{-1e300, -1e300};
};

namespace {

constexpr double k_flat = 3e-10;

// The normal of the points' plane, of any length; 0 if all are on a line.
Vec3 normal_of(const CountedVector<Vec3>& points) {
    const Vec3 first = points.front();
    Vec3 along{0, 0, 0};
    for (const Vec3& p : points) {
        if (is_zero(along)) along = p - first;
        const Vec3 n = cross(along, p - first);
        const double size = length(along) * length(p - first);
        if (length(n) > 1e-12 * size) return n;
    }
    return {0, 0, 0};
}

// A point in the coordinate plane in which the polygon is largest.
FlatPoint projected(Vec3 p, Vec3 normal) {
    const double x = number::abs(normal.x), y = number::abs(normal.y), z = number::abs(normal.z);
    if (z >= x && z >= y) return {p.x, p.y};
    return x >= y ? FlatPoint{p.y, p.z} : FlatPoint{p.z, p.x};
}

// The point of the plane through `first` that is projected to p.
Vec3 lifted(FlatPoint p, Vec3 normal, Vec3 first) {
    const FlatPoint from = projected(first, normal), n = projected(normal, normal);
    const double third = -(n.x * (p.x - from.x) + n.y * (p.y - from.y));
    const double x = number::abs(normal.x), y = number::abs(normal.y), z = number::abs(normal.z);
    if (z >= x && z >= y) return {p.x, p.y, first.z + third / normal.z};
    if (x >= y) return {first.x + third / normal.x, p.x, p.y};
    return {p.y, first.y + third / normal.y, p.x};
}

std::vector<Outline> outlines_of(const CountedVector<Vec3>& points, Vec3 normal) {
    std::vector<Outline> out;
    const auto is_same = [](Vec3 a, Vec3 b) {
        return is_same_coordinate(a.x, b.x) && is_same_coordinate(a.y, b.y) && is_same_coordinate(a.z, b.z);
    };
    for_each_loop(points, is_same, [&](std::size_t first, std::size_t end) {
        Outline outline;
        for (std::size_t i = first; i < end; ++i) {
            if (!outline.points.empty() && outline.points.back() == points[i]) continue;
            outline.points.push_back(points[i]);
            const FlatPoint p = outline.flat.emplace_back(projected(points[i], normal));
            outline.low = {std::min(outline.low.x, p.x), std::min(outline.low.y, p.y)};
            outline.high = {std::max(outline.high.x, p.x), std::max(outline.high.y, p.y)};
        }
        if (outline.points.size() >= 3) out.push_back(std::move(outline));
    });
    return out;
}

double area(FlatPoint a, FlatPoint b, FlatPoint c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Whether two edges without a common end have a common point.
bool meet(FlatPoint a, FlatPoint b, FlatPoint c, FlatPoint d) {
    const auto apart = [](double p, double q, double r, double s) {
        return std::max(p, q) < std::min(r, s) || std::max(r, s) < std::min(p, q);
    };
    if (apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y)) return false;
    const double abc = area(a, b, c), abd = area(a, b, d), cda = area(c, d, a), cdb = area(c, d, b);
    return !(abc > 0 && abd > 0) && !(abc < 0 && abd < 0) && !(cda > 0 && cdb > 0) && !(cda < 0 && cdb < 0);
}

// Whether an outline goes once around, always to the same side: the most frequent ones do.
bool is_convex(const FlatLoop& p) {
    const std::size_t n = p.size();
    int left = 0, right = 0, turns = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const FlatPoint a = p[i], b = p[(i + 1) % n], c = p[(i + 2) % n];
        const double turn = area(a, b, c);
        left += turn > 0;
        right += turn < 0;
        if (turn == 0 && (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < 0) return false;
        // Where the edges' direction changes from left to right.
        turns += (b.x - a.x < 0) && !(c.x - b.x < 0);
    }
    return (left == 0 || right == 0) && turns <= 1;
}

bool is_simple(const FlatLoop& p) {
    if (is_convex(p)) return true;
    const std::size_t n = p.size();
    for (std::size_t i = 0; i < n; ++i) {
        const FlatPoint a = p[i], b = p[(i + 1) % n], c = p[(i + 2) % n];
        if (area(a, b, c) == 0 && (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < 0) return false;
        for (std::size_t k = i + 2; k < n; ++k) {
            if ((k + 1) % n != i && meet(a, b, p[k], p[(k + 1) % n])) return false;
        }
    }
    return true;
}

bool are_apart(const Outline& a, const Outline& b) {
    return a.high.x < b.low.x || b.high.x < a.low.x || a.high.y < b.low.y || b.high.y < a.low.y;
}

}  // namespace

// { number, points modifiers }
Object ObjectParser::read_polygon(const Token& word) {
    Object object;
    object.kind = ObjectKind::polygon;
    object.at = word;
    if (!expect('{')) return object;
    if (begins_declared(peek()) && begins_object(peek())) return read_copy();
    const Token count_at = peek();
    const std::size_t count = read_count();
    if (!failed() && count < 3) error(count_at, "expected at least three points of a polygon");
    CountedVector<Vec3> points;
    for (std::size_t i = 0; i < count && !failed(); ++i) {
        points.push_back(vector());
        accept(',');
    }
    if (failed()) return object;
    take_outlines(points, object);
    read_modifiers(object);
    return object;
}

// Makes the object a mesh of what is inside of an odd number of outlines. False if they cross too often.
bool ObjectParser::fill_outlines(const std::vector<Outline>& outlines, Vec3 normal, Vec3 first,
                                 Object& object) {
    CountedVector<FlatLoop> loops;
    loops.reserve(outlines.size());
    for (const Outline& outline : outlines) loops.push_back(outline.flat);
    CountedVector<FlatTriangle> triangles;
    if (!fill_even_odd(
            loops, [&](std::uint64_t n) { return spend(n); }, triangles))
        return false;
    auto mesh = make_counted<ReadMesh>();
    mesh->triangles.reserve(triangles.size());
    mesh->vertices.reserve(3 * triangles.size());
    const auto add = [&](FlatPoint p) { return mesh->add_vertex(lifted(p, normal, first)); };
    for (const FlatTriangle& t : triangles) mesh->triangles.push_back({add(t[0]), add(t[1]), add(t[2])});
    object.kind = ObjectKind::mesh;
    object.stands_for = "polygon";
    object.count = 1;
    object.parts = nullptr;
    object.mesh = std::move(mesh);
    return true;
}

// Makes the object a polygon, a group of several, or a mesh if there are holes.
void ObjectParser::take_outlines(const CountedVector<Vec3>& points, Object& object) {
    const auto refuse = [&](std::string_view why) {
        object.missing.add({"polygon", why, call_place(object.at), true});
    };
    auto parts = make_counted<CountedVector<ObjectPart>>();
    const Vec3 normal = normal_of(points);
    object.kind = ObjectKind::group;
    object.count = 0;
    object.parts = parts;
    if (is_zero(normal)) return;  // POV-Ray draws nothing
    const Vec3 unit = normalize(normal);
    for (const Vec3& p : points) {
        if (number::abs(dot(unit, p - points.front())) <= k_flat) continue;
        return warn_once("polygon not flat", object.at,
                         "the points of this polygon are not in one plane: as in POV-Ray, it is left out");
    }
    std::vector<Outline> outlines = outlines_of(points, normal);
    bool are_simple = true;  // each is a Polygon, without holes
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        if (!spend(outlines[i].flat.size() * outlines[i].flat.size() / 64 + i / 8)) return;
        if (outlines[i].points.size() > k_max_polygon_vertices) return refuse("with more than 4096 points");
        are_simple = are_simple && is_simple(outlines[i].flat);
        for (std::size_t k = 0; k < i && are_simple; ++k) are_simple = are_apart(outlines[i], outlines[k]);
    }
    if (!are_simple) {
        if (!fill_outlines(outlines, normal, points.front(), object) && !failed())
            refuse("whose edges cross too often");
        return;
    }
    parts->reserve(outlines.size());
    for (Outline& outline : outlines) {
        Object part;
        part.kind = ObjectKind::polygon;
        part.at = object.at;
        part.outline = make_counted<CountedVector<Vec3>>(std::move(outline.points));
        if (outlines.size() == 1) {
            object = std::move(part);
            return;
        }
        parts->push_back(make_counted<const Object>(std::move(part)));
        ++object.count;
    }
    object.depth = 2;
}

}  // namespace glint::povray
