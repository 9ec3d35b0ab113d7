#pragma once
// What the readers of one load() share: the scene that grows, and what the texts before have given.
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/diagnostics.h"
#include "formats/parser.h"
#include "glint/load.h"

namespace glint {

struct Reading {
    Reading(const LoadOptions& load_options, std::uint32_t max_errors)
        : options(load_options), diagnostics(max_errors) {}

    const LoadOptions& options;
    Scene scene;
    Diagnostics diagnostics;
    // Ordered, so that no choice of names makes it slow.
    std::map<std::string, std::uint32_t, std::less<>> materials;  ///< by name, of all texts
    bool camera_given = false, background_given = false;
    bool own_ambient_light = false;           ///< the one that EPFL's texts do not write
    std::optional<Diagnostic> camera_wanted;  ///< the error to report if no text gives a camera
};

/// One of the texts.
struct ReadText {
    TextPlace place;
    std::uint16_t file = 0;  ///< index into Scene::files
};

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
