// SPDX-License-Identifier: Apache-2.0
// Shapes without an area, and cylinders and cones that are as flat as discs.
#include <fmt/format.h>

#include <algorithm>

#include "check/checks.h"
#include "math/number.h"
#include "math/transform.h"
#include "world/camera_projection.h"
#include "world/geometry/primitive_bounds-inl.h"

namespace glint {
namespace {

constexpr double k_no_area = 1e-12;  // twice the area, of the square of the longest edge
constexpr double k_flat = 0.0125;    // height, of the radius: a coin has 0.1, a compact disc 0.02
constexpr double k_thin = 0.5;       // pixels

// Triangles and polygons whose vertices are on one line.
bool has_no_area(std::span<const Vec3> vertices) {
    double longest = 0;
    Vec3 area;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vec3 edge = vertices[i] - vertices[0];
        longest = number::max(longest, length(edge));
    }
    if (!(longest > 0)) return true;
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
        area = area + cross((vertices[i] - vertices[0]) / longest, (vertices[i + 1] - vertices[0]) / longest);
    // A polygon's parts may cancel, but then it has an area all the same.
    bool on_a_line = length(area) <= k_no_area;
    for (std::size_t i = 1; on_a_line && i + 1 < vertices.size(); ++i) {
        on_a_line = length(cross((vertices[i] - vertices[0]) / longest,
                                 (vertices[i + 1] - vertices[0]) / longest)) <= k_no_area;
    }
    return on_a_line;
}

bool has_no_area(const Scene& scene, const Shape& shape) {
    switch (shape.kind) {
        case ShapeKind::triangle:
            return has_no_area(scene.get<Triangle>()[shape.index].vertices);
        case ShapeKind::smooth_triangle:
            return has_no_area(scene.get<SmoothTriangle>()[shape.index].vertices);
        case ShapeKind::polygon: {
            const Polygon& p = scene.get<Polygon>()[shape.index];
            return has_no_area(std::span(scene.polygon_vertices).subspan(p.first, p.count));
        }
        case ShapeKind::box: {
            const Vec3 size = scene.get<Box>()[shape.index].max - scene.get<Box>()[shape.index].min;
            return (size.x == 0) + (size.y == 0) + (size.z == 0) >= 2;
        }
        default:
            return false;
    }
}

struct Axis {
    Vec3 from, to;
    double radius = 0;
};

std::optional<Axis> axis_of(const Scene& scene, std::uint32_t index) {
    const Shape& shape = scene.shapes[index];
    Axis axis;
    if (shape.kind == ShapeKind::cylinder) {
        const Cylinder& c = scene.get<Cylinder>()[shape.index];
        axis = {c.from, c.to, c.radius};
    } else if (shape.kind == ShapeKind::cone) {
        const Cone& c = scene.get<Cone>()[shape.index];
        // A disc with a hole: Tachyon's rings.
        if (!c.caps && c.from_radius != c.to_radius) return std::nullopt;
        axis = {c.from, c.to, number::max(c.from_radius, c.to_radius)};
    } else {
        return std::nullopt;
    }
    if (shape.transform == k_none) return axis;
    const Affine& map = scene.transforms[shape.transform];
    // The radius by the longest of the map's columns: never too small.
    double scale = 0;
    for (const Vec3& unit : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        scale = number::max(scale, length(transform_vector(map, unit)));
    return Axis{transform_point(map, axis.from), transform_point(map, axis.to), axis.radius * scale};
}

// The greatest length in the picture, in pixels, of a vector at this depth.
double pixels_of(const WorldParts& world, Vec3 from, double size) {
    const PreparedCamera& camera = world.camera;
    double depth = 1;
    if (camera.projection == Projection::perspective) {
        depth = CameraProjection(camera).coordinates(from).depth;
        if (depth <= 0) return number::k_infinity;
    }
    return size / depth *
           number::max(world.settings.width / length(camera.right),
                       world.settings.height / length(camera.up));
}

}  // namespace

void check_flat_shapes(CheckContext& context, const VisibleHits& visible, std::vector<bool>& explained) {
    const Scene& scene = context.scene();
    std::vector<std::uint32_t> lines;
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
        if (!has_no_area(scene, scene.shapes[i])) continue;
        lines.push_back(i);
        explained[i] = true;
    }
    if (!lines.empty()) {
        const bool single = lines.size() == 1;
        context.report(
            "shape-without-area", context.at_shape(lines.front()),
            fmt::format("{} of {} {} no area, because {} on one line or in one point, and {} not visible: {}",
                        lines.size(),
                        scene.shapes.size() == 1 ? "1 shape" : fmt::format("{} shapes", scene.shapes.size()),
                        single ? "has" : "have", single ? "its corners are" : "their corners are",
                        single ? "is" : "are", context.some_shapes(lines)),
            "give the corners different places that are not on one line, or remove the shape",
            context.is_model() ? Severity::note : Severity::warning);
    }
    std::vector<bool> seen(scene.shapes.size());
    for (const SurfaceHit& h : visible.seen()) seen[h.shape] = true;
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
        // In a model, those inside others do no harm.
        if (explained[i] || (context.is_model() && !seen[i])) continue;
        const std::optional<Axis> axis = axis_of(scene, i);
        if (!axis) continue;
        const double height = length(axis->to - axis->from);
        if (height > k_flat * axis->radius || pixels_of(context.world(), axis->from, height) > k_thin)
            continue;
        explained[i] = true;
        context.report(
            "shape-too-flat", context.at_shape(i),
            fmt::format("{} is {:.3g} high with a radius of {:.3g}: its side is narrower than a pixel, "
                        "and it looks like a disc",
                        context.shape(i), height, axis->radius),
            "move its two ends apart; if a disc is intended, write a `disc`",
            context.is_model() ? Severity::note : Severity::warning);
    }
}

}  // namespace glint
