// SPDX-License-Identifier: Apache-2.0
// --alpha: a picture with an alpha channel, in one run, in parts and from a journal.
#include <gtest/gtest.h>

#include "cli/process.h"
#include "image/read_png.h"

namespace glint::test {
namespace {

using Arguments = std::vector<std::string>;

Arguments joined(Arguments a, const Arguments& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

constexpr auto k_ball = R"(
background = (0, 0.5, 1)
camera { position = (0, 0, 5)  look_at = (0, 0, 0)  fov_x = 40 }
light { type = ambient  intensity = 1 }
sphere { center = (-0.5, 0, 0)  radius = 1  color = (1, 0.5, 0.25)  ambient = 1 }
disc { center = (1, 0, 1)  normal = (0, 0, 1)  radius = 0.4  ambient_color = (0, 0, 0)  diffuse = 0  transmission = 0.6 }
)";
const Arguments k_render_ball{"render", "a.glint", "-s", "90x70", "--alpha", "--aa", "2", "-q"};

TEST(AlphaFiles, PngIsStraight) {
    const Folder folder;
    folder.write("a.glint", k_ball);
    ASSERT_EQ(run(folder, joined(k_render_ball, {"-o", "a.png"})).code, 0);
    const Picture picture = read_png(folder.path("a.png"));
    ASSERT_EQ(picture.error, "");
    ASSERT_EQ(picture.channels, 4);
    int partly = 0, glass = 0;
    for (std::size_t i = 0; i < picture.samples.size(); i += 4) {
        const std::uint16_t* p = &picture.samples[i];
        if (p[3] == 0) {
            EXPECT_EQ(p[0] + p[1] + p[2], 0);
            continue;
        }
        partly += p[3] < 255 ? 1 : 0;
        if (p[3] == 102) {  // glass: 1 - 0.6, and nothing of the background
            EXPECT_EQ(p[0] + p[1] + p[2], 0);
            ++glass;
        } else if (p[2] > 0) {  // the ball, at its edge too
            EXPECT_EQ(p[0], 255);
            EXPECT_EQ(p[1], 128);
            EXPECT_EQ(p[2], 64);
        }
    }
    EXPECT_GT(partly, 100);
    EXPECT_GT(glass, 50);
}

TEST(AlphaFiles, SettingOfTheScene) {
    const Folder folder;
    folder.write("a.glint", k_ball);
    ASSERT_EQ(run(folder, joined(k_render_ball, {"-o", "a.png"})).code, 0);
    folder.write("b.glint", std::string("render { size = 90 x 70  aa = 2  alpha = true }") + k_ball);
    ASSERT_EQ(run(folder, {"render", "b.glint", "-o", "b.png", "-q"}).code, 0);
    EXPECT_TRUE(folder.read("a.png") == folder.read("b.png"));
}

TEST(AlphaFiles, PartsAndJournals) {
    const Folder folder;
    folder.write("a.glint", k_ball);
    for (const Arguments& more : {Arguments{}, Arguments{"--aov", "alpha,depth"}}) {
        for (const char* ending : {".png", ".exr"}) {
            SCOPED_TRACE(ending);
            const auto name = [&](const char* stem) { return std::string(stem) + ending; };
            const Arguments render = joined(k_render_ball, more);
            ASSERT_EQ(run(folder, joined(render, {"-o", name("a")})).code, 0);
            ASSERT_EQ(run(folder, joined(render, {"-o", name("b"), "--resume"})).code, 0);
            EXPECT_TRUE(folder.read(name("a")) == folder.read(name("b")));
            ASSERT_EQ(run(folder, joined(render, {"-o", "1.tiles", "--part", "1/2"})).code, 0);
            ASSERT_EQ(run(folder, joined(render, {"-o", "2.tiles", "--part", "2/2"})).code, 0);
            ASSERT_EQ(run(folder, {"join", "1.tiles", "2.tiles", "-q", "-o", name("c")}).code, 0);
            EXPECT_TRUE(folder.read(name("a")) == folder.read(name("c")));
            EXPECT_FALSE(folder.has("a.alpha.png")) << "it is the channel of the picture";
        }
    }
    EXPECT_TRUE(folder.has("a.depth.png"));
}

TEST(AlphaFiles, PpmHasNone) {
    const Folder folder;
    folder.write("a.glint", k_ball);
    const Finished r = run(folder, joined(k_render_ball, {"-o", "a.ppm"}));
    EXPECT_EQ(r.code, 2);
    EXPECT_TRUE(contains(r.err, "PPM has no alpha channel")) << r.err;
    EXPECT_FALSE(folder.has("a.ppm"));
}

TEST(AlphaFiles, Explained) {
    const Folder folder;
    folder.write("a.glint", k_ball);
    const Finished r = run(folder, {"explain", "a.glint", "-s", "90x70", "--alpha", "-p", "75,34"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(contains(r.out, "hits nothing: alpha loses 0.6")) << r.out;
    EXPECT_TRUE(contains(r.out, "alpha        0.4")) << r.out;
}

TEST(AlphaFiles, AdaptiveSamplesInParts) {
    const Folder folder;
    folder.write("a.glint", k_ball);
    const Arguments render{"render", "a.glint", "-s", "90x70", "--aa", "adaptive:3:0.02", "-q"};
    ASSERT_EQ(run(folder, joined(render, {"-o", "a.png"})).code, 0);
    ASSERT_EQ(run(folder, joined(render, {"-o", "1.tiles", "--part", "1/2"})).code, 0);
    ASSERT_EQ(run(folder, joined(render, {"-o", "2.tiles", "--part", "2/2"})).code, 0);
    ASSERT_EQ(run(folder, {"join", "1.tiles", "2.tiles", "-q", "-o", "b.png"}).code, 0);
    EXPECT_TRUE(folder.read("a.png") == folder.read("b.png"));
    const Finished r =
        run(folder, {"explain", "a.glint", "-s", "90x70", "--aa", "adaptive:3:0.02", "-p", "5,5"});
    EXPECT_TRUE(contains(r.out, "adaptive sampling: one sample")) << r.out;
}

}  // namespace
}  // namespace glint::test
