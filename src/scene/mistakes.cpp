// SPDX-License-Identifier: Apache-2.0
#include "scene/mistakes.h"

#include <algorithm>

#include "scene/validated_scene.h"

namespace glint {

std::vector<Diagnostic> to_diagnostics(std::vector<Mistake> mistakes, const Scene& scene) {
    std::vector<Diagnostic> diagnostics;
    for (Mistake& mistake : mistakes) {
        Diagnostic d;
        d.severity = mistake.severity;
        d.message = std::move(mistake.message);
        d.item = mistake.item;
        d.index = mistake.index;
        if (mistake.place.line != 0 && mistake.place.file < scene.files.size()) {
            d.file = scene.files[mistake.place.file];
            d.line = mistake.place.line;
            d.column = mistake.place.column;
            d.length = 1;
        }
        diagnostics.push_back(std::move(d));
    }
    return diagnostics;
}

std::vector<Diagnostic> validate(const Scene& scene) { return to_diagnostics(find_mistakes(scene), scene); }

std::optional<ValidatedScene> ValidatedScene::take(Scene& scene, std::vector<Mistake>& mistakes) {
    mistakes = find_mistakes(scene);
    const bool is_wrong = std::any_of(mistakes.begin(), mistakes.end(),
                                      [](const Mistake& m) { return m.severity == Severity::error; });
    if (is_wrong) return std::nullopt;
    std::vector<Diagnostic> warnings = to_diagnostics(mistakes, scene);
    return ValidatedScene(std::move(scene), std::move(warnings));
}

}  // namespace glint
