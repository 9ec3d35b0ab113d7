// SPDX-License-Identifier: Apache-2.0
#pragma once
// What check() says of a text.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "formats/load_text.h"
#include "glint/check.h"

namespace glint::test {

inline std::vector<Finding> check_loaded(const Scene& scene, std::span<const SceneText> texts = {}) {
    CheckOptions options;
    options.texts = texts;
    const std::vector<Finding> findings = check(scene, options).value();
    for (const Finding& f : findings) {
        // Notes are about models of many shapes or triangles.
        const bool may_note =
            (scene.shapes.size() > 64 || !scene.meshes.empty()) && f.diagnostic.severity == Severity::note;
        EXPECT_TRUE(may_note || f.diagnostic.severity == Severity::warning) << f.id;
        EXPECT_FALSE(f.diagnostic.message.empty()) << f.id;
        EXPECT_FALSE(f.remedy.empty()) << f.id;
    }
    return findings;
}

inline std::vector<Finding> check_text(std::string_view text, const std::string& name = "scene.glint") {
    const Result<Scene> loaded = load_text(text, name);
    EXPECT_TRUE(loaded) << messages(loaded);
    const SceneText texts[] = {{name, text, {}}};
    return check_loaded(loaded.value_or(Scene{}), texts);
}

/// "id@line id@line", in the order of the findings.
inline std::string ids(const std::vector<Finding>& findings) {
    std::string all;
    for (const Finding& f : findings)
        all += fmt::format("{}{}@{}", all.empty() ? "" : " ", f.id, f.diagnostic.line);
    return all;
}
inline std::string ids_of(std::string_view text, const std::string& name = "scene.glint") {
    return ids(check_text(text, name));
}

/// The only finding; its message and remedy, for a look at the words.
inline std::string only_message(std::string_view text, const std::string& name = "scene.glint") {
    const std::vector<Finding> result = check_text(text, name);
    EXPECT_EQ(result.size(), 1u) << ids(result);
    return result.empty() ? "" : to_string(result[0]);
}

inline bool has(const std::string& text, std::string_view part) {
    return text.find(part) != std::string::npos;
}

/// Lines 1 to 6: a small picture, a camera, two lights and three shapes, with nothing the matter.
inline const std::string k_clean =
    R"(render { size = 320 x 240 }  camera { position = (0, 2, 8)  look_at = (0, 0.5, 0)  fov_x = 50 }
light { type = ambient  intensity = 0.2 }
light "lamp" { position = (3, 6, 5)  intensity = 0.6 }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.5, 0.5, 0.5)  ambient = 1  diffuse = 0.9 }
sphere "left" { center = (-1.5, 1, 0)  radius = 1  color = (0.8, 0.3, 0.2)  ambient = 1  diffuse = 0.9 }
box { min = (0.5, 0, -0.5)  max = (1.5, 1, 0.5)  color = (0.2, 0.3, 0.8)  ambient = 1  diffuse = 0.9 }
)";

}  // namespace glint::test
