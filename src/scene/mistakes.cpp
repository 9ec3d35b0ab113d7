// SPDX-License-Identifier: Apache-2.0
#include "scene/mistakes.h"

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

}  // namespace glint
