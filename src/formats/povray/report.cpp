// SPDX-License-Identifier: Apache-2.0
// What is not rendered of POV-Ray: messages, and objects that are left out.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/povray/scene_builder.h"

namespace glint::povray {
namespace {

// The word as the text has it: of a pattern, it can be anything.
std::string shown(std::string_view word) {
    const bool is_plain =
        word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_ ") ==
        std::string_view::npos;
    return is_plain ? fmt::format("`{}`", word) : quoted(word);
}

// "`text` (a shape)"
std::string what(const Missing& missing) {
    return shown(missing.name) +
           (missing.meaning.empty() ? std::string() : fmt::format(" ({})", missing.meaning));
}

// What can be tried.
std::string advice(const Missing& missing) {
    if (missing.name == "clipped_by") {
        return missing.is_error
                   ? "; the object is cut where the picture shows it: take the `clipped_by` out of "
                     "the text, or draw the whole object with the option skip-unsupported"
                   : "; the object is drawn whole";
    }
    if (missing.name == "texture_list")
        return "; each such face has the shine of its first corner: give all corners of a face the same "
               "`finish`";
    return missing.is_error ? "; the option skip-unsupported leaves it out and draws the rest" : "";
}

}  // namespace

void SceneBuilder::report(const Missing& missing) {
    if (!missing.is_error && (is_quiet_ || reading_.diagnostics.warned(missing.name))) return;
    if (!missing.is_error) {
        return stream_.warn_once(missing.name, missing.at,
                                 fmt::format("glint does not render {} of POV-Ray: the picture will differ{}",
                                             what(missing), advice(missing)));
    }
    // Reading goes on, so that all of them are named.
    const std::string key = fmt::format("refused {}", missing.name);
    if (std::find(warned_.begin(), warned_.end(), key) != warned_.end()) return;
    warned_.push_back(key);
    reading_.diagnostics.refuse(
        reading_.texts[missing.at.text], missing.at.offset,
        std::max<std::size_t>(stream_.text_of(missing.at).size(), 1),
        fmt::format("glint does not render {} of POV-Ray{}", what(missing), advice(missing)));
}

void SceneBuilder::report(const MissingList& missing) {
    for (const Missing& each : missing) report(each);
}

// Objects that have no meaning without what is missing; only with skip_unsupported.
bool SceneBuilder::leave_out(const Object& object) {
    if (!reading_.options.skip_unsupported) return false;
    const MissingList& missing = object.kind == ObjectKind::light ? object.light->missing : object.missing;
    const auto reason =
        std::find_if(missing.begin(), missing.end(), [](const Missing& m) { return m.is_error; });
    if (reason == missing.end()) return false;
    const Token& at = reason->at;
    reading_.left_out.add(what(*reason) + " of POV-Ray", reading_.texts[at.text], at.offset,
                          std::max<std::size_t>(stream_.text_of(at).size(), 1));
    return true;
}

}  // namespace glint::povray
