// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a journal's first bytes say: which picture its tiles belong to (docs/journal.md).
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "glint/image.h"
#include "glint/layers.h"
#include "glint/result.h"

namespace glint {

/// A journal's header. Journals of the same picture differ at most in `part` and in the files' names.
struct JournalHeader {
    std::uint32_t picture_version = 0;  ///< k_picture_version of the program that wrote it
    Crop picture;                       ///< the pixels that are rendered, in the whole picture
    std::vector<Layer> layers;          ///< each once, in the order of a record
    /// Name and hash_of() of each text that the scene was read from, those that it includes among them.
    std::vector<std::pair<std::string, std::string>> files;
    /// Name and value of everything else that decides the picture.
    std::vector<std::pair<std::string, std::string>> settings;
    std::uint32_t part = 1, parts = 1;  ///< tiles part - 1, part - 1 + parts, ... are expected; 1 to parts

    /// Floats of one pixel: the picture's three and the layers' channels.
    std::size_t floats_of_pixel() const;
    std::size_t channels_of_layer(std::size_t i) const;
};

/// CRC-32, the polynomial of PNG and zlib.
std::uint32_t journal_checksum(std::string_view bytes);

/// The header's bytes: its text between the magic line and the checksum.
std::string header_bytes(const JournalHeader& header);

/// A header that was read, and how many bytes it takes.
struct ParsedHeader {
    JournalHeader header;
    std::size_t size = 0;
};

/// Reads the header at the start of `bytes`. Fails (parse) if there is no complete and correct one.
Result<ParsedHeader> parse_header(std::string_view bytes);

/// What tells the pictures of two headers apart, as "castle.json has changed" or "size is 640x480 there and
/// 320x240 here"; empty if they are one picture. `a` is there, `b` here.
std::string header_difference(const JournalHeader& a, const JournalHeader& b);

}  // namespace glint
