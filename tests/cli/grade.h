// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shared by the tests of glint grade: the rendered and graded pictures of a class.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "cli/process.h"

namespace glint::test {

inline const std::string k_castle = GLINT_SOURCE "/scenes/epfl/castle.json";
inline const std::string k_rubric = GLINT_SOURCE "/docs/rt2.rubric";

class Grade : public ::testing::Test {
  protected:
    void draw(const std::string& out, std::vector<std::string> more) {
        std::filesystem::create_directories(std::filesystem::path(folder.path(out)).parent_path());
        std::vector<std::string> arguments = {"render", k_castle, "-s", "96x72", "-q", "-o", out};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Finished r = run(folder, arguments);
        ASSERT_EQ(r.code, 0) << r.err;
    }
    // The pictures that RT2 asks for.
    void hand_in(const std::string& name) {
        draw(name + "/castle_diffuse.png", {"--shading", "diffuse", "--no-shadows", "--reflections", "0"});
        draw(name + "/castle_phong.png", {"--shading", "phong", "--no-shadows", "--reflections", "0"});
        draw(name + "/castle_blinn.png", {"--no-shadows", "--reflections", "0"});
        draw(name + "/castle_shadows.png", {"--reflections", "0"});
        draw(name + "/castle_reflections.png", {});
        // Only the ambient part: the scene without its other lights.
        std::ifstream in(k_castle);
        const std::string json{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
        const std::size_t lights = json.find("\"lights\"");
        const std::string out = std::regex_replace(
            json.substr(lights), std::regex("(\"position\": \\[[^\\]]*\\], \"color\": )\\[[^\\]]*\\]"),
            "$1[0, 0, 0]");
        folder.write("dark.json", json.substr(0, lights) + out);
        const Finished r = run(folder, {"render", "dark.json", "-s", "96x72", "-q", "-o",
                                        name + "/castle_ambient.png", "--no-shadows", "--reflections", "0"});
        ASSERT_EQ(r.code, 0) << r.err;
    }
    Finished grade(std::vector<std::string> more) {
        more.insert(more.begin(), "grade");
        return run(folder, more);
    }
    nlohmann::json graded(std::vector<std::string> more) {
        more.insert(more.end(), {"--json", "out.json"});
        const Finished r = grade(more);
        EXPECT_EQ(r.code, 0) << r.err;
        return nlohmann::json::parse(folder.read("out.json"));
    }
    const Folder folder;
};

}  // namespace glint::test
