// SPDX-License-Identifier: Apache-2.0
// Mistakes of lights, planted, and what is none.
#include <fstream>
#include <iterator>

#include "check/check_text.h"

namespace glint::test {
namespace {

TEST(CheckLights, InsideAClosedShape) {
    const std::string text = k_clean + "light \"lost\" { position = (-1.5, 1, 0.2)  intensity = 0.5 }\n";
    EXPECT_EQ(ids_of(text), "light-inside-shape@7");
    EXPECT_TRUE(has(only_message(text), "light 'lost' is inside sphere 'left' (line 5)"))
        << only_message(text);
}

// A torus that the check's ray leaves, enters again and leaves: no convex shape.
TEST(CheckLights, InsideATorus) {
    const auto with = [](const char* place) {
        return ids_of(
            k_clean +
            "torus { center = (0, 1.6, 2)  axis = (0.7, -0.6211, 0.2)  radius = 0.6  tube = 0.2 }\n" +
            "light { position = " + place + "  intensity = 0.5 }\n");
    };
    // (0.6211, 0.7, 0) is at right angles to the axis.
    EXPECT_TRUE(has(with("(0.398, 2.049, 2)"), "light-inside-shape@8"));
    EXPECT_TRUE(has(with("(-0.398, 1.151, 2)"), "light-inside-shape@8"));
    EXPECT_FALSE(has(with("(0, 1.6, 2)"), "light-inside-shape")) << "in the hole";
}

TEST(CheckLights, NotInsideALampOfGlassOrWithoutShadows) {
    const std::string lamp =
        "sphere { center = (-2, 3, 1)  radius = 0.3  transmission = 0.9  ior = 1.5 }\n"
        "light { position = (-2, 3, 1)  intensity = 0.4 }\n";
    EXPECT_EQ(ids_of(k_clean + "conventions { glass_shadow = none }\n" + lamp), "");
    EXPECT_EQ(ids_of(k_clean + "render { shadows = false }\n" + lamp), "");
}

TEST(CheckLights, InsideATransparentLamp) {
    const std::string lamp =
        "sphere { center = (-2, 3, 1)  radius = 0.3  diffuse = 0  specular = 0  transmit = 0.9 }\n"
        "light { position = (-2, 3, 1)  intensity = 0.4 }\n";
    EXPECT_EQ(ids_of(k_clean + lamp), "");
    EXPECT_EQ(ids_of(k_clean + "conventions { transparent_shadow = none }\n" + lamp), "");
    EXPECT_TRUE(
        has(ids_of(k_clean + "conventions { transparent_shadow = opaque }\n" + lamp), "light-inside-shape"));
}

TEST(CheckLights, BehindAnOpaquePlane) {
    const std::string text = k_clean + "light { position = (0, -3, 4)  intensity = 0.5 }\n";
    EXPECT_EQ(ids_of(text), "light-behind-plane@7");
    EXPECT_TRUE(has(only_message(text), "plane 1 (line 4)")) << only_message(text);
}

// The balls touch the floor, and shadow rays start 0.001 off it: a few pixels get the light.
TEST(CheckLights, BelowTheFloorOfTheBook) {
    std::ifstream file(GLINT_SOURCE_DIR "/scenes/cgfs/three_spheres.cgfs");
    const std::string book{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    EXPECT_EQ(ids_of(book, "book.cgfs"), "");
    const std::pair<const char*, const char*> lights[] = {{"(0, -3, 3)", "light-blocked@34"},
                                                          {"(2, -2, 0)", "light-inside-shape@34"},
                                                          {"(2, 0, 4)", "light-inside-shape@34"},
                                                          {"(0, -1, 3)", "light-inside-shape@34"}};
    for (const auto& [place, expected] : lights) {
        const std::string text =
            book + fmt::format("light {{ type = point  intensity = 0.4  position = {} }}\n", place);
        EXPECT_EQ(ids_of(text, "book.cgfs"), expected) << place;
    }
}

TEST(CheckLights, OnASurface) {
    const auto lamp = [](const char* place) {
        return k_clean + "light { position = " + place + "  intensity = 0.4 }\n";
    };
    EXPECT_EQ(ids_of(lamp("(0.2, 0, 3)")), "light-on-surface@7");
    EXPECT_EQ(ids_of(lamp("(0.7, 1, 0.2)")), "light-on-surface@7");
    EXPECT_EQ(ids_of(lamp("(-1.5, 2.0000004, 0)")), "light-on-surface@7");
    EXPECT_TRUE(has(only_message(lamp("(-1.5, 2, 0)")), "light 3 is on sphere 'left' (line 5)"))
        << only_message(lamp("(-1.5, 2, 0)"));
    EXPECT_EQ(ids_of(k_clean + "light { type = spot  position = (0.2, 0, 3)  target = (0, 1, 0)  "
                               "outer_angle = 40  intensity = 0.4 }\n"),
              "light-on-surface@7");
    // Near it, or without shadows, or on a lamp.
    EXPECT_EQ(ids_of(lamp("(0.2, 0.001, 3)")), "");
    EXPECT_EQ(ids_of(lamp("(0.7, 1.00001, 0.2)")), "");
    EXPECT_EQ(ids_of("render { shadows = false }\n" + lamp("(0.2, 0, 3)")), "");
    for (const char* const shape : {"sphere { center = (-2, 3, 1)  radius = 0.3  casts_shadow = false }\n",
                                    "disc { center = (-2, 3.3, 1)  normal = (0, 1, 0)  radius = 0.3 }\n"})
        EXPECT_FALSE(has(ids_of(lamp("(-2, 3.3, 1)") + shape), "light-")) << shape;
}

TEST(CheckLights, BehindEverything) {
    // Nothing that is seen faces it.
    EXPECT_EQ(ids_of(R"(camera { position = (0, 0, 8)  look_at = (0, 0, 0)  fov_x = 20 }
light { position = (2, 3, 8)  intensity = 0.7 }
light { position = (0, 0, -9)  intensity = 0.7 }
light { type = directional  to_light = (0, 0, -1)  intensity = 0.7 }
sphere { center = (0, 0, 0)  radius = 1 }
disc { center = (0, 0, -2)  normal = (0, 0, 1)  radius = 2  color = (0.2, 0.4, 0.2) }
)"),
              "light-behind-everything@3 light-behind-everything@4");
}

// It reaches a few pixels of the ball's edge.
TEST(CheckLights, BehindEverythingButAnEdge) {
    const auto lit = [](const char* place, const char* more = "") {
        return ids_of(
            fmt::format("render {{ size = 320 x 240 }} camera {{ position = (0, 0, 8)  look_at = (0, 0, "
                        "0)  fov_x = 20 }}\n"
                        "light {{ position = (2, 3, 8)  intensity = 0.7 }}\n"
                        "light {{ position = {}  intensity = 0.7 }}\n"
                        "sphere {{ center = (0, 0, 0)  radius = 1 }}\n{}",
                        place, more));
    };
    EXPECT_EQ(lit("(2.4807, 0, -8.6514)"), "light-behind-everything@3");
    EXPECT_EQ(lit("(3.0782, 0, -8.4572)"), "") << "a rim";
    // A moon of a few pixels is lit.
    EXPECT_EQ(lit("(2.4807, 0, -8.6514)", "sphere { center = (2.8, 0.5, -11)  radius = 0.04 }\n"), "");
}

TEST(CheckLights, SpotAimedElsewhere) {
    const std::string spot =
        "light \"stage\" { type = spot  position = (3, 6, 5)  intensity = 0.6  outer_angle = ";
    const std::string text = k_clean + spot + "30  axis = (0, 1, 0) }\n";
    EXPECT_EQ(ids_of(text), "spot-aimed-elsewhere@7");
    EXPECT_TRUE(has(only_message(text), "is within 30 degrees of its axis")) << only_message(text);
    EXPECT_EQ(ids_of(k_clean + spot + "30  target = (0, 0, 0) }\n"), "");
    EXPECT_EQ(ids_of(k_clean + spot + "180  axis = (0, 1, 0) }\n"), "");
}

TEST(CheckLights, ALightWithoutShadowsIsNotBlocked) {
    const std::string end = "intensity = 0.2  casts_shadows = false }\n";
    EXPECT_EQ(ids_of(k_clean + "light { position = (-1.5, 1, 0.2)  " + end), "") << "inside a ball";
    EXPECT_EQ(ids_of(k_clean + "light { position = (0, -3, 4)  " + end), "") << "below the floor";
}

TEST(CheckLights, AreaLightThatFacesAway) {
    const std::string panel =
        "light \"lamp\" { type = parallelogram  position = (3, 6, 5)  intensity = 0.6  samples_u = 2  "
        "samples_v = 2  "
        "one_sided = true  ";
    EXPECT_EQ(ids_of(k_clean + panel + "side_u = (0, 0, 1)  side_v = (1, 0, 0) }\n"),
              "area-light-faces-away@7");
    EXPECT_EQ(ids_of(k_clean + panel + "side_u = (1, 0, 0)  side_v = (0, 0, 1) }\n"), "");
}

TEST(CheckLights, AreaLightWithInvisibleSamples) {
    const std::string panel =
        "light \"lamp\" { type = sphere  position = (3, 6, 5)  intensity = 0.6  samples_u = 8  samples_v = 8 "
        " radius = ";
    const std::string text = k_clean + panel + "0.0001 }\n";
    EXPECT_EQ(ids_of(text), "area-light-too-many-samples@7");
    EXPECT_TRUE(has(only_message(text), "has 8 x 8 samples")) << only_message(text);
    EXPECT_EQ(ids_of(k_clean + panel + "1.5 }\n"), "");
}

TEST(CheckLights, AreaLightWithOneSample) {
    const auto lamp = [](std::string_view rest, std::string_view render = "") {
        return k_clean + fmt::format(
                             "render {{ {} }}\nlight {{ type = sphere  position = (-3, 5, 5)  intensity = "
                             "0.4  {} }}\n",
                             render, rest);
    };
    const std::string one = "radius = 0.8  samples_u = 1  samples_v = 1";
    EXPECT_EQ(ids_of(lamp(one)), "area-light-one-sample@8");
    EXPECT_TRUE(has(only_message(lamp(one)), "all its light comes from one point"))
        << only_message(lamp(one));
    EXPECT_EQ(ids_of(lamp(one + "  jitter = true")), "area-light-one-sample@8");
    EXPECT_TRUE(has(only_message(lamp(one + "  jitter = true")), "its shadows are noise"));
    // Several samples of a pixel, a light as small as a point, and no shadows.
    EXPECT_EQ(ids_of(lamp(one + "  jitter = true", "aa = 3")), "");
    EXPECT_EQ(ids_of(lamp("radius = 0.001  samples_u = 1  samples_v = 1")), "");
    EXPECT_EQ(ids_of(lamp(one + "  casts_shadows = false")), "");
    EXPECT_EQ(ids_of(lamp("radius = 0.8  samples_u = 2  samples_v = 4")), "");
}

TEST(CheckLights, BlockedByAShape) {
    const std::string text = R"(camera { position = (0, 4, 8)  look_at = (0, 0, 0)  fov_x = 30 }
light { position = (3, 6, 8)  intensity = 0.7 }
light "hidden" { position = (0, 30, 0)  intensity = 0.3 }
disc { center = (0, 0, 0)  normal = (0, 1, 0)  radius = 2 }
box "shade" { min = (-4, 20, -4)  max = (4, 21, 4) }
)";
    EXPECT_EQ(ids_of(text), "light-blocked@3");
    EXPECT_TRUE(has(only_message(text), "box 'shade' (line 5)")) << only_message(text);
}

// The remedy is tried: a sun has no place that it could be moved from.
TEST(CheckLights, ReversedDirections) {
    const std::string sun = R"(camera { position = (0, 2, 8)  look_at = (0, 1, 0)  fov_x = 50 }
light { type = ambient  intensity = 0.3 }
light { type = directional  direction = (1, -2, 1)  intensity = 0.7 }
sphere { center = (0, 1, 0)  radius = 1 }
)";
    for (const char* floor : {"plane { point = (0, 0, 0)  normal = (0, 1, 0) }\n",
                              "box { min = (-9, -1, -9)  max = (9, 0, 9) }\n"}) {
        const std::string message = only_message(sun + floor);
        EXPECT_TRUE(has(message, "remedy: negate the direction")) << message;
        EXPECT_TRUE(has(message, "write (-1, 2, -1)")) << message;
    }
}

TEST(CheckLights, ThatTheOcclusionLeavesOut) {
    const std::string message = only_message(k_clean + "occlusion { samples = 16  direct = 0 }\n");
    EXPECT_TRUE(has(message, "[light-adds-nothing]")) << message;
    EXPECT_TRUE(has(message, "`direct` of the occlusion is 0")) << message;
}

TEST(CheckLights, BlockedByWhatItLiesIn) {
    // By the lecture's rule a surface through the light itself is before it.
    const std::string lamp = "disc \"lamp\" { center = (3, 6, 5)  normal = (-3, 4, 3)  radius = 0.5 }\n";
    EXPECT_FALSE(has(ids_of(k_clean + lamp), "light-"));
    EXPECT_TRUE(has(ids_of("profile = lecture5\n" + k_clean + lamp), "light-blocked@4"));
}

TEST(CheckLights, TheShapeIsNamedThatIsInTheWay) {
    // The sky holds the lamp and the camera alike.
    const std::string sky =
        "sphere \"sky\" { center = (0, 0, 0)  radius = 50  color = (0.4, 0.5, 0.9)  diffuse = 0 }\n";
    const std::string below = k_clean + sky + "light { position = (0, -3, 4)  intensity = 0.5 }\n";
    EXPECT_EQ(ids_of(below), "light-behind-plane@8");
    EXPECT_TRUE(has(only_message(below), "plane 1 (line 4) is between")) << only_message(below);
    // A pane that casts no shadow is not in the way, and nothing is without shadows.
    const std::string pane =
        "disc { center = (0, -2, 4)  normal = (0, 1, 0)  radius = 9  transmission = 0.9 }\n"
        "conventions { glass_shadow = none }\n";
    EXPECT_TRUE(has(ids_of(k_clean + "light { position = (0, -3, 4)  intensity = 0.5 }\n" + pane),
                    "light-behind-plane@7"));
    EXPECT_EQ(ids_of(R"(render { shadows = false }
camera { position = (0, 4, 8)  look_at = (0, 0, 0)  fov_x = 30 }
light { position = (3, 6, 8)  intensity = 0.7 }
light { position = (0, 30, 0)  color = (0, 0, 0.5) }
disc { center = (0, 0, 0)  normal = (0, 1, 0)  radius = 2  color = (0.8, 0.8, 0) }
box { min = (-4, 20, -4)  max = (4, 21, 4) }
)"),
              "light-adds-nothing@4 shape-outside-view@6");
}

TEST(CheckLights, BlockedByWhatIsBeyondIt) {
    const std::string enclosure = R"(camera { position = (0, 2, 8)  look_at = (0, 0.5, 0)  fov_x = 50 }
light { type = ambient  intensity = 0.2 }
light { position = (3, 6, 5)  intensity = 0.6 }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  ambient = 1 }
plane "ceiling" { point = (0, 9, 0)  normal = (0, -1, 0)  ambient = 1 }
sphere { center = (-1.5, 1, 0)  radius = 1  ambient = 1 }
)";
    EXPECT_EQ(ids_of(enclosure), "");
    const std::string past = enclosure + "conventions { shadow_stops_at_light = false }\n";
    EXPECT_TRUE(has(ids_of(past), "light-blocked@3")) << ids_of(past);
    std::string message;
    for (const Finding& f : check_text(past))
        if (f.id == "light-blocked") message = to_string(f);
    EXPECT_TRUE(has(message, "plane 'ceiling' (line 5) is beyond it")) << message;
    EXPECT_TRUE(has(message, "remedy: set shadow_stops_at_light = true")) << message;
}

TEST(CheckLights, ARimLightIsNoMistake) {
    // From behind, but its rim is seen; and a small highlight in a scene without diffuse surfaces.
    EXPECT_EQ(ids_of(k_clean + "light { position = (-3, 4, -6)  intensity = 0.4 }\n"), "");
    EXPECT_EQ(ids_of(R"(camera { position = (0, 0, 8)  look_at = (0, 0, 0) }
light { type = ambient  intensity = 0.4 }
light { position = (4, 5, 6)  intensity = 0.9 }
sphere { center = (0, 0, 0)  radius = 1  ambient = 1  diffuse = 0  specular_color = (1, 1, 1)  shininess = 5000 }
)"),
              "");
}

TEST(CheckLights, WithoutColorOrEffect) {
    EXPECT_EQ(ids_of(k_clean + "light { position = (0, 5, 5)  intensity = 0 }\n"), "light-without-color@7");
    EXPECT_EQ(ids_of(k_clean + "light { type = ambient  intensity = 0 }\n"), "light-without-color@7");
    EXPECT_EQ(ids_of(k_clean + "light { position = (0, 5, 5)  attenuation = (0, 0, 9000) }\n"),
              "light-too-weak@7");
    // No material reflects what the light has.
    EXPECT_EQ(ids_of(R"(camera { position = (0, 0, 8)  look_at = (0, 0, 0) }
light { position = (4, 5, 6)  color = (0, 0.8, 0) }
light { position = (4, 5, 6)  color = (0, 0, 0.8) }
light { type = ambient  intensity = 0.4 }
sphere { center = (0, 0, 0)  radius = 1  color = (1, 1, 0)  ambient = 0  diffuse = 0.8 }
)"),
              "light-adds-nothing@3 light-adds-nothing@4");
}

TEST(CheckLights, ThatTakeLightAway) {
    EXPECT_TRUE(
        has(ids_of(k_clean + "light { position = (0, 5, 5)  intensity = -0.1 }\n"), "light-negative@7"));
}

// A direction that is too long makes the picture white: there is nothing else to be said of it.
TEST(CheckLights, DirectionsThatAreTooLong) {
    EXPECT_EQ(
        ids_of("conventions { normalize = false }\ncamera { position = (0, 1.5, 6)  look_at = (0, 1, 0) }\n"
               "light { type = directional  to_light = (3, 5, 5)  intensity = 0.8 }\n"
               "sphere { center = (0, 1, 0)  radius = 1  color = (0.8, 0.2, 0.1) }\n"
               "plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.5, 0.5, 0.5) }\n"),
        "direction-not-unit@3");
}

TEST(CheckLights, ColorsAsBytes) {
    EXPECT_TRUE(has(ids_of(k_clean + "light { position = (0, 5, 5)  color = (255, 250, 240) }\n"),
                    "light-color-255@7"));
    // Strong, for what its distance takes from it.
    EXPECT_EQ(ids_of(k_clean + "light { position = (0, 5, 5)  intensity = 12  attenuation = (0, 0, 1) }\n"),
              "");
}

TEST(CheckLights, NotWhereNothingIsLit) {
    EXPECT_EQ(ids_of(k_clean + "render { shading = normals }\nlight { position = (0, -3, 4) }\n"), "");
}

std::string with_lights(int count, const std::string& rest) {
    std::string text = k_clean;
    for (int i = 0; i < count; ++i)
        text += fmt::format("light {{ position = ({}, 6, 4)  {} }}\n", i * 12.0 / count - 6, rest);
    return text;
}

TEST(CheckLights, WeakLightsAreJudgedTogether) {
    EXPECT_EQ(ids_of(with_lights(40, "intensity = 0.001")), "");
    EXPECT_EQ(ids_of(with_lights(600, "intensity = 0.001")), "");
    const std::string weak = with_lights(40, "intensity = 0.000001");
    EXPECT_EQ(ids_of(weak), "light-too-weak@7");
    EXPECT_TRUE(has(only_message(weak), "40 lights (light 3, ")) << only_message(weak);
    // Two and three are drawn together; one is with the lamp.
    EXPECT_EQ(ids_of(with_lights(600, "intensity = 1e-8")), "light-too-weak@8");
}

TEST(CheckLights, ManyMistakesOfOneKindAreOneFinding) {
    const std::string black = with_lights(300, "intensity = 0");
    EXPECT_EQ(ids_of(black), "light-without-color@7");
    EXPECT_TRUE(has(only_message(black), "; and 299 more like it")) << only_message(black);
}

TEST(CheckLights, ManyLightsEachOfThemLooked) {
    std::string text = k_clean;
    for (int i = 0; i < 60; ++i)
        text += fmt::format("light {{ position = ({}, 6, 4)  intensity = 0.01 }}\n", i * 0.2 - 6);
    text += "light { position = (0, -3, 4) }\n";
    EXPECT_EQ(ids_of(text), "light-behind-plane@67");
}

TEST(CheckLights, WrittenTwice) {
    const std::string again = k_clean + "light { intensity = 0.6  position = (3, 6, 5) }\n";
    EXPECT_EQ(ids_of(again), "light-written-twice@7");
    EXPECT_TRUE(has(only_message(again), "light 3 is equal to light 'lamp' (line 3)")) << only_message(again);
    EXPECT_EQ(ids_of(k_clean + "light { type = ambient  intensity = 0.2 }\n"), "light-written-twice@7");
    for (const std::string_view other :
         {"position = (3, 6, 5.1)  intensity = 0.3", "position = (3, 6, 5)  intensity = 0.3",
          "position = (3, 6, 5)  intensity = 0.6  attenuation = (1, 0.01, 0)",
          "type = directional  direction = (3, 6, 5)  intensity = 0.2"})
        EXPECT_FALSE(has(ids_of(k_clean + "light { " + std::string(other) + " }\n"), "written-twice"))
            << other;
}

TEST(CheckLights, WrittenThreeTimesIsOneFinding) {
    const std::string again = "light { position = (3, 6, 5)  intensity = 0.6 }\n";
    EXPECT_EQ(ids_of(k_clean + again + again), "light-written-twice@7");
    const std::string message = only_message(k_clean + again + again);
    EXPECT_TRUE(has(
        message,
        "light 3 and light 4 (line 8) are equal to light 'lamp' (line 3), also in place and color: the three "
        "are one light of three times the intensity"))
        << message;
    EXPECT_TRUE(has(only_message(k_clean + again + again + again + again + again),
                    "light 3, light 4 (line 8), light 5 (line 9) and 2 more are equal"))
        << only_message(k_clean + again + again + again + again + again);
    // Two pairs are two findings.
    const std::string other = "light { position = (-3, 6, 5)  intensity = 0.1 }\n";
    EXPECT_EQ(ids_of(k_clean + again + other + other), "light-written-twice@7 light-written-twice@9");
}

TEST(CheckLights, WrittenTwiceAndMovedByAHair) {
    const auto twin = [](std::string_view rest) {
        return ids_of(k_clean + fmt::format("light {{ intensity = 0.6  {} }}\n", rest));
    };
    EXPECT_EQ(twin("position = (3, 6, 5.001)"), "light-written-twice@7");
    const std::string message =
        only_message(k_clean + "light { intensity = 0.6  position = (3, 6, 5.001) }\n");
    EXPECT_TRUE(
        has(message, "light 3 is equal to light 'lamp' (line 3), and in almost the same place: the two"))
        << message;
    EXPECT_FALSE(has(twin("position = (3, 6, 5.02)"), "written-twice")) << "beside it";
    // Suns and spots differ in where they point.
    const auto pair = [](std::string_view first, std::string_view second) {
        return ids_of(
            k_clean +
            fmt::format("light {{ intensity = 0.2  {} }}\nlight {{ intensity = 0.2  {} }}\n", first, second));
    };
    EXPECT_EQ(
        pair("type = directional  to_light = (1, 2, 1)", "type = directional  to_light = (1, 2, 1.001)"),
        "light-written-twice@8");
    EXPECT_EQ(pair("type = directional  to_light = (1, 2, 1)", "type = directional  to_light = (1, 2, 1.02)"),
              "");
    const std::string spot = "type = spot  outer_angle = 40  target = (0, 0, 0)  position = ";
    EXPECT_EQ(pair(spot + "(2, 6, 5)", spot + "(2.001, 6, 5)"), "light-written-twice@8");
    EXPECT_EQ(
        pair(spot + "(2, 6, 5)", "type = spot  outer_angle = 40  target = (0.3, 0, 0)  position = (2, 6, 5)"),
        "");
}

// RT2's scenes have an ambient light that is not in the file.
TEST(CheckLights, AreNumberedAsInTheFile) {
    const auto lit = [](std::string_view lights) {
        return only_message(
            fmt::format(
                R"({{"camera": {{"position": [0, 2, 8], "target": [0, 1, 0], "up": [0, 1, 0], "fov": 50}},
"materials": [{{"name": "chalk", "color": [0.8, 0.8, 0.8], "ambient": 0.2, "diffuse": 0.7, "specular": 0, "shininess": 1}}],
"lights": [{{"position": [3, 6, 5], "color": [0.6, 0.6, 0.6]}},
           {}],
"spheres": [{{"center": [0, 1, 0], "radius": 1, "material": "chalk"}}], "planes": [], "cylinders": []}})",
                lights),
            "a.json");
    };
    std::string message = lit(R"({"position": [0, 1, 0], "color": [0.5, 0.5, 0.5]})");
    EXPECT_TRUE(has(message, "a.json:4") && has(message, "light 2 of the file is inside sphere 1"))
        << message;
    message = lit(R"({"position": [3, 6, 5], "color": [0.6, 0.6, 0.6]})");
    EXPECT_TRUE(has(message, "light 2 of the file is equal to light 1 of the file (line 3)")) << message;
}

TEST(CheckLights, SpotAnglesInRadians) {
    const auto spot = [](std::string_view target, std::string_view angles) {
        return k_clean +
               fmt::format(
                   "light {{ type = spot  position = (0, 6, 5)  target = {}  {}  intensity = 0.3 }}\n",
                   target, angles);
    };
    // Whether it hits something or not.
    for (const char* target : {"(0, 0.5, 0)", "(-1.5, 1, 0)"})
        EXPECT_EQ(ids_of(spot(target, "inner_angle = 0.3  outer_angle = 0.5")), "spot-angle-in-radians@7");
    const std::string message = only_message(spot("(-1.5, 1, 0)", "inner_angle = 0.3  outer_angle = 0.5"));
    EXPECT_TRUE(has(message, "0.5 radians are 28.6 degrees")) << message;
    EXPECT_EQ(ids_of(spot("(0, 0.5, 0)", "inner_angle = 3  outer_angle = 5")), "");
    // Narrow, but from so far away that it lights a ball.
    EXPECT_EQ(ids_of(k_clean +
                     "light { type = spot  position = (0, 60, 70)  target = (-1.5, 1, 0)  inner_angle = 0.5  "
                     "outer_angle = 0.7  intensity = 0.3 }\n"),
              "");
}

TEST(CheckLights, SpotsThatAreDots) {
    const auto spot = [](double tightness, std::string_view angle = "outer_angle = 40",
                         std::string_view place = "(0, 6, 5)") {
        return k_clean + fmt::format(
                             "light {{ type = spot  position = {}  target = (0, 0.5, 0)  "
                             "intensity = 0.3  tightness = {}  {} }}\n",
                             place, tightness, angle);
    };
    EXPECT_EQ(ids_of(spot(5000)), "spot-too-tight@7");
    EXPECT_TRUE(has(only_message(spot(5000)), "has the tightness 5000: its light is cos^5000, a dot of"))
        << only_message(spot(5000));
    EXPECT_EQ(ids_of(spot(1e8)), "spot-too-tight@7");
    EXPECT_EQ(ids_of(spot(100)), "");
    // From so far away that it lights a ball, and a beam that is narrow whatever the tightness.
    EXPECT_EQ(ids_of(spot(5000, "outer_angle = 40", "(0, 60, 70)")), "");
    EXPECT_EQ(ids_of(spot(5000, "inner_angle = 1  outer_angle = 3")), "");
}

TEST(CheckLights, AttenuatedAway) {
    const auto lamp = [](std::string_view rest) {
        std::string text = k_clean;
        const std::string_view old = "light \"lamp\" { position = (3, 6, 5)  intensity = 0.6 }";
        return text.replace(text.find(old), old.size(),
                            fmt::format("light \"lamp\" {{ position = (0, 8, 3)  {} }}", rest));
    };
    const std::string square = lamp("intensity = 1  attenuation = (0, 0, 1)");
    EXPECT_EQ(ids_of(square), "light-attenuated-away@3");
    EXPECT_TRUE(has(only_message(square), "it is 6.76 units away")) << only_message(square);
    EXPECT_TRUE(has(only_message(square), "raise the intensity about 46 times")) << only_message(square);
    EXPECT_EQ(ids_of(lamp("intensity = 40  attenuation = (0, 0, 1)")), "");
    EXPECT_EQ(ids_of(lamp("intensity = 1  attenuation = (1, 0.1, 0.01)")), "");
    // Dim, but not by attenuation.
    EXPECT_EQ(ids_of(lamp("intensity = 0.04  attenuation = (1, 0.01, 0)")), "");
    // The only shape in its light is so small that only a larger picture shows it.
    EXPECT_EQ(ids_of(k_clean + "light { position = (1.2, 1.86, 0.06)  attenuation = (0, 0, 20000) }\n"
                               "sphere { center = (1.2, 1.8, 0)  radius = 0.03 }\n"),
              "light-attenuated-away@7");
    // Each is faint; together they are not.
    EXPECT_EQ(ids_of(with_lights(30, "intensity = 0.5  attenuation = (0, 0, 1)")), "");
}

TEST(CheckLights, AroundAShape) {
    const auto ball = [](std::string_view rest) {
        return k_clean + fmt::format("light {{ type = sphere  intensity = 0.3  {} }}\n", rest);
    };
    EXPECT_EQ(ids_of(ball("position = (-1.5, 1, 0)  radius = 2")), "light-around-shape@7");
    EXPECT_EQ(ids_of(ball("position = (-1.5, 1, 0)  radius = 1.2")), "light-around-shape@7");
    EXPECT_EQ(ids_of(ball("position = (-1.5, 3.2, 1)  radius = 1")), "");
    // The bulb of a lamp.
    const std::string lamp = ball("position = (0, 3, 2)  radius = 0.3");
    EXPECT_EQ(
        ids_of(lamp + "sphere { center = (0, 3, 2)  radius = 0.25  emission = 1  casts_shadow = false }\n"),
        "");
}

}  // namespace
}  // namespace glint::test
