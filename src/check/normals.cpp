// SPDX-License-Identifier: Apache-2.0
// Surfaces that are seen from behind where the conventions do not turn normals, and vertex normals against
// their triangle's winding.
#include <fmt/format.h>

#include <algorithm>

#include "check/checks.h"
#include "math/transform.h"

namespace glint {
namespace {

constexpr double k_few = 0.01;  // of the smooth triangles of a model

// Of the pixels in which a surface is seen, those in which it is seen from behind.
struct Views {
    std::size_t front = 0, behind = 0;
    bool mostly_behind() const { return behind > 9 * front && behind > 0; }
};

// Shapes that enclose a space are not sheets: their insides are dark on purpose.
bool is_sheet(ShapeKind kind) {
    return kind == ShapeKind::plane || kind == ShapeKind::disc || kind == ShapeKind::triangle ||
           kind == ShapeKind::smooth_triangle || kind == ShapeKind::polygon;
}

void check_backs(CheckContext& context, const VisibleHits& visible) {
    const Scene& scene = context.scene();
    const Shading shading = scene.settings.shading;
    if (shading == Shading::color || shading == Shading::normals || context.world().lights->empty()) return;
    std::vector<Views> views(scene.shapes.size());
    for (const SurfaceHit& h : visible.seen()) {
        if (flips_normal(context.world(), h.surface) || !is_sheet(scene.shapes[h.shape].kind)) continue;
        // A surface without a diffuse term looks the same from both sides, except for its highlights.
        if (brightest(context.material_of(h.shape).diffuse) <= 0) continue;
        ++(h.behind ? views[h.shape].behind : views[h.shape].front);
    }
    std::vector<std::uint32_t> backs;
    std::size_t pixels = 0, fronts = 0;
    for (std::uint32_t i = 0; i < views.size(); ++i) {
        fronts += views[i].front > 0 ? 1 : 0;
        if (!views[i].mostly_behind()) continue;
        backs.push_back(i);
        pixels += views[i].behind;
    }
    if (backs.empty()) return;
    context.report(
        "seen-from-behind", context.at_shape(backs.front()),
        fmt::format(
            "{} {} seen from behind, in {} of the picture, where the lights on the viewer's side have "
            "no effect: these conventions do not turn a normal towards the viewer{}",
            context.some_shapes(backs), backs.size() == 1 ? "is" : "are",
            percent_text(static_cast<double>(pixels) / static_cast<double>(visible.rays())),
            fronts == 0   ? ""
            : fronts == 1 ? "; another flat shape is seen from the front"
                          : fmt::format("; {} other flat shapes are seen from the front", fronts)),
        "reverse the normal, or the order of the vertices: from the front they are counter-clockwise");
}

void check_vertex_normals(CheckContext& context) {
    const Scene& scene = context.scene();
    std::vector<std::uint32_t> against, mixed;
    std::size_t smooth = 0;
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
        const Shape& shape = scene.shapes[i];
        if (shape.kind != ShapeKind::smooth_triangle) continue;
        ++smooth;
        // As written in the file: a transform that mirrors would reverse the winding, but not the normals.
        const SmoothTriangle& t = scene.get<SmoothTriangle>()[shape.index];
        const Vec3 face = cross(t.vertices[1] - t.vertices[0], t.vertices[2] - t.vertices[0]);
        const auto backward = std::count_if(std::begin(t.normals), std::end(t.normals),
                                            [&](Vec3 n) { return dot(n, face) < 0; });
        if (backward == 3) against.push_back(i);
        if (backward == 1 || backward == 2) mixed.push_back(i);
    }
    // The programs that export surfaces make a few such triangles of thousands.
    const auto severity = [&](const std::vector<std::uint32_t>& list) {
        const bool few =
            context.is_model() && static_cast<double>(list.size()) < k_few * static_cast<double>(smooth);
        return few ? Severity::note : Severity::warning;
    };
    if (!against.empty()) {
        context.report(
            "normals-against-winding", context.at_shape(against.front()),
            fmt::format("the vertex normals of {} of {} smooth triangles point to the side from which their "
                        "vertices are clockwise: {}",
                        against.size(), smooth, context.some_shapes(against)),
            "reverse the normals, or the order of the vertices", severity(against));
    }
    if (!mixed.empty()) {
        context.report(
            "normals-on-both-sides", context.at_shape(mixed.front()),
            fmt::format("the vertex normals of {} of {} smooth triangles point to different sides of "
                        "them: {}",
                        mixed.size(), smooth, context.some_shapes(mixed)),
            "make the three normals of a triangle point to one side of it", severity(mixed));
    }
}

}  // namespace

void check_normals(CheckContext& context, const VisibleHits& visible) {
    check_backs(context, visible);
    check_vertex_normals(context);
}

}  // namespace glint
