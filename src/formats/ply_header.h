// SPDX-License-Identifier: Apache-2.0
#pragma once
// The header of a PLY file: which elements follow, and their properties.
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/load_state.h"

namespace glint {

enum class PlyCoding : std::uint8_t { ascii, little_endian, big_endian };
enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// The length of a number in the binary codings, in bytes.
std::size_t size_of(PlyType type);

struct PlyProperty {
    std::string_view name;
    PlyType type = PlyType::float32;
    std::optional<PlyType> count_type = {};  ///< of the length of a list; nothing: a single number
};

struct PlyElement {
    std::string_view name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties = {};
    std::size_t offset = 0, length = 0;  ///< of its line in the text, without the line's end

    /// The fewest bytes that one of these elements takes.
    std::size_t least_bytes(PlyCoding coding) const;
    const PlyProperty* find(std::string_view property) const;
};

struct PlyHeader {
    PlyCoding coding = PlyCoding::ascii;
    std::vector<PlyElement> elements;
    std::size_t end = 0;  ///< offset of the first byte after the header
};

/// Reads the header of a text. Nothing, and an error with its line, if it is not one.
std::optional<PlyHeader> read_ply_header(LoadState& reading, InputText where);

}  // namespace glint
