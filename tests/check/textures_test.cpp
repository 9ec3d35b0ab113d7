// SPDX-License-Identifier: Apache-2.0
// Mistakes of textures, planted, and what is none.
#include "check/check_text.h"

namespace glint::test {
namespace {

constexpr std::string_view k_texels = "texels = (\"202020 e0e0e0\", \"e0e0e0 202020\")  ";

std::string texture(const std::string& keys) {
    return "texture checks { " + std::string(k_texels) + keys + " }\n";
}
const std::string k_ball = "sphere { center = (0, 1, 2)  radius = 0.4  texture = checks }\n";

// A square with these texture coordinates at its corners.
std::string square(const std::string& coordinates) {
    return "mesh { vertices = ((-0.4, 0.8, 2), (0.4, 0.8, 2), (0.4, 1.6, 2), (-0.4, 1.6, 2))  "
           "triangles = ((0, 1, 2), (0, 2, 3))  " +
           (coordinates.empty() ? "" : "texture_coordinates = (" + coordinates + ")  ") +
           "material = painted }\n";
}
const std::string k_painted = "material painted { texture = checks }\n";
const std::string k_whole = "(0, 0), (1, 0), (1, 1), (0, 1)";

TEST(CheckTextures, SayNothingOfSoundOnes) {
    for (const std::string_view mapping : {"planar", "spherical", "cylindrical"})
        for (const std::string_view wrap : {"repeat", "mirror", "clamp", "once"})
            EXPECT_EQ(ids_of(k_clean +
                             texture(fmt::format("mapping = {}  wrap_u = {}  wrap_v = {}  translate = "
                                                 "(0, 0.8, 2)",
                                                 mapping, wrap, wrap)) +
                             k_ball),
                      "")
                << mapping << wrap;
    EXPECT_EQ(ids_of(k_clean + texture("") + k_painted + square(k_whole)), "");
}

TEST(CheckTextures, Unused) {
    EXPECT_EQ(ids_of(k_clean + texture("")), "texture-unused@7");
    EXPECT_TRUE(has(only_message(k_clean + texture("")), "no material has texture 'checks'"));
}

TEST(CheckTextures, ShapesWithoutCoordinates) {
    EXPECT_EQ(ids_of(k_clean + texture("") + k_ball), "texture-without-coordinates@8");
    EXPECT_EQ(ids_of(k_clean + texture("") + k_painted + square("")), "texture-without-coordinates@8");
    const std::string one = only_message(k_clean + texture("") + k_painted + square(""));
    EXPECT_TRUE(has(one,
                    "material 'painted' (line 8) has texture 'checks' (line 7), which is placed by the "
                    "texture coordinates of meshes, and the only shape that has it, mesh 4 (line 9), "
                    "has none"))
        << one;
    const std::string two =
        only_message(k_clean + texture("") + k_painted + square(k_whole) +
                     "sphere { center = (0, 2, 2)  radius = 0.2  material = painted }\n"
                     "box { min = (-0.6, 2, 2)  max = (-0.3, 2.3, 2.3)  material = painted }\n");
    EXPECT_TRUE(has(two, "2 of the 3 shapes that have it have none: sphere 5 (line 10) and box 6 (line 11)"))
        << two;
}

// Of a solid, meshes are asked for coordinates, and its other shapes if there is no mesh that has them.
TEST(CheckTextures, ShapesOfSolidsWithoutCoordinates) {
    const auto cut = [](std::string_view first, std::string_view second) {
        return ids_of(
            fmt::format("{}{}{}difference {{ {} {} }}\n", k_clean, texture(""), k_painted, first, second));
    };
    const auto wedge = [](std::string_view coordinates) {
        return fmt::format(
            "mesh {{ vertices = ((-0.4, 0.8, 2), (0.4, 0.8, 2), (0, 0.8, 1.6), (0, 1.6, 1.8))  triangles = "
            "((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3))  {} material = painted }}",
            coordinates);
    };
    const std::string_view plain = "sphere { center = (0, 1.2, 2.1)  radius = 0.2  color = (1, 0, 0) }",
                           painted = "sphere { center = (0, 1.2, 2.1)  radius = 0.2  material = painted }";
    const std::string sound = wedge("texture_coordinates = (" + k_whole + ")  ");
    EXPECT_EQ(cut(sound, plain), "");
    EXPECT_EQ(cut(sound, painted), "");
    EXPECT_EQ(cut(wedge(""), plain), "texture-without-coordinates@8");
    EXPECT_EQ(cut("box { min = (-0.3, 0.9, 1.8)  max = (0.3, 1.5, 2.1) }", painted),
              "texture-without-coordinates@8");
}

TEST(CheckTextures, TrianglesWithoutCoordinates) {
    const std::string all = k_clean + texture("") + k_painted + square(k_whole) + square(k_whole);
    Scene scene = load_text(all, "scene.glint").value();
    EXPECT_EQ(ids(check_loaded(scene)).find("texture-without"), std::string::npos);
    MeshData mesh = *scene.meshes.at(0);
    mesh.texture_coordinates.corners = {mesh.triangles.at(0), {k_none, k_none, k_none}};
    scene.meshes[0] = std::make_shared<const MeshData>(mesh);
    std::string found;
    for (const Finding& f : check_loaded(scene))
        if (f.id == "texture-without-coordinates") found += to_string(f);
    EXPECT_TRUE(has(found, "and 1 of the 2 triangles of mesh 4 (line 9) has none")) << found;
    EXPECT_TRUE(has(found, "another material")) << found;
}

TEST(CheckTextures, OutOfReach) {
    const auto planar = [](std::string_view keys) {
        return ids_of(k_clean + texture("mapping = planar  " + std::string(keys)) + k_ball);
    };
    EXPECT_EQ(planar("wrap_u = once  translate = (0.5, 0, 0)"), "texture-out-of-reach@7");
    EXPECT_EQ(planar("wrap_v = once  uv_map = ((1, 0, 0), (0, 1, 3))"), "texture-out-of-reach@7");
    EXPECT_EQ(planar("wrap_v = once  translate = (0.5, 0, 0)"), "");
    EXPECT_EQ(planar("wrap_u = once  translate = (0.3, 0, 0)"), "");
    // Planes have all coordinates.
    EXPECT_EQ(ids_of(k_clean +
                     texture("mapping = planar  wrap_u = once  wrap_v = once  translate = (9, 9, 9)  "
                             "rotate = (90, 0, 0)") +
                     "plane { point = (0, 0, -9)  normal = (0, 0, 1)  texture = checks }\n"),
              "");
    const auto painted = [](const std::string& keys, const std::string& coordinates) {
        return ids_of(k_clean + texture(keys) + k_painted + square(coordinates));
    };
    const std::string beside = "(1.5, 0), (2.5, 0), (2.5, 1), (1.5, 1)";
    EXPECT_EQ(painted("wrap_u = once", beside), "texture-out-of-reach@7");
    for (const std::string wrap : {"repeat", "mirror", "clamp"})
        EXPECT_EQ(painted("wrap_u = " + wrap, beside), "") << wrap;
    EXPECT_EQ(painted("wrap_u = once  uv_map = ((1, 0, -1), (0, 1, 0))", beside), "");
    EXPECT_EQ(painted("wrap_u = once", "(0.5, 0), (2.5, 0), (2.5, 1), (1.5, 1)"), "");
}

TEST(CheckTextures, Invisible) {
    const auto shown = [](std::string_view texels, std::string_view keys) {
        return ids_of(k_clean +
                      fmt::format("texture checks {{ texels = ({})  mapping = spherical  translate = (0, 1, "
                                  "2)  {} }}\n",
                                  texels, keys) +
                      k_ball);
    };
    const std::string_view none = "\"20202000 e0e0e000\"", some = "\"20202060 e0e0e060\"";
    EXPECT_TRUE(has(shown(none, ""), "texture-invisible@7")) << shown(none, "");
    EXPECT_TRUE(has(shown(some, "alpha = mask"), "texture-invisible@7"));
    EXPECT_EQ(shown(none, "alpha = ignore"), "");
    EXPECT_EQ(shown(some, ""), "");
    EXPECT_EQ(shown(some, "alpha = mask  alpha_cutoff = 0.3"), "");
    EXPECT_EQ(shown(none, "wrap_u = once  uv_map = ((2, 0, 0), (0, 2, 0))"), "");
}

// Two texels, the left one a hole, and a square in front of the other shapes with these coordinates.
std::string masked(const std::string& coordinates, const std::string& keys = "alpha = mask") {
    return "texture checks { texels = (\"20202000 e0e0e0ff\")  filter = nearest  " + keys + " }\n" +
           k_painted + square(coordinates);
}
const std::string k_in_hole = "(0, 0), (0.4, 0), (0.4, 1), (0, 1)";

TEST(CheckTextures, OnlyHolesAreSeen) {
    EXPECT_EQ(ids_of(k_clean + masked(k_in_hole)), "shape-only-holes@9");
    const std::string message = only_message(k_clean + masked(k_in_hole));
    EXPECT_TRUE(has(message,
                    "mesh 4 (line 9) is seen only where texture 'checks' (line 7) has a hole: rays meet it "))
        << message;
    for (const std::string seen : {"alpha = ignore", "alpha = mask  alpha_cutoff = 0",
                                   "alpha = mask  uv_map = ((1, 0, 0.5), (0, 1, 0))"})
        EXPECT_EQ(ids_of(k_clean + masked(k_in_hole, seen)), "") << seen;
    EXPECT_EQ(ids_of(k_clean + masked("(0, 0), (0.6, 0), (0.6, 1), (0, 1)")), "");
    // It is a few pixels large, and the picture does not show all of it.
    EXPECT_EQ(
        ids_of("render { size = 24 x 18 }\n" + k_clean.substr(k_clean.find("  camera")) + masked(k_in_hole)),
        "");
}

TEST(CheckTextures, OnlyBacksAreSeen) {
    const auto turned = [](const std::string& keys, const std::string& order = "(0, 2, 1), (0, 3, 2)") {
        return k_clean +
               "mesh { vertices = ((-0.3, 0.2, 3), (0.3, 0.2, 3), (0.3, 0.8, 3), (-0.3, 0.8, 3))  "
               "triangles = (" +
               order + ")  color = (0.9, 0.2, 0.1)  " + keys + " }\n";
    };
    EXPECT_EQ(ids_of(turned("one_sided = true")), "shape-only-back@7");
    EXPECT_TRUE(
        has(only_message(turned("one_sided = true")),
            "mesh 4 (line 7) is seen only from behind, and its one-sided material does not show there"));
    EXPECT_EQ(ids_of(turned("one_sided = false")), "");
    EXPECT_EQ(ids_of(turned("one_sided = true", "(0, 1, 2), (0, 2, 3)")), "");
    EXPECT_EQ(ids_of(turned("one_sided = true", "(0, 1, 2), (0, 3, 2)")), "mesh-winding@7")
        << "half of it is seen";
}

TEST(CheckTextures, TheCameraLooksAtHoles) {
    const std::string view = k_clean.substr(0, k_clean.find("plane"));
    const std::string plane = "plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.5, 0.5, 0.5) }\n";
    EXPECT_EQ(ids_of(view + plane + masked(k_in_hole)), "shape-only-holes@7");
    EXPECT_EQ(ids_of(view + masked(k_in_hole)), "shape-only-holes@6");
    // A plane is all that the camera could see.
    EXPECT_EQ(
        ids_of(view +
               "texture checks { texels = (\"20202000\", \"20202000\", \"202020ff\")  mapping = planar  "
               "wrap_u = clamp  wrap_v = clamp  alpha = mask  filter = nearest  translate = (0, -90, 0) }\n"
               "plane { point = (0, 0, -9)  normal = (0, 0, 1)  texture = checks }\n"),
        "shape-only-holes@5");
    // It looks elsewhere.
    EXPECT_EQ(ids_of("camera { position = (0, 2, 8)  look_at = (0, 0.5, 90) }\n" + plane + masked(k_in_hole)),
              "camera-sees-nothing@1");
}

TEST(CheckTextures, ShapesBehindHolesAndWithHolesAreNotHidden) {
    // A square behind another one, both transparent everywhere: the reason is their texture.
    const std::string sheets =
        "texture checks { texels = (\"20202000 e0e0e000\")  alpha = mask }\n" + k_painted + square(k_whole) +
        "mesh { vertices = ((-0.3, 0.9, 1), (0.3, 0.9, 1), (0.3, 1.5, 1), (-0.3, 1.5, 1))  "
        "triangles = ((0, 1, 2), (0, 2, 3))  texture_coordinates = (" +
        k_whole +
        ")  "
        "material = painted }\n";
    EXPECT_EQ(ids_of(k_clean + sheets), "texture-invisible@7");
    // Around the camera.
    EXPECT_EQ(
        ids_of(k_clean +
               "texture checks { texels = (\"20202000 e0e0e000\")  mapping = spherical  alpha = mask }\n"
               "sphere { center = (0, 2, 8)  radius = 0.5  texture = checks }\n"),
        "texture-invisible@7");
    // What is behind a hole is thin, not hidden.
    const std::string wire = "cylinder { from = (-0.2, 1.2, 1)  to = (0.2, 1.3, 1)  radius = 0.0002 }\n";
    EXPECT_EQ(ids_of(k_clean + wire), "shape-too-small@7");
    EXPECT_EQ(ids_of(k_clean + wire + sheets.substr(0, sheets.find("mesh", sheets.find("mesh") + 4))),
              "shape-too-small@7 texture-invisible@8");
}

TEST(CheckTextures, HolesShowTheBackground) {
    // All texels of the square but one are holes; it is not taken for the background.
    const std::string sky = "background = (0.4, 0.6, 0.9)\n" + k_clean.substr(0, k_clean.find("plane"));
    const std::string holes = R"("20202000 20202000 20202000 20202000 20202000 20202000 20202000 20202000")";
    std::string texels = R"("20202000 20202000 20202000 e0e0e0ff 20202000 20202000 20202000 20202000")";
    for (int i = 0; i < 7; ++i) texels += ", " + holes;
    const std::string sheet = k_painted + square(k_whole);
    EXPECT_EQ(ids_of(sky + "texture checks { texels = (" + texels + ")  filter = nearest  alpha = mask }\n" +
                     sheet),
              "");
    EXPECT_EQ(ids_of(sky + "texture checks { texels = (" + texels + ")  filter = nearest }\n" + sheet), "");
}

TEST(CheckTextures, ANarrowViewThroughAHole) {
    std::string text = k_clean;
    text.replace(text.find("(0, 0.5, 0)"), 11, "(0, 1.2, 2)");
    text.replace(text.find("fov_x = 50"), 10, "fov_x = 1.5");
    for (const std::string_view at : {"-0.04, 0.93", "0.04, 0.93", "0, 0.9"})
        text += fmt::format("sphere {{ center = ({}, 0)  radius = 0.015 }}\n", at);
    for (const std::string& scene : {text, text + masked(k_in_hole)})
        EXPECT_FALSE(has(ids_of(scene), "camera-angle-in-radians")) << ids_of(scene);
    EXPECT_TRUE(has(ids_of(text + masked(k_in_hole, "alpha = ignore")), "camera-angle-in-radians"));
}

TEST(CheckTextures, TooFine) {
    const auto scaled = [](std::string_view scale, std::string_view texels = "202020 e0e0e0") {
        return k_clean +
               fmt::format(
                   "texture checks {{ texels = (\"{}\", \"e0e0e0 202020\")  mapping = planar  scale "
                   "= {} }}\n",
                   texels, scale) +
               k_ball;
    };
    EXPECT_EQ(ids_of(scaled("0.0002")), "texture-too-fine@7");
    EXPECT_TRUE(has(only_message(scaled("0.0002")), "is so fine that it is noise in this picture"))
        << only_message(scaled("0.0002"));
    for (const std::string_view fine : {"0.004", "0.02", "1"}) EXPECT_EQ(ids_of(scaled(fine)), "") << fine;
    // Texels that hardly differ.
    EXPECT_EQ(ids_of(k_clean +
                     "texture checks { texels = (\"808080 909090\")  mapping = planar  scale = 0.0002 }\n" +
                     k_ball),
              "");
    // Many samples see many texels.
    EXPECT_EQ(ids_of("render { aa = 8 }\n" + scaled("0.0005")), "");
    // A floor that is fine only at the horizon.
    EXPECT_EQ(ids_of(k_clean +
                     "texture checks { texels = (\"202020 e0e0e0\", \"e0e0e0 202020\")  mapping = planar  "
                     "rotate = (90, 0, 0)  scale = 0.3 }\n"
                     "disc { center = (0, 0.01, 0)  normal = (0, 1, 0)  radius = 40  texture = checks }\n"),
              "");
}

// A wall whose coordinates go this far.
std::string fine_wall(double u, double v, const std::string& texels = "\"202020 e0e0e0\", \"e0e0e0 202020\"",
                      const std::string& keys = "") {
    return k_clean + fmt::format("texture checks {{ texels = ({})  {} }}\n", texels, keys) + k_painted +
           square(fmt::format("(0, 0), ({0}, 0), ({0}, {1}), (0, {1})", u, v));
}

TEST(CheckTextures, TooFineInOneDirection) {
    // The wall is about 37 pixels wide and high.
    const std::string columns = "\"202020 e0e0e0\"", rows = "\"202020\", \"e0e0e0\"";
    EXPECT_EQ(ids_of(fine_wall(100000, 0.001, columns)), "texture-too-fine@7");
    EXPECT_EQ(ids_of(fine_wall(0.001, 100000, rows)), "texture-too-fine@7");
    EXPECT_TRUE(has(only_message(fine_wall(100000, 0.001, columns)),
                    " texels lie along the side of a pixel; their colors differ by "))
        << only_message(fine_wall(100000, 0.001, columns));
    EXPECT_EQ(ids_of(fine_wall(1000, 1, columns)), "texture-too-fine@7");
    EXPECT_EQ(ids_of(fine_wall(200, 0.001, columns)), "");
    EXPECT_EQ(ids_of(fine_wall(200, 200, columns)), "");
    // It varies only in the other direction.
    EXPECT_EQ(ids_of(fine_wall(100000, 1, rows)), "");
    EXPECT_EQ(ids_of(fine_wall(1, 100000, columns)), "");
    EXPECT_EQ(ids_of("render { aa = 8 }\n" + fine_wall(1000, 1, columns)), "");
}

TEST(CheckTextures, NoiseOfAlpha) {
    const std::string texels = "\"e0e0e000 e0e0e0ff\", \"e0e0e0ff e0e0e000\"";
    EXPECT_EQ(ids_of(fine_wall(10000, 10000, texels, "alpha = mask")), "texture-too-fine@7");
    EXPECT_EQ(ids_of(fine_wall(10000, 10000, texels)), "texture-too-fine@7");
    EXPECT_TRUE(
        has(only_message(fine_wall(10000, 10000, texels, "alpha = mask")), "their alpha differs by "));
    EXPECT_EQ(ids_of(fine_wall(10000, 10000, texels, "alpha = ignore")), "");
    EXPECT_EQ(ids_of(fine_wall(10, 10, texels, "alpha = mask")), "");
    // The alpha hardly varies, or all of it is above the cutoff.
    EXPECT_EQ(ids_of(fine_wall(10000, 10000, "\"e0e0e0d0 e0e0e0d8\", \"e0e0e0d8 e0e0e0d0\"")), "");
    EXPECT_EQ(ids_of(fine_wall(10000, 10000, "\"e0e0e0a0 e0e0e0ff\", \"e0e0e0ff e0e0e0a0\"", "alpha = mask")),
              "");
    // Colors that differ where the surface is nearly transparent.
    EXPECT_EQ(ids_of(fine_wall(10000, 10000, "\"20202008 e0e0e008\", \"e0e0e008 20202008\"")), "");
}

TEST(CheckTextures, NoiseOfAlphaThatShowsNothing) {
    // What is behind looks like the surface: both are lit by ambient light alone, and of one color.
    const auto scene = [](std::string_view behind) {
        return "render { size = 320 x 240 }  camera { position = (0, 2, 8)  look_at = (0, 0.5, 0)  fov_x = "
               "50 }\n"
               "light { type = ambient }\nbackground = (0.2, 0.4, 0.6)\n" +
               fmt::format(
                   "disc {{ center = (0, 1.2, 1.9)  normal = (0, 0, 1)  radius = 1  color = {}  ambient = 1 "
                   "}}\n",
                   behind) +
               "texture checks { texels = (\"ffffff00 ffffffff\", \"ffffffff ffffff00\")  alpha = mask }\n"
               "material painted { color = (0.8, 0.8, 0.8)  ambient = 1  texture = checks }\n" +
               square("(0, 0), (10000, 0), (10000, 10000), (0, 10000)");
    };
    EXPECT_EQ(ids_of(scene("(0.8, 0.8, 0.8)")), "");
    EXPECT_EQ(ids_of(scene("(0.3, 0.1, 0.1)")), "texture-too-fine@5");
}

}  // namespace
}  // namespace glint::test
