// SPDX-License-Identifier: Apache-2.0
// Whether a clipping object holds a whole object, so that it cuts nothing.
#include <algorithm>

#include "formats/povray/clip.h"
#include "math/transform.h"

namespace glint::povray {
namespace {

struct Bounds {
    Vec3 lo{1e300, 1e300, 1e300}, hi{-1e300, -1e300, -1e300};
    bool is_known = true;

    void add(Vec3 p) {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
    void add(Vec3 center, double r) {
        add(center - Vec3{r, r, r});
        add(center + Vec3{r, r, r});
    }
};

// Bounds in the object's own space, without its map.
Bounds own_bounds(const Object& object) {
    Bounds out;
    switch (object.kind) {
        case ObjectKind::sphere:
        case ObjectKind::disc:
            out.add(object.a, object.r);
            break;
        case ObjectKind::torus:
            out.add({-object.r - object.s, -object.s, -object.r - object.s});
            out.add({object.r + object.s, object.s, object.r + object.s});
            break;
        case ObjectKind::cylinder:
            out.add(object.a, object.r);
            out.add(object.b, object.r);
            break;
        case ObjectKind::cone:
            out.add(object.a, object.r);
            out.add(object.b, object.s);
            break;
        case ObjectKind::box:
            out.add(object.a);
            out.add(object.b);
            break;
        case ObjectKind::triangle:
        case ObjectKind::smooth_triangle:
            out.add(object.a);
            out.add(object.b);
            out.add(object.c);
            break;
        case ObjectKind::mesh:
            for (const Float3& p : object.mesh->vertices) out.add(to_vec3(p));
            break;
        case ObjectKind::polygon:
            for (const Vec3& p : *object.outline) out.add(p);
            break;
        default:
            out.is_known = false;
    }
    return out;
}

}  // namespace

bool bounds_of(const Object& object, Vec3& lo, Vec3& hi) {
    const Bounds own = own_bounds(object);
    if (!own.is_known) return false;
    Bounds outer;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 p{corner & 1 ? own.hi.x : own.lo.x, corner & 2 ? own.hi.y : own.lo.y,
                     corner & 4 ? own.hi.z : own.lo.z};
        outer.add(object.map ? transform_point(*object.map, p) : p);
    }
    lo = outer.lo;
    hi = outer.hi;
    return true;
}

bool holds(const Object& clip, const Object& object) {
    Bounds outer;
    if (clip.map || clip.is_inverse || !clip.missing.empty() || !bounds_of(object, outer.lo, outer.hi))
        return false;
    if (clip.kind == ObjectKind::box) {
        const Vec3 lo{std::min(clip.a.x, clip.b.x), std::min(clip.a.y, clip.b.y),
                      std::min(clip.a.z, clip.b.z)};
        const Vec3 hi{std::max(clip.a.x, clip.b.x), std::max(clip.a.y, clip.b.y),
                      std::max(clip.a.z, clip.b.z)};
        return lo.x <= outer.lo.x && lo.y <= outer.lo.y && lo.z <= outer.lo.z && hi.x >= outer.hi.x &&
               hi.y >= outer.hi.y && hi.z >= outer.hi.z;
    }
    if (clip.kind != ObjectKind::plane) return false;
    const Vec3 n = normalize(clip.b);
    double most = 0;
    for (int i = 0; i < 3; ++i) {
        const double along = i == 0 ? n.x : i == 1 ? n.y : n.z;
        const double lo = i == 0 ? outer.lo.x : i == 1 ? outer.lo.y : outer.lo.z;
        const double hi = i == 0 ? outer.hi.x : i == 1 ? outer.hi.y : outer.hi.z;
        most += along > 0 ? along * hi : along * lo;
    }
    return most <= clip.s;
}

}  // namespace glint::povray
