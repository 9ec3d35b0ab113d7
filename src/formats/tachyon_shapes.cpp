// SPDX-License-Identifier: Apache-2.0
// Tachyon's shapes.
#include <fmt/format.h>

#include <utility>

#include "base/text.h"
#include "formats/tachyon_reader.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint {
namespace {

constexpr Range k_count{0, 4e9, false, false, "a whole number from 0 to 4e9"};
// With a radius of 0 nothing is seen; programs write such shapes.
constexpr Range k_radius{0, k_length.max, false, false, k_length.text};
// Half the length of an endless cylinder, in its radii.
constexpr double k_endless = 1e6;
// The height of the cone that stands for a ring with a hole, in its widths: its normals are off by this
// angle.
constexpr double k_ring_height = 1e-6;

// The largest of the numbers over the smallest.
double spread(const double (&numbers)[3]) {
    return number::max(number::max(numbers[0], numbers[1]), numbers[2]) /
           number::min(number::min(numbers[0], numbers[1]), numbers[2]);
}

Color mean(const Color& a, const Color& b, const Color& c) { return (a + b + c) * (1.0 / 3); }

}  // namespace

template <class T> void TachyonReader::add(const T& shape, std::uint32_t material) {
    note(scene_.shape_texts, scene_.shapes.size(), source_place(text_, object_));
    scene_.add(shape, material);
    if (scene_.shapes.size() % 4096 == 0) reading_.memory.count(scene_);
}

void TachyonReader::add_smooth(const SmoothTriangle& t, std::uint32_t material) {
    const auto& n = t.normals;
    if (is_zero(n[0]) || is_zero(n[1]) || is_zero(n[2])) {
        // It would have no light at such a vertex.
        reading_.diagnostics.warn_once(
            "tachyon normal", text_.place, object_.offset, object_.length,
            "a vertex has the normal 0 0 0: triangles with such a vertex are drawn flat");
        return add(Triangle{{t.vertices[0], t.vertices[1], t.vertices[2]}}, material);
    }
    const double squares[] = {dot(n[0], n[0]), dot(n[1], n[1]), dot(n[2], n[2])};
    if (spread(squares) > 1.04) note_limit(TachyonLimit::normal_lengths, object_);  // by more than 2%
    add(t, material);
}

bool TachyonReader::read_triangle() {
    Triangle t;
    std::uint32_t material = k_none;
    if (!point("V0", "V0", t.vertices[0]) || !point("V1", "V1", t.vertices[1]) ||
        !point("V2", "V2", t.vertices[2]) || !texture(material)) {
        return false;
    }
    add(t, material);
    return true;
}

bool TachyonReader::read_smooth_triangle() {
    SmoothTriangle t;
    std::uint32_t material = k_none;
    if (!point("V0", "V0", t.vertices[0]) || !point("V1", "V1", t.vertices[1]) ||
        !point("V2", "V2", t.vertices[2]) || !point("N0", "N0", t.normals[0]) ||
        !point("N1", "N1", t.normals[1]) || !point("N2", "N2", t.normals[2]) || !texture(material)) {
        return false;
    }
    add_smooth(t, material);
    return true;
}

bool TachyonReader::read_colored_triangle() {
    SmoothTriangle t;
    Color c[3];
    if (!point("V0", "V0", t.vertices[0]) || !point("V1", "V1", t.vertices[1]) ||
        !point("V2", "V2", t.vertices[2]) || !point("N0", "N0", t.normals[0]) ||
        !point("N1", "N1", t.normals[1]) || !point("N2", "N2", t.normals[2]) || !color("C0", "C0", c[0]) ||
        !color("C1", "C1", c[1]) || !color("C2", "C2", c[2])) {
        return false;
    }
    scanner_.accept("TEXTURE");
    TachyonTexture read;
    if (!texture_body(read, true)) return false;
    read.color = mean(c[0], c[1], c[2]);
    if (!(c[0] == c[1] && c[1] == c[2])) note_limit(TachyonLimit::vertex_colors, object_);
    add_smooth(t, material_of(read, object_));
    return true;
}

bool TachyonReader::read_vertices() {
    double count = 0;
    if (!expect("NUMVERTS", "Numverts") || !whole_number(count, k_count)) return false;
    const auto read_points = [&](CountedVector<Vec3>& list) {
        list.clear();
        const std::size_t most = scanner_.at_most(count);
        if (reading_.memory.has_room(MemoryBudget::list_bytes(most, sizeof(Vec3)))) list.reserve(most);
        for (double left = count; left > 0; --left) {
            Vec3 v;
            if (!point(v) || !go_on()) return false;
            list.push_back(v);
        }
        return true;
    };
    if (!expect("COORDS", "Coords") || !read_points(coordinates_) || !expect("NORMALS", "Normals") ||
        !read_points(normals_)) {
        return false;
    }
    colors_.clear();
    vertex_texture_ = {};
    std::uint32_t material = k_none;
    while (!scanner_.accept("END_VERTEXARRAY")) {
        if (scanner_.accept("COLORS")) {
            colors_.clear();
            for (double left = count; left > 0; --left) {
                Color c;
                if (!color(c) || !go_on()) return false;
                colors_.push_back(c);
            }
        } else if (scanner_.accept("TEXTURE")) {
            vertex_texture_ = {};
            material = k_none;
            if (!texture_body(vertex_texture_, false)) return false;
        } else if (scanner_.accept("TRIMESH") ? !read_facets(material, false)
                   : scanner_.accept("TRISTRIP")
                       ? !read_facets(material, true)
                       : !expected("`Colors`, `Texture`, `TriMesh`, `TriStrip` or `End_VertexArray`")) {
            return false;
        }
        if (reading_.diagnostics.full()) return false;
    }
    return true;
}

// A large mesh would move the lists several times, with twice their memory at the last time.
void TachyonReader::reserve_triangles(std::size_t count) {
    auto& list = scene_.get<SmoothTriangle>();
    if (count <= scene_.shapes.size()) return;
    constexpr std::uint64_t k_bytes = sizeof(SmoothTriangle) + sizeof(Shape) + sizeof(SourcePlace);
    if (!reading_.memory.has_room(MemoryBudget::list_bytes(count, k_bytes))) return;
    list.reserve(list.size() + count);
    scene_.shapes.reserve(scene_.shapes.size() + count);
    scene_.shape_texts.places.reserve(scene_.shapes.size() + count);
}

// The triangles of a mesh: three indices each. Of a strip: each index makes one with the two before it.
bool TachyonReader::read_facets(std::uint32_t& material, bool is_strip) {
    const Range index_range{0, number::max(0.0, static_cast<double>(coordinates_.size()) - 1), false, false,
                            "the index of a vertex, from 0"};
    double count = 0;
    if (!whole_number(count, k_count)) return false;
    if (material == k_none) material = material_of(vertex_texture_, object_);
    std::size_t corners[3] = {};
    const auto add_facet = [&](std::size_t a, std::size_t b, std::size_t c) {
        const SmoothTriangle t{{coordinates_[a], coordinates_[b], coordinates_[c]},
                               {normals_[a], normals_[b], normals_[c]}};
        if (colors_.empty()) return add_smooth(t, material);
        TachyonTexture colored = vertex_texture_;
        colored.color = mean(colors_[a], colors_[b], colors_[c]);
        if (!(colors_[a] == colors_[b] && colors_[b] == colors_[c]))
            note_limit(TachyonLimit::vertex_colors, object_);
        add_smooth(t, material_of(colored, object_));
    };
    const auto read_corner = [&](std::size_t& corner) {
        double index = 0;
        if (coordinates_.empty()) return expected("a vertex array that has vertices");
        if (!whole_number(index, index_range)) return false;
        corner = static_cast<std::size_t>(index);
        return true;
    };
    if (!is_strip) {
        reserve_triangles(scanner_.at_most(count));
        for (double left = count; left > 0; --left) {
            if (!read_corner(corners[0]) || !read_corner(corners[1]) || !read_corner(corners[2]) || !go_on())
                return false;
            add_facet(corners[0], corners[1], corners[2]);
        }
        return true;
    }
    for (double k = 0; k < count; ++k) {
        corners[0] = corners[1];
        corners[1] = corners[2];
        if (!read_corner(corners[2]) || !go_on()) return false;
        if (k < 2) continue;
        const bool is_odd = static_cast<std::uint64_t>(k) % 2 != 0;
        if (is_odd) {
            add_facet(corners[1], corners[0], corners[2]);
        } else {
            add_facet(corners[0], corners[1], corners[2]);
        }
    }
    return true;
}

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
    if (!expect("POINTS", "Points") || !whole_number(count, k_count)) return false;
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
    if (!(spread(sides) < 1 + 1e-6)) note_limit(TachyonLimit::box_normals, object_);
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
