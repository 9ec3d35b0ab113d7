// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene's likely mistakes: what can be drawn, and is hardly what was meant. docs/checks.md explains each.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glint/diagnostic.h"
#include "glint/export.h"
#include "glint/load.h"
#include "glint/scene.h"

namespace glint {

struct CheckOptions {
    int threads = 0;  ///< 0 = one a processor; the findings are the same
    /// The texts that the scene was read from, for the source lines in the findings; each under its name in
    /// Scene::files. They need not be all.
    std::span<const SceneText> texts;
};

/// One likely mistake.
struct Finding {
    std::string_view id;    ///< one of check_kinds(): "camera-inside-shape"
    Diagnostic diagnostic;  ///< a warning: where, and what is the matter, with its numbers
    std::string remedy;     ///< what to change
};

struct CheckResult {
    std::vector<Finding> findings;        ///< in the order of the text; what has no place comes last
    std::vector<Diagnostic> diagnostics;  ///< what validate() says; with an error nothing was checked
    std::string error;                    ///< "out of memory"; empty if none
};

/// Looks for mistakes: traces the camera's rays, follows them into mirrors and glass, and draws small
/// pictures, with and without what is under suspicion. The findings do not depend on threads or machine. The
/// time is that of a few pictures, n log n in the number of shapes. Never throws.
GLINT_API CheckResult check(const Scene& scene, const CheckOptions& options = {});

/// A kind of finding.
struct CheckKind {
    std::string_view id;
    std::string_view description;  ///< one line
};

/// All kinds, by subject.
GLINT_API std::span<const CheckKind> check_kinds();

/// The finding as text: its diagnostic, with the id, then "  remedy: ..."; ends with a newline.
GLINT_API std::string to_string(const Finding& finding);

}  // namespace glint
