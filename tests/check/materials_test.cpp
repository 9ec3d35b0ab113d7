// SPDX-License-Identifier: Apache-2.0
// Mistakes of materials, planted, and what is none.
#include "check/check_text.h"

namespace glint::test {
namespace {

TEST(CheckMaterials, Unused) {
    EXPECT_EQ(ids_of(k_clean + "material spare { color = (1, 0, 0) }\n"), "material-unused@7");
    EXPECT_TRUE(has(only_message(k_clean + "material spare { color = (1, 0, 0) }\n"), "material 'spare'"));
    EXPECT_EQ(ids_of(k_clean + "material red { color = (1, 0, 0) }\nsphere { center = (0, 1, 2) radius = 0.4 "
                               "material = red }\n"),
              "");
}

TEST(CheckMaterials, ColorsOfTheWrongScale) {
    EXPECT_TRUE(has(ids_of(k_clean + "sphere { center = (0, 1, 2)  radius = 0.4  color = (255, 80, 10) }\n"),
                    "material-color-255@7"));
    const std::string lit =
        "sphere { center = (0, 0, 4)  radius = 1  color = (200, 100, 50) }\n"
        "light { type = point  intensity = 0.7  position = (2, 3, 0) }\n";
    EXPECT_EQ(ids_of(lit, "a.cgfs"), "");
    EXPECT_EQ(ids_of(lit + "sphere { center = (0, 1, 3)  radius = 0.4  color = (1, 0.5, 0) }\n", "a.cgfs"),
              "material-almost-black@3");
    // Black is a color.
    EXPECT_EQ(ids_of(lit + "sphere { center = (0, 1, 3)  radius = 0.4  color = (0, 0, 0) }\n", "a.cgfs"), "");
}

TEST(CheckMaterials, TermsAsBytes) {
    const auto ball = [](std::string_view rest) {
        return k_clean +
               fmt::format("sphere {{ center = (0, 1, 2)  radius = 0.4  color = (0.8, 0.5, 0.2)  {} }}\n",
                           rest);
    };
    EXPECT_EQ(ids_of(ball("emission = 255")), "material-color-255@7");
    EXPECT_TRUE(has(only_message(ball("emission = 255")), "a channel of 204 in its emission")) << ball("");
    EXPECT_EQ(ids_of(ball("emission_color = (255, 200, 100)")), "material-color-255@7");
    EXPECT_EQ(ids_of(ball("ambient = 255")), "material-color-255@7");
    EXPECT_TRUE(has(only_message(ball("ambient = 255")), "a channel of 204 in its k_a"));
    // A bright lamp.
    for (const char* lamp : {"emission = 1", "emission = 60", "emission_color = (5000, 5000, 5000)"})
        EXPECT_EQ(ids_of(ball(lamp)), "") << lamp;
}

TEST(CheckMaterials, ThatLightMakesDarker) {
    EXPECT_TRUE(has(ids_of(k_clean + "sphere { center = (0, 1, 2)  radius = 0.4  color = (1, -0.5, 0) }\n"),
                    "material-negative@7"));
}

TEST(CheckMaterials, ShininessOfZero) {
    const std::string ball = "sphere { center = (0, 1, 2)  radius = 0.4  specular = 0.1  shininess = ";
    EXPECT_EQ(ids_of(k_clean + ball + "0 }\n"), "shininess-zero@7");
    EXPECT_EQ(ids_of(k_clean + ball + "1 }\n"), "");
    EXPECT_EQ(ids_of(k_clean + "render { shading = diffuse }\n" + ball + "0 }\n"), "");
}

TEST(CheckMaterials, FinishesWithoutEffect) {
    const std::string ball = "sphere { center = (0, 1, 2)  radius = 0.4  ";
    for (const std::string_view unused :
         {"metallic = 1", "diffuse = 0  brilliance = 2", "diffuse = 0  outline = 1", "outline_width = 0.5",
          "angled_opacity = true", "mirror_falloff = 2", "mirror_metallic = 1",
          "mirror_fresnel = true  ior = 1.5", "mirror = 0.1  mirror_fresnel = true",
          "mirror = 0.1  mirror_fresnel = true  ior = 1.5  mirror_falloff = 1",
          "mirror = 0.1  mirror_min = 0.1", "transmit = 0.5  conserve_energy = true",
          "transmit = 0.5  fade_color = (1, 0, 0)", "transmit = 0.5  fade_power = 2", "fade_distance = 2",
          "caustics = 9", "mirror = 0.1  conserve_energy = true"})
        EXPECT_EQ(ids_of(k_clean + ball + std::string(unused) + " }\n"), "finish-unused@7") << unused;
    for (const std::string_view used :
         {"metallic = 1  specular = 0.1", "metallic = 1  phong_color = (0.1, 0.1, 0.1)", "brilliance = 2",
          "mirror = 0.1  mirror_falloff = 2", "mirror_min = 0.1  mirror_falloff = 2",
          "mirror = 0.1  mirror_fresnel = true  ior = 1.5",
          "mirror_min = 0.1  mirror_fresnel = true  ior = 1.5",
          "mirror = 0.1  transmit = 0.5  conserve_energy = true",
          "transmit = 0.5  fade_distance = 1  fade_power = 2  fade_color = (1, 0, 0)",
          "transmit = 0.5  caustics = 9", "transmit = 0.5  angled_opacity = true"})
        EXPECT_EQ(ids_of(k_clean + ball + std::string(used) + " }\n"), "") << used;
}

TEST(CheckMaterials, ABlackMirror) {
    const std::string ball =
        k_clean + "sphere { center = (0, 1, 2)  radius = 0.4  mirror = 0.3  mirror_color = ";
    EXPECT_EQ(ids_of(ball + "(0, 0, 0) }\n"), "finish-unused@7");
    EXPECT_TRUE(has(only_message(ball + "(0, 0, 0) }\n"), "the mirror's color is black"));
    EXPECT_EQ(ids_of(ball + "(0.1, 0, 0) }\n"), "");
    EXPECT_EQ(ids_of(k_clean + "sphere { center = (0, 1, 2)  radius = 0.4  mirror_color = (0, 0, 0) }\n"), "")
        << "no mirror";
}

TEST(CheckMaterials, ShininessOutOfRange) {
    const auto ball = [](std::string_view shininess) {
        return k_clean + fmt::format(
                             "sphere {{ center = (0, 1, 2)  radius = 0.8  diffuse = 0.5  specular = 0.4  "
                             "shininess = {} }}\n",
                             shininess);
    };
    EXPECT_EQ(ids_of(ball("0.02")), "shininess-too-small@7");
    EXPECT_EQ(ids_of(ball("200000")), "shininess-too-large@7");
    EXPECT_TRUE(has(only_message(ball("200000")), "200000: its highlights are smaller than a pixel"))
        << only_message(ball("200000"));
    for (const std::string_view fine : {"1", "2000", "100000"}) EXPECT_EQ(ids_of(ball(fine)), "") << fine;
    EXPECT_EQ(ids_of(k_clean + "sphere { center = (0, 1, 2)  radius = 0.8  phong_color = (0.2, 0.2, 0.2)  "
                               "phong_shininess = 0.3 }\n"),
              "shininess-too-small@7");
    EXPECT_EQ(ids_of(k_clean + "sphere { center = (0, 1, 2)  radius = 0.8  phong_color = (0.2, 0.2, 0.2)  "
                               "phong_shininess = 200000 }\n"),
              "shininess-too-large@7");
    // Not visible, but for another reason.
    EXPECT_EQ(ids_of("render { shading = diffuse }\n" + ball("200000")), "");
}

TEST(CheckMaterials, TheExponentHasTheNameOfTheFile) {
    const auto pov = [](std::string_view finish) {
        return only_message(
            fmt::format(
                "#version 3.7;\nglobal_settings {{ assumed_gamma 1 }}\n"
                "camera {{ location <0, 2, -9> look_at <0, 1, 0> }}\n"
                "light_source {{ <3, 8, -7> color rgb 0.7 }}\n"
                "plane {{ y, 0 pigment {{ rgb <0.4, 0.5, 0.4> }} finish {{ ambient 0.1 diffuse 0.7 }} }}\n"
                "sphere {{ <0, 1, 0>, 1 pigment {{ rgb <0.6, 0.3, 0.2> }} finish {{ ambient 0.1 diffuse "
                "0.5 {} }} }}\n",
                finish),
            "a.pov");
    };
    std::string message = pov("specular 0.3 roughness 5");
    EXPECT_TRUE(has(message, "has the roughness 5, an exponent of 0.2: the highlight") &&
                has(message, "give it a roughness from 0.001 (small) to 1 (wide)"))
        << message;
    message = pov("phong 0.2 phong_size 0.5");
    EXPECT_TRUE(has(message, "has the phong_size 0.5: ") && has(message, "a phong_size from 1 (wide)"))
        << message;
    message = only_message(
        "sphere { center = (0, 0, 4)  radius = 1  color = (200, 100, 50)  specular = 0.5 }\n"
        "light { type = point  intensity = 0.3  position = (2, 3, 0) }\n",
        "a.cgfs");
    EXPECT_TRUE(has(message, "has the specular 0.5: ") && has(message, "give it a specular from 1 (wide)"))
        << message;
    message = only_message(k_clean +
                           "sphere { center = (0, 1, 2)  radius = 0.8  specular = 0.1  shininess = 0.5 }\n");
    EXPECT_TRUE(has(message, "has the shininess 0.5: ")) << message;
}

TEST(CheckMaterials, GlassThatDoesNotRefract) {
    const std::string ball = "sphere { center = (0, 1, 2)  radius = 0.8  diffuse = 0.1  ";
    EXPECT_EQ(ids_of(k_clean + ball + "transmission = 0.9 }\n"), "glass-without-refraction@7");
    for (const std::string_view fine :
         {"transmission = 0.9  ior = 1.5", "transmission = 0.9  ior = 1.01", "transmit = 0.9"})
        EXPECT_EQ(ids_of(k_clean + ball + std::string(fine) + " }\n"), "") << fine;
    // A pane, which would not bend the light but once.
    EXPECT_EQ(ids_of(k_clean +
                     "disc { center = (0, 1, 2)  normal = (0, 0, 1)  radius = 0.8  transmission = 0.9 }\n"),
              "");
    EXPECT_EQ(
        ids_of(
            "camera { location <0, 2, 9> up <0, 1, 0> right <1.33, 0, 0> look_at <0, 1, 0> }\n"
            "light_source { <3, 8, 7> color rgb <0.7, 0.7, 0.7> }\n"
            "plane { <0, 1, 0>, 0 pigment { color rgb <0.4, 0.5, 0.4> } finish { ambient 0.2 diffuse 0.7 } "
            "}\n"
            "sphere { <0, 1, 0>, 1 pigment { color rgbf <0.8, 0.3, 0.2, 0.7> } finish { ambient 0.2 diffuse "
            "0.7 } }\n",
            "a.pov"),
        "");
}

TEST(CheckMaterials, Invisible) {
    const std::string ball = "sphere { center = (0, 1, 2)  radius = 0.8  ";
    EXPECT_EQ(ids_of(k_clean + ball + "transmit = 1 }\n"), "material-invisible@7");
    EXPECT_EQ(ids_of(k_clean + ball + "filter = 1  color = (1, 1, 1) }\n"), "material-invisible@7");
    for (const std::string_view fine : {"transmit = 0.95", "transmit = 1  specular = 0.5",
                                        "transmit = 0.8  mirror = 0.1  filter = 0.2  color = (1, 1, 1)",
                                        "filter = 1  color = (1, 0.5, 0.5)", "transmit = 1  hollow = true",
                                        "transmit = 1  angled_opacity = true"})
        EXPECT_EQ(ids_of(k_clean + ball + std::string(fine) + " }\n"), "") << fine;
}

TEST(CheckMaterials, AreUsedWhereOthersAreMadeOfThem) {
    const std::string gold = k_clean + "material gold { color = (0.8, 0.6, 0.2) }\n";
    EXPECT_EQ(ids_of(gold), "material-unused@7");
    EXPECT_EQ(ids_of(gold + "sphere { center = (0, 1, 2)  radius = 0.8  material = gold  mirror = 0.3 }\n"),
              "");
    // Also before its definition.
    EXPECT_EQ(ids_of(k_clean + "sphere { center = (0, 1, 2)  radius = 0.8  material = gold  mirror = 0.3 }\n"
                               "material gold { color = (0.8, 0.6, 0.2) }\n"),
              "");
}

}  // namespace
}  // namespace glint::test
