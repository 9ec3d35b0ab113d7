// SPDX-License-Identifier: Apache-2.0
// docs/checks.md has every kind, and no other; and what holds of any answer.
#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <regex>
#include <set>

#include "check/check_text.h"

namespace glint::test {
namespace {

TEST(CheckList, DocsNameEveryKind) {
    const std::string docs = read_whole_file(GLINT_SOURCE_DIR "/docs/checks.md");
    std::vector<std::string> documented, known;
    const std::regex heading("\n### `([a-z0-9-]+)`\n");
    for (std::sregex_iterator at(docs.begin(), docs.end(), heading), end; at != end; ++at)
        documented.push_back((*at)[1]);
    for (const CheckKind& kind : check_kinds()) known.emplace_back(kind.id);
    EXPECT_EQ(documented, known);
    EXPECT_EQ(std::set<std::string>(known.begin(), known.end()).size(), known.size());
}

TEST(CheckList, AnInvalidSceneIsNotChecked) {
    Scene scene;
    scene.add(Sphere{{0, 0, 0}, -1});
    const Result<std::vector<Finding>> result = check(scene);
    EXPECT_FALSE(result);
    EXPECT_EQ(result.code, ErrorCode::invalid_scene);
    EXPECT_TRUE(has_errors(result.diagnostics));
}

TEST(CheckList, ASceneMadeInCodeHasNoPlaces) {
    Scene scene;
    scene.camera.position = {0, 0, 8};
    scene.lights.push_back(Light{});
    scene.lights[0].position = {2, 3, 8};
    scene.lights[0].color = scene.lights[0].specular_color = {0.7, 0.7, 0.7};
    scene.add(Sphere{});
    scene.materials.push_back({});
    EXPECT_EQ(ids(check_loaded(scene)), "material-unused@0");
    const std::string text = to_string(check_loaded(scene)[0]);
    EXPECT_EQ(text.rfind("materials[0]: warning: no shape uses material 1 [material-unused]\n  remedy: ", 0),
              0u)
        << text;
}

TEST(CheckList, AnEmptySceneAndTheSmallestPicture) {
    EXPECT_EQ(ids(check_loaded(Scene{})), "");
    Scene scene;
    scene.settings.width = scene.settings.height = 1;
    scene.camera.position = {0, 0, 8};
    scene.add(Sphere{});
    EXPECT_EQ(ids(check_loaded(scene)), "picture-black@0");
}

TEST(CheckList, ReportsProgressAndCanBeCancelled) {
    const Scene scene = load_text(k_clean, "a.glint").value();
    std::vector<double> fractions;
    std::atomic<bool> cancel{false};
    CheckOptions options;
    options.threads = 1;
    options.progress = [&](double fraction) { fractions.push_back(fraction); };
    options.cancel = &cancel;
    ASSERT_TRUE(check(scene, options));
    ASSERT_GE(fractions.size(), 8u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_LT(fractions.front(), 0.5);
    EXPECT_EQ(fractions.back(), 1);
    // Wherever it is cancelled, it goes no further.
    for (std::size_t stop = 1; stop < fractions.size(); ++stop) {
        cancel = false;
        std::size_t calls = 0;
        options.progress = [&](double) { cancel = ++calls == stop || cancel; };
        EXPECT_EQ(check(scene, options).code, ErrorCode::cancelled) << stop;
        EXPECT_LE(calls, stop + 1);
    }
}

TEST(CheckList, TheFindingsDoNotDependOnThreads) {
    const std::string text = k_clean +
                             "light { position = (0, -3, 4) }\nsphere { center = (0, 1, 30)  radius = 0.5 }\n"
                             "disc { center = (0, 0, 2)  normal = (0, 1, 0)  radius = 1 }\n";
    const Result<Scene> loaded = load_text(text, "a.glint");
    ASSERT_TRUE(loaded);
    std::string first;
    for (const int threads : {1, 2, 5}) {
        CheckOptions options;
        options.threads = threads;
        std::string all;
        for (const Finding& f : check(*loaded, options).value()) all += to_string(f);
        if (first.empty()) first = all;
        EXPECT_EQ(all, first) << threads;
        EXPECT_FALSE(all.empty());
    }
}

}  // namespace
}  // namespace glint::test
