// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene's likely mistakes: what can be rendered, but is probably not intended. docs/checks.md explains
// each.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "glint/callback.h"
#include "glint/diagnostic.h"
#include "glint/export.h"
#include "glint/load.h"
#include "glint/result.h"
#include "glint/scene.h"

namespace glint {

struct CheckOptions {
    int threads = 0;  ///< 0: one per processor; the findings do not depend on it
    /// The texts that the scene was read from, each under its name in Scene::files, for the source lines in
    /// the findings. Texts may be missing.
    std::span<const SceneText> texts = {};
    /// Called on the calling thread, at intervals, with the fraction done (0 to 1). Must not throw.
    Function<void(double)> progress = {};
    CancelFlag cancel = {};  ///< checked at intervals
};

/// One likely mistake.
struct Finding {
    std::string_view id;  ///< one of check_kinds(), such as "camera-inside-shape"
    /// A warning with its place and the numbers involved; a note if the picture is as it should be all the
    /// same (materials that nothing uses in an exported model).
    Diagnostic diagnostic;
    std::string remedy;  ///< how to correct it
};

/// Looks for mistakes: traces the camera's rays, follows them into mirrors and glass, and renders
/// small pictures with and without a light, with another epsilon, with one reflection more. Findings are in
/// the order of the text; those without a place are last. They do not depend on threads or machine. The
/// diagnostics are what validate() says; with an error among them nothing is checked. The time is that of a
/// few pictures, n log n in the number of shapes. Never throws.
GLINT_API Result<std::vector<Finding>> check(const Scene& scene, const CheckOptions& options = {});

/// A kind of finding.
struct CheckKind {
    std::string_view id;
    std::string_view description;  ///< one line
};

/// All kinds, sorted by subject.
GLINT_API std::span<const CheckKind> check_kinds();

/// The finding as text: its diagnostic and id, then "  remedy: ..."; ends with a newline.
GLINT_API std::string to_string(const Finding& finding);

}  // namespace glint
