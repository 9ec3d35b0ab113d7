// SPDX-License-Identifier: Apache-2.0
// glint check: its output and exit codes.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/process.h"

namespace glint::test {
namespace {

constexpr auto k_clean = R"(sphere { center = (0, 0, 4)  radius = 1  color = (200, 80, 40) }
light { type = ambient  intensity = 0.2 }
light { type = point  intensity = 0.6  position = (2, 1, 0) }
)";
constexpr auto k_lost = "sphere { center = (0, 0, -4)  radius = 1  color = (200, 80, 40) }\n";

TEST(Check, Text) {
    const Folder folder;
    folder.write("a.cgfs", std::string(k_clean) + k_lost);
    const Finished r = run(folder, {"check", "a.cgfs"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.err, "");
    EXPECT_TRUE(r.out.starts_with("a.cgfs:4:1: warning: 1 of 2 shapes is outside the picture")) << r.out;
    EXPECT_TRUE(contains(r.out, "[shape-outside-view]\n  sphere { center = (0, 0, -4)")) << r.out;
    EXPECT_TRUE(contains(r.out, "\n  ^~~~~~\n  remedy: ")) << r.out;
    EXPECT_TRUE(r.out.ends_with("\na.cgfs: 1 likely mistake\n")) << r.out;
}

TEST(Check, NothingIsTheMatter) {
    const Folder folder;
    folder.write("a.cgfs", k_clean);
    const Finished r = run(folder, {"check", "a.cgfs", "--strict"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.out, "a.cgfs: no likely mistakes found\n");
    EXPECT_EQ(run(folder, {"check", "a.cgfs", "--json"}).out, "[]\n");
}

TEST(Check, TellsWhyStrictFails) {
    const std::string spheres = GLINT_SOURCE "/scenes/cgfs/only_spheres.cgfs";
    const Folder folder;
    const Finished text = run(folder, {"check", spheres, "--strict"});
    EXPECT_EQ(text.code, 1);
    EXPECT_TRUE(contains(text.out, "no likely mistakes found, 1 warning\n")) << text.out;
    const Finished json = run(folder, {"check", spheres, "--strict", "--json"});
    EXPECT_EQ(json.code, 1);
    EXPECT_TRUE(contains(json.out, "\"id\": \"reading\"")) << json.out;
}

TEST(Check, StrictFailsOnFindingsAndWarnings) {
    const Folder folder;
    folder.write("lost.cgfs", std::string(k_clean) + k_lost);
    EXPECT_EQ(run(folder, {"check", "lost.cgfs", "--strict"}).code, 1);
    folder.write("warned.cgfs", std::string(k_clean) + "wobble = 3\n");
    const Finished warned = run(folder, {"check", "warned.cgfs"});
    EXPECT_EQ(warned.code, 0);
    EXPECT_TRUE(contains(warned.err, "warned.cgfs:4:1: warning: ")) << warned.err;
    EXPECT_EQ(run(folder, {"check", "warned.cgfs", "--strict"}).code, 1);
}

// The interpretation of valid input is a note; it is printed and is not a failure.
TEST(Check, NotesPassStrictly) {
    const Folder folder;
    for (const char* scene : {"/scenes/epfl/two_scenes.js", "/scenes/csc473/cone_tower.pov"}) {
        const Finished r = run(folder, {"check", GLINT_SOURCE + std::string(scene), "--strict"});
        EXPECT_EQ(r.code, 0) << r.out << r.err;
        EXPECT_TRUE(contains(r.err, ": note: ")) << r.err;
    }
}

TEST(Check, Json) {
    const Folder folder;
    folder.write("a.cgfs", std::string(k_clean) + k_lost +
                               "light { type = point  intensity = 0  position = (0, 9, 0) }");
    const Finished r = run(folder, {"check", "a.cgfs", "--json"});
    ASSERT_EQ(r.code, 0) << r.err;
    const auto json = nlohmann::json::parse(r.out);
    ASSERT_EQ(json.size(), 2u) << r.out;
    EXPECT_EQ(json[0]["id"], "shape-outside-view");
    EXPECT_EQ(json[0]["severity"], "warning");
    EXPECT_EQ(json[0]["file"], "a.cgfs");
    EXPECT_EQ(json[0]["line"], 4);
    EXPECT_EQ(json[0]["column"], 1);
    EXPECT_TRUE(contains(json[0]["message"], "outside the picture"));
    EXPECT_FALSE(json[0]["remedy"].get<std::string>().empty());
    EXPECT_EQ(json[1]["id"], "light-without-color");
}

TEST(Check, TakesTheSceneOptionsOfRender) {
    const Folder folder;
    folder.write("spheres.cgfs", std::string(k_clean).substr(0, std::string(k_clean).find('\n') + 1));
    folder.write("lights.cgfs", std::string(k_clean).substr(std::string(k_clean).find('\n') + 1));
    EXPECT_EQ(run(folder, {"check", "spheres.cgfs", "lights.cgfs", "--strict"}).code, 0);
    const Finished r = run(folder, {"check", "spheres.cgfs", "lights.cgfs", "--convention", "epsilon=3"});
    EXPECT_EQ(r.code, 0) << r.err;
    RunOptions input;
    input.input = std::string(k_clean) + k_lost;
    EXPECT_TRUE(contains(run(folder, {"check", "-", "--format", "cgfs"}, input).out, "[shape-outside-view]"));
}

// The findings depend on the options of rendering.
TEST(Check, TakesThePictureOptionsOfRender) {
    const Folder folder;
    folder.write("a.cgfs", std::string(k_clean) +
                               "sphere { center = (0.3, 0.55, 1.5)  radius = 0.005  color = (255, 0, 0) }\n");
    const auto out = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"check", "a.cgfs"});
        const Finished r = run(folder, more);
        EXPECT_EQ(r.code, 0) << r.err;
        return r.out;
    };
    EXPECT_FALSE(contains(out({}), "[shape-too-small]"));
    EXPECT_TRUE(contains(out({"-s", "40x40", "--no-shadows"}), "[shape-too-small]"));
    folder.write("a.cgfs",
                 std::string(k_clean) + "light { type = point  intensity = 0  position = (0, 9, 0) }\n");
    EXPECT_TRUE(contains(out({}), "[light-without-color]"));
    EXPECT_FALSE(contains(out({"--shading", "color"}), "[light-without-color]"));
    folder.write(
        "a.cgfs",
        std::string(k_clean) +
            "sphere { center = (0, -5001, 0)  radius = 5000  color = (255, 255, 0)  reflective = 0.9 }\n"
            "sphere { center = (0, 5003, 0)  radius = 5000  color = (0, 255, 0)  reflective = 0.9 }\n");
    EXPECT_TRUE(contains(out({}), "[reflections-too-few]"));
    EXPECT_FALSE(contains(out({"--reflections", "100"}), "[reflections-too-few]"));
    EXPECT_EQ(run(folder, {"check", "a.cgfs", "--shading", "plastic"}).code, 2);
}

TEST(Check, AFindingInAnIncludedFileShowsItsLine) {
    const Folder folder;
    folder.write("part.glint",
                 "sphere { center = (0, 0, 0)  radius = 1 }\n\nmaterial spare { color = (1, 0, 0) }\n");
    folder.write("a.glint",
                 "camera { position = (0, 0, 8)  look_at = (0, 0, 0) }\n"
                 "light { position = (3, 3, 8)  intensity = 0.7 }\ninclude \"part.glint\"\n");
    const Finished r = run(folder, {"check", "a.glint"});
    EXPECT_TRUE(contains(r.out, "part.glint:3:1: warning: no shape uses material 'spare'")) << r.out << r.err;
    EXPECT_TRUE(contains(r.out, "\n  material spare { color = (1, 0, 0) }\n")) << r.out;
}

TEST(Check, BadInputAndUsage) {
    const Folder folder;
    folder.write("broken.cgfs", "sphere { center = (0, 0");
    EXPECT_EQ(run(folder, {"check", "broken.cgfs"}).code, 1);
    EXPECT_EQ(run(folder, {"check", "missing.cgfs"}).code, 1);
    EXPECT_EQ(run(folder, {"check"}).code, 2);
    folder.write("a.cgfs", k_clean);
    EXPECT_EQ(run(folder, {"check", "a.cgfs", "--wobble"}).code, 2);
    EXPECT_EQ(run(folder, {"check", "a.cgfs", "--convention", "wobble=1"}).code, 2);
}

}  // namespace
}  // namespace glint::test
