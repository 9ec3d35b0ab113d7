// SPDX-License-Identifier: Apache-2.0
#pragma once
// The fuzzing of the logs of ray tracers: each has an answer.
#include <algorithm>
#include <string>
#include <string_view>

#include "glint/diagnose.h"
#include "glint/load.h"

namespace glint::test {

struct LoggedScene {
    Scene scene;
    World world;
};

inline const LoggedScene& logged_scene() {
    static const LoggedScene one = [] {
        const std::string text =
            "sphere { center = (0, 0, 4) radius = 1 color = (255, 0, 0) specular = 10 reflective = 0.5 }\n"
            "sphere { center = (0, -101, 4) radius = 100 color = (0, 255, 0) }\n"
            "light { type = ambient intensity = 0.2 }\n"
            "light { type = point intensity = 0.6 position = (2, 1, 0) }\n";
        const SceneText file{"a.cgfs", text};
        LoadOptions options;
        options.settings = {{"size", "8x8"}};
        LoggedScene made{load({&file, 1}, options).value(), {}};
        made.world = prepare(made.scene).value();
        return made;
    }();
    return one;
}

/// Compares the log with a small scene. Returns what is wrong with the answer, or an empty string.
inline std::string fuzz_trace_log(std::string_view log) {
    const LoggedScene& of = logged_scene();
    DiagnoseOptions options;
    options.threads = 1;
    const Result<Diagnosis> answer = diagnose(of.scene, of.world, log, options);
    if (!answer) return answer.message.empty() ? "a failure without a message" : "";
    if (!diagnosis_json(*answer, of.scene)) return "no JSON";
    if (answer->wrong_pixels > answer->pixels) return "more wrong pixels than there are";
    for (const DiagnosisFinding& finding : answer->findings) {
        if (finding.is_sure && (finding.causes.size() != 1 || finding.pixels < 3))
            return "a cause is sure without three pixels";
        if (finding.places == 0) return "a finding without a place";
    }
    return "";
}

}  // namespace glint::test
