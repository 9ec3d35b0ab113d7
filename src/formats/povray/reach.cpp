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

// How far a disc of radius r around `axis` reaches along d.
double disc_reach(Vec3 axis, double r, Vec3 d) {
    const Vec3 n = normalize(axis);
    return r * length(d - n * dot(d, n));
}

// An upper bound: what an operand cuts off from another one counts, too.
std::optional<double> solid_reach(const Scene& scene, const SolidTree& tree, Vec3 d) {
    std::vector<std::optional<double>> open;  // without a number: endless
    auto operand = tree.operands.begin();
    for (const SolidStep& step : tree.steps) {
        if (step.operation == SolidOperation::operand) {
            open.push_back(reach(scene, *operand++, d));
            continue;
        }
        const auto first = open.end() - step.count;
        std::optional<double> whole = *first;
        switch (step.operation) {
            case SolidOperation::merge:
            case SolidOperation::unite:
                for (auto part = first; part != open.end(); ++part)
                    whole = whole && *part ? std::optional(number::max(*whole, **part)) : std::nullopt;
                break;
            case SolidOperation::intersection:
                for (auto part = first; part != open.end(); ++part) {
                    if (*part) whole = whole ? number::min(*whole, **part) : **part;
                }
                break;
            case SolidOperation::inverse:
                whole = std::nullopt;
                break;
            case SolidOperation::difference:
            case SolidOperation::clip:
            case SolidOperation::operand:
                break;
        }
        open.erase(first, open.end());
        open.push_back(whole);
    }
    return open.empty() ? std::nullopt : open.back();
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

double ReachBox::size() const {
    const Vec3 sides = most - least;
    return std::max({sides.x, sides.y, sides.z});
}

std::uint64_t reach_steps(const Scene& scene, const Shape& shape) {
    if (shape.kind == ShapeKind::solid) {
        std::uint64_t steps = 1;
        for (const Shape& operand : operands_of(scene, shape)) steps += reach_steps(scene, operand);
        return steps;
    }
    if (shape.kind != ShapeKind::mesh) return 1;
    return 1 + scene.meshes[scene.get<Mesh>()[shape.index].mesh]->vertex_count();
}

}  // namespace glint::povray
