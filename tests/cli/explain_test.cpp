// SPDX-License-Identifier: Apache-2.0
// glint explain: its output formats and errors. tests/explain checks the contents.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "image/read_png.h"

namespace glint::test {
namespace {

const std::string k_castle = GLINT_SOURCE "/scenes/epfl/castle.json";

TEST(Explain, TellsOfAPixel) {
    const Folder folder;
    const Finished r = run(folder, {"explain", k_castle, "-p", "320,440"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(r.out.starts_with("pixel 320,440 of 640x640\ncamera ray 0 from (25, -37, 13.5)")) << r.out;
    EXPECT_TRUE(contains(r.out, "castle.json:")) << r.out;
    EXPECT_TRUE(contains(r.out, "\nthe pixel\n")) << r.out;
    EXPECT_FALSE(contains(r.out, "\x1b[")) << "colors, though this is no terminal";
    EXPECT_EQ(folder.count(), 0);
}

// In a terminal the colors are shown, unless NO_COLOR is set (no-color.org: and not empty).
TEST(Explain, ShowsColorsInATerminal) {
    const Folder folder;
    RunOptions options;
    options.program = "/usr/bin/script";
    const auto shown = [&](const std::string& no_color) {
        const std::string line =
            "env -u NO_COLOR " + no_color + " " GLINT_COMMAND " explain " + k_castle + " -p 320,440";
        return Process(folder, {"-qec", line, "/dev/null"}, options).finish().out;
    };
    const std::string swatch = "bytes        24 36 11  \x1b[48;2;24;36;11m    \x1b[0m";
    EXPECT_TRUE(contains(shown(""), swatch)) << shown("");
    EXPECT_TRUE(contains(shown("NO_COLOR="), swatch));
    const std::string plain = shown("NO_COLOR=1");
    EXPECT_TRUE(contains(plain, "bytes        24 36 11")) << plain;
    EXPECT_FALSE(contains(plain, "48;2")) << plain;
}

TEST(Explain, TheBytesOfTheJsonAreTheFiles) {
    const Folder folder;
    ASSERT_EQ(run(folder, {"render", k_castle, "-s", "80x80", "-o", "c.ppm", "--shading", "phong"}).code, 0);
    const std::string ppm = folder.read("c.ppm");
    const std::size_t pixels = ppm.size() - 3 * 80 * 80;
    for (const auto& [x, y] : {std::pair{40, 60}, std::pair{0, 0}, std::pair{79, 79}, std::pair{37, 41}}) {
        const std::string at = std::to_string(x) + "," + std::to_string(y);
        const Finished r =
            run(folder, {"explain", k_castle, "-s", "80x80", "--shading", "phong", "--as", "json", "-p", at});
        ASSERT_EQ(r.code, 0) << r.err;
        const auto json = nlohmann::json::parse(r.out);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto byte =
                static_cast<std::uint8_t>(ppm[pixels + 3 * static_cast<std::size_t>(80 * y + x) + c]);
            EXPECT_EQ(json["bytes"][c], byte) << at;
        }
        // The same pixel, with rows counted from the bottom.
        const std::string below = std::to_string(x) + "," + std::to_string(79 - y);
        EXPECT_EQ(run(folder, {"explain", k_castle, "-s", "80x80", "--shading", "phong", "--as", "json", "-p",
                               below, "--origin", "bottom-left"})
                      .out,
                  r.out);
    }
}

TEST(Explain, TheNumbersAreThoseOfTheFileThatRenderWrites) {
    const Folder folder;
    const std::vector<std::string> cases[] = {
        {"--bits", "8"},
        {"--bits", "16"},
        {"--transfer", "srgb"},
        {"--transfer", "srgb", "--bits", "16"},
        {"--convention", "rounding=down"},
        {"--convention", "transfer=srgb", "--convention", "gamma=2.2", "--convention", "rounding=half_up"},
        {"--convention", "transfer=srgb", "--transfer", "none"}};
    for (const std::vector<std::string>& more : cases) {
        std::vector<std::string> render = {"render", k_castle, "-s", "40x40", "-q", "-o", "c.png"},
                                 tell = {"explain", k_castle, "-s", "40x40", "-p", "20,30"};
        render.insert(render.end(), more.begin(), more.end());
        tell.insert(tell.end(), more.begin(), more.end());
        ASSERT_EQ(run(folder, render).code, 0);
        const Picture picture = read_png(folder.path("c.png"));
        ASSERT_EQ(picture.error, "");
        const std::uint16_t* found = &picture.samples[3 * (30 * 40 + 20)];
        const std::string numbers =
            std::to_string(found[0]) + " " + std::to_string(found[1]) + " " + std::to_string(found[2]);
        EXPECT_TRUE(contains(run(folder, tell).out, numbers + "\n")) << numbers << run(folder, tell).out;
        tell.insert(tell.end(), {"--as", "json"});
        const auto json = nlohmann::json::parse(run(folder, tell).out);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(json[picture.bits == 8 ? "bytes" : "words"][c], found[c]) << more.back();
        tell.back() = "printrays";
        const std::string course = "Color: (" + std::to_string(found[0]) + ", " + std::to_string(found[1]);
        EXPECT_TRUE(contains(run(folder, tell).out, course)) << more.back();
    }
    EXPECT_EQ(run(folder, {"explain", k_castle, "-p", "1,1", "--bits", "12"}).code, 2);
    EXPECT_EQ(run(folder, {"explain", k_castle, "-p", "1,1", "--transfer", "gamma"}).code, 2);
}

TEST(Explain, RaysThatAddLittleAreOneLine) {
    const Folder folder;
    const std::string glass = GLINT_SOURCE "/scenes/glint/glass.glint";
    const auto tell = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"explain", glass, "-p", "160,120"});
        return run(folder, more);
    };
    const std::string usual = tell({}).out, all = tell({"--all"}).out;
    EXPECT_TRUE(contains(usual, "adds with the 6 rays after it (0.000623257, ")) << usual;
    EXPECT_TRUE(contains(usual, ": less than 0.5 of 255\n")) << usual;
    EXPECT_TRUE(contains(usual, "\nrays not shown: 7, which add (0.000623257, ")) << usual;
    EXPECT_FALSE(contains(all, "less than") || contains(all, "not shown")) << all;
    EXPECT_LT(usual.size(), all.size());
    EXPECT_EQ(usual.substr(usual.find("\nthe pixel:")), all.substr(all.find("\nthe pixel:")));
    EXPECT_EQ(tell({"--fold", "0"}).out, all);
    EXPECT_EQ(tell({"--fold", "0.5"}).out, usual);
    EXPECT_LT(tell({"--fold", "100"}).out.size(), usual.size());
    EXPECT_EQ(tell({"--as", "json"}).out, tell({"--as", "json", "--all"}).out);
    for (const char* wrong : {"nan", "-1", "256", "x"}) EXPECT_EQ(tell({"--fold", wrong}).code, 2) << wrong;
}

TEST(Explain, TheSamplesOfAnAreaLightAndTheStepOfAMirrorRay) {
    const Folder folder;
    folder.write("a.glint",
                 "camera { position = (0, 3, 6)  look_at = (0, 0, 0) }\n"
                 "light \"lamp\" { type = parallelogram  position = (0, 4, 0)  side_u = (1, 0, 0)  side_v = "
                 "(0, 0, 1)  "
                 "samples_u = 2  samples_v = 2 }\n"
                 "plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (1, 0, 0)  mirror = 0.5 }\n");
    const Finished r = run(folder, {"explain", "a.glint", "-s", "9x9", "-p", "4,6"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(contains(r.out, "each sample has 1/4 of the light; N·L = ")) << r.out;
    EXPECT_TRUE(contains(r.out, ", which adds most: L (")) << r.out;
    const Finished mirror = run(folder, {"explain", "a.glint", "-s", "9x9", "-p", "4,6", "--all",
                                         "--convention", "offset=normal", "--convention", "epsilon=0.001"});
    EXPECT_TRUE(contains(mirror.out,
                         "starts 0.001 from P along N, so that it does not hit the surface at P again "
                         "(offset normal, epsilon 0.001)"))
        << mirror.out;
    EXPECT_TRUE(contains(mirror.out, "x 0.5 (the rest is what it reflects or lets through) = "))
        << mirror.out;
}

TEST(Explain, ListsTheSamples) {
    const Folder folder;
    folder.write("a.glint",
                 "camera { position = (0, 0, 4)  look_at = (0, 0, 0) }\nbackground = (0, 0, 1)\n"
                 "light { type = ambient  intensity = 1 }\n"
                 "plane \"wall\" { point = (0, 0, 0)  normal = (1, 0, 0)  color = (1, 0, 0)  ambient = 1 }\n"
                 "sphere \"ball\" { center = (0, 0, 0)  radius = 1  color = (1, 0.5, 0)  ambient = 1 }\n");
    const std::vector<std::string> tell = {"explain", "a.glint", "-s", "9x9", "-p", "5,2", "--aa", "2"};
    const Finished r = run(folder, tell);
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(
        r.out.ends_with("its samples, column and row\n"
                        "    0,0  (0, 0, 1)    hits nothing\n"
                        "    1,0  (0, 0, 1)    hits nothing\n"
                        "    0,1  (1, 0.5, 0)  sphere 'ball' (a.glint:5:1)\n"
                        "    1,1  (0, 0, 1)    hits nothing; shown above\n"))
        << r.out;
    EXPECT_FALSE(contains(run(folder, {"explain", "a.glint", "-s", "9x9", "-p", "5,2"}).out, "its samples"));
    EXPECT_FALSE(contains(run(folder, {"explain", "a.glint", "-s", "9x9", "-p", "5,2", "--aa", "9"}).out,
                          "its samples"));
}

// The exact layout of CSC 473: a sphere in front of nothing, in a mirror.
TEST(Explain, PrintsRaysAsTheCourseDoes) {
    const Folder folder;
    folder.write("a.pov",
                 R"(camera { location <0, 0, 14> up <0, 1, 0> right <1.33333, 0, 0> look_at <0, 0, 0> }
light_source { <-100, 100, 100> color rgb <1.5, 1.5, 1.5> }
sphere { <0, 0, 0>, 2 pigment { color rgb <1, 0, 1> } finish { ambient 0.2 diffuse 0.4 reflection 0.5 } }
)");
    const Finished r = run(folder, {"explain", "a.pov", "-p", "320,239", "--origin", "bottom-left", "--as",
                                    "printrays", "-s", "640x480"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.out, R"(Pixel: [320, 239] Color: (69, 0, 69)
----
      Iteration type: Primary
                 Ray: {0.0000 0.0000 14.0000} -> {0.0010 -0.0010 -1.0000}
          Hit Object: (ID #1 - Sphere)
        Intersection: {0.0125 -0.0125 1.9999} at T = 12.0001
              Normal: {0.0063 -0.0063 1.0000}
             Ambient: {0.2000, 0.0000, 0.2000}
             Diffuse: {0.3373, 0.0000, 0.3373}
            Specular: {0.0000, 0.0000, 0.0000}
----
      Iteration type: Reflection
                 Ray: {0.0125 -0.0125 2.0009} -> {0.0135 -0.0135 0.9998}
  No intersection.
)");
}

TEST(Explain, WhyALightAddsNothing) {
    const Folder folder;
    const std::string acne = GLINT_SOURCE "/scenes/faults/acne.glint";
    const Finished r = run(folder, {"explain", acne, "-p", "140,110", "--why-not", "sun"});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_TRUE(contains(r.out, "adds nothing: blocked by sphere 'ball'")) << r.out;
    EXPECT_TRUE(contains(r.out, "see the convention 'epsilon'")) << r.out;
    EXPECT_EQ(run(folder, {"explain", acne, "-p", "140,110", "--why-not", "2"}).out, r.out);
    EXPECT_TRUE(
        contains(run(folder, {"explain", acne, "-p", "140,110", "--why-not", "1"}).out, "is ambient"));
    EXPECT_TRUE(
        contains(run(folder, {"explain", acne, "-p", "10,10", "--why-not", "2"}).out, "hits nothing"));
    EXPECT_TRUE(
        contains(run(folder, {"explain", acne, "-p", "10,10", "--why-not", "1"}).out, "hits nothing"));
    const Finished json = run(folder, {"explain", acne, "-p", "140,110", "--why-not", "2", "--as", "json"});
    EXPECT_EQ(json.code, 2);
    EXPECT_TRUE(contains(json.err, "--why-not prints text only, not json")) << json.err;
    const Finished none = run(folder, {"explain", acne, "-p", "140,110", "--why-not", "moon"});
    EXPECT_EQ(none.code, 2);
    EXPECT_TRUE(contains(none.err, "there is no light 'moon'; there are 2 lights")) << none.err;
}

TEST(Explain, OpacityAtAnAngle) {
    const Folder folder;
    folder.write("a.glint",
                 "camera { position = (0, 0, 9) } light { type = ambient intensity = 1 }\n"
                 "material m { color = (1, 0.2, 0.2) transmit = 0.5 angled_opacity = true }\n"
                 "sphere { center = (0, 0, 0) radius = 2 material = m }\n");
    const Finished r = run(folder, {"explain", "a.glint", "-s", "64x48", "-p", "32,24", "--as", "json"});
    ASSERT_EQ(r.code, 0) << r.err;
    const auto hit = nlohmann::json::parse(r.out)["rays"][0]["hit"];
    const double opacity = hit["opacity"];
    EXPECT_LT(opacity, 0.3);
    for (const double through : hit["through"]) EXPECT_DOUBLE_EQ(through, 1 - opacity);
    const Finished text = run(folder, {"explain", "a.glint", "-s", "64x48", "-p", "32,24"});
    const std::string line = fmt::format(
        "transparent: opacity {:.6g}, what is behind times {:.6g}, at this angle\n", opacity, 1 - opacity);
    EXPECT_TRUE(contains(text.out, line)) << line << text.out;
}

TEST(Explain, TellsOfHolesAndOfBorders) {
    const Folder folder;
    folder.write("leaf.glint",
                 "render { size = 8 x 4 }\ncamera { position = (0, 0, 9)  look_at = (0, 0, 0)  fov_x = 20 }\n"
                 "light { type = ambient }\n"
                 "texture leaf { texels = (\"10203033 405060ff\")  filter = nearest  alpha = mask  mapping = "
                 "planar  scale = 8  translate = (-4, -4, 0) }\n"
                 "texture wall { texels = (\"102030 405060\")  mapping = planar  wrap_u = clamp }\n"
                 "disc \"sheet\" { center = (0, 0, 0)  normal = (0, 0, 1)  radius = 9  texture = leaf }\n"
                 "plane { point = (0, 0, -1)  normal = (0, 0, 1)  texture = wall }\n");
    const std::string left = run(folder, {"explain", "leaf.glint", "-p", "1,2"}).out,
                      right = run(folder, {"explain", "leaf.glint", "-p", "6,2"}).out;
    EXPECT_TRUE(contains(left,
                         "\n  passes a hole of disc 'sheet' (leaf.glint:6:1) at t = 9.05666: texture 'leaf' "
                         "(leaf.glint:4:1) at u "))
        << left;
    EXPECT_TRUE(contains(left, ", alpha 0.2 is below the cutoff 0.5\n  hits plane 2 ")) << left;
    EXPECT_TRUE(contains(left, " (clamped), v ")) << left;
    EXPECT_FALSE(contains(right, "hole")) << right;
    EXPECT_FALSE(contains(right, "clamped")) << right;
}

TEST(Explain, TellsOfColorsOfAMap) {
    const Folder folder;
    folder.write("map.glint",
                 "render { size = 8 x 4 }\ncamera { position = (0, 0, 9)  look_at = (0, 0, 0)  fov_x = 20 }\n"
                 "light { type = ambient }\n"
                 "texture map { color_map = ((0, (1, 0, 0)), (0.5, (0, 0, 1)))  mapping = planar  scale = 10 "
                 " translate = (-5, 0, 0) }\n"
                 "texture board { color_map = ((0, (1, 1, 1)), (0.5, (0, 1, 0)))  mapping = checker  filter "
                 "= nearest }\n"
                 "disc { center = (0.5, 0, 0)  normal = (0, 0, 1)  radius = 0.9  texture = map }\n"
                 "plane { point = (0, 0, -1)  normal = (0, 0, 1)  texture = board }\n");
    const std::string map = run(folder, {"explain", "map.glint", "-p", "3,2"}).out,
                      board = run(folder, {"explain", "map.glint", "-p", "0,2"}).out;
    EXPECT_TRUE(contains(map, "texture 'map' (map.glint:4:1) at u 0.48")) << map;
    EXPECT_TRUE(contains(map,
                         " of planar: between color 1 of the color map (at 0: (1, 0, 0)) and color 2 of the "
                         "color map (at 0.5: "
                         "(0, 0, 1)), 0.96"))
        << map;
    EXPECT_TRUE(contains(board, "at u 0 of checker: color 1 of the color map (at 0: 1), color 1, which"))
        << board;
}

TEST(Explain, TellsOfBacks) {
    const Folder folder;
    folder.write(
        "back.glint",
        "render { size = 8 x 4 }\ncamera { position = (0, 0, 9)  look_at = (0, 0, 0)  fov_x = 20 }\n"
        "light { type = ambient }\n"
        "disc \"sheet\" { center = (0, 0, 0)  normal = (0, 0, -1)  radius = 9  one_sided = true }\n");
    const std::string text = run(folder, {"explain", "back.glint", "-p", "1,2"}).out;
    EXPECT_TRUE(
        contains(text,
                 "\n  passes the back of disc 'sheet' (back.glint:4:1) at t = 9.05666: its material is "
                 "one-sided\n"))
        << text;
    const Finished json = run(folder, {"explain", "back.glint", "-p", "1,2", "--as", "json"});
    const auto hole = nlohmann::json::parse(json.out)["rays"][0]["holes"][0];
    EXPECT_EQ(hole["back"], true);
    EXPECT_EQ(hole["shape"]["name"], "sheet");
    EXPECT_FALSE(hole.contains("texture") || hole.contains("cutoff"));
}

TEST(Explain, DrawsItsRaysOverThePicture) {
    const Folder folder;
    ASSERT_EQ(run(folder, {"render", k_castle, "-s", "64x64", "-o", "plain.ppm"}).code, 0);
    ASSERT_EQ(run(folder, {"explain", k_castle, "-s", "64x64", "-p", "30,50", "--overlay", "rays.png"}).code,
              0);
    EXPECT_TRUE(folder.read("rays.png").starts_with("\x89PNG"));
    EXPECT_EQ(run(folder, {"explain", k_castle, "-p", "3,3", "--overlay", "rays.gif"}).code, 2);
    EXPECT_EQ(run(folder, {"explain", k_castle, "-p", "3,3", "--overlay", "-"}).code, 2);
    EXPECT_EQ(run(folder, {"explain", k_castle, "-p", "3,3", "--overlay", "no/rays.png"}).code, 1);
}

TEST(Explain, WhatMakesNoSense) {
    const Folder folder;
    for (const char* pixel :
         {"", "3", "3,", ",3", "a,b", "3,4,5", "3.5,4", "640,0", "0,640", "-1,0", "99999999999,0"}) {
        const Finished r = run(folder, {"explain", k_castle, std::string("--pixel=") + pixel});
        EXPECT_EQ(r.code, 2) << pixel;
        EXPECT_TRUE(contains(r.err, "pixel")) << r.err;
    }
    EXPECT_EQ(run(folder, {"explain", k_castle}).code, 2);
    EXPECT_EQ(run(folder, {"explain", k_castle, "-p", "1,1", "--sample", "1,0"}).code, 2);
    EXPECT_EQ(run(folder, {"explain", k_castle, "-p", "1,1", "--aa", "2", "--sample", "1,0"}).code, 0);
    EXPECT_EQ(run(folder, {"explain", k_castle, "-p", "1,1", "--as", "xml"}).code, 2);
    EXPECT_EQ(run(folder, {"explain", "no.json", "-p", "1,1"}).code, 1);
}

}  // namespace
}  // namespace glint::test
