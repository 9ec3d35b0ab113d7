// SPDX-License-Identifier: Apache-2.0
// Features of POV-Ray that glint does not render: each is named where it counts.
#include <fmt/format.h>

#include "formats/povray_text.h"
#include "math/transform.h"

namespace glint::test {
namespace {

// The warnings and errors of a text.
std::string said(const std::string& text) {
    return messages(read_povray("light_source { <0, 0, -9>, rgb 1 }\n" + text));
}

TEST(PovRayMissing, PartsOfAnInteriorAreNamedIfItCanBeSeenInto) {
    const std::string before = "sphere { 0, 1 pigment { rgbt <1, 1, 1, .5> } interior { ";
    EXPECT_NE(said(before + "media { emission 1 } } }").find("2:57: warning: glint does not render `media`"),
              std::string::npos)
        << said(before + "media { emission 1 } } }");
    EXPECT_EQ(said(before + "fade_power 2 fade_distance 1 } }"), "");
    EXPECT_NE(said(before + "fade_power -2 fade_distance 1 } }").find("fade_power' (below 0)"),
              std::string::npos);
    const std::string faded = " pigment { rgbt 1 } interior { fade_distance 1 } }";
    EXPECT_EQ(
        said("mesh { triangle { 0, y, x } triangle { 0, x, z } triangle { 0, y, z } triangle { x, y, z }" +
             faded),
        "");
    EXPECT_NE(said("mesh { triangle { 0, y, x } triangle { 0, x, z } triangle { 0, y, z }" + faded)
                  .find("of a mesh that is open"),
              std::string::npos);
    const std::string mesh =
        "mesh { triangle { -8, 8*x-8, 8*y-8 } triangle { -8, 8*x-8, 8*z-8 } triangle { -8, 8*y-8, 8*z-8 } "
        "triangle { 8*x-8, 8*y-8, 8*z-8 } ";
    const std::string within = "camera { location -7 look_at -8 } ",
                      beside = "camera { location 1 look_at 0 } ";
    EXPECT_NE(said(within + mesh + faded).find("of a mesh around the camera without `inside_vector`"),
              std::string::npos)
        << said(within + mesh + faded);
    EXPECT_EQ(said(within + mesh + "inside_vector y" + faded), "");
    EXPECT_EQ(said(within + mesh + "inside_vector y pigment { rgbt 1 } }"), "");
    EXPECT_NE(said(within + mesh + "inside_vector y pigment { rgbt 1 } interior { ior 2 } }")
                  .find("the camera may be inside"),
              std::string::npos);
    EXPECT_EQ(said(within + mesh + "inside_vector 0 pigment { rgbt 1 } interior { ior 2 } }"), "");
    EXPECT_EQ(said(beside + mesh + faded), "");
    const std::string balls = "union { sphere { 0, 1 } sphere { ", half = " box { -9, <9, 0, 9> }" + faded;
    EXPECT_NE(said("intersection { " + balls + "x, 1 } } " + half).find("of a union in a solid whose parts"),
              std::string::npos);
    EXPECT_EQ(said("intersection { " + balls + "3*x, 1 } } " + half), "");
    EXPECT_EQ(said("difference { box { -9, 9 } " + balls + "x, 1 } }" + faded), "");
    EXPECT_EQ(said(before + "caustics 1 } }"), "");
    EXPECT_NE(said(before + "caustics -1 } }").find("`caustics` (below 0)"), std::string::npos);
    EXPECT_NE(said("sphere { 0, 1 texture { pigment { rgbt .5 } } texture { pigment { rgbt .5 } } interior { "
                   "caustics 1 } }")
                  .find("`caustics` (of layered textures)"),
              std::string::npos);
    EXPECT_NE(said(before + "ior 1.2 dispersion 1.1 } }").find("`dispersion`"), std::string::npos);
    const std::string named =
        "#declare I = interior { media { absorption 1 } }\nsphere { 0, 1 pigment { rgbt .5 } "
        "material { interior { I } } }";
    EXPECT_NE(said(named).find("`media`"), std::string::npos);
    EXPECT_EQ(said("sphere { 0, 1 pigment { rgb 1 } interior { media { emission 1 } ior 1.5 } }"), "");
}

TEST(PovRayMissing, CausticsAreAPowerOfTheCosine) {
    const auto caustics = [](const std::string& items) {
        return povray_scene("sphere { 0, 1 pigment { rgbt 1 } " + items + " }").materials.at(0).caustics;
    };
    EXPECT_EQ(caustics("interior { ior 1.5 }"), 0);
    EXPECT_EQ(caustics("interior { caustics 0.2 }"), 9);
    EXPECT_EQ(caustics("interior { caustics 1e12 }"), 1e12);
    EXPECT_EQ(caustics("interior { caustics 2 } interior { ior 1.2 }"), 90);
    const Scene two = povray_scene(
        "#declare I = interior { ior 1.5 caustics 2 }\nsphere { 0, 1 pigment { rgbt 1 } interior { I } }\n"
        "sphere { 3, 1 pigment { rgbt 1 } interior { ior 1.5 } }\n");
    EXPECT_EQ(two.materials.at(0).caustics, 90);
    EXPECT_EQ(two.materials.at(two.shapes.at(1).material).caustics, 0);
}

TEST(PovRayMissing, AMaterialAddsToTheInteriorBeforeIt) {
    const auto inside = [](const std::string& items) {
        const Scene scene = povray_scene(
            "#declare M = material { texture { pigment { rgbt 1 } } };\n"
            "sphere { 0, 1 pigment { rgbt 1 } interior { ior 1.5 fade_distance 2 } " +
            items + " }");
        const Material& m = scene.materials.at(0);
        return std::pair(m.refracts ? m.ior : 1, m.fade_distance);
    };
    EXPECT_EQ(inside("material { interior { ior 1.2 } }"), std::pair(1.2, 2.0));
    EXPECT_EQ(inside("material { texture { pigment { rgbt 1 } } }"), std::pair(1.5, 2.0));
    EXPECT_EQ(inside("material { M }"), std::pair(1.0, 0.0));
    EXPECT_EQ(inside("material { M interior { ior 1.3 } }"), std::pair(1.3, 0.0));
    EXPECT_EQ(inside("interior { fade_distance 9e-11 }"), std::pair(1.5, 0.0));
}

TEST(PovRayMissing, JitterIsNamedWhereItIsSeen) {
    const auto is_named = [](const std::string& light, const std::string& rest = "sphere { 0, 1 }") {
        const std::string text = "light_source { <0, 40, 9>, 1 area_light " + light + " jitter }\n" + rest;
        return said(text).find("`jitter` (of an area light") != std::string::npos;
    };
    EXPECT_TRUE(is_named("4*x, 4*z, 3, 3"));
    EXPECT_FALSE(is_named("4*x, 4*z, 3, 3", "sphere { 0, 1 no_shadow }"));
    EXPECT_FALSE(is_named("4*x, 4*z, 3, 3 shadowless"));
    EXPECT_FALSE(is_named("0.8*x, 0.8*z, 3, 3")) << "the edges of shadows are narrow";
    EXPECT_TRUE(is_named("0.8*x, 0.8*z, 3, 3", "plane { y, 0 }"));
    EXPECT_TRUE(is_named("0.8*x, 0.8*z, 3, 3",
                         "#for (I, 0, 9) #for (K, 0, 9) sphere { <I, 0, K>, 0.3 } sphere { <I, -1, K>, 0.3 } "
                         "#end #end"))
        << "there are many of them";
    EXPECT_FALSE(is_named("0.1*x, 0.1*z, 3, 3", "difference { sphere { 0, 1 } plane { x, 0 } }"));
    EXPECT_FALSE(is_named("0.1*x, 0.1*z, 3, 3", "intersection { plane { x, 0 } sphere { 0, 1 } }"));
    EXPECT_TRUE(is_named("0.1*x, 0.1*z, 3, 3", "union { difference { plane { y, 0 } sphere { 0, 1 } } }"))
        << "a plane has no end";
    EXPECT_TRUE(is_named("0.6*x, 0.6*z, 3, 1", "sphere { 0, 40 }")) << "the light is within the box";
    EXPECT_FALSE(is_named("0.6*x, 9*z, 3, 1", "sphere { 0, 1 }")) << "a side with one sample has no length";
    EXPECT_FALSE(is_named(
        "0.1*x, 0.1*z, 3, 3",
        "intersection { plane { x, 1 } plane { -x, 1 } plane { y, 1 } plane { -y, 1 } plane { z, 1 } "
        "plane { -z, 1 } rotate <10, 20, 30> }"))
        << "planes that enclose a box";
    // Meshes are searched up to 100 million steps: six for each vertex.
    const std::string many =
        "#declare M = mesh2 { vertex_vectors { 10000 #for (I, 0, 9999) , <mod(I, 100), 0, floor(I / 100)> / "
        "100 #end }\n"
        "face_indices { 9899 #for (I, 0, 9898) , <I, I + 1, I + 100> #end } }\n";
    EXPECT_FALSE(is_named("0.0001*x, 0.0001*z, 2, 2", many + "#for (I, 0, 1099) object { M } #end"));
    EXPECT_TRUE(is_named("0.0001*x, 0.0001*z, 2, 2", many + "#for (I, 0, 1799) object { M } #end"));
}

TEST(PovRayMissing, TinyScenesAreNamed) {
    const std::string mirror = " finish { reflection .5 } }\nplane { y, -9 }";
    EXPECT_NE(said("camera { location -1*z }\nsphere { 0, 0.004" + mirror)
                  .find("2:1: warning: all shapes are within 0.008 units: POV-Ray's fixed tolerances change "
                        "the mirrors"),
              std::string::npos);
    EXPECT_NE(said("sphere { 5, 0.001 }").find("change the shadows"), std::string::npos);
    EXPECT_EQ(said("camera { location -1*z }\nsphere { 0, 0.006" + mirror), "");
    EXPECT_EQ(said("camera { location -1*z }\nsphere { 0, 0.001 } sphere { 1, 0.001" + mirror), "");
    EXPECT_EQ(said("camera { location -1*z }\nsphere { 0, 0.003 }\nplane { y, -9 }"), "");
}

TEST(PovRayMissing, AHighBailoutOfReflectionsByTheAngle) {
    const std::string high = "global_settings { adc_bailout .1 }\n",
                      plain = "sphere { 0, 1 finish { reflection .4 } }",
                      angle = "sphere { 0, 1 finish { reflection { 0, .4 } } }";
    EXPECT_NE(said(high + angle).find("2:19: warning: glint does not render `adc_bailout`"),
              std::string::npos)
        << said(high + angle);
    EXPECT_NE(said(angle + high).find("`adc_bailout`"), std::string::npos);
    EXPECT_EQ(said(high + plain), "");
    EXPECT_EQ(said("global_settings { adc_bailout 1/255 }\n" + angle), "");
}

TEST(PovRayMissing, ParallelLightsBelowAPolygon) {
    const std::string light = "light_source { <0, 3, 0>, rgb 1 parallel point_at 0 }\n";
    EXPECT_NE(said(light + "sphere { 0, 1 } polygon { 4, <0, 4, 0>, <1, 4, 0>, <1, 4, 1>, <0, 4, 1> }")
                  .find("`parallel`"),
              std::string::npos);
    EXPECT_EQ(said(light + "sphere { 0, 1 } polygon { 4, <0, 2, 0>, <1, 2, 0>, <1, 2, 1>, <0, 2, 1> }"), "");
    const std::string ellipsoid = "sphere { 0, 1 } quadric { <1, 2, 1>, 0, 0, -1 translate y*";
    EXPECT_NE(said(light + ellipsoid + "4 }").find("`parallel`"), std::string::npos);
    EXPECT_EQ(said(light + ellipsoid + "2 }"), "");
    EXPECT_NE(said(light + "sphere { 0, 1 } quadric { <1, 0, 1>, 0, 0, -1 }").find("`parallel`"),
              std::string::npos);
}

TEST(PovRayMissing, BoundsOfShapesWithoutEnds) {
    const std::string bounds = " bounded_by { sphere { 0, 2 } } }";
    const std::string zeros = ", 0, 0, 0, 0, 0, 0, 0, 0, 0";
    const std::string ring = "quartic { <1, 0, 0, 0, 2, 0, 0, 2, 0, -3" + zeros + ", 0, 1, 0, 0, 2, 0, -3" +
                             ", 0, 0, 0, 0, 1, 0, -3, 0, 1>";
    for (const std::string& text :
         {"plane { y, 0" + bounds, "quadric { <1, 0, 1>, 0, 0, -1" + bounds,
          "quartic { <1, 0, 0, 0" + zeros + zeros + zeros + ", 0, 1, 0, -1>" + bounds,
          "union { sphere { 0, 1 } plane { y, 0 }" + bounds})
        EXPECT_NE(said(text).find("POV-Ray draws a shape without ends only where"), std::string::npos)
            << text;
    for (const std::string& text :
         {std::string("plane { y, 0 }"), "sphere { 0, 1" + bounds, "quadric { <1, 1, 1>, 0, 0, -1" + bounds,
          ring + bounds, "intersection { plane { y, 0 } sphere { 0, 1 }" + bounds})
        EXPECT_EQ(said(text), "") << text;
}

TEST(PovRayMissing, BoundsThatAreTooSmall) {
    for (const char* text :
         {"sphere { 0, 1 bounded_by { box { <-.5, .5, -.5>, <.5, 1.5, .5> } } }",
          "torus { 1, .3 bounded_by { sphere { 0, .7 } } }", "box { -1, 1 bounded_by { sphere { 0, .4 } } }",
          "difference { box { -1, 1 } sphere { 1, .5 } bounded_by { box { -.4, .4 } } }",
          "sphere { 0, 1 translate 3*x bounded_by { sphere { 0, .9 } } }",
          "union { sphere { 0, 1 } sphere { 2*x, 1 } bounded_by { box { -1, 1 } } rotate 20*z }"})
        EXPECT_NE(said(text).find("this one reaches out of it"), std::string::npos) << text;
    for (const char* text :
         {"sphere { 0, 1 bounded_by { sphere { 0, 1 } } }", "sphere { 0, 1 bounded_by { box { -1, 1 } } }",
          "sphere { 0, 1 bounded_by { sphere { 0, 1 } } translate 3*x rotate 20*z }",
          "torus { 1, .3 bounded_by { box { -.9, .9 } } }", "sphere { 0, 1 bounded_by { plane { y, 2 } } }",
          "union { sphere { 0, 1 } sphere { x, 1 } bounded_by { box { -1, 2 } } }",
          "sphere { 0, 1 clipped_by { plane { y, 0 } } bounded_by { clipped_by } }"})
        EXPECT_EQ(said(text), "") << text;
}

TEST(PovRayMissing, RefractionOfThreeObjectsWithinEachOther) {
    const std::string glass = "pigment { rgbt 1 } interior { ior 1.5 } }";
    const Scene scene = povray_scene("sphere { 0, 1 " + glass);
    EXPECT_EQ(scene.materials.at(0).transmit, 1);
    EXPECT_EQ(scene.materials.at(0).ior, 1.5);
    EXPECT_TRUE(scene.materials.at(0).refracts);
    const std::string two = "sphere { 0, 1 " + glass + " box { 0, 1 " + glass;
    for (const std::string& text :
         {two, two + " sphere { 9*x, 1 " + glass, two + " sphere { 0, 1 }",
          "union { sphere { 0, 1 } sphere { x, 1 } sphere { y, 1 } sphere { z, 1 } " + glass})
        EXPECT_EQ(said(text), "") << text;
    for (const std::string& text :
         {two + " cylinder { 0, x, 1 open " + glass, two + " sphere { x, 1 pigment { rgbt .5 } }"}) {
        EXPECT_NE(said(text).find("`ior` (of three transparent objects within each other)"),
                  std::string::npos)
            << text << said(text);
    }
    // Where three are together is too small to be seen (of a camera 60 units away).
    const std::string axes =
        "cylinder { 0, 40*x, .2 open pigment { rgbt .7 } } cylinder { 0, 40*y, .2 open pigment { rgbt .7 } }";
    const auto lens_at = [&](double y) {
        return axes + fmt::format(" sphere {{ <0, {}, 0>, 17 ", y) + glass;
    };
    const std::string far = "camera { location <30, 30, 50> look_at 0 }\n",
                      near = "camera { location <1, 3, 5> look_at 0 }\n";
    EXPECT_EQ(said(far + lens_at(16.9)), "");
    EXPECT_NE(said(near + lens_at(16.9)).find("of three transparent objects"), std::string::npos);
    EXPECT_NE(
        said(far + lens_at(16.9) + "sphere { <0, 16.9, 0>, 16 " + glass).find("of three transparent objects"),
        std::string::npos);
    // Planes that enclose something have an end: boxes, and eight planes around a point.
    const auto cube = [&](double at) {
        return fmt::format(
                   "intersection {{ plane {{ x, 1 }} plane {{ -x, 0 }} plane {{ y, 1 }} plane {{ -y, 0 }} "
                   "plane {{ z, 1 }} "
                   "plane {{ -z, 0 }} translate {}*x ",
                   at) +
               glass;
    };
    const auto octahedron = [&](double at) {
        return fmt::format(
                   "intersection {{ #for (I, 0, 7) plane {{ <mod(I, 2) - .5, mod(div(I, 2), 2) - .5, div(I, "
                   "4) - .5>, 1 }} "
                   "#end scale .5 rotate <0, 0, 45> translate {}*x ",
                   at) +
               glass;
    };
    for (const auto& [text, is_named] : std::initializer_list<std::pair<std::string, bool>>{
             {cube(0) + cube(2) + cube(4), false},
             {cube(0) + cube(.5) + cube(.9), true},
             {octahedron(0) + octahedron(3) + octahedron(6), false},
             {octahedron(0) + octahedron(.5) + octahedron(1), true},
             {cube(0) + cube(2) + "plane { y, .5 " + glass + "plane { z, .5 " + glass, true}})
        EXPECT_EQ(said(text).find("of three transparent objects") != std::string::npos, is_named)
            << text << said(text);
    for (const std::string& text :
         {"intersection { sphere { 0, 1 " + glass + " box { 0, 1 } pigment { rgbt 1 } }",
          "sphere { 0, 1 inverse " + glass,
          std::string("sphere { 0, 1 pigment { rgbt 1 } finish { ior 1.2 } interior { ior 1.7 } }")}) {
        EXPECT_NE(said(text).find("`ior` (of a"), std::string::npos) << text << said(text);
    }
    EXPECT_NE(said("sphere { 0, 1 pigment { rgbt 1 } finish { refraction .5 ior 2 } }").find("`refraction`"),
              std::string::npos);
    const std::string prism = "prism { 0, 1, 4, <-9, -9>, <9, -9>, <0, 9>, <-9, -9> translate -.5*y } ";
    EXPECT_NE(said("camera { location 0 look_at z } " + prism + "sphere { 3*z, 1 " + glass)
                  .find("the camera may be inside of this object"),
              std::string::npos);
    EXPECT_EQ(said("camera { location 0 look_at z } " + prism), "");
    const std::string fog = "fog { distance 9 color rgb 1 } ";
    EXPECT_EQ(said(fog + "sphere { 0, 1 " + glass), "");
    EXPECT_EQ(said(fog + "sphere { 0, 1 hollow " + glass), "");
    // The last `ior` of a finish is that of the whole object.
    const Scene balls = povray_scene(
        "union { sphere { 0, 1 finish { ior 1.2 } } sphere { x, 1 finish { ior 1.4 } } sphere { y, 1 } "
        "pigment { rgbt 1 } }");
    for (const Shape& shape : balls.shapes) EXPECT_EQ(balls.materials.at(shape.material).ior, 1.4);
    EXPECT_NE(said(fog + "box { 0, 1 " + glass + "sphere { 0, 1 hollow " + glass).find("hollow objects"),
              std::string::npos);
    EXPECT_NE(said("sphere { 0, 1 pigment { rgbt 1 } interior { ior 0 } }").find("`ior` (of 0 or less)"),
              std::string::npos);
}

TEST(PovRayMissing, TransparentObjectsHaveAnIndexOf1BesideOthersThatRefract) {
    const std::string clear = "sphere { 5*x, 1 pigment { rgbf .5 } }";
    EXPECT_FALSE(povray_scene(clear).materials.at(0).refracts);
    const Scene scene =
        povray_scene(clear + "sphere { 0, 1 pigment { rgbf 1 } interior { ior 1.5 } } sphere { y, 1 }");
    EXPECT_TRUE(scene.materials.at(0).refracts);
    EXPECT_EQ(scene.materials.at(0).ior, 1);
    EXPECT_FALSE(scene.materials.at(2).refracts);
    // An opaque object may be around the camera.
    const Scene wall = povray_scene(clear + "plane { z, 9 interior { ior 1.5 } }");
    EXPECT_TRUE(wall.materials.at(1).refracts);
    EXPECT_FALSE(povray_scene("plane { z, 9 interior { ior 1.5 } }").materials.at(0).refracts);
}

TEST(PovRayMissing, NothingThatIsNamedHidesAnother) {
    // Both an effect and a shape's cut are missing: the cut is an error, whatever follows it.
    const std::string text = said("disc { 0, y, 2 clipped_by { box { -1, 1 } } no_image double_illuminate }");
    EXPECT_NE(text.find("error: glint does not render `clipped_by`"), std::string::npos) << text;
    EXPECT_NE(text.find("`no_image`"), std::string::npos) << text;
    EXPECT_NE(text.find("`double_illuminate`"), std::string::npos) << text;
    const std::string camera = said("camera { fisheye location -3*z normal { bumps .1 } }\nsphere { 0, 1 }");
    EXPECT_NE(camera.find("error: glint does not render `fisheye`"), std::string::npos) << camera;
}

TEST(PovRayMissing, MaterialsAndGroupsOfLights) {
    EXPECT_NE(said("sphere { 0, 1 material { texture { pigment { rgb 1 } } interior_texture { pigment { rgb "
                   "<1, 0, 0> } } } }")
                  .find("`interior_texture`"),
              std::string::npos);
    EXPECT_NE(
        said("light_group { light_source { y, 1 } sphere { 0, 1 } }").find("error: glint does not render"),
        std::string::npos)
        << "its shapes are missing";
}

// Each has an effect only beside another property.
TEST(PovRayMissing, EffectsOfMirrorsAreNamedWhereThereAreSome) {
    const std::string mirror = "plane { y, -1 finish { reflection .3 } }\n";
    EXPECT_EQ(said("sphere { 0, 1 no_reflection }"), "");
    EXPECT_EQ(said(mirror + "sphere { 0, 1 no_reflection off }"), "");
    for (const std::string& text :
         {mirror + "sphere { 0, 1 no_reflection }", "union { sphere { 0, 1 } no_reflection }\n" + mirror}) {
        EXPECT_NE(said(text).find("warning: glint does not render `no_reflection`"), std::string::npos)
            << said(text);
    }
    const std::string keeps = "finish { reflection .3 conserve_energy } }";
    EXPECT_EQ(said("sphere { 0, 1 " + keeps), "");
    EXPECT_EQ(said("sphere { 0, 1 pigment { rgbt <1, 1, 1, .5> } finish { conserve_energy } }"), "");
    EXPECT_EQ(said("sphere { 0, 1 pigment { rgbt <1, 1, 1, .5> } " + keeps), "");
    EXPECT_EQ(said("sphere { 0, 1 finish { reflection x conserve_energy } }"), "");
    const auto in_glass = [&](const std::string& reflection, const std::string& shape = "box { 0, 1 ") {
        return said(shape + "pigment { rgbt 1 } finish { reflection " + reflection +
                    " conserve_energy } interior { ior 1.5 } }");
    };
    for (const char* const right : {"0.1", "{ 0, 1 fresnel }", "{ 0, 0.2 fresnel }"})
        EXPECT_EQ(in_glass(right), "") << right;
    EXPECT_EQ(in_glass("0.9", "sphere { 0, 1 "), "") << "what enters a ball leaves it";
    for (const char* const other : {"0.9", "{ 0.05, 1 }", "{ 0, 0.9 fresnel }"})
        EXPECT_NE(in_glass(other).find("`conserve_energy` (with total reflection in an object)"),
                  std::string::npos)
            << other;
    EXPECT_NE(said("sphere { 0, 1 pigment { rgbt <1, 1, 1, .5> } finish { reflection x conserve_energy } }")
                  .find("`conserve_energy` (of a colored reflection)"),
              std::string::npos);
    EXPECT_NE(said("sphere { 0, 1 texture { pigment { rgb x } } texture { pigment { rgbt <1, 1, 1, .5> } " +
                   keeps + " }")
                  .find("`conserve_energy` (of layered textures)"),
              std::string::npos);
}

// POV-Ray's mirrors of objects within each other differ.
TEST(PovRayMissing, FresnelMirrorsWithinTransparentObjects) {
    const auto ball = [](const std::string& at, const std::string& pigment, const std::string& reflection) {
        return "sphere { " + at + " pigment { " + pigment + " } finish { reflection { " + reflection +
               " } } interior { ior 1.5 } }\n";
    };
    const std::string outer = ball("0, 2", "rgbt .8", ".1"), mirror = "0, 1 fresnel";
    EXPECT_EQ(said(ball("0, 1", "rgb 1", mirror)), "");
    EXPECT_EQ(said(outer + ball("5*x, 1", "rgbt .8", mirror)), "");
    EXPECT_EQ(said(ball("0, 1", "rgb 1", mirror) + ball("x, 1", "rgb 1", mirror)), "");
    EXPECT_EQ(said(outer + ball("0, 1", "rgbt .8", ".1")), "");
    for (const std::string& text :
         {outer + ball("0, 1", "rgbt .8", mirror), outer + ball("0, 1", "rgb 1", mirror),
          ball("0, 2", "rgbt .8", mirror) + ball("0, 1", "rgbt .5", ".1")})
        EXPECT_NE(said(text).find("`fresnel` (of an object within a transparent one)"), std::string::npos)
            << text;
}

TEST(PovRayMissing, TheSecondDiffuseNumberNeedsNoComma) {
    EXPECT_EQ(said("sphere { 0, 1 finish { diffuse 0.8 0 phong 1 } }"), "");
    EXPECT_NE(said("sphere { 0, 1 finish { diffuse 0.8 .3 } }").find("`diffuse`"), std::string::npos);
    EXPECT_NE(said("sphere { 0, 1 finish { diffuse 0.8, .3 } }").find("`diffuse`"), std::string::npos);
}

TEST(PovRayMissing, ParallelLightsThatFade) {
    const std::string light = "light_source { 3*y, 1 parallel point_at 0 fade_distance 2 ";
    EXPECT_NE(said(light + "fade_power 1 }\nsphere { 0, 1 }")
                  .find("2:1: warning: glint does not render `fade_distance` (of a parallel light)"),
              std::string::npos)
        << said(light + "fade_power 1 }\nsphere { 0, 1 }");
    EXPECT_EQ(said(light + "}\nsphere { 0, 1 }"), "");
}

TEST(PovRayMissing, ParallelLightsWithShapesBeyondTheirPlane) {
    const std::string light = "light_source { 3*y, 1 parallel point_at 0 }\nplane { y, -1 }\n";
    EXPECT_EQ(said(light + "sphere { 0, 1 } cylinder { -x, x, 2.9 }"), "");
    for (const char* const shape :
         {"sphere { 2.5*y, 1 }", "cylinder { -x + y, x + y, 2.1 }", "box { 2*y, 1 + 4*y }",
          "cone { 0, 1, 3.1*y, 0 }", "triangle { 0, x, 4*y }", "sphere { 0, 1 scale <1, 4, 1> }",
          "disc { 0, z, 3.2 }"}) {
        EXPECT_NE(said(light + shape).find("2:1: warning: glint does not render `parallel`"),
                  std::string::npos)
            << shape << ": " << said(light + shape);
    }
    EXPECT_EQ(said(light + "sphere { 2.5*y, 1 no_shadow }"), "");
    EXPECT_NE(
        said("camera { location y - z }\nlight_source { -y, 1 parallel point_at 2*y }\nplane { y, -2 }\n"
             "sphere { y, 1 }")
            .size(),
        std::string::npos);
}

// POV-Ray mixes the unit normals of a mesh before its transform, and so do meshes.
TEST(PovRayMissing, NormalsOfAMeshAreMixedBeforeItsTransform) {
    const std::string corners = "smooth_triangle { 0, <-1, -1, 1>, x, <1, -1, 1>, y, <0, 9, 9> }";
    EXPECT_EQ(povray_scene(corners).get<SmoothTriangle>().size(), 1u);
    const std::string text = "mesh { " + corners + " rotate 20 scale 3 }";
    EXPECT_EQ(povray_scene(text).get<SmoothTriangle>().size(), 1u);
    const Scene scene = povray_scene("mesh { " + corners + " scale <1, 1, 4> }");
    ASSERT_EQ(scene.shapes.size(), 1u);
    EXPECT_EQ(scene.shapes[0].kind, ShapeKind::mesh);
    EXPECT_EQ(scene.transforms.at(scene.shapes[0].transform).m[2][2], 4);
    const auto normals = scene.meshes.at(0)->corner_normals(0);
    ASSERT_TRUE(normals);
    EXPECT_NEAR((*normals)[2].z, 0.70710678, 1e-7) << "of length 1, and not transformed";
}

// Faces whose corners differ in more than color: one with two colors is made of strips, one with three of
// small triangles.
TEST(PovRayMissing, FacesOfVeryDifferentColorsAreFine) {
    const auto mesh = [](const std::string& last) {
        return "#default { finish { emission 1 } } mesh2 { vertex_vectors { 3, 0, x, y } texture_list { 3, "
               "texture { pigment { rgb 0 } }, texture { pigment { rgb 0 } }, texture { " +
               last + " } } face_indices { 1, <0, 1, 2>, 0, 1, 2 } }";
    };
    const Scene scene = povray_scene(mesh("pigment { rgb 1 }"));
    EXPECT_EQ(scene.shapes.size(), 2u * 171 - 1);
    double area = 0;
    for (const Shape& shape : scene.shapes) {
        const Triangle& t = scene.get<Triangle>().at(shape.index);
        area += length(cross(t.vertices[1] - t.vertices[0], t.vertices[2] - t.vertices[0])) / 2;
        const double middle = (t.vertices[0].y + t.vertices[1].y + t.vertices[2].y) / 3;
        EXPECT_NEAR(scene.materials.at(shape.material).color.r, middle, 1.0 / 300);
    }
    EXPECT_NEAR(area, 0.5, k_pov_near);
    EXPECT_NE(said(mesh("pigment { rgb 1 } finish { phong 1 }")).find("`texture_list`"), std::string::npos);
}

TEST(PovRayMissing, NamesOfArraysOfTexturesAndLights) {
    const Scene scene = povray_scene(
        "#declare T = array[1][2] { { texture { pigment { rgb <1, 0, 0> } }, texture { pigment { rgb <0, 1, "
        "0> } } } }\n"
        "#declare F = array[1] { finish { phong .5 } }\n#declare P = array[1] { pigment { rgb <0, 0, 1> } }\n"
        "#declare C = array[1] { rgb <1, 1, 0> }\n#declare L = light_source { 5*y, rgb 2 }\n"
        "sphere { 0, 1 texture { T[0][1] finish { F[0] } } } sphere { x, 1 pigment { P[0] } }\n"
        "sphere { y, 1 pigment { C[0]*.5 } } light_source { L translate x }\n");
    ASSERT_EQ(scene.materials.size(), 3u);
    EXPECT_EQ(scene.materials[0].color, (Color{0, 1, 0}));
    EXPECT_EQ(scene.materials[0].phong, (Color{.5, .5, .5}));
    EXPECT_EQ(scene.materials[1].color, (Color{0, 0, 1}));
    EXPECT_EQ(scene.materials[2].color, (Color{.5, .5, 0}));
    EXPECT_EQ(scene.lights.at(1).position, (Vec3{1, 5, 0}));
    EXPECT_EQ(scene.lights.at(1).color, (Color{2, 2, 2}));
}

TEST(PovRayMissing, UnusualCamerasAndSpots) {
    const Scene scene = povray_scene("camera { location 9*y look_at 0 right 2*x } sphere { 0, 1 }");
    ASSERT_TRUE(scene.camera.frame);
    expect_vec(scene.camera.frame->right, {2, 0, 0});
    expect_vec(scene.camera.frame->up, {0, 0, 1});
    const Scene spot =
        povray_scene("light_source { 5*y, 1 spotlight point_at 0 radius 20 falloff 1 } sphere { 0, 1 }");
    EXPECT_EQ(spot.lights.at(1).inner_angle, 20) << "as VTK writes it: the radius counts";
    EXPECT_EQ(spot.lights.at(1).outer_angle, 20);
    const std::string camera = said("camera { cylinder 3 angle 200 location 9*y }\nsphere { 0, 1 }");
    EXPECT_NE(camera.find("2:10: error: glint does not render `cylinder`"), std::string::npos) << camera;
    EXPECT_EQ(camera.find("expected"), std::string::npos) << camera;
}

// Jmol cuts shapes by the box of the picture: what is not seen is drawn whole, the rest is cut. A disc, which
// has no inside, cannot be cut.
TEST(PovRayMissing, CutsOutsideThePictureAreNone) {
    const std::string camera =
        "camera { orthographic location <2, 1, -5> look_at <2, 1, 0> right 4*x up 2*y }\n";
    const std::string inside = "clipped_by { box { 0, <4, 2, 99> } } ";
    for (const std::string kind : {"sphere { <0, 1, 3>, 1 ", "disc { <0, 1, 3>, y, 1 "})
        EXPECT_EQ(said(camera + kind + inside + "no_shadow }"), "") << kind;
    EXPECT_EQ(povray_scene(camera + "sphere { <0, 1, 3>, 1 " + inside + "no_shadow }").shapes.at(0).kind,
              ShapeKind::sphere);
    const std::string seen = "error: glint does not render `clipped_by`";
    for (const std::string& items : {
             "<0, 1, 3>, 1 " + inside + "}",  // its shadow is seen
             std::string("<4, 1, 3>, 1 clipped_by { box { 0, <3.9, 2, 99> } } no_shadow }"),
             std::string("<0, 1, 3>, 1 clipped_by { box { 0, <4, 2, 3> } } no_shadow }"),
             "<0, 1, 3>, 1 " + inside + "no_shadow translate x }",
             "<0, 1, 3>, 1 " + inside + "no_shadow } translate x }",
             "<0, 1, 3>, 1 " + inside + "no_shadow finish { reflection .5 } }",
             "<0, 1, 3>, 1 } " + inside + "no_shadow }",
         }) {
        const bool is_group =
            std::count(items.begin(), items.end(), '}') > std::count(items.begin(), items.end(), '{') + 1;
        const auto shape = [&](std::string of, const char* normal) {
            of.insert(of.find("3>,") + 3, normal);
            return of;
        };
        const std::string ball = (is_group ? "union { sphere { " : "sphere { ") + items,
                          disc = (is_group ? "union { disc { " : "disc { ") + shape(items, " y,");
        EXPECT_NE(said(camera + disc).find(seen), std::string::npos) << disc << said(camera + disc);
        EXPECT_EQ(said(camera + ball), "") << ball;
        EXPECT_EQ(povray_scene(camera + ball).shapes.at(0).kind, ShapeKind::solid) << ball;
    }
    // Of two cuts, one is seen.
    EXPECT_EQ(povray_scene(camera + "sphere { <0, 1, 3>, 1 clipped_by { plane { -z, -3 } } " + inside +
                           "no_shadow }")
                  .shapes.at(0)
                  .kind,
              ShapeKind::solid);
    // A shape that is not there is not cut, and neither is the next one.
    const auto shapes = povray_scene(camera +
                                     "sphere { <0, 1, 3>, 0 clipped_by { box { 0, <4, 2, 2> } } "
                                     "no_shadow } sphere { <2, 1, 3>, 1 }")
                            .shapes;
    ASSERT_EQ(shapes.size(), 1u);
    EXPECT_EQ(shapes[0].kind, ShapeKind::sphere);
    const std::string perspective = "camera { location <2, 1, -5> look_at <2, 1, 0> right 4*x up 2*y }\n";
    EXPECT_EQ(povray_scene(perspective + "sphere { <0, 1, 3>, 1 " + inside + "no_shadow }").shapes.at(0).kind,
              ShapeKind::solid)
        << "perspective shows more at this depth";
}

TEST(PovRayMissing, DeclarationsOfOtherKinds) {
    EXPECT_EQ(said("#declare deprecated once \"old\" R = 2;\n#declare M = media { emission 1 }\n"
                   "default { finish { ambient 1 } }\nsphere { 0, R }"),
              "");
}

}  // namespace
}  // namespace glint::test
