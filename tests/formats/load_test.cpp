// SPDX-License-Identifier: Apache-2.0
// What load() does around the readers: formats, profiles, settings.
#include <cfenv>

#include "formats/load_text.h"

namespace glint::test {
namespace {

constexpr std::string_view k_text =
    "light { type = ambient intensity = 1 }\nsphere { center = (0,0,3) radius = 1 color = (1,2,3) }\n";

TEST(Load, FormatsAreFoundByNameOrExtension) {
    for (const char* name : {"a.cgfs", "A.CGFS", "x/y.z.cgfs"})
        EXPECT_TRUE(load_text(k_text, name).scene) << name;
    const SceneText named[] = {{"standard input", k_text, "cgfs"}};
    EXPECT_TRUE(load(named).scene);
    const SceneText other[] = {{"a.json", k_text, "cgfs"}};
    EXPECT_TRUE(load(other).scene) << "the format's name goes before the extension";
}

std::string listed(std::string_view FormatInfo::*column) {
    std::string all;
    for (const FormatInfo& f : formats()) all += (all.empty() ? "" : ", ") + std::string(f.*column);
    return all;
}

TEST(Load, UnknownFormatsAreNamed) {
    for (const char* name : {"a.blend", "cgfs", ".cgfs", ""}) {
        const LoadResult result = load_text(k_text, name);
        ASSERT_EQ(result.diagnostics.size(), 1u) << name;
        EXPECT_EQ(result.diagnostics[0].message,
                  "expected a name that ends in one of " + listed(&FormatInfo::extensions) +
                      ", or the name of a format (" + listed(&FormatInfo::name) + ")");
        EXPECT_EQ(result.diagnostics[0].file, name);
    }
    const SceneText text[] = {{"a", k_text, "pov"}};
    EXPECT_EQ(load(text).diagnostics.at(0).message,
              "expected one of the formats " + listed(&FormatInfo::name) + ", found 'pov'");
    EXPECT_TRUE(has_errors(load({}).diagnostics));
}

TEST(Load, AProfileReplacesTheFormats) {
    LoadOptions options;
    options.profile = "glint";
    const LoadResult result = load_text(k_text, "a.cgfs", options);
    ASSERT_TRUE(result.scene);
    EXPECT_EQ(result.scene->profile, "glint");
    EXPECT_EQ(result.scene->conventions, Conventions{});
    EXPECT_TRUE(result.scene->camera.frame) << "the camera is the format's all the same";
    options.profile = "glimt";
    EXPECT_EQ(load_text(k_text, "a.cgfs", options).diagnostics.at(0).message,
              "no profile is called 'glimt': there are cgfs, epfl, lecture5, light, csc473, nff, glint; did "
              "you mean "
              "`glint`?");
}

TEST(Load, SettingsOverrideAndSayWhereTheyCameFrom) {
    LoadOptions options;
    options.settings = {{"size", "10x20"}, {"specular_gate", "true"}};
    const LoadResult result = load_text(k_text, "a.cgfs", options);
    ASSERT_TRUE(result.scene);
    EXPECT_EQ(result.scene->settings.width, 10);
    EXPECT_TRUE(result.scene->conventions.specular_gate);
    EXPECT_EQ(result.scene->origins[*find_setting("size")].kind, SettingOrigin::Kind::command);
    EXPECT_EQ(result.scene->origins[*find_setting("epsilon")].kind, SettingOrigin::Kind::profile);
    options.settings = {{"sice", "10x20"}, {"epsilon", "x"}};
    const LoadResult wrong = load_text(k_text, "a.cgfs", options);
    ASSERT_EQ(wrong.diagnostics.size(), 2u);
    EXPECT_EQ(wrong.diagnostics[0].message, "no setting is called 'sice'; did you mean `size`?");
    EXPECT_EQ(wrong.diagnostics[1].message, "epsilon: expected a number from 0 to 1e12, found 'x'");
}

TEST(Load, AProfileFileIsAppliedBetween) {
    LoadOptions options;
    options.profile = "epfl";
    options.profile_text = SceneText{
        "mine.profile", "# a classic fault\r\nepsilon = 0   // acne\n\n  size=30 x 40\nlimit = drop", {}};
    options.settings = {{"limit", "keep"}};
    const LoadResult result = load_text(k_text, "a.cgfs", options);
    ASSERT_TRUE(result.scene) << to_string(result.diagnostics.at(0));
    EXPECT_EQ(result.scene->profile, "epfl");
    EXPECT_EQ(result.scene->conventions.epsilon, 0);
    EXPECT_EQ(result.scene->conventions.offset, Offset::normal);
    EXPECT_EQ(result.scene->settings.height, 40);
    EXPECT_EQ(result.scene->conventions.limit, LimitRule::keep);
    const SettingOrigin origin = result.scene->origins[*find_setting("size")];
    EXPECT_EQ(origin.kind, SettingOrigin::Kind::file);
    EXPECT_EQ(origin.place, (SourcePlace{4, 3, 1}));
    EXPECT_EQ(result.scene->files.at(origin.place.file), "mine.profile");
}

TEST(Load, AProfileFileMayStartFromAProfile) {
    LoadOptions options;
    options.profile_text = SceneText{"mine", "profile = csc473\nreflections = 1\n", {}};
    const LoadResult result = load_text(k_text, "a.cgfs", options);
    ASSERT_TRUE(result.scene);
    EXPECT_EQ(result.scene->profile, "csc473");
    EXPECT_EQ(result.scene->conventions.limit, LimitRule::drop);
    EXPECT_EQ(result.scene->settings.reflections, 1);
}

TEST(Load, MistakesOfAProfileFileHaveTheirPlace) {
    LoadOptions options;
    options.profile_text =
        SceneText{"mine", "epsilon = 0\n limmit = keep\nfacing = most\nnonsense\nprofile = x\n", {}};
    const LoadResult result = load_text(k_text, "a.cgfs", options);
    ASSERT_EQ(result.diagnostics.size(), 4u);
    EXPECT_EQ(result.diagnostics[0].message, "no setting is called 'limmit'; did you mean `limit`?");
    EXPECT_EQ(result.diagnostics[0].file, "mine");
    EXPECT_EQ(result.diagnostics[0].line, 2u);
    EXPECT_EQ(result.diagnostics[0].column, 2u);
    EXPECT_EQ(result.diagnostics[1].message, "facing: expected none | open | all, found 'most'");
    EXPECT_EQ(result.diagnostics[2].message, "expected `key = value`, found 'nonsense'");
    EXPECT_EQ(result.diagnostics[3].line, 5u);
}

// Hosts that round otherwise exist; numbers and maps must not follow them.
TEST(Load, TheCallersRoundingChangesNothing) {
    const char* text = "sphere { <0.1, 0.7, -0.3>, 0.1 rotate <10, 20, 30> scale <0.1, 0.2, 0.3> }";
    const LoadResult usual = load_text(text, "a.pov");
    ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
    const LoadResult upward = load_text(text, "a.pov");
    const int after = std::fegetround();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(after, FE_UPWARD) << "the caller's state is restored";
    ASSERT_TRUE(usual.scene && upward.scene);
    EXPECT_EQ(usual.scene->get<Sphere>()[0].center, upward.scene->get<Sphere>()[0].center);
    EXPECT_EQ(usual.scene->transforms, upward.scene->transforms);
}

TEST(Load, TextsOfTwoFormatsKeepTheFirstOnesConventions) {
    const std::string json =
        R"({ "camera": { "position": [0,0,9], "target": [0,0,0], "up": [0,1,0], "fov": 60 } })";
    const SceneText texts[] = {{"a.cgfs", k_text, {}}, {"b.json", json, {}}};
    const LoadResult result = load(texts);
    ASSERT_TRUE(result.scene);
    EXPECT_EQ(result.scene->profile, "cgfs");
    EXPECT_EQ(result.scene->camera.fov_degrees, 60);
    EXPECT_FALSE(result.scene->camera.frame);
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].message, "read with the conventions of cgfs, as the first text is");
}

TEST(Load, MessagesAreInTheOrderOfTheTexts) {
    const SceneText texts[] = {{"z.cgfs", "sphere { foo = 1 }", {}},
                               {"a.cgfs", "\n\nbar = 1\nlight { }", {}}};
    const LoadResult result = load(texts);
    ASSERT_EQ(result.diagnostics.size(), 4u);
    EXPECT_EQ(result.diagnostics[0].file, "z.cgfs");
    EXPECT_EQ(result.diagnostics[0].column, 1u);
    EXPECT_EQ(result.diagnostics[1].column, 10u);
    EXPECT_EQ(result.diagnostics[2].line, 3u);
    EXPECT_EQ(result.diagnostics[3].line, 4u);
}

}  // namespace
}  // namespace glint::test
