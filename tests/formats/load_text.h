// SPDX-License-Identifier: Apache-2.0
#pragma once
// Loads one text, and checks the properties of every result.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "base/text.h"
#include "glint/load.h"

namespace glint::test {

inline Result<Scene> load_text(std::string_view text, std::string name, LoadOptions options = {},
                               Sources* sources = nullptr, std::string format = {}) {
    const SceneText texts[] = {{std::move(name), text, std::move(format)}};
    return load(texts, options, sources);
}

inline std::string messages(const Result<Scene>& result) {
    std::string all;
    for (const Diagnostic& d : result.diagnostics) all += to_string(d);
    return all;
}

/// The scene of a text without diagnostics.
inline Scene quiet_scene(std::string_view text, std::string name) {
    const Result<Scene> result = load_text(text, std::move(name));
    EXPECT_TRUE(result) << messages(result);
    EXPECT_EQ(messages(result), "");
    return result.value_or(Scene{});
}

inline std::string read_whole_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Files in the folder of the one that includes them.
class FolderSources : public Sources {
  public:
    Result<std::string> read(std::string_view name, std::string_view from) override {
        const std::string path = std::string(from.substr(0, from.rfind('/') + 1)) + std::string(name);
        std::string text = read_whole_file(path);
        if (!text.empty()) return text;
        return Status{ErrorCode::io, "no such file", {}};
    }
};

inline bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t n = utf8_length(text);
        if (n == 0) return false;
        text.remove_prefix(n);
    }
    return true;
}

/// A scene or an error, never both; every error has a place within the text and a message.
inline std::string what_is_wrong(const Result<Scene>& result, std::string_view text) {
    if (result.has_value() == has_errors(result.diagnostics)) return "a scene and an error, or neither";
    if (result && has_errors(validate(*result))) return "a scene that is not valid";
    for (const Diagnostic& d : result.diagnostics) {
        if (d.message.empty()) return "a message without text";
        if (!is_utf8(d.message) || !is_utf8(d.source_line))
            return "a message that is not UTF-8: " + d.message;
        if (d.severity != Severity::error && d.line == 0) continue;  // about the scene as a whole
        if (d.line == 0 || d.column == 0 || d.length == 0) return "no place: " + d.message;
        const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
        if (d.line > lines) return "a line beyond the text: " + d.message;
        if (d.caret > d.source_line.size()) return "a caret beyond the line: " + d.message;
    }
    return {};
}

}  // namespace glint::test
