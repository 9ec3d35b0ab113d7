// SPDX-License-Identifier: Apache-2.0
// load() with texts that are not scenes.
#include <stdexcept>

#include "misuse/misused.h"

namespace glint::test {
namespace {

constexpr std::string_view k_text =
    "camera { position = (0, 0, 5) look_at = (0, 0, 0) }\nsphere { center = (0, 0, 0) radius = 1 }\n";

void expect_error(const Result<Scene>& result, const char* what) {
    EXPECT_FALSE(result) << what;
    EXPECT_NE(result.message, "") << what;
    EXPECT_EQ(has_errors(result.diagnostics), result.code != ErrorCode::internal) << what;
    for (const Diagnostic& d : result.diagnostics) EXPECT_FALSE(d.message.empty()) << what;
}

TEST(Misuse, OfTexts) {
    expect_error(load({}), "no text");
    const SceneText empty{};
    expect_error(load({&empty, 1}), "a text without a name");
    for (const char* const name : {"", ".", "a", "a.txt", "glint", ".glint"}) {
        const SceneText text{name, k_text, ""};
        expect_error(load({&text, 1}), name);
    }
    const SceneText unknown{"a.glint", k_text, "no format"};
    expect_error(load({&unknown, 1}), "an unknown format");
    std::string every(256, ' ');
    for (int c = 0; c < 256; ++c) every[static_cast<std::size_t>(c)] = static_cast<char>(c);
    for (const FormatInfo& format : formats()) {
        const SceneText noise{"a", every, std::string(format.name)};
        expect_error(load({&noise, 1}), "every byte");
        const SceneText other{"a", "sphere {", std::string(format.name)};
        expect_error(load({&other, 1}), "half a shape");
    }
    for (const SceneText& text :
         {empty, unknown, SceneText{"a.", every, ""}, SceneText{"a.pov", every, ""}}) {
        const FormatChoice choice = choose_format(text);
        EXPECT_EQ(choice.format, text.name == "a.pov" ? "povray" : "") << text.name;
        EXPECT_FALSE(choice.reason.empty()) << text.name;
    }
    const std::vector<SceneText> many(70000, SceneText{"a.glint", "", ""});
    expect_error(load(many), "too many texts");
}

TEST(Misuse, OfLoadOptions) {
    const SceneText text{"a.glint", k_text, ""};
    EXPECT_TRUE(load({&text, 1}));
    LoadOptions options;
    options.profile = "no profile";
    expect_error(load({&text, 1}, options), "profile");
    for (const auto& setting : std::vector<std::pair<std::string, std::string>>{
             {"", ""}, {"none", "1"}, {"size", "0x0"}, {"aa", std::string(9999, '1')}, {"size", ""}}) {
        options = {};
        options.settings = {setting};
        expect_error(load({&text, 1}, options), "a setting");
    }
    options = {};
    options.profile_text = SceneText{"", "no equals sign", "none"};
    expect_error(load({&text, 1}, options), "profile text");
    const SceneText wrong{"a.glint", "x y z", ""};
    for (const std::uint32_t errors : {0u, std::numeric_limits<std::uint32_t>::max()}) {
        options = {};
        options.max_errors = errors;
        expect_error(load({&wrong, 1}, options), "most errors");
    }
    options = {};
    const std::atomic<bool> cancel{true};
    options.cancel = &cancel;
    EXPECT_EQ(load({&text, 1}, options).code, ErrorCode::cancelled);
    options = {};
    options.scene_name = "no such scene";
    const SceneText two{"a.js", "export const a = {};", ""};
    expect_error(load({&two, 1}, options), "scene name");
}

// Sources with faulty implementations.
struct OddSources : Sources {
    enum { throws, repeats, gives_noise, says_nothing } what = throws;
    Result<std::string> read(std::string_view, std::string_view) override {
        if (what == throws) throw std::runtime_error("the disk is gone");
        if (what == repeats) return std::string("include \"b.glint\" include \"c.glint\"");
        if (what == gives_noise) return std::string(1000, '\xff');
        return Status{ErrorCode::io, "", {}};
    }
};

TEST(Misuse, OfSources) {
    const std::string including = std::string(k_text) + "include \"b.glint\"\n";
    const SceneText text{"a.glint", including, ""};
    expect_error(load({&text, 1}, {}, nullptr), "no sources");
    OddSources sources;
    for (const auto what :
         {OddSources::throws, OddSources::repeats, OddSources::gives_noise, OddSources::says_nothing}) {
        sources.what = what;
        const Result<Scene> result = load({&text, 1}, {}, &sources);
        expect_error(result, "odd sources");
        EXPECT_EQ(result.code == ErrorCode::internal, what == OddSources::throws) << result.message;
    }
}

}  // namespace
}  // namespace glint::test
