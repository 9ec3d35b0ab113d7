// SPDX-License-Identifier: Apache-2.0
// Normals and vectors, planted, and what is no mistake.
#include "check/check_text.h"

namespace glint::test {
namespace {

const std::string k_pov =
    R"(camera { location <0, 2, 9> up <0, 1, 0> right <1.33333, 0, 0> look_at <0, 1, 0> }
light_source { <3, 8, 7> color rgb <0.7, 0.7, 0.7> }
sphere { <0, 1, 0>, 1 pigment { color rgb <0.8, 0.3, 0.2> } finish { ambient 0.2 diffuse 0.7 } }
)";
const std::string k_finish = " pigment { color rgb <0.4, 0.5, 0.4> } finish { ambient 0.2 diffuse 0.7 } }\n";

TEST(CheckNormals, SeenFromBehind) {
    EXPECT_EQ(ids_of(k_pov + "plane { <0, 1, 0>, 0" + k_finish, "a.pov"), "");
    EXPECT_EQ(ids_of(k_pov + "plane { <0, -1, 0>, 0" + k_finish, "a.pov"), "seen-from-behind@4");
    const std::string front = "triangle { <-2, 0, -2>, <2, 0, -2>, <0, 4, -2>" + k_finish;
    const std::string back = "triangle { <2, 0, -2.5>, <-2, 0, -2.5>, <-3, 4, -2.5>" + k_finish;
    EXPECT_EQ(ids_of(k_pov + front, "a.pov"), "");
    EXPECT_EQ(ids_of(k_pov + front + back, "a.pov"), "seen-from-behind@5");
    EXPECT_TRUE(
        has(only_message(k_pov + front + back, "a.pov"), "another flat shape is seen from the front"));
    // Without a diffuse term both sides look the same.
    EXPECT_EQ(
        ids_of(k_pov + "plane { <0, -1, 0>, 0 pigment { color rgb <0.4, 0.5, 0.4> } finish { ambient 0.2 "
                       "diffuse 0 } }\n",
               "a.pov"),
        "");
    // glint's own conventions turn them.
    EXPECT_EQ(ids_of(k_clean + "triangle { vertices = ((2, 0, -2), (-2, 0, -2), (0, 4, -2)) }\n"), "");
}

std::string smooth(double z) {
    return fmt::format(
        "triangle {{ vertices = ((-1, 1, 2), (1, 1, 2), (0, 3, 2))  normals = ((0, 0.1, 1), (0.1, 0, 1), (0, "
        "0, {})) }}\n",
        z);
}

TEST(CheckNormals, AgainstTheWinding) {
    EXPECT_EQ(ids_of(k_clean + smooth(1)), "");
    EXPECT_EQ(ids_of(k_clean + smooth(-1)), "normals-on-both-sides@7");
    EXPECT_EQ(
        ids_of(k_clean +
               "triangle { vertices = ((1, 1, 2), (-1, 1, 2), (0, 3, 2))  normals = ((0, 0, 1), (0, 0, 1), "
               "(0, 0, 1)) }\n"),
        "normals-against-winding@7");
    // A mirrored one is turned around with all that it has.
    EXPECT_EQ(ids_of(k_clean + "group { scale = (-1, 1, 1)\n" + smooth(1) + "}\n"), "");
}

TEST(CheckVectors, NotUnitWhereTheFormatWantsIt) {
    EXPECT_EQ(ids_of(k_pov + "plane { <0, 2, 0>, -1" + k_finish, "a.pov"), "normal-not-unit@4");
    EXPECT_TRUE(
        has(only_message(k_pov + "plane { <0, 2, 0>, -1" + k_finish, "a.pov"), "remedy: write (0, 1, 0)"));
    EXPECT_EQ(ids_of(k_clean + "disc { center = (0, 2, 0)  normal = (0, 0, 7)  radius = 0.5 }\n"), "");
    const char* const k_epfl =
        R"({ "camera": { "position": [0, -8, 3], "target": [0, 0, 1], "up": [0, 0, 1], "fov": 45 },
"materials": [ { "name": "m", "color": [0.7, 0.5, 0.4], "ambient": 0.2, "diffuse": 0.7, "specular": 0, "shininess": 1, "mirror": 0 } ],
"lights": [ { "position": [3, -6, 7], "color": [0.8, 0.8, 0.8] } ],
"spheres": [ { "center": [0, 0, 1], "radius": 1, "material": "m" } ],
"planes": [
 { "center": [0, 0, 0], "normal": [0, 0, %s], "material": "m" } ] })";
    const auto with = [&](std::string_view z) {
        std::string text = k_epfl;
        return text.replace(text.find("%s"), 2, z);
    };
    EXPECT_EQ(ids_of(with("1"), "a.json"), "");
    EXPECT_EQ(ids_of(with("0.997"), "a.json"), "");
    EXPECT_EQ(ids_of(with("3"), "a.json"), "normal-not-unit@6");
    // It is the format that says so, and not the conventions that the scene is drawn by.
    LoadOptions other;
    other.profile = "glint";
    EXPECT_EQ(ids(check_loaded(*load_text(with("3"), "a.json", other))), "normal-not-unit@6");
    other.profile = "epfl";
    std::string own = k_clean;
    own.replace(own.find("(0, 1, 0)"), 9, "(0, 3, 0)");
    EXPECT_EQ(ids(check_loaded(*load_text(own, "a.glint", other))), "");
}

TEST(CheckVectors, VertexNormalsOfAPatch) {
    const auto patch = [](std::string_view z) {
        return fmt::format(
            "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 64 64\nl 3 3 5\n"
            "f 0.8 0.5 0.3 0.8 0 1 0 1\npp 3\n-1 -1 0 0 0 1\n1 -1 0 0 0 {}\n0 1 0 0 0 1\n",
            z);
    };
    EXPECT_EQ(ids_of(patch("1"), "a.nff"), "");
    EXPECT_EQ(ids_of(patch("2"), "a.nff"), "normal-not-unit@10");
}

TEST(CheckVectors, DirectionsThatAreNotNormalised) {
    const std::string light = "light { type = directional  to_light = (1, 2, 2)  intensity = 0.2 }\n";
    EXPECT_EQ(ids_of(k_clean + light), "");
    EXPECT_TRUE(has(ids_of(k_clean + "conventions { normalize = false }\n" + light), "direction-not-unit@8"));
}

}  // namespace
}  // namespace glint::test
