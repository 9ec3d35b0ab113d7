// SPDX-License-Identifier: Apache-2.0
// Tachyon's shapes but triangles.
#include <fmt/format.h>

#include <utility>

#include "base/text.h"
#include "formats/tachyon_reader.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint {
namespace {

// With a radius of 0 nothing is seen; programs write such shapes.
constexpr Range k_radius{0, k_length.max, false, false, k_length.text};
// Half the length of an endless cylinder, in its radii.
constexpr double k_endless = 1e6;
// The height of the cone that stands for a ring with a hole, in its widths: its normals are off by this
// angle.
constexpr double k_ring_height = 1e-6;

}  // namespace

bool TachyonReader::read_sphere() {
    Sphere s;
    std::uint32_t material = k_none;
    if (!point("CENTER", "Center", s.center) || !number("RAD", "Rad", s.radius, k_radius) ||
        !texture(material)) {
        return false;
    }
    if (s.radius > 0) add(s, material);
    return true;
}

// Without caps. Programs write a few of no length, which show nothing.
bool TachyonReader::read_finite_cylinder() {
    Cylinder c;
    std::uint32_t material = k_none;
    if (!point("BASE", "Base", c.from) || !point("APEX", "Apex", c.to) ||
        !number("RAD", "Rad", c.radius, k_radius) || !texture(material)) {
        return false;
    }
    if (c.from != c.to && c.radius > 0) add(c, material);
    return true;
}

bool TachyonReader::read_cylinder() {
    Vec3 center, axis;
    double radius = 0;
    std::uint32_t material = k_none;
    if (!point("CENTER", "Center", center) || !expect("AXIS", "Axis") || !direction(axis) ||
        !number("RAD", "Rad", radius, k_radius) || !texture(material)) {
        return false;
    }
    if (radius == 0) return true;
    note_limit(TachyonLimit::endless_cylinder, object_);
    const Vec3 half = normalize(axis) * (k_endless * radius);
    add(Cylinder{center - half, center + half, radius, false}, material);
    return true;
}

bool TachyonReader::read_polycylinder() {
    double count = 0, radius = 0;
    if (!expect("POINTS", "Points") || !whole_number(count, k_tachyon_count)) return false;
    CountedVector<Vec3> points;
    for (double left = count; left > 0; --left) {
        Vec3 p;
        if (!point(p) || !go_on()) return false;
        points.push_back(p);
    }
    std::uint32_t material = k_none;
    if (!number("RAD", "Rad", radius, k_radius) || !texture(material)) return false;
    if (radius == 0) return true;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!go_on()) return false;
        add(Sphere{points[i], radius}, material);
        if (i + 1 < points.size() && points[i] != points[i + 1])
            add(Cylinder{points[i], points[i + 1], radius, false}, material);
    }
    return true;
}

bool TachyonReader::read_ring() {
    Vec3 center, normal;
    double inner = 0, outer = 0;
    std::uint32_t material = k_none;
    if (!point("CENTER", "Center", center) || !expect("NORMAL", "Normal") || !direction(normal) ||
        !number("INNER", "Inner", inner, k_coordinate) || !number("OUTER", "Outer", outer, k_length) ||
        !texture(material)) {
        return false;
    }
    if (inner >= outer) return true;  // it has no area
    if (inner <= 0) {
        add(Disc{center, normal, outer}, material);
        return true;
    }
    const Vec3 height = normalize(normal) * ((outer - inner) * k_ring_height);
    add(Cone{center, center + height, inner, outer, false}, material);
    return true;
}

bool TachyonReader::read_plane() {
    Plane p;
    std::uint32_t material = k_none;
    if (!point("CENTER", "Center", p.point) || !expect("NORMAL", "Normal") || !direction(p.normal) ||
        !texture(material)) {
        return false;
    }
    add(p, material);
    return true;
}

bool TachyonReader::read_box() {
    Box b;
    std::uint32_t material = k_none;
    if (!point("MIN", "Min", b.min) || !point("MAX", "Max", b.max) || !texture(material)) return false;
    const auto sort = [](double& low, double& high) {
        if (high < low) std::swap(low, high);
    };
    sort(b.min.x, b.max.x);
    sort(b.min.y, b.max.y);
    sort(b.min.z, b.max.z);
    const Vec3 size = b.max - b.min;
    const double sides[] = {size.x, size.y, size.z};
    if (!(tachyon_spread(sides) < 1 + 1e-6)) note_limit(TachyonLimit::box_normals, object_);
    add(b, material);
    return true;
}

// Tachyon renders its lights as spheres, which cast no shadow.
void TachyonReader::add_light(Light light, double radius) {
    state_.lights.push_back(static_cast<std::uint32_t>(scene_.lights.size()));
    note(scene_.light_texts, scene_.lights.size(), source_place(text_, object_));
    scene_.lights.push_back(light);
    if (!light.has_position() || !(radius > 0)) return;
    note_limit(TachyonLimit::fogged_light, object_);
    Material own;
    own.color = own.ambient = light.color;
    own.diffuse = {0, 0, 0};
    own.casts_shadow = false;
    note(scene_.material_texts, scene_.materials.size(), source_place(text_, object_));
    scene_.materials.push_back(own);
    add(Sphere{light.position, radius}, static_cast<std::uint32_t>(scene_.materials.size() - 1));
}

}  // namespace glint
