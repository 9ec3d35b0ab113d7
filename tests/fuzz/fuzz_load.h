#pragma once
// What a fuzzer does with a text: load it and look at the answer.
#include <string>
#include <string_view>

#include "glint/load.h"

namespace glint {

/// Loads the text; an empty string, or what is wrong with the answer.
inline std::string fuzz_load(std::string_view text, std::string format) {
    const SceneText texts[] = {{"fuzz", text, std::move(format)}};
    const LoadResult result = load(texts);
    std::string printed;
    for (const Diagnostic& d : result.diagnostics) printed += to_string(d);
    if (result.scene.has_value() == has_errors(result.diagnostics))
        return "a scene and an error, or neither: " + printed;
    for (const Diagnostic& d : result.diagnostics) {
        if (d.severity == Severity::error && d.line == 0) return "an error without a place: " + d.message;
    }
    if (result.scene && has_errors(validate(*result.scene))) return "a scene that is not valid";
    return {};
}

}  // namespace glint
