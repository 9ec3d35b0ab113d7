// SPDX-License-Identifier: Apache-2.0
// POV-Ray's language: directives, macros, expressions, objects, the camera, and what is refused.
#include "formats/mistakes.h"
#include "formats/povray_text.h"

namespace glint::test {
namespace {

// The radius of the first sphere: how the tests below see the value of an expression.
double value_of(const std::string& expression, const std::string& before = {}) {
    const Scene scene = povray_scene(before + "\nsphere { 0, 10 + (" + expression + ") }");
    EXPECT_EQ(scene.get<Sphere>().size(), 1u) << expression;
    return scene.get<Sphere>().empty() ? -99 : scene.get<Sphere>()[0].radius - 10;
}

TEST(PovRay, ExpressionsHaveItsPrecedenceAndPromotion) {
    EXPECT_NEAR(value_of("1 + 2*3 - 4/8"), 6.5, k_pov_near);
    EXPECT_NEAR(value_of("-2*-3"), 6, k_pov_near);
    EXPECT_NEAR(value_of("(<1, 2, 3>*2).y"), 4, k_pov_near);
    EXPECT_NEAR(value_of("(x + 2*y).y"), 2, k_pov_near);
    EXPECT_NEAR(value_of("(2 < 3) & (3 != 4)"), 1, k_pov_near);
    EXPECT_NEAR(value_of("1 > 2 ? 5 : 7"), 7, k_pov_near);
    EXPECT_NEAR(value_of("!true"), 0, k_pov_near);
    EXPECT_NEAR(value_of("<.9 .8 .7>.z"), .7, k_pov_near) << "commas are optional";
    EXPECT_NEAR(value_of("(rgb <.1, .2, .3>).green"), .2, k_pov_near);
    EXPECT_NEAR(value_of("V.v", "#declare V = <1, 5>;"), 5, k_pov_near);
}

TEST(PovRay, FunctionsComputeAsDocumented) {
    EXPECT_NEAR(value_of("sqrt(9) + abs(-2) + int(-2.5) + floor(-2.5) + ceil(1.2)"), 2, k_pov_near);
    EXPECT_NEAR(value_of("sin(pi/6)"), 0.5, k_pov_near);
    EXPECT_NEAR(value_of("degrees(atan2(1, 1))"), 45, 1e-9);
    EXPECT_NEAR(value_of("min(3, 1, 2) + max(3, 1, 2)"), 4, k_pov_near);
    EXPECT_NEAR(value_of("mod(7, 3) + div(7, 3)"), 3, k_pov_near);
    EXPECT_NEAR(value_of("mod(1, 0.1)"), 0.1, k_pov_near);  // 0.1 is a little more than a tenth
    EXPECT_EQ(value_of("mod(-7.5, 2)"), -1.5);
    EXPECT_EQ(value_of("strcmp(str(mod(-6, 2), 0, 2), \"-0.00\")"), 0);
    EXPECT_NEAR(value_of("vlength(<3, 4, 0>)"), 5, k_pov_near);
    EXPECT_NEAR(value_of("vdot(vcross(x, y), z)"), 1, k_pov_near);
    EXPECT_NEAR(value_of("vrotate(x, 90*z).y"), 1, k_pov_near);
    EXPECT_NEAR(value_of("vaxis_rotate(y, x, 90).z"), 1, k_pov_near);
    EXPECT_NEAR(value_of("select(-1, 5, 6, 7)"), 5, k_pov_near);
    EXPECT_NEAR(value_of("strlen(concat(\"ab\", str(1.5, 0, 2)))"), 6, k_pov_near);
    EXPECT_NEAR(value_of("val(\"2.5\")"), 2.5, k_pov_near);
    EXPECT_NEAR(value_of("pow(2, -1)"), 0.5, k_pov_near);
}

TEST(PovRay, CommentsNest) {
    EXPECT_NEAR(value_of("3 /* a /* b */ c */ + 1 // d"
                         "\n"),
                4, k_pov_near);
}

TEST(PovRay, ConditionsAndLoopsMayStandAnywhere) {
    EXPECT_NEAR(value_of("#if (1 > 2) 5 #else 6 #end"), 6, k_pov_near);
    EXPECT_NEAR(value_of("#ifdef (Q) 5 #elseif (1) 7 #else 6 #end"), 7, k_pov_near);
    EXPECT_NEAR(value_of("S",
                         "#declare S = 0; #declare I = 0;\n"
                         "#while (I < 4) #declare S = S + I; #declare I = I + 1; #end"),
                6, k_pov_near);
    EXPECT_NEAR(
        value_of("S", "#declare S = 0; #for (I, 1, 9, 2) #declare S = S + I; #if (I > 4) #break #end #end"),
        9, k_pov_near);
    EXPECT_NEAR(value_of("S",
                         "#switch (3) #case (1) #declare S = 1; #break #range (2, 4) #declare S = 2; #break "
                         "#else #declare S = 3; #end"),
                2, k_pov_near);
    const Scene scene = povray_scene("cylinder { 0, y, 1 #if (yes) open #end pigment { rgb 1 } }");
    EXPECT_FALSE(scene.get<Cylinder>().at(0).caps);
}

TEST(PovRay, MacrosAreParsedAtTheirCallsWithArgumentsByReference) {
    EXPECT_NEAR(value_of("A", "#macro Add(V) #declare V = V + .5; #end #declare A = 1; Add(A)"), 1.5,
                k_pov_near);
    EXPECT_NEAR(value_of("A", "#macro Set(V) #local V = 5; #end #declare A = 1; Set(A)"), 5, k_pov_near)
        << "a parameter stands for the identifier";
    EXPECT_NEAR(value_of("A", "#macro Set(V) #local V = 5; #end #declare A = 1; Set((A))"), 1, k_pov_near);
    EXPECT_NEAR(value_of("Twice(3) + 1", "#macro Twice(V) V*2 #end"), 7, k_pov_near);
    EXPECT_NEAR(value_of("G", "#declare G = 1; #macro M() #local G = 2; #declare G = 3; #end M()"), 1,
                k_pov_near)
        << "#declare changes the local identifier";
    EXPECT_NEAR(value_of("F(5)", "#macro F(N) #if (N < 2) 1 #else N*F(N - 1) #end #end"), 120, k_pov_near);
    // A macro that is never called may hold anything.
    EXPECT_NEAR(value_of("1", "#macro Never() pigment { average pigment_map { [1 foo] } } #end"), 1,
                k_pov_near);
    // The comma between two arguments may be missing.
    EXPECT_NEAR(value_of("P(<1, 2, 3>4)", "#macro P(V, R) V.y*R #end"), 8, k_pov_near);
}

TEST(PovRay, ArraysHoldValuesOfAllKinds) {
    EXPECT_NEAR(value_of("A[1] + A[2]", "#declare A = array[3] {1, 2, 3};"), 5, k_pov_near);
    EXPECT_NEAR(value_of("A[1][0]", "#declare A = array[2][2] {{1, 2}, {3, 4}}"), 3, k_pov_near);
    EXPECT_NEAR(value_of("A[0]", "#declare A = array[2]; #declare A[0] = 7;"), 7, k_pov_near);
    EXPECT_NEAR(value_of("dimension_size(A, 1)", "#declare A = array[4]"), 4, k_pov_near);
    const Scene scene =
        povray_scene("#declare A = array[2] {sphere { 0, 1 }, box { 0, 1 }}\nobject { A[1] }");
    EXPECT_EQ(scene.get<Box>().size(), 1u);
}

TEST(PovRay, IncludesAreReadOnceBesideTheTextOrFromItsTable) {
    TextSources sources(
        std::map<std::string, std::string, std::less<>>{{"part.inc", "#declare R = 2;\n#local Hidden = 3;"}});
    const Scene scene = povray_scene(
        "#include \"part.inc\"\n#ifdef (Hidden) #error \"seen\" #end\nsphere { 0, R }", &sources);
    EXPECT_EQ(scene.get<Sphere>().at(0).radius, 2);
    const Scene named =
        povray_scene("#include \"colors.inc\"\nsphere { 0, 1 pigment { color SteelBlue*.5 } }");
    EXPECT_NEAR(named.materials.at(0).color.g, 0.419608 / 2, k_pov_near);
}

// The numbers are those of POV-Ray's #debug.
TEST(PovRay, ColorsIncHasItsMacrosOfHues) {
    const auto color = [](const std::string& value) {
        const Scene scene = povray_scene("#include \"colors.inc\"\n#declare C = " + value +
                                         ";\nsphere { <C.red, C.green, C.blue>, 1 translate <0, 0, 0> }");
        return scene.get<Sphere>().at(0).center;
    };
    const auto expect = [](Vec3 found, Vec3 wanted) {
        EXPECT_NEAR(found.x, wanted.x, 1e-5);
        EXPECT_NEAR(found.y, wanted.y, 1e-6);
        EXPECT_NEAR(found.z, wanted.z, 1e-6);
    };
    expect(color("CRGB2HSL(rgb <0.2, 0.5, 0.8>)"), {210, 0.6, 0.5});
    expect(color("CRGB2HSV(rgb <0.2, 0.5, 0.8>)"), {210, 0.75, 0.8});
    expect(color("CRGB2HSL(rgb <0.9, 0.1, 0.3>)"), {-15, 0.8, 0.5});
    expect(color("CRGB2HSL(<0.3, 0.9, 0.2>)"), {111.4285736, 0.7777777, 0.55});
    expect(color("CRGB2HSV(rgb 0)"), {0, 0, 0});
    expect(color("CRGB2HSL(rgb 1)"), {0, 0, 1});
    expect(color("CHSL2RGB(<200, 0.7, 0.8>)"), {0.66, 0.8466667, 0.94});
    expect(color("CHSV2RGB(<359, 1, 1>)"), {1, 0, 0.0166667});
    expect(color("CHSL2RGB(<-400, 0.5, 0.5>)"), {0.75, 0.25, 0.5833333});
    expect(color("rgb CH2RGB(800)"), {0.6666667, 1, 0});
    expect(color("rgb CRGB2H(rgb <0.2, 0.5, 0.8>, 0.8, 0.6)"), {210, 210, 210});
    const Scene scene = povray_scene(
        "#include \"colors.inc\"\nsphere { 0, 1 pigment { color CHSV2RGB(<60, 0.3, 0.7, 0.2, 0.4>) } }");
    EXPECT_EQ(scene.materials.at(0).filter, 0.2);
    EXPECT_EQ(scene.materials[0].transmit, 0.4);
    EXPECT_NEAR(scene.materials[0].color.b, 0.49, k_pov_near);
}

TEST(PovRay, ShapesHaveTheirParameters) {
    const Scene scene = povray_scene(
        "sphere { <1, 2, 3>, 4 }\n"
        "cylinder { 0, 2*y, .5 }\n"
        "cone { 0, 1, y, .5 open }\n"
        "cone { 0, 1, y, 1 }\n"
        "box { <1, -1, 1>, <-1, 1, -1> }\n"
        "plane { <0, 0, -3>, 3 }\n"
        "disc { 0, z, 2 }\n"
        "triangle { 0, x, y }\n"
        "smooth_triangle { 0, z, x, z, y, z }\n"
        "torus { 2, .5 sturm translate 3*x }\n"
        "torus { 2, 3 scale <1, 2, 1> }\n"
        "disc { 0, y, -2, -.5 }\n"
        "disc { 0, y, 1, 1.5 }\n"
        "torus { 1, 0 }\n");
    ASSERT_EQ(scene.get<Torus>().size(), 2u) << "without a tube, nothing is seen";
    EXPECT_EQ(scene.get<Torus>()[0].center, (Vec3{3, 0, 0}));
    EXPECT_EQ(scene.get<Torus>()[0].axis, (Vec3{0, 1, 0}));
    EXPECT_EQ(scene.get<Torus>()[0].radius, 2);
    EXPECT_EQ(scene.get<Torus>()[0].tube, 0.5);
    EXPECT_EQ(scene.get<Torus>()[1].tube, 3);
    ASSERT_EQ(scene.get<Disc>().size(), 2u) << "and nothing of a disc that is all hole";
    EXPECT_EQ(scene.get<Disc>()[0].hole, 0);
    EXPECT_EQ(scene.get<Disc>()[1].radius, 2);
    EXPECT_EQ(scene.get<Disc>()[1].hole, 0.5);
    EXPECT_EQ(scene.get<Sphere>().at(0).center, (Vec3{1, 2, 3}));
    EXPECT_TRUE(scene.get<Cylinder>().at(0).caps);
    EXPECT_EQ(scene.get<Cylinder>().at(1).radius, 1) << "a cone of equal radii";
    EXPECT_FALSE(scene.get<Cone>().at(0).caps);
    EXPECT_EQ(scene.get<Box>().at(0).min, (Vec3{-1, -1, -1}));
    EXPECT_EQ(scene.get<Plane>().at(0).point, (Vec3{0, 0, -3})) << "a true distance along the unit normal";
    EXPECT_EQ(scene.get<Disc>().at(0).radius, 2);
    EXPECT_EQ(scene.get<Triangle>().at(0).vertices[2], (Vec3{0, 1, 0}));
    EXPECT_EQ(scene.get<SmoothTriangle>().at(0).normals[1], (Vec3{0, 0, 1}));
    EXPECT_EQ(scene.shape_texts.place(1).line, 3u);
}

TEST(PovRay, QuarticsCubicsAndPolysHaveTheSameTerms) {
    const auto coefficients = [](const std::string& text) {
        std::map<std::string_view, double> found;
        const Scene scene = povray_scene(text);
        for (std::size_t i = 0; i < std::size(k_quartic_terms); ++i) {
            const double c = scene.get<Quartic>().at(0).coefficients[i];
            if (c != 0) found[k_quartic_terms[i]] = c;
        }
        return found;
    };
    using Terms = std::map<std::string_view, double>;
    const auto list = [](int count) {
        std::string text = "<1";
        for (int i = 2; i <= count; ++i) text += ", " + std::to_string(i);
        return text + "> pigment { rgb 1 } }";
    };
    const Terms all = coefficients("quartic { " + list(35));
    ASSERT_EQ(all.size(), 35u);
    for (std::size_t i = 0; i < 35; ++i) EXPECT_EQ(all.at(k_quartic_terms[i]), static_cast<double>(i + 1));
    EXPECT_EQ(coefficients("poly { 4, " + list(35)), all);
    const Terms cubic = coefficients("cubic { " + list(20));
    EXPECT_EQ(cubic, (Terms{{"x3", 1},  {"x2y", 2},  {"x2z", 3}, {"x2", 4},   {"xy2", 5},
                            {"xyz", 6}, {"xy", 7},   {"xz2", 8}, {"xz", 9},   {"x", 10},
                            {"y3", 11}, {"y2z", 12}, {"y2", 13}, {"yz2", 14}, {"yz", 15},
                            {"y", 16},  {"z3", 17},  {"z2", 18}, {"z", 19},   {"constant", 20}}));
    EXPECT_EQ(coefficients("poly { 3 " + list(20)), cubic);
    EXPECT_EQ(coefficients("poly { 2, " + list(10)), (Terms{{"x2", 1},
                                                            {"xy", 2},
                                                            {"xz", 3},
                                                            {"x", 4},
                                                            {"y2", 5},
                                                            {"yz", 6},
                                                            {"y", 7},
                                                            {"z2", 8},
                                                            {"z", 9},
                                                            {"constant", 10}}));
    for (const std::string& text : {"quartic { " + list(34), "cubic { " + list(21), "poly { 1, " + list(4),
                                    std::string("poly { 36, <1> }"), std::string("poly { 5, <1, 2> }"),
                                    std::string("poly { 2, <0, 0, 0, 0, 0, 0, 0, 0, 0, 1> }")})
        EXPECT_FALSE(read_povray(text).ok()) << text;
}

TEST(PovRay, TransformsAreAppliedInTheOrderWritten) {
    const Scene scene = povray_scene(
        "sphere { x, 1 scale 2 rotate 90*z translate <0, 0, 5> }\n"
        "sphere { 0, 1 scale <1, 2, 1> }\n"
        "#declare T = transform { translate x }\n"
        "union { sphere { 0, 1 translate y } transform { T } scale 3 }\n"
        "sphere { x, 1 matrix <0, 1, 0, -1, 0, 0, 0, 0, 1, 0, 0, 7> }\n");
    expect_vec(scene.get<Sphere>().at(0).center, {0, 2, 5});
    EXPECT_NEAR(scene.get<Sphere>().at(0).radius, 2, k_pov_near);
    EXPECT_EQ(scene.shapes.at(0).transform, k_none);
    EXPECT_NE(scene.shapes.at(1).transform, k_none) << "an ellipsoid";
    expect_vec(scene.get<Sphere>().at(2).center, {3, 3, 0});
    expect_vec(scene.get<Sphere>().at(3).center, {0, 1, 7});
}

TEST(PovRay, TexturesAreInheritedAndChangedItemByItem) {
    const Scene scene = povray_scene(
        "#declare T = texture { pigment { rgb <1, 0, 0> } finish { ambient .3 diffuse .5 phong .7 phong_size "
        "9 } }\n"
        "sphere { 0, 1 texture { T finish { ambient .6 } } }\n"
        "union { sphere { 0, 1 } sphere { 0, 2 pigment { rgb <0, 0, 1> } } texture { T } no_shadow }\n"
        "#default { finish { diffuse .9 } }\n"
        "sphere { 0, 3 pigment { color rgb 1 } }\n");
    const auto material = [&](std::size_t i) { return scene.materials.at(scene.shapes.at(i).material); };
    EXPECT_NEAR(material(0).ambient.r, .6, k_pov_near);
    EXPECT_NEAR(material(0).diffuse.r, .5, k_pov_near);
    EXPECT_NEAR(material(0).phong.r, .7, k_pov_near);
    EXPECT_EQ(material(0).phong_shininess, 9);
    EXPECT_EQ(material(1).diffuse.r, .5);
    EXPECT_FALSE(material(1).casts_shadow);
    EXPECT_NEAR(material(2).color.b, 1, k_pov_near);
    EXPECT_NEAR(material(2).diffuse.b, .6, k_pov_near) << "its own texture has POV-Ray's default finish";
    EXPECT_NEAR(material(3).diffuse.r, .9, k_pov_near);
    EXPECT_NEAR(material(3).ambient.r, .1, k_pov_near);
}

TEST(PovRay, FinishesHaveBothHighlightsAndMetals) {
    const Scene scene = povray_scene(
        "sphere { 0, 1 pigment { rgb <1, .5, 0> } finish { emission .2 phong .3 phong_size 7 specular .4 "
        "roughness .02\n"
        "  metallic brilliance 3 reflection { .1, .5 falloff 2 metallic .5 } } }\n"
        "sphere { 0, 2 finish { phong -1 reflection .25 } }");
    const Material &a = scene.materials.at(0), &b = scene.materials.at(1);
    EXPECT_NEAR(a.emission.g, .1, k_pov_near);
    EXPECT_EQ(a.phong, (Color{.3, .3, .3}));
    EXPECT_EQ(a.phong_shininess, 7);
    EXPECT_EQ(a.specular, (Color{.4, .4, .4}));
    EXPECT_NEAR(a.shininess, 50, k_pov_near);
    EXPECT_EQ(a.metallic, 1);
    EXPECT_EQ(a.brilliance, 3);
    EXPECT_EQ(a.mirror_min, .1);
    EXPECT_EQ(a.mirror, .5);
    EXPECT_EQ(a.mirror_falloff, 2);
    EXPECT_EQ(a.mirror_metallic, .5);
    const Scene glass = povray_scene("sphere { 0, 1 pigment { color rgb .5 filter .2 transmit .3 } }");
    EXPECT_EQ(glass.materials.at(0).filter, .2);
    EXPECT_EQ(glass.materials.at(0).transmit, .3);
    EXPECT_EQ(glass.conventions.opacity, OpacityRule::brightest);
    EXPECT_EQ(povray_scene("#version 3.7;\nsphere { 0, 1 }").conventions.opacity, OpacityRule::whole);
    EXPECT_EQ(b.phong, (Color{0, 0, 0})) << "a phong below 0 is none";
    EXPECT_EQ(b.mirror, .25);
    EXPECT_EQ(b.mirror_falloff, 0);
}

TEST(PovRay, FresnelMirrors) {
    const auto mirror = [](const std::string& finish) {
        const Scene scene = povray_scene("sphere { 0, 1 pigment { rgbt <1, 1, 1, .5> } finish { " + finish +
                                         " } interior { ior 1.5 } }");
        return scene.materials.at(0);
    };
    // One value is the greatest.
    EXPECT_EQ(mirror("reflection { .5 fresnel }").mirror_min, 0);
    const Material two = mirror("reflection { .2, .5 fresnel falloff 3 } conserve_energy");
    EXPECT_TRUE(two.mirror_fresnel && two.conserve_energy);
    EXPECT_EQ(two.mirror_min, .2);
    EXPECT_EQ(two.mirror, .5);
    EXPECT_EQ(two.ior, 1.5);
    EXPECT_FALSE(mirror("reflection { .5 fresnel off }").mirror_fresnel);
    // A later reflection keeps the word, but its one value is both the least and the greatest.
    EXPECT_FALSE(mirror("reflection { .2, .5 fresnel } reflection .3").mirror_fresnel);
    EXPECT_TRUE(mirror("reflection { .2, .5 fresnel } reflection { .1, .3 }").mirror_fresnel);
    EXPECT_FALSE(mirror("conserve_energy").conserve_energy);
    // An opaque mirror keeps its index.
    EXPECT_EQ(povray_scene("sphere { 0, 1 finish { reflection { .5 fresnel } } interior { ior 2 } }")
                  .materials.at(0)
                  .ior,
              2);
}

TEST(PovRay, AnIncludeIsReadBeforeWhatFollowsIt) {
    TextSources sources(std::map<std::string, std::string, std::less<>>{
        {"b.inc", "sphere { <1, 2, 3>, 1 }\n#declare R = 4;"}});
    for (const char* const end : {"", ";", " ;"}) {
        const Scene scene =
            povray_scene(std::string("#include \"b.inc\"") + end + "\nsphere { 0, R }", &sources);
        ASSERT_EQ(scene.get<Sphere>().size(), 2u);
        EXPECT_EQ(scene.get<Sphere>()[0].radius, 1);
        EXPECT_EQ(scene.get<Sphere>()[1].radius, 4);
    }
}

TEST(PovRay, TheCameraIsLeftHandedAndAppliedAtItsEnd) {
    Scene scene = povray_scene("camera { look_at <0, 0, 5> location <0, 0, -5> angle 90 }\nsphere { 0, 1 }");
    ASSERT_TRUE(scene.camera.frame);
    expect_vec(scene.camera.frame->right, {1.33, 0, 0});
    expect_vec(scene.camera.frame->up, {0, 1, 0});
    expect_vec(scene.camera.frame->forward, {0, 0, 1.33 / 2});
    scene = povray_scene("camera { right -x*2 look_at <0, 0, 1> }\nsphere { 0, 1 }");
    expect_vec(scene.camera.frame->right, {-2, 0, 0});
    scene = povray_scene("camera { orthographic location <0, 0, -5> look_at 0 }\nsphere { 0, 1 }");
    EXPECT_EQ(scene.camera.projection, Projection::orthographic);
    EXPECT_NEAR(scene.camera.frame->right.x, 5 * 1.33, k_pov_near);
    scene = povray_scene("sphere { 0, 1 }");
    expect_vec(scene.camera.frame->forward, {0, 0, 1});
}

TEST(PovRay, SmoothTrianglesWithNormalsOnBothSidesAreLeftOut) {
    const std::string triangle = "smooth_triangle { 0, -z, x, -z, y, ";
    EXPECT_EQ(povray_scene(triangle + "<.5, 0, -.1> }").get<SmoothTriangle>().size(), 1u);
    const std::string text = "sphere { 0, 1 } " + triangle + "<.5, 0, .1> }";
    EXPECT_EQ(povray_scene(text).get<SmoothTriangle>().size(), 0u);
    EXPECT_NE(messages(read_povray(text)).find("warning: normals on both sides of a smooth triangle"),
              std::string::npos);
}

TEST(PovRay, FogOnTheGround) {
    const Scene scene = povray_scene(
        "fog { fog_type 2 distance 4 rgb .5 fog_offset 2 fog_alt 3 up 2*x rotate 90*z translate 5 }\nsphere "
        "{ 0, 1 }");
    ASSERT_TRUE(scene.fog);
    EXPECT_EQ(read_povray("fog { distance 4 rgbft <.5, .5, .5, .3, .2> }\nsphere { 0, 1 }")->fog->filter, .3);
    EXPECT_EQ(scene.fog->density, .25);
    EXPECT_EQ(scene.fog->falloff, 3);
    EXPECT_EQ(scene.fog->height, 2);
    EXPECT_NEAR(scene.fog->up.x, 0, 1e-15);
    EXPECT_EQ(scene.fog->up.y, 2);
    const Scene even = povray_scene(
        "fog { fog_type 2 fog_type 1 distance 4 rgb .5 fog_offset 2 fog_alt 3 up x }\nsphere { 0, 1 }");
    EXPECT_EQ(*even.fog, (Fog{FogKind::exp, {.5, .5, .5}, .25, 0}));
    const Result<Scene> sharp =
        read_povray("fog { fog_type 2 distance 4 rgb .5 fog_offset 2 }\nsphere { 0, 1 }");
    EXPECT_NE(messages(sharp).find("`fog_alt` (that is not above 0"), std::string::npos) << messages(sharp);
}

TEST(PovRay, LightsFogAndBackground) {
    const Scene scene = povray_scene(
        "light_source { x, rgb <1, .5, .25>*2 spotlight point_at 3*x radius 10 falloff 20 tightness 2 "
        "shadowless }\n"
        "light_source { 5*y, 1 parallel point_at 0 }\n"
        "background { color rgb <.1, .2, .3> }\n"
        "fog { distance 4 rgb .5 }\n"
        "global_settings { ambient_light rgb 2 max_trace_level 3 }\nsphere { 0, 1 }");
    ASSERT_EQ(scene.lights.size(), 4u);
    EXPECT_EQ(scene.lights[1].kind, LightKind::spot);
    EXPECT_EQ(scene.lights[1].axis, (Vec3{2, 0, 0}));
    EXPECT_EQ(scene.lights[1].outer_angle, 20);
    EXPECT_EQ(scene.lights[1].color, (Color{2, 1, .5}));
    EXPECT_FALSE(scene.lights[1].casts_shadows);
    EXPECT_EQ(scene.lights[1].specular_color, (Color{0, 0, 0})) << "no highlights, either";
    EXPECT_EQ(scene.lights[2].specular_color, (Color{1, 1, 1}));
    EXPECT_EQ(scene.lights[2].kind, LightKind::directional);
    EXPECT_EQ(scene.lights[2].to_light, (Vec3{0, 5, 0}));
    EXPECT_EQ(scene.lights[3].color, (Color{2, 2, 2}));
    EXPECT_EQ(scene.background, (Color{.1, .2, .3}));
    ASSERT_TRUE(scene.fog);
    EXPECT_EQ(scene.fog->density, .25);
    EXPECT_EQ(scene.settings.reflections, 2);
    EXPECT_EQ(scene.profile, "povray");
}

// The interior of each shape in fog: its number, or -1 if it is hollow.
std::vector<std::int32_t> interiors_of(const std::string& text) {
    const Result<Scene> scene =
        read_povray("fog { distance 4 rgb .5 } #default { pigment { rgbt <1, 0, 0, .5> } }\n" + text);
    EXPECT_TRUE(scene) << messages(scene);
    EXPECT_EQ(messages(scene).find("fog"), std::string::npos) << messages(scene);
    std::vector<std::int32_t> list;
    if (!scene) return list;
    EXPECT_EQ(scene->conventions.fog_extent, FogExtent::outside_objects);
    for (const Shape& shape : scene->shapes) {
        const Material& m = scene->materials.at(shape.material);
        list.push_back(m.hollow ? -1 : m.interior);
    }
    return list;
}

TEST(PovRay, ObjectsHaveInteriors) {
    using List = std::vector<std::int32_t>;
    const std::string two = "sphere { x, 1 } sphere { 2*x, 1 } ",
                      mesh = "mesh { triangle { x, y, z } triangle { x, y, 0 } } ";
    EXPECT_EQ(interiors_of(two), (List{0, 0}));
    EXPECT_EQ(interiors_of("sphere { x, 1 hollow } sphere { x, 1 hollow off }"), (List{-1, 0}));
    EXPECT_EQ(interiors_of(mesh + mesh), (List{1, 2}));
    EXPECT_EQ(interiors_of("triangle { x, y, z } " + mesh + "triangle { x, y, z }"), (List{0, 1, 0}));
    EXPECT_EQ(interiors_of("union { " + two + "} union { " + two + "hollow }"), (List{1, 1, -1, -1}));
    EXPECT_EQ(interiors_of("union { union { " + two + "} " + mesh + "}"), (List{1, 1, 1}));
    EXPECT_EQ(interiors_of("union { union { " + two + "} " + mesh + " interior { ior 1 } }"),
              (List{1, 1, 1}));
    EXPECT_EQ(interiors_of("union { sphere { x, 1 interior { ior 1 } } " + two + "}"), (List{0, 1, 1}));
    EXPECT_EQ(interiors_of("union { union { " + two + "interior { ior 1 } } " + two + "}"),
              (List{2, 2, 1, 1}));
    EXPECT_EQ(interiors_of("union { sphere { x, 1 hollow } sphere { x, 1 hollow interior { ior 1 } } }"),
              (List{1, -1}));
    EXPECT_EQ(interiors_of("#declare O = sphere { x, 1 hollow } object { O } object { O hollow off }"),
              (List{-1, 0}));
    // Of opaque surfaces, only `hollow` counts.
    EXPECT_EQ(interiors_of("union { " + two + "pigment { rgb 1 } } sphere { 0, 9 pigment { rgb 1 } hollow }"),
              (List{0, 0, -1}));
    // Materials are shared as before where there is no fog.
    const Scene clear =
        povray_scene("#default { pigment { rgbt .5 } }\nunion { " + two + "} union { " + two + "hollow }");
    EXPECT_EQ(clear.materials.size(), 1u);
    EXPECT_EQ(clear.materials[0].interior, 0);
}

TEST(PovRay, AreaLightsShineFromTheirCentre) {
    const Scene scene = povray_scene(
        "light_source { 0, rgb 1 area_light <2, 0, 0>, <0, 3, 0>, 5, 4 adaptive 1 jitter rotate 90*z }\n"
        "sphere { 0, 1 }");
    const Light& light = scene.lights.at(1);
    EXPECT_EQ(light.kind, LightKind::parallelogram);
    expect_vec(light.side_u, {0, 2, 0});
    expect_vec(light.side_v, {-3, 0, 0});
    EXPECT_EQ(light.samples_u, 5);
    EXPECT_EQ(light.samples_v, 4);
    EXPECT_EQ(light.adaptive, 1);
    EXPECT_TRUE(light.jitter);
    const auto adaptive = [](const std::string& items) {
        return povray_scene("light_source { 0, 1 " + items + " }\nsphere { 0, 1 }").lights.at(1).adaptive;
    };
    EXPECT_EQ(adaptive("area_light x, y, 3, 3"), k_all_levels);
    EXPECT_EQ(adaptive("adaptive 2 area_light x, y, 3, 3"), 2);
    EXPECT_FALSE(light.circular || light.oriented);
    EXPECT_EQ(scene.conventions.area_shading, AreaShading::center);
    for (const bool oriented : {false, true}) {
        const Scene round =
            povray_scene("light_source { 0, 1 area_light 2*x, 2*z, 5, 4 " +
                         std::string(oriented ? "orient" : "circular") + " }\nsphere { 0, 1 }");
        EXPECT_TRUE(round.lights.at(1).circular);
        EXPECT_EQ(round.lights[1].oriented, oriented);
    }
    const std::string spot = "light_source { y, 1 spotlight radius 10 falloff 20 point_at x ";
    const Light cone = povray_scene(spot + "area_light x, z, 5, 5 }\nsphere { 0, 1 }").lights.at(1);
    EXPECT_TRUE(cone.is_parallelogram() && cone.is_spot());
    expect_vec(cone.axis, {1, -1, 0});
    EXPECT_EQ(cone.outer_angle, 20);
    EXPECT_EQ(povray_scene(spot + "area_light x, z, 1, 1 }\nsphere { 0, 1 }").lights.at(1).kind,
              LightKind::spot);
}

TEST(PovRay, APovIsOfCsc473IfItsWholeTextIs) {
    const std::string both =
        "camera { location <0, 0, 5> look_at <0, 0, 0> }\n"
        "light_source { <0, 9, 9> color rgb <1, 1, 1> }\nsphere { <0, 0, 0>, 1 }\n";
    const FormatChoice csc = choose_format({"a.pov", both, {}});
    EXPECT_EQ(csc.format, "csc473");
    EXPECT_NE(csc.reason.find("--format povray"), std::string::npos);
    const std::string own = both + "sphere { y, 1 }";
    const FormatChoice pov = choose_format({"a.pov", own, {}});
    EXPECT_EQ(pov.format, "povray");
    EXPECT_NE(pov.reason.find("4:10"), std::string::npos) << pov.reason;
    EXPECT_EQ(load_text(both, "a.pov").value_or(Scene{}).profile, "csc473");
    EXPECT_EQ(load_text(own, "a.pov").value_or(Scene{}).profile, "povray");
    EXPECT_EQ(choose_format({"a.pov", both, "povray"}).format, "povray");
}

TEST(PovRay, AGlintSceneIncludesAPovByItsText) {
    TextSources sources(std::map<std::string, std::string, std::less<>>{
        {"a.pov", "#declare R = 2;\nsphere { x, R pigment { rgb 1 } }"},
        {"b.pov", "sphere { <0, 0, 0>, 1 }"}});
    const Result<Scene> result = load_text(
        "camera { position = (0, 0, 9)  look_at = (0, 0, 0) }\nlight { position = (0, 9, 9) }\n"
        "include \"a.pov\"\ninclude \"b.pov\"\n",
        "s.glint", {}, &sources);
    ASSERT_TRUE(result) << messages(result);
    EXPECT_EQ(result->get<Sphere>().size(), 2u);
    EXPECT_EQ(result->camera.position, (Vec3{0, 0, 9}));
    EXPECT_EQ(messages(result).find("ignores the camera"), std::string::npos) << messages(result);
}

class PovRayMistakes : public testing::TestWithParam<BadText> {};
TEST_P(PovRayMistakes, AreReportedAtTheirPlace) { expect_messages(GetParam(), "a.pov", "povray"); }

#define L "light_source { <0, 0, -9>, rgb 1 }\n"

INSTANTIATE_TEST_SUITE_P(
    PovRay, PovRayMistakes,
    testing::Values(
        BadText{"Blob",
                L "$blob { threshold .6 sphere { 0, 1, 1 } }",
                {"glint does not render `blob` (a shape) of POV-Ray; the option skip-unsupported leaves it "
                 "out and draws the rest"}},
        BadText{"Torus",
                L "$torus { -1, .2 }",
                {"glint does not render `torus` (with a radius that is not above 0) of POV-Ray; the option "
                 "skip-unsupported leaves it out and draws the rest"}},
        BadText{"Difference",
                L "sphere { 0, 1 }\nunion { difference { box { 0, 1 } $disc { 0, y, 1 } } }",
                {"glint does not render `disc` (in a solid) of POV-Ray; the option "
                 "skip-unsupported leaves it out and draws the rest"}},
        BadText{"Operand",
                L "intersection { box { 0, 1 } union { sphere { 0, 1 } $blob { sphere { 0, 1, 1 } } } }",
                {"glint does not render `blob` (a shape) of POV-Ray; the option "
                 "skip-unsupported leaves it out and draws the rest"}},
        BadText{"Normal",
                L "sphere { 0, 1 pigment { rgb 1 } $normal { bumps .4 } }",
                {"glint does not render `normal` (a material) of POV-Ray: the picture will differ"}},
        BadText{"Clip",
                L "disc { 0, y, 2 $clipped_by { box { -1, 1 } } }",
                {"glint does not render `clipped_by` (a part of a shape) of POV-Ray; the object is cut where "
                 "the picture shows it: take the `clipped_by` out of the text, or draw the whole object with "
                 "the option skip-unsupported"}},
        BadText{"Undeclared",
                L "sphere { 0, 1 pigment { color $Red } }",
                {"expected a color, found 'Red', which is not declared"}},
        BadText{"NotAColor",
                L "sphere { 0, 1 pigment { $<.1, .2, .3> } }",
                {"expected a color (`rgb` before the numbers)"}},
        BadText{"OpenComment",
                L "sphere { 0, 1 }\n$/* a /* b */",
                {"this comment does not end: comments nest in POV-Ray's language"}},
        BadText{"OpenIf", "$#if (1)\n" L, {"this `#if` has no `#end`"}},
        BadText{"LoneEnd", L "$#end", {"this `#end` has nothing to end"}},
        BadText{
            "Cylinder", L "$cylinder { x, x, 1 }", {"expected two ends at different points of a cylinder"}},
        BadText{"Error", "$#error \"no\"", {"the text reports an error: 'no'"}},
        BadText{
            "Array", "#declare A = array[2];\n#declare B = $A[2];", {"expected an index below 2, found 2"}},
        BadText{
            "BigArray", "#declare A = $array[1000][1000][1000];", {"more than 4000000 elements of arrays"}},
        BadText{"Include", "$#include \"b.inc\"", {"'b.inc': no files are read here"}},
        BadText{"Endless",
                "#macro F() $F() #end\nF()",
                {"F(): macros and includes are nested more than 500 deep (in a call of F() at a.pov:2:1)"}}),
    test_name);

TEST(PovRay, MistakesInMacrosNameTheCall) {
    const Result<Scene> result = read_povray("#macro Ball(R)\n  sphere { 0, R foo }\n#end\n\nBall(2)");
    ASSERT_FALSE(result);
    EXPECT_EQ(result.diagnostics[0].line, 2u);
    EXPECT_NE(result.diagnostics[0].message.find("in a call of Ball() at a.pov:5:1"), std::string::npos)
        << messages(result);
    EXPECT_EQ(povray_scene("#macro Ball(R)\n  sphere { 0, R }\n#end\n\nBall(2)").shape_texts.place(0).line,
              6u);
}

TEST(PovRay, HostileTextsEndWithAMessage) {
    TextSources sources(std::map<std::string, std::string, std::less<>>{{"a.pov", "#include \"b.inc\""},
                                                                        {"b.inc", "#include \"b.inc\""}});
    const std::string deep(100000, '(');
    for (const std::string& text : {
             std::string("#while (1) #end"),
             std::string("#declare I = 0; #for (I, 0, 1e300, 1e-300) #end"),
             std::string("#include \"b.inc\""),
             "#declare A = " + deep,
             std::string("#declare S = \"abcdefgh\"; #while (1) #declare S = concat(S, S); #end"),
             std::string(
                 "#declare A = union { sphere { 0, 1 } sphere { 0, 2 } }\n"
                 "#for (I, 1, 60) #declare A = union { object { A } object { A } } #end object { A }"),
             std::string(
                 "#declare A = sphere { 0, 1 }\n#for (I, 1, 900) #declare A = union { object { A } } #end"),
         }) {
        const Result<Scene> result = read_povray(text, &sources);
        EXPECT_FALSE(result) << text.substr(0, 81);
        EXPECT_EQ(what_is_wrong(result, text), "") << text.substr(0, 81);
    }
}

TEST(PovRay, WritesNoFiles) {
    const std::string write =
        "#declare S = seed(1); #fopen Out \"list.txt\" write\n"
        "#write(Out, \"a\", 1 + 1, <1, 2, 3>, rand(S))\n#ifdef(Out) sphere { 0, 1 } #end\n"
        "#fclose Out\n#ifdef(Out) sphere { 0, 2 } #end\n";
    EXPECT_EQ(povray_scene(write).get<Sphere>().size(), 1u);
    EXPECT_EQ(messages(read_povray(write)).substr(0, 81),
              "a.pov:1:30: warning: glint writes no files: `#write` to 'list.txt' has no effect\n");
    EXPECT_NE(messages(read_povray("#fopen In \"list.txt\" read\n")).find("1:22: error: glint does not read"),
              std::string::npos);
    EXPECT_NE(messages(read_povray("#fopen In \"list.txt\" sphere\n"))
                  .find("1:22: error: expected `read`, `write` or `append`, found 'sphere'"),
              std::string::npos);
    EXPECT_NE(messages(read_povray("#write(Out, 1)")).find("1:8: error: expected an open file, found 'Out'"),
              std::string::npos);
    EXPECT_NE(messages(read_povray("#fopen Out \"a\" append #write(Out, sphere { 0, 1 })"))
                  .find("expected a text, a number or a vector, found an object"),
              std::string::npos);
}

}  // namespace
}  // namespace glint::test
