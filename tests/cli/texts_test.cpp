// SPDX-License-Identifier: Apache-2.0
// The text functions of the command.
#include <gtest/gtest.h>

#include "cli/foreign_flags.h"
#include "cli/half_blocks.h"
#include "cli/progress.h"
#include "cli/text.h"

namespace glint::test {
using namespace cli;
namespace {

TEST(Texts, Sizes) {
    ASSERT_TRUE(parse_size("640x480"));
    EXPECT_EQ(parse_size("640x480")->height, 480);
    for (const char* text : {"", "640", "x480", "640x", "640X480", "640x480x2", "640x480 ", " 640x480",
                             "6.4x5", "99999999999999999999x1"}) {
        EXPECT_FALSE(parse_size(text)) << text;
    }
}

TEST(Texts, Crops) {
    const auto crop = parse_crop("20x10+3+4");
    ASSERT_TRUE(crop);
    EXPECT_EQ(crop->width, 20);
    EXPECT_EQ(crop->height, 10);
    EXPECT_EQ(crop->x, 3);
    EXPECT_EQ(crop->y, 4);
    for (const char* text : {"", "20x10", "20x10+3", "0x10+0+0", "20x10+-3+4", "20x10+3+4+5", "20x10-3+4"}) {
        EXPECT_FALSE(parse_crop(text)) << text;
    }
}

TEST(Texts, Numbers) {
    EXPECT_EQ(with_commas(0), "0");
    EXPECT_EQ(with_commas(999), "999");
    EXPECT_EQ(with_commas(1000), "1,000");
    EXPECT_EQ(with_commas(1024311), "1,024,311");
    EXPECT_EQ(counted(1, "warning"), "1 warning");
    EXPECT_EQ(counted(1000, "warning"), "1,000 warnings");
    EXPECT_EQ(counted(1, "box"), "1 box");
    EXPECT_EQ(counted(2, "box"), "2 boxes");
    EXPECT_EQ(counted(1, "torus"), "1 torus");
    EXPECT_EQ(counted(2, "torus"), "2 tori");
    EXPECT_EQ(bytes_text(12), "12 bytes");
    EXPECT_EQ(bytes_text(120e9), "120.0 GB");
}

TEST(Texts, Paths) {
    EXPECT_EQ(stem("a/b.c/scene.two.cgfs"), "scene.two");
    EXPECT_EQ(stem("scene"), "scene");
    EXPECT_EQ(stem(".hidden"), ".hidden");
    EXPECT_EQ(extension("a.b/scene"), "");
    EXPECT_EQ(extension("a/SCENE.PNG"), ".png");
    EXPECT_EQ(extension(".png"), "");
}

TEST(Texts, Progress) {
    EXPECT_EQ(progress_text(0, 1, 80), "[                              ]   0%");
    EXPECT_EQ(progress_text(0.5, 72, 80), "[###############               ]  50%  1:12 left");
    EXPECT_EQ(progress_text(0.01, 100, 80), "[                              ]   1%  2:45:00 left");
    EXPECT_EQ(progress_text(0.5, 72, 28), "[#####     ]  50%  1:12 left");
    EXPECT_EQ(progress_text(0.5, 72, 20), "  50%  1:12 left");
    EXPECT_EQ(progress_text(0.5, 72, 10), "  50%");
    for (int columns = 5; columns < 60; ++columns) {
        EXPECT_LE(progress_text(0.01, 100, columns).size(), static_cast<std::size_t>(columns));
    }
}

// The test's own clock, in seconds.
int fake_time = 0;
ProgressBar::Clock::time_point fake_now() {
    return ProgressBar::Clock::time_point(std::chrono::seconds(fake_time));
}

TEST(Texts, ProgressWithoutATerminalIsALineEveryTenSeconds) {
    testing::internal::CaptureStderr();
    {
        ProgressBar bar(true, fake_now), quiet(false, fake_now);
        for (fake_time = 0; fake_time < 40; ++fake_time) {
            bar.update(fake_time / 40.0);
            quiet.update(fake_time / 40.0);
        }
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "glint: 25%  0:30 left\nglint: 50%  0:20 left\nglint: 75%  0:10 left\n");
}

TEST(Texts, HalfBlocks) {
    const Image image{2, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 0.5f, 0.5f, 0.5f}};
    EXPECT_EQ(half_blocks(image, 80, {}),
              "\x1b[38;2;255;0;0;48;2;0;0;255m▀\x1b[38;2;0;255;0;48;2;255;255;255m▀\x1b[0m\n"
              "\x1b[38;2;0;0;0m▀\x1b[38;2;128;128;128m▀\x1b[0m\n");
    // Scaled to one column: the mean of white and black is 127.5, rounded to even.
    const Image wide{2, 2, {1, 1, 1, 0, 0, 0, 0, 0, 0, 1, 1, 1}};
    EXPECT_EQ(half_blocks(wide, 1, {}), "\x1b[38;2;128;128;128m▀\x1b[0m\n");
}

TEST(Texts, ForeignFlags) {
    const auto answer = [](const std::vector<std::string>& arguments) {
        const bool named = arguments.front() == "render" || arguments.front() == "check";
        const std::span<const std::string> all(arguments);
        return answer_foreign_flags(all.subspan(named ? 1 : 0), named ? arguments.front() : "render",
                                    [](const std::string&) { return true; })
            .value_or("");
    };
    EXPECT_EQ(answer({"render", "a.cgfs", "-o", "a.png", "-s", "64x64", "-t", "2", "--aa", "3"}), "");
    EXPECT_EQ(answer({"render", "a.cgfs", "--seed", "7", "--alpha", "--aa", "2:jitter"}), "");
    EXPECT_EQ(answer({"render", "a.cgfs", "-"}), "");
    EXPECT_EQ(answer({"render", "--", "+a.cgfs"}), "");
    EXPECT_EQ(answer({"render", "+W64", "+H48"}),
              "+W64 +H48: use --size 64x48\ncommand: glint render --size 64x48");
    EXPECT_EQ(answer({"+w64"}),
              "+w64: use --size 64x64, which has both width and height\n"
              "command: glint render --size 64x64");
    EXPECT_EQ(answer({"render", "a.json", "--width", "64", "--height=48", "-i", "b.json"}),
              "--width 64 --height 48: use --size 64x48\n-i b.json: use b.json\n"
              "command: glint render a.json b.json --size 64x48");
    EXPECT_EQ(answer({"--input=a.json", "--spp", "16", "--jobs", "2"}),
              "--input a.json: use a.json\n--spp 16: use --aa 4\n--jobs 2: use --threads 2\n"
              "command: glint render a.json --aa 4 --threads 2");
    EXPECT_EQ(answer({"check", "a.json", "--samples", "5"}),
              "--samples 5: use --aa 3\ncommand: glint check a.json --aa 3");
    EXPECT_EQ(answer({"+KC"}),
              "+KC: glint has no animation clock; glint-povray takes it\ncommand: glint render SCENE");
    for (const std::string flag : {"+UF", "+UO", "-UF"})
        EXPECT_EQ(answer({flag}),
                  flag + ": glint renders whole frames; leave it out\ncommand: glint render SCENE");
    for (const char* flag :
         {"--width",    "--height",     "-i",           "--input",    "--samples", "--spp",  "--jobs",
          "-j",         "--depth",      "+A",           "-A",         "+D",        "-D",     "+R3",
          "+WT4",       "+Q9",          "+FN16",        "+SC10",      "-V",        "+L/usr", "+Z",
          "-fullshade", "-mediumshade", "-lowestshade", "-aasamples", "-raydepth", "-res",   "-verbose"}) {
        const std::string text = answer({"a.cgfs", flag});
        EXPECT_EQ(text.find(flag), 0u) << text;
        EXPECT_NE(text.find("\ncommand: glint render a.cgfs"), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace glint::test
