// SPDX-License-Identifier: Apache-2.0
// What was measured of POV-Ray: a shape's box is that of the corners of a box in the shape's own space, after
// all transforms. A sphere remains one while it is only turned, moved and scaled evenly. The box of a group,
// a solid or a mesh is that of the corners of the box before each transform. An intersection has what is
// common to its parts, of which planes count that are perpendicular to an axis, and inverse parts do not; if
// that is nothing, or without a bound, the box is that of all space. Planes of clipped_by do not count; the
// boxes of other clips count for some kinds, by a rule that is not known.
#include "formats/povray/extents.h"

#include <algorithm>

#include "formats/povray/field_mesh.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

constexpr double k_all_space = 1e10;
constexpr double k_thickness = 0.001;  // of half a disc
constexpr double k_aligned = 1e-9;
constexpr double k_bounds_slack = 1e-3;  // of the object's box

Extent all_space() {
    return {{-k_all_space, -k_all_space, -k_all_space}, {k_all_space, k_all_space, k_all_space}};
}

bool is_bounded(const Extent& extent) { return extent.high.x < k_all_space; }

void add(Extent& extent, Vec3 p) {
    extent.low = {std::min(extent.low.x, p.x), std::min(extent.low.y, p.y), std::min(extent.low.z, p.z)};
    extent.high = {std::max(extent.high.x, p.x), std::max(extent.high.y, p.y), std::max(extent.high.z, p.z)};
}

Extent mapped(const Extent& box, const Affine& map) {
    if (!is_bounded(box)) return box;
    Extent out;
    for (int corner = 0; corner < 8; ++corner) {
        add(out,
            transform_point(map, {corner & 1 ? box.high.x : box.low.x, corner & 2 ? box.high.y : box.low.y,
                                  corner & 4 ? box.high.z : box.low.z}));
    }
    return out;
}

Extent ball(Vec3 center, Vec3 reach) { return {center - reach, center + reach}; }

// The frame of a cylinder or disc: z turned to a unit vector, on the shortest way.
Affine frame_of(Vec3 origin, Vec3 z) {
    const double size = number::sqrt(z.x * z.x + z.y * z.y);
    Affine out = translation(origin);
    if (size < 1e-12) {
        out.m[1][1] = out.m[2][2] = z.z < 0 ? -1 : 1;
        return out;
    }
    const Vec3 about{-z.y / size, z.x / size, 0};
    for (int i = 0; i < 2; ++i) {
        const Vec3 unit{i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, 0};
        const Vec3 turned = unit * z.z + cross(about, unit) * size + about * (dot(about, unit) * (1 - z.z));
        out.m[0][i] = turned.x, out.m[1][i] = turned.y, out.m[2][i] = turned.z;
    }
    out.m[0][2] = z.x, out.m[1][2] = z.y, out.m[2][2] = z.z;
    return out;
}

class ExtentReader {
  public:
    ExtentReader(const std::function<bool(std::uint64_t)>& spend, std::string_view& why)
        : spend_(spend), why_(why) {}

    std::optional<Extent> of(const Object& object) {
        if (!spend_(1)) return std::nullopt;
        if (object.is_bounded) return unknown("with bounded_by");
        const bool is_cut = std::any_of(object.clips.begin(), object.clips.end(), [](const ClipObject& clip) {
            return clip.object->kind != ObjectKind::plane;
        });
        if (is_cut) return unknown("with clipped_by");
        const Affine map = object.map.value_or(Affine());
        switch (object.kind) {
            case ObjectKind::sphere:
                return of_sphere(object, map);
            case ObjectKind::box: {
                Extent box;
                add(box, object.a);
                add(box, object.b);
                return mapped(box, map);
            }
            case ObjectKind::cylinder:
                return of_cone(object, object.r, map);
            case ObjectKind::cone:
                return of_cone(object, object.s, map);
            case ObjectKind::torus: {
                const double reach = object.r + object.s;
                return mapped(ball({0, 0, 0}, {reach, object.s, reach}), map);
            }
            case ObjectKind::disc:
                return mapped(ball({0, 0, 0}, {object.r, object.r, k_thickness}),
                              compose(map, frame_of(object.a, normalize(object.b))));
            case ObjectKind::triangle:
            case ObjectKind::smooth_triangle: {
                Extent box;
                for (const Vec3& p : {object.a, object.b, object.c}) add(box, transform_point(map, p));
                return box;
            }
            case ObjectKind::plane:
            case ObjectKind::light:
                return all_space();
            case ObjectKind::mesh:
                return of_mesh(object, map);
            case ObjectKind::height_field:
                return of_field(object, map);
            case ObjectKind::group:
                return of_group(object, map);
            case ObjectKind::solid:
                return of_solid(object);
            case ObjectKind::quadric:
                return unknown("quadric");
            case ObjectKind::quartic:
                return unknown("quartic");
            case ObjectKind::polygon:
                return unknown("polygon");
            default:
                return unknown("a shape that glint does not render");
        }
    }

  private:
    std::optional<Extent> unknown(std::string_view why) {
        why_ = why;
        return std::nullopt;
    }

    // Stretched after it was turned, it is a ball before; turned after it was stretched, a box.
    std::optional<Extent> of_sphere(const Object& object, const Affine& map) {
        const Vec3 reach{object.r, object.r, object.r};
        const double factor = similarity(map);
        const Extent turned = mapped(ball(object.a, reach), map);
        const auto column = [&](int i) { return Vec3{map.m[0][i], map.m[1][i], map.m[2][i]}; };
        if (object.is_moved_by_matrix) return turned;
        const bool is_mirrored = dot(cross(column(0), column(1)), column(2)) < 0;
        if (is_mirrored && !is_diagonal(map)) return unknown("a sphere that is turned and mirrored");
        if (factor > 0) return ball(transform_point(map, object.a), reach * factor);
        const auto row = [&](int i) { return Vec3{map.m[i][0], map.m[i][1], map.m[i][2]}; };
        const auto are_square = [](Vec3 a, Vec3 b, Vec3 c) {
            const double limit = k_aligned * std::max({dot(a, a), dot(b, b), dot(c, c)});
            return number::abs(dot(a, b)) <= limit && number::abs(dot(a, c)) <= limit &&
                   number::abs(dot(b, c)) <= limit;
        };
        if (are_square(row(0), row(1), row(2))) {
            const Vec3 sizes{length(row(0)), length(row(1)), length(row(2))};
            return ball(transform_point(map, object.a), sizes * object.r);
        }
        if (are_square(column(0), column(1), column(2))) return turned;
        return unknown("a sphere that is turned, stretched and turned again");
    }

    static Extent of_cone(const Object& object, double far, const Affine& map) {
        const bool is_cylinder = object.kind == ObjectKind::cylinder;
        const double r = is_cylinder ? object.r : std::max(object.r, far);
        // Its z is towards the wider end, or the first one.
        const bool is_first_wider = is_cylinder || object.r >= far;
        const Vec3 from = is_first_wider ? object.b : object.a, to = is_first_wider ? object.a : object.b;
        const double size = length(to - from);
        Extent box = ball({0, 0, size / 2}, {r, r, size / 2});
        return mapped(box, compose(map, frame_of(from, (to - from) / size)));
    }

    std::optional<Extent> of_mesh(const Object& object, const Affine& map) {
        const auto& vertices = object.mesh->vertices;
        if (!spend_(vertices.size() / 16)) return std::nullopt;
        if (object.stands_for == "polygon") return unknown("polygon");
        Extent box;
        for (const Float3& p : vertices) add(box, to_vec3(p));
#if defined(GLINT_WITH_FREETYPE)
        if (object.stands_for == "text") return vertices.empty() ? all_space() : after_steps(box, object);
#endif
        return object.stands_for.empty() ? after_steps(box, object) : mapped(box, map);
    }

    std::optional<Extent> of_field(const Object& object, const Affine& map) {
        if (!object.field || object.field->heights.empty())
            return unknown("height_field without its picture");
        const HeightField& field = *object.field;
        if (!spend_(field.heights.size() / 16)) return std::nullopt;
        const auto [low, high] = std::minmax_element(field.heights.begin(), field.heights.end());
        const double most_x = field.width - 1, most_z = field.depth - 1;
        const Extent box{{0, std::max<double>(*low, field.water), 0},
                         {most_x, static_cast<double>(*high), most_z}};
        return mapped(box, compose(map, cube_from_grid(field)));
    }

    std::optional<Extent> of_group(const Object& object, const Affine& map) {
        if (object.stands_for == "lathe") return of_lathe(object, map);
        if (object.is_curve) return unknown("sphere_sweep with a curved spline");
        if (object.stands_for == "sphere_sweep") return of_sweep(object, map);
        Extent box;
        for (const ObjectPart& part : *object.parts) {
            const auto extent = of(*part);
            if (!extent) return std::nullopt;
            if (!is_bounded(*extent)) return all_space();
            add(box, extent->low);
            add(box, extent->high);
        }
        return after_steps(box, object);
    }

    static std::optional<Extent> of_lathe(const Object& object, const Affine& map) {
        Extent box;
        for (const ObjectPart& part : *object.parts) {
            const double r = std::max(part->r, part->s);
            add(box, part->a + Vec3{r, 0, r});
            add(box, part->a - Vec3{r, 0, r});
            if (part->kind != ObjectKind::disc) add(box, part->b);
        }
        return mapped(box, map);
    }

    std::optional<Extent> of_sweep(const Object& object, const Affine& map) {
        Extent box;
        for (const ObjectPart& part : *object.parts) {
            if (part->kind != ObjectKind::sphere) continue;
            Object sphere = *part;
            sphere.map = map;
            sphere.is_moved_by_matrix = object.is_moved_by_matrix;
            const auto extent = of(sphere);
            if (!extent) return std::nullopt;
            add(box, extent->low);
            add(box, extent->high);
        }
        return box;
    }

    std::optional<Extent> of_solid(const Object& object) {
        Extent box = all_space();
        const bool is_difference = object.operation == SolidOperation::difference;
        for (std::size_t i = 0; i < object.parts->size(); ++i) {
            const Object& part = *(*object.parts)[i];
            const bool is_inverse = part.is_inverse != (is_difference && i > 0);
            if (part.kind == ObjectKind::plane) {
                cut_by_plane(part, is_inverse, box);
            } else if (!is_inverse) {
                const auto extent = of(part);
                if (!extent) return std::nullopt;
                box.low = {std::max(box.low.x, extent->low.x), std::max(box.low.y, extent->low.y),
                           std::max(box.low.z, extent->low.z)};
                box.high = {std::min(box.high.x, extent->high.x), std::min(box.high.y, extent->high.y),
                            std::min(box.high.z, extent->high.z)};
            }
        }
        const Vec3 size = box.high - box.low;
        const bool is_empty = size.x < 0 || size.y < 0 || size.z < 0;
        const bool is_endless = std::max({size.x, size.y, size.z}) >= k_all_space;
        if (is_empty || is_endless) return all_space();
        return after_steps(box, object);
    }

    static void cut_by_plane(const Object& plane, bool is_inverse, Extent& box) {
        const Affine map = plane.map.value_or(Affine());
        const auto back = inverse(map);
        if (!back) return;
        Vec3 n = normalize(transform_normal(*back, plane.b));
        double distance = dot(n, transform_point(map, normalize(plane.b) * plane.s));
        if (is_inverse) n = -n, distance = -distance;
        const auto cut = [&](double along, double& low, double& high) {
            if (along > 1 - k_aligned) high = std::min(high, distance);
            if (along < -1 + k_aligned) low = std::max(low, -distance);
        };
        cut(n.x, box.low.x, box.high.x);
        cut(n.y, box.low.y, box.high.y);
        cut(n.z, box.low.z, box.high.z);
    }

    static Extent after_steps(Extent box, const Object& object) {
        for (const Affine& step : object.steps) box = mapped(box, step);
        return box;
    }

    const std::function<bool(std::uint64_t)>& spend_;
    std::string_view& why_;
};

double volume(const Extent& box) {
    const Vec3 size = box.high - box.low;
    return size.x * size.y * size.z;
}

}  // namespace

std::optional<Extent> extent_of(const Object& object, const std::function<bool(std::uint64_t)>& spend,
                                std::string_view& why) {
    const auto extent = ExtentReader(spend, why).of(object);
    if (extent && extent->low.x <= extent->high.x) return extent;
    if (extent) why = "it has no points";
    return std::nullopt;
}

bool leaves_bounds(const Object& object, const Object& bounds,
                   const std::function<bool(std::uint64_t)>& spend) {
    if (bounds.is_inverse) return false;
    std::string_view why;
    const auto inner = extent_of(object, spend, why), outer = extent_of(bounds, spend, why);
    if (!inner || !outer || !is_bounded(*inner) || volume(*outer) >= volume(*inner)) return false;
    const Vec3 slack = (inner->high - inner->low) * k_bounds_slack;
    const Vec3 low = inner->low + slack, high = inner->high - slack;
    return low.x < outer->low.x || low.y < outer->low.y || low.z < outer->low.z || high.x > outer->high.x ||
           high.y > outer->high.y || high.z > outer->high.z;
}

}  // namespace glint::povray
