// SPDX-License-Identifier: Apache-2.0
// The objects that contain the camera, and those that refract.
#include "world/appearance/interiors.h"

#include <algorithm>
#include <array>
#include <span>
#include <tuple>

#include "math/number.h"
#include "world/appearance/appearance.h"
#include "world/geometry/contains.h"

namespace glint {
namespace {

// What the camera rays start from: a point, or a rectangle.
struct CameraOrigins {
    std::array<Vec3, 4> points;
    std::size_t count = 1;
    explicit CameraOrigins(const PreparedCamera& camera) : points{camera.position} {
        if (camera.projection != Projection::orthographic) return;
        const Vec3 x = camera.right * 0.5, y = camera.up * 0.5, at = camera.position;
        points = {at - x - y, at - x + y, at + x - y, at + x + y};
        count = 4;
    }
    std::span<const Vec3> all() const { return {points.data(), count}; }
    // Whether the box of the points meets a shape's.
    bool meet(const PackedGeometry& geometry, std::uint32_t slot) const {
        for (int a = 0; a < 3; ++a) {
            double low = number::k_infinity, high = -number::k_infinity;
            for (const Vec3 point : all()) {
                const double p[] = {point.x, point.y, point.z};
                low = number::min(low, p[a]);
                high = number::max(high, p[a]);
            }
            if (!(geometry.box_lo[a][slot] <= high && low <= geometry.box_hi[a][slot])) return false;
        }
        return true;
    }
};

// Of a convex shape, all of a rectangle is inside if its corners are.
bool is_convex(ShapeKind kind) {
    return kind != ShapeKind::torus && kind != ShapeKind::quadric && kind != ShapeKind::quartic &&
           kind != ShapeKind::solid;
}

void find_camera_interiors(const WorldParts& parts, Interiors& found) {
    const PackedGeometry& geometry = *parts.geometry;
    const CameraOrigins origins(parts.camera);
    for (const ShapeClass& shapes : geometry.classes) {
        if (shapes.first >= geometry.first_operand()) break;
        const bool is_space = shapes.kind == ShapeKind::plane;
        for (std::uint32_t item = 0; item < shapes.count; ++item) {
            const std::uint32_t slot = shapes.first + item;
            if (slot < geometry.boxed && !origins.meet(geometry, slot)) continue;
            if (geometry.is_open(geometry.surface_of(slot)) && !is_space) continue;
            if (interior_word(parts, geometry.surface_of(slot)) == 0) continue;
            std::size_t inside = 0;
            for (const Vec3 point : origins.all()) inside += contains(geometry, slot, point);
            if (inside == origins.count && (is_convex(shapes.kind) || origins.count == 1)) {
                const std::uint32_t word = interior_word(parts, geometry.surface_of(slot));
                found.camera ^= word;
                if (!refracts(parts, geometry.surface_of(slot))) found.unbent ^= word;
            } else if (inside > 0 || (origins.count > 1 && !is_space)) {
                found.cutting.push_back(slot);
            }
        }
    }
}

void find_refracting(const WorldParts& parts, Interiors& found) {
    const PackedGeometry& geometry = *parts.geometry;
    auto& all = found.refracting;
    for (std::uint32_t slot = 0; slot < geometry.count; ++slot) {
        const SurfaceId id = geometry.surface_of(slot);
        if (!refracts(parts, id)) continue;
        const std::uint32_t row = material_row(parts, id);
        const bool hollow = parts.extended_row(row)[k_extended_value<&Material::hollow>] > 0;
        all.push_back({interior_word(parts, id), parts.material(row)[k_ior], hollow});
        found.has_hollow = found.has_hollow || hollow;
    }
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
        return std::tie(a.word, a.ior, a.hollow) < std::tie(b.word, b.ior, b.hollow);
    });
    all.erase(std::unique(all.begin(), all.end()), all.end());
}

bool has_glass(const WorldParts& parts) {
    for (std::size_t at = k_transmission; at < parts.materials->size(); at += k_material_values) {
        if ((*parts.materials)[at] > 0) return true;
    }
    return false;
}

}  // namespace

void find_interiors(WorldParts& parts) {
    Interiors& found = parts.interiors;
    find_camera_interiors(parts, found);
    if (parts.uses<&Material::refracts>()) find_refracting(parts, found);
    found.tracked =
        found.camera != 0 || !found.cutting.empty() || parts.has_transparency() || has_glass(parts);
}

std::uint32_t camera_interiors_at(const WorldParts& parts, Vec3 origin) {
    const PackedGeometry& geometry = *parts.geometry;
    std::uint32_t interiors = parts.interiors.camera;
    for (const std::uint32_t slot : parts.interiors.cutting) {
        if (contains(geometry, slot, origin)) interiors ^= interior_word(parts, geometry.surface_of(slot));
    }
    return interiors;
}

}  // namespace glint
