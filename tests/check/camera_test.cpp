// SPDX-License-Identifier: Apache-2.0
// Mistakes of the camera, planted, and what is none.
#include "check/check_text.h"

namespace glint::test {
namespace {

TEST(CheckCamera, ACleanSceneHasNoFinding) { EXPECT_EQ(ids_of(k_clean), ""); }

TEST(CheckCamera, InsideAShape) {
    for (const char* shape :
         {"sphere \"case\" { center = (0, 2, 8.3)  radius = 0.5 }",
          "box \"case\" { min = (-1, 1, 7.9)  max = (1, 3, 9) }",
          "cylinder \"case\" { from = (0, 1, 8)  to = (0, 3, 8)  radius = 0.4 }",
          "cone \"case\" { from = (0, 1, 8)  to = (0, 3, 8)  radius = (1, 0) }",
          "quadric \"case\" { squares = (1, 2, 1)  constant = -1  translate = (0, 2, 8.2) }",
          "difference \"case\" { box { min = (-1, 1, 7.9)  max = (1, 3, 9) } sphere { center = (0, 3, 9)  "
          "radius = "
          "1 } }",
          "torus \"case\" { center = (2, 2, 8)  axis = (0, 1, 0)  radius = 2  tube = 0.4 }",
          "sphere \"case\" { center = (0, 0, 0)  radius = 1  scale = 0.5  translate = (0, 2, 8) }"}) {
        const std::vector<Finding> result = check_text(k_clean + shape);
        ASSERT_FALSE(result.empty()) << shape;
        EXPECT_EQ(result[0].id, "camera-inside-shape") << shape;
        EXPECT_EQ(result[0].diagnostic.line, 1u);
        EXPECT_TRUE(has(result[0].diagnostic.message, "'case' (line 7)")) << result[0].diagnostic.message;
        EXPECT_TRUE(has(result[0].diagnostic.source_line, "camera {"));
    }
}

// It touches the floor, which does not go through it.
TEST(CheckCamera, InsideABallOnAFloor) {
    EXPECT_TRUE(has(ids_of("camera { position = (0, 1.2, 0.3)  look_at = (0, 1, -4)  fov_x = 50 }\n"
                           "light { position = (3, 6, 5)  intensity = 0.6 }\n"
                           "sphere { center = (0, 0.7, 0.2)  radius = 0.7 }\n"
                           "plane { point = (0, 0, 0)  normal = (0, 1, 0) }\n"),
                    "camera-inside-shape@1"));
}

TEST(CheckCamera, NotInsideWhatIsOpenBesideItOrAroundAll) {
    for (const char* shape :
         {// open ends
          "cylinder { from = (0, 1, 9)  to = (0, 3, 9)  radius = 1.5  caps = false }",
          // its box holds the camera, it does not
          "sphere { center = (3, 4, 9.5)  radius = 3.5 }",
          // the sky
          "sphere { center = (0, 0, 0)  radius = 200  color = (0.4, 0.5, 0.9)  ambient = 3 }",
          // a sky without lights' light, which is all there is
          "sphere { center = (0, 0, 0)  radius = 12  color = (0.4, 0.5, 0.9)  diffuse = 0  specular = 0  "
          "ambient = 1 }",
          // a sheet: the half-space behind a plane, of which the surface is cut out
          "clip { plane { point = (0, 0, -3)  normal = (0, 0, -1) } sphere { center = (0, 2, -3)  radius = "
          "0.5 } }",
          // a room under a sky
          "box { min = (-9, -1, -9)  max = (9, 9, 9) }\nsphere { center = (0, 0, 0)  radius = 200 }"}) {
        EXPECT_FALSE(has(ids_of(k_clean + shape), "camera-inside")) << shape << "\n"
                                                                    << ids_of(k_clean + shape);
    }
}

TEST(CheckCamera, NotInsideASkyOverAFloor) {
    const std::string scene = R"(camera { position = (0, 2, 8)  look_at = (0, 1, 0)  fov_x = 50 }
light { type = ambient  intensity = 0.2 }
light { position = (3, 6, 5)  intensity = 0.6 }
)";
    const std::string sky =
        "sphere { center = (0, 0, 0)  radius = 50  color = (0.4, 0.5, 0.9)  ambient = 1 }\n";
    EXPECT_EQ(
        ids_of(scene + sky + "plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.5, 0.4, 0.3) }\n"),
        "");
    // A plane that does not go through it makes no room of it.
    EXPECT_TRUE(has(ids_of(scene + sky + "plane { point = (0, -60, 0)  normal = (0, 1, 0) }\n"),
                    "camera-inside-shape@1"));
}

TEST(CheckCamera, LooksAway) {
    const std::string message = only_message(R"(light { position = (0, 5, 0) }
camera { position = (0, 0, 5)  look_at = (0, 0, 10) }
sphere { center = (0, 0, 0)  radius = 1 }
)");
    EXPECT_TRUE(has(message, "scene.glint:2:1: warning: ")) << message;
    EXPECT_TRUE(has(message, "[camera-sees-nothing]")) << message;
    EXPECT_TRUE(has(message, "is behind it")) << message;
    EXPECT_TRUE(has(message, "  remedy: point the camera at (0, 0, 0)")) << message;
}

// The remedy is not to point the camera where it points already.
TEST(CheckCamera, LooksAtShapesThatItDoesNotSee) {
    const std::string lit = "light { position = (30, 50, 50) }\n";
    const std::string narrow =
        lit +
        "sphere { center = (-15, 10, 0)  radius = 10 }\n"
        "sphere { center = (15, 10, 0)  radius = 10 }\n"
        "camera { projection = orthographic  position = (0, 10, 80)  look_at = (0, 10, 0)";
    EXPECT_TRUE(has(only_message(narrow + " }\n"), "remedy: make the view wider"))
        << only_message(narrow + " }\n");
    EXPECT_EQ(ids_of(narrow + "  width = 60 }\n"), "");

    const std::string ball = lit + "sphere { center = (0, 1, 0)  radius = 1  color = (0.8, 0.2, 0.1) }\n";
    const std::string far = ball + "camera { position = (0, 1, 3000)  look_at = (0, 1, 0)  fov_x = 45 }\n";
    EXPECT_TRUE(has(only_message(far), "remedy: move the camera nearer, or narrow its angle"))
        << only_message(far);

    const std::string below = ball +
                              "plane { point = (0, 0, 0)  normal = (0, 1, 0) }\n"
                              "camera { position = (0, -2, 8)  look_at = (0, 1, 0) }\n";
    EXPECT_TRUE(
        has(to_string(check_text(below)[0]), "remedy: move the camera to the shapes' side of the planes"))
        << to_string(check_text(below)[0]);

    const std::string within = lit +
                               "sphere { center = (-1.5, 1, 0)  radius = 1 }\n"
                               "sphere { center = (1.5, 1, 0)  radius = 1 }\n"
                               "camera { position = (0, 1, 0)  look_at = (0, 2, 8) }\n";
    EXPECT_TRUE(has(only_message(within), "it stands in the middle of them")) << only_message(within);
    EXPECT_TRUE(has(only_message(within), "remedy: move the camera away")) << only_message(within);

    const std::string near = only_message(
        "sphere { center = (0, 0, 0.6) radius = 0.2 color = (200, 20, 10) specular = 50 }\n"
        "light { type = point intensity = 0.8 position = (2, 3, 0) }\n",
        "a.cgfs");
    EXPECT_TRUE(has(near, "remedy: move the camera back")) << near;
}

TEST(CheckCamera, SeesOnlyPlanes) {
    // The floor is seen, the ball is behind the viewer.
    EXPECT_EQ(ids_of(R"(light { position = (0, 5, 0) }
camera { position = (0, 1, 5)  look_at = (0, 0, 10) }
plane { point = (0, 0, 0)  normal = (0, 1, 0) }
sphere { center = (0, 1, 0)  radius = 1 }
)"),
              "camera-sees-nothing@2");
    // A scene of planes alone is one.
    EXPECT_EQ(ids_of(R"(light { position = (0, 5, 0)  intensity = 0.7 }
camera { position = (0, 1, 5)  look_at = (0, 0, 10) }
plane { point = (0, 0, 0)  normal = (0, 1, 0) }
)"),
              "");
}

TEST(CheckCamera, SeesByItsMirror) {
    EXPECT_EQ(ids_of(R"(light { position = (0, 5, 0)  intensity = 0.6 }
camera { position = (0, 1, 5)  look_at = (0, 1, 10) }
plane { point = (0, 0, 9)  normal = (0, 0, -1)  mirror = 0.9 }
sphere { center = (0, 1, 0)  radius = 1 }
)"),
              "");
}

TEST(CheckCamera, SkewedFrame) {
    const std::string lit =
        "sphere { center = (0, 0, 4) radius = 1 color = (200, 100, 50) }\n"
        "light { type = point intensity = 0.7 position = (2, 3, 0) }\n";
    EXPECT_EQ(ids_of(lit + "camera { position = (0, 0, 0)\n rotation = ((1, 0.3, 0), (0, 1, 0), (0, 0, 1)) }",
                     "a.cgfs"),
              "camera-frame-skewed@3");
    EXPECT_EQ(ids_of(lit + "camera { position = (0, 0, 0)\n rotation = ((1, 0, 0), (0, 1, 0), (0, 0, 2)) }",
                     "a.cgfs"),
              "camera-frame-skewed@3");
    // The book's own settings stretch the viewport.
    for (const char* viewport : {"projection_plane_d = 2\n", "viewport_size = 2 x 1\n"}) {
        EXPECT_EQ(ids_of(viewport + lit, "a.cgfs"), "") << viewport;
        EXPECT_TRUE(has(ids_of(viewport + lit +
                                   "camera { position = (0, 0, 0)\n rotation = ((1, 0, 0), (0, 1, "
                                   "0), (0, 0, 2)) }",
                               "a.cgfs"),
                        "camera-frame-skewed@4"))
            << viewport;
    }
    // Rounded to four digits.
    EXPECT_EQ(ids_of("sphere { center = (0, 0, 4) radius = 1 color = (200, 100, 50) }\n"
                     "light { type = point intensity = 0.7 position = (2, 3, 0) }\n"
                     "camera { position = (4, 0, 0)  rotation = ((0.7071, 0, -0.7071), (0, 1, 0), (0.7071, "
                     "0, 0.7071)) }",
                     "a.cgfs"),
              "");
}

TEST(CheckCamera, Mirrored) {
    const auto pov = [](const char* right) {
        return fmt::format(
            "camera {{ location <0, 2, 9> up <0, 1, 0> right <{}, 0, 0> look_at <0, 1, 0> }}\n"
            "light_source {{ <3, 8, 7> color rgb <0.7, 0.7, 0.7> }}\n"
            "sphere {{ <0, 1, 0>, 1 pigment {{ color rgb <0.8, 0.3, 0.2> }} finish {{ ambient 0.2 diffuse "
            "0.7 }} "
            "}}\n",
            right);
    };
    EXPECT_EQ(ids_of(pov("1.33333"), "a.pov"), "");
    EXPECT_EQ(ids_of(pov("-1.33333"), "a.pov"), "camera-mirrored@1");
}

// POV-Ray's default camera is left-handed, that of exported models is often right-handed; both are right.
TEST(CheckCamera, NotMirroredInPovRay) {
    const auto pov = [](std::string_view camera) {
        return fmt::format(
            "#version 3.7;\ncamera {{ {} }}\nlight_source {{ <3, 8, -7> rgb 0.7 }}\n"
            "light_source {{ <3, 8, 7> rgb 0.2 }}\n"
            "sphere {{ <0, 1, 0>, 1 pigment {{ rgb <0.8, 0.3, 0.2> }} finish {{ ambient 0.2 diffuse 0.7 }} "
            "}}\n",
            camera);
    };
    for (const std::string_view camera :
         {"location <0, 2, -9> look_at <0, 1, 0>",
          "location <0, 2, -9> right x * image_width / image_height look_at <0, 1, 0>",
          "location <0, 2, 9> right -1.33 * x look_at <0, 1, 0>",
          "orthographic location <0, 2, 9> right <-4, 0, 0> up <0, 3, 0> look_at <0, 1, 0>",
          "location <0, 1, 9> direction <0, 0, -1>"})
        EXPECT_EQ(ids_of(pov(camera), "a.pov"), "") << camera;
}

// Text that is in CSC 473's part of the language as well: POV-Ray renders it with this right vector, too.
TEST(CheckCamera, NotMirroredIfPovRayAgrees) {
    const auto pov = [](const char* right) {
        return fmt::format(
            "camera {{ location <0, 2, -9> up <0, 1, 0> right <{}, 0, 0> look_at <0, 1, 0> }}\n"
            "light_source {{ <3, 8, -7> color rgb <0.7, 0.7, 0.7> }}\n"
            "sphere {{ <0, 1, 0>, 1 pigment {{ color rgb <0.8, 0.3, 0.2> }} finish {{ ambient 0.2 diffuse "
            "0.7 }} "
            "}}\n",
            right);
    };
    EXPECT_EQ(load_text(pov("1.33333"), "a.pov").value().profile, "csc473");
    EXPECT_EQ(ids_of(pov("1.33333"), "a.pov"), "");
    EXPECT_EQ(ids_of(pov("-1.33333"), "a.pov"), "");
}

TEST(CheckCamera, MirroredInTheBook) {
    const auto book = [](const char* rotation) {
        return fmt::format(
            "sphere {{ center = (0.5, 0, 4) radius = 1 color = (200, 100, 50) }}\n"
            "light {{ type = point intensity = 0.7 position = (2, 3, 0) }}\n"
            "camera {{ position = (0, 0, 0)\n rotation = ({}) }}",
            rotation);
    };
    EXPECT_EQ(ids_of(book("(1, 0, 0), (0, 1, 0), (0, 0, 1)"), "a.cgfs"), "");
    EXPECT_EQ(ids_of(book("(-1, 0, 0), (0, 1, 0), (0, 0, 1)"), "a.cgfs"), "camera-mirrored@3");
}

std::string with_fov(std::string_view fov) {
    std::string text = k_clean;
    return text.replace(text.find("fov_x = 50"), 10, fov);
}

TEST(CheckCamera, SeesTooMuch) {
    EXPECT_EQ(ids_of(with_fov("fov_x = 175")), "camera-view-too-wide@1");
    EXPECT_TRUE(has(only_message(with_fov("fov_x = 175")), "sees 175 degrees from left to right"))
        << only_message(with_fov("fov_x = 175"));
    EXPECT_FALSE(has(ids_of(with_fov("fov_x = 120")), "camera-"));
    // Across the other side.
    EXPECT_TRUE(
        has(ids_of("render { size = 120 x 360 }\n" + with_fov("fov_y = 160")), "camera-view-too-wide@2"));
    EXPECT_EQ(ids_of("camera { location <0, 2, -3> look_at <0, 1, 0> angle 170 }\n"
                     "light_source { <3, 8, -7> rgb 0.7 }\nplane { y, 0 pigment { rgb 0.5 } }\n"
                     "sphere { <0, 1, 0>, 1 pigment { rgb <0.8, 0.3, 0.2> } }\n",
                     "a.pov"),
              "camera-view-too-wide@1");
}

TEST(CheckCamera, AngleInRadians) {
    const std::string text = with_fov("fov_x = 0.9");
    EXPECT_EQ(ids_of(text), "camera-angle-in-radians@1");
    EXPECT_TRUE(has(only_message(text), "remedy: write the angle in degrees: 51.6")) << only_message(text);
    EXPECT_EQ(ids_of("camera { location <0, 2, -7> look_at <0, 1, 0> angle 0.7 }\n"
                     "light_source { <3, 8, -7> rgb 0.7 }\nplane { y, 0 pigment { rgb 0.5 } }\n"
                     "sphere { <0, 1, 0>, 1 pigment { rgb <0.8, 0.3, 0.2> } }\n",
                     "a.pov"),
              "camera-angle-in-radians@1");
    // With something beside the shape.
    std::string edge = text;
    edge.replace(edge.find("(0, 0.5, 0)"), 11, "(-0.5, 1, 0)");
    EXPECT_EQ(ids_of(edge), "camera-angle-in-radians@1");
    // From far away, by a telescope.
    EXPECT_EQ(
        ids_of(
            "camera { position = (0, 0, 100)  look_at = (0, 0, 0)  fov_x = 1.8 }\n"
            "light { position = (30, 60, 90)  intensity = 0.6 }\nsphere { center = (0, 0, 0)  radius = 1 }\n"
            "sphere { center = (0, 40, -900)  radius = 1  color = (1, 0, 0) }\n")
            .find("camera-"),
        std::string::npos);
    std::string far = with_fov("fov_x = 2");
    far.replace(far.find("(0, 2, 8)"), 9, "(0, 40, 160)");
    EXPECT_EQ(ids_of(far), "");
}

}  // namespace
}  // namespace glint::test
