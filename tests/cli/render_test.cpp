// SPDX-License-Identifier: Apache-2.0
// glint render: the picture, its file and the messages.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "cli/process.h"
#include "image/read_png.h"

namespace glint::test {
namespace {

TEST(Render, DefaultsToTheScenesNameInTheCurrentFolder) {
    const Folder folder;
    std::filesystem::create_directory(folder.path("deep"));
    folder.write("deep/ball.one.cgfs", k_scene);
    const Finished r = run(folder, {"render", "deep/ball.one.cgfs", "-s", "40x30"});
    EXPECT_EQ(r.code, 0) << r.err;
    const Picture picture = read_png(folder.path("ball.one.png"));
    EXPECT_EQ(picture.error, "");
    EXPECT_EQ(picture.width, 40);
    EXPECT_EQ(picture.height, 30);
    EXPECT_EQ(r.out, "");
}

TEST(Render, EndsWithOneLine) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const Finished r = run(folder, {"render", "a.cgfs", "-s", "100x80", "-t", "2"});
    const std::regex line(R"(a\.png  100x80  \d{1,3}(,\d{3})* rays  \d+\.\d{3} s  \d+\.\d Mray/s  )"
                          R"(\(total \d+\.\d{3} s, 2 threads, [a-z0-9]+, 0 warnings\)\n)");
    EXPECT_TRUE(std::regex_match(r.err, line)) << r.err;
    EXPECT_EQ(run(folder, {"render", "a.cgfs", "-s", "10x10", "--quiet"}).err, "");
}

TEST(Render, StrictDrawsNothingThatIsWarnedOf) {
    const Folder folder;
    folder.write("good.cgfs", k_scene);
    folder.write(
        "warned.cgfs",
        std::string(k_scene) + "sphere { center = (0, 0, 9)  radius = 1  color = (1, 1, 1)  glow = 3 }\n");
    for (const bool quiet : {false, true}) {
        std::vector<std::string> strict = {"render",   "warned.cgfs", "-s",    "9x9",
                                           "--strict", "--stats",     "s.json"};
        if (quiet) strict.push_back("--quiet");
        const Finished r = run(folder, strict);
        EXPECT_EQ(r.code, 1);
        EXPECT_TRUE(contains(r.err, "warned.cgfs:4:")) << r.err;
        EXPECT_TRUE(contains(r.err, "glint: --strict: 1 warning, so no picture is written\n")) << r.err;
    }
    EXPECT_EQ(folder.count(), 2);
    EXPECT_EQ(run(folder, {"render", "warned.cgfs", "-s", "9x9"}).code, 0);
    EXPECT_EQ(run(folder, {"render", "good.cgfs", "-s", "9x9", "--strict"}).code, 0);
    EXPECT_TRUE(folder.has("good.png"));
}

// Spheres that are both glass and mirror: more rays than a sample may have.
TEST(Render, StrictCountsRaysThatAreNotTraced) {
    const Folder folder;
    folder.write("cut.glint", R"(camera { position = (0, 0, 8)  look_at = (0, 0, 0)  fov_x = 50 }
conventions { mirror = add }
material "glass" { diffuse = 0  mirror = 1  transmission = 1  ior = 1.5 }
sphere { center = (0, 0, 0)  radius = 9  material = "glass" }
sphere { center = (1, 0, 0)  radius = 7  material = "glass" }
sphere { center = (0, 1, 0)  radius = 5  material = "glass" }
light { type = ambient  intensity = 0.2 }
)");
    const std::vector<std::string> arguments = {"render", "cut.glint", "-s", "4x4", "--reflections", "1000"};
    const Finished r = run(folder, arguments);
    ASSERT_EQ(r.code, 0);
    ASSERT_TRUE(contains(r.err, "were not traced")) << r.err;
    std::filesystem::remove(folder.path("cut.png"));
    auto strict = arguments;
    strict.emplace_back("--strict");
    EXPECT_EQ(run(folder, strict).code, 1);
    EXPECT_FALSE(folder.has("cut.png"));
}

TEST(Render, SeveralFilesAreOneScene) {
    const Folder folder;
    const std::string whole = k_scene;
    const std::size_t cut = whole.find("light");
    folder.write("whole.cgfs", whole);
    folder.write("spheres.cgfs", whole.substr(0, cut));
    folder.write("lights.cgfs", whole.substr(cut));
    EXPECT_EQ(run(folder, {"render", "whole.cgfs", "-s", "50x50"}).code, 0);
    EXPECT_EQ(run(folder, {"render", "spheres.cgfs", "lights.cgfs", "-s", "50x50"}).code, 0);
    EXPECT_EQ(folder.read("whole.png"), folder.read("spheres.png"));
}

TEST(Render, WarnsAboutNoLightsAndCountsIt) {
    const Folder folder;
    folder.write("dark.cgfs", "sphere { center = (0, 0, 4)  radius = 1  color = (255, 0, 0) }");
    const Finished r = run(folder, {"render", "dark.cgfs", "-s", "10x10"});
    EXPECT_EQ(r.code, 0);
    EXPECT_TRUE(contains(r.err, "warning: ")) << r.err;
    EXPECT_TRUE(contains(r.err, "1 warning)")) << r.err;
}

TEST(Render, StandardInputAndOutput) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "60x40"}).code, 0);
    const std::string expected = folder.read("a.png");
    const auto piped =
        run(folder, {"render", "-", "--format", "cgfs", "-s", "60x40", "-o", "-"}, with_input(k_scene));
    EXPECT_EQ(piped.out, expected) << piped.err;
    EXPECT_EQ(run(folder, {"render", "a.cgfs", "-s", "60x40", "-o", "/dev/stdout"}).out, expected);
    ASSERT_EQ(run(folder, {"render", "-", "--format", "cgfs", "-s", "60x40"}, with_input(k_scene)).code, 0);
    EXPECT_EQ(folder.read("picture.png"), expected);
    // If standard output is a file, it is written in place, not replaced.
    const auto to_file = with_output_to(folder.path("b.png"));
    ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "60x40", "-o", "-"}, to_file).code, 0);
    EXPECT_EQ(folder.read("b.png"), expected);
}

TEST(Render, TheExtensionChoosesTheFormat) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    for (const char* name : {"a.png", "a.PNG", "a.ppm", "a.exr"}) {
        ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "9x7", "-o", name}).code, 0) << name;
    }
    EXPECT_EQ(folder.read("a.png"), folder.read("a.PNG"));
    EXPECT_TRUE(folder.read("a.ppm").starts_with("P6\n9 7\n255\n"));
    EXPECT_TRUE(folder.read("a.exr").starts_with("\x76\x2f\x31\x01"));
    const Finished r = run(folder, {"render", "a.cgfs", "-o", "a.gif"});
    EXPECT_EQ(r.code, 2);
    EXPECT_TRUE(contains(r.err, "glint writes .png, .ppm, .exr, .tga, .bmp or .jpg")) << r.err;
}

// Also of pictures that would be written strip by strip.
TEST(Render, WhatAFormatCannotDoIsSaidBeforeRendering) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const std::pair<std::vector<std::string>, const char*> cases[] = {
        {{"-s", "9x7", "-o", "a.jpg", "--bits", "16"}, "--output 'a.jpg': JPEG has 8 bits a channel"},
        {{"-s", "9x7", "-o", "a.jpg", "--bits", "16", "--resume"}, "JPEG has 8 bits a channel"},
        {{"-s", "9x7", "-o", "a.bmp", "--bits", "16", "--resume"}, "BMP has 8 bits a channel"},
        {{"-s", "9x7", "-o", "a.tga", "--alpha"}, "glint writes TGA without alpha; write .png or .exr"},
        {{"-s", "65501x2", "-o", "a.jpg", "--resume"}, "JPEG has at most 65500 pixels a side"}};
    for (const auto& [options, message] : cases) {
        std::vector<std::string> words{"render", "a.cgfs"};
        words.insert(words.end(), options.begin(), options.end());
        const Finished r = run(folder, words);
        EXPECT_EQ(r.code, 2) << r.err;
        EXPECT_TRUE(contains(r.err, message)) << r.err;
        EXPECT_EQ(folder.count(), 1);
    }
}

TEST(Render, BitsAndTransfer) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const auto draw = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments = {"render", "a.cgfs", "-s", "20x20", "-o", "x.png"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        EXPECT_EQ(run(folder, arguments).code, 0);
        return read_png(folder.path("x.png"));
    };
    const Picture eight = draw({}), sixteen = draw({"--bits", "16"}), srgb = draw({"--transfer", "srgb"});
    ASSERT_EQ(sixteen.bits, 16);
    bool brighter = false;
    for (std::size_t i = 0; i < eight.samples.size(); ++i) {
        EXPECT_NEAR(sixteen.samples[i] / 257.0, eight.samples[i], 0.51);
        EXPECT_GE(srgb.samples[i], eight.samples[i]);
        brighter = brighter || srgb.samples[i] > eight.samples[i];
    }
    EXPECT_TRUE(brighter);
}

TEST(Render, TheSceneSaysHowNumbersBecomeBytes) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const auto draw = [&](std::vector<std::string> more) {
        std::vector<std::string> arguments = {"render", "a.cgfs", "-s", "90x20", "-q", "-o", "x.png"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        EXPECT_EQ(run(folder, arguments).code, 0);
        return folder.read("x.png");
    };
    const std::vector<std::string> convention = {"--convention", "transfer=srgb"};
    const std::string plain = draw({}), srgb = draw({"--transfer", "srgb"});
    EXPECT_NE(plain, srgb);
    EXPECT_EQ(draw(convention), srgb);
    EXPECT_EQ(draw({"--convention", "transfer=srgb", "--transfer", "none"}), plain);
    EXPECT_EQ(draw({"--convention", "transfer=srgb", "--resume"}), srgb);
    EXPECT_NE(draw({"--convention", "rounding=down"}), plain);
    EXPECT_NE(draw({"--convention", "gamma=2"}), plain);
    for (const std::string part : {"1", "2"}) {
        ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "90x20", "--convention", "transfer=srgb", "--part",
                               part + "/2", "-o", part + ".tiles"})
                      .code,
                  0);
    }
    ASSERT_EQ(run(folder, {"join", "1.tiles", "2.tiles", "-o", "x.png"}).code, 0);
    EXPECT_EQ(folder.read("x.png"), srgb);
    // OpenEXR is linear.
    ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "20x20", "-o", "a.exr"}).code, 0);
    ASSERT_EQ(
        run(folder, {"render", "a.cgfs", "-s", "20x20", "-o", "b.exr", "--convention", "transfer=srgb"}).code,
        0);
    EXPECT_EQ(folder.read("a.exr"), folder.read("b.exr"));
    // Pictures compared with the scene are those that render writes.
    ASSERT_EQ(run(folder, {"convert", "a.cgfs", "a.glint"}).code, 0);
    const std::string text = folder.read("a.glint");
    const std::size_t at = text.find("render {");
    ASSERT_NE(at, std::string::npos);
    folder.write("b.glint",
                 text.substr(0, at) + "conventions { transfer = srgb  rounding = down }\n" + text.substr(at));
    ASSERT_EQ(run(folder, {"render", "b.glint", "-s", "60x60", "-o", "right.png"}).code, 0);
    ASSERT_EQ(
        run(folder, {"render", "b.glint", "-s", "60x60", "--shading", "diffuse", "-o", "wrong.png"}).code, 0);
    const Finished r = run(folder, {"compare", "wrong.png", "right.png", "--scene", "b.glint"});
    EXPECT_TRUE(contains(r.out, "specular-missing: explains 100%")) << r.out << r.err;
}

TEST(Render, CropIsAPartOfTheWhole) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "60x50"}).code, 0);
    ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "60x50", "--crop", "20x10+25+30", "-o", "b.png"}).code,
              0);
    const Picture whole = read_png(folder.path("a.png")), part = read_png(folder.path("b.png"));
    ASSERT_EQ(part.width, 20);
    ASSERT_EQ(part.height, 10);
    for (int y = 0; y < 10; ++y) {
        for (int i = 0; i < 60; ++i) {
            ASSERT_EQ(part.samples[y * 60 + i], whole.samples[3 * ((y + 30) * 60 + 25) + i]) << y << " " << i;
        }
    }
}

TEST(Render, TheSameBytesForThreadsAndInstructionSets) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "120x90"}).code, 0);
    const std::string expected = folder.read("a.png");
    for (const char* threads : {"1", "2", "7"}) {
        ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "120x90", "-t", threads, "-o", "t.png"}).code, 0);
        EXPECT_EQ(folder.read("t.png"), expected) << threads;
    }
    std::istringstream names(run(folder, {"info", "--isa"}).out);
    int count = 0;
    for (std::string name; std::getline(names, name); ++count) {
        const Finished r = run(folder, {"render", "a.cgfs", "-s", "120x90", "--isa", name, "-o", "i.png"});
        ASSERT_EQ(r.code, 0) << r.err;
        EXPECT_TRUE(contains(r.err, ", " + name + ", ")) << r.err;
        EXPECT_EQ(folder.read("i.png"), expected) << name;
    }
    EXPECT_GE(count, 1);
}

TEST(Render, OptionsReachThePicture) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "60x60"}).code, 0);
    const std::string plain = folder.read("a.png");
    const std::pair<const char*, const char*> changes[] = {{"--shading", "normals"},
                                                           {"--shading", "color"},
                                                           {"--shading", "diffuse"},
                                                           {"--reflections", "0"},
                                                           {"--aa", "3"},
                                                           {"--profile", "glint"},
                                                           {"--convention", "pixel_sample=center"}};
    for (const auto& [option, value] : changes) {
        const Finished r = run(folder, {"render", "a.cgfs", "-s", "60x60", "-o", "b.png", option, value});
        ASSERT_EQ(r.code, 0) << option << r.err;
        EXPECT_NE(folder.read("b.png"), plain) << option << " " << value;
    }
}

TEST(Render, NoShadows) {
    const Folder folder;
    folder.write("a.cgfs", std::string(k_scene) +
                               "sphere { center = (0, -5001, 0)  radius = 5000  color = (255, 255, 0) }");
    ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "60x60"}).code, 0);
    ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "60x60", "--no-shadows", "-o", "b.png"}).code, 0);
    EXPECT_NE(folder.read("a.png"), folder.read("b.png"));
}

TEST(Render, ProfileFromAFile) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    folder.write("mine.txt", "pixel_sample = center\n");
    const std::vector<std::string> arguments = {"render", "a.cgfs", "-s", "30x30", "-o"};
    const auto draw = [&](const char* out, const char* option, const char* value) {
        std::vector<std::string> all = arguments;
        all.insert(all.end(), {out, option, value});
        EXPECT_EQ(run(folder, all).code, 0);
        return folder.read(out);
    };
    const std::string by_file = draw("file.png", "--profile", "mine.txt");
    EXPECT_EQ(by_file, draw("key.png", "--convention", "pixel_sample=center"));
    EXPECT_NE(by_file, draw("plain.png", "--profile", "cgfs"));
}

TEST(Render, StatsHaveTheseKeys) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "40x30", "-t", "2", "--stats", "s.json"}).code, 0);
    const auto stats = nlohmann::json::parse(folder.read("s.json"));
    const auto keys = [](const nlohmann::json& object) {
        std::vector<std::string> names;
        for (const auto& item : object.items()) names.push_back(item.key());
        return names;
    };
    EXPECT_EQ(keys(stats), (std::vector<std::string>{"encode_s", "isa", "load_s", "peak_rss_bytes",
                                                     "prepare_s", "rays", "threads", "trace_s"}));
    EXPECT_EQ(keys(stats["rays"]),
              (std::vector<std::string>{"camera", "cut", "mirror", "shadow", "transmitted"}));
    EXPECT_EQ(stats["rays"]["camera"], 40 * 30);
    EXPECT_EQ(stats["threads"], 2);
    EXPECT_GT(stats["peak_rss_bytes"], 1000000);
}

TEST(Render, ShowsThePictureAsText) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const Finished r = run(folder, {"render", "a.cgfs", "-s", "12x8", "--show"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(std::count(r.out.begin(), r.out.end(), '\n'), 4) << "two rows a line";
    EXPECT_TRUE(contains(r.out, "\x1b[38;2;255;255;255;48;2;255;255;255m▀")) << "the white background";
    EXPECT_TRUE(folder.has("a.png"));
    EXPECT_EQ(run(folder, {"render", "a.cgfs", "--show", "-o", "-"}).code, 2);
}

TEST(Render, AMissingIncludeIsAnErrorEvenWhenQuiet) {
    const Folder folder;
    folder.write("a.glint",
                 "camera { position = (0, 0, 5) }\nsphere { center = (0, 0, 0) radius = 1 }\ninclude "
                 "\"none.glint\"\n");
    const Finished done = run(folder, {"render", "a.glint", "-o", "a.png", "--quiet"});
    EXPECT_EQ(done.code, 1);
    EXPECT_TRUE(contains(done.err, "a.glint:3:9: error: 'none.glint': ")) << done.err;
    EXPECT_FALSE(folder.has("a.png"));
}

// A .pov of plain words that is also a scene of CSC 473, with a picture that POV-Ray mirrors.
TEST(Render, APovThatPovRayMirrorsIsNoted) {
    const Folder folder;
    const auto said = [&](const std::string& camera, const std::vector<std::string>& options = {}) {
        folder.write("a.pov",
                     "camera { " + camera +
                         " }\nlight_source { <0, 9, 9> color rgb <1, 1, 1> }\nsphere { <0, 0, 0>, 1 }\n");
        std::vector<std::string> arguments{"render", "a.pov", "-s", "8x6", "-o", "a.png", "--strict"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const Finished done = run(folder, arguments);
        EXPECT_EQ(done.code, 0) << "a note is no warning";
        const std::size_t note = done.err.find("note: ");
        return note == std::string::npos ? std::string() : done.err;
    };
    const std::string front = "location <0, 0, 5> look_at <0, 0, 0>";
    const std::string note = said(front);
    EXPECT_TRUE(contains(note, "a.pov:1:1: note: read as a scene of CSC 473, ")) << note;
    EXPECT_TRUE(contains(note, "`--format povray`")) << note;
    EXPECT_TRUE(contains(note, "\n  camera {")) << note;
    EXPECT_NE(said(front + " right <1.33, 0, 0>"), "");
    EXPECT_EQ(said(front, {"--format", "csc473"}), "");
    EXPECT_EQ(said(front, {"--format", "povray"}), "");
    EXPECT_EQ(said("location <0, 0, -5> look_at <0, 0, 0>"), "") << "right is right in both";
}

TEST(Render, IncludesFilesFromTheSceneFolder) {
    const Folder folder;
    std::filesystem::create_directories(folder.path("scenes/parts"));
    folder.write("scenes/a.glint", "camera { position = (0, 0, 5) }\ninclude \"parts/b.glint\"\n");
    folder.write("scenes/parts/b.glint", "include \"c.cgfs\"\n");
    folder.write("scenes/parts/c.cgfs", "sphere { center = (0, 0, 0) radius = 1 color = (0, 0, 255) }\n");
    const Finished good = run(folder, {"info", "scenes/a.glint"});
    EXPECT_EQ(good.code, 0) << good.err;
    EXPECT_TRUE(contains(good.out, "1 sphere")) << good.out;
    folder.write("scenes/parts/c.cgfs", "\nsphere { radius = x }\n");
    const Finished bad = run(folder, {"render", "scenes/a.glint", "-o", "a.png"});
    EXPECT_EQ(bad.code, 1);
    EXPECT_TRUE(contains(bad.err, "scenes/parts/c.cgfs:2:19: error: expected a number")) << bad.err;
    EXPECT_FALSE(folder.has("a.png"));
}

}  // namespace
}  // namespace glint::test
