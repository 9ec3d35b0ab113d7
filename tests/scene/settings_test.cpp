// SPDX-License-Identifier: Apache-2.0
// The table of settings: every key accepts the text that it prints, and rejects invalid text.
#include <gtest/gtest.h>

#include "glint/scene.h"

namespace glint::test {
namespace {

std::string set(Scene& scene, std::string_view key, std::string_view value) {
    const auto index = find_setting(key);
    if (!index) return "no such key";
    return set_setting(scene, *index, value, {SettingOrigin::Kind::command, {}}).message;
}

TEST(Settings, KeysAreFoundByName) {
    const auto keys = setting_keys();
    ASSERT_EQ(keys.size(), 44u);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        EXPECT_EQ(find_setting(keys[i].name), i);
        EXPECT_FALSE(keys[i].values.empty());
        EXPECT_FALSE(keys[i].description.empty());
    }
    EXPECT_FALSE(find_setting("Specular_gate"));
    EXPECT_FALSE(find_setting(""));
}

TEST(Settings, RenderSettingsAreNotConventions) {
    for (const SettingKey& key : setting_keys()) {
        const bool is_render = key.name == "size" || key.name == "shading" || key.name == "shadows" ||
                               key.name == "reflections" || key.name == "aa" || key.name == "alpha" ||
                               key.name == "seed";
        EXPECT_EQ(key.is_convention, !is_render) << key.name;
    }
}

TEST(Settings, EveryFieldHasAKey) {
    Scene scene;
    const std::pair<const char*, const char*> values[] = {{"pixel_sample", "corner"},
                                                          {"ray_direction", "viewport"},
                                                          {"camera_t_min", "1"},
                                                          {"specular_gate", "false"},
                                                          {"clamp_cosines", "false"},
                                                          {"normalize", "false"},
                                                          {"offset", "facing"},
                                                          {"epsilon", "0.001"},
                                                          {"shadow_stops_at_light", "false"},
                                                          {"mirror", "add"},
                                                          {"limit", "drop"},
                                                          {"mirror_miss", "black"},
                                                          {"fresnel", "schlick"},
                                                          {"beer", "0.15"},
                                                          {"glass_shadow", "none"},
                                                          {"transparency", "blend"},
                                                          {"opacity", "brightest"},
                                                          {"transparent_shadow", "none"},
                                                          {"transparency_counts", "true"},
                                                          {"transparent_surfaces", "12"},
                                                          {"transparent_epsilon", "0.002"},
                                                          {"transparent_shadow_epsilon", "0.003"},
                                                          {"min_weight", "0.01"},
                                                          {"facing", "open"},
                                                          {"cones", "false"},
                                                          {"spot_falloff", "linear"},
                                                          {"clamp_attenuation", "false"},
                                                          {"attenuate_highlights", "false"},
                                                          {"light_threshold", "0.25"},
                                                          {"area_shading", "center"},
                                                          {"fog_distance", "depth"},
                                                          {"fog_background", "false"},
                                                          {"fog_extent", "outside_objects"},
                                                          {"background_alpha", "0.5"},
                                                          {"transfer", "srgb"},
                                                          {"gamma", "2.2"},
                                                          {"rounding", "down"},
                                                          {"size", "320x200"},
                                                          {"shading", "normals"},
                                                          {"shadows", "false"},
                                                          {"reflections", "7"},
                                                          {"aa", "3"},
                                                          {"alpha", "true"},
                                                          {"seed", "4294967295"}};
    ASSERT_EQ(std::size(values), setting_keys().size());
    for (const auto& [key, value] : values) {
        EXPECT_EQ(set(scene, key, value), "") << key;
        EXPECT_EQ(get_setting(scene, *find_setting(key)), value);
        EXPECT_EQ(scene.origins[*find_setting(key)].kind, SettingOrigin::Kind::command);
    }
    const Conventions expected{PixelSample::corner,
                               RayDirection::viewport,
                               1,
                               false,
                               false,
                               false,
                               Offset::facing,
                               0.001,
                               false,
                               MirrorRule::add,
                               LimitRule::drop,
                               MissRule::black,
                               Fresnel::schlick,
                               0.15,
                               GlassShadow::none,
                               Transparency::blend,
                               OpacityRule::brightest,
                               TransparentShadow::none,
                               true,
                               12,
                               0.002,
                               0.003,
                               0.01,
                               Facing::open,
                               false,
                               SpotFalloff::linear,
                               false,
                               false,
                               0.25,
                               AreaShading::center,
                               FogDistance::depth,
                               false,
                               FogExtent::outside_objects,
                               0.5,
                               Transfer::srgb,
                               2.2,
                               Rounding::down};
    EXPECT_EQ(scene.conventions, expected);
    const RenderSettings settings{320,  200,   Shading::normals, false, 7, 3, std::nullopt,
                                  true, false, 4294967295};
    EXPECT_EQ(scene.settings, settings);
}

TEST(Settings, EveryListedWordIsAccepted) {
    for (std::size_t i = 0; i < setting_keys().size(); ++i) {
        std::string_view words = setting_keys()[i].values;
        if (words.find(" | ") == std::string_view::npos) continue;
        while (!words.empty()) {
            const auto word = words.substr(0, words.find(" | "));
            Scene scene;
            EXPECT_TRUE(set_setting(scene, i, word, {}));
            EXPECT_EQ(get_setting(scene, i), word);
            words.remove_prefix(std::min(word.size() + 3, words.size()));
        }
    }
}

TEST(Settings, NumbersKeepTheirDigits) {
    Scene scene;
    for (const char* value : {"0.1", "1e-300", "123456.789", "0.30000000000000004", "1000000000000"}) {
        ASSERT_EQ(set(scene, "epsilon", value), "");
        const double first = scene.conventions.epsilon;
        ASSERT_EQ(set(scene, "epsilon", get_setting(scene, *find_setting("epsilon"))), "");
        EXPECT_EQ(scene.conventions.epsilon, first) << value;
    }
}

TEST(Settings, AdaptiveSampling) {
    Scene scene;
    EXPECT_EQ(set(scene, "aa", "adaptive:4:0.05"), "");
    EXPECT_EQ(scene.settings.samples, 4);
    EXPECT_EQ(scene.settings.aa_threshold, 0.05);
    EXPECT_TRUE(scene.settings.is_adaptive());
    EXPECT_EQ(get_setting(scene, *find_setting("aa")), "adaptive:4:0.05");
    EXPECT_EQ(set(scene, "aa", "3"), "");
    EXPECT_FALSE(scene.settings.is_adaptive());
    EXPECT_EQ(set(scene, "aa", "adaptive:1:0"), "");
    EXPECT_FALSE(scene.settings.is_adaptive()) << "one sample is one sample";
    EXPECT_EQ(set(scene, "aa", "adaptive:4"), "");
    EXPECT_EQ(scene.settings.aa_threshold, k_default_aa_threshold);
}

TEST(Settings, JitteredSamples) {
    Scene scene;
    for (const char* value : {"4:jitter", "adaptive:5:0.25:jitter", "1:jitter"}) {
        EXPECT_EQ(set(scene, "aa", value), "");
        EXPECT_TRUE(scene.settings.jitter);
        EXPECT_EQ(get_setting(scene, *find_setting("aa")), value);
    }
    EXPECT_EQ(set(scene, "aa", "adaptive:3:jitter"), "");
    EXPECT_EQ(get_setting(scene, *find_setting("aa")), "adaptive:3:0.05:jitter");
    EXPECT_EQ(set(scene, "aa", "4"), "");
    EXPECT_FALSE(scene.settings.jitter);
}

TEST(Settings, BlanksAroundValuesDoNotMatter) {
    Scene scene;
    EXPECT_EQ(set(scene, "size", " 320 x 200\t"), "");
    EXPECT_EQ(scene.settings.width, 320);
    EXPECT_EQ(scene.settings.height, 200);
}

struct Wrong {
    const char *key, *value, *message;
};

class WrongSettings : public testing::TestWithParam<Wrong> {};

TEST_P(WrongSettings, AreRejectedAndChangeNothing) {
    Scene scene;
    EXPECT_EQ(set(scene, GetParam().key, GetParam().value), GetParam().message);
    EXPECT_EQ(scene.conventions, Conventions{});
    EXPECT_EQ(scene.settings, RenderSettings{});
    EXPECT_TRUE(scene.origins.empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongSettings,
    testing::Values(
        Wrong{"specular_gate", "maybe", "expected true or false, found 'maybe'"},
        Wrong{"specular_gate", "True", "expected true or false, found 'True'; did you mean `true`?"},
        Wrong{"specular_gate", "flase", "expected true or false, found 'flase'; did you mean `false`?"},
        Wrong{"specular_gate", "no", "expected true or false, found 'no'"},
        Wrong{"specular_gate", "", "expected true or false, found ''"},
        Wrong{"epsilon", "-1", "expected a number from 0 to 1e12, found '-1'"},
        Wrong{"epsilon", "nan", "expected a number from 0 to 1e12, found 'nan'"},
        Wrong{"epsilon", "inf", "expected a number from 0 to 1e12, found 'inf'"},
        Wrong{"epsilon", "1e999", "expected a number from 0 to 1e12, found '1e999'"},
        Wrong{"epsilon", "0,001", "expected a number from 0 to 1e12, found '0,001'"},
        Wrong{"epsilon", "+-1", "expected a number from 0 to 1e12, found '+-1'"},
        Wrong{"min_weight", "1.5", "expected a number from 0 to 1, found '1.5'"},
        Wrong{"size", "0x10", "expected WIDTHxHEIGHT, each from 1 to 65536, found '0x10'"},
        Wrong{"size", "640", "expected WIDTHxHEIGHT, each from 1 to 65536, found '640'"},
        Wrong{"size", "-640x480", "expected WIDTHxHEIGHT, each from 1 to 65536, found '-640x480'"},
        Wrong{"size", "100000x100000", "expected WIDTHxHEIGHT, each from 1 to 65536, found '100000x100000'"},
        Wrong{"size", "99999999999x1", "expected WIDTHxHEIGHT, each from 1 to 65536, found '99999999999x1'"},
        Wrong{"reflections", "1001", "expected a whole number from 0 to 1000, found '1001'"},
        Wrong{"reflections", "2.5", "expected a whole number from 0 to 1000, found '2.5'"},
        Wrong{"aa", "0",
              "expected a whole number from 1 to 64, or adaptive:N:T; :jitter may follow, found '0'"},
        Wrong{"aa", "adaptive",
              "expected a whole number from 1 to 64, or adaptive:N:T; :jitter may follow, found 'adaptive'"},
        Wrong{"aa", "adaptive:",
              "expected a whole number from 1 to 64, or adaptive:N:T; :jitter may follow, found 'adaptive:'"},
        Wrong{
            "aa", "adaptive:4:",
            "expected a whole number from 1 to 64, or adaptive:N:T; :jitter may follow, found 'adaptive:4:'"},
        Wrong{"aa", ":jitter",
              "expected a whole number from 1 to 64, or adaptive:N:T; :jitter may follow, found ':jitter'"},
        Wrong{"aa", "4:jitter:jitter",
              "expected a whole number from 1 to 64, or adaptive:N:T; :jitter may follow, found "
              "'4:jitter:jitter'"},
        Wrong{"aa", "4:0.1",
              "expected a whole number from 1 to 64, or adaptive:N:T; :jitter may follow, found '4:0.1'"},
        Wrong{"seed", "4294967296", "expected a whole number from 0 to 4294967295, found '4294967296'"},
        Wrong{"seed", "-1", "expected a whole number from 0 to 4294967295, found '-1'"},
        Wrong{"seed", "", "expected a whole number from 0 to 4294967295, found ''"},
        Wrong{"aa", "adaptive:0:1",
              "expected a whole number from 1 to 64, or adaptive:N:T; :jitter may follow, found "
              "'adaptive:0:1'"},
        Wrong{"aa", "adaptive:65:1",
              "expected a whole number from 1 to 64, or adaptive:N:T; :jitter may follow, found "
              "'adaptive:65:1'"},
        Wrong{"aa", "adaptive:4:-0.1",
              "expected a whole number from 1 to 64, or adaptive:N:T; :jitter may follow, found "
              "'adaptive:4:-0.1'"},
        Wrong{"aa", "adaptive:4:nan",
              "expected a whole number from 1 to 64, or adaptive:N:T; :jitter may follow, found "
              "'adaptive:4:nan'"},
        Wrong{"aa", "adaptive:4:1:1",
              "expected a whole number from 1 to 64, or adaptive:N:T; :jitter may follow, found "
              "'adaptive:4:1:1'"},
        Wrong{"shading", "blinn_phong",
              "expected phong | blinn-phong | diffuse | color | normals, found 'blinn_phong'; did you mean "
              "`blinn-phong`?"},
        Wrong{"limit", "\x1b[31m", "expected keep | drop | background, found '\\x1b[31m'"}));

TEST(Settings, UnknownKeysChangeNothing) {
    Scene scene;
    EXPECT_EQ(set_setting(scene, 1000, "1", {}).message, "no such setting");
    EXPECT_EQ(get_setting(scene, 1000), "");
}

}  // namespace
}  // namespace glint::test
