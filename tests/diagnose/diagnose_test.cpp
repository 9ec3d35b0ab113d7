// SPDX-License-Identifier: Apache-2.0
// Logs of glint itself have no finding, whatever their conventions; a mistake in them is found.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "diagnose/own_log.h"
#include "math/transform.h"

namespace glint::test {
namespace {

std::string text_of(const std::string& scene) {
    std::ifstream file(GLINT_SOURCE "/scenes/" + scene);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

OwnScene scene_of(const std::string& name) { return own_scene(text_of(name), name); }

class OwnScenes : public testing::TestWithParam<const char*> {};

TEST_P(OwnScenes, DoNotDifferFromThemselves) {
    const OwnScene own = scene_of(GetParam());
    EXPECT_EQ(first_finding(own, OwnLog{}.write(own)), "");
    OwnLog json;
    json.is_json = true;
    EXPECT_EQ(first_finding(own, json.write(own)), "");
    OwnLog rounded;
    rounded.decimals = 5;
    EXPECT_EQ(first_finding(own, rounded.write(own)), "");
    OwnLog other;
    other.to_light = [](Vec3 v) { return -v; };
    other.color = [](Color c) { return c * 255; };
    EXPECT_EQ(first_finding(own, other.write(own)), "");
}

INSTANTIATE_TEST_SUITE_P(Scenes, OwnScenes,
                         testing::Values("cgfs/three_mirrors.cgfs", "cgfs/three_spheres.cgfs",
                                         "epfl/castle.json", "epfl/mirror_room.json", "csc473/cone_tower.pov",
                                         "csc473/glass_ball.pov", "nff/pyramid.nff", "glint/lit_sphere.glint",
                                         "glint/attenuation.glint", "glint/three_spots.glint",
                                         "glint/hall_of_mirrors.glint", "glint/finishes.glint",
                                         "glint/window.glint", "glint/glass.glint"),
                         [](const auto& param) {
                             std::string name = param.param;
                             for (char& c : name)
                                 if (c == '/' || c == '.') c = '_';
                             return name;
                         });

TEST(Diagnose, ReversedVectors) {
    const OwnScene own = scene_of("cgfs/three_mirrors.cgfs");
    OwnLog log;
    log.normal = [](Vec3 v) { return -v; };
    log.has_n_l = false;
    EXPECT_EQ(first_finding(own, log.write(own)), "N: normal-reversed");
    // N.L shows that N is turned before it is used.
    log.has_n_l = true;
    EXPECT_EQ(first_finding(own, log.write(own)), "");
}

TEST(Diagnose, ABlackAmbientTermIsNotTheColorsScale) {
    const OwnScene own = scene_of("glint/lit_sphere.glint");
    OwnLog log;
    log.color = [](Color c) { return c * 0.5; };
    const std::string found = first_finding(own, log.write(own));
    EXPECT_NE(found, "");
    EXPECT_EQ(found.find("L:"), std::string::npos) << found;
}

TEST(Diagnose, NotANumber) {
    const OwnScene own = scene_of("cgfs/three_mirrors.cgfs");
    std::string log = OwnLog{}.write(own);
    const std::size_t at = log.find("N.L ");
    log.replace(at + 4, log.find('\n', at) - at - 4, "-nan");
    const Result<Diagnosis> result = diagnose(own.scene, own.world, log);
    ASSERT_TRUE(result);
    ASSERT_FALSE(result->findings.empty());
    EXPECT_EQ(result->findings[0].quantity, "N.L");
    EXPECT_EQ(result->findings[0].relation, "yours is not a number");
    EXPECT_FALSE(result->findings[0].is_sure);
}

TEST(Diagnose, FewerThanThreePixelsAreNotSure) {
    const OwnScene own = scene_of("cgfs/three_mirrors.cgfs");
    OwnLog log;
    log.has_n_l = false;
    log.normal = [](Vec3 v) { return -v; };
    const Explanation e = explain(own.scene, own.world, 30, 30).value();
    std::string text = "pixel 30 30\n";
    log.add_ray(text, e, 0);
    EXPECT_EQ(first_finding(own, text), "N: normal-reversed (likely)");
}

TEST(Diagnose, LogsThatCannotBeCompared) {
    const OwnScene own = scene_of("cgfs/three_mirrors.cgfs");
    const auto message = [&](std::string_view log) { return diagnose(own.scene, own.world, log).message; };
    EXPECT_EQ(message(""), "log: the log has no line `pixel X Y`");
    EXPECT_EQ(message("pixel 100 100\nray camera\n"), "log: no pixel of the log is in the picture of 64x48");
    EXPECT_EQ(message("size 50 50\npixel 1 1\nray camera\n"),
              "log: the log is of a picture of 50x50 pixels, the scene's has 64x48: give its size");
    EXPECT_EQ(message("pixel 1 1\nray camera\nN 1\nt 1\n"), "log:3:1: expected 3 numbers after 'N', found 1");
}

// A log of wrong pixels alone: what glint hits there does not say which shapes the numbers are.
TEST(Diagnose, NumbersOfShapesAreInTheScenesOrder) {
    const OwnScene own = own_scene(
        "camera { position = (0, 0, 9)  look_at = (0, 0, 0) }\nlight { position = (3, 4, 9) }\n"
        "sphere { center = (0, 0, 0)  radius = 1 }\nsphere { center = (0, 0, -5)  radius = 3 }\n"
        "sphere { center = (0, 0, -15)  radius = 9 }\n",
        "three.glint");
    std::string log;
    for (int x = 29; x < 35; ++x) {
        const Vec3 d = explain(own.scene, own.world, x, 24).value().rays[0].direction;
        // The last sphere is hit in place of the first, at its own distance.
        log += fmt::format("pixel {} 24\nray camera\ndirection {} {} {}\nshape 2\nt 15.2\nend\n", x, d.x, d.y,
                           d.z);
    }
    log += "pixel 10 24\nray camera\nshape 0\nend\n";
    const Diagnosis found = diagnose(own.scene, own.world, log).value();
    for (const std::string& sentence : found.conventions)
        EXPECT_EQ(sentence.find("another order"), std::string::npos) << sentence;
    ASSERT_FALSE(found.findings.empty());
    EXPECT_EQ(found.findings[0].quantity, "shape");
    EXPECT_EQ(found.findings[0].example.yours.numbers[0], 3);
    EXPECT_EQ(found.findings[0].example.expected.numbers[0], 1);
}

// One quantity that is wrong does not decide that its colors go to 1.
TEST(Diagnose, TheScaleOfColorsIsThatOfTheOthers) {
    const OwnScene own = scene_of("cgfs/three_mirrors.cgfs");
    OwnLog log;
    log.color = [](Color c) { return c * 255; };
    std::string text = log.write(own);
    // Each highlight is a third.
    std::string changed;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        double r = 0, g = 0, b = 0;
        if (std::sscanf(line.c_str(), "specular %lf %lf %lf", &r, &g, &b) == 3)
            line = fmt::format("specular {} {} {}", r / 3, g / 3, b / 3);
        changed += line + "\n";
    }
    const Diagnosis found = diagnose(own.scene, own.world, changed).value();
    ASSERT_FALSE(found.findings.empty());
    EXPECT_EQ(found.findings[0].quantity, "specular");
    EXPECT_EQ(found.findings[0].relation, "yours is 0.3333 times what it should be");
}

// A log says the size of its picture, which need not be the scene's.
TEST(Diagnose, TheSizeOfTheLogIsTaken) {
    const OwnScene own = scene_of("cgfs/three_mirrors.cgfs");
    const OwnScene larger = own_scene(text_of("cgfs/three_mirrors.cgfs"), "three_mirrors.cgfs", 320, 240);
    const std::string log = "size 64 48\n" + OwnLog{}.write(own);
    EXPECT_EQ(first_finding(larger, log), "");
    EXPECT_EQ(first_finding(own, log), "");
    // Without the size, these are other pixels' rays.
    EXPECT_NE(first_finding(larger, OwnLog{}.write(own)), "");
}

// Without D, P and N each ray follows from all rays before it.
TEST(Diagnose, ManyMirrorsWithFewValues) {
    const OwnScene own = scene_of("cgfs/three_mirrors.cgfs");
    std::string log = "pixel 30 30\nray camera\nshape 1\n";
    for (int i = 0; i < 200; ++i) log += "ray mirror\nt 1\nlight 2\nN.L 0.5\n";
    EXPECT_EQ(diagnose(own.scene, own.world, log).message, "");
}

TEST(Diagnose, HugeNumbers) {
    const OwnScene own = scene_of("cgfs/three_mirrors.cgfs");
    const std::string ray =
        "pixel 30 30\nray camera\nshape 1\nP 1e200 0 0\nlight 2\nL 1e300 1e300 0\ndiffuse 1 1 1\nspecular 1 "
        "1 1\nlocal 1 1 1\n";
    EXPECT_EQ(diagnose(own.scene, own.world, ray).message, "");
    EXPECT_EQ(diagnose(own.scene, own.world, "pixel 30 30\nray camera\nlight nan\n").message,
              "log:3:1: expected a light's number");
}

TEST(Diagnose, ADirectionThatIsNoNumber) {
    const OwnScene own = scene_of("cgfs/three_mirrors.cgfs");
    const Result<Diagnosis> result =
        diagnose(own.scene, own.world, "pixel 30 30\nray camera\ndirection nan nan nan\n");
    ASSERT_TRUE(result);
    ASSERT_EQ(result->findings.size(), 1u);
    EXPECT_EQ(result->findings[0].relation, "yours is not a number");
}

// Near the middle a row more or less is the same as counting from the bottom.
TEST(Diagnose, ARowTooFarIsNotAFlippedPicture) {
    const OwnScene own = scene_of("cgfs/three_spheres.cgfs");
    OwnLog log;
    log.direction = [](Vec3 v) { return Vec3{v.x, v.y + 1.0 / 48, v.z}; };
    const std::string found = first_finding(own, log.write(own));
    EXPECT_EQ(found.find("rows-flipped"), std::string::npos) << found;
    EXPECT_NE(found.find("direction"), std::string::npos) << found;
}

// Where the shadow ray from P + epsilon N runs beside the one from there to the light, both programs are
// right.
TEST(Diagnose, BordersOfShadowsMoveByEpsilon) {
    const OwnScene own = own_scene(R"({
 "name": "pipe",
 "camera": { "position": [1.5, -9, 3.2], "target": [0.3, 0, 0.9], "up": [0, 0, 1], "fov": 48 },
 "materials": [ { "name": "clay", "color": [0.9, 0.2, 0.1], "ambient": 0.15, "diffuse": 0.75, "specular": 0, "shininess": 1 } ],
 "lights": [ { "position": [6, -3, 4], "color": [0.25, 0.35, 0.5] } ],
 "planes": [ { "center": [0, 0, 0], "normal": [0, 0, 1], "material": "clay" } ],
 "cylinders": [ { "center": [3.4, -1.4, 0.5], "axis": [1, 1, 0], "radius": 0.5, "height": 1.6, "material": "clay" } ]
})",
                                   "pipe.json", 480, 320);
    const std::string log = R"(pixel 322 241
ray camera
P 1.7325361306379454 -1.2937636894990057 0
N 0 0 1
light 1
L 0.70040832923445517 -0.28004036123118081 0.65651014342545289
blocked 0
pixel 316 244
ray camera
P 1.6420179816243321 -1.4210971965905417 0
N 0 0 1
light 1
L 0.71179841435071134 -0.25788553214353027 0.65332845463737543
blocked 0
)";
    EXPECT_EQ(first_finding(own, log), "");
    const std::string inside = R"(pixel 350 232
ray camera
P 2.1762028068873414 -0.86896531911682118 0
N 0 0 1
light 1
L 0.64484232286773835 -0.35937610818051868 0.67455703354687779
blocked 0
)";
    EXPECT_EQ(first_finding(own, inside).rfind("blocked: ", 0), 0u);
}

TEST(Diagnose, DoesNotDependOnThreads) {
    const OwnScene own = scene_of("epfl/castle.json");
    OwnLog log;
    log.to_light = [](Vec3 v) { return Vec3{v.y, v.x, v.z}; };
    const std::string text = log.write(own);
    DiagnoseOptions one, four;
    one.threads = 1, four.threads = 4;
    EXPECT_EQ(diagnosis_json(*diagnose(own.scene, own.world, text, one), own.scene).value(),
              diagnosis_json(*diagnose(own.scene, own.world, text, four), own.scene).value());
}

TEST(ProposedPixels, AreOfEachKind) {
    const OwnScene own = scene_of("cgfs/three_mirrors.cgfs");
    Rendering mine = render(own.world).value();
    EXPECT_TRUE(propose_pixels(own.scene, own.world, mine.image).value().empty());
    for (float& v : mine.image.rgb) v *= 0.8f;
    const std::vector<ProposedPixel> proposed = propose_pixels(own.scene, own.world, mine.image).value();
    EXPECT_EQ(proposed.size(), 12u);
    std::set<std::string> kinds;
    for (const ProposedPixel& p : proposed) kinds.insert(p.kind);
    EXPECT_GE(kinds.size(), 3u);
    mine.image.width = 10;
    EXPECT_FALSE(propose_pixels(own.scene, own.world, mine.image));
}

}  // namespace
}  // namespace glint::test
