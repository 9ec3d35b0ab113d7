// SPDX-License-Identifier: Apache-2.0
#pragma once
// The texts of the corpora.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace glint::test {

inline std::string corpus_folder(const std::string& name) {
    return GLINT_SOURCE_DIR "/tests/fuzz/corpus/" + name;
}

/// Calls body(text, path) for every file of a corpus; returns how many there are.
template <class Body> int for_each_text(const std::string& corpus, Body&& body) {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(corpus_folder(corpus))) {
        std::ifstream file(entry.path(), std::ios::binary);
        std::stringstream text;
        text << file.rdbuf();
        body(text.str(), entry.path().string());
        ++files;
    }
    return files;
}

}  // namespace glint::test
