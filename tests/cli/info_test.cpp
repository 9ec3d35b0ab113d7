// SPDX-License-Identifier: Apache-2.0
// glint info.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/process.h"

namespace glint::test {
namespace {

TEST(Info, Text) {
    const Folder folder;
    folder.write("a.cgfs", k_scene);
    const Finished r = run(folder, {"info", "a.cgfs", "--convention", "limit=drop"});
    ASSERT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(contains(r.out, "1 sphere  (1)")) << r.out;
    EXPECT_TRUE(contains(r.out, "1 ambient, 1 point  (2)")) << r.out;
    EXPECT_TRUE(contains(r.out, "sum of intensities 1\n")) << r.out;
    EXPECT_TRUE(contains(r.out, "profile cgfs")) << r.out;
    EXPECT_TRUE(contains(r.out, "a.cgfs:3:1")) << "a light's place" << r.out;
    const std::size_t limit = r.out.find("\n  limit ");
    ASSERT_NE(limit, std::string::npos);
    EXPECT_TRUE(contains(r.out.substr(limit, 60), "drop")) << r.out;
    EXPECT_TRUE(contains(r.out.substr(limit, 60), "command line")) << r.out;
}

TEST(Info, MaxMemory) {
    const Folder folder;
    folder.write("a.pov", "union { #while(1) sphere { 0, 1 } #end }");
    const Finished limited = run(folder, {"info", "a.pov", "--max-memory", "4M"});
    EXPECT_NE(limited.code, 0);
    EXPECT_TRUE(contains(limited.err, "a.pov:1:")) << limited.err;
    EXPECT_TRUE(contains(limited.err, "takes more than 4 MiB of memory")) << limited.err;
    const Finished wrong = run(folder, {"info", "a.pov", "--max-memory", "4X"});
    EXPECT_TRUE(contains(wrong.err, "expected a size as 500M or 4G, found '4X'")) << wrong.err;
}

TEST(Info, AMeshIsSeenFromTheViewThatIsAskedFor) {
    const Folder folder;
    folder.write("a.stl",
                 "solid a\nfacet normal 0 0 1\nouter loop\nvertex -1 0 0\nvertex 1 0 0\nvertex 0 0 2\n"
                 "endloop\nendfacet\nendsolid a\n");
    const auto camera = [&](const std::string& view) {
        return run(folder, {"info", "a.stl", "--view", view}).out;
    };
    EXPECT_EQ(camera("front"), camera("0,0,2.5"));
    EXPECT_EQ(camera("iso"), camera("2,2,2"));
    EXPECT_NE(camera("iso"), camera("front"));
    for (const char* wrong : {"back", "1,2", "1,2,3,", "0,0,0", "nan,0,1", "1,1,inf"}) {
        const Finished refused = run(folder, {"info", "a.stl", "--view", wrong});
        EXPECT_EQ(refused.code, 2);
        EXPECT_TRUE(contains(refused.err, "expected front, iso or a direction from the mesh to the eye"))
            << refused.err;
    }
}

TEST(Info, Json) {
    const Folder folder;
    folder.write("dark.cgfs", "sphere { center = (1, 2, 3)  radius = 1  color = (255, 0, 0) }");
    const Finished r = run(folder, {"info", "dark.cgfs", "--json", "--profile", "glint"});
    ASSERT_EQ(r.code, 0) << r.err;
    const auto json = nlohmann::json::parse(r.out);
    EXPECT_EQ(json["shapes"]["sphere"], 1);
    EXPECT_EQ(json["shapes"]["plane"], 0);
    EXPECT_NEAR(json["bounds"]["min"][1].get<double>(), 1, 1e-5);
    EXPECT_EQ(json["lights"].size(), 0u);
    EXPECT_EQ(json["profile"], "glint");
    EXPECT_EQ(json["conventions"]["offset"]["value"], "scale");
    EXPECT_EQ(json["conventions"]["offset"]["from"], "profile glint");
    EXPECT_GT(json["memory_bytes"]["total"].get<int>(), 0);
    EXPECT_GT(json["memory_bytes"]["boxes"].get<int>(), 0);
    EXPECT_EQ(json["packed_shapes"], 1);
    EXPECT_GT(json["bytes_a_shape"].get<double>(), 0);
    EXPECT_EQ(json["warnings"].size(), 1u) << "no lights";
}

TEST(Info, CountsShapesWithColorsOfTheirOwn) {
    const Folder folder;
    folder.write("a.glint",
                 "camera { position = (0, 0, 5) }\nlight { position = (2, 4, 5) }\n"
                 "sphere { center = (0, 0, 0)  radius = 1  shape_color = (0.5, 0, 1) }\n"
                 "sphere { center = (3, 0, 0)  radius = 1 }\n");
    EXPECT_TRUE(contains(run(folder, {"info", "a.glint"}).out, "; 1 shape with a color of its own\n"));
    const auto json = nlohmann::json::parse(run(folder, {"info", "a.glint", "--json"}).out);
    EXPECT_EQ(json["shape_color_count"], 1);
    EXPECT_GE(json["memory_bytes"]["colors"].get<int>(), 24);
    const Finished told = run(folder, {"explain", "a.glint", "-s", "20x20", "-p", "10,10"});
    EXPECT_TRUE(
        contains(told.out, "in the shape's own color (0.5, 0, 1): k_a (0.05, 0, 0.1), k_d (0.4, 0, 0.8)"))
        << told.out;
    const auto hit = nlohmann::json::parse(
        run(folder, {"explain", "a.glint", "-s", "20x20", "-p", "10,10", "--as", "json"})
            .out)["rays"][0]["hit"];
    EXPECT_EQ(hit["shape"]["color"], (std::vector<double>{0.5, 0, 1}));
    EXPECT_EQ(hit["material"]["diffuse"], (std::vector<double>{0.4, 0, 0.8}));
}

TEST(Info, IsaIsOneNameALine) {
    const Folder folder;
    const Finished r = run(folder, {"info", "--isa"});
    EXPECT_EQ(r.code, 0);
    EXPECT_TRUE(r.out.ends_with("scalar\n")) << r.out;
    EXPECT_FALSE(contains(r.out, " "));
}

}  // namespace
}  // namespace glint::test
