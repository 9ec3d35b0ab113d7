// SPDX-License-Identifier: Apache-2.0
// What a small picture shows, planted, and what is no mistake.
#include "check/check_text.h"

namespace glint::test {
namespace {

TEST(CheckPicture, FogThatHidesEverything) {
    const std::string dense = k_clean + "fog { type = exp  density = 40 }\n";
    EXPECT_EQ(ids_of(dense), "fog-hides-everything@7");
    EXPECT_TRUE(has(only_message(dense), "remedy: lower the density")) << only_message(dense);
    const std::string near =
        k_clean + "background = (0.2, 0.3, 0.4)\nfog { type = linear  start = 0  end = 1 }\n";
    EXPECT_EQ(ids_of(near + "conventions { fog_background = false }\n"), "fog-hides-everything@8");
    EXPECT_TRUE(has(only_message(near), "remedy: raise `end`")) << only_message(near);
    EXPECT_EQ(ids_of(k_clean + "fog { type = exp  density = 0.1 }\n"), "");
}

TEST(CheckPicture, FogThatIsNotVisible) {
    const std::string thin =
        "fog { type = exp  density = 0.0000001 }\nconventions { fog_background = false }\n";
    EXPECT_EQ(ids_of(k_clean + thin), "fog-not-visible@7");
    // All that is there is a ball, and the fog begins behind it.
    const std::string ball =
        "camera { position = (0, 0, 8)  look_at = (0, 0, 0) }\nlight { position = (4, 5, 6) }\n"
        "conventions { fog_background = false }\nsphere { center = (0, 0, 0)  radius = 1 }\n";
    EXPECT_EQ(ids_of(ball + "fog { type = linear  start = 20  end = 30 }\n"), "fog-not-visible@5");
    EXPECT_EQ(ids_of(ball + "fog { type = linear  start = 6  end = 30 }\n"), "");
    EXPECT_EQ(ids_of(ball + "render { shading = color }\nfog { type = linear  start = 20  end = 30 }\n"), "");
}

TEST(CheckPicture, Black) {
    EXPECT_TRUE(has(ids_of(R"(camera { position = (0, 0, 8)  look_at = (0, 0, 0) }
light { position = (0, 4, 8) }
sphere { center = (0, 0, 0)  radius = 1  color = (0, 0, 0) }
)"),
                    "picture-black@0"));
}

TEST(CheckPicture, Dark) {
    const auto lit = [](const char* intensity) {
        return fmt::format(
            "camera {{ position = (0, 1, 6)  look_at = (0, 1, 0) }}\nlight {{ position = (3, 5, 5)  "
            "intensity = {} }}\nsphere {{ center = (0, 1, 0)  radius = 1 }}\n"
            "plane {{ point = (0, 0, 0)  normal = (0, 1, 0) }}\n",
            intensity);
    };
    const std::string message = only_message(lit("0.004"));
    EXPECT_TRUE(has(message, "[picture-dark]")) << message;
    EXPECT_TRUE(has(message, "of the lights about 300 times")) << message;
    EXPECT_EQ(ids_of(lit("0.1")), "");
    EXPECT_EQ(ids_of(lit("1")), "");
}

TEST(CheckPicture, OfOneColor) {
    EXPECT_TRUE(has(ids_of(R"(background = (1, 1, 1)
camera { position = (0, 0, 8)  look_at = (0, 0, 0) }
light { type = ambient  intensity = 9 }
sphere { center = (0, 0, 0)  radius = 1  color = (1, 1, 1)  ambient = 1 }
)"),
                    "picture-one-color@0"));
}

TEST(CheckPicture, Clamped) {
    const std::string text = R"(camera { position = (0, 2, 8)  look_at = (0, 0.5, 0)  fov_x = 50 }
light { type = ambient  intensity = 0.6 }
light { position = (3, 6, 5)  intensity = 0.9 }
material floor { color = (0.9, 0.9, 0.9)  ambient = 1  diffuse = 1 }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  material = floor }
)";
    EXPECT_EQ(ids_of(text), "picture-clamped@4");
    EXPECT_TRUE(has(only_message(text), "can come to 1.35")) << only_message(text);
    EXPECT_EQ(ids_of("background = (1.5, 1.5, 1.5)\n" + k_clean), "picture-clamped@1");
    const std::string all = only_message(R"(camera { position = (0, 2, 8)  look_at = (0, 0, 0)  fov_x = 20 }
light { position = (3, 60, 5)  intensity = 5 }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.9, 0.9, 0.9) }
sphere { center = (0, 0.3, 0)  radius = 0.08  color = (0.02, 0.02, 0.02)  specular = 0 }
)");
    EXPECT_TRUE(has(all, " 100% of ")) << all;
}

TEST(CheckPicture, ClampedByAmbientLight) {
    const auto floor = [](std::string_view ambient, std::string_view light) {
        return only_message(fmt::format(
            "camera {{ position = (0, 2, 8)  look_at = (0, 0.5, 0)  fov_x = 50 }}\n"
            "light {{ type = ambient  intensity = 1 }}\nlight {{ position = (3, 6, 5)  intensity = {} }}\n"
            "plane {{ point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.9, 0.9, 0.9)  ambient = {}  diffuse "
            "= 1 "
            "}}\n",
            light, ambient));
    };
    const std::string usual = "0.05 to 0.3 of the material's color", others = "lower the other lights'";
    std::string message = floor("1", "0.9");
    EXPECT_TRUE(has(message, "can come to 1.71, of which k_a I_a alone is 0.9")) << message;
    EXPECT_TRUE(has(message, usual) && !has(message, others)) << message;
    message = floor("1", "1.5");
    EXPECT_TRUE(has(message, usual) && has(message, others)) << message;
    // The lights alone.
    message = floor("0.2", "1.9");
    EXPECT_TRUE(has(message, "[picture-clamped]") && !has(message, usual)) << message;
}

TEST(CheckPicture, AShapeMayNotBeAllClamped) {
    const std::string white = R"(camera { position = (0, 0, 8)  look_at = (0, 0, 0)  fov_x = 60 }
light { type = ambient  intensity = 1 }
light { position = (3, 6, 8)  intensity = 3 }
sphere { center = (0, 0, 0)  radius = 1  color = (1, 1, 1)  ambient = 1  diffuse = 1 }
)";
    EXPECT_EQ(ids_of(white), "picture-clamped@4");
    EXPECT_TRUE(has(only_message(white), "sphere 1 is brighter than 1")) << only_message(white);
    EXPECT_TRUE(has(only_message(white), "can come to 4")) << only_message(white);
    // A lamp glows.
    EXPECT_EQ(
        ids_of(k_clean + "sphere { center = (0, 2.6, 0)  radius = 0.4  color = (1, 1, 1)  ambient = 8 }\n"),
        "");
    EXPECT_EQ(
        ids_of(k_clean + "sphere { center = (0, 2.6, 0)  radius = 0.4  color = (1, 1, 1)  emission = 2 }\n"),
        "");
}

TEST(CheckPicture, ShapesOfOneMaterialAreOneFinding) {
    const std::string three =
        "material chalk { color = (1, 1, 1)  ambient = 1  diffuse = 4 }\n"
        "sphere { center = (0, 0.4, 3)  radius = 0.4  material = chalk }\n"
        "sphere { center = (1, 0.4, 3)  radius = 0.4  material = chalk }\n"
        "sphere { center = (2, 0.4, 3)  radius = 0.4  material = chalk }\n";
    EXPECT_EQ(ids_of(k_clean + three), "picture-clamped@8");
    EXPECT_TRUE(
        has(only_message(k_clean + three), "sphere 4 (line 8), sphere 5 (line 9) and sphere 6 (line 10) are"))
        << only_message(k_clean + three);
    // Two materials are two findings.
    EXPECT_EQ(
        ids_of(
            k_clean + three +
            "sphere { center = (-1, 0.4, 3)  radius = 0.4  color = (1, 1, 1)  ambient = 1  diffuse = 5 }\n"),
        "picture-clamped@8 picture-clamped@11");
    // A mistake in the material's own numbers explains it.
    EXPECT_EQ(ids_of(k_clean +
                     "sphere { center = (0, 0.4, 3)  radius = 0.4  color = (255, 255, 255)  diffuse = 1 }\n"),
              "material-color-255@7");
    EXPECT_EQ(
        ids_of(k_clean +
               "sphere { center = (0, 0.4, 3)  radius = 0.4  color = (1, 1, 1)  diffuse = 1  specular = 1 "
               " shininess = 0 }\n"),
        "shininess-zero@7");
}

TEST(CheckPicture, AHighlightMayBeClamped) {
    // About 1% of the picture.
    EXPECT_EQ(ids_of(k_clean + "sphere { center = (0, 1.3, 2)  radius = 1.3  color = (1, 1, 1)  ambient = 1\n"
                               "diffuse = 0.7  specular = 1  shininess = 8 }\n"),
              "");
}

TEST(CheckPicture, EpsilonTooSmall) {
    EXPECT_EQ(ids_of(k_clean + "conventions { epsilon = 0 }\n"), "epsilon-too-small@7");
    EXPECT_EQ(ids_of(k_clean + "conventions {\n  offset = normal\n  epsilon = 1e-17 }\n"),
              "epsilon-too-small@9");
    EXPECT_TRUE(
        has(only_message(k_clean + "conventions { epsilon = 0 }\n"), "% of the picture is in shadow acne"));
}

// A row of pixels meets the plane where rounding puts it, 1e17 away.
TEST(CheckPicture, TheHorizonOfAPlaneAsksForNoEpsilon) {
    EXPECT_EQ(
        ids_of("Begin_Scene\nResolution 160 120\n"
               "Camera Zoom 1.5 Aspectratio 1 Antialiasing 0 Raydepth 6 Center 0 2 -8 Viewdir 0 -0.2 1 "
               "Updir 0 1 0 End_Camera\nBackground 0.1 0.2 0.4\nLight Center 5 8 -10 Rad 0.1 Color 1 1 1\n"
               "Plane Center 0 0 0 Normal 0 1 0 Texture Ambient 0.2 Diffuse 0.7 Specular 0 Opacity 1 "
               "Color 0.8 0.4 0.2 TexFunc 0\n"
               "Sphere Center 0 1 0 Rad 1 Texture Ambient 0.2 Diffuse 0.7 Specular 0 Opacity 1 "
               "Color 0.2 0.4 0.8 TexFunc 0\nEnd_Scene\n",
               "scene.dat"),
        "");
}

TEST(CheckPicture, EpsilonTooLarge) {
    // A scene in millimetres, with an epsilon for one in metres.
    const std::string small = R"(camera { position = (0, 0.002, 0.008)  look_at = (0, 0.0005, 0)  fov_x = 50 }
light { type = ambient  intensity = 0.2 }
light { position = (0.003, 0.006, 0.005)  intensity = 0.6 }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.5, 0.5, 0.5)  ambient = 1  diffuse = 0.9 }
sphere { center = (-0.0015, 0.001, 0)  radius = 0.001  color = (0.8, 0.3, 0.2)  ambient = 1  diffuse = 0.9 }
)";
    EXPECT_EQ(ids_of(small + "conventions { offset = normal  epsilon = 0.001 }\n"), "epsilon-too-large@6");
    EXPECT_EQ(ids_of(small + "conventions { offset = normal  epsilon = 1e-6 }\n"), "");
    EXPECT_EQ(ids_of(small), "");
}

TEST(CheckPicture, WhereMirrorsMakeChaosNoEpsilonIsTooLarge) {
    // A quarter of the picture changes with the epsilon, and goes on to with those that are smaller still.
    EXPECT_FALSE(has(ids_of(R"(render { size = 160 x 120  reflections = 60 }
conventions { offset = normal  epsilon = 0.0001 }
camera { position = (0, 0, 0.05)  look_at = (0.3, 0.2, -3)  fov_x = 100 }
light { type = ambient  intensity = 0.4 }
light { position = (0, 0.3, 0)  intensity = 0.6 }
sphere { center = (1, 1, 1)  radius = 0.99  mirror = 0.98  color = (0.8, 0.1, 0.1)  ambient = 0.1 }
sphere { center = (-1, -1, 1)  radius = 0.99  mirror = 0.98  color = (0.1, 0.8, 0.1)  ambient = 0.1 }
sphere { center = (-1, 1, -1)  radius = 0.99  mirror = 0.98  color = (0.1, 0.1, 0.8)  ambient = 0.1 }
sphere { center = (1, -1, -1)  radius = 0.99  mirror = 0.98  color = (0.8, 0.8, 0.1)  ambient = 0.1 }
sphere { center = (0, 0, 0)  radius = 2.5  color = (1, 1, 1)  mirror = 0.9  ambient = 0.3 }
)"),
                     "epsilon"));
}

TEST(CheckPicture, EpsilonsOfTheSources) {
    for (const char* offset : {"ray", "normal", "facing", "direction"})
        EXPECT_EQ(ids_of(k_clean + "conventions { epsilon = 0.001  offset = " + offset + " }\n"), "")
            << offset;
}

const std::string k_mirrors =
    R"(camera { position = (1.1, 1.75, 3.1)  look_at = (-0.25, 1.15, -3)  fov_x = 62 }
light { type = ambient  intensity = 0.3 }
light { position = (0, 3.6, 0)  intensity = 0.7 }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.4, 0.3, 0.2)  ambient = 1 }
plane { point = (0, 0, -4)  normal = (0, 0, 1)  mirror = 0.95  color = (0.2, 0.3, 0.2)  ambient = 1 }
plane { point = (0, 0, 4)  normal = (0, 0, -1)  mirror = 0.95  color = (0.2, 0.3, 0.2)  ambient = 1 }
sphere { center = (-0.5, 0.6, -1.2)  radius = 0.6  color = (0.8, 0.3, 0.2)  ambient = 1 }
)";

TEST(CheckPicture, MirrorsPastTheLimit) {
    EXPECT_EQ(ids_of(k_mirrors + "render {\n  reflections = 2 }\n"), "reflections-too-few@9");
    EXPECT_EQ(ids_of(k_mirrors + "render {\n  reflections = 0 }\n"),
              "shape-outside-view@6 reflections-too-few@9");
    const std::string message = only_message(k_mirrors + "render {\n  reflections = 2 }\n");
    EXPECT_TRUE(has(message, "one reflection more than 2 changes")) << message;
    EXPECT_EQ(ids_of(k_mirrors + "render { reflections = 60 }\n"), "");
}

TEST(CheckPicture, GlassNeedsTwoReflections) {
    const auto with = [](int reflections, const std::string& rest) {
        return k_clean + fmt::format("render {{ reflections = {} }}\n", reflections) + rest;
    };
    // It has no light of its own: one reflection more changes nothing.
    const std::string ball =
        "sphere { center = (0.3, 1, 2)  radius = 0.8  color = (0, 0, 0)  transmission = 0.9  ior = 1.5 }\n";
    EXPECT_EQ(ids_of(with(0, ball)), "reflections-too-few@7");
    const std::string message = only_message(with(0, ball));
    EXPECT_TRUE(has(message, "2 reflections more than 0 change")) << message;
    EXPECT_TRUE(has(message, "set reflections to 2")) << message;
    EXPECT_EQ(ids_of(with(1, ball)), "reflections-too-few@7");
    EXPECT_EQ(ids_of(with(2, ball)), "");
    const std::string bubble =
        "sphere { center = (0.3, 1, 2)  radius = 0.7  color = (0, 0, 0)  transmission = 0.9  ior = 0.667 }\n";
    EXPECT_TRUE(has(ids_of(with(0, ball + bubble)), "reflections-too-few@7"));
    // A pane is one surface.
    EXPECT_EQ(ids_of(with(1,
                          "disc { center = (0.3, 1, 2)  normal = (0, 0, 1)  radius = 0.8  color = (0, 0, 0)  "
                          "transmission = 0.9 }\n")),
              "");
}

TEST(CheckPicture, OneMirrorNeedsOneReflection) {
    EXPECT_EQ(
        ids_of(
            k_clean +
            "render { reflections = 1 }\nplane { point = (0, 0, -4)  normal = (0, 0, 1)  mirror = 0.8 }\n"),
        "");
}

TEST(CheckPicture, AmbientLightThatIsTooStrong) {
    const auto scene = [](std::string_view intensity, std::string_view ambient, std::string_view diffuse) {
        return fmt::format(
            "camera {{ position = (0, 2, 8)  look_at = (0, 0.5, 0)  fov_x = 50 }}\n"
            "light {{ type = ambient  intensity = {0} }}\n"
            "light {{ position = (3, 6, 5)  intensity = 0.6 }}\n"
            "plane {{ point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.4, 0.4, 0.4)  ambient = {1}  "
            "diffuse = {2} }}\n"
            "sphere {{ center = (0, 1, 0)  radius = 1  color = (0.5, 0.3, 0.2)  ambient = {1}  diffuse = "
            "{2} }}\n",
            intensity, ambient, diffuse);
    };
    EXPECT_EQ(ids_of(scene("1", "0.9", "0.7")), "ambient-too-strong@2");
    EXPECT_TRUE(
        has(only_message(scene("1", "0.9", "0.7")), "is 0.9 times its color, and a light adds only 0.42"))
        << only_message(scene("1", "0.9", "0.7"));
    EXPECT_EQ(ids_of(scene("1", "0.3", "0.7")), "");
    EXPECT_EQ(ids_of(scene("0.3", "0.9", "0.7")), "");
    // A drawing that is flat on purpose: its terms come to 1.
    EXPECT_EQ(ids_of(scene("1", "0.8", "0.3")), "");
}

TEST(CheckPicture, NoLightButAmbientLight) {
    const auto lit = [](const std::string& rest) {
        return "camera { position = (0, 2, 8)  look_at = (0, 0.5, 0)  fov_x = 50 }\n"
               "light { type = ambient  intensity = 0.8 }\n" +
               rest;
    };
    const auto ball = [](const std::string& rest) {
        return "sphere { center = (0, 1, 0)  radius = 1  color = (0.8, 0.3, 0.2)  ambient = 1  " + rest +
               " }\n";
    };
    const std::string floor = "plane { point = (0, 0, 0)  normal = (0, 1, 0)  ambient = 1 }\n";
    EXPECT_EQ(ids_of(lit(ball("") + floor)), "light-only-ambient@2");
    // Nothing to be lit, another light, and light from all directions.
    EXPECT_EQ(ids_of(lit(ball("diffuse = 0") + floor)), "");
    EXPECT_EQ(ids_of(lit(ball("") + floor + "light { position = (3, 6, 5)  intensity = 0.2 }\n")), "");
    EXPECT_EQ(ids_of(lit(ball("") + floor + "occlusion { samples = 16  color = (0.2, 0.2, 0.2) }\n")), "");
    EXPECT_EQ(ids_of(lit(ball("") + floor + "render { shading = color }\n")), "");
    // A lamp glows; and a drawing is flat.
    EXPECT_EQ(
        ids_of(lit(ball("") + "box { min = (1.5, 0, 0)  max = (2, 1, 1)  ambient = 1  emission = 1 }\n")),
        "");
    EXPECT_EQ(ids_of(lit("disc { center = (0, 1, 0)  normal = (0, 0, 1)  radius = 1  ambient = 1 }\n"
                         "disc { center = (1, 1, 0.1)  normal = (0, 0, 1)  radius = 0.4  color = (0.8, 0.3, "
                         "0.2)  ambient = 1 }\n")),
              "");
    // By the format, which has the ambient light.
    EXPECT_TRUE(has(ids_of("camera { location <0, 1, 8> up <0, 1, 0> right <1.33, 0, 0> look_at <0, 1, 0> }\n"
                           "sphere { <0, 1, 0>, 1 pigment { color rgb <0.8, 0.3, 0.2> } finish { ambient 0.5 "
                           "diffuse 0.7 } }\n",
                           "a.pov"),
                    "light-only-ambient@0"));
}

TEST(CheckPicture, OcclusionWithoutReach) {
    const auto occlusion = [](std::string_view rest) {
        return k_clean + fmt::format("occlusion {{ samples = 32  color = (0.3, 0.3, 0.3)  {} }}\n", rest);
    };
    EXPECT_EQ(ids_of(occlusion("reach = 0.000001")), "occlusion-reach-too-short@7");
    EXPECT_EQ(ids_of(occlusion("reach = 0.3")), "");
    EXPECT_EQ(ids_of(occlusion("")), "");
    // There is nothing that could be within reach.
    EXPECT_EQ(
        ids_of("camera { position = (0, 0, 8)  look_at = (0, 0, 0) }\n"
               "light { position = (3, 4, 8)  intensity = 0.6 }\nsphere { center = (0, 0, 0)  radius = 1 }\n"
               "occlusion { samples = 32  color = (0.3, 0.3, 0.3)  reach = 0.000001 }\n"),
        "");
}

TEST(CheckPicture, ShapesInTheColorOfTheBackground) {
    const std::string base =
        "background = (0.5, 0.6, 0.8)\ncamera { position = (0, 1, 8)  look_at = (0, 1, 0)  fov_x = 50 }\n"
        "light { type = ambient  intensity = 1 }\nlight { position = (3, 6, 5)  intensity = 0.4 }\n"
        "sphere { center = (-1.5, 1, 0)  radius = 1  color = (0.8, 0.3, 0.2)  ambient = 0.3  diffuse = 0.9 "
        "}\n";
    const std::string ghost =
        "box { min = (0.5, 0, -0.5)  max = (1.5, 1, 0.5)  color = (0.5, 0.6, 0.8)  ambient = 1  diffuse = ";
    EXPECT_EQ(ids_of(base + ghost + "0 }\n"), "shape-looks-like-background@6");
    EXPECT_TRUE(
        has(only_message(base + ghost + "0 }\n"), "box 2 (line 6) cannot be told from the background"))
        << only_message(base + ghost + "0 }\n");
    // Visible by its shading alone; then by strong shading; then by another color.
    EXPECT_TRUE(has(only_message(base + ghost + "0.5 }\n"),
                    "box 2 (line 6) has the color of the background, and only the shading shows where it is"))
        << only_message(base + ghost + "0.5 }\n");
    EXPECT_FALSE(has(ids_of(base + ghost + "2 }\n"), "looks-like-background"));
    EXPECT_EQ(ids_of(base + ghost + "0.5  diffuse_color = (0.8, 0.3, 0.2) }\n"), "");
    EXPECT_EQ(ids_of("render { shading = color }  " + base.substr(0, base.find("light")) + ghost +
                     "0.5 }\nsphere { center = (-1.5, 1, 0)  radius = 1 }\n"),
              "shape-looks-like-background@3");
    // Distant shapes in fog.
    EXPECT_EQ(ids_of(base + "sphere { center = (2, 1, -60)  radius = 6  color = (0.8, 0.3, 0.2) }\n"
                            "fog { type = exp2  density = 0.06  color = (0.5, 0.6, 0.8) }\n"),
              "");
    // In front of a wall of another color it is seen.
    EXPECT_EQ(ids_of(base + ghost +
                     "0 }\nplane { point = (0, 0, -3)  normal = (0, 0, 1)  color = (0.3, 0.5, 0.3) }\n"),
              "");
    // White in light that is too strong, before white; and in light that is not.
    const auto on_white = [](const std::string& light) {
        return "background = (1, 1, 1)\ncamera { position = (0, 0, 8)  look_at = (0, 0, 0)  fov_x = 50 }\n" +
               light +
               "disc { center = (-1.5, 0, 0)  normal = (0, 0, 1)  radius = 1  color = (0.8, 0.3, 0.3) }\n"
               "disc { center = (1.5, 0, 0)  normal = (0, 0, 1)  radius = 1  color = (1, 1, 1)  ambient = 0 "
               "}\n";
    };
    const std::string strong = "light { type = directional  direction = (0, 0, 1)  intensity = 2.2 }\n";
    EXPECT_TRUE(has(ids_of(on_white(strong)), "shape-looks-like-background@5")) << ids_of(on_white(strong));
    const std::string gentle = "light { type = directional  direction = (0, 0, 1)  intensity = 0.9 }\n";
    EXPECT_EQ(ids_of(on_white(gentle)), "");
    // Black on black; but a moon that is only not lit has its color.
    const std::string night =
        "camera { position = (0, 0, 8)  look_at = (0, 0, 0)  fov_x = 50 }\n"
        "light { type = directional  direction = (0, 0, -1)  intensity = 0.8 }\n"
        "sphere { center = (-1.5, 0, 0)  radius = 1  color = (0.8, 0.8, 0.8) }\n"
        "disc { center = (1.5, 1, 0)  normal = (0, 0.2, -1)  radius = 1  color = (0.8, 0.8, 0.8)  ambient = "
        "0 }\n";
    EXPECT_FALSE(has(ids_of(night), "looks-like-background")) << ids_of(night);
    EXPECT_EQ(ids_of(base.substr(base.find('\n') + 1) +
                     "sphere { center = (1.5, 1, 0)  radius = 0.7  color = (0, 0, 0) }\n"),
              "shape-looks-like-background@5");
}

TEST(CheckPicture, AmbientLightThatMakesAllWhite) {
    std::string text = k_clean;
    const std::string_view old = "light { type = ambient  intensity = 0.2 }";
    text.replace(text.find(old), old.size(),
                 "background = (1, 1, 1)  light { type = ambient  intensity = 30 }");
    EXPECT_TRUE(has(ids_of(text), "picture-one-color")) << ids_of(text);
    EXPECT_TRUE(has(ids_of(text), "ambient-too-strong@2")) << ids_of(text);
}

}  // namespace
}  // namespace glint::test
