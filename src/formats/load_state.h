// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the readers of one load() share: the scene that grows, and what the texts before have given.
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.h"
#include "formats/parser.h"
#include "glint/load.h"

namespace glint {

class GlintMaterials;

/// One of the texts.
struct ReadText {
    InputText place;
    std::uint16_t file = 0;  ///< index into Scene::files
    bool is_included = false;
};

/// The texts that are named by others. Texts and names stay where they are as long as the load goes on.
struct Includes {
    struct Text {
        std::string name, text;
    };
    std::deque<Text> texts;
    std::map<std::string, std::uint16_t, std::less<>> files;  ///< of texts, by name
    std::uint16_t root = 0;                                   ///< the text of the caller's that is being read
    std::vector<std::uint16_t> open;  ///< the included ones that are being read, from the outermost
    std::uint32_t count = 0;          ///< how often any was included
    std::size_t repeated_bytes = 0;   ///< of texts included again
};

struct LoadState {
    LoadState(const LoadOptions& load_options, Sources* text_sources, std::uint32_t max_errors)
        : options(load_options), sources(text_sources), diagnostics(max_errors) {}

    const LoadOptions& options;
    Sources* sources;              ///< null: nothing can be included
    std::vector<InputText> texts;  ///< by SourcePlace::file
    Includes includes;
    Scene scene;
    Diagnostics diagnostics;
    // Ordered, so that no choice of names makes it slow.
    std::map<std::string, std::uint32_t, std::less<>> materials;  ///< by name, of all texts
    std::shared_ptr<GlintMaterials> glint_materials;              ///< of the .glint texts, once there is one
    bool camera_given = false, background_given = false;
    bool camera_included = false, background_included = false;  ///< the one given is an included text's
    bool is_include_missing = false;                            ///< a text could not be read
    bool settings_given = false;                                ///< a text has set conventions by hand
    bool own_ambient_light = false;                             ///< the one that EPFL's texts do not write
    std::optional<ReadText> profile_text;                       ///< the caller's profile file
    std::optional<Diagnostic> camera_wanted;  ///< the error to report if no text gives a camera
};

inline constexpr std::size_t k_max_texts =
    65534;  ///< of a load: SourcePlace::file, and one more for a profile

inline SourcePlace source_place(const ReadText& text, const Token& token) {
    return {token.line, static_cast<std::uint16_t>(token.column < 65535 ? token.column : 65535), text.file};
}

/// Notes the place, and the name if there is one, of item number `index`.
inline void note(ItemTexts& texts, std::size_t index, SourcePlace place, std::string name = {}) {
    texts.places.resize(index);
    texts.places.push_back(place);
    if (!name.empty()) texts.names.emplace(static_cast<std::uint32_t>(index), std::move(name));
}

}  // namespace glint
