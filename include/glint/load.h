// SPDX-License-Identifier: Apache-2.0
#pragma once
// Text to Scene. The library opens no files: texts come from the caller or from the caller's Sources.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glint/callback.h"
#include "glint/export.h"
#include "glint/result.h"
#include "glint/scene.h"

namespace glint {

/// One text to read. The text must outlive the call.
struct SceneText {
    std::string name = {};  ///< used in messages; its extension selects the format if `format` is empty
    std::string_view text = {};
    std::string format = {};  ///< "cgfs", "epfl", ...; empty: by the name's extension
};

/// The source of texts that scenes include. load() reads files only through it.
class GLINT_API Sources {
  public:
    virtual ~Sources() = default;
    /// The text `name`, relative to the text `from`. A failure has ErrorCode::io and a message ("no such
    /// file").
    virtual Result<std::string> read(std::string_view name, std::string_view from) = 0;
};

struct LoadOptions {
    std::string profile = {};     ///< replaces the format's own profile; empty: the format's
    std::string scene_name = {};  ///< for files that hold several scenes
    /// KEY=VALUE pairs, applied last, with origin `command`.
    std::vector<std::pair<std::string, std::string>> settings = {};
    /// The text of a profile file (`key = value` lines) applied after `profile`, and its name for messages.
    std::optional<SceneText> profile_text = {};
    std::uint32_t max_errors = 20;  ///< reading stops after this many
    /// Called on the calling thread, at intervals, with the fraction of the texts that is read (0 to 1). Must
    /// not throw.
    Function<void(double)> progress = {};
    CancelFlag cancel = {};  ///< checked at intervals
    /// Bytes that reading may hold: the scene, and a reader's strings, arrays, objects and tokens. 0:
    /// default_max_memory() of the length of all texts, with those that they include. At times, up to twice
    /// as much is allocated.
    std::uint64_t max_memory = 0;
    /// Identifiers that a scene in POV-Ray's language finds declared, and their values; also `clock`. Other
    /// formats have no use for them.
    std::vector<std::pair<std::string, double>> declared = {};
    /// Objects that glint does not render are left out: a warning for each kind has their number
    /// (Diagnostic::left_out). Without this they are errors. Objects that are cut, and surfaces with
    /// patterns, are drawn without these, with a warning.
    bool skip_unsupported = false;
    /// The direction from the mesh to the eye, not 0, for files of meshes that are rendered by themselves
    /// (.ply, .stl, .obj); its lights turn with it. y is up, in views along y -z or z. By default the eye is
    /// in front (+z), a little to the right and above. An error for other scenes.
    std::optional<Vec3> view = {};
};

/// The default of LoadOptions::max_memory for texts of this length in bytes: 2 GiB and 256 times the length;
/// in the browser build 384 MiB and 64 times the length, at most 768 MiB.
GLINT_API std::uint64_t default_max_memory(std::uint64_t text_bytes);

/// Reads the texts as one scene, in their order, and validates it. The diagnostics (errors, warnings, notes)
/// are in the order of the text. Codes of failures: parse; io, if an included text cannot be read;
/// invalid_scene, if validate() finds errors in the scene that was read; invalid_argument, for invalid
/// options; cancelled; out_of_memory, with a diagnostic if it was LoadOptions::max_memory. Never throws.
GLINT_API Result<Scene> load(std::span<const SceneText> texts, const LoadOptions& options = {},
                             Sources* sources = nullptr);

/// A scene format that load() reads.
struct FormatInfo {
    std::string_view name;        ///< "cgfs"
    std::string_view extensions;  ///< ".cgfs", space-separated
    std::string_view profile;     ///< the conventions of its source
    std::string_view description;
    bool uses_size = false;  ///< a scene may depend on the size of its picture
};
GLINT_API std::span<const FormatInfo> formats();

/// The format that load() reads a text in.
struct FormatChoice {
    std::string_view format;  ///< FormatInfo::name; empty if there is none
    std::string reason;       ///< why this one, or why none
};
/// By SceneText::format or the name's extension. A .pov is `csc473` if its whole text is a scene of CSC 473,
/// else `povray`.
GLINT_API FormatChoice choose_format(const SceneText& text);

}  // namespace glint
