// SPDX-License-Identifier: Apache-2.0
// diagnose() and propose_pixels(): with a scene edited after prepare(), and with logs and pictures of no
// sense.
#include "misuse/misused.h"

namespace glint::test {
namespace {

constexpr std::string_view k_log =
    "pixel 10 7\nray camera\nshape 1\nN 0 1 0\nlight 1\nN.L 0.5\ndiffuse 1 1 1\n";

TEST(Misuse, OfDiagnose) {
    const Scene scene = some_scene();
    const World world = world_of(scene);
    const Result<Diagnosis> good = diagnose(scene, world, k_log);
    ASSERT_EQ(good.message, "");
    EXPECT_TRUE(diagnosis_json(*good, scene));
    EXPECT_TRUE(diagnosis_json(*good, Scene{}));
    EXPECT_TRUE(diagnosis_json(Diagnosis{}, scene));
    for (const int threads : {-1, 0, 1, 100000}) {
        DiagnoseOptions options;
        options.threads = threads;
        EXPECT_EQ(diagnose(scene, world, k_log, options).message, "") << threads;
    }
    const std::string_view nothing[] = {"",  std::string_view("\0\0", 2), "pixel",       "pixel 1e9 1e9",
                                        "{", "pixel nan nan\n",           "ray camera\n"};
    for (const std::string_view log : nothing) EXPECT_NE(diagnose(scene, world, log).message, "") << log;
    Scene edited = scene;
    edited.lights.clear();
    EXPECT_EQ(diagnose(edited, world, k_log).code, ErrorCode::invalid_argument);
    EXPECT_EQ(diagnose(Scene{}, world, k_log).code, ErrorCode::invalid_argument);
    EXPECT_GT(diagnosed_causes().size(), 100u);
}

TEST(Misuse, OfProposePixels) {
    const Scene scene = some_scene();
    const World world = world_of(scene);
    EXPECT_TRUE(propose_pixels(scene, world, picture(16, 12)));
    EXPECT_EQ(propose_pixels(scene, world, picture(12, 16)).code, ErrorCode::invalid_argument);
    EXPECT_EQ(propose_pixels(scene, world, Image{}).code, ErrorCode::invalid_argument);
    Image odd = picture(16, 12);
    odd.rgb.resize(5);
    EXPECT_EQ(propose_pixels(scene, world, odd).code, ErrorCode::invalid_argument);
}

}  // namespace
}  // namespace glint::test
