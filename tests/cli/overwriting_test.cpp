// SPDX-License-Identifier: Apache-2.0
// No command overwrites an input or another output.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "cli/process.h"

namespace glint::test {
namespace {

using Arguments = std::vector<std::string>;

class Overwriting : public testing::Test {
  protected:
    Overwriting() {
        folder.write("s.cgfs", k_scene);
        folder.write("x.png", k_scene);
        folder.write("p.ppm", "[render]\n");
        folder.write("part.glint", "sphere { center = (0, 0, 4)  radius = 1 }\n");
        folder.write("whole.glint", "include \"part.glint\"\n");
        folder.write("p.profile", "reflections = 1\n");
        for (const char* picture : {"a.png", "b.png"}) {
            EXPECT_EQ(run(folder, {"render", "s.cgfs", "-s", "20x10", "-o", picture, "-q"}).code, 0);
        }
        std::filesystem::create_directory(folder.path("in"));
        std::filesystem::copy(folder.path("a.png"), folder.path("in/ada.png"));
        folder.write("one.rubric", "all 10 *.png\n");
        std::filesystem::create_symlink("s.cgfs", folder.path("soft.json"));
        std::filesystem::create_hard_link(folder.path("s.cgfs"), folder.path("hard.json"));
        std::filesystem::create_hard_link(folder.path("s.cgfs"), folder.path("hard.png"));
        const std::pair<const char*, const char*> links[] = {{"new.png", "to_new"},
                                                             {"new.png", "to_new.png"},
                                                             {"in/../to_new", "to_to_new.png"},
                                                             {"in/new.png", "into.png"}};
        for (const auto& [target, link] : links) std::filesystem::create_symlink(target, folder.path(link));
    }

    std::map<std::string, std::string> files() const {
        std::map<std::string, std::string> all;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path())) {
            const std::string name = entry.path().lexically_relative(folder.path()).string();
            if (!entry.is_directory()) all[name] = folder.read(name);
        }
        return all;
    }

    const Folder folder;
};

TEST_F(Overwriting, IsRefusedBeforeTheWork) {
    const auto before = files();
    const std::string read = "would overwrite an input: choose another file", one = "are the same file";
    const std::pair<Arguments, std::string> cases[] = {
        {{"render", "s.cgfs", "--stats", "s.cgfs"}, "--stats 's.cgfs' " + read},
        {{"render", "s.cgfs", "--stats", "./s.cgfs"}, "--stats './s.cgfs' " + read},
        {{"render", "s.cgfs", "--stats", "in/../s.cgfs"}, read},
        {{"render", "s.cgfs", "--stats", "soft.json"}, "--stats 'soft.json' " + read},
        {{"render", "s.cgfs", "--stats", "hard.json"}, "--stats 'hard.json' " + read},
        {{"render", "s.cgfs", "-o", "hard.png"}, "--output 'hard.png' " + read},
        {{"render", "soft.json", "--format", "cgfs", "--stats", "hard.json"}, read},
        {{"render", "s.cgfs", "--stats", "s.png"}, "--output and --stats are the same file, 's.png'"},
        {{"render", "s.cgfs", "-o", "new.png", "--stats", "./new.png"}, one},
        {{"render", "s.cgfs", "-o", "a.png", "--stats", "a.png"}, one},
        {{"render", "s.cgfs", "--profile", "p.ppm", "-o", "p.ppm"}, "--output 'p.ppm' " + read},
        {{"render", "s.cgfs", "--profile", "p.profile", "--stats", "p.profile"}, read},
        {{"render", "x.png", "--format", "cgfs"}, "--output 'x.png' " + read},
        {{"render", "whole.glint", "--stats", "part.glint"}, "--stats 'part.glint' " + read},
        {{"render", "s.cgfs", "--aov", "normal", "--stats", "s.normal.png"},
         "--stats and --aov are the same file"},
        {{"render", "s.normal.png", "--format", "cgfs", "-o", "s.png", "--aov", "normal"}, "no such file"},
        {{"render", "-", "--format", "cgfs", "-o", "-", "--stats", "-"}, "--output and --stats cannot both"},
        {{"convert", "s.cgfs", "whole.glint", "part.glint"}, "OUT 'part.glint' " + read},
        {{"convert", "whole.glint", "-o", "part.glint"}, read},
        {{"explain", "x.png", "--format", "cgfs", "-p", "1,1", "--overlay", "x.png"}, read},
        {{"versus", "x.png", "--format", "cgfs", "--a", "aa=2", "-o", "x.png"}, read},
        {{"compare", "a.png", "b.png", "--diff", "b.png"}, "--diff 'b.png' " + read},
        {{"compare", "a.png", "b.png", "--scene", "x.png", "--format", "cgfs", "--diff", "x.png"}, read},
        {{"grade", "in", "--reference", "a.png", "--sheet", "a.png"}, "--sheet 'a.png' " + read},
        {{"grade", "in", "--scene", "whole.glint", "--csv", "part.glint"}, "--csv 'part.glint' " + read},
        {{"grade", "in", "--scene", "s.cgfs", "--rubric", "one.rubric", "--json", "one.rubric"}, read},
        {{"grade", "in", "--reference", "a.png", "--csv", "t", "--json", "in/../t"}, one},
        {{"grade", "in", "--reference", "a.png", "--csv", "-", "--json", "-"}, "cannot both"},
        // Links that name no file yet.
        {{"render", "s.cgfs", "-o", "new.png", "--stats", "to_new"},
         "--output and --stats are the same file, 'to_new'"},
        {{"render", "s.cgfs", "-o", "to_new.png", "--stats", "to_new"}, one},
        {{"render", "s.cgfs", "-o", "to_to_new.png", "--stats", "in/../new.png"}, one},
        {{"grade", "in", "--reference", "a.png", "--csv", "new.png", "--json", "to_new"}, one},
        {{"grade", "in", "--reference", "a.png", "--sheet", "into.png"}, "in 'in', where the next run"}};
    for (const auto& [arguments, message] : cases) {
        const Finished r = run(folder, arguments);
        EXPECT_EQ(r.code, message == "no such file" ? 1 : 2) << message << r.err;
        EXPECT_TRUE(contains(r.err, message)) << arguments[0] << " says\n" << r.err;
    }
    EXPECT_EQ(files(), before) << "nothing was written";
}

TEST_F(Overwriting, OfALayerThatIsAScene) {
    folder.write("s.normal.png", k_scene);
    const Finished r =
        run(folder, {"render", "s.normal.png", "--format", "cgfs", "-o", "s.png", "--aov", "normal"});
    EXPECT_EQ(r.code, 2);
    EXPECT_TRUE(contains(r.err, "--aov 's.normal.png' would overwrite an input")) << r.err;
    EXPECT_EQ(folder.read("s.normal.png"), k_scene);
    EXPECT_FALSE(folder.has("s.png"));
}

// The file behind standard input also counts as read.
TEST_F(Overwriting, OfStandardInput) {
    const std::string command = "cd '" + folder.path() +
                                "' && '" GLINT_COMMAND
                                "' render - --format cgfs -q --stats s.cgfs <s.cgfs 2>/dev/null";
    EXPECT_NE(std::system(command.c_str()), 0);
    EXPECT_EQ(folder.read("s.cgfs"), k_scene);
}

TEST_F(Overwriting, OfOlderFilesAndOfNothingIsAllowed) {
    const Arguments allowed[] = {
        {"render", "s.cgfs", "-s", "9x9", "-o", "a.png", "--stats", "/dev/null"},
        {"render", "s.cgfs", "-s", "9x9", "-o", "/dev/null", "--stats", "/dev/null"},
        {"render", "/dev/stdin", "--format", "cgfs", "-s", "9x9", "-o", "/dev/stdout", "--stats",
         "/dev/null"},
        {"render", "s.cgfs", "-s", "9x9", "-o", "-", "--stats", "new.json"},
        {"compare", "a.png", "b.png", "-q", "--hard-fail", "255", "--within", "255", "--diff", "/dev/null"},
        {"compare", "a.png", "a.png", "-q", "--diff", "difference.png"},
        {"convert", "s.cgfs", "s.cgfs", "new.glint"}};
    folder.write("a.png", folder.read("b.png"));
    for (const Arguments& arguments : allowed) {
        if (arguments[0] == "compare") folder.write("a.png", folder.read("b.png"));
        const Finished r = run(folder, arguments, with_input(k_scene));
        EXPECT_EQ(r.code, 0) << r.err;
    }
}

// A shell may redirect standard output to a file that is read, or that another option writes.
TEST_F(Overwriting, OfRedirectedStandardOutputIsRefused) {
    const auto shell = [&](const std::string& line) {
        const std::string command = "cd '" + folder.path() + "' && " GLINT_COMMAND " " + line;
        return WEXITSTATUS(std::system(command.c_str()));
    };
    const auto before = files();
    EXPECT_EQ(shell("render s.cgfs -s 20x10 -q -o - >> s.cgfs 2> /dev/null"), 2);
    EXPECT_EQ(shell("convert s.cgfs -o - >> s.cgfs 2> /dev/null"), 2);
    EXPECT_EQ(files(), before);
    EXPECT_EQ(shell("render s.cgfs -s 20x10 -q -o - --stats both > both 2> /dev/null"), 2);
    EXPECT_EQ(folder.read("both"), "");
    EXPECT_EQ(shell("render s.cgfs -s 20x10 -q -o - --stats stats > picture"), 0);
    EXPECT_GT(folder.read("picture").size(), 100u);
}

}  // namespace
}  // namespace glint::test
