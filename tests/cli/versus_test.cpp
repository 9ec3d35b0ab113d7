// SPDX-License-Identifier: Apache-2.0
// glint versus: two pictures of one scene.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/process.h"

namespace glint::test {
namespace {

const std::string k_lights = GLINT_SOURCE "/scenes/epfl/three_lights.json";

std::vector<std::string> versus(std::vector<std::string> more) {
    std::vector<std::string> all{"versus", k_lights, "-s", "80x80"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

TEST(Versus, ExplainsThePixelThatDiffersMost) {
    const Folder folder;
    const Finished r =
        run(folder, versus({"--a", "shading=phong", "--b", "shading=blinn-phong", "-o", "v.png"}));
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(r.out.starts_with("shading=phong against shading=blinn-phong, 80x80 pixels\n")) << r.out;
    EXPECT_TRUE(contains(r.out, "\nA: shading=phong\npixel ")) << r.out;
    EXPECT_TRUE(contains(r.out, "R·V = ") && contains(r.out, "N·H = ")) << r.out;
    const std::string png = folder.read("v.png");
    ASSERT_GT(png.size(), 24u);
    EXPECT_EQ(static_cast<unsigned char>(png[19]), 248) << "A, B and the difference, 80 wide each, 4 between";

    const auto figures = [&](const std::vector<std::string>& more) {
        const Finished f = run(folder, versus(more));
        EXPECT_EQ(f.code, 0) << f.err;
        return nlohmann::json::parse(f.out);
    };
    const auto plain = figures({"--a", "shading=phong", "--b", "shading=blinn-phong", "--json"});
    // The explanations are of the named pixel, which is inside an object, and give its value.
    const auto& explained = plain["explained"];
    EXPECT_GT(explained["value"].get<double>(), 0.5 * plain["largest"]["value"].get<double>());
    for (const std::size_t side : {0u, 1u}) {
        const auto& e = plain["explanations"][side];
        EXPECT_EQ(e["pixel"], (nlohmann::json{explained["x"], explained["y"]}));
    }
    // On an edge that moved by half a pixel the two would be of different objects.
    const auto moved = figures({"--a", "pixel_sample=corner", "--json"});
    EXPECT_NE(moved["explanations"][0]["pixel"],
              (nlohmann::json{moved["largest"]["x"], moved["largest"]["y"]}));
    const auto matched =
        figures({"--a", "shading=phong", "--b", "shading=blinn-phong", "--match-exponents", "--json"});
    EXPECT_LT(matched["mean"].get<double>(), 0.2 * plain["mean"].get<double>())
        << "four times the exponent makes Blinn and Phong's highlight as wide";
}

TEST(Versus, ProfilesAndNoDifference) {
    const Folder folder;
    // Profiles have their own sizes; both pictures have the scene's.
    EXPECT_EQ(run(folder, {"versus", k_lights, "--a", "profile=epfl", "--b", "profile=cgfs"}).code, 0);
    const Finished r = run(folder, versus({"--a", "profile=epfl", "--b", "profile=cgfs"}));
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(contains(r.out, "B: profile=cgfs")) << r.out;
    const Finished same = run(folder, versus({"--a", "reflections=9", "--b", "reflections=9"}));
    EXPECT_EQ(same.code, 0);
    EXPECT_TRUE(same.out.ends_with("identical\n")) << same.out;
    const Finished json = run(folder, versus({"--a", "reflections=9", "--b", "reflections=9", "--json"}));
    EXPECT_TRUE(nlohmann::json::parse(json.out)["identical"].get<bool>());
}

TEST(Versus, WhatMakesNoSense) {
    const Folder folder;
    EXPECT_EQ(run(folder, versus({})).code, 2);
    EXPECT_EQ(run(folder, versus({"--a", "x=1"})).code, 2);
    EXPECT_EQ(run(folder, versus({"--a", "shading"})).code, 2);
    EXPECT_EQ(run(folder, versus({"--a", "profile=nobody"})).code, 2);
    EXPECT_EQ(run(folder, versus({"--a", "reflections=1", "-o", "v.jpg"})).code, 2);
    EXPECT_EQ(run(folder, {"versus", k_lights, "--a", "size=10x10", "--b", "size=20x20"}).code, 1);
}

}  // namespace
}  // namespace glint::test
