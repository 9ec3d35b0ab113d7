// SPDX-License-Identifier: Apache-2.0
// check follows the rays that the picture is made of: those that explain() writes down of its pixels.
#include "check/visible_hits.h"

#include <algorithm>
#include <array>
#include <initializer_list>

#include "check/check_text.h"
#include "gallery/scene_file.h"
#include "glint/explain.h"

namespace glint::test {
namespace {

using Numbers = std::array<double, 8>;

Numbers numbers(Vec3 a, Vec3 b = {}, double c = 0, double d = 0) {
    return {a.x, a.y, a.z, b.x, b.y, b.z, c, d};
}

void expect_the_rays_of_the_picture(std::initializer_list<const char*> files, const char* settings) {
    for (const char* file : files) {
        const auto scene =
            test::load_file(GLINT_SOURCE_DIR + std::string(file), std::string("size=40x30 aa=1 ") + settings);
        ASSERT_TRUE(scene) << file;
        Result<World> prepared = prepare(*scene);
        ASSERT_TRUE(prepared);
        const CheckOptions options;
        CheckContext context(*scene, *prepared, options);
        const VisibleHits visible(context);
        ASSERT_EQ(visible.size.width, 40);
        ASSERT_GE(visible.generations.size(), 2u) << file;

        std::vector<std::vector<Numbers>> points(visible.generations.size());
        std::vector<std::vector<Numbers>> shadows(prepared->parts().lights->size());
        for (int y = 0; y < 30; ++y) {
            for (int x = 0; x < 40; ++x) {
                for (const ExplainedRay& ray : explain(*scene, *prepared, x, y).value().rays) {
                    const auto generation = static_cast<std::size_t>(ray.generation);
                    if (!ray.hit || generation >= points.size()) continue;
                    points[generation].push_back(numbers(ray.hit->point));
                    for (std::size_t l = 0; l < ray.hit->lights.size(); ++l) {
                        const LightTerms& terms = ray.hit->lights[l];
                        if (terms.has_ray && terms.n_l > 0)
                            shadows[l].push_back(
                                numbers(terms.origin, terms.direction, terms.t_min, terms.t_max));
                    }
                }
            }
        }
        for (std::size_t g = 0; g < points.size(); ++g) {
            std::vector<Numbers> found;
            for (const SurfaceHit& hit : visible.generations[g]) found.push_back(numbers(hit.point));
            std::sort(found.begin(), found.end());
            std::sort(points[g].begin(), points[g].end());
            EXPECT_TRUE(found == points[g]) << file << " generation " << g << ": " << found.size()
                                            << " hits, " << points[g].size() << " in the picture";
        }
        // Those of points whose material reflects the light: all that the picture traces, and no others
        // there.
        EXPECT_TRUE(std::any_of(shadows.begin(), shadows.end(), [](const auto& of) { return !of.empty(); }));
        for (std::size_t l = 0; l < shadows.size(); ++l) {
            const ShadowRays rays =
                shadow_rays(prepared->parts(), visible, (*prepared->parts().lights)[l], 1000000);
            std::vector<Numbers> found;
            const RaySpan span = rays.rays.from(0);
            for (std::size_t i = 0; i < rays.rays.size(); ++i)
                found.push_back(
                    numbers(rays.rays.origin(i), rays.rays.direction(i), span.t_min[i], rays.rays.t_max(i)));
            std::sort(found.begin(), found.end());
            std::sort(shadows[l].begin(), shadows[l].end());
            EXPECT_TRUE(std::includes(found.begin(), found.end(), shadows[l].begin(), shadows[l].end()))
                << file << " light " << l << ": " << found.size() << " of " << shadows[l].size();
        }
    }
}

class VisibleHitsTest : public testing::TestWithParam<const char*> {};

TEST_P(VisibleHitsTest, FollowsTheRaysOfThePicture) {
    expect_the_rays_of_the_picture({"/scenes/glint/glass.glint", "/scenes/csc473/glass_ball.pov"},
                                   GetParam());
}

INSTANTIATE_TEST_SUITE_P(Rules, VisibleHitsTest,
                         testing::Values("offset=scale", "offset=ray epsilon=0.001",
                                         "offset=normal epsilon=0.001", "offset=facing epsilon=0.001",
                                         "offset=direction epsilon=0.001", "shadow_stops_at_light=false",
                                         "facing=winding", "fresnel=schlick offset=normal epsilon=0.001"));

class VisibleThroughTransparentHits : public testing::TestWithParam<const char*> {};

TEST_P(VisibleThroughTransparentHits, AreThoseOfThePicture) {
    expect_the_rays_of_the_picture({"/scenes/glint/stained_glass.glint"}, GetParam());
}

INSTANTIATE_TEST_SUITE_P(Rules, VisibleThroughTransparentHits,
                         testing::Values("", "offset=direction epsilon=0.001", "transparent_epsilon=0.05",
                                         "transparent_surfaces=1", "transparency_counts=true reflections=2"));

}  // namespace
}  // namespace glint::test
