// SPDX-License-Identifier: Apache-2.0
// Shapes that are not visible: neither directly, nor in the first mirrors, nor by their shadows.
#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "check/checks.h"
#include "math/extent.h"
#include "math/number.h"
#include "trace/rays/camera_rays-inl.h"
#include "world/camera_projection.h"
#include "world/geometry/primitive_bounds-inl.h"

namespace glint {
namespace {

constexpr std::size_t k_max_lights = 16;
constexpr double k_speck = 16;         // pixels a side; a model that is smaller is too small
constexpr double k_near_corner = 0.9;  // of the way from the middle of a box to its corner
constexpr std::size_t k_max_enclosed = 8;
constexpr std::size_t k_max_points = 20000;  // of a generation, whose shadow rays are traced

// Marks the shapes that cast a shadow on visible points: those that shadow rays hit first.
void mark_shadows(const CheckContext& context, const VisibleHits& visible, std::vector<bool>& seen) {
    const WorldParts& world = context.world();
    if (!world.settings.shadows) return;
    for (std::size_t l = 0; l < world.lights->size() && l < k_max_lights; ++l) {
        const ShadowRays shadows = shadow_rays(world, visible, (*world.lights)[l], k_max_points);
        for (const SurfaceId id : nearest_occluders(world, shadows.rays, context.threads()).surface)
            if (id.exists()) seen[world.geometry->shape_of(id)] = true;
    }
}

// Marks the bodies of lights: shapes that a format makes of a light (Tachyon).
void mark_bodies_of_lights(const Scene& scene, std::vector<bool>& seen) {
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> of_lights;
    const auto key = [](SourcePlace p) {
        return std::tuple{std::uint32_t{p.file}, p.line, std::uint32_t{p.column}};
    };
    for (const SourcePlace& p : scene.light_texts.places)
        if (p.line != 0) of_lights.insert(key(p));
    if (of_lights.empty()) return;
    for (std::uint32_t i = 0; i < seen.size(); ++i)
        if (of_lights.contains(key(scene.shape_texts.place(i)))) seen[i] = true;
}

Vec3 corner_of(const Bounds& box, int corner) {
    return {corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
            corner & 4 ? box.max.z : box.min.z};
}

// The position of shapes in the picture.
class Frame {
  public:
    Frame(const PreparedCamera& camera, const RenderSettings& settings)
        : camera_(camera), projection_(camera), width_(settings.width), height_(settings.height) {}

    enum class Place : std::uint8_t { not_rendered, outside, tiny, inside };
    Place place_of(const Bounds& box) const {
        int out[5] = {};
        for (int corner = 0; corner < 8; ++corner) {
            const auto [x, y, depth] = projection_.coordinates(corner_of(box, corner));
            const bool flat = camera_.projection == Projection::orthographic;
            const double half = flat ? 0.5 : depth / 2;
            out[0] += depth <= 0;
            out[1] += x > half, out[2] += x < -half;
            out[3] += y > half, out[4] += y < -half;
        }
        if (std::find(std::begin(out), std::end(out), 8) != std::end(out)) return Place::outside;
        return is_within(box, 1) ? Place::tiny : Place::inside;
    }

    /// Whether the box is in front of the camera and smaller than a square of so many pixels.
    bool is_within(const Bounds& box, double side) const {
        Extent pixels;
        for (int corner = 0; corner < 8; ++corner) {
            const auto [x, y, depth] = projection_.coordinates(corner_of(box, corner));
            if (depth <= 0) return false;
            const double size = camera_.projection == Projection::orthographic ? 1 : depth;
            pixels.add({x / size * width_, y / size * height_, 0});
        }
        return pixels.hi.x - pixels.lo.x < side && pixels.hi.y - pixels.lo.y < side;
    }

    /// Whether any camera ray would hit the plane if it were the only shape.
    bool may_see(Vec3 point, Vec3 normal) const {
        for (int i = 0; i < 25; ++i) {
            const auto ray = HWY_NAMESPACE::viewport_ray(camera_, i % 5 * 0.25 - 0.5, i / 5 * 0.25 - 0.5);
            if (dot(point - ray.origin, normal) / dot(ray.direction, normal) > 0) return true;
        }
        return false;
    }

  private:
    const PreparedCamera& camera_;
    CameraProjection projection_;
    double width_, height_;
};

struct Unseen {
    std::vector<std::uint32_t> outside, hidden, tiny, thin;
    std::size_t shapes = 0;  // that are rendered at all
};

Unseen find_unseen(const WorldParts& world, const std::vector<bool>& seen) {
    using Place = Frame::Place;
    const Frame frame(world.camera, world.settings);
    // A polygon has the place of its most visible triangle.
    std::vector<Place> places(seen.size(), Place::not_rendered);
    for (std::uint32_t slot = 0; slot < world.geometry->first_operand(); ++slot) {
        Place& place = places[world.geometry->shape_index[slot]];
        if (slot < world.geometry->bounded) {
            const Aabb box = HWY_NAMESPACE::primitive_bounds(*world.geometry, slot);
            if (is_endless(box)) continue;  // where it is, is not known
            place = std::max(place, frame.place_of(to_bounds(box)));
        } else {
            const ShapeClass& planes = world.geometry->class_of(slot);
            const auto value = [&](int k) { return planes.value(k, slot); };
            const bool met = frame.may_see({value(0), value(1), value(2)}, {value(3), value(4), value(5)});
            place = met ? Place::inside : Place::outside;
        }
    }
    Unseen unseen;
    for (std::uint32_t shape = 0; shape < seen.size(); ++shape) {
        if (places[shape] == Place::not_rendered) continue;
        ++unseen.shapes;
        if (seen[shape]) continue;
        auto& list = places[shape] == Place::outside ? unseen.outside
                     : places[shape] == Place::tiny  ? unseen.tiny
                                                     : unseen.hidden;
        list.push_back(shape);
    }
    return unseen;
}

bool is_most(const Unseen& unseen, const std::vector<std::uint32_t>& list) {
    return list.size() > unseen.shapes / 2;
}

// In a scene written by hand every shape should be visible. A model of hundreds of shapes has backs and
// insides, and continues outside the picture: only its named shapes count, or all if half of them are not
// visible.
std::vector<std::uint32_t> worth_naming(const CheckContext& context, const Unseen& unseen,
                                        const std::vector<std::uint32_t>& list, bool half_counts) {
    if (!context.is_model() || (half_counts && is_most(unseen, list))) return list;
    std::vector<std::uint32_t> named;
    std::copy_if(list.begin(), list.end(), std::back_inserter(named),
                 [&](std::uint32_t shape) { return !context.scene().shape_texts.name(shape).empty(); });
    return named;
}

// Whether the shapes are triangles of a mesh that is not small itself: a fine mesh looks as it should.
bool is_fine_mesh(const CheckContext& context, const std::vector<std::uint32_t>& tiny) {
    if (!context.is_model()) return false;
    const Scene& scene = context.scene();
    const WorldParts& world = context.world();
    std::vector<bool> listed(scene.shapes.size());
    for (const std::uint32_t shape : tiny) {
        const ShapeKind kind = scene.shapes[shape].kind;
        if (kind != ShapeKind::triangle && kind != ShapeKind::smooth_triangle && kind != ShapeKind::polygon)
            return false;
        listed[shape] = true;
    }
    Extent all;
    for (std::uint32_t slot = 0; slot < world.geometry->bounded; ++slot) {
        if (!listed[world.geometry->shape_index[slot]]) continue;
        const Bounds box = to_bounds(HWY_NAMESPACE::primitive_bounds(*world.geometry, slot));
        all.add(box.min);
        all.add(box.max);
    }
    return !Frame(world.camera, world.settings).is_within({all.lo, all.hi}, k_speck);
}

// What may hide a bounded shape, by the points of its box that are in the picture: its middle, and points
// near its corners. hidden: another shape is in front of one of them. thin: only rays beside it pass its
// middle.
enum class Reason : std::uint8_t { hidden, thin, outside };

Reason reason_of(const CheckContext& context, std::uint32_t shape) {
    const WorldParts& world = context.world();
    const CameraProjection projection(world.camera);
    const bool flat = world.camera.projection == Projection::orthographic;
    RayList rays;
    std::vector<double> depths;
    bool middle_is_inside = false;
    for (std::uint32_t slot = 0; slot < world.geometry->bounded; ++slot) {
        if (world.geometry->shape_index[slot] != shape) continue;
        const Bounds box = to_bounds(HWY_NAMESPACE::primitive_bounds(*world.geometry, slot));
        const Vec3 middle = (box.min + box.max) * 0.5;
        for (int i = 0; i < 9; ++i) {
            const Vec3 point = i == 8 ? middle : middle + (corner_of(box, i) - middle) * k_near_corner;
            const auto [x, y, depth] = projection.coordinates(point);
            const double size = flat ? 1 : depth;
            if (!(depth > 0) || number::abs(x) > size / 2 || number::abs(y) > size / 2) continue;
            middle_is_inside = middle_is_inside || i == 8;
            const auto ray = HWY_NAMESPACE::viewport_ray(world.camera, x / size, y / size);
            rays.add(ray.origin, ray.direction, 0);
            depths.push_back(depth);
        }
    }
    const HitList hits = nearest_surfaces(world, rays, context.threads());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (!hits.surface[i].exists() || world.geometry->shape_of(hits.surface[i]) == shape) continue;
        const Vec3 point = rays.origin(i) + rays.direction(i) * hits.t[i];
        if (projection.coordinates(point).depth < depths[i]) return Reason::hidden;
    }
    return middle_is_inside ? Reason::thin : Reason::outside;
}

// Looks more closely at the shapes that may be hidden.
void find_reasons(const CheckContext& context, Unseen& unseen) {
    if (context.is_model()) return;
    std::vector<std::uint32_t> hidden;
    for (const std::uint32_t shape : unseen.hidden) {
        const bool plane = context.scene().shapes[shape].kind == ShapeKind::plane;
        const Reason reason = plane ? Reason::hidden : reason_of(context, shape);
        auto& list = reason == Reason::hidden ? hidden
                     : reason == Reason::thin ? unseen.thin
                                              : unseen.outside;
        list.push_back(shape);
    }
    unseen.hidden = std::move(hidden);
    std::sort(unseen.outside.begin(), unseen.outside.end());
}

// Which of the first few shapes is inside which other shape.
std::string enclosure(const CheckContext& context, const WorldParts& world,
                      const std::vector<std::uint32_t>& list) {
    for (std::size_t i = 0; i < list.size() && i < k_max_enclosed; ++i) {
        std::uint32_t slot = 0;
        while (slot < world.geometry->bounded && world.geometry->shape_index[slot] != list[i]) ++slot;
        if (slot == world.geometry->bounded) continue;
        const Bounds box = to_bounds(HWY_NAMESPACE::primitive_bounds(*world.geometry, slot));
        for (const std::uint32_t around : shapes_around(context, (box.min + box.max) * 0.5)) {
            if (around == list[i]) continue;
            return fmt::format("; the middle of {} is inside {}", context.shape(list[i]),
                               context.shape_and_line(around));
        }
    }
    return {};
}

}  // namespace

void check_shapes(CheckContext& context, const VisibleHits& visible, const std::vector<bool>& explained) {
    const WorldParts& world = context.world();
    std::vector<bool> seen = visible.hit_shapes(context.scene());
    // check_holes() tells of those of which only holes are seen.
    for (std::uint32_t i = 0; i < seen.size(); ++i) seen[i] = seen[i] || explained[i] || visible.is_passed(i);
    mark_shadows(context, visible, seen);
    mark_bodies_of_lights(context.scene(), seen);
    Unseen unseen = find_unseen(world, seen);
    find_reasons(context, unseen);
    const std::size_t deep = visible.generations.size() - 1;
    const std::string mirrors =
        deep == 0 ? ""
                  : fmt::format("; nor is anything in the first {} of mirrors and glass",
                                deep == 1 ? "generation" : fmt::format("{} generations", deep));
    // The shadows of the lights that were not traced are unknown.
    const bool knows_shadows = !world.settings.shadows || world.lights->size() <= k_max_lights;
    const std::string coarse = context.coarse_grid(VisibleHits::k_longest);
    const auto report = [&](std::string_view id, const std::vector<std::uint32_t>& all,
                            std::string_view where, bool hidden, std::string remedy) {
        const std::vector<std::uint32_t> list = worth_naming(context, unseen, all, !hidden);
        if (list.empty()) return;
        context.report(
            id, context.at_shape(list.front()),
            fmt::format("{} of {} {} {}{}{}: {}{}", list.size(),
                        unseen.shapes == 1 ? "1 shape" : fmt::format("{} shapes", unseen.shapes),
                        list.size() == 1 ? "is" : "are", where,
                        !knows_shadows     ? ""
                        : list.size() == 1 ? ", and no shadow of it is visible"
                                           : ", and no shadow of them is visible",
                        mirrors, context.some_shapes(list),
                        (hidden ? enclosure(context, world, list) : "") + coarse),
            std::move(remedy),
            context.is_model() && (hidden || !is_most(unseen, all)) ? Severity::note : Severity::warning);
    };
    report("shape-outside-view", unseen.outside, "outside the picture", false,
           "move the shapes or the camera, or widen its view");
    report("shape-hidden", unseen.hidden, "hidden behind or inside others", true,
           "move the shape or what hides it, or remove it");
    report("shape-too-small", unseen.thin, "thinner than a pixel, as the camera sees it", false,
           "make the shape thicker, turn it, or make the picture larger");
    if (is_fine_mesh(context, unseen.tiny)) return;
    report("shape-too-small", unseen.tiny, "smaller than a pixel", false,
           "make the shape larger, or the picture, or bring the camera nearer");
}

}  // namespace glint
