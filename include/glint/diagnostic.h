// SPDX-License-Identifier: Apache-2.0
#pragma once
// Messages about input. The library never prints; it returns these.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "glint/export.h"

namespace glint {

/// note: an interpretation of ambiguous input, which is not a mistake. warning:
/// likely a mistake.
enum class Severity : std::uint8_t { note, warning, error };

/// A place in one of the texts that a scene was read from. Lines and columns count from 1; columns count
/// bytes. line 0: no place (an item made in code, or a default).
struct SourcePlace {
    std::uint32_t line = 0;
    std::uint16_t column = 0;  // saturates at 65535
    std::uint16_t file = 0;    // index into Scene::files
    friend bool operator==(const SourcePlace&, const SourcePlace&) = default;
};

/// The parts of a Scene that a message can be about. Those from `light` to `shape`, and textures, are lists.
enum class SceneItem : std::uint8_t {
    none,
    camera,
    background,
    setting,
    light,
    material,
    transform,
    shape,
    fog,
    texture
};

/// One message about the input: where, what was expected, what was found.
struct Diagnostic {
    Severity severity = Severity::error;
    std::string file;          ///< as the user named it; empty if the message has no place
    std::uint32_t line = 0;    ///< from 1; 0: about the file or the scene as a whole
    std::uint32_t column = 0;  ///< in bytes from 1
    std::uint32_t length = 0;  ///< bytes to underline, at least 1 if there is a place (0 counts as 1)
    std::string message;       ///< the complete message, such as "expected a number, found 'abc'"
    std::string source_line;   ///< the line's text around the place, for the caret; may be shortened
    std::uint32_t caret = 0;   ///< byte offset of the place within source_line
    /// The item that the message is about, for scenes from text and scenes made in code. index: in
    /// Scene::lights, materials, transforms, shapes or textures, or for a setting in setting_keys(); 0 for
    /// the camera, the background and the fog.
    SceneItem item = SceneItem::none;
    std::uint32_t index = 0;
    /// The number of objects that this warning says are left out (LoadOptions::skip_unsupported).
    std::uint32_t left_out = 0;
    /// Whether this error is about something that LoadOptions::skip_unsupported leaves out.
    bool can_skip = false;
};

/// The item as a path in the Scene: "lights[1]", "camera", "settings". Empty if the message is about none.
GLINT_API std::string item_path(const Diagnostic& diagnostic);

/// "file:line:col: error: message" (or warning, or note), the source line, and a caret under the place; ends
/// with a newline. Without a file the path of an item of a list is in its place: "lights[1]: error: message".
GLINT_API std::string to_string(const Diagnostic& diagnostic);

/// True if any is an error.
GLINT_API bool has_errors(const std::vector<Diagnostic>& diagnostics);

/// The number of warnings.
GLINT_API std::size_t count_warnings(const std::vector<Diagnostic>& diagnostics);

}  // namespace glint
