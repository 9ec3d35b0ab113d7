// SPDX-License-Identifier: Apache-2.0
// Objects to the Scene: groups are resolved, maps are applied to the shapes.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/add_shape.h"
#include "formats/povray/closed_mesh.h"
#include "math/number.h"
#include "math/quadric_bounds.h"
#include "math/quartic_value.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

// Along an axis. POV-Ray gives some of them a box that is too small when they are cut (measured).
bool is_paraboloid(const Object& quadric) {
    const double squares[] = {quadric.a.x, quadric.a.y, quadric.a.z},
                 linear[] = {quadric.c.x, quadric.c.y, quadric.c.z};
    for (int i = 0; i < 3; ++i) {
        const double first = squares[(i + 1) % 3], second = squares[(i + 2) % 3];
        if (squares[i] == 0 && linear[i] != 0 && first * second > 0) return true;
    }
    return false;
}

// Unless the terms of degree 4 are clearly positive, or negative, in all directions.
bool may_have_no_ends(const Quartic& quartic) {
    double leading[std::size(k_quartic_terms)] = {}, least = number::k_infinity, most = -number::k_infinity;
    for (std::size_t i = 0; i < std::size(leading); ++i) {
        if (quartic_degree(i) == 4) leading[i] = quartic.coefficients[i];
    }
    constexpr int k_steps = 4;
    for (int x = -k_steps; x <= k_steps; ++x) {
        for (int y = -k_steps; y <= k_steps; ++y) {
            for (const double z : {-4.0, -3.0, -2.0, -1.0, 0.0}) {  // as at the opposite point
                if (x == 0 && y == 0 && z == 0) continue;
                const double value = quartic_value(leading, normalize(Vec3{1.0 * x, 1.0 * y, z}));
                least = number::min(least, value), most = number::max(most, value);
            }
        }
    }
    return least * most <= 0 || number::min(number::abs(least), number::abs(most)) <
                                    0.02 * number::max(number::abs(least), number::abs(most));
}

// POV-Ray's rays meet it only if they meet what bounds it (measured).
bool may_leave_bounds(const Object& o) {
    switch (o.kind) {
        case ObjectKind::plane:
            return true;
        case ObjectKind::quadric: {
            Vec3 lo, hi;
            quadric_bounds({o.a, o.b, o.c, o.s}, lo, hi);
            return hi.x >= k_endless;
        }
        case ObjectKind::quartic:
            return may_have_no_ends(*o.quartic);
        default:
            return false;
    }
}

}  // namespace

bool is_diagonal(const Affine& map) {
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
            if (r != c && map.m[r][c] != 0) return false;
        }
    }
    return true;
}

double similarity(const Affine& map) {
    const auto column = [&](int i) { return Vec3{map.m[0][i], map.m[1][i], map.m[2][i]}; };
    const Vec3 x = column(0), y = column(1), z = column(2);
    const double xx = dot(x, x), limit = 1e-12 * xx;
    const bool is_similar = number::abs(dot(y, y) - xx) <= limit && number::abs(dot(z, z) - xx) <= limit &&
                            number::abs(dot(x, y)) <= limit && number::abs(dot(x, z)) <= limit &&
                            number::abs(dot(y, z)) <= limit;
    return is_similar ? number::sqrt(xx) : 0;
}

bool has_normals_on_both_sides(const std::array<Vec3, 3>& vertices, const std::array<Vec3, 3>& normals) {
    const Vec3 face = cross(vertices[1] - vertices[0], vertices[2] - vertices[0]);
    bool front = false, back = false;
    for (const Vec3& n : normals) {
        front = front || dot(n, face) > 0;
        back = back || dot(n, face) < 0;
    }
    return front && back;
}

// The place of a shape: that of the outermost macro call, where the text asks for it.
SourcePlace SceneBuilder::shape_place(const Token& at) {
    const Token token = stream_.call_place(at);
    if (token.offset != last_place_token_.offset || token.text != last_place_token_.text ||
        last_place_.line == 0) {
        last_place_token_ = token;
        last_place_ = stream_.place_of(token);
    }
    return last_place_;
}

void SceneBuilder::place(const Object& object, const Texture& default_texture) {
    if (stream_.failed()) return;
    stream_.allow_steps(object.count);
    if (!stream_.count_shapes(object.count)) {
        return stream_.error(object.at, fmt::format("more than {} shapes", stream_.max_shapes()));
    }
    Inherited outer;
    outer.texture = &default_texture;
    outer.finish_interior = finish_interior_of(object);
    place(object, outer);
}

void SceneBuilder::place(const Object& object, const Inherited& from) {
    if (stream_.failed() || (++placed_ % 256 == 0 && !stream_.is_within_memory(object.at))) return;
    Inherited own = from;
    std::optional<Affine> map, texture_map;
    if (object.map) {
        map = from.map ? compose(*from.map, *object.map) : *object.map;
        own.map = &*map;
    }
    // A shape's own texture counts, else that of the group.
    if (object.texture) {
        own.texture = object.texture.get();
        own.texture_map = from.map;
        if (object.texture_map && (own.texture->pigment.image || own.texture->below)) {
            texture_map = from.map ? compose(*from.map, *object.texture_map) : *object.texture_map;
            own.texture_map = &*texture_map;
        }
    }
    own.is_uv = object.is_uv || (!object.texture && from.is_uv);
    if (!object.stands_for.empty()) own.uv_source = UvSource::unknown;
    own.is_no_shadow = from.is_no_shadow || object.is_no_shadow;
    own.is_bounded = from.is_bounded || object.is_bounded;
    if (object.interior) own.interior = object.interior.get();
    if (!own.interior) own.interior = own.finish_interior;
    if (object.kind != ObjectKind::light) inherit_interior(object, own);
    if (from.in_solid && object.interior && object.interior->ior != 1)
        report({"ior", "of a part of a solid", stream_.call_place(object.at)});
    if (from.in_solid && object.interior && fade_of(own).distance > 0)
        report({"fade_distance", "of a part of a solid", stream_.call_place(object.at)});
    if (object.is_inverse && !own.in_solid && ior_of(own) != 1)
        report({"ior", "of an inverted object", stream_.call_place(object.at)});
    if (object.is_inverse && !own.in_solid && fade_of(own).distance > 0)
        report({"fade_distance", "of an inverted object", stream_.call_place(object.at)});
    if (leave_out(object)) {
        if (object.kind == ObjectKind::light) place_look(object, own);
        return;
    }
    report(object.missing);
    if (object.leaves_bounds && !own.in_solid)
        stream_.warn_once(
            "bounded_by", object.at,
            "POV-Ray draws an object only where rays meet its bounded_by, and this one reaches out of it: "
            "the picture may differ");
    if (object.no_reflection && !no_reflection_) no_reflection_ = stream_.call_place(*object.no_reflection);
    // If the camera does not see what is cut, it is not cut: Jmol cuts by the box of the picture.
    const bool may_be_unseen = !is_quiet_ && object.clip && object.clips.size() == 1 && !from.map &&
                               object.map == object.clip->map && own.is_no_shadow && !own.in_solid &&
                               !own.clips && !object.clip->halves.empty();
    if (object.clip && !may_be_unseen && !add_clips(object, from, own)) report(object.clip->missing);
    switch (object.kind) {
        case ObjectKind::refused:
            return;
        case ObjectKind::light:
            return place_light(object, own);
        default:
            break;
    }
    const std::size_t first = scene_.shapes.size();
    if (object.kind == ObjectKind::group || object.kind == ObjectKind::solid) {
        place_parts(object, own);
        if (!own.in_solid) note_inside(object, own, first);
        return;
    }
    if (object.kind == ObjectKind::mesh) {
        place_mesh(object, own, may_be_unseen && encloses_space(object));
    } else if (object.kind == ObjectKind::height_field) {
        place_field(object, own);
    } else {
        place_shape(object, own);
    }
    // A mesh of one face is gathered with others.
    if (may_be_unseen && (scene_.shapes.size() > first || object.kind == ObjectKind::mesh))
        clips_.push_back({object.clip, object.clips, first, encloses_space(object)});
    if (own.in_solid || own.clips) finish_operand(object, own, first);
    if (own.in_solid) return;
    if (object.kind == ObjectKind::mesh || (object.is_inverse && object.kind != ObjectKind::height_field))
        note_inside(object, own, first);
    if (own.clips && scene_.shapes.size() > first) {
        note_solid(first, own);
    } else {
        note_interior(first, own);
    }
}

void SceneBuilder::place_shape(const Object& o, const Inherited& from) {
    Inherited own = from;
    std::optional<Affine> sphere;
    const bool is_whole = own.uv_source != UvSource::unknown;  // not a part of a sphere_sweep
    if (o.kind == ObjectKind::sphere && is_whole && (own.texture->pigment.image || own.texture->below)) {
        sphere = own.map ? compose(*own.map, translation(o.a)) : translation(o.a);
        own.sphere = &*sphere;
        own.uv_source = UvSource::sphere;
    }
    if (o.kind == ObjectKind::box || o.kind == ObjectKind::torus) own.uv_source = UvSource::unknown;
    own.is_ball = o.kind == ObjectKind::sphere && is_whole && !own.in_solid && !own.clips;
    const std::uint32_t material = material_of(own, o.at);
    const Affine* map = own.map;
    const double factor = map ? similarity(*map) : 1;
    const auto point = [&](Vec3 p) { return map ? transform_point(*map, p) : p; };
    const auto turned = [&](Vec3 n) {
        if (!map) return n;
        const auto object_from_world = inverse(*map);
        if (!object_from_world) stream_.error(o.at, "the shape's transform leaves nothing of it");
        return stream_.failed() ? n : transform_normal(*object_from_world, n);
    };
    // A map that keeps angles is applied to the shape itself.
    const Affine* rest = factor > 0 ? nullptr : map;
    const auto moved = [&](Vec3 p) { return rest ? p : point(p); };
    const double size = rest ? 1 : factor;
    if (own.is_bounded && !own.in_solid && !own.clips && may_leave_bounds(o)) {
        stream_.warn_once("bounded_by", o.at,
                          "POV-Ray draws a shape without ends only where rays meet its bounded_by: the "
                          "picture may differ");
    }
    switch (o.kind) {
        case ObjectKind::sphere:
            if (o.r > 0) add(Sphere{moved(o.a), o.r * size}, material, rest, o.at);
            break;
        case ObjectKind::cylinder:
            if (o.r > 0) add(Cylinder{moved(o.a), moved(o.b), o.r * size, !o.is_open}, material, rest, o.at);
            break;
        case ObjectKind::cone:
            if (o.r == o.s) {
                if (o.r > 0)
                    add(Cylinder{moved(o.a), moved(o.b), o.r * size, !o.is_open}, material, rest, o.at);
            } else {
                add(Cone{moved(o.a), moved(o.b), o.r * size, o.s * size, !o.is_open}, material, rest, o.at);
            }
            break;
        case ObjectKind::box: {
            const bool is_moved = map && is_diagonal(*map);
            const Vec3 a = is_moved ? point(o.a) : o.a, b = is_moved ? point(o.b) : o.b;
            const Box box{{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                          {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
            add(box, material, is_moved ? nullptr : map, o.at);
            break;
        }
        case ObjectKind::plane: {
            const Vec3 n = normalize(o.b);
            add(Plane{point(n * o.s), turned(n)}, material, nullptr, o.at);
            break;
        }
        case ObjectKind::disc:
            if (o.r > o.s)
                add(Disc{moved(o.a), rest ? o.b : turned(o.b), o.r * size, o.s * size}, material, rest, o.at);
            break;
        case ObjectKind::torus: {
            const Vec3 axis{0, 1, 0};
            if (o.r > 0 && o.s > 0) {
                add(Torus{moved({}), rest ? axis : turned(axis), o.r * size, o.s * size}, material, rest,
                    o.at);
            }
            break;
        }
        case ObjectKind::quadric:
            if ((own.in_solid || own.clips) && is_paraboloid(o)) {
                stream_.warn_once(
                    "paraboloid", o.at,
                    "POV-Ray may cut off a part of a paraboloid in a solid or with clipped_by: the "
                    "picture may differ");
            }
            add(Quadric{o.a, o.b, o.c, o.s}, material, map, o.at);
            break;
        case ObjectKind::quartic:
            add(*o.quartic, material, map, o.at);
            break;
        case ObjectKind::triangle:
            add(Triangle{{point(o.a), point(o.b), point(o.c)}}, material, nullptr, o.at);
            break;
        case ObjectKind::polygon: {
            auto& all = scene_.polygon_vertices;
            const Polygon polygon{static_cast<std::uint32_t>(all.size()),
                                  static_cast<std::uint32_t>(o.outline->size())};
            for (const Vec3& p : *o.outline) all.push_back(point(p));
            add(polygon, material, nullptr, o.at);
            break;
        }
        default: {
            if (has_normals_on_both_sides({o.a, o.b, o.c}, *o.normals)) {
                stream_.warn_once(
                    "normals on both sides", o.at,
                    "normals on both sides of a smooth triangle: as in POV-Ray, it is left out");
                break;
            }
            const auto normal = [&](Vec3 n) { return turned(n == Vec3{0, 0, 0} ? Vec3{1, 0, 0} : n); };
            add(SmoothTriangle{{point(o.a), point(o.b), point(o.c)},
                               {normal((*o.normals)[0]), normal((*o.normals)[1]), normal((*o.normals)[2])}},
                material, nullptr, o.at);
        }
    }
}

}  // namespace glint::povray
