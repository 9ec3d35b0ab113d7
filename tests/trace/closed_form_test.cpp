// SPDX-License-Identifier: Apache-2.0
// Pictures whose pixels are known in closed form.
#include <gtest/gtest.h>

#include "trace/pictures.h"

namespace glint::test {
namespace {

Material shiny() {
    Material m;
    m.ambient = {0.1, 0.05, 0.2};
    m.diffuse = {0.3, 0.2, 0.6};
    m.specular = {0.4, 0.7, 0.1};
    m.shininess = 20;
    return m;
}

// The full model of one unoccluded light at a point, gated and clamped.
Layers lit(const Material& m, Color ambient, const Light& light, Vec3 p, Vec3 n, Vec3 v, bool phong) {
    const Vec3 to_light = light.way_from(p);
    const double d = std::sqrt(dot(to_light, to_light));
    const Vec3 l = to_light / d, r = n * (2 * dot(n, l)) - l, h = l + v;
    const double n_l = dot(n, l), s = phong ? dot(r, v) : dot(n, h) / std::sqrt(dot(h, h));
    const Attenuation& a = light.attenuation;
    const double f = light.has_attenuation() ? std::min(1 / (a.c0 + a.c1 * d + a.c2 * d * d), 1.0) : 1;
    Layers layers;
    layers.ambient = m.ambient * ambient;
    if (n_l > 0) layers.diffuse = m.diffuse * light.color * (f * n_l);
    if (n_l > 0 && s > 0)
        layers.specular = m.specular * light.specular_color * (f * std::pow(s, m.shininess));
    return layers;
}

TEST(ClosedForm, ASphereLitFromItsCentre) {
    Random random(71);
    for (const Offset offset : {Offset::scale, Offset::ray, Offset::facing}) {
        for (const Shading shading : {Shading::phong, Shading::blinn_phong, Shading::diffuse}) {
            for (const double radius : {1e-3, 1.0, 700.0}) {
                Scene scene;
                set_size(scene, 40, 30);
                scene.settings.shading = shading;
                scene.settings.samples = radius == 1.0 ? 3 : 1;
                scene.conventions.offset = offset;
                if (offset != Offset::scale) scene.conventions.epsilon = 1e-5;
                const Vec3 center = point_in_cube(random, radius);
                scene.camera.position = center;
                scene.camera.look_at = center + unit_direction(random);
                scene.camera.fov_degrees = 120;
                scene.lights = {ambient_light({0.5, 1, 2}), point_light(center, {0.9, 0.8, 0.7})};
                scene.lights[1].attenuation = {0.5, 0.25 / radius, 0.75 / (radius * radius)};
                scene.add(Sphere{center, radius}, add_material(scene, shiny()));
                // f_att = 1 / (0.5 + 0.25 + 0.75), N·L = S = 1.
                const Material m = shiny();
                Layers known;
                known.ambient = m.ambient * Color{0.5, 1, 2};
                known.diffuse = m.diffuse * Color{0.9, 0.8, 0.7} * (1 / 1.5);
                if (shading != Shading::diffuse)
                    known.specular = m.specular * Color{0.9, 0.8, 0.7} * (1 / 1.5);
                expect_picture(render_scene(scene), [&](int, int) { return known; });
            }
        }
    }
}

TEST(ClosedForm, APlaneUnderOneLight) {
    for (const bool phong : {true, false}) {
        Scene scene;
        set_size(scene, 97, 61);
        scene.settings.shading = phong ? Shading::phong : Shading::blinn_phong;
        scene.camera.position = {3, 5, 7};
        scene.camera.look_at = {0.5, 0.25, -1};
        scene.camera.fov_degrees = 35;
        scene.lights = {ambient_light({1, 1, 1}), point_light({-1, 2, -3}, {1, 0.9, 0.8})};
        scene.lights[1].attenuation = {0.2, 0.1, 0.05};
        const Material m = shiny();
        scene.add(Plane{{100, 0.25, 30}, {0, 2, 0}}, add_material(scene, m));
        const Image image = render_scene(scene);

        const Vec3 forward = normalize(scene.camera.look_at - scene.camera.position);
        const Vec3 x = normalize(cross(forward, scene.camera.up)), y = cross(x, forward);
        const double width = 2 * std::tan(35 * M_PI / 360), height = width * 61 / 97;
        expect_picture(image, [&](int i, int j) {
            const Vec3 d = normalize(forward + x * (width * ((i + 0.5) / 97 - 0.5)) +
                                     y * (height * (0.5 - (j + 0.5) / 61)));
            const double t = (0.25 - 5) / d.y;
            if (!(t > 0)) return Layers{};
            return lit(m, {1, 1, 1}, scene.lights[1], scene.camera.position + d * t, {0, 1, 0}, -d, phong);
        });
    }
}

// LIGHT's picture: a sphere of radius 21, one unit per pixel at whole x and y, in parallel projection, with
// highlights for an observer at a point.
TEST(ClosedForm, TheSphereOfLight) {
    const Vec3 source{5, 20, 30}, observer{40, -10, 25};
    const double k_a = 0.15, k_d = 0.5, k_s = 0.6, n = 7;
    for (const bool clamped : {true, false}) {
        for (const bool attenuated : {false, true}) {
            Scene scene;
            ASSERT_TRUE(apply_profile(scene, "light"));
            scene.conventions.clamp_cosines = clamped;
            scene.conventions.specular_gate = clamped;
            scene.camera.projection = Projection::orthographic;
            scene.camera.position = {0, 0, 50};
            scene.camera.look_at = {0, 0, 0};
            scene.camera.width = 43;
            scene.camera.lighting_eye = observer;
            scene.lights = {ambient_light({1, 1, 1}), point_light(source)};
            if (attenuated) scene.lights[1].attenuation = {0.25, 0.02, 0.0005};
            Material m;
            m.ambient = {k_a, k_a, k_a};
            m.diffuse = {k_d, k_d, k_d};
            m.specular = {k_s, k_s, k_s};
            m.shininess = n;
            scene.add(Sphere{{0, 0, 0}, 21}, add_material(scene, m));
            const Image image = render_scene(scene);
            ASSERT_EQ(image.width, 43);
            ASSERT_EQ(image.height, 43);
            int on_sphere = 0, negative = 0;
            expect_picture(image, [&](int i, int j) {
                const int x = i - 21, y = 21 - j;
                Layers layers;
                if (x * x + y * y > 21 * 21) return layers;
                ++on_sphere;
                const Vec3 p{double(x), double(y), std::sqrt(441.0 - x * x - y * y)};
                const Vec3 normal = p / 21, l = normalize(source - p), v = normalize(observer - p);
                const double d = length(source - p), cos_1 = dot(normal, l);
                const double cos_2 = dot(normal * (2 * cos_1) - l, v);
                const double f = attenuated ? std::min(1 / (0.25 + 0.02 * d + 0.0005 * d * d), 1.0) : 1;
                double diffuse = cos_1, specular = std::pow(std::fabs(cos_2), n) * (cos_2 < 0 ? -1 : 1);
                if (clamped) {
                    diffuse = std::max(cos_1, 0.0);
                    specular = cos_1 > 0 && cos_2 > 0 ? specular : 0;
                }
                negative += diffuse < 0 || specular < 0;
                const double a = k_a, b = f * k_d * diffuse, c = f * k_s * specular;
                layers.ambient = {a, a, a};
                layers.diffuse = {b, b, b};
                layers.specular = {c, c, c};
                return layers;
            });
            EXPECT_EQ(on_sphere, 1373);  // points with whole coordinates in a circle of radius 21
            EXPECT_EQ(negative > 0, !clamped);
        }
    }
}

TEST(ClosedForm, TheBigSphereIsShadedAsInDouble) {
    // The book's ground of radius 5000 beside spheres of radius 1.
    Scene scene;
    ASSERT_TRUE(apply_profile(scene, "cgfs"));
    set_size(scene, 150, 150);
    scene.settings.shadows = false;
    scene.camera.frame = CameraFrame{};
    scene.background = {1, 1, 1};
    const Material ground = shiny();
    const auto other = add_material(scene, Material{});
    const auto ground_index = add_material(scene, ground);
    for (int i = 0; i < 60; ++i)
        scene.add(Sphere{{i % 8 - 4.0, -1 + 0.3 * (i % 5), 4.0 + i}, 0.3}, other);  // NOLINT
    const auto ground_shape = scene.add(Sphere{{0, -5001, 0}, 5000}, ground_index);
    scene.lights = {ambient_light({0.2, 0.2, 0.2}), point_light({2, 1, 0}, {0.6, 0.6, 0.6})};
    const std::optional<World> world = make_world(scene);
    const Image image = render_world(*world);
    int ground_pixels = 0;
    expect_picture(
        image,
        [&](int i, int j) {
            const Vec3 d{(i - 75) / 150.0, (74 - j) / 150.0, 1};
            // The nearest sphere, in long double.
            long double best = 1e30L;
            std::size_t nearest = scene.shapes.size();
            for (std::size_t k = 0; k < scene.shapes.size(); ++k) {
                const Sphere& s = scene.get<Sphere>()[k];
                const long double qx = -s.center.x, qy = -s.center.y, qz = -s.center.z;
                const long double a = (long double)d.x * d.x + (long double)d.y * d.y + 1,
                                  b = qx * d.x + qy * d.y + qz;
                const long double c = qx * qx + qy * qy + qz * qz - (long double)s.radius * s.radius,
                                  disc = b * b - a * c;
                if (disc < 0) continue;
                const long double t = (-b - std::sqrt(disc)) / a;
                if (t > 1 && t < best) best = t, nearest = k;
            }
            Layers layers;
            if (nearest == scene.shapes.size()) {
                layers.background = {1, 1, 1};
                return layers;
            }
            if (nearest != ground_shape) {
                // Not tested here.
                layers.background = pixel(image, i, j);
                return layers;
            }
            ++ground_pixels;
            const auto t = static_cast<double>(best);
            const Vec3 p = d * t, normal = (p - Vec3{0, -5001, 0}) / 5000;
            layers = lit(ground, {0.2, 0.2, 0.2}, scene.lights[1], p, normal, normalize(-d), true);
            return layers;
        },
        2);
    EXPECT_GT(ground_pixels, 6000);
}

TEST(ClosedForm, ColorsNormalsAndBackgrounds) {
    Scene scene;
    set_size(scene, 32, 32);
    scene.background = {0.25, 0.5, 0.75};
    scene.conventions.facing = Facing::none;
    scene.camera.projection = Projection::orthographic;
    scene.camera.position = {0, 0, 10};
    scene.camera.look_at = {0, 0, 0};
    scene.camera.width = 4;
    Material m = shiny();
    m.color = {0.1, 0.2, 0.3};
    m.mirror = 0.5;
    scene.add(Sphere{{0, 0, 0}, 1}, add_material(scene, m));
    const auto at = [](int i) { return (i + 0.5) / 8 - 2; };
    const auto on = [&](int i, int j) { return at(i) * at(i) + at(j) * at(j) <= 1; };
    scene.settings.shading = Shading::color;
    expect_picture(render_scene(scene), [&](int i, int j) {
        Layers layers;
        (on(i, j) ? layers.ambient : layers.background) = on(i, j) ? m.color : scene.background;
        return layers;
    });
    scene.settings.shading = Shading::normals;
    expect_picture(render_scene(scene), [&](int i, int j) {
        Layers layers;
        if (on(i, j)) {
            const double x = at(i), y = -at(j);
            layers.ambient = Color{x + 1, y + 1, std::sqrt(1 - x * x - y * y) + 1} * 0.5;
        } else {
            layers.background = {0, 0, 1};
        }
        return layers;
    });
}

TEST(ClosedForm, AMirroringMapKeepsTheFrontOfFlatShapes) {
    for (int kind = 0; kind < 4; ++kind) {
        Scene scene;
        set_size(scene, 1, 1);
        scene.settings.shading = Shading::normals;
        scene.conventions.facing = Facing::none;
        scene.camera.position = {0, 0, 5};
        scene.transforms = {scaling({-1, 1, 1})};
        const Vec3 a{-2, -2, 0}, b{2, -2, 0}, c{0, 3, 0}, n{0, 0, 1};
        scene.polygon_vertices = {a, b, c, {-1, 2, 0}};
        if (kind == 0) scene.add(Triangle{{a, b, c}}, k_none, 0);
        if (kind == 1) scene.add(SmoothTriangle{{a, b, c}, {n, n, n}}, k_none, 0);
        if (kind == 2) scene.add(Polygon{0, 4}, k_none, 0);
        if (kind == 3) scene.add(Disc{{0, 0, 0}, n, 1}, k_none, 0);
        EXPECT_EQ(pixel(render_scene(scene), 0, 0), (Color{0.5, 0.5, 1})) << kind;
    }
}

// Side by side: smooth triangles whose normals and windings are to either side, and other shapes, of which
// only the normal counts.
TEST(ClosedForm, TheWindingTurnsTheNormalsOfSmoothTriangles) {
    constexpr int k_columns = 24;
    Scene scene;
    set_size(scene, k_columns, 1);
    scene.settings.shading = Shading::normals;
    scene.camera.projection = Projection::orthographic;
    scene.camera.position = {0, 0, 10};
    scene.camera.look_at = {0, 0, 0};
    scene.camera.width = k_columns;
    for (int i = 0; i < k_columns; ++i) {
        const Vec3 center{i + 0.5 - k_columns / 2.0, 0, 0}, n{0, 0, i % 2 == 0 ? 1.0 : -1.0};
        const Vec3 a = center + Vec3{-0.4, -0.4, 0}, b = center + Vec3{0.4, -0.4, 0},
                   c = center + Vec3{0, 0.6, 0};
        const bool is_clockwise = i % 4 >= 2;
        if (i % 5 == 4) {
            scene.add(Disc{center, n, 0.4});
        } else {
            scene.add(SmoothTriangle{{a, is_clockwise ? c : b, is_clockwise ? b : c}, {n, n, n}});
        }
    }
    for (const Facing facing : {Facing::all, Facing::winding}) {
        scene.conventions.facing = facing;
        const Image image = render_scene(scene);
        for (int i = 0; i < k_columns; ++i) {
            const bool away = facing == Facing::winding && i % 5 != 4 && (i % 2 != 0) != (i % 4 >= 2);
            EXPECT_EQ(pixel(image, i, 0), (Color{0.5, 0.5, away ? 0.0 : 1.0})) << i;
        }
    }
}

}  // namespace
}  // namespace glint::test
