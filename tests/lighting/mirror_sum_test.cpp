// SPDX-License-Identifier: Apache-2.0
// docs/lighting.md, "Mirrors as a sum": the recursion, the sum, both readings of "at most N reflections", and
// the renderer.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

#include "glint/glint.h"

namespace glint::test {
namespace {

/// The surfaces that a ray hits: their local colors c_i and mirror coefficients a_i, in order.
struct Chain {
    std::vector<double> color, mirror;
};

// The example of the text. All numbers are exact in binary, so the comparisons are exact.
const Chain k_example = {{0.75, 0.5, 0.25, 1}, {0.5, 0.25, 0.5, 0}};

/// c^i = (1 - a_i) c_i + a_i c^(i+1), and black after the last surface.
double recursion(const Chain& chain, std::size_t i = 0) {
    if (i == chain.color.size()) return 0;
    const double a = chain.mirror[i];
    return (1 - a) * chain.color[i] + a * recursion(chain, i + 1);
}

/// The sum over i < count of (1 - a_i) (a_0 ... a_(i-1)) c_i; `weight` becomes a_0 ... a_(count-1).
double partial_sum(const Chain& chain, std::size_t count, double& weight) {
    double sum = 0;
    weight = 1;
    for (std::size_t i = 0; i < count; ++i) {
        sum += (1 - chain.mirror[i]) * weight * chain.color[i];
        weight *= chain.mirror[i];
    }
    return sum;
}

double sum_of(const Chain& chain, LimitRule limit, std::size_t reflections) {
    double weight = 1;
    if (limit == LimitRule::drop) return partial_sum(chain, reflections + 1, weight);
    const double before = partial_sum(chain, reflections, weight);
    return before + weight * chain.color[reflections];
}

TEST(MirrorSum, EqualsTheRecursion) {
    double weight = 1;
    EXPECT_EQ(recursion(k_example), 0.640625);
    EXPECT_EQ(partial_sum(k_example, 4, weight), 0.640625);
    EXPECT_EQ(weight, 0);
    Chain chain;
    for (int i = 0; i < 200; ++i) {
        chain.color.push_back(std::fmod(i * 0.37, 1.0));
        chain.mirror.push_back(0.5 + 0.5 * std::fmod(i * 0.61, 1.0));
    }
    EXPECT_NEAR(partial_sum(chain, 200, weight), recursion(chain), 1e-15);
}

TEST(MirrorSum, HasTwoReadingsAtTheLimit) {
    const double keep[] = {0.75, 0.625, 0.59375, 0.640625};
    const double drop[] = {0.375, 0.5625, 0.578125, 0.640625};
    for (std::size_t n = 0; n < 4; ++n) {
        EXPECT_EQ(sum_of(k_example, LimitRule::keep, n), keep[n]) << n;
        EXPECT_EQ(sum_of(k_example, LimitRule::drop, n), drop[n]) << n;
        double weight = 1;
        partial_sum(k_example, n + 1, weight);
        EXPECT_EQ(keep[n] - drop[n], weight * k_example.color[n]) << n;
    }
}

// A ray with the directions +x, +y, -x, +y between four spheres, each with one color in any light.
Scene zigzag(const Chain& chain) {
    Scene scene;
    apply_profile(scene, "epfl");
    scene.settings.width = scene.settings.height = 1;
    scene.camera.look_at = {1, 0, 0};
    scene.camera.up = {0, 0, 1};
    Light ambient;
    ambient.kind = LightKind::ambient;
    scene.lights.push_back(ambient);
    const double k = std::sqrt(0.5);
    const Vec3 centers[] = {{10 + k, -k, 0}, {10 + k, 10 + k, 0}, {-k, 10 - k, 0}, {0, 21, 0}};
    for (std::size_t i = 0; i < 4; ++i) {
        Material material;
        material.ambient = {chain.color[i], chain.color[i], chain.color[i]};
        material.diffuse = material.specular = {0, 0, 0};
        material.mirror = chain.mirror[i];
        scene.materials.push_back(material);
        scene.add(Sphere{centers[i], 1}, static_cast<std::uint32_t>(i));
    }
    return scene;
}

TEST(MirrorSum, EqualsTheRenderedPixel) {
    Scene scene = zigzag(k_example);
    for (const LimitRule limit : {LimitRule::keep, LimitRule::drop}) {
        scene.conventions.limit = limit;
        for (std::int32_t n = 0; n < 4; ++n) {
            scene.settings.reflections = n;
            const Result<World> prepared = prepare(scene, {.threads = 1});
            ASSERT_TRUE(prepared);
            const Result<Rendering> result = render(*prepared);
            ASSERT_TRUE(result) << result.message;
            EXPECT_EQ(result->image.rgb[0], sum_of(k_example, limit, static_cast<std::size_t>(n)))
                << "limit " << static_cast<int>(limit) << ", " << n << " reflections";
        }
    }
}

}  // namespace
}  // namespace glint::test
