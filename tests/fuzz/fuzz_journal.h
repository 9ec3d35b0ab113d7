// SPDX-License-Identifier: Apache-2.0
#pragma once
// The fuzzing of journals: read them and check the result.
#include <string>
#include <string_view>

#include "journal/journal.h"
#include "journal/little_endian.h"

namespace glint::test {

/// A fuzzer does not find checksums: it gives 0, and this sets those of the header and of a first record.
inline std::string with_checksums(std::string_view data) {
    std::string bytes(data);
    const std::size_t start = 20;
    const auto set = [&](std::size_t from, std::size_t end) {
        std::string sum;
        put_u32(sum, journal_checksum(std::string_view(bytes).substr(from, end - from)));
        bytes.replace(end, 4, sum);
    };
    if (bytes.size() < start + 4) return bytes;
    const std::size_t text_end = start + get_u32(std::string_view(bytes).substr(16));
    if (text_end + 4 > bytes.size()) return bytes;
    set(start, text_end);
    const std::size_t record = text_end + 4, floats = record + 52;
    if (floats + 4 > bytes.size()) return bytes;
    const std::size_t record_end = floats + get_u32(std::string_view(bytes).substr(floats - 4));
    if (record_end + 4 > bytes.size()) return bytes;
    set(record, record_end);
    return bytes;
}

/// Parses the bytes. Returns an empty string, or what is wrong with the result.
inline std::string fuzz_journal(std::string_view data) {
    const std::string bytes = with_checksums(data);
    const Result<Journal> journal = parse_journal(bytes);
    if (journal.has_value() != journal.message.empty()) return "a journal and an error, or neither";
    if (!journal) return {};
    const JournalHeader& header = journal->header;
    if (journal->size > bytes.size() || journal->damaged != (journal->size < bytes.size()))
        return "a wrong size";
    const std::string written = header_bytes(header);
    const Result<ParsedHeader> again = parse_header(written);
    if (!again) return "the header is not read again: " + again.message;
    if (!header_difference(again->header, header).empty() || header_bytes(again->header) != written)
        return "another header comes back";
    const std::string_view rest =
        std::string_view(bytes).substr(again->size <= bytes.size() ? again->size : 0);
    if (const auto tile = parse_unchecked_record(rest, header)) {
        if (tile->number >= count_tiles(header.picture) || tile->floats.size() > rest.size())
            return "a record of a wrong tile";
    }
    for (const JournalTile& tile : journal->tiles) {
        const Crop area = tile_area(header.picture, tile.number);
        if (area.width < 1 || tile.floats.size() != 4 * header.floats_of_pixel() *
                                                        static_cast<std::size_t>(area.width) *
                                                        static_cast<std::size_t>(area.height))
            return "a tile of a wrong size";
        for (std::size_t image = 0; image <= header.layers.size(); ++image) {
            const std::size_t channels = image == 0 ? 3 : header.channels_of_layer(image - 1);
            std::vector<float> values(channels * static_cast<std::size_t>(area.width) *
                                      static_cast<std::size_t>(area.height));
            copy_tile(tile, header, image, area, values.data());
        }
    }
    return {};
}

}  // namespace glint::test
