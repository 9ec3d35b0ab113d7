// SPDX-License-Identifier: Apache-2.0
// Shapes that nobody sees, and shapes in one place: planted, and what is no mistake.
#include "check/check_text.h"

namespace glint::test {
namespace {

TEST(CheckShapes, OutsideTheView) {
    const std::string text = k_clean + "sphere \"lost\" { center = (0, 1, 30)  radius = 0.5 }\n";
    EXPECT_EQ(ids_of(text), "shape-outside-view@7");
    EXPECT_TRUE(has(only_message(text), "1 of 4 shapes")) << only_message(text);
    EXPECT_TRUE(has(only_message(text), "sphere 'lost' (line 7)")) << only_message(text);
    EXPECT_EQ(ids_of(k_clean + "plane { point = (0, 0, 40)  normal = (0, 0, 1) }\n"), "shape-outside-view@7");
}

TEST(CheckShapes, SeenInAMirrorOrByItsShadowIsSeen) {
    EXPECT_EQ(ids_of(k_clean + "plane { point = (0, 0, -4)  normal = (0, 0, 1)  mirror = 0.8 }\n"
                               "sphere { center = (0, 1, 12)  radius = 2 }\n"),
              "");
    EXPECT_EQ(ids_of(k_clean + "sphere { center = (1.5, 5, 3)  radius = 0.4 }\n"), "");
}

TEST(CheckShapes, SeenByAShadowBehindClearGlass) {
    // The pane is nearer to the lamp, and lets its light through.
    const std::string ball = "sphere { center = (1.5, 5, 3)  radius = 0.4 }\n";
    EXPECT_EQ(ids_of("conventions { glass_shadow = none }\n" + k_clean + ball +
                     "disc \"pane\" { center = (2.25, 5.5, 4)  normal = (1.5, 1, 2)  radius = 0.9  "
                     "transmission = 0.9 }\n"),
              "shape-outside-view@9");
}

TEST(CheckShapes, SeenByAShadowFromBeyondTheLight) {
    // Over the lamp, whose shadow rays do not stop at it.
    const std::string over = "sphere { center = (3.6, 7.4, 6)  radius = 0.3 }\n";
    EXPECT_EQ(ids_of(k_clean + over), "shape-outside-view@7");
    EXPECT_EQ(ids_of(k_clean + "conventions { shadow_stops_at_light = false }\n" + over), "");
}

TEST(CheckShapes, NothingIsSaidOfShadowsOfLightsLeftOut) {
    std::string text = k_clean;
    for (int i = 0; i < 17; ++i)
        text += fmt::format("light {{ position = ({}, 6, 4)  intensity = 0.05 }}\n", i * 0.2 - 6);
    text += "sphere { center = (0, 1, 30)  radius = 0.5 }\n";
    EXPECT_EQ(ids_of(text), "shape-outside-view@24");
    EXPECT_FALSE(has(only_message(text), "shadow")) << only_message(text);
}

TEST(CheckShapes, HiddenBehindAndInside) {
    EXPECT_EQ(ids_of(k_clean + "sphere { center = (-1.9, 0.6, -1)  radius = 0.2 }\n"), "shape-hidden@7");
    const std::string inside = k_clean + "sphere { center = (-1.5, 1, 0)  radius = 0.5 }\n";
    EXPECT_EQ(ids_of(inside), "shape-hidden@7");
    EXPECT_TRUE(has(only_message(inside), "inside sphere 'left' (line 5)")) << only_message(inside);
    EXPECT_EQ(ids_of(k_clean + "plane { point = (0, -1, 0)  normal = (0, 1, 0) }\n"), "shape-hidden@7");
}

TEST(CheckShapes, SmallerThanAPixel) {
    EXPECT_EQ(ids_of(k_clean + "sphere { center = (0, 2.5, 0)  radius = 0.0005 }\n"), "shape-too-small@7");
}

TEST(CheckShapes, ManyAreOneFinding) {
    std::string text = k_clean;
    for (int i = 0; i < 20; ++i) text += fmt::format("sphere {{ center = ({}, 1, 30)  radius = 0.3 }}\n", i);
    const std::string message = only_message(text);
    EXPECT_TRUE(has(message, "20 of 23 shapes")) << message;
    EXPECT_TRUE(has(message, "sphere 4 (line 7), sphere 5 (line 8)")) << message;
    EXPECT_TRUE(has(message, "and 15 more")) << message;
}

TEST(CheckShapes, ABackOfAModelIsNoMistake) {
    // A wall of balls, ten deep: most are hidden behind the first rows, but the model is computed.
    std::string text = k_clean;
    for (int i = 0; i < 100; ++i)
        text += fmt::format("sphere {{ center = ({}, {}, {})  radius = 0.14 }}\n", 0.28 * (i % 5) - 0.5,
                            0.2 + 0.28 * (i / 5 % 4), -2 - 0.28 * (i / 20));
    EXPECT_FALSE(has(ids_of(text), "hidden")) << ids_of(text);
    EXPECT_EQ(ids_of(text + "sphere \"lost\" { center = (0, 1, 30)  radius = 0.5 }\n"),
              "shape-outside-view@107");
}

TEST(CheckShapes, WrittenTwice) {
    EXPECT_EQ(ids_of(k_clean + "sphere { center = (-1.5, 1, 0)  radius = 1  color = (0, 1, 0) }\n"),
              "shape-written-twice@7");
    EXPECT_TRUE(
        has(ids_of(k_clean + "plane { point = (5, 0, 3)  normal = (0, 2, 0) }\n"), "shape-written-twice@7"));
    EXPECT_TRUE(has(
        ids_of(k_clean + "group { translate = (1, 1, 0)  sphere { center = (0, 0, 2)  radius = 0.5 } }\n"
                         "group { translate = (1, 1, 0)  sphere { center = (0, 0, 2)  radius = 0.5 } }\n"),
        "shape-written-twice@8"));
    const std::string torus = "torus { center = (0, 1, 2)  axis = (0, 1, 0)  radius = 0.5  tube = ";
    EXPECT_TRUE(has(ids_of(k_clean + torus + "0.1 }\n" + torus + "0.1 }\n"), "shape-written-twice@8"));
    EXPECT_FALSE(has(ids_of(k_clean + torus + "0.1 }\n" + torus + "0.2 }\n"), "shape-written-twice"));
    const std::string disc = "disc { center = (0, 1, 2)  normal = (0, 1, 1)  radius = 0.5  hole = ";
    EXPECT_TRUE(has(ids_of(k_clean + disc + "0.1 }\n" + disc + "0.1 }\n"), "shape-written-twice@8"));
    EXPECT_FALSE(has(ids_of(k_clean + disc + "0.1 }\n" + disc + "0.2 }\n"), "shape-written-twice"));
    // The same ball elsewhere.
    EXPECT_EQ(
        ids_of(k_clean + "group { translate = (1, 1, 0)  sphere { center = (0, 0, 2)  radius = 0.5 } }\n"
                         "group { translate = (-1, 1, 0)  sphere { center = (0, 0, 2)  radius = 0.5 } }\n"),
        "");
}

TEST(CheckFaces, CoplanarAndSeen) {
    const char* const k_planted[] = {
        // a disc, a polygon, a box's top, a triangle in the plane of the floor
        "disc { center = (0, 0, 2)  normal = (0, 1, 0)  radius = 1  color = (1, 0, 0) }\n",
        "polygon { vertices = ((-1, 0, 3), (1, 0, 3), (1, 0, 1), (-1, 0, 1))  color = (1, 0, 0) }\n",
        "box { min = (-1, -1, 1)  max = (1, 0, 3)  color = (1, 0, 0) }\n",
        "triangle { vertices = ((-1, 0, 3), (1, 0, 3), (0, 0, 1))  color = (1, 0, 0) }\n",
        // turned about the vertical: the same plane but for rounding
        "group { rotate = (0, 30, 0)  box { min = (-1, -1, 1)  max = (1, 0, 3)  color = (1, 0, 0) } }\n",
    };
    for (const char* shape : k_planted) EXPECT_EQ(ids_of(k_clean + shape), "faces-coincide@7") << shape;
    EXPECT_TRUE(has(only_message(k_clean + k_planted[0]), "plane 1 (line 4)"));
}

TEST(CheckFaces, SeenOnlyInAMirror) {
    // A mat behind the camera, flat on a wall there; the mirror at the back shows it.
    const std::string mirror =
        "plane { point = (0, 0, -6)  normal = (0, 0, 1)  color = (0.1, 0.1, 0.1)  diffuse = 0.3  mirror = "
        "0.8 }\n";
    const std::string wall =
        "box { min = (-4, 0, 12)  max = (4, 5, 13)  color = (0.6, 0.6, 0.4)  ambient = 1  diffuse = 0.6 }\n";
    const auto mat = [](double z) {
        return fmt::format(
            "disc {{ center = (2, 2, {})  normal = (0, 0, -1)  radius = 1  color = (1, 0, 0)  ambient = 1 "
            "}}\n",
            z);
    };
    EXPECT_EQ(ids_of(k_clean + mirror + wall + mat(11.9)), "");
    EXPECT_EQ(ids_of(k_clean + mirror + wall + mat(12)), "faces-coincide@9");
    // The same without mirrors: not visible, so only that is reported.
    EXPECT_FALSE(has(ids_of(k_clean + wall + mat(12)), "faces-coincide"));
    // A box that stands on a mirror: the bottom is not visible.
    EXPECT_EQ(
        ids_of(k_clean + "disc { center = (0, 0.001, 2)  normal = (0, 1, 0)  radius = 1.2  mirror = 0.6 }\n"
                         "box { min = (-0.2, 0.001, 1.8)  max = (0.2, 0.5, 2.2)  color = (1, 0, 0) }\n"),
        "");
}

TEST(CheckFaces, WithinEpsilonAlsoByOtherConventions) {
    const std::string mat =
        "disc { center = (0, 0.0005, 2)  normal = (0, 1, 0)  radius = 1  color = (1, 0, 0) }\n";
    EXPECT_EQ(ids_of(k_clean + mat), "");
    EXPECT_EQ(ids_of(k_clean + "conventions { offset = normal  epsilon = 0.001 }\n" + mat),
              "faces-coincide@8");
}

TEST(CheckFaces, NearMisses) {
    for (const char* shape : {
             // a mat on the floor, not in it
             "disc { center = (0, 0.01, 2)  normal = (0, 1, 0)  radius = 1  color = (1, 0, 0) }\n",
             // standing on the floor: the bottom is in its plane and not seen
             "cylinder { from = (-0.2, 0, 2)  to = (-0.2, 0.6, 2)  radius = 0.3  color = (1, 0, 0) }\n",
             // half in the floor
             "sphere { center = (0, 0, 2)  radius = 0.5  color = (1, 0, 0) }\n",
             // touching it in a point, and along a line
             "sphere { center = (0, 0.5, 2)  radius = 0.5  color = (1, 0, 0) }\n",
             "cylinder { from = (-1, 0.3, 2)  to = (1, 0.3, 2)  radius = 0.3  color = (1, 0, 0) }\n",
             // two walls of one material that overlap: nobody can tell
             "group { color = (0.3, 0.5, 0.3)  box { min = (-2, 0, -3)  max = (1, 2, -2) }\n"
             "        box { min = (0, 0, -3)  max = (3, 2, -2) } }\n",
             // two triangles of one square
             "triangle { vertices = ((-1, 0.5, 2), (1, 0.5, 2), (1, 2.5, 2))  color = (1, 0, 0) }\n"
             "triangle { vertices = ((-1, 0.5, 2), (1, 2.5, 2), (-1, 2.5, 2))  color = (0, 1, 0) }\n",
         }) {
        EXPECT_EQ(ids_of(k_clean + shape), "") << shape;
    }
}

TEST(CheckFaces, AnEdgeThatPixelsLieOnIsNoFace) {
    // The diagonal of the square runs through the middles of pixels.
    EXPECT_EQ(ids_of(R"(render { size = 64 x 64 }
camera { projection = orthographic  width = 4  position = (0, 0, 8)  look_at = (0, 0, 0) }
light { position = (3, 4, 8)  intensity = 0.7 }
triangle { vertices = ((-1, -1, 0), (1, -1, 0), (1, 1, 0))  color = (1, 0, 0) }
triangle { vertices = ((-1, -1, 0), (1, 1, 0), (-1, 1, 0))  color = (0, 1, 0) }
)"),
              "");
}

TEST(CheckShapes, WithoutAnArea) {
    for (const char* shape : {"triangle { vertices = ((0, 1, 2), (1, 2, 2), (2, 3, 2)) }\n",
                              "triangle { vertices = ((0.1, 0.1, 2), (0.2, 0.2, 2), (0.3, 0.3, 2)) }\n",
                              "triangle { vertices = ((0, 1, 2), (0, 1, 2), (0, 1, 2)) }\n",
                              "polygon { vertices = ((0, 1, 2), (1, 1, 2), (2, 1, 2), (3, 1, 2)) }\n",
                              "box { min = (0, 1, 2)  max = (0, 1, 3) }\n"})
        EXPECT_EQ(ids_of(k_clean + shape), "shape-without-area@7") << shape;
    // A narrow one, and a box that is a pane.
    EXPECT_EQ(ids_of(k_clean + "triangle { vertices = ((-2, 1, 2), (2, 1, 2), (2, 1.05, 2)) }\n"), "");
    EXPECT_EQ(ids_of(k_clean + "box { min = (0, 1, 2)  max = (1, 2, 2) }\n"), "");
}

TEST(CheckShapes, TooFlat) {
    const auto cylinder = [](std::string_view top, std::string_view radius) {
        return k_clean +
               fmt::format("cylinder {{ from = (0, 1, 2)  to = (0, {}, 2)  radius = {} }}\n", top, radius);
    };
    EXPECT_EQ(ids_of(cylinder("1.001", "0.4")), "shape-too-flat@7");
    EXPECT_EQ(ids_of(cylinder("1.001", "0.1")), "shape-too-flat@7");
    EXPECT_EQ(ids_of(k_clean + "cone { from = (0, 1, 2)  to = (0, 1.001, 2)  radius = (0.4, 0.2) }\n"),
              "shape-too-flat@7");
    // A ring, a coin, and a needle.
    EXPECT_EQ(ids_of(k_clean +
                     "cone { from = (0, 1, 2)  to = (0, 1.000001, 2)  radius = (0.2, 0.4)  caps = false }\n"),
              "");
    EXPECT_EQ(ids_of(cylinder("1.02", "0.4")), "");
    EXPECT_EQ(ids_of(cylinder("2", "0.02")), "");
    // A plate that is flat, but large in the picture.
    EXPECT_EQ(ids_of(k_clean + "cylinder { from = (0, 0.02, 0)  to = (0, 0.04, 0)  radius = 2.5 }\n"), "");
}

TEST(CheckShapes, ThinIsNotHidden) {
    // A needle, and a disc and a pane that are seen from the side.
    for (const char* shape :
         {"cylinder { from = (-0.07, 1.503, 2)  to = (-0.07, 2.507, 2)  radius = 0.0001 }\n",
          "disc { center = (0, 2, 2)  normal = (0, 1, 0)  radius = 0.4 }\n",
          "triangle { vertices = ((0, 2, 2), (0.5, 2, 2), (0, 2, 3)) }\n",
          "cylinder { from = (0, 2, 2)  to = (0, 2.001, 2)  radius = 0.1 }\n"}) {
        const std::string text = "render { shadows = false }\n" + k_clean + shape;
        const std::string found = ids_of(text);
        EXPECT_TRUE(found == "shape-too-small@8" || found == "shape-too-flat@8") << shape << found;
    }
    EXPECT_EQ(ids_of(k_clean + "cylinder { from = (-1.5, 0.5, 0)  to = (-1.5, 1.5, 0)  radius = 0.2 }\n"),
              "shape-hidden@7");
}

// The corners of its box are in the picture, and the sphere is not.
TEST(CheckShapes, BesideThePicture) {
    EXPECT_EQ(ids_of(R"(render { shadows = false }
camera { position = (0, 0, 8)  look_at = (0, 0, 0)  fov_x = 50 }
light { position = (3, 6, 5)  intensity = 0.6 }
sphere { center = (0, 0, 0)  radius = 1 }
sphere { center = (4.5, 0, 0)  radius = 0.65 }
)"),
              "shape-outside-view@5");
}

// An ellipsoid has a place; of a quadric without ends, it is not known.
TEST(CheckShapes, QuadricsOutsideThePicture) {
    const auto quadric = [](std::string_view squares, std::string_view at) {
        return fmt::format("{}quadric {{ squares = {}  constant = -0.1  translate = {} }}\n", k_clean,
                           squares, at);
    };
    EXPECT_EQ(ids_of("render { shadows = false }\n" + quadric("(1, 2, 3)", "(40, 0, 0)")),
              "shape-outside-view@8");
    EXPECT_EQ(ids_of(quadric("(1, 2, 3)", "(0, 2, 2)")), "");
    EXPECT_EQ(ids_of("render { shadows = false }\n" + quadric("(1, 1, 0)", "(40, 0, 0)")), "");
}

TEST(CheckShapes, TheBodyOfALightMayBeOutside) {
    EXPECT_EQ(ids_of(R"(Begin_Scene
Resolution 160 120
Camera Zoom 1 Aspectratio 1 Antialiasing 0 Raydepth 4 Center 0 1 -6 Viewdir 0 -0.1 1 Updir 0 1 0 End_Camera
Light Center 3 9 -5 Rad 0.2 Color 1 1 1
Sphere Center 0 0 0 Rad 1 Texture Ambient 0.1 Diffuse 0.7 Specular 0 Opacity 1 Color 0.8 0.3 0.2 TexFunc 0
End_Scene
)",
                     "a.dat"),
              "");
}

}  // namespace
}  // namespace glint::test
