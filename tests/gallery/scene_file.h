// SPDX-License-Identifier: Apache-2.0
#pragma once
// The scene files of the gallery.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "glint/glint.h"

namespace glint::test {

/// The files that a scene includes.
class Beside : public Sources {
  public:
    Result<std::string> read(std::string_view name, std::string_view from) override {
        std::ostringstream text;
        const std::string folder(from.substr(0, from.rfind('/') + 1));
        text << std::ifstream(folder + std::string(name), std::ios::binary).rdbuf();
        return text.str();
    }
};

/// settings: "key=value key=value".
inline Result<Scene> load_file(const std::string& path, const std::string& settings = {}) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    const std::string held = text.str();
    const SceneText scene_text{path, held, ""};
    Beside beside;
    LoadOptions options;
    std::istringstream words(settings);
    for (std::string pair; words >> pair;)
        options.settings.emplace_back(pair.substr(0, pair.find('=')), pair.substr(pair.find('=') + 1));
    return load({&scene_text, 1}, options, &beside);
}

/// The paths of all whole scenes below a folder.
inline std::vector<std::string> scene_files(const std::string& folder) {
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string path = entry.path().string();
        // Parts of scenes, and files that other scenes include.
        const bool is_part =
            path.find("/only_") != std::string::npos || path.find("/parts/") != std::string::npos;
        if (entry.is_regular_file() && !is_part) paths.push_back(path);
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace glint::test
