// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scenes as texts of glint's own language, so that faults can be planted by editing the text, and their
// pictures.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>
#include <span>
#include <string>
#include <vector>

#include "glint/glint.h"

namespace glint::test {

/// Every match of `pattern` by `with`, which may use $1...; fails the test if there is none.
inline std::string replaced(const std::string& text, const std::string& pattern, const std::string& with) {
    const std::regex regex(pattern);
    EXPECT_TRUE(std::regex_search(text, regex)) << pattern;
    return std::regex_replace(text, regex, with);
}

/// The number in the first group of every match, times factor.
inline std::string scaled_numbers(const std::string& text, const std::string& pattern, double factor) {
    const std::regex regex(pattern);
    std::string out;
    auto rest = text.cbegin();
    for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) {
        out.append(rest, (*it)[1].first);
        out += std::to_string(std::stod((*it)[1]) * factor);
        rest = (*it)[1].second;
    }
    EXPECT_NE(rest, text.cbegin()) << pattern;
    return out.append(rest, text.cend());
}

/// A setting or convention, in a line before the others'.
inline std::string with_key(const std::string& text, const std::string& key, const std::string& value) {
    return replaced(text, "\nrender \\{", "\nconventions { " + key + " = " + value + " }\nrender {");
}

/// Every light but the ambient one with these words more.
inline std::string with_light_words(const std::string& text, const std::string& words) {
    return replaced(text, "(type = (point|directional)[^}]*)\\}", "$1 " + words + " }");
}

/// All lights, the ambient one too, this many times as bright.
inline std::string with_light(const std::string& text, double factor) {
    const bool all_say = std::regex_search(text, std::regex("(point|directional)[^}]*intensity"));
    const std::string out = scaled_numbers(text, "intensity = ([0-9.]+)", factor);
    return all_say ? out : with_light_words(out, "intensity = " + std::to_string(factor));
}

inline Scene read_scene(const std::string& text) {
    const SceneText texts[] = {{"planted.glint", text, {}}};
    Result<Scene> result = load(texts);
    for (const Diagnostic& d : result.diagnostics) {
        if (d.severity == Severity::error) ADD_FAILURE() << to_string(d) << text;
    }
    return result ? *std::move(result) : Scene{};
}

inline Image draw(const Scene& scene) {
    const Result<World> prepared = prepare(scene);
    if (!prepared) {
        ADD_FAILURE() << "not prepared";
        return {};
    }
    return render(*prepared).value().image;
}

/// What a file of 8 bits holds of it.
inline Image as_file(const Image& image) {
    const Result<std::vector<std::uint8_t>> encoded = encode(image, {FileFormat::ppm});
    return decode(*encoded).value().image;
}

inline Image draw_text(const std::string& text) { return as_file(draw(read_scene(text))); }

/// A ball behind every lamp as seen from the origin, so large that it takes the light of a part of the
/// picture if shadow rays do not end at the lamp.
inline std::string with_balls_behind_lights(std::string text) {
    const std::regex lamp("type = point  position = \\(([^,]*), ([^,]*), ([^)]*)\\)");
    std::string balls;
    for (std::sregex_iterator it(text.begin(), text.end(), lamp), end; it != end; ++it) {
        const double x = std::stod((*it)[1]), y = std::stod((*it)[2]), z = std::stod((*it)[3]);
        const double radius = 0.5 * std::sqrt(x * x + y * y + z * z);
        balls += "sphere { center = (" + std::to_string(1.6 * x) + ", " + std::to_string(1.6 * y) + ", " +
                 std::to_string(1.6 * z) + ")  radius = " + std::to_string(radius) +
                 "  ambient = 0.1  diffuse = 0.8  specular = 0.1  shininess = 20 }\n";
    }
    return text + balls;
}

struct TestScene {
    std::string name;  ///< below scenes/
    std::string text;  ///< in glint's own language, at 160 x 120 and one sample a pixel
};

/// The scene of a file. Its light, mirrors and background are such that every classic fault shows.
inline TestScene test_scene(const std::string& name) {
    std::ifstream file(GLINT_SOURCE "/scenes/" + name);
    const std::string source{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const SceneText texts[] = {{name, source, {}}};
    const Result<Scene> result = load(texts);
    EXPECT_TRUE(result.has_value()) << name;
    std::string text = write_glint(*result).value();
    text = replaced(text, "size = [0-9]+ x [0-9]+", "size = 160 x 120");
    text = replaced(text, "aa = [0-9]+", "aa = 1");
    text = replaced(text, "reflections = [0-9]+", "reflections = 2");
    text = replaced(text, "background = \\([^)]*\\)", "background = (0.25, 0.35, 0.5)");
    text = replaced(text, "(type = point[^}]*)\\}", "$1 attenuation = (1, 0.02, 0.0003) }");
    text = with_key(text, "mirror_miss", "background");
    return {name, with_balls_behind_lights(text)};
}

inline const std::vector<TestScene>& test_scenes() {
    static const std::vector<TestScene> scenes = {
        test_scene("cgfs/three_mirrors.cgfs"), test_scene("epfl/castle.json"),
        test_scene("epfl/three_lights.json"), test_scene("glint/still_life.glint")};
    return scenes;
}

/// How many of these scenes a test goes through. Sanitizers look for faults of memory and of threads: one
/// scene runs the same code as four, and four take most of an hour.
#if defined(GLINT_SANITIZED)
inline constexpr int k_scenes_to_test = 1;
#else
inline constexpr int k_scenes_to_test = 4;
#endif
inline std::span<const TestScene> scenes_to_test() {
    return std::span(test_scenes()).first(k_scenes_to_test);
}

/// The first cause's name, or "none"; after it all of the report.
inline std::string first_cause(const Result<CauseReport>& report) {
    if (!report) return "none " + report.message;
    return report->causes.empty() ? "none" : report->causes.front().name;
}
inline std::string all_causes(const Result<CauseReport>& result) {
    std::string text = result.message + "\n";
    const CauseReport report = result.value_or(CauseReport{});
    for (const Cause& cause : report.causes)
        text += cause.name + " " + std::to_string(cause.explained) + " " + cause.explanation + "\n";
    return text;
}

}  // namespace glint::test
