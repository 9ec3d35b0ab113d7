// SPDX-License-Identifier: Apache-2.0
// The camera: inside a shape, mirrored, or where it sees nothing.
#include <fmt/format.h>

#include <algorithm>

#include "check/checks.h"
#include "math/number.h"
#include "math/transform.h"
#include "scene/handedness.h"
#include "scene/settings.h"
#include "world/geometry/primitive_bounds-inl.h"

namespace glint {
namespace {

// A plane cuts a shape if it is nearer to its centre than this part of its extent: one that only touches it,
// as the floor below a ball, does not.
constexpr double k_inner_part = 1 - 1e-6;
// The cosine of the angle within which a camera points at a place, and the part of the shapes' extent within
// which it stands there.
constexpr double k_aimed = 0.999, k_same_place = 1e-3;

bool contains(const Bounds& outer, const Bounds& inner) {
    return outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && outer.min.z <= inner.min.z &&
           outer.max.x >= inner.max.x && outer.max.y >= inner.max.y && outer.max.z >= inner.max.z;
}

bool cuts(Vec3 point, Vec3 normal, const Bounds& box) {
    const Vec3 half = (box.max - box.min) * 0.5, way = box.min + half - point;
    const double reach =
        number::abs(normal.x) * half.x + number::abs(normal.y) * half.y + number::abs(normal.z) * half.z;
    return number::abs(dot(way, normal)) < k_inner_part * reach;
}

// A sky, or a room: it holds other shapes too, or a plane goes through it.
bool is_enclosure(const WorldParts& world, std::uint32_t shape) {
    std::uint32_t own = 0;
    while (own < world.geometry->bounded && world.geometry->shape_index[own] != shape) ++own;
    if (own == world.geometry->bounded) return false;
    const Bounds enclosure = to_bounds(HWY_NAMESPACE::primitive_bounds(*world.geometry, own));
    for (std::uint32_t slot = 0; slot < world.geometry->bounded; ++slot)
        if (slot != own &&
            contains(enclosure, to_bounds(HWY_NAMESPACE::primitive_bounds(*world.geometry, slot))))
            return true;
    for (std::uint32_t slot = world.geometry->bounded; slot < world.geometry->first_operand(); ++slot) {
        const ShapeClass& planes = world.geometry->class_of(slot);
        const auto value = [&](int k) { return planes.value(k, slot); };
        if (cuts({value(0), value(1), value(2)}, {value(3), value(4), value(5)}, enclosure)) return true;
    }
    return false;
}

// A clipped solid is a surface only, and one without the light of any light is a backdrop.
bool is_surface_only(const CheckContext& context, std::uint32_t shape) {
    const Scene& scene = context.scene();
    if (const Shape& of = scene.shapes[shape]; of.kind == ShapeKind::solid) {
        const SolidTree& tree = scene.solids[scene.get<Solid>()[of.index].solid];
        if (tree.steps.back().operation == SolidOperation::clip) return true;
    }
    const Material& material = context.material_of(shape);
    return is_black(material.diffuse) && is_black(material.specular) && is_black(material.phong) &&
           material.mirror == 0 && material.transmission == 0 && !material.is_transparent();
}

void check_inside(CheckContext& context, const VisibleHits& visible) {
    const Scene& scene = context.scene();
    const std::vector<bool> hit = visible.hit_shapes(scene);
    for (const std::uint32_t shape : shapes_around(context, scene.camera.position)) {
        if (is_enclosure(context.world(), shape) || is_surface_only(context, shape) ||
            (visible.is_passed(shape) && !hit[shape]))
            continue;
        context.report("camera-inside-shape", context.at_camera(),
                       fmt::format("the camera at {} is inside {}: the picture shows the inside of the shape",
                                   vector_text(scene.camera.position), context.shape_and_line(shape)),
                       "move the camera out of the shape, or make the shape smaller");
    }
}

Handedness handedness_of(const Scene& scene) {
    const auto all = profiles();
    const auto profile =
        std::find_if(all.begin(), all.end(), [&](const Profile& p) { return p.name == scene.profile; });
    return profile == all.end() ? Handedness::right : profile->handedness;
}

void check_handedness(CheckContext& context) {
    const Scene& scene = context.scene();
    const Handedness expected = handedness_of(scene);
    if (!scene.camera.frame || expected == Handedness::either) return;
    const auto& [right, up, forward] = *scene.camera.frame;
    const bool is_left = dot(cross(right, up), forward) > 0;
    if (is_left == (expected == Handedness::left)) return;
    if (expected == Handedness::right_unless_povray && !is_reversed_in_povray(*scene.camera.frame)) return;
    context.report(
        "camera-mirrored", context.at_camera(),
        fmt::format("the camera's right, up and forward are {}-handed, but the scenes of {} are {}-handed: "
                    "left and right are exchanged in the picture",
                    is_left ? "left" : "right", scene.profile, is_left ? "right" : "left"),
        "negate the camera's right vector");
}

// What to do about a camera that looks at the middle of the shapes and sees none of them. along: its
// distance.
std::string remedy_of_unseen(const CheckContext& context, const Bounds& all, double along, bool planes) {
    const Camera& camera = context.scene().camera;
    const WorldParts& world = context.world();
    if (planes) return "move the camera to the shapes' side of the planes, or the planes out of its way";
    const double extent = length(all.max - all.min);
    if (camera.projection == Projection::orthographic)
        return fmt::format("make the view wider: the shapes extend over {:.4g}", extent);
    if (const double least = context.scene().conventions.camera_t_min; along - extent / 2 < least)
        return "move the camera back: what is nearer to it than the least t of camera rays is not seen";
    const double pixel = along * length(world.camera.right) / length(world.camera.forward) /
                         static_cast<double>(world.settings.width);
    if (extent < pixel)
        return fmt::format(
            "move the camera nearer, or narrow its angle: the shapes extend over {:.4g}, and a "
            "pixel there over {:.4g}",
            extent, pixel);
    return "look at a shape: there is none in the middle of all";
}

}  // namespace

bool check_camera(CheckContext& context, const VisibleHits& visible) {
    check_handedness(context);
    if (context.scene().camera.projection == Projection::perspective) check_inside(context, visible);
    const WorldParts& world = context.world();
    if (world.geometry->count == 0) return false;
    bool planes = false;
    for (const std::vector<SurfaceHit>& hits : visible.generations) {
        for (const SurfaceHit& h : hits) {
            if (world.geometry->is_bounded(h.surface)) return true;
            planes = true;
        }
    }
    if (world.geometry->bounded == 0 && planes) return true;
    // It looks at shapes where they have holes: check_holes() says so.
    for (std::uint32_t i = 0; i < context.scene().shapes.size(); ++i) {
        const bool is_plane = context.scene().shapes[i].kind == ShapeKind::plane;
        if (visible.is_passed(i) && (!is_plane || world.geometry->bounded == 0)) return planes;
    }
    const FindingPlace place = context.at_camera();
    if (world.geometry->bounded == 0) {
        context.report("camera-sees-nothing", place,
                       "the camera looks away from every plane of the scene: the picture is only background",
                       "turn the camera towards a plane");
        return false;
    }
    const Bounds all = scene_bounds(context.prepared());
    if (!(all.min.x <= all.max.x)) {
        context.report("camera-sees-nothing", place, "the camera sees none of the scene's shapes",
                       "turn the camera towards a shape");
        return false;
    }
    const Vec3 middle = (all.min + all.max) * 0.5, way = middle - world.camera.position;
    const double along = dot(way, normalize(world.camera.forward));
    const bool away = along <= 0;
    if (length(way) <= k_same_place * length(all.max - all.min)) {
        context.report("camera-sees-nothing", place,
                       fmt::format("the camera sees none of the scene's shapes{}: it stands in the middle of "
                                   "them, at {}, and looks along {}",
                                   planes ? " but planes" : "", vector_text(world.camera.position),
                                   vector_text(normalize(world.camera.forward))),
                       "move the camera away from the shapes, and point it at them");
        return false;
    }
    const bool is_aimed = along > k_aimed * length(way);
    context.report(
        "camera-sees-nothing", place,
        fmt::format(
            "the camera sees none of the scene's shapes{}: it looks along {} from {}; the centre of the "
            "shapes, {}, is {}",
            planes ? " but planes" : "", vector_text(normalize(world.camera.forward)),
            vector_text(world.camera.position), vector_text(middle),
            away ? "behind it" : fmt::format("{:.4g} in front of it", along)),
        is_aimed ? remedy_of_unseen(context, all, along, planes)
                 : fmt::format("point the camera at {}{}", vector_text(middle),
                               planes && !away ? ", and check that no plane hides the shapes" : ""));
    return false;
}

}  // namespace glint
