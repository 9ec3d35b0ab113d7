// SPDX-License-Identifier: Apache-2.0
#include "formats/povray/reach.h"

#include <algorithm>
#include <vector>

#include "glint/solid.h"
#include "math/number.h"
#include "math/quadric_bounds.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

// Planes of an intersection: for more, only the other parts bound it.
constexpr std::size_t k_most_halves = 24;

// How far a disc of radius r around `axis` reaches along d.
double disc_reach(Vec3 axis, double r, Vec3 d) {
    const Vec3 n = normalize(axis);
    return r * length(d - n * dot(d, n));
}

// The points p with dot(normal, p) <= most.
struct HalfSpace {
    Vec3 normal;
    double most;
};

std::optional<HalfSpace> half_space_of(const Scene& scene, const Shape& shape) {
    if (shape.kind != ShapeKind::plane) return std::nullopt;
    const Plane& plane = scene.get<Plane>()[shape.index];
    if (shape.transform == k_none) return HalfSpace{plane.normal, dot(plane.normal, plane.point)};
    const Affine& map = scene.transforms[shape.transform];
    const std::optional<Affine> back = inverse(map);
    if (!back) return std::nullopt;
    const Vec3 normal = transform_normal(*back, plane.normal);
    return HalfSpace{normal, dot(normal, transform_point(map, plane.point))};
}

// The greatest dot(d, p) in all half-spaces: if d is the sum of three normals by numbers from 0 on, the sum
// of their `most` is an upper bound, and the least of these is the greatest dot(d, p) (duality of linear
// programs).
std::optional<double> reach_in(const std::vector<HalfSpace>& halves, Vec3 d) {
    std::optional<double> least;
    for (std::size_t i = 0; i < halves.size(); ++i) {
        for (std::size_t j = i + 1; j < halves.size(); ++j) {
            const Vec3 a = halves[i].normal, b = halves[j].normal, across = cross(a, b);
            for (std::size_t k = j + 1; k < halves.size(); ++k) {
                const Vec3 c = halves[k].normal;
                const double size = dot(across, c);
                if (number::abs(size) < 1e-9 * length(a) * length(b) * length(c)) continue;
                const double of_a = dot(cross(b, c), d) / size, of_b = dot(cross(c, a), d) / size,
                             of_c = dot(across, d) / size;
                const double low = -1e-12 * (number::abs(of_a) + number::abs(of_b) + number::abs(of_c));
                if (of_a < low || of_b < low || of_c < low) continue;
                const double most = of_a * halves[i].most + of_b * halves[j].most + of_c * halves[k].most;
                least = least ? number::min(*least, most) : most;
            }
        }
    }
    return least;
}

// An upper bound: what an operand cuts off from another one counts, too, but for planes.
std::optional<double> solid_reach(const Scene& scene, const SolidTree& tree, Vec3 d) {
    struct Part {
        std::optional<double> reach;    // without a number: endless
        std::vector<HalfSpace> halves;  // which it is in
    };
    std::vector<Part> open;
    auto operand = tree.operands.begin();
    for (const SolidStep& step : tree.steps) {
        if (step.operation == SolidOperation::operand) {
            Part& part = open.emplace_back(Part{reach(scene, *operand, d), {}});
            if (const auto half = half_space_of(scene, *operand)) part.halves.push_back(*half);
            ++operand;
            continue;
        }
        const auto first = open.end() - step.count;
        Part all = std::move(*first);
        std::optional<double>& whole = all.reach;
        switch (step.operation) {
            case SolidOperation::merge:
            case SolidOperation::unite:
                if (step.count > 1) all.halves.clear();
                for (auto part = first + 1; part != open.end(); ++part)
                    whole = whole && part->reach ? std::optional(number::max(*whole, *part->reach))
                                                 : std::nullopt;
                break;
            case SolidOperation::intersection:
                for (auto part = first + 1; part != open.end(); ++part) {
                    if (part->reach) whole = whole ? number::min(*whole, *part->reach) : *part->reach;
                    all.halves.insert(all.halves.end(), part->halves.begin(), part->halves.end());
                }
                if (all.halves.size() <= k_most_halves) {
                    if (const auto most = reach_in(all.halves, d))
                        whole = whole ? number::min(*whole, *most) : *most;
                }
                break;
            case SolidOperation::inverse:
                whole = std::nullopt;
                all.halves.clear();
                break;
            case SolidOperation::difference:
            case SolidOperation::clip:
            case SolidOperation::operand:
                break;
        }
        open.erase(first, open.end());
        open.push_back(std::move(all));
    }
    return open.empty() ? std::nullopt : open.back().reach;
}

// The greatest d·p of the points p of a shape without transform; nothing if there is none.
std::optional<double> own_reach(const Scene& scene, const Shape& shape, Vec3 d) {
    switch (shape.kind) {
        case ShapeKind::sphere: {
            const Sphere& s = scene.get<Sphere>()[shape.index];
            return dot(d, s.center) + s.radius * length(d);
        }
        case ShapeKind::cylinder: {
            const Cylinder& c = scene.get<Cylinder>()[shape.index];
            return std::max(dot(d, c.from), dot(d, c.to)) + disc_reach(c.to - c.from, c.radius, d);
        }
        case ShapeKind::cone: {
            const Cone& c = scene.get<Cone>()[shape.index];
            const Vec3 axis = c.to - c.from;
            return std::max(dot(d, c.from) + disc_reach(axis, c.from_radius, d),
                            dot(d, c.to) + disc_reach(axis, c.to_radius, d));
        }
        case ShapeKind::disc: {
            const Disc& c = scene.get<Disc>()[shape.index];
            return dot(d, c.center) + disc_reach(c.normal, c.radius, d);
        }
        case ShapeKind::torus: {
            const Torus& t = scene.get<Torus>()[shape.index];
            return dot(d, t.center) + disc_reach(t.axis, t.radius, d) + t.tube * length(d);
        }
        case ShapeKind::box: {
            const Box& b = scene.get<Box>()[shape.index];
            return std::max(d.x * b.min.x, d.x * b.max.x) + std::max(d.y * b.min.y, d.y * b.max.y) +
                   std::max(d.z * b.min.z, d.z * b.max.z);
        }
        case ShapeKind::triangle:
        case ShapeKind::smooth_triangle: {
            const Vec3* v = shape.kind == ShapeKind::triangle
                                ? scene.get<Triangle>()[shape.index].vertices
                                : scene.get<SmoothTriangle>()[shape.index].vertices;
            return std::max({dot(d, v[0]), dot(d, v[1]), dot(d, v[2])});
        }
        case ShapeKind::mesh: {
            const MeshData& mesh = *scene.meshes[scene.get<Mesh>()[shape.index].mesh];
            double most = -1e300;
            for (std::uint32_t i = 0; i < mesh.vertex_count(); ++i)
                most = std::max(most, dot(d, mesh.position(i)));
            return most;
        }
        case ShapeKind::polygon: {
            const Polygon& p = scene.get<Polygon>()[shape.index];
            double most = -1e300;
            for (std::uint32_t i = 0; i < p.count; ++i)
                most = std::max(most, dot(d, scene.polygon_vertices[p.first + i]));
            return most;
        }
        case ShapeKind::solid:
            return solid_reach(scene, scene.solids[scene.get<Solid>()[shape.index].solid], d);
        case ShapeKind::quadric: {
            Vec3 lo, hi;
            quadric_bounds(scene.get<Quadric>()[shape.index], lo, hi);
            return std::max(d.x * lo.x, d.x * hi.x) + std::max(d.y * lo.y, d.y * hi.y) +
                   std::max(d.z * lo.z, d.z * hi.z);
        }
        default:
            return std::nullopt;
    }
}

}  // namespace

std::optional<double> reach(const Scene& scene, const Shape& shape, Vec3 d) {
    if (shape.transform == k_none) return own_reach(scene, shape, d);
    const Affine& map = scene.transforms[shape.transform];
    const auto part = [&](Vec3 unit) { return dot(d, transform_vector(map, unit)); };
    const auto far = own_reach(scene, shape, {part({1, 0, 0}), part({0, 1, 0}), part({0, 0, 1})});
    if (!far) return std::nullopt;
    return *far + dot(d, transform_point(map, {0, 0, 0}));
}

bool are_apart(const Scene& scene, const Shape& a, const Shape& b) {
    for (const Vec3 d : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        const auto most_a = reach(scene, a, d), most_b = reach(scene, b, d);
        const auto least_a = reach(scene, a, -d), least_b = reach(scene, b, -d);
        if (!most_a || !most_b || !least_a || !least_b) return false;
        if (*most_a < -*least_b || *most_b < -*least_a) return true;
    }
    return false;
}

void ReachBox::add(const Scene& scene, const Shape& shape) {
    const auto side = [&](Vec3 axis, double& low, double& high) {
        const auto up = reach(scene, shape, axis), down = reach(scene, shape, -axis);
        if (!up || !down) {
            is_unbounded = true;
            return;
        }
        high = std::max(high, *up);
        low = std::min(low, -*down);
    };
    side({1, 0, 0}, least.x, most.x);
    side({0, 1, 0}, least.y, most.y);
    side({0, 0, 1}, least.z, most.z);
}

void ReachBox::add(const ReachBox& box) {
    is_unbounded = is_unbounded || box.is_unbounded;
    const auto widen = [](double Vec3::*axis, const ReachBox& by, ReachBox& all) {
        all.least.*axis = std::min(all.least.*axis, by.least.*axis);
        all.most.*axis = std::max(all.most.*axis, by.most.*axis);
    };
    for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) widen(axis, box, *this);
}

double ReachBox::size() const {
    const Vec3 sides = most - least;
    return std::max({sides.x, sides.y, sides.z});
}

std::uint64_t reach_steps(const Scene& scene, const Shape& shape) {
    if (shape.kind == ShapeKind::solid) {
        std::uint64_t steps = 1, planes = 0;
        for (const Shape& operand : operands_of(scene, shape)) {
            steps += reach_steps(scene, operand);
            planes += operand.kind == ShapeKind::plane ? 1 : 0;
        }
        if (planes <= k_most_halves) steps += planes * planes * planes / 6;
        return steps;
    }
    if (shape.kind != ShapeKind::mesh) return 1;
    return 1 + scene.meshes[scene.get<Mesh>()[shape.index].mesh]->vertex_count();
}

}  // namespace glint::povray
