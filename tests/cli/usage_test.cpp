// SPDX-License-Identifier: Apache-2.0
// The messages for command lines that are not valid, and requests for help.
#include <gtest/gtest.h>

#include "cli/process.h"
#include "glint/version.h"

namespace glint::test {
namespace {

TEST(Usage, NamesWhatWasMeant) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const std::pair<std::vector<std::string>, const char*> cases[] = {
        {{"rendre"}, "there is no command 'rendre'; did you mean `render`? (there are render, info, "},
        {{"help", "rendre"}, "there is no command 'rendre'; did you mean `render`?"},
        {{"render", "a.cgfs", "--siz", "9x9"}, "unknown option '--siz' (did you mean `--size`?)"},
        {{"render", "a.cgfs", "--siz=9x9"}, "unknown option '--siz=9x9' (did you mean `--size`?)"},
        {{"explain", "a.cgfs", "--pixle", "1,2"}, "unknown option '--pixle' (did you mean `--pixel`?)"},
        {{"render", "a.cgfs", "--convention", "speculargate=false"}, "did you mean `specular_gate`?"},
        {{"versus", "a.cgfs", "--a", "speculargate=false"}, "did you mean `specular_gate`?"},
        {{"compare", "a.cgfs", "--vary", "reflection=0..2"}, "did you mean `reflections`?"},
        {{"render", "a.cgfs", "--profile", "lectur5"}, "did you mean `lecture5`?"},
        {{"render", "a.cgfs", "--format", "cfgs"}, "did you mean `cgfs`?"},
        {{"render", "a.cgfs", "--aov", "normals"}, "did you mean `normal`?"},
        {{"render", "a.cgfs", "--isa", "skalar"}, "did you mean `scalar`?"},
        {{"render", "a.cgfs", "out.png"}, "-o names the output: glint render a.cgfs -o out.png"},
        {{"render", "out.exr"}, "glint render SCENE -o out.exr"},
        {{"render", "a.cgfs", "--width", "64"}, "command: glint render a.cgfs --size 64x64"},
        {{"render", "-i", "a.cgfs", "--spp", "9"}, "command: glint render a.cgfs --aa 3"},
        {{"check", "a.cgfs", "--jobs", "2"}, "command: glint check a.cgfs --threads 2"},
        {{"render", "a.cgfs", "-j4"}, "command: glint render a.cgfs --threads 4"},
        {{"info", "-i", "a.cgfs"}, "command: glint info a.cgfs"},
        {{"convert", "--input", "a.cgfs", "b.glint"}, "command: glint convert a.cgfs b.glint"},
        {{"explain", "a.cgfs", "-p", "1,1", "--jobs", "2"},
         "--jobs 2: `glint explain` has no --threads; leave it out\ncommand: glint explain a.cgfs -p 1,1\n"},
        {{"info", "a.cgfs", "--width", "9"},
         "`glint info` has no --size; leave it out\ncommand: glint info a.cgfs\n"},
        {{"--verbose"}, "command: glint render SCENE\n"},
        {{"-v", "a.cgfs"}, "command: glint render a.cgfs\n"},
        {{"render", "a.cgfs", "--shading", "fong"}, "found 'fong'; did you mean `phong`?"},
        {{"render", "a.cgfs", "--shading", "blin-fong"}, "did you mean `blinn-phong`?"},
        {{"render", "a.cgfs", "--shading", "blinn"}, "did you mean `blinn-phong`?"},
        {{"versus", "a.cgfs", "--a", "shading=fong"}, "did you mean `phong`?"},
        {{"render", "a.cgfs", "--convention", "facing=opne"}, "did you mean `open`?"},
        {{"render", "a.cgfs", "--transfer", "sgrb"}, "did you mean `srgb`?"},
        {{"explain", "a.cgfs", "-p", "1,1", "--as", "jsno"}, "did you mean `json`?"},
        {{"completion", "bsh"}, "did you mean `bash`?"},
        // The options of commands, in front of all words.
        {{"--siz"}, "glint: unknown option '--siz'; did you mean 'glint render --size'?\n"},
        {{"--siz", "9x9", "a.cgfs"}, "did you mean 'glint render --size 9x9 a.cgfs'?"},
        {{"--siz=9x9", "a.cgfs"}, "unknown option '--siz'; did you mean 'glint render --size=9x9 a.cgfs'?"},
        {{"--shading", "phong"},
         "'--shading' belongs after a command; did you mean 'glint render --shading phong'?"},
        {{"-s", "9x9", "a.cgfs"}, "did you mean 'glint render -s 9x9 a.cgfs'?"},
        {{"--pixle", "1,2", "a.cgfs"}, "did you mean 'glint explain --pixel 1,2 a.cgfs'?"},
        {{"--strct", "check", "a.cgfs"}, "did you mean 'glint check --strict a.cgfs'?"},
        {{"--verison"}, "unknown option '--verison' (did you mean `--version`?)"},
    };
    for (const auto& [arguments, message] : cases) {
        const Finished r = run(folder, arguments);
        EXPECT_EQ(r.code, 2) << message;
        EXPECT_TRUE(contains(r.err, message)) << r.err;
    }
    EXPECT_EQ(folder.count(), 1);
}

// The messages name the option, what was expected and what was found.
TEST(Usage, InItsOwnWords) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const std::pair<std::vector<std::string>, const char*> cases[] = {
        {{"render", "a.cgfs", "--one", "--two", "-z"},
         "glint render: unknown options '--one', '--two', '-z'\n"},
        {{"--one", "--two"}, "glint: unknown options '--one', '--two'\n"},
        {{"completion", "bash", "two", "--x"}, "glint completion: unexpected arguments 'two', '--x'\n"},
        {{"render"}, "glint render: expected SCENE\n"},
        {{"explain", "a.cgfs"}, "glint explain: expected --pixel X,Y\n"},
        {{"explain"}, "glint explain: expected SCENE and --pixel X,Y\n"},
        {{"grade"}, "glint grade: expected DIR\n"},
        {{"render", "a.cgfs", "-s"}, "glint render: --size: expected WxH, found nothing\n"},
        {{"render", "a.cgfs", "--size="}, "glint render: --size: expected WxH, found nothing\n"},
        {{"versus", "a.cgfs", "--a"}, "glint versus: --a: expected KEY=VALUE, found nothing\n"},
        {{"render", "a.cgfs", "--convention"},
         "glint render: --convention: expected KEY=VALUE, found nothing\n"},
        {{"render", "a.cgfs", "-s", "1x1", "-s", "2x2"}, "--size is given 2 times: expected once\n"},
        {{"render", "a.cgfs", "--quiet=maybe"}, "glint render: --quiet takes no value\n"},
        {{"render", "a.cgfs", "-t", "x"}, "--threads: expected a whole number from 0 to 1024, found 'x'\n"},
        {{"check", "a.cgfs", "-t", "2000"},
         "--threads: expected a whole number from 0 to 1024, found '2000'\n"},
        {{"compare", "a", "b", "--within", "nan"},
         "--within: expected a number from 0 to 1000000, found 'nan'\n"},
    };
    for (const auto& [arguments, message] : cases) {
        const Finished r = run(folder, arguments);
        EXPECT_EQ(r.code, 2) << message;
        EXPECT_TRUE(contains(r.err, message)) << r.err;
    }
}

TEST(Usage, HelpAndVersionInEverySpelling) {
    const Folder folder;
    const std::string version = run(folder, {"--version"}).out;
    EXPECT_EQ(version, "glint " GLINT_VERSION "\n");
    for (const char* spelling : {"-V", "-v", "version"}) {
        const Finished r = run(folder, {spelling});
        EXPECT_EQ(r.code, 0);
        EXPECT_EQ(r.out, version) << spelling;
    }
    const Finished help = run(folder, {"help"});
    EXPECT_EQ(help.code, 0);
    EXPECT_EQ(help.out, run(folder, {"--help"}).out);
    for (const char* command : {"render", "explain", "help"}) {
        const Finished r = run(folder, {"help", command});
        EXPECT_EQ(r.code, 0);
        EXPECT_EQ(r.out, run(folder, {command, "--help"}).out);
        EXPECT_TRUE(contains(r.out, std::string("Usage: glint ") + command)) << r.out;
    }
}

TEST(Usage, NothingNamesTheFirstCommands) {
    const Folder folder;
    const std::string out = run(folder, {}).out;
    for (const char* command : {"glint render SCENE", "glint explain SCENE", "glint check SCENE"})
        EXPECT_TRUE(contains(out, command)) << out;
}

TEST(Usage, WhatCannotBePrintedIsAnError) {
    const Folder folder;
    for (const char* argument : {"--version", "--help", "version", "help"}) {
        const Finished r = run(folder, {argument}, with_output_to("/dev/full"));
        EXPECT_EQ(r.code, 1) << argument;
        EXPECT_NE(r.err, "") << argument;
    }
    EXPECT_EQ(run(folder, {}, with_output_to("/dev/full")).code, 1);
}

TEST(Usage, ARepeatedOptionTakesOneValue) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const std::vector<std::string> commands[] = {
        {"render", "--convention", "specular_gate=false", "a.cgfs", "-s", "8x8", "-q", "-o", "a.png"},
        {"compare", "--scene", "a.cgfs", "a.png", "a.png"},
        {"versus", "--a", "specular_gate=false", "--a", "limit=drop", "a.cgfs", "-s", "8x8"},
    };
    for (const std::vector<std::string>& command : commands) {
        const Finished r = run(folder, command);
        EXPECT_EQ(r.code, 0) << command[0] << ": " << r.err;
    }
}

}  // namespace
}  // namespace glint::test
