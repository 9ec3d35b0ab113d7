// SPDX-License-Identifier: Apache-2.0
#include "compare/item_texts.h"

#include <fmt/format.h>

#include <vector>

#include "base/text.h"

namespace glint {

std::string line_text(const Scene& scene, SourcePlace place) {
    if (place.line == 0) return {};
    return place.file == 0 || place.file >= scene.files.size()
               ? fmt::format("line {}", place.line)
               : fmt::format("{}:{}", scene.files[place.file], place.line);
}

std::string item_text(const Scene& scene, std::string_view kind, std::uint32_t index,
                      const ItemTexts& texts) {
    std::vector<std::string> parts;
    if (!texts.name(index).empty()) parts.push_back(fmt::format("\"{}\"", printable(texts.name(index))));
    if (std::string line = line_text(scene, texts.place(index)); !line.empty()) parts.push_back(line);
    const std::string text = fmt::format("{} {}", kind, index + 1);
    return parts.empty() ? text : fmt::format("{} ({})", text, fmt::join(parts, ", "));
}

std::string shape_text(const Scene& scene, std::uint32_t shape) {
    return item_text(scene, to_string(scene.shapes[shape].kind), shape, scene.shape_texts);
}

std::string capitalized(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

}  // namespace glint
