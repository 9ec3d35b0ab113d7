// SPDX-License-Identifier: Apache-2.0
#pragma once
// The fuzzing of scenes: write them as .glint and read that again; render them.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <string_view>

#include "formats/scene_fingerprint.h"
#include "fuzz/fuzz_load.h"
#include "glint/glint.h"

namespace glint::test {

/// Loads the text; if it is a scene, writes it and loads it again. Returns the first difference, or an empty
/// string.
inline std::string fuzz_convert(std::string_view text, std::string format) {
    const SceneText texts[] = {{"fuzz", text, std::move(format)}};
    const Result<Scene> first = load_few_steps(texts);
    if (!first) return {};
    const std::string written = write_glint(*first, texts).value();
    if (written.empty()) return "a scene that is not written";
    const SceneText written_texts[] = {{"fuzz.glint", written, {}}};
    const Result<Scene> second = load(written_texts);
    if (!second) {
        std::string all = "what was written is not read:\n";
        for (const Diagnostic& d : second.diagnostics) all += to_string(d);
        return all + written;
    }
    const std::string difference = test::first_difference(*first, *second);
    if (!difference.empty()) return "another scene was read:\n" + difference + '\n' + written;
    const std::string again = write_glint(*second, written_texts).value();
    return again == written ? std::string() : "written again:\n" + written + "\nnow:\n" + again;
}

/// Explains some pixels of a picture. Returns an error message or an empty string.
inline std::string fuzz_explain(const Scene& scene, const World& world, const Image& image) {
    for (const int x : {0, image.width / 2, image.width - 1}) {
        const int y = x * (image.height - 1) / std::max(image.width - 1, 1);
        const Result<Explanation> explained = explain(scene, world, x, y);
        if (!explained) return "a pixel that is not explained: " + explained.message;
        const Explanation& e = *explained;
        const float* drawn = &image.rgb[3 * static_cast<std::size_t>(y * image.width + x)];
        if (std::memcmp(e.value, drawn, sizeof(e.value)) != 0)
            return "a pixel that is explained to be another";
        if (explanation_json(e, scene).value_or({}).size() < 100) return "an explanation without JSON";
    }
    return {};
}

/// Few samples of everything, so that a scene that asks for many is not reported as one that hangs.
inline void reduce_samples(Scene& scene) {
    RenderSettings& settings = scene.settings;
    settings.width = std::min(settings.width, 16);
    settings.height = std::min(settings.height, 16);
    settings.samples = 1;
    settings.reflections = std::min(settings.reflections, 3);
    for (Light& light : scene.lights) {
        light.samples_u = std::min(light.samples_u, 4);
        light.samples_v = std::min(light.samples_v, 4);
    }
    if (scene.occlusion) scene.occlusion->samples = std::min(scene.occlusion->samples, 16);
}

/// Loads the text; if it is a scene, renders it with few pixels and explains some of them. Returns an error
/// message or an empty string.
inline std::string fuzz_render(std::string_view text, std::string format) {
    const SceneText texts[] = {{"fuzz", text, std::move(format)}};
    Result<Scene> loaded = load_few_steps(texts);
    if (!loaded) return {};
    reduce_samples(*loaded);
    const Result<World> prepared = prepare(*loaded, {.threads = 1});
    if (!prepared) return "a scene that load() takes and prepare() does not";
    RenderOptions options;
    options.threads = 1;
    const Result<Rendering> result = render(*prepared, options);
    if (!result) return "no picture: " + result.message;
    for (const float channel : result->image.rgb) {
        if (std::isnan(channel)) return "a pixel that is not a number";
    }
    return fuzz_explain(*loaded, *prepared, result->image);
}

}  // namespace glint::test
