// SPDX-License-Identifier: Apache-2.0
// load() apart from the readers: formats, profiles, settings.
#include <algorithm>
#include <atomic>
#include <cfenv>

#include "formats/load_text.h"

namespace glint::test {
namespace {

constexpr std::string_view k_text =
    "light { type = ambient intensity = 1 }\nsphere { center = (0,0,3) radius = 1 color = (1,2,3) }\n";

TEST(Load, FormatsAreFoundByNameOrExtension) {
    for (const char* name : {"a.cgfs", "A.CGFS", "x/y.z.cgfs"}) EXPECT_TRUE(load_text(k_text, name)) << name;
    const SceneText named[] = {{"standard input", k_text, "cgfs"}};
    EXPECT_TRUE(load(named));
    const SceneText other[] = {{"a.json", k_text, "cgfs"}};
    EXPECT_TRUE(load(other)) << "the format's name has precedence over the extension";
}

TEST(Load, UnknownFormatsAreNamed) {
    for (const char* name : {"a.blend", "cgfs", ".cgfs", ""}) {
        const Result<Scene> result = load_text(k_text, name);
        ASSERT_EQ(result.diagnostics.size(), 1u) << name;
        EXPECT_EQ(result.diagnostics[0].message,
                  "expected a name that ends in one of .cgfs, .json .js, .pov, .nff, .dat, .ply, .stl, .obj, "
                  ".gltf .glb, .glint, or the name "
                  "of a format (cgfs, epfl, csc473, povray, nff, tachyon, ply, stl, obj, gltf, glint)");
        EXPECT_EQ(result.diagnostics[0].file, name);
    }
    const SceneText text[] = {{"a", k_text, "pov"}};
    EXPECT_EQ(load(text).diagnostics.at(0).message,
              "expected one of the formats cgfs, epfl, csc473, povray, nff, tachyon, ply, stl, obj, gltf, "
              "glint, found 'pov'");
    EXPECT_TRUE(has_errors(load({}).diagnostics));
}

TEST(Load, AProfileReplacesTheFormats) {
    LoadOptions options;
    options.profile = "glint";
    const Result<Scene> result = load_text(k_text, "a.cgfs", options);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->profile, "glint");
    EXPECT_EQ(result->conventions, Conventions{});
    EXPECT_TRUE(result->camera.frame) << "the camera is still the format's";
    options.profile = "glimt";
    EXPECT_EQ(load_text(k_text, "a.cgfs", options).diagnostics.at(0).message,
              "no profile is called 'glimt': there are cgfs, epfl, lecture5, light, csc473, povray, nff, "
              "tachyon, glint; did "
              "you mean "
              "`glint`?");
}

TEST(Load, SettingsOverrideAndStoreTheirOrigin) {
    LoadOptions options;
    options.settings = {{"size", "10x20"}, {"specular_gate", "true"}};
    const Result<Scene> result = load_text(k_text, "a.cgfs", options);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->settings.width, 10);
    EXPECT_TRUE(result->conventions.specular_gate);
    EXPECT_EQ(result->origins[*find_setting("size")].kind, SettingOrigin::Kind::command);
    EXPECT_EQ(result->origins[*find_setting("epsilon")].kind, SettingOrigin::Kind::profile);
    options.settings = {{"sice", "10x20"}, {"epsilon", "x"}};
    const Result<Scene> wrong = load_text(k_text, "a.cgfs", options);
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
    const Result<Scene> result = load_text(k_text, "a.cgfs", options);
    ASSERT_TRUE(result) << to_string(result.diagnostics.at(0));
    EXPECT_EQ(result->profile, "epfl");
    EXPECT_EQ(result->conventions.epsilon, 0);
    EXPECT_EQ(result->conventions.offset, Offset::normal);
    EXPECT_EQ(result->settings.height, 40);
    EXPECT_EQ(result->conventions.limit, LimitRule::keep);
    const SettingOrigin origin = result->origins[*find_setting("size")];
    EXPECT_EQ(origin.kind, SettingOrigin::Kind::file);
    EXPECT_EQ(origin.place, (SourcePlace{4, 3, 1}));
    EXPECT_EQ(result->files.at(origin.place.file), "mine.profile");
}

TEST(Load, AProfileFileMayStartFromAProfile) {
    LoadOptions options;
    options.profile_text = SceneText{"mine", "profile = csc473\nreflections = 1\n", {}};
    const Result<Scene> result = load_text(k_text, "a.cgfs", options);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->profile, "csc473");
    EXPECT_EQ(result->conventions.limit, LimitRule::drop);
    EXPECT_EQ(result->settings.reflections, 1);
}

TEST(Load, MistakesOfAProfileFileHaveTheirPlace) {
    LoadOptions options;
    options.profile_text =
        SceneText{"mine", "epsilon = 0\n limmit = keep\nfacing = most\nnonsense\nprofile = x\n", {}};
    const Result<Scene> result = load_text(k_text, "a.cgfs", options);
    ASSERT_EQ(result.diagnostics.size(), 4u);
    EXPECT_EQ(result.diagnostics[0].message, "no setting is called 'limmit'; did you mean `limit`?");
    EXPECT_EQ(result.diagnostics[0].file, "mine");
    EXPECT_EQ(result.diagnostics[0].line, 2u);
    EXPECT_EQ(result.diagnostics[0].column, 2u);
    EXPECT_EQ(result.diagnostics[1].message, "facing: expected none | open | all | winding, found 'most'");
    EXPECT_EQ(result.diagnostics[2].message, "expected `key = value`, found 'nonsense'");
    EXPECT_EQ(result.diagnostics[3].line, 5u);
}

// Some hosts set another rounding mode; numbers and maps must not depend on it.
TEST(Load, TheCallersRoundingChangesNothing) {
    const char* text = "sphere { <0.1, 0.7, -0.3>, 0.1 rotate <10, 20, 30> scale <0.1, 0.2, 0.3> }";
    const Result<Scene> usual = load_text(text, "a.pov");
    ASSERT_EQ(std::fesetround(FE_UPWARD), 0);
    const Result<Scene> upward = load_text(text, "a.pov");
    const int after = std::fegetround();
    std::fesetround(FE_TONEAREST);
    EXPECT_EQ(after, FE_UPWARD) << "the caller's state is restored";
    ASSERT_TRUE(usual && upward);
    EXPECT_EQ(usual->get<Sphere>()[0].center, upward->get<Sphere>()[0].center);
    EXPECT_EQ(usual->transforms, upward->transforms);
}

TEST(Load, TextsOfTwoFormatsKeepTheFirstOnesConventions) {
    const std::string json =
        R"({ "camera": { "position": [0,0,9], "target": [0,0,0], "up": [0,1,0], "fov": 60 } })";
    const SceneText texts[] = {{"a.cgfs", k_text, {}}, {"b.json", json, {}}};
    const Result<Scene> result = load(texts);
    ASSERT_TRUE(result);
    EXPECT_EQ(result->profile, "cgfs");
    EXPECT_EQ(result->camera.fov_degrees, 60);
    EXPECT_FALSE(result->camera.frame);
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].message, "read with the conventions of cgfs, as the first text is");
}

TEST(Load, MessagesAreInTheOrderOfTheTexts) {
    const SceneText texts[] = {{"z.cgfs", "sphere { foo = 1 }", {}},
                               {"a.cgfs", "\n\nbar = 1\nlight { }", {}}};
    const Result<Scene> result = load(texts);
    ASSERT_EQ(result.diagnostics.size(), 4u);
    EXPECT_EQ(result.diagnostics[0].file, "z.cgfs");
    EXPECT_EQ(result.diagnostics[0].column, 1u);
    EXPECT_EQ(result.diagnostics[1].column, 10u);
    EXPECT_EQ(result.diagnostics[2].line, 3u);
    EXPECT_EQ(result.diagnostics[3].line, 4u);
}

TEST(Load, ReturnsTheCodeOfTheFailure) {
    const auto code_of = [](std::string_view text, const LoadOptions& options = {},
                            Sources* sources = nullptr) {
        return load_text(text, "a.glint", options, sources).code;
    };
    const std::string camera = "camera { position = (0, 0, 5) look_at = (0, 0, 0) }\n";
    EXPECT_EQ(code_of(camera), ErrorCode::none);
    EXPECT_EQ(code_of(camera + "sphere { center = oops }"), ErrorCode::parse);
    EXPECT_EQ(code_of(camera + "box { min = (1, 0, 0) max = (0, 0, 0) }"), ErrorCode::invalid_scene);
    FolderSources sources;
    EXPECT_EQ(code_of(camera + "include \"none.glint\"", {}, &sources), ErrorCode::io);
    EXPECT_EQ(code_of(camera, {.profile = "none"}), ErrorCode::invalid_argument);
    EXPECT_EQ(code_of(camera, {.settings = {{"none", "1"}}}), ErrorCode::invalid_argument);
    EXPECT_EQ(load_text(camera, "a.none").code, ErrorCode::invalid_argument);
    EXPECT_EQ(load({}).code, ErrorCode::invalid_argument);
}

TEST(Load, TheMessageHasThePlaceOfTheFirstError) {
    const Result<Scene> result = load_text("sphere { center = oops }\nsphere { radius = oops }", "a.glint");
    ASSERT_FALSE(result.diagnostics.empty());
    const Diagnostic& first = result.diagnostics[0];
    EXPECT_EQ(result.message, "a.glint:" + std::to_string(first.line) + ":" + std::to_string(first.column) +
                                  ": " + first.message);
    EXPECT_EQ(result.message.find('\n'), std::string::npos);
}

TEST(Load, ErrorsOfTheSceneHavePlaceAndItem) {
    const Result<Scene> result = load_text(
        "camera { position = (0, 0, 5) look_at = (0, 0, 0) }\nsphere { center = (0, 0, 0) radius = 1 }\n"
        "box { min = (1, 0, 0) max = (0, 0, 0) }\n",
        "a.glint");
    ASSERT_EQ(result.code, ErrorCode::invalid_scene) << to_string(result);
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].line, 3u);
    EXPECT_EQ(item_path(result.diagnostics[0]), "shapes[1]");
}

std::string many_spheres() {
    std::string text = "camera { position = (0, 0, 5) look_at = (0, 0, 0) }\n";
    for (int i = 0; i < 20000; ++i) text += "sphere { center = (0, 0, 0) radius = 1 }\n";
    return text;
}

TEST(Load, ReportsProgress) {
    const std::string text = many_spheres();
    const std::string_view spheres = std::string_view(text).substr(text.find('\n'));
    const SceneText texts[] = {
        {"a.glint", text, ""}, {"b.glint", spheres.substr(0, 41), ""}, {"c.glint", spheres, ""}};
    std::vector<double> fractions;
    LoadOptions options;
    options.progress = [&](double fraction) { fractions.push_back(fraction); };
    ASSERT_TRUE(load(texts, options));
    ASSERT_GT(fractions.size(), 50u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.back(), 1);
    for (std::size_t i = 1; i < fractions.size(); ++i) EXPECT_LT(fractions[i] - fractions[i - 1], 0.1);
}

// An included text that is much longer than the one that includes it.
TEST(Load, ReportsTheProgressOfIncludedTexts) {
    struct Spheres : Sources {
        Result<std::string> read(std::string_view, std::string_view) override { return many_spheres(); }
    } sources;
    std::vector<double> fractions;
    LoadOptions options;
    options.progress = [&](double fraction) { fractions.push_back(fraction); };
    ASSERT_TRUE(load_text("include \"spheres.glint\"\n", "a.glint", options, &sources));
    ASSERT_GT(fractions.size(), 20u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    for (std::size_t i = 1; i < fractions.size(); ++i) EXPECT_LT(fractions[i] - fractions[i - 1], 0.1);
}

TEST(Load, CanBeCancelled) {
    const std::string text = many_spheres();
    for (const double when : {0.0, 0.3, 0.9}) {
        std::atomic<bool> cancel{false};
        double last = 0;
        LoadOptions options;
        options.progress = [&](double fraction) {
            last = fraction;
            if (fraction >= when) cancel = true;
        };
        options.cancel = &cancel;
        const Result<Scene> result = load_text(text, "a.glint", options);
        EXPECT_FALSE(result);
        EXPECT_EQ(result.code, ErrorCode::cancelled);
        EXPECT_EQ(result.message, "cancelled");
        EXPECT_TRUE(result.diagnostics.empty());
        EXPECT_LT(last, when + 0.1) << "reading has stopped";
    }
}

}  // namespace
}  // namespace glint::test
