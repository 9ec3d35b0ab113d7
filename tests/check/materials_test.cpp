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
    // Black is a colour.
    EXPECT_EQ(ids_of(lit + "sphere { center = (0, 1, 3)  radius = 0.4  color = (0, 0, 0) }\n", "a.cgfs"), "");
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
          "mirror_falloff = 2", "mirror_metallic = 1", "mirror = 0.1  mirror_min = 0.1"})
        EXPECT_EQ(ids_of(k_clean + ball + std::string(unused) + " }\n"), "finish-unused@7") << unused;
    for (const std::string_view used :
         {"metallic = 1  specular = 0.1", "metallic = 1  phong_color = (0.1, 0.1, 0.1)", "brilliance = 2",
          "mirror = 0.1  mirror_falloff = 2", "mirror_min = 0.1  mirror_falloff = 2"})
        EXPECT_EQ(ids_of(k_clean + ball + std::string(used) + " }\n"), "") << used;
}

}  // namespace
}  // namespace glint::test
