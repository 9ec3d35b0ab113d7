// SPDX-License-Identifier: Apache-2.0
// Shapes that lie in one another make every ray expensive: then there are fewer of them.
#include "check/check_text.h"
#include "check/visible_hits.h"
#include "gallery/scene_file.h"

namespace glint::test {
namespace {

// Shells around the camera, by a ball that is hidden behind the first of them.
std::string shells(int count) {
    std::string text =
        "camera { position = (0, 0, 0.1)  look_at = (0, 0, -1) }\n"
        "light { type = ambient  intensity = 0.2 }\n"
        "sphere \"ball\" { center = (0, 0, -9)  radius = 1  ambient = 1 }\n";
    for (int i = 0; i < count; ++i)
        text += fmt::format("sphere {{ center = (0, 0, 0)  radius = {}  ambient = 1 }}\n", 1 + 0.001 * i);
    return text;
}

struct Looked {
    double shapes_per_ray;
    SmallSize size;
    std::string coarse;
};
Looked look(const Scene& scene) {
    Result<World> prepared = prepare(scene);
    EXPECT_TRUE(prepared);
    const CheckOptions options;
    CheckContext context(scene, *prepared, options);
    return {shapes_per_ray(context.world(), 0), context.grid(VisibleHits::k_longest),
            context.coarse_grid(VisibleHits::k_longest)};
}

TEST(CheckCost, ShapesInOneAnotherGetACoarserGrid) {
    const Looked looked = look(*load_text(shells(3000), "a.glint"));
    EXPECT_NEAR(looked.shapes_per_ray, 3000, 1)
        << "the camera is in all of their boxes, and not in the ball's";
    EXPECT_LT(looked.shapes_per_ray * looked.size.width * looked.size.height, 6e7);
    EXPECT_GT(looked.size.width, 100);
    EXPECT_EQ(looked.coarse, fmt::format("; looked at with {}x{} rays only, each of which meets the boxes of "
                                         "3000 shapes",
                                         looked.size.width, looked.size.height));
    const std::vector<Finding> result = check_text(shells(3000));
    ASSERT_FALSE(result.empty());
    const auto hidden =
        std::find_if(result.begin(), result.end(), [](const Finding& f) { return f.id == "shape-hidden"; });
    ASSERT_NE(hidden, result.end()) << ids(result);
    EXPECT_TRUE(has(hidden->diagnostic.message, "'ball'")) << hidden->diagnostic.message;
    EXPECT_TRUE(has(hidden->diagnostic.message, looked.coarse)) << hidden->diagnostic.message;
}

TEST(CheckCost, AFewDoNot) {
    const Looked looked = look(*load_text(shells(100), "a.glint"));
    EXPECT_EQ(looked.size.width, 640);
    EXPECT_EQ(looked.coarse, "");
}

TEST(CheckCost, TheGalleryIsLookedAtWhole) {
    for (const std::string& path : test::scene_files(GLINT_SOURCE_DIR "/scenes")) {
        const auto scene = test::load_file(path, "");
        ASSERT_TRUE(scene) << path;
        EXPECT_EQ(look(*scene).coarse, "") << path;
    }
}

}  // namespace
}  // namespace glint::test
