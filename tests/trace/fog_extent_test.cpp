// SPDX-License-Identifier: Apache-2.0
// Fog outside of objects (FogExtent::outside_objects): the renderer compared with a recursion that keeps a
// list of the objects that a ray is inside, and pictures known in closed form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "explain/added_up.h"
#include "glint/explain.h"
#include "trace/hit_rule.h"
#include "trace/pictures.h"
#include "trace/sheets.h"

namespace glint::test {
namespace {

// The recursion with ambient light only, mirrors added, and nothing beyond the limit.
class FogRecursion {
  public:
    using Objects = std::vector<std::uint64_t>;
    FogRecursion(const Scene& scene, const World& world) : scene_(scene), world_(world) {}

    Color seen(Vec3 o, Vec3 d, double t_min, double start, int level, const Objects& inside) {
        const BruteHit hit = brute_nearest(world_, o, d, t_min, 1e300);
        const Fog& fog = *scene_.fog;
        if (hit.slot == k_none) {
            const double f = inside.empty() && scene_.conventions.fog_background ? fog.transmit : 1;
            return scene_.background * f + fog.color * (1 - f);
        }
        const std::uint32_t number = world_.parts().geometry->shape_index[hit.slot];
        const Shape& shape = scene_.shapes[number];
        const Material& m = scene_.materials[shape.material];
        const double way = (hit.t - start) * length(d);
        const double f = inside.empty() ? std::max(std::exp(-fog.density * way), fog.transmit) : 1;
        Color sum = m.ambient * (1 - m.filter - m.transmit);
        if (m.mirror > 0 && level < scene_.settings.reflections) {
            const Vec3 p = o + d * hit.t, n = plane_or_sphere_normal(scene_, shape, p),
                       away = d - n * (2 * dot(n, d));
            sum = sum + seen(p + away * 1e-7, away, 0, 0, level + 1, inside) * m.mirror;
        }
        if (m.is_transparent() && level < scene_.settings.reflections) {
            const Color through{m.transmit + m.filter * m.color.r, m.transmit + m.filter * m.color.g,
                                m.transmit + m.filter * m.color.b};
            sum = sum + seen(o, d, hit.t, hit.t, level, passed(inside, number)) * through;
        }
        return sum * f + fog.color * (1 - f);
    }

    Objects around(Vec3 p) const {
        Objects inside;
        for (std::uint32_t i = 0; i < scene_.shapes.size(); ++i) {
            const Shape& shape = scene_.shapes[i];
            bool contains = false;
            if (shape.kind == ShapeKind::sphere) {
                const Sphere& s = scene_.get<Sphere>()[shape.index];
                contains = length(p - s.center) < s.radius;
            } else if (shape.kind == ShapeKind::plane) {
                const Plane& plane = scene_.get<Plane>()[shape.index];
                contains = dot(p - plane.point, plane.normal) < 0;
            }
            if (contains) inside = passed(inside, i);
        }
        return inside;
    }

  private:
    Objects passed(Objects inside, std::uint32_t number) const {
        const Material& m = scene_.materials[scene_.shapes[number].material];
        if (m.hollow) return inside;
        const std::uint64_t object =
            m.interior > 0 ? std::uint64_t{1} << 32 | static_cast<std::uint32_t>(m.interior) : number;
        const auto at = std::find(inside.begin(), inside.end(), object);
        if (at == inside.end()) {
            inside.push_back(object);
        } else {
            inside.erase(at);
        }
        return inside;
    }
    const Scene& scene_;
    const World& world_;
};

// Spheres, separate triangles, and tetrahedra whose triangles are one object, in front of a wall.
Scene objects_in_fog() {
    Random random(23);
    Scene scene = ambient_view({0.9, 0.3, 0.2});
    scene.settings.reflections = 5;
    scene.conventions.mirror = MirrorRule::add;
    scene.conventions.limit = LimitRule::drop;
    scene.conventions.fog_extent = FogExtent::outside_objects;
    scene.fog = Fog{FogKind::exp, {0.4, 0.6, 0.8}, 0.07, 0, 0, 0.1};
    const Color colors[] = {{1, 0.5, 0.25}, {0.25, 1, 0.5}, {0.5, 0.25, 1}, {0.9, 0.9, 0.3}};
    const double filters[] = {0.6, 0, 0.3, 0}, transmits[] = {0, 0.6, 0.4, 0.9};
    for (std::size_t i = 0; i < 4; ++i) add_material(scene, sheet(colors[i], filters[i], transmits[i]));
    scene.materials[1].mirror = 0.3;
    scene.materials[2].hollow = true;
    add_material(scene, sheet({0.7, 0.6, 0.5}, 0, 0));
    add_material(scene, sheet({0.1, 0.2, 0.1}, 0, 0));
    scene.materials.back().mirror = 0.5;
    const auto at = [&] { return 0.01 * (below(random, 800) - 400); };
    const auto point = [&] { return Vec3{at(), at(), at()}; };
    for (int i = 0; i < 25; ++i)
        scene.add(Sphere{point(), 0.4 + 0.01 * below(random, 120)},
                  static_cast<std::uint32_t>(below(random, 6)));
    for (int i = 0; i < 6; ++i) scene.add(Triangle{{point(), point(), point()}}, i % 2 == 0 ? 0 : 3);
    for (int i = 0; i < 5; ++i) {
        Material m = sheet(colors[static_cast<std::size_t>(i % 4)], 0.2, 0.6);
        m.interior = 7 + i;
        const std::uint32_t material = add_material(scene, m);
        const Vec3 p[] = {point(), point(), point(), point()};
        for (int k = 0; k < 4; ++k) scene.add(Triangle{{p[k], p[(k + 1) % 4], p[(k + 2) % 4]}}, material);
    }
    scene.add(Plane{{0, 0, -9}, {0, 0, 1}}, 4);
    return scene;
}

void expect_recursion(const Scene& scene, std::size_t around) {
    const std::optional<World> world = make_world(scene);
    const Image image = render_world(*world);
    FogRecursion recursion(scene, *world);
    EXPECT_EQ(recursion.around(scene.camera.position).size(), around);
    int wrong = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Explanation e = explain(scene, *world, x, y).value();
            const Vec3 from = e.rays[0].origin;
            const Color want = recursion.seen(from, e.rays[0].direction, 0, 0, 0, recursion.around(from));
            const Color got = image.pixel(x, y);
            const double most =
                std::max({std::abs(want.r - got.r), std::abs(want.g - got.g), std::abs(want.b - got.b)});
            wrong += most > 1e-5;
        }
    }
    // Where rays graze spheres, the recursion's own offsets decide.
    EXPECT_LE(wrong, 4);
}

// Also rays that start inside a shape which does not contain the whole of an orthographic camera's picture.
TEST(FogExtent, RaysOfAnOrthographicCameraStartInsideDifferentObjects) {
    Scene scene = objects_in_fog();
    scene.camera.projection = Projection::orthographic;
    scene.camera.position = {0, 0, 5};
    scene.camera.look_at = {0, 0, 0};
    scene.add(Sphere{{0.3, -0.2, 5}, 0.2}, 0);
    scene.add(Plane{{0, -0.1, 0}, {0.1, 1, 0}}, 4);
    expect_recursion(scene, 0);
}

TEST(FogExtent, TheRecursionWithAListOfObjects) {
    Scene scene = objects_in_fog();
    expect_recursion(scene, 0);
    scene.conventions.fog_background = false;
    scene.shapes.pop_back();  // the wall
    scene.get<Plane>().clear();
    expect_recursion(scene, 0);
}

TEST(FogExtent, TheCameraIsInsideObjects) {
    Scene scene = objects_in_fog();
    scene.add(Sphere{{0, 0, 12}, 1.5}, 0);
    scene.add(Sphere{{0, 1, 12}, 2.5}, 3);
    scene.add(Sphere{{0, 0, 12}, 3}, 2);            // hollow
    scene.add(Plane{{0, 0, 10}, {0.1, 0, -1}}, 3);  // a half-space
    scene.add(Plane{{0, 0, 30}, {0, 0, -1}}, 4);    // on its other side
    scene.add(Sphere{{0, 0, 0}, 60}, 4);            // opaque, around all
    expect_recursion(scene, 4);
    scene.materials[4].hollow = true;
    expect_recursion(scene, 3);
}

// A wall that shines white at distance 40, seen through the objects; of the fog, exp(-way / 10) is seen.
double way_in_fog(const std::function<void(Scene&)>& build) {
    Scene scene;
    set_size(scene, 1, 1);
    scene.camera.position = {0, 0, 0};
    scene.camera.look_at = {0, 0, -1};
    scene.lights = {ambient_light({1, 1, 1})};
    scene.fog = Fog{FogKind::exp, {0, 0, 0}, 0.1, 0, 0, 0};
    scene.conventions.fog_extent = FogExtent::outside_objects;
    Material white;
    white.ambient = {1, 1, 1};
    white.diffuse = {0, 0, 0};
    add_material(scene, sheet({0, 0, 0}, 0, 1));
    add_material(scene, sheet({0, 0, 0}, 0, 1));
    add_material(scene, white);
    scene.materials[1].interior = 1;
    scene.add(Disc{{0, 0, -40}, {0, 0, 1}, 100}, 2);
    build(scene);
    return -10 * std::log(static_cast<double>(render_scene(scene).pixel(0, 0).g));
}
Triangle sheet_at(double z) { return {{Vec3{-50, -50, z}, Vec3{50, -50, z}, Vec3{0, 50, z}}}; }

TEST(FogExtent, WaysThatPovRayHas) {
    const auto way = [](double expected, const std::function<void(Scene&)>& build) {
        EXPECT_NEAR(way_in_fog(build), expected, 1e-4);
    };
    way(40, [](Scene&) {});
    way(32, [](Scene& s) { s.add(Sphere{{0, 0, -10}, 4}, 0); });
    way(28, [](Scene& s) { s.add(Sphere{{0, 0, -10}, 4}, 0), s.add(Sphere{{0, 0, -14}, 4}, 0); });
    way(32, [](Scene& s) { s.add(Sphere{{0, 0, -10}, 4}, 0), s.add(Sphere{{0, 0, -10}, 2}, 0); });
    // One interior: the part that both contain is outside.
    way(32, [](Scene& s) { s.add(Sphere{{0, 0, -10}, 4}, 1), s.add(Sphere{{0, 0, -14}, 4}, 1); });
    way(10, [](Scene& s) { s.add(sheet_at(-10), 0); });
    way(10, [](Scene& s) { s.add(sheet_at(-10), 0), s.add(sheet_at(-15), 0); });
    way(35, [](Scene& s) { s.add(sheet_at(-10), 1), s.add(sheet_at(-15), 1); });
    way(40, [](Scene& s) { s.materials[0].hollow = true, s.add(sheet_at(-10), 0); });
    way(35, [](Scene& s) { s.add(Sphere{{0, 0, 0}, 5}, 0); });
    way(33, [](Scene& s) { s.add(Box{{-3, -3, -7}, {3, 3, 3}}, 0); });
    way(36, [](Scene& s) { s.add(Cylinder{{0, 0, -8}, {0, 0, -12}, 3, true}, 0); });
    way(20, [](Scene& s) { s.add(Plane{{0, 0, -20}, {0, 0, -1}}, 0); });
    way(20, [](Scene& s) { s.add(Plane{{0, 0, -20}, {0, 0, 1}}, 0); });
    way(32, [](Scene& s) {
        s.materials[0] = Material{};
        s.materials[0].ambient = s.materials[0].diffuse = {0, 0, 0};
        s.materials[0].transmission = 1;
        s.materials[0].ior = 1.5;
        s.add(Sphere{{0, 0, -10}, 4}, 0);
    });
    // The camera sees the inside of an opaque sphere, without transparent surfaces in the scene.
    way(0, [](Scene& s) {
        s.add(Sphere{{0, 0, 0}, 30}, 2), s.materials.erase(s.materials.begin()),
            s.shapes[0].material = s.shapes[1].material = 1;
    });
}

TEST(FogExtent, OrthographicCamerasAreInsideWhatContainsTheirPicture) {
    Scene scene;
    set_size(scene, 40, 40);
    scene.camera.projection = Projection::orthographic;
    scene.camera.position = {0, 0, 5};
    scene.camera.look_at = {0, 0, 0};
    scene.lights = {ambient_light({1, 1, 1})};
    scene.fog = Fog{FogKind::exp, {0, 0, 1}, 0.1, 0, 0, 0};
    scene.background = {1, 0, 0};
    scene.conventions.fog_extent = FogExtent::outside_objects;
    scene.add(Sphere{{0, 0, 5}, 1000}, add_material(scene, sheet({0.2, 0.4, 0.2}, 0, 0.5)));
    const Image around = render_scene(scene);
    EXPECT_NEAR(around.pixel(20, 20).b, 0.05 + 0.5, 1e-6) << "fog on the background only";
    scene.get<Sphere>()[0].radius = 1e-3;
    EXPECT_EQ(render_scene(scene).pixel(1, 1), (Color{0, 0, 1}));
    // The corners of the picture are in the tube, and its middle is in the hole.
    scene.camera.width = 2;
    scene.add(Torus{{0, 0, 5}, {0, 0, 1}, std::sqrt(2.0), 0.5}, scene.shapes[0].material);
    const Image ring = render_scene(scene);
    EXPECT_NEAR(ring.pixel(0, 0).b, 0.05 + 0.5, 1e-6);
    EXPECT_EQ(ring.pixel(20, 20), (Color{0, 0, 1}));
}

Scene mixture_in_fog() {
    Scene scene = objects_in_fog();
    set_size(scene, 70, 50);
    scene.settings.samples = 2;
    Material glass;
    glass.transmission = 0.7;
    glass.ior = 1.4;
    const std::uint32_t material = add_material(scene, glass);
    scene.shapes[3].material = scene.shapes[8].material = material;
    scene.lights.push_back(point_light({5, 9, 19}, {0.6, 0.5, 0.5}));
    scene.add(Sphere{{0, 0, 11}, 2}, 1);
    return scene;
}

TEST(FogExtent, CropsThreadsAndInstructionSets) { expect_same_crops(*make_world(mixture_in_fog()), 20); }

TEST(FogExtent, ExplainedAsDrawn) {
    std::size_t inside = 0, outside = 0;
    for (const bool alpha : {false, true}) {
        Scene scene = mixture_in_fog();
        scene.settings.alpha = alpha;
        expect_explained_as_drawn(scene, 3, 2, [&](const Explanation& e, int x, int y) {
            float layers[k_light_layers][3];
            add_up(e, layers);
            for (int l = 0; l < k_light_layers; ++l)
                for (int c = 0; c < 3; ++c) ASSERT_EQ(layers[l][c], e.layers[l][c]) << x << ',' << y;
            for (const ExplainedRay& ray : e.rays) {
                (ray.inside_object ? inside : outside) += 1;
                ASSERT_TRUE(!ray.inside_object || ray.visibility == 1);
            }
        });
    }
    EXPECT_GT(inside, 1000u);
    EXPECT_GT(outside, 1000u);
}

TEST(FogExtent, EmptyTilesHaveTheBitsOfOthers) {
    // The camera is inside an opaque half-space, and most tiles are filled without tracing.
    Scene scene;
    set_size(scene, 150, 100);
    scene.background = {0.2, 0.5, 0.7};
    scene.lights = {ambient_light({1, 1, 1})};
    scene.camera.position = {0, 0, 0};
    scene.camera.look_at = {0, 0, -1};
    scene.fog = Fog{FogKind::exp, {0.7, 0.6, 0.3}, 0.06, 0, 0, 0.3};
    scene.conventions.fog_extent = FogExtent::outside_objects;
    const std::uint32_t material = add_material(scene, sheet({1, 1, 1}, 0, 0));
    scene.add(Sphere{{-4, 3, -10}, 1}, material);
    scene.add(Sphere{{0, 0, 50}, 51}, material);
    for (const int samples : {1, 3}) {
        scene.settings.samples = samples;
        const std::optional<World> world = make_world(scene);
        RenderOptions options;
        options.layers = {Layer::fog};
        expect_same_picture(render(*world, options).value().image, render_world(*world));
    }
}

TEST(FogExtent, ChangesWithoutPreparing) {
    const Scene scene = mixture_in_fog();
    const Image wanted = render_scene(scene);
    Scene other = scene;
    other.conventions.fog_extent = FogExtent::everywhere;
    other.camera.position = {0, 0, 40};
    for (Material& m : other.materials) m.interior = 0, m.hollow = false;
    World world = *make_world(other);
    world = with_rules(world, scene.conventions, scene.settings).value();
    world = with_materials(world, scene.materials).value();
    world = with_camera(world, scene.camera).value();
    expect_same_picture(wanted, render_world(world));
    world = with_camera(with_rules(world, other.conventions, other.settings).value(), other.camera).value();
    expect_same_picture(render_scene(other), render_world(with_materials(world, other.materials).value()));

    // A sphere moves away from the camera, and a material that is hollow is assigned to one around it.
    Scene moved = scene;
    World edited = *make_world(scene);
    const auto last = static_cast<std::uint32_t>(scene.shapes.size() - 1);
    moved.get<Sphere>()[moved.shapes[last].index].center = {0, 0, 5};
    ASSERT_TRUE(edit_shapes(edited, moved, std::vector{last}));
    expect_same_picture(render_scene(moved), render_world(edited));
    Scene hollow = scene;
    hollow.shapes[last].material = 2;
    World assigned = *make_world(scene);
    ASSERT_TRUE(assign_material(assigned, std::vector{last}, 2).ok());
    expect_same_picture(render_scene(hollow), render_world(assigned));
}

TEST(FogExtent, ChangesNoBitWhereNothingIsPassed) {
    Scene scene = objects_in_fog();
    for (Material& m : scene.materials) m.filter = m.transmit = 0;
    Scene everywhere = scene;
    everywhere.conventions.fog_extent = FogExtent::everywhere;
    expect_same_picture(render_scene(everywhere), render_scene(scene));
}

}  // namespace
}  // namespace glint::test
