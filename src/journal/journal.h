// SPDX-License-Identifier: Apache-2.0
#pragma once
// A journal: a header, then the tiles that have been rendered, each with a checksum (docs/journal.md). These
// functions know bytes only; who writes the file is the command's business.
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "glint/render.h"
#include "journal/header.h"

namespace glint {

/// A tile in the bytes of a journal.
struct JournalTile {
    std::uint32_t number = 0;
    RayCounts rays;           ///< traced for this tile
    std::string_view floats;  ///< the picture's pixels row by row, then each layer's
};

/// A journal that was read. It refers to the bytes.
struct Journal {
    JournalHeader header;
    std::vector<JournalTile> tiles;  ///< in the order of the file; a tile may be there twice
    std::size_t size = 0;            ///< bytes of the header and of these tiles
    bool damaged = false;            ///< whether anything follows these, which no tile can be read from
};

/// Reads until the first record that is cut or damaged. Fails (parse) only if the header does. `passed` is
/// called after each record, with the bytes that were read so far.
Result<Journal> parse_journal(std::string_view bytes, const std::function<void(std::size_t)>& passed = {});

/// The record of a tile, whose layers are the header's in that order.
std::string record_bytes(const FinishedTile& tile);

/// The same without the checksum, for transports that lose no bits.
std::string unchecked_record_bytes(const FinishedTile& tile);

/// The tile of a record, whose checksum may be absent and is not compared; nothing if the bytes have another
/// length than one record. It refers to the bytes.
std::optional<JournalTile> parse_unchecked_record(std::string_view bytes, const JournalHeader& header);

/// Writes the floats of a tile into their place in `values`, which are the pixels of the rectangle `target`.
/// image: 0 for the picture, i for the header's layer i - 1. The rectangle must contain the tile.
void copy_tile(const JournalTile& tile, const JournalHeader& header, std::size_t image, const Crop& target,
               float* values);

/// Writes a tile into a picture of the header's size and the header's layers.
void copy_tile(const JournalTile& tile, const JournalHeader& header, Rendering& rendering);

/// The numbers of the tiles that the header's part has: part - 1, part - 1 + parts, ...
std::vector<std::uint32_t> tiles_of_part(const JournalHeader& header);

}  // namespace glint
