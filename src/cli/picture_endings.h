// SPDX-License-Identifier: Apache-2.0
#pragma once
// The endings of pictures' names.
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "glint/image.h"

namespace glint::cli {

/// The first of a format is the one that glint gives to files.
inline constexpr std::pair<FileFormat, std::string_view> k_picture_endings[] = {
    {FileFormat::png, ".png"},  {FileFormat::ppm, ".ppm"}, {FileFormat::exr, ".exr"},
    {FileFormat::tga, ".tga"},  {FileFormat::bmp, ".bmp"}, {FileFormat::jpeg, ".jpg"},
    {FileFormat::jpeg, ".jpeg"}};
/// The same in a sentence.
inline constexpr const char* k_picture_endings_text = ".png, .ppm, .exr, .tga, .bmp or .jpg";

inline std::optional<FileFormat> format_of_ending(std::string_view ending) {
    for (const auto& [format, known] : k_picture_endings)
        if (known == ending) return format;
    return std::nullopt;
}

inline std::string ending_of(FileFormat format) {
    for (const auto& [known, ending] : k_picture_endings)
        if (known == format) return std::string(ending);
    return {};
}

}  // namespace glint::cli
