// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes of texts in POV-Ray's language, for the tests of their reader.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "formats/load_text.h"
#include "glint/scene.h"

namespace glint::test {

inline constexpr double k_pov_near = 1e-12;

inline Result<Scene> read_povray(std::string_view text, Sources* sources = nullptr) {
    return load_text(text, "a.pov", {}, sources, "povray");
}

// The scene of a text that has at least one shape; notes and warnings are allowed.
inline Scene povray_scene(const std::string& text, Sources* sources = nullptr) {
    const Result<Scene> result = read_povray("light_source { <0, 0, -9>, rgb 1 }\n" + text, sources);
    EXPECT_TRUE(result) << messages(result);
    return result.value_or(Scene{});
}

inline void expect_vec(Vec3 a, Vec3 b) {
    EXPECT_NEAR(a.x, b.x, k_pov_near);
    EXPECT_NEAR(a.y, b.y, k_pov_near);
    EXPECT_NEAR(a.z, b.z, k_pov_near);
}

class TextSources : public Sources {
  public:
    explicit TextSources(std::map<std::string, std::string, std::less<>> texts) : texts_(std::move(texts)) {}
    Result<std::string> read(std::string_view name, std::string_view) override {
        const auto at = texts_.find(name);
        if (at != texts_.end()) return at->second;
        return Status{ErrorCode::io, "no such file", {}};
    }

  private:
    std::map<std::string, std::string, std::less<>> texts_;
};

}  // namespace glint::test
