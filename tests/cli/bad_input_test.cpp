// SPDX-License-Identifier: Apache-2.0
// The messages and exit codes for input that the command cannot handle.
#include <gtest/gtest.h>

#include "cli/process.h"

namespace glint::test {
namespace {

TEST(BadInput, Files) {
    const Folder folder;
    folder.write("empty.cgfs", "");
    folder.write("binary.cgfs", std::string("sphere\0{", 8));
    folder.write("utf16.cgfs", std::string("\xff\xfes\0p\0h\0", 8));
    folder.write("wrong.cgfs", "sphere { center = (0, 0, 3)\n  radius = abc\n  color = }\n");
    folder.write("scene.what", k_scene);
    const std::pair<std::vector<std::string>, const char*> cases[] = {
        {{"none.cgfs"}, "none.cgfs: no such file"},
        {{"."}, ".: is a folder"},
        {{"empty.cgfs"}, "empty.cgfs:1:1: error: expected"},
        {{"binary.cgfs"}, "binary.cgfs:1:7: error: expected text, found the byte 0x00"},
        {{"/dev/zero", "--format", "cgfs"}, "/dev/zero:1:1: error: expected text, found the byte 0x00"},
        {{"utf16.cgfs"}, "utf16.cgfs:1:1: error: expected UTF-8, found UTF-16"},
        {{"wrong.cgfs"}, "wrong.cgfs:2:12: error: expected"},
        {{"scene.what"}, "scene.what"},
        {{"wrong.cgfs/x.cgfs"}, "Not a directory"},
    };
    for (const auto& [arguments, message] : cases) {
        std::vector<std::string> all = {"render"};
        all.insert(all.end(), arguments.begin(), arguments.end());
        const Finished r = run(folder, all);
        EXPECT_EQ(r.code, 1) << arguments[0] << r.err;
        EXPECT_TRUE(contains(r.err, message)) << r.err;
        all[0] = "info";
        EXPECT_EQ(run(folder, all).code, 1) << arguments[0];
    }
    EXPECT_EQ(folder.count(), 5) << "no picture";
}

TEST(BadInput, SeveralMissingFilesAreNamedInOneRun) {
    const Folder folder;
    const Finished r = run(folder, {"render", "one.cgfs", "two.cgfs"});
    EXPECT_TRUE(contains(r.err, "one.cgfs: no such file")) << r.err;
    EXPECT_TRUE(contains(r.err, "two.cgfs: no such file")) << r.err;
}

TEST(BadInput, APipe) {
    const Folder folder;
    const Finished good =
        run(folder, {"render", "/dev/stdin", "--format", "cgfs", "-s", "9x9", "-o", "a.png"},
            with_input(k_scene));
    EXPECT_EQ(good.code, 0) << good.err;
    const Finished bad =
        run(folder, {"render", "-", "--format", "cgfs"}, with_input("sphere {\n  radius = x }"));
    EXPECT_EQ(bad.code, 1);
    EXPECT_TRUE(contains(bad.err, "-:2:12: error:")) << bad.err;
}

TEST(BadInput, Usage) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const std::pair<std::vector<std::string>, const char*> cases[] = {
        {{"render"}, "SCENE"},
        {{"render", "a.cgfs", "--nonsense"}, "--nonsense"},
        {{"render", "a.cgfs", "--size", "0x5"}, "'0x5'"},
        {{"render", "a.cgfs", "--size", "-3x5"}, "'-3x5'"},
        {{"render", "a.cgfs", "--size", "70000x1"}, "65536"},
        {{"render", "a.cgfs", "--size", "12"}, "'12'"},
        {{"render", "a.cgfs", "--aa", "0"}, "1 to 64"},
        {{"render", "a.cgfs", "--reflections", "-1"}, "0 to 1000"},
        {{"render", "a.cgfs", "--shading", "gouraud"}, "blinn-phong"},
        {{"render", "a.cgfs", "--transfer", "gamma"}, "none or srgb"},
        {{"render", "a.cgfs", "--bits", "12"}, "8 or 16"},
        {{"render", "a.cgfs", "--threads", "-1"}, "0 to 1024"},
        {{"render", "a.cgfs", "--isa", "avx9"}, "scalar"},
        {{"render", "a.cgfs", "--format", "doc"}, "cgfs"},
        {{"render", "a.cgfs", "--profile", "none"}, "lecture5"},
        {{"render", "a.cgfs", "--convention", "limit"}, "KEY=VALUE"},
        {{"render", "a.cgfs", "--convention", "limits=drop"}, "specular_gate"},
        {{"render", "a.cgfs", "--convention", "limit=x"}, "keep | drop"},
        {{"render", "a.cgfs", "--crop", "10x10"}, "WxH+X+Y"},
        {{"render", "a.cgfs", "--size", "64x64", "--crop", "10x10+60+0"}, "64x64"},
        {{"render", "a.cgfs", "--crop", "10x10+2147483647+0"}, "WxH+X+Y"},
        {{"render", "a.cgfs", "--aov", ""}, "--aov: expected LAYERS, found nothing"},
        {{"render", "a.cgfs", "--aov", "normal,,depth"}, "--aov 'normal,,depth': expected layer names"},
        {{"render", "a.cgfs", "--aov", "normal,"}, "an empty name"},
        {{"render", "a.cgfs", "--aov", "normals"}, "there is no layer 'normals'"},
        {{"render", "-"}, "--format"},
        {{"render", "-", "-", "--format", "cgfs"}, "once"},
        {{"render", "a.cgfs", "-o", "-", "--stats", "-"}, "--stats"},
        {{"info"}, "SCENE"},
        {{"rendr", "a.cgfs"}, "there are render, info, convert, check, "},
        {{"a.cgfs"}, "glint render a.cgfs"},
        {{"other.json", "-s", "10x10"}, "glint render other.json -s 10x10"},
        {{"completion", "tcsh"}, "bash"},
        {{"--nonsense"}, "--nonsense"},
    };
    for (const auto& [arguments, message] : cases) {
        const Finished r = run(folder, arguments);
        EXPECT_EQ(r.code, 2) << message << r.err;
        EXPECT_TRUE(contains(r.err, message)) << r.err;
    }
    EXPECT_EQ(folder.count(), 1);
}

TEST(BadInput, ASizeBeyondMemorySaysWhatItNeeds) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const Finished r = run(folder, {"render", "a.cgfs", "--size", "10000000x10000000"});
    EXPECT_EQ(r.code, 1);
    EXPECT_TRUE(contains(r.err, "a picture of 10000000x10000000 needs 1.2 PB of memory")) << r.err;
}

TEST(BadInput, ForeignFlags) {
    const Folder folder;
    const Finished povray = run(folder, {"render", "+Ia.pov", "+W640", "+H480", "-D"});
    EXPECT_EQ(povray.code, 2);
    EXPECT_TRUE(contains(povray.err, "+W640 +H480: use --size 640x480")) << povray.err;
    EXPECT_TRUE(contains(povray.err, "glint render a.pov --size 640x480")) << povray.err;
    const Finished tachyon = run(folder, {"a.dat", "-res", "640", "480", "-o", "a.ppm", "-numthreads", "2"});
    EXPECT_EQ(tachyon.code, 2);
    EXPECT_TRUE(contains(tachyon.err, "glint render a.dat --size 640x480 -o a.ppm --threads 2"))
        << tachyon.err;
}

TEST(BadInput, NothingIsAShortHelp) {
    const Folder folder;
    const Finished r = run(folder, {});
    EXPECT_EQ(r.code, 0);
    EXPECT_TRUE(contains(r.out, "glint render SCENE"));
    EXPECT_TRUE(run(folder, {"--version"}).out.starts_with("glint "));
}

}  // namespace
}  // namespace glint::test
