// SPDX-License-Identifier: Apache-2.0
// Pixels of Tachyon's scenes, as Tachyon has them (measured).
#include <gtest/gtest.h>

#include "formats/load_text.h"
#include "glint/glint.h"

namespace glint::test {
namespace {

// The pixel in the middle, in bytes that are rounded down.
std::array<int, 3> middle_of(const std::string& objects, int raydepth = 2) {
    const std::string text =
        "Begin_Scene\nResolution 21 21\nCamera Projection Orthographic Zoom 0.5 Aspectratio 1 Antialiasing 0 "
        "Raydepth " +
        std::to_string(raydepth) +
        " Center 0 0 -6 Viewdir 0 0 1 Updir 0 1 0 End_Camera\nBackground 0 0 0.4\n" + objects + "End_Scene\n";
    const Result<Scene> scene = load_text(text, "a.dat");
    EXPECT_TRUE(scene) << scene.message;
    if (!scene) return {};
    EXPECT_TRUE(scene.diagnostics.empty()) << to_string(scene.diagnostics.front());
    const Result<World> world = prepare(*scene);
    Result<Rendering> result = render(*world);
    std::array<int, 3> bytes{};
    for (std::size_t c = 0; c < 3; ++c)
        bytes[c] = static_cast<int>(255 * result->image.rgb[3 * (10 * 21 + 10) + c]);
    return bytes;
}

#define DAT_LOOK " Opacity 1 Color 1 1 1 TexFunc 0\n"

TEST(TachyonPictures, LightFromBehindAFaceReachesANormalThatIsTurnedToIt) {
    // The face is seen from the front and lit from behind; its normals point to the light.
    const std::string face =
        "STri V0 -9 -9 -2 V1 0 9 0 V2 9 -9 2 N0 -0.8 0 -0.6 N1 -0.8 0 -0.6 N2 -0.8 0 -0.6 "
        "Texture Ambient 0.1 Diffuse 0.5 Specular 0" DAT_LOOK;
    EXPECT_EQ(middle_of("Directional_Light Direction 1 0 0.1 Color 1 1 1\n" + face),
              (std::array<int, 3>{134, 134, 134}));
}

TEST(TachyonPictures, MeshesWhoseNormalsAreOnBothSidesHaveNoWarning) {
    std::string mesh = "Directional_Light Direction 0 0 1 Color 1 1 1\n";
    for (int i = 0; i < 8; ++i) {
        mesh +=
            "STri V0 -9 -9 0 V1 0 9 0 V2 9 -9 0 N0 0 0 -1 N1 0 0.6 0.8 N2 0 0 -1 "
            "Texture Ambient 0 Diffuse 0.5 Specular 0" DAT_LOOK;
    }
    EXPECT_GT(middle_of(mesh)[0], 0);
}

TEST(TachyonPictures, BeyondRaydepthTheBackgroundHasNoFog) {
    const std::string ring =
        "Normal 0 0 1 Inner 0 Outer 5 Texture Ambient 0.2 Diffuse 0 Specular 0 Opacity 0.5 "
        "Color 1 1 1 TexFunc 0\n";
    EXPECT_EQ(middle_of("Directional_Light Direction 0 0 1 Color 1 1 1\nFog Exp2 Start 2 End 14 Density 0.1 "
                        "Color 0.5 0 0\nRing Center 0 0 0 " +
                        ring + "Ring Center 0 0 1 " + ring),
              (std::array<int, 3>{84, 64, 107}));
}

TEST(TachyonPictures, BeyondRaydepthAMirrorSeesTheGradientBehindItself) {
    const std::string mirror =
        "UpDir 0 1 0 TopVal 0.616 BottomVal -0.909 TopColor 0.703 0.159 0.122 BottomColor 0.146 0.712 0.875\n"
        "Plane Center 0 0 3 Normal 0 0.5 -1 Texture Ambient 0.1 Diffuse 0 Specular 0.6" DAT_LOOK;
    EXPECT_EQ(middle_of("Background_Gradient Sky_Sphere " + mirror, 1), (std::array<int, 3>{147, 123, 134}));
    EXPECT_EQ(middle_of("Background_Gradient Sky_Sphere " + mirror, 2), (std::array<int, 3>{133, 49, 44}));
}

}  // namespace
}  // namespace glint::test
