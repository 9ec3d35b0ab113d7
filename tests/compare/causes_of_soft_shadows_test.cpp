// SPDX-License-Identifier: Apache-2.0
// Soft shadows in place of hard ones, and hard ones in place of soft ones, are the first cause that
// find_causes() names: of panels, discs and spheres, in scenes with one light and with several.
#include <functional>

#include "compare/planted_faults.h"

namespace glint::test {
namespace {

// Makes the light that is at `light` in the list an area light.
using Soften = std::function<void(Light&)>;

Soften panel(Vec3 side_u, Vec3 side_v, std::int32_t samples) {
    return [=](Light& l) {
        l.kind = LightKind::parallelogram;
        l.side_u = side_u;
        l.side_v = side_v;
        l.samples_u = l.samples_v = samples;
    };
}
#if !defined(GLINT_SANITIZED)
Soften disc(Vec3 axis, double radius, std::int32_t rings, std::int32_t around) {
    return [=](Light& l) {
        l.kind = LightKind::disc;
        l.axis = axis;
        l.radius = radius;
        l.samples_u = rings;
        l.samples_v = around;
    };
}
Soften ball(double radius, std::int32_t samples) {
    return [=](Light& l) {
        l.kind = LightKind::sphere;
        l.radius = radius;
        l.samples_u = l.samples_v = samples;
    };
}
#endif

// With one sample per pixel, at a size at which a test takes little time. The lights are points.
Scene hard_scene(const std::string& name, std::int32_t width, std::int32_t height) {
    std::ifstream file(GLINT_SOURCE "/scenes/" + name);
    const std::string source{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const SceneText texts[] = {{name, source, {}}};
    Result<Scene> result = load(texts);
    EXPECT_TRUE(result.has_value()) << name;
    Scene scene = result ? *std::move(result) : Scene{};
    scene.settings.width = width;
    scene.settings.height = height;
    scene.settings.samples = 1;
    for (Light& l : scene.lights) {
        if (l.is_area()) l.kind = LightKind::point;
    }
    return scene;
}

// `lights` are softened, by their places in the list.
void expect_both_ways(const Scene& hard, std::span<const std::size_t> lights, const Soften& soften,
                      const std::string& what) {
    Scene soft = hard;
    for (const std::size_t i : lights) soften(soft.lights[i]);
    const Image of_hard = as_file(draw(hard)), of_soft = as_file(draw(soft));
    ASSERT_NE(of_hard.rgb, of_soft.rgb) << what;
    const Result<CauseReport> softer = find_causes(of_soft, of_hard, &hard);
    EXPECT_EQ(first_cause(softer), "shadows-soft") << what << all_causes(softer);
    const Result<CauseReport> harder = find_causes(of_hard, of_soft, &soft);
    EXPECT_EQ(first_cause(harder), "shadows-hard") << what << all_causes(harder);
}

const std::string k_soft_room = R"(
background = (0.35, 0.45, 0.6)
camera { position = (0.5, 2.4, 7)  look_at = (0, 0.7, 0)  fov_x = 46 }
light { type = ambient  intensity = 0.3 }
light "lamp" { position = (1.5, 5, 2)  intensity = 0.7 }
light "other" { position = (-3, 4, 5)  intensity = 0.4 }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.6, 0.6, 0.55)  ambient = 0.2  diffuse = 0.8 }
sphere { center = (-1.2, 0.9, 0.4)  radius = 0.9  color = (0.9, 0.25, 0.2)  ambient = 0.2  diffuse = 0.7 }
box { min = (0.7, 0, -0.8)  max = (1.7, 1.5, 0.2)  color = (0.3, 0.4, 0.8)  ambient = 0.2  diffuse = 0.8 }
render { size = 240 x 180  shading = phong  reflections = 2 }
)";

constexpr std::size_t k_first[] = {1}, k_both[] = {1, 2};

TEST(CausesOfSoftShadows, ThreeSpheres) {
    const Scene scene = hard_scene("cgfs/three_spheres.cgfs", 120, 90);
    expect_both_ways(scene, k_first, panel({0.5, 0, 0}, {0, 0, 0.5}, 4), "panel");
#if !defined(GLINT_SANITIZED)
    expect_both_ways(scene, k_first, disc({-2, -1, 4}, 0.3, 4, 8), "disc");
    expect_both_ways(scene, k_first, ball(0.2, 4), "ball");
#endif
}

#if !defined(GLINT_SANITIZED)
TEST(CausesOfSoftShadows, ARoom) {
    Scene scene = read_scene(k_soft_room);
    scene.lights.pop_back();
    expect_both_ways(scene, k_first, panel({1.2, 0, 0}, {0, 0, 1.2}, 8), "panel");
    expect_both_ways(scene, k_first, disc({-1.5, -5, -2}, 0.5, 4, 8), "disc");
}
TEST(CausesOfSoftShadows, TwoLights) {
    Scene scene = read_scene(k_soft_room);
    for (const std::size_t i : k_both)
        scene.lights[i].color = scene.lights[i].specular_color = {0.4, 0.4, 0.4};
    expect_both_ways(scene, k_both, panel({0.8, 0, 0}, {0, 0, 0.8}, 4), "panels");
}
TEST(CausesOfSoftShadows, ACastle) {
    const Scene scene = hard_scene("epfl/castle.json", 240, 180);
    expect_both_ways(scene, k_first, panel({6, 0, 0}, {0, 6, 0}, 4), "panel");
}
#endif

}  // namespace
}  // namespace glint::test
