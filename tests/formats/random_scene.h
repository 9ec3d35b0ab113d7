// SPDX-License-Identifier: Apache-2.0
#pragma once
// Random scenes with all kinds of items, and with numbers and names that are hard to write and read.
#include <random>
#include <string>

#include "glint/glint.h"

namespace glint::test {

/// Most of its scenes are valid.
class RandomScene {
  public:
    explicit RandomScene(unsigned seed) : random_(seed) {}

    Scene make() {
        Scene s;
        apply_profile(s, profile_names()[pick(profile_names().size())]);
        s.background = color();
        make_camera(s);
        for (std::size_t n = pick(5), i = 0; i < n; ++i) make_light(s);
        for (std::size_t n = 1 + pick(6), i = 0; i < n; ++i) make_material(s);
        for (std::size_t n = pick(4), i = 0; i < n; ++i) s.transforms.push_back(map());
        for (std::size_t n = 1 + pick(20), i = 0; i < n; ++i) make_shape(s);
        if (!often()) make_fog(s);
        if (!often()) make_sky(s);
        if (pick(3) == 0) {
            for (std::uint32_t i = 0; i < s.shapes.size(); ++i)
                if (often()) s.set_shape_color(i, color());
        }
        return s;
    }

  private:
    std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }
    double between(double a, double b) { return std::uniform_real_distribution<double>(a, b)(random_); }
    bool often() { return pick(3) != 0; }

    double coordinate() {
        static constexpr double odd[] = {0, -0.0, 5e-324, -5e-324, 2.2250738585072014e-308, 1e-300, 0.1,
                                         1, 1e12, -1e12,  1e11,    123456789.123456789,     1.0 / 3};
        return often() ? between(-3, 3) : odd[pick(std::size(odd))];
    }
    double length() {
        static constexpr double odd[] = {5e-324, 1e-12, 1, 0.1, 5000, 1e12};
        return often() ? between(0.1, 1) : odd[pick(std::size(odd))];
    }
    double channel() {
        static constexpr double odd[] = {0, -0.0, 1, 5e-324, 1e6, -1e6, 2, -1, 0.8, 200 / 255.0, 255.0};
        return often() ? between(0, 1) : odd[pick(std::size(odd))];
    }
    double fraction() {
        static constexpr double odd[] = {0, -0.0, 1, 5e-324, 0.1};
        return often() ? between(0, 1) : odd[pick(std::size(odd))];
    }
    void make_fog(Scene& s) {
        Fog fog;
        fog.kind = static_cast<FogKind>(pick(3));
        fog.color = color();
        fog.start = often() ? between(-3, 3) : 0;
        if (fog.has_density()) fog.density = length();
        if (fog.has_end()) fog.end = fog.start + between(0.1, 9);
        fog.transmit = often() ? 0 : fraction();
        fog.filter = often() ? 0 : fraction();
        s.fog = fog;
    }
    void make_sky(Scene& s) {
        BackgroundGradient gradient;
        gradient.kind = static_cast<GradientKind>(pick(2));
        gradient.up = direction();
        gradient.bottom = between(-3, 3);
        gradient.top = gradient.bottom + between(0.1, 9);
        gradient.bottom_color = color();
        gradient.top_color = color();
        gradient.repeats = often();
        s.gradient = gradient;
        Occlusion occlusion;
        occlusion.method = static_cast<OcclusionMethod>(pick(2));
        occlusion.samples = 1 + static_cast<std::int32_t>(pick(4096));
        occlusion.color = color();
        if (often()) occlusion.reach = length();
        occlusion.direct = often() ? between(0, 2) : 1;
        s.occlusion = occlusion;
    }
    Vec3 point() { return {coordinate(), coordinate(), coordinate()}; }
    Quartic quartic() {
        Quartic q;
        q.coefficients[pick(34)] = 1;
        for (double& c : q.coefficients) {
            if (pick(3) == 0) c = coordinate();
        }
        if (q.coefficients[3] == 0) q.coefficients[3] = -0.5;
        return q;
    }
    Vec3 direction() {
        Vec3 d = point();
        if (d == Vec3{0, 0, 0}) d.y = 1;
        return d;
    }
    Color color() {
        const double gray = channel();
        return pick(3) == 0 ? Color{gray, gray, gray} : Color{channel(), channel(), channel()};
    }
    Color tint() {
        Color c = color();
        for (double* x : {&c.r, &c.g, &c.b}) *x = *x < 0 ? -*x : *x;
        return c;
    }
    std::string name() {
        static const std::string odd[] = {"ball",
                                          "a b",
                                          "\"",
                                          "\\",
                                          "new\nline",
                                          "#hash",
                                          "// no comment",
                                          "{",
                                          "\xc3\xa9t\xc3\xa9",
                                          "\xff\xfe",
                                          std::string("nul\0x", 5),
                                          "none",
                                          "true",
                                          "x",
                                          "1x",
                                          "-x",
                                          "material_1",
                                          "\x7f\x01\t",
                                          "'",
                                          "/* a */",
                                          "all",
                                          "\xe2\x82\xac",
                                          std::string(300, 'n')};
        return odd[pick(std::size(odd))];
    }
    void note(ItemTexts& texts, std::size_t index) {
        if (pick(3) == 0) texts.names[static_cast<std::uint32_t>(index)] = name();
    }

    void make_camera(Scene& s) {
        Camera& c = s.camera;
        c.projection = static_cast<Projection>(pick(2));
        c.position = point();
        c.look_at = {between(-1, 1), between(-1, 1), between(-1, 1)};
        c.up = {between(-1, 1), 5, between(-1, 1)};
        c.fov_axis = static_cast<FovAxis>(pick(2));
        c.fov_degrees = pick(4) == 0 ? 5e-324 : between(0.1, 179.9);
        c.width = length();
        if (pick(3) == 0)
            c.frame = CameraFrame{{between(1, 2), -0.0, 0.1}, {0, -1, between(0, 1)}, {0.1, 0, -1}};
        if (pick(3) == 0) c.lighting_eye = point();
    }
    void make_light(Scene& s) {
        Light l;
        l.kind = static_cast<LightKind>(pick(k_light_kinds));
        l.position = point();
        l.to_light = direction();
        l.color = color();
        l.specular_color = pick(2) == 0 ? l.color : color();
        if (pick(2) == 0) l.attenuation = {length(), fraction(), fraction()};
        if (pick(2) == 0) l.fade_distance = length(), l.fade_power = 3 * fraction();
        l.axis = direction();
        if (pick(2) == 0) l.outer_angle = between(1, 180), l.inner_angle = l.outer_angle * fraction();
        if (pick(2) == 0) l.tightness = 1e9 * fraction();
        l.side_u = {length(), 0, 0}, l.side_v = {fraction(), length(), -fraction()};
        if (pick(2) == 0) l.radius = length();
        if (pick(2) == 0) l.samples_u = 1 + static_cast<std::int32_t>(pick(64)), l.samples_v = 64;
        l.one_sided = pick(2) == 0, l.jitter = pick(2) == 0, l.cone = pick(4) == 0;
        if (pick(2) == 0) l.adaptive = static_cast<std::int32_t>(pick(17));
        l.casts_shadows = pick(4) != 0;
        note(s.light_texts, s.lights.size());
        s.lights.push_back(l);
    }
    void make_material(Scene& s) {
        Material m;
        if (often()) {
            m.color = color();
            m.ambient = pick(2) == 0 ? m.color * fraction() : color();
            m.diffuse = pick(2) == 0 ? m.color * 0.7 : color();
            m.specular = pick(2) == 0 ? m.color * channel() : color();
            m.shininess = pick(2) == 0 ? 40 : 1e9 * fraction();
            m.mirror = fraction();
            m.casts_shadow = pick(4) != 0;
            m.mirror_tint = pick(2) == 0 ? Color{1, 1, 1} : tint();
            m.transmission = fraction();
            m.ior = often() ? 1.5 : length();
            if (m.ior > 1e6) m.ior = 1e6;
            m.transmission_tint = pick(2) == 0 ? Color{1, 1, 1} : tint();
            make_extended(m);
        }
        if (pick(4) == 0 && !s.materials.empty()) m = s.materials[pick(s.materials.size())];
        note(s.material_texts, s.materials.size());
        s.materials.push_back(m);
    }
    void make_extended(Material& m) {
        if (pick(2) == 0) m.emission = pick(2) == 0 ? m.color * channel() : color();
        if (pick(4) == 0) m.brilliance = 1e9 * fraction();
        if (pick(4) == 0) m.metallic = fraction();
        if (pick(4) == 0) m.phong = color(), m.phong_shininess = 1e9 * fraction();
        m.tinted_highlight = pick(4) != 0;
        if (pick(4) == 0) m.mirror_falloff = 1e9 * fraction(), m.mirror_min = fraction();
        if (pick(4) == 0) m.mirror_metallic = fraction();
        if (pick(4) == 0) m.angled_opacity = true;
        if (pick(4) == 0) m.outline = fraction(), m.outline_width = fraction();
        if (pick(4) == 0) m.hollow = true;
        if (pick(4) == 0) m.one_sided = true;
        if (pick(4) == 0) m.refracts = true;
        if (pick(4) == 0) m.mirror_fresnel = true;
        if (pick(4) == 0) m.conserve_energy = true;
        if (pick(4) == 0) m.fade_distance = length(), m.fade_power = 1e9 * fraction();
        if (pick(4) == 0) m.fade_color = {fraction(), fraction(), 1};
        if (pick(4) == 0) m.caustics = length();
        if (pick(4) == 0) m.interior = static_cast<std::int32_t>(pick(1000)) + 1;
        if (pick(3) == 0) {
            m.transmission = 0;
            if (!m.angled_opacity) m.filter = 0.5 * fraction();
            m.transmit = 0.5 * fraction();
        }
    }
    Affine map() {
        Affine m;
        if (pick(4) == 0) return {{{1, 0, 0, coordinate()}, {0, 1, 0, coordinate()}, {0, 0, 1, 1}}};
        if (pick(6) == 0) return m;
        if (pick(4) == 0) return {{{0.3, 0, 0, 0}, {0, 0.3, 0, 0}, {0, 0, 0.3, 0}}};
        if (pick(4) == 0) return {{{0.3, 0, 0, -0.0}, {0, 2, 0, 0}, {0, 0, 5, 0}}};
        for (int r = 0; r < 3; ++r) {
            for (int c = 0; c < 4; ++c) m.m[r][c] = between(-0.2, 0.2) + (r == c ? 1 : 0);
            m.m[r][3] = pick(2) == 0 ? coordinate() : -0.0;
        }
        return m;
    }
    void make_shape(Scene& s) {
        const std::uint32_t material =
            pick(4) == 0 ? k_none : static_cast<std::uint32_t>(pick(s.materials.size()));
        const std::uint32_t transform = s.transforms.empty() || pick(2) == 0
                                            ? k_none
                                            : static_cast<std::uint32_t>(pick(s.transforms.size()));
        note(s.shape_texts, s.shapes.size());
        const bool caps = pick(2) == 0;
        switch (static_cast<ShapeKind>(pick(k_shape_kinds))) {
            case ShapeKind::sphere:
                s.add(Sphere{point(), length()}, material, transform);
                break;
            case ShapeKind::plane:
                s.add(Plane{point(), direction()}, material, transform);
                break;
            case ShapeKind::cylinder:
                s.add(Cylinder{{0, 0, between(0, 1)}, {between(1, 2), 0, coordinate()}, length(), caps},
                      material, transform);
                break;
            case ShapeKind::cone:
                s.add(Cone{{0, 0, between(0, 1)},
                           {between(1, 2), 0, coordinate()},
                           length(),
                           pick(2) == 0 ? 0 : length(),
                           caps},
                      material, transform);
                break;
            case ShapeKind::disc:
                s.add(Disc{point(), direction(), length()}, material, transform);
                if (Disc& disc = s.get<Disc>().back(); pick(2) == 0) disc.hole = disc.radius * 0.75;
                break;
            case ShapeKind::torus:
                s.add(Torus{point(), direction(), length(), length()}, material, transform);
                break;
            case ShapeKind::quadric:
                s.add(Quadric{point(), direction(), pick(2) == 0 ? point() : Vec3{}, coordinate()}, material,
                      transform);
                break;
            case ShapeKind::quartic:
                s.add(quartic(), material, transform);
                break;
            case ShapeKind::box:
                s.add(Box{{-1, -0.0, between(-1, 0)}, {between(0, 1), 5e-324, 1}}, material, transform);
                break;
            case ShapeKind::triangle:
                s.add(Triangle{{point(), point(), point()}}, material, transform);
                break;
            case ShapeKind::smooth_triangle:
                s.add(SmoothTriangle{{point(), point(), point()}, {direction(), direction(), direction()}},
                      material, transform);
                break;
            case ShapeKind::polygon: {
                const auto count = static_cast<std::uint32_t>(3 + pick(8));
                const auto first = static_cast<std::uint32_t>(s.polygon_vertices.size());
                for (std::uint32_t i = 0; i < count; ++i) s.polygon_vertices.push_back(point());
                s.add(Polygon{first, count}, material, transform);
                break;
            }
            case ShapeKind::solid:
                make_solid(s, material, transform);
                break;
            case ShapeKind::mesh:
                if (s.meshes.empty() || pick(2) == 0) make_mesh(s);
                s.add(Mesh{static_cast<std::uint32_t>(pick(s.meshes.size()))}, material, transform);
                break;
        }
    }
    // Of operands of all kinds, and of solids.
    void make_solid(Scene& s, std::uint32_t material, std::uint32_t transform, int depth = 0) {
        const auto first = static_cast<std::uint32_t>(s.shapes.size());
        const std::size_t count = 1 + pick(3);
        const auto some = [&](std::size_t n) {
            return n == 0 || pick(2) == 0 ? k_none : static_cast<std::uint32_t>(pick(n));
        };
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t own = some(s.materials.size()), map = some(s.transforms.size());
            switch (pick(depth < 3 ? 8 : 7)) {
                case 0:
                    s.add(Sphere{point(), length()}, own, map);
                    break;
                case 1:
                    s.add(Plane{point(), direction()}, own, map);
                    break;
                case 2:
                    s.add(Cylinder{{0, 0, 0}, {1, 0, coordinate()}, length(), true}, own, map);
                    break;
                case 3:
                    s.add(Torus{point(), direction(), length(), length()}, own, map);
                    break;
                case 4:
                    s.add(Box{{-1, -1, -1}, {0, 2, 1}}, own, map);
                    break;
                case 5:
                    if (pick(2) == 0) {
                        s.add(quartic(), own, map);
                    } else {
                        s.add(Quadric{direction(), point(), point(), coordinate()}, own, map);
                    }
                    break;
                case 6:
                    make_tetrahedron(s);
                    s.add(Mesh{static_cast<std::uint32_t>(s.meshes.size() - 1)}, own, map);
                    break;
                default:
                    make_solid(s, own, map, depth + 1);
            }
        }
        const auto operation = static_cast<SolidOperation>(1 + pick(count == 1 ? 6 : 4));
        combine_last(s, operation == SolidOperation::inverse && count > 1 ? SolidOperation::merge : operation,
                     first, material, transform);
    }
    void make_tetrahedron(Scene& s) {
        MeshData mesh;
        for (int i = 0; i < 4; ++i) mesh.positions.push_back(point());
        mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
        s.meshes.push_back(std::make_shared<const MeshData>(std::move(mesh)));
    }
    void make_mesh(Scene& s) {
        const auto single = [](Vec3 v) {
            return Float3{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
        };
        MeshData mesh;
        const std::size_t vertices = 1 + pick(6);
        const bool is_single = pick(2) == 0, is_smooth = pick(2) == 0;
        for (std::size_t i = 0; i < vertices; ++i) {
            if (is_single) {
                mesh.single_positions.push_back(single(point()));
            } else {
                mesh.positions.push_back(point());
            }
            if (is_smooth) mesh.normals.values.push_back(pick(3) == 0 ? Float3{} : single(direction()));
        }
        const auto corners = [&](std::size_t below) {
            const auto corner = [&] { return static_cast<std::uint32_t>(pick(below)); };
            return TriangleCorners{corner(), corner(), corner()};
        };
        for (std::size_t i = 0; i < 1 + pick(4); ++i) mesh.triangles.push_back(corners(vertices));
        if (is_smooth && pick(2) == 0) {
            for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
                mesh.normals.corners.push_back(corners(vertices));
        }
        if (pick(2) == 0) {
            const bool by_vertex = pick(2) == 0;
            const std::size_t colors = by_vertex ? vertices : 1 + pick(4);
            for (std::size_t i = 0; i < colors; ++i) {
                const Color c = color();
                mesh.colors.values.push_back(single({c.r, c.g, c.b}));
            }
            for (std::size_t i = 0; !by_vertex && i < mesh.triangles.size(); ++i) {
                constexpr std::uint32_t none = CornerValues::k_none;
                mesh.colors.corners.push_back(pick(4) == 0 ? TriangleCorners{none, none, none}
                                                           : corners(colors));
            }
        }
        s.meshes.push_back(std::make_shared<const MeshData>(std::move(mesh)));
    }

    std::mt19937 random_;
};

}  // namespace glint::test
