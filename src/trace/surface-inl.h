// The stage between a hit and its light: point, normal, direction to the eye, material; and what of a ray
// missed.
#if defined(GLINT_TRACE_SURFACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_SURFACE_INL_H_
#undef GLINT_TRACE_SURFACE_INL_H_
#else
#define GLINT_TRACE_SURFACE_INL_H_
#endif

#include "geometry/kinds-inl.h"
#include "trace/tile.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The unit normal of a slot's shape at a point of it.
struct NormalAt {
    const ShapeClass& shapes;
    std::uint32_t item;
    Triple<double> point, normal;
    template <class Geometry> HWY_INLINE void visit() {
        double p[Geometry::k_values];
        for (int k = 0; k < Geometry::k_values; ++k) p[k] = shapes.column(k)[item];
        normal = Geometry::normal(p, point);
    }
};

/// The largest coordinate of a bounded shape: its formula's rounding is relative to that too, however near to
/// the world's origin the ray is.
HWY_INLINE double box_reach(const World& world, std::uint32_t slot) {
    float reach = 0;
    for (int a = 0; slot < world.bounded && a < 3; ++a) {
        reach = max(reach, max(-world.box_lo[a][slot], world.box_hi[a][slot]));
    }
    return reach;
}

/// Fills the hits of a TileScratch from t and slot of rays [0, count), which are rays first... of
/// scratch.rays.
inline void find_surfaces(const World& world, TileScratch& s, int first, int count) {
    const RaySpan r = s.rays.rays(first);
    s.hits = 0;
    for (int i = 0; i < count; ++i) {
        if (s.slot[i] == k_none) continue;
        const std::uint32_t slot = s.slot[i];
        const Triple<double> o{r.ox[i], r.oy[i], r.oz[i]}, d{r.dx[i], r.dy[i], r.dz[i]};
        const Triple<double> point = o + d * s.t[i];
        const ShapeClass& shapes = world.class_of(slot);
        NormalAt at{shapes, slot - shapes.first, point, {}};
        visit_geometry(shapes.kind, shapes.transformed, at);
        const bool behind = dot(at.normal, d) > 0;
        const bool turn = behind && (world.material[slot] & k_turn_normal) != 0;
        const Triple<double> n = turn ? -at.normal : at.normal;

        Triple<double> eye = -d;
        if (world.camera.has_lighting_eye && s.rays.path(first + i).branch == Branch::camera) {
            const Vec3 e = world.camera.lighting_eye;
            eye = Triple<double>{e.x, e.y, e.z} - point;
        }
        if (world.conventions.normalize) eye = normalize(eye);

        const int h = s.hits++;
        s.ray[h] = i;
        s.material[h] = world.material[slot] & k_material_index;
        s.behind[h] = behind;
        const auto put = [h](TileScratch::Column* to, const Triple<double>& v) {
            to[0][h] = v.x, to[1][h] = v.y, to[2][h] = v.z;
        };
        put(s.point, point);
        put(s.normal, n);
        put(s.incoming, d);
        put(s.to_eye, eye);
        s.magnitude[h] = max_abs(o) + max_abs(point) + box_reach(world, slot);
    }
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
