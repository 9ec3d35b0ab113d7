// SPDX-License-Identifier: Apache-2.0
// explain() describes the same pixel that render() gives, and its parts add up to it.
#include "glint/explain.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "explain/added_up.h"
#include "gallery/scene_file.h"
#include "trace/kernels.h"
#include "world/appearance/appearance.h"

namespace glint::test {
namespace {

// All t at which a shadow ray hits shapes that cast shadows, by testing all shapes.
std::vector<double> occluders(const World& world, const LightTerms& terms) {
    std::vector<double> met;
    double t_min = terms.t_min;
    for (;;) {
        double columns[8][1 + k_ray_padding] = {
            {terms.origin.x},    {terms.origin.y},    {terms.origin.z}, {terms.direction.x},
            {terms.direction.y}, {terms.direction.z}, {t_min},          {terms.t_max}};
        double t[1 + k_ray_padding];
        std::uint32_t slot[1 + k_ray_padding], element[1 + k_ray_padding];
        available_kernels().front().nearest_hit(
            world.parts(),
            {columns[0], columns[1], columns[2], columns[3], columns[4], columns[5], columns[6], columns[7]},
            1, 1, {t, slot, element});
        if (slot[0] == k_none) return met;
        if (blocks_light(world.parts(), {slot[0], element[0]}, terms.origin + terms.direction * t[0]))
            met.push_back(t[0]);
        t_min = t[0];
    }
}
double last_t(const World& world, const LightTerms& terms) {
    const auto met = occluders(world, terms);
    return met.empty() ? -1 : met.back();
}
double first_t(const World& world, const LightTerms& terms) {
    const auto met = occluders(world, terms);
    return met.empty() ? -1 : met.front();
}

double length(Vec3 v) { return std::sqrt(dot(v, v)); }

void check_light(const Scene& scene, const World& world, const ExplainedHit& hit, const LightTerms& terms) {
    EXPECT_EQ(terms.blocked, terms.blocker.has_value());
    if (!terms.blocked) return;
    const bool from_light =
        scene.lights[terms.light].has_position() && scene.conventions.shadow_stops_at_light;
    const double t = from_light ? last_t(world, terms) : first_t(world, terms);
    ASSERT_GE(t, 0) << "the shadow ray of a blocked light hits nothing";
    const double distance = length(terms.origin + terms.direction * t - hit.point);
    EXPECT_NEAR(terms.blocker->distance, distance, 1e-6 * (1 + terms.distance))
        << "another blocker is nearer to the point";
}

void check_pixel(const Scene& scene, const World& world, const Image& picture, int x, int y) {
    const Explanation e = explain(scene, world, x, y).value();
    float layers[k_light_layers][3];
    add_up(e, layers);
    for (int c = 0; c < 3; ++c) {
        const float drawn =
            picture.rgb[3 * static_cast<std::size_t>(y * picture.width + x) + static_cast<std::size_t>(c)];
        ASSERT_EQ(std::bit_cast<std::uint32_t>(e.value[c]), std::bit_cast<std::uint32_t>(drawn))
            << x << ',' << y << " channel " << c;
        float sum = 0;
        for (int l = 0; l < k_light_layers; ++l) {
            ASSERT_EQ(layers[l][c], e.layers[l][c]) << x << ',' << y << " layer " << l;
            sum += e.layers[l][c];
        }
        ASSERT_EQ(sum, drawn) << x << ',' << y;
    }
    for (const ExplainedRay& ray : e.rays) {
        if (!ray.hit) continue;
        Color diffuse, specular;
        for (const LightTerms& terms : ray.hit->lights) {
            diffuse = diffuse + terms.diffuse;
            specular = specular + terms.specular;
            check_light(scene, world, *ray.hit, terms);
        }
        ASSERT_EQ(diffuse * ray.hit->outline, ray.hit->diffuse);
        ASSERT_EQ(specular, ray.hit->specular);
        for (const ExplainedSecondaryRay* secondary : {&ray.hit->reflected, &ray.hit->transmitted}) {
            ASSERT_EQ(secondary->state == SecondaryRayState::traced, secondary->ray >= 0);
            if (secondary->ray < 0) continue;
            const ExplainedRay& child = e.rays.at(static_cast<std::size_t>(secondary->ray));
            ASSERT_EQ(&e.rays.at(static_cast<std::size_t>(child.parent)), &ray);
            ASSERT_EQ(child.weight, secondary->weight);
            ASSERT_EQ(child.transmitted, secondary == &ray.hit->transmitted);
        }
    }
}

// The surface that is hit is one of the crossings, at the same t, and the first surface of the ray.
TEST(Explain, CrossingsOfSolids) {
    int hits = 0, crossings = 0;
    for (const bool is_clear : {false, true}) {
        auto scene = test::load_file(GLINT_PROJECT_DIR "/scenes/glint/solids.glint");
        ASSERT_TRUE(scene);
        // Rays go on from within.
        for (Material& material : scene->materials)
            if (is_clear && material.transmission == 0 && material.filter == 0) material.transmit = 0.5;
        scene->settings.width = 61;
        scene->settings.height = 47;
        const Result<World> prepared = prepare(*scene);
        ASSERT_TRUE(prepared) << to_string(prepared);
        const World& world = *prepared;
        for (int i = 0; i < 61 * 47; i += 3) {
            for (const ExplainedRay& ray : explain(*scene, world, i % 61, i / 61).value().rays) {
                if (!ray.hit) continue;
                if (scene->shapes[ray.hit->shape].kind != ShapeKind::solid) {
                    EXPECT_TRUE(ray.hit->crossings.empty());
                    continue;
                }
                ++hits;
                bool is_found = false;
                double last = -std::numeric_limits<double>::infinity();
                for (const ExplainedCrossing& c : ray.hit->crossings) {
                    ++crossings;
                    EXPECT_GE(c.t, last);
                    last = c.t;
                    if (c.hit) {
                        EXPECT_FALSE(is_found);
                        EXPECT_TRUE(c.surface);
                        EXPECT_NEAR(c.t, ray.t, 1e-6 * (1 + ray.t));
                        EXPECT_EQ(c.operand, static_cast<int>(ray.hit->element));
                        is_found = true;
                    } else if (c.surface && !is_found) {
                        EXPECT_LE(c.t, ray.t_min);
                    }
                }
                EXPECT_TRUE(is_found) << i;
            }
        }
    }
    EXPECT_GT(hits, 300);
    EXPECT_GT(crossings, 2 * hits);
}

TEST(Explain, AQuadricByItselfHasNoCrossings) {
    Scene scene;
    scene.add(Quadric{{1, 2, 3}, {}, {}, -1});
    scene.solids.push_back(combine(scene, SolidOperation::merge, scene.shapes));
    scene.camera.position = {0, 0, 5};
    const Explanation e = explain(scene, prepare(scene).value(), 320, 240).value();
    ASSERT_TRUE(e.rays[0].hit);
    EXPECT_TRUE(e.rays[0].hit->crossings.empty());
}

TEST(Explain, TenThousandPixelsEqualThePicture) {
    std::mt19937 random(5);
    int pixels = 0, blocked = 0;
    const auto files = test::scene_files(GLINT_PROJECT_DIR "/scenes");
    const auto each = 10000 / static_cast<int>(files.size()) / 2 + 1;
    for (const std::string& file : files) {
        for (const char* settings : {"", "aa=2 reflections=3 shadow_stops_at_light=false"}) {
            auto scene = test::load_file(file, settings);
            ASSERT_TRUE(scene) << file;
            SCOPED_TRACE(file + " " + settings);
            // Small and fast, and not a multiple of the tile size.
            scene->settings.height = 97 * scene->settings.height / scene->settings.width;
            scene->settings.width = 97;
            const Result<World> world = prepare(*scene);
            ASSERT_TRUE(world);
            const Result<Rendering> whole = render(*world);
            ASSERT_TRUE(whole);
            for (int i = 0; i < each && !testing::Test::HasFatalFailure(); ++i) {
                const int x = static_cast<int>(random() % 97u);
                const int y = static_cast<int>(random() % static_cast<unsigned>(whole->image.height));
                check_pixel(*scene, *world, whole->image, x, y);
                ++pixels;
                for (const ExplainedRay& ray : explain(*scene, *world, x, y).value().rays)
                    for (const LightTerms& terms : ray.hit ? ray.hit->lights : std::vector<LightTerms>())
                        blocked += terms.blocked;
            }
        }
    }
    EXPECT_GE(pixels, 10000);
    EXPECT_GT(blocked, 1000) << "too few shadows for a test of blockers";
}

TEST(Explain, UnlitShadingsAndEveryInstructionSet) {
    for (const char* settings : {"shading=normals", "shading=color", "shading=diffuse", "shadows=false"}) {
        auto scene = test::load_file(GLINT_PROJECT_DIR "/scenes/epfl/castle.json",
                                     std::string("size=64x64 ") + settings);
        ASSERT_TRUE(scene);
        const Result<World> world = prepare(*scene);
        const Result<Rendering> whole = render(*world);
        for (int i = 0; i < 64; ++i) check_pixel(*scene, *world, whole->image, i, (37 * i) % 64);
    }
    const auto scene = test::load_file(GLINT_PROJECT_DIR "/scenes/epfl/castle.json", "size=64x64");
    const Result<World> world = prepare(*scene);
    const std::string first = explanation_json(explain(*scene, *world, 30, 50).value(), *scene).value();
    for (const std::string& isa : isa_names())
        EXPECT_EQ(explanation_json(explain(*scene, *world, 30, 50, {-1, isa}).value(), *scene).value(), first)
            << isa;
}

// The sum of a pixel, computed by hand.
TEST(Explain, APlaneUnderOneLight) {
    Scene scene;
    scene.materials.push_back({.ambient = {0.1, 0.1, 0.1}, .diffuse = {0.5, 0.5, 0.5}});
    scene.add(Plane{}, 0);
    scene.add(Sphere{.center = {0, 2, 0}, .radius = 0.5}, 0);
    scene.lights.push_back({.kind = LightKind::ambient, .color = {1, 1, 1}});
    scene.lights.push_back({.position = {0, 4, 0}});
    scene.camera.position = {0, 1, 4};
    scene.camera.look_at = {0, 0, 0};
    scene.settings.width = scene.settings.height = 65;
    const Result<World> world = prepare(scene);
    ASSERT_TRUE(world);
    const Explanation e = explain(scene, *world, 32, 32).value();
    ASSERT_EQ(e.rays.size(), 1u);
    ASSERT_TRUE(e.rays[0].hit);
    const ExplainedHit& hit = *e.rays[0].hit;
    EXPECT_EQ(hit.shape, 0u);
    ASSERT_EQ(hit.lights.size(), 1u);
    const LightTerms& terms = hit.lights[0];
    EXPECT_EQ(terms.light, 1u);
    EXPECT_EQ(reason(terms), LightReason::blocked);
    ASSERT_TRUE(terms.blocker);
    EXPECT_EQ(terms.blocker->shape, 1u);
    EXPECT_NEAR(terms.blocker->distance, 1.5, 1e-6) << "the sphere's near side, seen from P";
    EXPECT_NEAR(e.value[0], 0.1f, 1e-7f);
}

TEST(Explain, ThePartOfAPolygon) {
    Scene scene;
    scene.polygon_vertices = {{-2, -2, 0}, {2, -2, 0}, {2, 2, 0}, {-2, 2, 0}};
    scene.add(Sphere{.center = {0, 0, -9}, .radius = 1});
    scene.add(Polygon{0, 4});
    scene.camera.position = {0, 0, 4};
    scene.settings.width = scene.settings.height = 33;
    const Result<World> world = prepare(scene);
    ASSERT_TRUE(world);
    std::set<std::uint32_t> elements;
    for (const int x : {4, 28}) {
        const ExplainedHit hit = explain(scene, *world, x, 14).value().rays[0].hit.value();
        EXPECT_EQ(hit.shape, 1u);
        elements.insert(hit.element);
    }
    EXPECT_EQ(elements, (std::set<std::uint32_t>{0, 1}));
}

TEST(Explain, ASpotAndItsCone) {
    Scene scene;
    scene.materials.push_back({.ambient = {0.1, 0.1, 0.1}, .diffuse = {0.5, 0.5, 0.5}});
    scene.add(Plane{}, 0);
    scene.add(Sphere{.center = {0, 2, 0}, .radius = 0.5}, 0);
    Light spot;
    spot.kind = LightKind::spot;
    spot.position = {0, 4, 0};
    spot.axis = {1, -2, 0};
    spot.inner_angle = 10;
    spot.outer_angle = 40;
    spot.fade_distance = spot.fade_power = 2;
    scene.lights = {spot, spot, spot};
    scene.lights[1].outer_angle = 20;
    scene.lights[2].casts_shadows = false;
    scene.camera.position = {0, 1, 4};
    scene.camera.look_at = {0, 0, 0};
    scene.settings.width = scene.settings.height = 65;
    const Result<World> world = prepare(scene);
    ASSERT_TRUE(world);
    const Explanation e =
        explain(scene, *world, 32, 32).value();  // of the origin, 26.57 degrees off the axis
    ASSERT_TRUE(e.rays.at(0).hit);
    const ExplainedHit& hit = *e.rays[0].hit;
    ASSERT_EQ(hit.lights.size(), 3u);
    EXPECT_EQ(reason(hit.lights[0]), LightReason::blocked);
    EXPECT_EQ(reason(hit.lights[1]), LightReason::outside_cone);
    EXPECT_EQ(hit.lights[1].spot, 0);
    EXPECT_EQ(reason(hit.lights[2]), LightReason::adds);
    EXPECT_FALSE(hit.lights[2].has_ray);
    EXPECT_NEAR(hit.lights[2].attenuation, 0.4, 1e-6);
    const double ct = 2 / std::sqrt(5.0), ci = std::cos(M_PI / 18), co = std::cos(M_PI * 2 / 9),
                 s = (ct - co) / (ci - co);
    EXPECT_NEAR(hit.lights[2].spot, s * s * (3 - 2 * s), 1e-5);
    EXPECT_NEAR(hit.lights[2].diffuse.r, 0.5 * 0.4 * s * s * (3 - 2 * s), 1e-5);
}

TEST(Explain, OneSampleAlone) {
    const auto scene = test::load_file(GLINT_PROJECT_DIR "/scenes/glint/glass.glint", "size=64x42 aa=3");
    const Result<World> world = prepare(*scene);
    const Explanation all = explain(*scene, *world, 15, 20).value();
    std::size_t rays = 0;
    for (int sample = 0; sample < 9; ++sample) {
        const Explanation one = explain(*scene, *world, 15, 20, {sample, {}}).value();
        rays += one.rays.size();
        for (const ExplainedRay& ray : one.rays) EXPECT_EQ(ray.sample, sample);
        for (int c = 0; c < 3; ++c) EXPECT_EQ(one.value[c], all.value[c]);
    }
    EXPECT_EQ(rays, all.rays.size());
    const std::vector<Color> values = sample_values(all).value();
    ASSERT_EQ(values.size(), 9u);
    Color sum;
    for (const Color& v : values) sum = sum + v;
    EXPECT_NEAR(sum.r / 9, all.value[0], 1e-6);
    EXPECT_NEAR(sum.g / 9, all.value[1], 1e-6);
    EXPECT_NEAR(sum.b / 9, all.value[2], 1e-6);
    EXPECT_FALSE(values[0] == values[8]) << "an edge: the samples differ";
    EXPECT_NE(explain(*scene, *world, 15, 20, {9, {}}).message, "");
}

// Between two mirrors of glass each sample has thousands of rays.
TEST(Explain, TooManyRaysNeedOneSampleAtATime) {
    Scene scene;
    scene.materials.push_back({.mirror = 0.5, .transmission = 0.5, .ior = 1.5});
    scene.add(Sphere{.center = {0, 0, -4}, .radius = 1}, 0);
    scene.add(Sphere{.center = {0, 0, -4}, .radius = 0.5}, 0);
    scene.settings.width = scene.settings.height = 9;
    scene.settings.reflections = 1000;
    scene.settings.samples = 8;
    const Result<World> world = prepare(scene);
    ASSERT_TRUE(world);
    EXPECT_NE(explain(scene, *world, 4, 4).message.find("ask for one of its samples"), std::string::npos);
    const Explanation one = explain(scene, *world, 4, 4, {36, {}}).value();
    EXPECT_GT(one.rays.size(), 1000u);
}

// A light that adds nothing although the surface faces it.
TEST(Explain, WhyThereIsNoHighlight) {
    Scene scene;
    scene.materials.push_back({.diffuse = {0, 0, 0}, .specular = {1, 1, 1}});
    scene.add(Plane{}, 0);
    // Both are low in front of the point: the reflected light points away from the eye.
    scene.lights.push_back({.position = {0, 0.5, 20}});
    scene.camera.position = {0, 0.5, 4};
    scene.camera.look_at = {0, 0, 2};
    scene.settings.width = scene.settings.height = 9;
    scene.settings.shading = Shading::phong;
    const Result<World> world = prepare(scene);
    const Explanation e = explain(scene, *world, 4, 4).value();
    ASSERT_TRUE(e.rays.at(0).hit);
    const ExplainedHit& hit = *e.rays[0].hit;
    EXPECT_EQ(reason(hit.lights.at(0)), LightReason::no_color);
    EXPECT_EQ(highlight_reason(hit.lights[0], hit, scene), HighlightReason::turned_away);
    scene.settings.shading = Shading::diffuse;
    EXPECT_EQ(highlight_reason(hit.lights[0], hit, scene), HighlightReason::unshaded);
}

TEST(Explain, InvalidRequests) {
    const auto scene = test::load_file(GLINT_PROJECT_DIR "/scenes/epfl/castle.json", "size=64x64");
    const Result<World> world = prepare(*scene);
    EXPECT_NE(explain(*scene, *world, 64, 0).message, "");
    EXPECT_NE(explain(*scene, *world, 0, -1).message, "");
    EXPECT_NE(explain(*scene, *world, 0, 0, {-1, "avx9"}).message, "");
}

TEST(Explain, SaysWhereInAMeshAPointIs) {
    MeshData mesh;
    mesh.single_positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, {5, -5, 0}};
    mesh.triangles = {{0, 1, 3}, {0, 1, 2}};
    mesh.colors.values = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
    Scene scene;
    scene.settings.width = scene.settings.height = 40;
    scene.camera.position = {7, 0, 5};
    scene.camera.look_at = {7, 0, 0};
    scene.lights.push_back({.position = {7, 2, 4}});
    scene.meshes.push_back(std::make_shared<const MeshData>(mesh));
    scene.transforms.resize(1);
    scene.transforms[0].m[0][3] = 7;
    scene.transforms[0].m[1][3] = 0.25;
    scene.add(Mesh{0}, k_none, 0);
    const Result<World> world = prepare(scene);
    ASSERT_TRUE(world);
    const Explanation e = explain(scene, *world, 19, 20).value();
    ASSERT_TRUE(e.rays[0].hit);
    const ExplainedHit& hit = *e.rays[0].hit;
    EXPECT_EQ(hit.triangle, 1);
    EXPECT_LT(length(hit.mesh_point - (hit.point - Vec3{7, 0.25, 0})), 1e-12);
    const Vec3 w = hit.corner_weights;
    EXPECT_NEAR(w.x + w.y + w.z, 1, 1e-12);
    EXPECT_LT(
        length(mesh.position(0) * w.x + mesh.position(1) * w.y + mesh.position(2) * w.z - hit.mesh_point),
        1e-9);
    ASSERT_TRUE(hit.color);
    EXPECT_NEAR(hit.color->r, w.x, 1e-6);
    EXPECT_NEAR(hit.color->g, w.y, 1e-6);
    EXPECT_NEAR(hit.color->b, w.z, 1e-6);
}

}  // namespace
}  // namespace glint::test
