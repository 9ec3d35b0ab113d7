// SPDX-License-Identifier: Apache-2.0
// Transparency without refraction (Material::filter, transmit): the renderer compared with a recursion under
// every convention, and pictures known in closed form.
#include <gtest/gtest.h>

#include "explain/added_up.h"
#include "glint/explain.h"
#include "trace/hit_rule.h"
#include "trace/pictures.h"
#include "trace/sheets.h"

namespace glint::test {
namespace {

Color through(const Material& m) {
    return {m.transmit + m.filter * m.color.r, m.transmit + m.filter * m.color.g,
            m.transmit + m.filter * m.color.b};
}

// The recursion of POV-Ray, Tachyon and glint, with ambient light only.
class StraightRecursion {
  public:
    StraightRecursion(const Scene& scene, const World& world) : scene_(scene), world_(world) {}

    Color seen(Vec3 o, Vec3 d, double t_min, int level, int passed) {
        const Conventions& rules = scene_.conventions;
        const BruteHit hit = brute_nearest(world_, o, d, t_min, 1e300);
        if (hit.slot == k_none) return scene_.background;
        const Shape& shape = scene_.shapes[world_.parts().geometry->shape_index[hit.slot]];
        const Material& m = scene_.materials[shape.material];
        const bool at_limit = level >= scene_.settings.reflections;
        const int next = level + (rules.transparency_counts ? 1 : 0);
        if (m.is_transparent() && passed >= rules.transparent_surfaces) {
            if (at_limit && rules.transparency_counts && rules.limit == LimitRule::background)
                return scene_.background;
            return seen(o, d, hit.t, rules.limit == LimitRule::background ? next : level, passed);
        }
        const bool whole = at_limit && rules.limit == LimitRule::keep;
        const double brightest = std::max({m.color.r, m.color.g, m.color.b});
        double opacity = rules.opacity == OpacityRule::whole ? 1 - m.filter - m.transmit
                                                             : 1 - m.transmit - m.filter * brightest;
        if (whole) opacity = 1;
        const double share = rules.mirror == MirrorRule::add || whole ? 1 : 1 - m.mirror;
        const double own = rules.transparency == Transparency::add ? share : share * opacity;
        Color sum = m.ambient * own;
        if (whole || (at_limit && rules.limit == LimitRule::drop)) return sum;
        const Vec3 p = o + d * hit.t;
        if (m.mirror > 0) {
            const Vec3 n = plane_or_sphere_normal(scene_, shape, p);
            const Vec3 away = d - n * (2 * dot(n, d));
            const double by = rules.transparency == Transparency::blend && m.is_transparent() ? opacity : 1;
            sum = sum + (at_limit ? scene_.background * by
                                  : seen(p + away * 1e-7, away, 0, level + 1, passed) * (m.mirror * by));
        }
        if (m.is_transparent()) {
            sum = sum + (at_limit ? scene_.background : seen(o, d, hit.t, next, passed + 1) * through(m));
        }
        return sum;
    }

  private:
    const Scene& scene_;
    const World& world_;
};

// Spheres, opaque, mirrors and transparent, in front of a wall.
Scene bubbles() {
    Random random(7);
    Scene scene = ambient_view({0.2, 0.3, 0.9});
    const Color colors[] = {{1, 0.5, 0.25}, {0.25, 1, 0.5}, {0.5, 0.25, 1}, {0.9, 0.9, 0.3}};
    const double filters[] = {0.6, 0, 0.3, 0}, transmits[] = {0, 0.5, 0.4, 0.9};
    for (std::size_t i = 0; i < 4; ++i) {
        add_material(scene, sheet(colors[i], filters[i], transmits[i]));
        scene.materials.back().mirror = i == 1 ? 0.3 : 0;
    }
    add_material(scene, sheet({0.7, 0.6, 0.5}, 0, 0));
    add_material(scene, sheet({0.1, 0.2, 0.1}, 0, 0));
    scene.materials.back().mirror = 0.5;
    for (int i = 0; i < 40; ++i) {
        const auto at = [&] { return 0.01 * (below(random, 800) - 400); };
        const Vec3 center{at(), at(), at()};
        scene.add(Sphere{center, 0.4 + 0.01 * below(random, 120)},
                  static_cast<std::uint32_t>(below(random, 6)));
    }
    return scene;
}

TEST(Transparency, TheRecursionUnderEveryConvention) {
    struct Ray {
        Vec3 origin, direction;
    };
    std::vector<Ray> rays;  // from the camera, which no convention changes
    const Scene seen = bubbles();
    const std::optional<World> seen_world = make_world(seen);
    for (int y = 0; y < 36; ++y) {
        for (int x = 0; x < 48; ++x) {
            const Explanation e = explain(seen, *seen_world, x, y).value();
            rays.push_back({e.rays[0].origin, e.rays[0].direction});
        }
    }
    int checked = 0;
    for (const Transparency transparency : {Transparency::highlights, Transparency::blend, Transparency::add})
        for (const LimitRule limit : {LimitRule::keep, LimitRule::drop, LimitRule::background})
            for (const bool counts : {false, true})
                for (const int reflections : {0, 2, 6}) {
                    Scene scene = bubbles();
                    Conventions& rules = scene.conventions;
                    rules.transparency = transparency;
                    rules.limit = limit;
                    rules.transparency_counts = counts;
                    rules.mirror = checked % 2 == 0 ? MirrorRule::blend : MirrorRule::add;
                    rules.opacity = checked % 3 == 0 ? OpacityRule::brightest : OpacityRule::whole;
                    rules.transparent_surfaces = checked % 4 == 0 ? 3 : checked % 7 == 0 ? 1 : 4096;
                    scene.settings.reflections = reflections;
                    const std::optional<World> world = make_world(scene);
                    const Image image = render_world(*world);
                    StraightRecursion recursion(scene, *world);
                    int wrong = 0;
                    for (int y = 0; y < image.height; ++y) {
                        for (int x = 0; x < image.width; ++x) {
                            const Ray& ray = rays[static_cast<std::size_t>(y * image.width + x)];
                            const Color want = recursion.seen(ray.origin, ray.direction, 0, 0, 0);
                            const Color got = image.pixel(x, y);
                            const double most = std::max({std::abs(want.r - got.r), std::abs(want.g - got.g),
                                                          std::abs(want.b - got.b)});
                            wrong += most > 1e-5;
                        }
                    }
                    // Where rays graze spheres, the recursion's own offsets decide.
                    EXPECT_LE(wrong, 4) << checked;
                    ++checked;
                }
    EXPECT_EQ(checked, 54);
}

TEST(Transparency, ManySurfacesEndAtTheLimitOfRays) {
    const int count = k_max_sample_rays + 100;
    Scene scene;
    set_size(scene, 1, 1);
    const std::uint32_t material = add_material(scene, sheet({1, 1, 1}, 0, 1));
    for (int i = 0; i < count; ++i) scene.add(Plane{{0, 0, -1.0 - i}, {0, 0, 1}}, material);
    scene.background = {1, 1, 1};
    scene.lights = {ambient_light({1, 1, 1})};
    const std::optional<World> world = make_world(scene);
    const Result<Rendering> all = render(*world);
    EXPECT_EQ(all->rays.transmitted, static_cast<std::uint64_t>(k_max_sample_rays));
    EXPECT_EQ(all->rays.cut, 1u);
    EXPECT_EQ(all->image.pixel(0, 0), (Color{0, 0, 0}));
}

// Two sheets at a small distance: they count as one within the conventions' epsilons.
TEST(Transparency, SheetsThatCoincideCountOnce) {
    for (const double gap : {0.0005, 0.002}) {
        Scene scene;
        set_size(scene, 1, 1);
        scene.background = {1, 1, 1};
        const std::uint32_t material = add_material(scene, sheet({0, 0, 0}, 0, 0.5));
        scene.add(Plane{{0, 0, -1}, {0, 0, 1}}, material);
        scene.add(Plane{{0, 0, -1 - gap}, {0, 0, 1}}, material);
        const auto seen = [&] { return static_cast<float>(render_scene(scene).pixel(0, 0).r); };
        EXPECT_FLOAT_EQ(seen(), 0.25f);
        scene.conventions.transparent_shadow_epsilon = 0.001;
        EXPECT_FLOAT_EQ(seen(), 0.25f) << "of shadows only";
        scene.conventions.transparent_epsilon = 0.001;
        EXPECT_FLOAT_EQ(seen(), gap < 0.001 ? 0.5f : 0.25f);
        scene.conventions.ray_direction = RayDirection::viewport;
        EXPECT_FLOAT_EQ(seen(), gap < 0.001 ? 0.5f : 0.25f) << "directions that are not unit vectors";
    }
}

TEST(Transparency, SheetsThatCoincideColorLightOnce) {
    for (const double gap : {0.0005, 0.002}) {
        for (const bool is_point : {false, true}) {
            Scene scene;
            set_size(scene, 1, 1);
            const std::uint32_t material = add_material(scene, sheet({0, 0, 0}, 0, 0.5));
            scene.add(Plane{{0, 0, 1}, {0, 0, 1}}, material);
            scene.add(Plane{{0, 0, 1 + gap}, {0, 0, 1}}, material);
            Material wall;
            wall.ambient = wall.specular = {0, 0, 0};
            wall.diffuse = {1, 1, 1};
            scene.add(Plane{{0, 0, -1}, {0, 0, 1}}, add_material(scene, wall));
            scene.lights = {is_point ? point_light({0, 0, 9}, {1, 1, 1})
                                     : directional_light({0, 0, 2}, {1, 1, 1})};
            const auto seen = [&] { return static_cast<float>(render_scene(scene).pixel(0, 0).r); };
            EXPECT_FLOAT_EQ(seen(), 0.25f);
            scene.conventions.transparent_epsilon = 0.001;
            EXPECT_FLOAT_EQ(seen(), 0.25f) << "of what is seen only";
            scene.conventions.transparent_shadow_epsilon = 0.001;
            EXPECT_FLOAT_EQ(seen(), gap < 0.001 ? 0.5f : 0.25f);
            const std::optional<World> world = make_world(scene);
            const Explanation e = explain(scene, *world, 0, 0).value();
            EXPECT_EQ(e.rays.back().hit->lights[0].filters.size(), gap < 0.001 ? 1u : 2u);
        }
    }
}

// A sheet in front of a wall, seen through it: within the epsilon, it does not color the light.
TEST(Transparency, SheetsOnTheLitPointColorNoLight) {
    for (const double gap : {0.0005, 0.002}) {
        for (const bool is_point : {false, true}) {
            Scene scene;
            set_size(scene, 1, 1);
            scene.add(Plane{{0, 0, -1 + gap}, {0, 0, 1}}, add_material(scene, sheet({0, 0, 0}, 0, 0.5)));
            Material wall;
            wall.ambient = wall.specular = {0, 0, 0};
            wall.diffuse = {1, 1, 1};
            scene.add(Plane{{0, 0, -1}, {0, 0, 1}}, add_material(scene, wall));
            scene.lights = {is_point ? point_light({0, 0, 9}, {1, 1, 1})
                                     : directional_light({0, 0, 2}, {1, 1, 1})};
            const auto seen = [&] { return static_cast<float>(render_scene(scene).pixel(0, 0).r); };
            EXPECT_FLOAT_EQ(seen(), 0.25f);
            scene.conventions.transparent_shadow_epsilon = 0.001;
            EXPECT_FLOAT_EQ(seen(), gap < 0.001 ? 0.5f : 0.25f);
        }
    }
}

TEST(Transparency, AlphaFollowsStraightRays) {
    Scene scene;
    set_size(scene, 1, 1);
    scene.background = {0.5, 0.25, 1};
    scene.settings.alpha = true;
    scene.add(Plane{{0, 0, -1}, {0, 0, 1}}, add_material(scene, sheet({1, 0.5, 0.25}, 0.5, 0.25)));
    scene.add(Plane{{0, 0, -2}, {0, 0, 1}}, add_material(scene, sheet({0, 0, 0}, 0, 0.5)));
    RenderOptions options;
    options.layers = {Layer::alpha};
    const Rendering all = render(*make_world(scene), options).value();
    EXPECT_FLOAT_EQ(all.layers[0].values[0], 1 - 0.5f * (0.75f + 0.5f + 0.375f) / 3);
    EXPECT_EQ(all.image.pixel(0, 0), (Color{0, 0, 0}));
}

TEST(Transparency, FogDependsOnTheWayBetweenSurfaces) {
    Scene scene;
    set_size(scene, 1, 1);
    scene.add(Plane{{0, 0, -4}, {0, 0, 1}}, add_material(scene, sheet({0, 0, 0}, 0, 0.5)));
    scene.add(Plane{{0, 0, -20}, {0, 0, 1}}, add_material(scene, sheet({1, 0.5, 0.25}, 0, 0)));
    scene.lights = {ambient_light({1, 1, 1})};
    Fog fog;
    fog.color = {0, 0, 1};
    fog.density = 0.05;
    scene.fog = fog;
    const double near = std::exp(-0.2), far = std::exp(-0.8);
    const Color c = render_scene(scene).pixel(0, 0);
    EXPECT_NEAR(c.r, near * 0.5 * far * 0.5, 1e-6);
    EXPECT_NEAR(c.b, near * 0.5 * (far * 0.125 + (1 - far)) + (1 - near), 1e-6);
}

// Everything at once.
Scene transparent_mixture() {
    Scene scene = mixture(11);
    scene.settings.samples = 2;
    for (int i = 0; i < 6; ++i) {
        Material m;
        m.color = {0.9, 0.2 * i, 1 - 0.2 * i};
        m.specular = {0.3, 0.3, 0.3};
        m.mirror = i % 2 == 0 ? 0.3 : 0;
        m.transmission = i == 3 ? 0.7 : 0;
        m.ior = 1.4;
        if (i != 3 && i != 0) m.filter = 0.3, m.transmit = 0.1 * i;
        add_material(scene, m);
    }
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
        scene.shapes[i].material = static_cast<std::uint32_t>(i % 6);
    scene.lights = {ambient_light({0.3, 0.3, 0.3}), point_light({5, 9, 19}, {0.6, 0.5, 0.5}),
                    directional_light({-1, 2, 1}, {0.3, 0.4, 0.5})};
    scene.fog = Fog{FogKind::exp, {0.5, 0.6, 0.7}, 0.02, 5, 0, 0.05};
    return scene;
}

TEST(Transparency, CropsThreadsAndInstructionSets) {
    for (const int surfaces : {4096, 2}) {
        Scene scene = transparent_mixture();
        scene.conventions.transparent_surfaces = surfaces;
        expect_same_crops(*make_world(scene), 20);
    }
}

void expect_filters_in_order(const Explanation& e) {
    for (const ExplainedRay& ray : e.rays) {
        if (!ray.hit) continue;
        Color diffuse;
        for (const LightTerms& terms : ray.hit->lights) {
            diffuse = diffuse + terms.diffuse;
            Color product{1, 1, 1};
            double before = -1;
            for (const ShadowFilter& filter : terms.filters) {
                ASSERT_GE(filter.distance, before);
                before = filter.distance;
                product = product * filter.factor;
            }
            ASSERT_NEAR(product.g, terms.filter.g, 1e-15);
        }
        ASSERT_EQ(diffuse, ray.hit->diffuse);
    }
}

TEST(Transparency, ExplainedAsDrawn) {
    std::size_t filters = 0, straight = 0, beyond = 0;
    for (const LimitRule limit : {LimitRule::drop, LimitRule::background}) {
        Scene scene = transparent_mixture();
        scene.conventions.limit = limit;
        scene.conventions.transparency_counts = limit == LimitRule::background;
        scene.settings.reflections = 2;
        expect_explained_as_drawn(scene, 3, 2, [&](const Explanation& e, int x, int y) {
            expect_added_up(e, x, y);
            expect_filters_in_order(e);
            if (HasFatalFailure()) return;
            for (const ExplainedRay& ray : e.rays) {
                straight += ray.straight;
                beyond += ray.beyond_limit;
                if (!ray.hit) continue;
                for (const LightTerms& terms : ray.hit->lights) filters += terms.filters.size();
            }
        });
    }
    EXPECT_GT(filters, 1000u);
    EXPECT_GT(straight, 1000u);
    EXPECT_GT(beyond, 100u);
}

TEST(Transparency, AnUnusedMaterialChangesNoBit) {
    Scene scene = transparent_mixture();
    for (Material& m : scene.materials) m.filter = m.transmit = 0;
    scene.conventions.beer = 0.1;
    for (const LimitRule limit : {LimitRule::keep, LimitRule::drop, LimitRule::background}) {
        scene.conventions.limit = limit;
        Scene with = scene;
        add_material(with, sheet({1, 0, 0}, 0.5, 0));
        expect_same_picture(render_scene(scene), render_scene(with));
    }
}

TEST(Transparency, MaterialsAreReplacedWithoutPreparing) {
    const Scene scene = transparent_mixture();
    Scene opaque = scene;
    for (Material& m : opaque.materials) m.filter = m.transmit = 0;
    const std::optional<World> plain = make_world(opaque);
    World one_by_one = *plain;
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i)
        one_by_one = with_material(one_by_one, i, scene.materials[i]).value();
    const Image wanted = render_scene(scene);
    expect_same_picture(wanted, render_world(one_by_one));
    expect_same_picture(wanted, render_world(with_materials(*plain, scene.materials).value()));
    expect_same_picture(render_world(*plain),
                        render_world(with_materials(one_by_one, opaque.materials).value()));
    EXPECT_FALSE(with_material(*plain, 0, sheet({1, 1, 1}, 0.6, 0.5)));
    Material both = sheet({1, 1, 1}, 0.5, 0);
    both.transmission = 0.5;
    EXPECT_FALSE(with_material(*plain, 0, both));
}

}  // namespace
}  // namespace glint::test
