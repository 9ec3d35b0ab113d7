// SPDX-License-Identifier: Apache-2.0
// Nothing is the matter with the gallery, but with the scene that shows acne on purpose.
#include <filesystem>

#include "check/check_text.h"

namespace glint::test {
namespace {

namespace fs = std::filesystem;

std::string ids_of_files(const std::vector<std::string>& paths, const LoadOptions& options = {}) {
    std::vector<std::string> held;
    for (const std::string& path : paths) held.push_back(read_whole_file(path));
    std::vector<SceneText> texts;
    for (std::size_t i = 0; i < paths.size(); ++i) texts.push_back({paths[i], held[i], {}});
    FolderSources sources;
    const Result<Scene> loaded = load(texts, options, &sources);
    EXPECT_TRUE(loaded) << messages(loaded);
    return ids(check_loaded(loaded.value_or(Scene{})));
}

TEST(CheckGallery, IsClean) {
    int scenes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(GLINT_SOURCE_DIR "/scenes")) {
        const std::string path = entry.path().generic_string();
        // Halves of a scene, and parts that scenes include.
        if (!entry.is_regular_file() || has(path, "/only_") || has(path, "/parts/") || has(path, "/faults/"))
            continue;
        ++scenes;
        EXPECT_EQ(ids_of_files({path}), path.ends_with("/acne.glint") ? "epsilon-too-small@3" : "") << path;
    }
    EXPECT_GE(scenes, 26);
}

TEST(CheckGallery, SoAreScenesOfSeveralFilesAndSeveralInOne) {
    const std::string folder = GLINT_SOURCE_DIR "/scenes/";
    EXPECT_EQ(ids_of_files({folder + "cgfs/only_spheres.cgfs", folder + "cgfs/only_lights.cgfs"}), "");
    LoadOptions pipes;
    pipes.scene_name = "pipes";
    EXPECT_EQ(ids_of_files({folder + "epfl/two_scenes.js"}, pipes), "");
}

TEST(CheckGallery, TheDarkStage) {
    EXPECT_EQ(ids_of_files({GLINT_SOURCE_DIR "/scenes/faults/stage.glint"}),
              "spot-aimed-elsewhere@7 area-light-faces-away@8 light-inside-shape@9 "
              "area-light-too-many-samples@10");
}

TEST(CheckGallery, AsTheSourcesDrawIt) {
    // The gallery's scenes by the conventions of other sources: their epsilons are no mistake either.
    const std::string scene = GLINT_SOURCE_DIR "/scenes/glint/still_life.glint";
    for (const char* offset : {"ray", "normal", "facing", "direction"}) {
        LoadOptions options;
        options.settings = {{"offset", offset}, {"epsilon", "0.001"}};
        EXPECT_EQ(ids_of_files({scene}, options), "") << offset;
    }
}

}  // namespace
}  // namespace glint::test
