// SPDX-License-Identifier: Apache-2.0
// The profiles, compared with the table of docs/conventions.md.
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

#include "glint/scene.h"

namespace glint::test {
namespace {

// docs/conventions.md has a table `| key | cgfs | epfl | ... |` with one row per key.
std::vector<std::string> cells(const std::string& line) {
    std::vector<std::string> out;
    std::stringstream stream(line.substr(1));
    for (std::string cell; std::getline(stream, cell, '|');) {
        const auto first = cell.find_first_not_of(" `");
        const auto last = cell.find_last_not_of(" `");
        out.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    }
    return out;
}

std::vector<std::vector<std::string>> documented_table() {
    std::ifstream file(GLINT_SOURCE_DIR "/docs/conventions.md");
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("| key | cgfs |")) {
            rows.push_back(cells(line));
            std::getline(file, line);  // |---|
        } else if (!rows.empty() && line.starts_with("|")) {
            rows.push_back(cells(line));
        } else if (!rows.empty()) {
            break;
        }
    }
    return rows;
}

TEST(Profiles, AgreeWithTheDocument) {
    const auto rows = documented_table();
    const auto names = profile_names();
    ASSERT_EQ(rows.size(), setting_keys().size() + 1);
    ASSERT_EQ(rows[0].size(), names.size() + 1);
    for (std::size_t p = 0; p < names.size(); ++p) EXPECT_EQ(rows[0][p + 1], names[p]);
    for (std::size_t k = 0; k < setting_keys().size(); ++k) {
        ASSERT_EQ(rows[k + 1].size(), names.size() + 1) << setting_keys()[k].name;
        EXPECT_EQ(rows[k + 1][0], setting_keys()[k].name);
        for (std::size_t p = 0; p < names.size(); ++p) {
            Scene scene;
            ASSERT_TRUE(apply_profile(scene, names[p]));
            EXPECT_EQ(rows[k + 1][p + 1], get_setting(scene, k)) << names[p] << " " << setting_keys()[k].name;
        }
    }
}

TEST(Profiles, EveryKeyIsDescribedInTheDocument) {
    std::ifstream file(GLINT_SOURCE_DIR "/docs/conventions.md");
    std::stringstream text;
    text << file.rdbuf();
    for (const SettingKey& key : setting_keys()) {
        std::string values(key.values);
        for (std::size_t at = 0; (at = values.find(" | ", at)) != std::string::npos; at += 3) {
            values.replace(at, 3, ", ");
        }
        const std::string row = "| `" + std::string(key.name) + "` | " + values + " | ";
        EXPECT_NE(text.str().find(row), std::string::npos) << row;
    }
}

// The values of the sources, written by hand: the table could repeat an error of the code.
TEST(Profiles, AgreeWithTheSources) {
    const auto value = [](const char* profile, const char* key) {
        Scene scene;
        apply_profile(scene, profile);
        return get_setting(scene, *find_setting(key));
    };
    const std::map<std::string, std::map<std::string, std::string>> expected = {
        {"cgfs",
         {{"pixel_sample", "corner"},
          {"ray_direction", "viewport"},
          {"camera_t_min", "1"},
          {"specular_gate", "false"},
          {"offset", "ray"},
          {"epsilon", "0.001"},
          {"mirror", "blend"},
          {"limit", "keep"},
          {"mirror_miss", "background"},
          {"facing", "none"},
          {"size", "600x600"},
          {"shading", "phong"},
          {"reflections", "3"},
          {"shadows", "true"},
          {"aa", "1"}}},
        {"epfl",
         {{"pixel_sample", "center"},
          {"ray_direction", "unit"},
          {"specular_gate", "true"},
          {"offset", "normal"},
          {"epsilon", "0.001"},
          {"mirror", "blend"},
          {"limit", "keep"},
          {"mirror_miss", "black"},
          {"facing", "open"},
          {"size", "640x640"},
          {"shading", "blinn-phong"},
          {"reflections", "4"}}},
        {"lecture5",
         {{"offset", "direction"},
          {"epsilon", "0.001"},
          {"specular_gate", "true"},
          {"facing", "none"},
          {"shading", "phong"}}},
        {"light",
         {{"pixel_sample", "whole"},
          {"shading", "phong"},
          {"shadows", "false"},
          {"reflections", "0"},
          {"facing", "none"},
          {"specular_gate", "true"},
          {"clamp_cosines", "true"},
          {"size", "43x43"}}},
        {"csc473",
         {{"pixel_sample", "center"},
          {"specular_gate", "false"},
          {"offset", "facing"},
          {"epsilon", "0.001"},
          {"mirror", "blend"},
          {"limit", "drop"},
          {"mirror_miss", "background"},
          {"facing", "none"},
          {"cones", "false"},
          {"shading", "blinn-phong"},
          {"size", "640x480"},
          {"reflections", "6"}}},
        {"povray",
         {{"mirror", "add"},
          {"transparent_epsilon", "0.0001"},
          {"transparent_shadow_epsilon", "0.001"},
          {"limit", "drop"},
          {"offset", "direction"},
          {"epsilon", "0.0001"},
          {"facing", "all"},
          {"specular_gate", "true"},
          {"shading", "blinn-phong"},
          {"reflections", "4"},
          {"size", "320x240"}}},
        {"nff",
         {{"mirror", "add"},
          {"cones", "true"},
          {"min_weight", "0.01"},
          {"facing", "all"},
          {"offset", "scale"},
          {"shading", "phong"},
          {"limit", "drop"},
          {"reflections", "5"},
          {"size", "512x512"}}},
        {"tachyon",
         {{"mirror", "add"},
          {"limit", "background"},
          {"transparency", "add"},
          {"transparent_shadow", "colored"},
          {"transparency_counts", "true"},
          {"spot_falloff", "linear"},
          {"clamp_attenuation", "false"},
          {"attenuate_highlights", "false"},
          {"light_threshold", "0.001959"},
          {"rounding", "down"},
          {"facing", "winding"},
          {"specular_gate", "true"},
          {"shading", "blinn-phong"}}}};
    for (const auto& [profile, values] : expected) {
        for (const auto& [key, text] : values)
            EXPECT_EQ(value(profile.c_str(), key.c_str()), text) << profile << " " << key;
    }
}

TEST(Profiles, GlintIsTheDefaults) {
    Scene scene;
    scene.conventions.limit = LimitRule::drop;
    scene.settings.width = 1;
    ASSERT_TRUE(apply_profile(scene, "glint"));
    EXPECT_EQ(scene.conventions, Conventions{});
    EXPECT_EQ(scene.settings, RenderSettings{});
}

TEST(Profiles, SetEveryOriginAndTheName) {
    Scene scene;
    ASSERT_TRUE(set_setting(scene, 0, "corner", {SettingOrigin::Kind::command, {}}));
    ASSERT_TRUE(apply_profile(scene, "epfl"));
    EXPECT_EQ(scene.profile, "epfl");
    ASSERT_EQ(scene.origins.size(), setting_keys().size());
    EXPECT_EQ(scene.origins[0].kind, SettingOrigin::Kind::profile);
}

TEST(Profiles, UnknownProfilesChangeNothing) {
    Scene scene;
    EXPECT_FALSE(apply_profile(scene, "renderman"));
    EXPECT_FALSE(apply_profile(scene, ""));
    EXPECT_EQ(scene.profile, "glint");
}

}  // namespace
}  // namespace glint::test
