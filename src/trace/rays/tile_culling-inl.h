// SPDX-License-Identifier: Apache-2.0
// Tile culling: a tile is empty if the frustum of its camera rays overlaps no box of the hierarchy.
#if defined(GLINT_TRACE_TILE_CULLING_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef GLINT_TRACE_TILE_CULLING_INL_H_
#undef GLINT_TRACE_TILE_CULLING_INL_H_
#else
#define GLINT_TRACE_TILE_CULLING_INL_H_
#endif

#include "simd/vec3-inl.h"
#include "trace/rays/camera_rays-inl.h"
#include "trace/tile.h"
#include "world/world.h"

HWY_BEFORE_NAMESPACE();
namespace glint {
namespace HWY_NAMESPACE {

/// The frustum of a tile's camera rays: four planes through the camera, with the frustum on their negative
/// sides.
struct TileFrustum {
    Vec3 apex;
    Vec3 outward[4];  // plane normals, scaled to a largest coordinate of 1
    bool exists = false;
};

/// The frustum of a tile's rays, enlarged by one pixel on each side. It does not exist for views so narrow
/// that rounding could turn its planes.
inline TileFrustum tile_frustum(const WorldParts& world, const TileJob& job) {
    const PreparedCamera& camera = world.camera;
    const double left = job.x - 1.0, top = job.y - 1.0;
    const SampleIndex first{0, 0, world.settings.samples};
    const auto corner = [&](int i, int j) {
        const PixelSample where = world.conventions.pixel_sample;
        const double x =
            viewport_x(world.settings, where, left + i * (job.width + 2.0), sample_x(where, first));
        const double y =
            viewport_y(world.settings, where, top + j * (job.height + 2.0), sample_y(where, first));
        return viewport_ray(camera, x, y).direction;
    };
    const Vec3 corners[4] = {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
    const Vec3 middle = corners[0] + corners[1] + corners[2] + corners[3];
    TileFrustum frustum;
    frustum.apex = camera.position;
    for (int i = 0; i < 4; ++i) {
        const Vec3 a = corners[i], b = corners[(i + 1) % 4], n = glint::cross(a, b);
        const double size = max_abs(Vector3<double>{n.x, n.y, n.z});
        if (!(size > 1e-6 * (glint::dot(a, a) + glint::dot(b, b)))) return frustum;
        frustum.outward[i] = n * ((glint::dot(n, middle) > 0 ? -1 : 1) / size);
    }
    frustum.exists = true;
    return frustum;
}

/// The boxes of a vector that may overlap the frustum: those that are not certainly outside one of its
/// planes. The rounding errors of the slab expression and of this test are below 1e-6 of the coordinates; the
/// margin is ten times as large.
HWY_INLINE LaneMask<float> may_overlap(const TileFrustum& frustum, const float* const lo[3],
                                       const float* const hi[3]) {
    auto outside = Floats(0) > Floats(0);
    for (const Vec3& n : frustum.outward) {
        const double normal[3] = {n.x, n.y, n.z};
        const double apex[3] = {frustum.apex.x, frustum.apex.y, frustum.apex.z};
        Floats least(0), size(0);  // the smallest distance from the plane, and the size of its terms
        for (int a = 0; a < 3; ++a) {
            const Floats na(static_cast<float>(normal[a])), o(static_cast<float>(apex[a]));
            const Floats low = load(lo[a]), high = load(hi[a]);
            least += na * ((normal[a] > 0 ? low : high) - o);
            size += abs(na) * (abs(low) + abs(high) + abs(o));
        }
        outside = outside || least > size * Floats(1e-5f);
    }
    return !outside;
}

/// Whether no camera ray of the tile can hit a shape. An early-out: false if this is not certain after a few
/// nodes.
inline bool is_tile_empty(const WorldParts& world, const TileJob& job) {
    constexpr int max_nodes = 64, max_stack = max_nodes * (k_bvh_width - 1) + 1;
    const PackedGeometry& geometry = *world.geometry;
    if (world.camera.projection == Projection::orthographic || geometry.bounded != geometry.first_operand() ||
        world.fault == TracerFault::behind_start)
        return false;
    if (geometry.bvh.nodes.empty()) return true;
    const TileFrustum frustum = tile_frustum(world, job);
    if (!frustum.exists) return false;
    std::uint32_t stack[max_stack];
    int count = 0;
    stack[count++] = 0;
    for (int visited = 0; count > 0; ++visited) {
        if (visited == max_nodes) return false;
        const BvhNode& node = geometry.bvh.nodes[stack[--count]];
        for (int c = 0; c < k_bvh_width; c += lane_count<float>()) {
            const float* lo[3] = {node.lo[0] + c, node.lo[1] + c, node.lo[2] + c};
            const float* hi[3] = {node.hi[0] + c, node.hi[1] + c, node.hi[2] + c};
            for (std::uint32_t bits = to_bits(may_overlap(frustum, lo, hi)); bits != 0; bits &= bits - 1) {
                const BvhChild child = node.child[c + __builtin_ctz(bits)];
                if (child.is_none()) continue;
                if (child.is_leaf()) return false;
                stack[count++] = child.index();
            }
        }
    }
    return true;
}

}  // namespace HWY_NAMESPACE
}  // namespace glint
HWY_AFTER_NAMESPACE();

#endif
