// SPDX-License-Identifier: Apache-2.0
// --aov light:NAME: one light alone, in files, in parts and in journals.
#include <gtest/gtest.h>

#include "cli/process.h"
#include "image/read_png.h"

namespace glint::test {
namespace {

constexpr auto k_lamps = R"(
camera { position = (0, 0, 5)  look_at = (0, 0, 0)  fov_x = 40 }
background = (0, 0, 1)
light "red"  { position = (-4, 2, 4)  color = (0.5, 0, 0) }
light "lamp" { position = (4, 2, 4)  color = (0, 0.5, 0) }
sphere { center = (0, 0, 0)  radius = 1  color = (1, 1, 1) }
)";

std::vector<std::string> render_lamps(const std::string& output, const std::string& layers) {
    return {"render", "a.glint", "-s", "90x70", "-q", "-o", output, "--aov", layers};
}

TEST(LightFiles, AreCalledByTheirNumbers) {
    const Folder folder;
    folder.write("a.glint", k_lamps);
    const Finished r = run(folder, render_lamps("a.png", "light:lamp,light:1,light:none,normal,light:2"));
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(folder.count(), 6);
    const Picture picture = read_png(folder.path("a.png")), red = read_png(folder.path("a.light-1.png")),
                  lamp = read_png(folder.path("a.light-2.png")),
                  none = read_png(folder.path("a.light-none.png"));
    ASSERT_EQ(none.samples.size(), picture.samples.size());
    int lit = 0;
    for (std::size_t i = 0; i < picture.samples.size(); i += 3) {
        EXPECT_EQ(red.samples[i], picture.samples[i]);
        EXPECT_EQ(lamp.samples[i + 1], picture.samples[i + 1]);
        EXPECT_EQ(none.samples[i + 2], picture.samples[i + 2]);
        EXPECT_EQ(red.samples[i + 1] + red.samples[i + 2] + lamp.samples[i] + lamp.samples[i + 2] +
                      none.samples[i] + none.samples[i + 1],
                  0);
        lit += red.samples[i] > 0 && lamp.samples[i + 1] > 0 ? 1 : 0;
    }
    EXPECT_GT(lit, 100);
}

TEST(LightFiles, AreTheSameInPartsAndJournals) {
    const Folder folder;
    folder.write("a.glint", k_lamps);
    const std::string layers = "depth,light:lamp,light:none";
    ASSERT_EQ(run(folder, render_lamps("whole.exr", layers)).code, 0);
    for (const char* const part : {"1", "2"}) {
        std::vector<std::string> arguments = render_lamps(std::string(part) + ".tiles", layers);
        arguments.insert(arguments.end(), {"--part", std::string(part) + "/2"});
        ASSERT_EQ(run(folder, arguments).code, 0);
    }
    ASSERT_EQ(run(folder, {"join", "1.tiles", "2.tiles", "-o", "joined.exr"}).code, 0);
    EXPECT_TRUE(folder.read("joined.exr") == folder.read("whole.exr"));
    EXPECT_NE(folder.read("whole.exr").find("light:2"), std::string::npos);
    std::vector<std::string> resumed = render_lamps("resumed.exr", layers);
    resumed.push_back("--resume");
    ASSERT_EQ(run(folder, resumed).code, 0);
    EXPECT_TRUE(folder.read("resumed.exr") == folder.read("whole.exr"));
}

TEST(LightFiles, UnknownLightsAreAnswered) {
    const Folder folder;
    folder.write("a.glint", k_lamps);
    for (const char* const name : {"lam", "3", "0"}) {
        const Finished r = run(folder, render_lamps("a.png", "light:" + std::string(name)));
        EXPECT_EQ(r.code, 2);
        EXPECT_TRUE(
            contains(r.err, "--aov: there is no light '" + std::string(name) + "'; there are 2 lights"))
            << r.err;
        EXPECT_TRUE(contains(r.err, "1: ") && contains(r.err, "'lamp'")) << r.err;
    }
    const Finished empty = run(folder, render_lamps("a.png", "light:"));
    EXPECT_TRUE(contains(empty.err, "expected the name or the number of a light")) << empty.err;
    const Finished stream = run(folder, render_lamps("-", "light:1"));
    EXPECT_TRUE(contains(stream.err, "standard output holds one picture")) << stream.err;
    EXPECT_EQ(folder.count(), 1);
}

}  // namespace
}  // namespace glint::test
