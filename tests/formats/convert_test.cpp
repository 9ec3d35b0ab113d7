// SPDX-License-Identifier: Apache-2.0
// A scene converted to .glint renders to the same bits.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "formats/load_text.h"
#include "formats/random_scene.h"
#include "formats/scene_fingerprint.h"
#include "glint/glint.h"

namespace glint::test {
namespace {

std::string errors_of(const Result<Scene>& result) {
    std::string all;
    for (const Diagnostic& d : result.diagnostics) {
        if (d.severity == Severity::error) all += to_string(d);
    }
    return all;
}

std::vector<float> small_picture(Scene scene) {
    scene.settings.width = 16;
    scene.settings.height = 12;
    scene.settings.samples = 1;
    scene.settings.reflections = std::min(scene.settings.reflections, 4);
    // first_difference() has compared the numbers of samples.
    if (scene.occlusion) scene.occlusion->samples = std::min(scene.occlusion->samples, 16);
    for (Light& light : scene.lights) {
        light.samples_u = std::min(light.samples_u, 4);
        light.samples_v = std::min(light.samples_v, 4);
    }
    const Result<World> prepared = prepare(scene);
    if (!prepared) return {};
    Result<Rendering> result = render(*prepared);
    return result ? std::move(result->image.rgb) : std::vector<float>();
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
        return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
    });
}

// Writes the scene, reads it again, and compares; returns the text.
std::string expect_same(const Scene& scene, std::span<const SceneText> texts, const std::string& what) {
    const std::string text = write_glint(scene, texts).value();
    EXPECT_FALSE(text.empty()) << what;
    const Result<Scene> again = load_text(text, "again.glint");
    EXPECT_TRUE(again) << what << '\n' << errors_of(again) << text.substr(0, 2000);
    if (!again) return text;
    EXPECT_EQ(test::first_difference(scene, *again), "") << what << '\n' << text.substr(0, 2000);
    const std::vector<float> picture = small_picture(scene);
    EXPECT_FALSE(picture.empty()) << what;
    EXPECT_TRUE(same_bits(picture, small_picture(*again))) << what;
    // Converting again changes nothing, comments included.
    const SceneText written{"again.glint", text, {}};
    if (!texts.empty()) {
        EXPECT_EQ(write_glint(*again, {&written, 1}).value(), text) << what;
    }
    EXPECT_EQ(write_glint(*again).value(), write_glint(scene).value()) << what;
    return text;
}

class Files : public Sources {
  public:
    Result<std::string> read(std::string_view name, std::string_view from) override {
        return read_whole_file(std::string(from.substr(0, from.rfind('/') + 1)) + std::string(name));
    }
};

// False if the text is not a scene.
bool expect_same_file(const std::string& path, const std::string& format) {
    const std::string text = read_whole_file(path);
    const SceneText texts[] = {{path, text, format}};
    Files files;
    const Result<Scene> loaded = load(texts, {}, &files);
    if (loaded) expect_same(*loaded, texts, path);
    return loaded.has_value();
}

TEST(Convert, TheGallery) {
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(GLINT_SOURCE_DIR "/scenes")) {
        if (!entry.is_regular_file()) continue;
        const std::string path = entry.path().string();
        const bool is_part = path.find("/parts/") != std::string::npos;  // of a scene that includes it
        EXPECT_TRUE(expect_same_file(path, {}) || is_part) << path;
        ++count;
    }
    EXPECT_GE(count, 9);
}

TEST(Convert, TheFuzzersCorpus) {
    int count = 0;
    for (const auto& folder : std::filesystem::directory_iterator(GLINT_SOURCE_DIR "/tests/fuzz/corpus")) {
        const std::string format = folder.path().filename().string();
        const auto known = formats();
        if (std::none_of(known.begin(), known.end(), [&](const FormatInfo& f) { return f.name == format; }))
            continue;
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            count += expect_same_file(entry.path().string(), format) ? 1 : 0;
        }
    }
    EXPECT_GE(count, 10);
}

TEST(Convert, EverySettingChanged) {
    for (std::size_t key = 0; key < setting_keys().size(); ++key) {
        for (const std::string_view profile : profile_names()) {
            Scene scene;
            apply_profile(scene, profile);
            scene.add(Sphere{{0, 0, -4}, 1});
            const std::string before = get_setting(scene, key);
            std::vector<std::string> candidates = {"0.015625", "1e-300", "0", "1", "7", "31x17"};
            std::istringstream words{std::string(setting_keys()[key].values)};  // "keep | drop"
            for (std::string word; words >> word;) candidates.push_back(word);
            int changes = 0;
            for (const std::string& value : candidates) {
                if (value == before || !set_setting(scene, key, value, {})) continue;
                ++changes;
                expect_same(scene, {}, std::string(setting_keys()[key].name) + " = " + value);
            }
            EXPECT_GE(changes, 1) << setting_keys()[key].name;
        }
    }
}

TEST(Convert, TheLargestPolygon) {
    Scene scene;
    for (std::uint32_t i = 0; i < k_max_polygon_vertices; ++i) {
        const double x = i / 1024.0 - 2;
        scene.polygon_vertices.push_back({x, x * x - 1 + 1e-17 * i, -5});
    }
    scene.add(Polygon{0, k_max_polygon_vertices});
    expect_same(scene, {}, "polygon");
}

TEST(Convert, RandomScenes) {
    int valid = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        const Scene scene = test::RandomScene(seed).make();
        if (has_errors(validate(scene))) {
            EXPECT_EQ(write_glint(scene).code, ErrorCode::invalid_scene);
            continue;
        }
        ++valid;
        expect_same(scene, {}, "seed " + std::to_string(seed));
        if (HasFailure()) return;
    }
    EXPECT_GE(valid, 100);
}

}  // namespace
}  // namespace glint::test
