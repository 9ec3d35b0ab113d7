// SPDX-License-Identifier: Apache-2.0
// Pictures that are rendered in several runs or parts have the bytes of one run.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <thread>

#include "cli/process.h"

namespace glint::test {
namespace {

using Arguments = std::vector<std::string>;

Arguments operator+(Arguments a, const Arguments& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// Slow enough to be killed in the middle.
const Arguments k_render{"render", "a.cgfs", "-s", "300x200", "--aa", "8", "-t", "2"};

std::string bytes_of_one_run(const Folder& folder, const Arguments& arguments) {
    const Finished r = run(folder, arguments + Arguments{"-o", "whole.png"});
    EXPECT_EQ(r.code, 0) << r.err;
    return folder.read("whole.png");
}

// Ends the process by a signal as soon as its journal has some bytes, or lets it end.
Finished kill_in_the_middle(const Folder& folder, const Arguments& arguments, const std::string& journal,
                            std::uintmax_t bytes, int signal) {
    Process process(folder, arguments);
    for (int i = 0; i < 20000; ++i) {
        std::error_code none;
        if (std::filesystem::file_size(folder.path(journal), none) >= bytes && !none) break;
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    ::kill(process.id(), signal);
    return process.finish();
}

TEST(Resume, AfterAnySignal) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const std::string whole = bytes_of_one_run(folder, k_render);
    const Arguments resumed = k_render + Arguments{"-o", "b.png", "--resume"};
    int interrupted = 0;
    for (const int signal : {SIGKILL, SIGINT, SIGTERM}) {
        const Finished killed = kill_in_the_middle(folder, resumed, "b.png.journal", 100000, signal);
        if (killed.code == 1000 + signal) {
            ++interrupted;
            EXPECT_FALSE(folder.has("b.png"));
            EXPECT_TRUE(folder.has("b.png.journal"));
            if (signal == SIGINT) {
                EXPECT_TRUE(contains(killed.err, "the same command goes on from here")) << killed.err;
            }
        }
        const Finished r = run(folder, resumed);
        EXPECT_EQ(r.code, 0) << r.err;
        if (killed.code == 1000 + signal) {
            EXPECT_TRUE(contains(r.err, "going on with b.png.journal: ")) << r.err;
        }
        EXPECT_TRUE(folder.read("b.png") == whole);
        EXPECT_FALSE(folder.has("b.png.journal"));
        std::filesystem::remove(folder.path("b.png"));
    }
    EXPECT_GT(interrupted, 0) << "the scene is too fast to be interrupted";
}

TEST(Resume, AfterAFullDisk) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const std::string whole = bytes_of_one_run(folder, k_render);
    const Arguments resumed = k_render + Arguments{"-o", "b.png", "--resume"};
    const Finished full = run(folder, resumed, with_full_disk(200000));
    EXPECT_EQ(full.code, 1);
    EXPECT_TRUE(contains(full.err, "cannot write the journal 'b.png.journal'")) << full.err;
    EXPECT_EQ(run(folder, resumed).code, 0);
    EXPECT_TRUE(folder.read("b.png") == whole);
}

TEST(Resume, WithLayersAndACrop) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const Arguments render{"render", "a.cgfs", "-s", "300x200", "--crop", "130x90+20+30", "--aov", "all"};
    ASSERT_EQ(run(folder, render + Arguments{"-o", "whole.exr"}).code, 0);
    const Arguments resumed = render + Arguments{"-o", "b.exr", "--resume"};
    EXPECT_EQ(run(folder, resumed, with_full_disk(150000)).code, 1);
    EXPECT_TRUE(folder.has("b.exr.journal"));
    EXPECT_EQ(run(folder, resumed).code, 0);
    EXPECT_TRUE(folder.read("b.exr") == folder.read("whole.exr"));
}

TEST(Resume, RefusesTheJournalOfAnotherPicture) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const Arguments resumed = k_render + Arguments{"-o", "b.png", "--resume"};
    ASSERT_EQ(run(folder, resumed, with_full_disk(200000)).code, 1);
    const std::string journal = folder.read("b.png.journal");
    const auto refused = [&](const Arguments& arguments, const char* why) {
        const Finished r = run(folder, arguments);
        EXPECT_EQ(r.code, 1) << why;
        EXPECT_TRUE(contains(r.err, why)) << r.err;
        EXPECT_TRUE(folder.read("b.png.journal") == journal) << "it is left alone";
        EXPECT_FALSE(folder.has("b.png"));
    };
    refused(resumed + Arguments{"--shading", "diffuse"}, "shading is phong there and diffuse here");
    refused(resumed + Arguments{"--aov", "depth"}, "the list of layers");
    refused({"render", "a.cgfs", "-s", "20x20", "-o", "b.png", "--resume"}, "size is 300x200 there");
    folder.write("a.cgfs", std::string(k_scene) + "\n");
    refused(resumed, "'a.cgfs' has changed");
    folder.write("a.cgfs", k_scene);
    folder.write("b.png.journal", "text");
    const Finished r = run(folder, resumed);
    EXPECT_EQ(r.code, 1);
    EXPECT_TRUE(contains(r.err, "no journal of glint")) << r.err;
    EXPECT_EQ(folder.read("b.png.journal"), "text");
}

TEST(Resume, SeesChangedIncludes) {
    const Folder folder;
    folder.write("ball.glint", "sphere { center = (0, 0, 0)  radius = 1 }\n");
    folder.write(
        "a.glint",
        "include \"ball.glint\"\ncamera { position = (0, 2, 8)  look_at = (0, 0, 0)  fov_x = 50 }\n");
    const Arguments resumed{"render", "a.glint", "-s", "200x200", "-o", "b.png", "--resume"};
    const Finished first = run(folder, resumed, with_full_disk(100000));
    ASSERT_EQ(first.code, 1) << first.err;
    ASSERT_TRUE(contains(first.err, "journal")) << first.err;
    folder.write("ball.glint", "sphere { center = (0, 0, 0)  radius = 2 }\n");
    const Finished r = run(folder, resumed);
    EXPECT_EQ(r.code, 1);
    EXPECT_TRUE(contains(r.err, "'ball.glint' has changed")) << r.err;
}

TEST(Resume, OneProcessAtATime) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const Arguments resumed = k_render + Arguments{"-o", "b.png", "--resume"};
    ASSERT_EQ(run(folder, resumed, with_full_disk(200000)).code, 1);
    const int file = ::open(folder.path("b.png.journal").c_str(), O_RDONLY);
    ASSERT_EQ(::flock(file, LOCK_EX), 0);
    const Finished r = run(folder, resumed);
    ::close(file);
    EXPECT_EQ(r.code, 1);
    EXPECT_TRUE(contains(r.err, "is in use by another process")) << r.err;
}

TEST(Resume, NeedsAFile) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    EXPECT_EQ(run(folder, {"render", "a.cgfs", "-s", "10x10", "-o", "-", "--resume"}).code, 2);
}

TEST(Parts, InAnyNumberAndOrder) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const Arguments render{"render", "a.cgfs", "-s", "150x110"};
    const std::string whole = bytes_of_one_run(folder, render);
    for (const int parts : {1, 2, 3, 7, 40}) {
        Arguments join{"join"};
        for (int part = parts; part >= 1; --part) {
            const std::string name = std::to_string(part) + ".tiles",
                              text = std::to_string(part) + "/" + std::to_string(parts);
            const Finished r = run(folder, render + Arguments{"--part", text, "-o", name, "-t", "1"});
            EXPECT_EQ(r.code, 0) << r.err;
            join.push_back(name);
        }
        join.push_back("1.tiles");  // one twice
        const Finished r = run(folder, join + Arguments{"-o", "b.png"});
        EXPECT_EQ(r.code, 0) << r.err;
        EXPECT_TRUE(folder.read("b.png") == whole) << parts;
    }
}

TEST(Parts, WithLayers) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const Arguments render{"render", "a.cgfs", "-s", "90x70", "--aov", "depth,ambient"};
    ASSERT_EQ(run(folder, render + Arguments{"-o", "whole.exr"}).code, 0);
    ASSERT_EQ(run(folder, render + Arguments{"--part", "1/2"}).code, 0);
    ASSERT_EQ(run(folder, render + Arguments{"--part", "2/2"}).code, 0);
    ASSERT_EQ(run(folder, {"join", "a.1-of-2.tiles", "a.2-of-2.tiles", "-o", "b.exr"}).code, 0);
    EXPECT_TRUE(folder.read("b.exr") == folder.read("whole.exr"));
    ASSERT_EQ(run(folder, {"join", "a.1-of-2.tiles", "a.2-of-2.tiles", "-o", "b.png"}).code, 0);
    EXPECT_TRUE(folder.has("b.depth.png"));
}

TEST(Parts, WhatIsMissingIsNamed) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const Arguments render{"render", "a.cgfs", "-s", "150x110"};  // 5 x 4 tiles
    for (const char* const part : {"1", "3"})
        ASSERT_EQ(run(folder, render + Arguments{"--part", std::string(part) + "/3", "-o",
                                                 std::string(part) + ".tiles"})
                      .code,
                  0);
    Finished r = run(folder, {"join", "3.tiles", "1.tiles", "-o", "b.png"});
    EXPECT_EQ(r.code, 1);
    EXPECT_TRUE(contains(r.err, "7 of 20 tiles are missing: 7 of the 7 of part 2/3")) << r.err;
    EXPECT_FALSE(folder.has("b.png"));
    r = run(folder, {"join", "3.tiles", "1.tiles", "-o", "b.png", "--partial"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(folder.has("b.png"));

    const std::string tiles = folder.read("1.tiles");
    folder.write("cut.tiles", tiles.substr(0, tiles.size() - 10));
    r = run(folder, {"join", "cut.tiles", "3.tiles", "-o", "c.png"});
    EXPECT_EQ(r.code, 1);
    EXPECT_TRUE(contains(r.err, "cut.tiles: cut or damaged after its 6 tiles")) << r.err;
    EXPECT_TRUE(contains(r.err, "1 of the 7 of part 1/3")) << r.err;
}

TEST(Parts, OfOtherPicturesAreRefused) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    folder.write("b.cgfs", std::string(k_scene) + "# other\n");
    ASSERT_EQ(run(folder, {"render", "a.cgfs", "-s", "50x40", "--part", "1/2", "-o", "1.tiles"}).code, 0);
    ASSERT_EQ(run(folder, {"render", "b.cgfs", "-s", "50x40", "--part", "2/2", "-o", "2.tiles"}).code, 0);
    const Finished r = run(folder, {"join", "1.tiles", "2.tiles", "-o", "b.png"});
    EXPECT_EQ(r.code, 1);
    EXPECT_TRUE(contains(r.err, "different pictures")) << r.err;
    EXPECT_EQ(run(folder, {"join", "a.cgfs", "-o", "b.png"}).code, 1);
    EXPECT_EQ(run(folder, {"join", "none.tiles", "-o", "b.png"}).code, 1);
}

// A file that claims to be of many parts does not keep join busy.
TEST(Parts, OfAnyClaimedNumber) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    ASSERT_EQ(
        run(folder, {"render", "a.cgfs", "-s", "150x110", "--part", "4294967295/4294967295", "-o", "1.tiles"})
            .code,
        0);
    const Finished r = run(folder, {"join", "1.tiles", "-o", "b.png"});
    EXPECT_EQ(r.code, 1);
    EXPECT_TRUE(contains(r.err, "20 of 20 tiles are missing: 1 of the 1 of part 1/4294967295,")) << r.err;
}

TEST(Parts, AreResumed) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const Arguments part = k_render + Arguments{"--part", "1/2", "-o", "1.tiles", "--resume"};
    ASSERT_EQ(run(folder, part, with_full_disk(200000)).code, 1);
    EXPECT_FALSE(folder.has("1.tiles"));
    ASSERT_EQ(run(folder, part).code, 0);
    const std::string tiles = folder.read("1.tiles");
    EXPECT_FALSE(folder.has("1.tiles.journal"));
    const Finished again = run(folder, part);
    EXPECT_EQ(again.code, 0);
    EXPECT_TRUE(contains(again.err, "1.tiles  is complete")) << again.err;
    EXPECT_TRUE(folder.read("1.tiles") == tiles);
}

TEST(Parts, BadArguments) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    for (const char* const part : {"0/2", "3/2", "1", "1/", "/2", "1/2x", "-1/2", "a/b", "1/99999999999"}) {
        const Finished r = run(folder, {"render", "a.cgfs", "-s", "10x10", "--part", part});
        EXPECT_EQ(r.code, 2) << part;
        EXPECT_TRUE(contains(r.err, "--part")) << r.err;
    }
    EXPECT_EQ(run(folder, {"render", "a.cgfs", "-s", "10x10", "--part", "1/2", "-o", "a.png"}).code, 2);
    EXPECT_EQ(run(folder, {"render", "a.cgfs", "-s", "10x10", "--part", "1/2", "--show"}).code, 2);
    EXPECT_EQ(folder.count(), 1);
}

}  // namespace
}  // namespace glint::test
