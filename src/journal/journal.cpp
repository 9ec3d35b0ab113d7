// SPDX-License-Identifier: Apache-2.0
#include "journal/journal.h"

#include <bit>
#include <cstring>
#include <span>

#include "base/status.h"
#include "journal/little_endian.h"

namespace glint {
namespace {

// A record: tag, tile, five ray counts, length of the floats in bytes, the floats, checksum of all before.
constexpr std::uint32_t k_tag = 0x454c4954;  // "TILE"
constexpr std::size_t k_record_start = 4 + 4 + 5 * 8 + 4, k_record_end = 4;

void put_floats(std::string& bytes, std::span<const float> values) {
    if constexpr (std::endian::native == std::endian::little) {
        bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    } else {
        for (const float value : values) put_float(bytes, value);
    }
}

void get_floats(std::string_view bytes, std::span<float> values) {
    if constexpr (std::endian::native == std::endian::little) {
        std::memcpy(values.data(), bytes.data(), values.size_bytes());
    } else {
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = get_float(bytes.substr(4 * i));
    }
}

std::size_t float_bytes(const JournalHeader& header, const Crop& area) {
    return 4 * header.floats_of_pixel() * static_cast<std::size_t>(area.width) *
           static_cast<std::size_t>(area.height);
}

// The record at the start of `bytes` but for its checksum, or false if it is cut or no record.
bool read_unchecked(std::string_view bytes, const JournalHeader& header, JournalTile& tile) {
    if (bytes.size() < k_record_start || get_u32(bytes) != k_tag) return false;
    tile.number = get_u32(bytes.substr(4));
    const Crop area = tile_area(header.picture, tile.number);
    const std::size_t length = float_bytes(header, area);
    if (area.width < 1 || get_u32(bytes.substr(k_record_start - 4)) != length ||
        bytes.size() < k_record_start + length)
        return false;
    std::uint64_t counts[5];
    for (std::size_t i = 0; i < 5; ++i) counts[i] = get_u64(bytes.substr(8 + 8 * i));
    tile.rays = {counts[0], counts[1], counts[2], counts[3], counts[4]};
    tile.floats = bytes.substr(k_record_start, length);
    return true;
}

// The record at the start of `bytes`, or false if it is cut or damaged.
bool read_record(std::string_view bytes, const JournalHeader& header, JournalTile& tile) {
    if (!read_unchecked(bytes, header, tile)) return false;
    const std::size_t length = k_record_start + tile.floats.size();
    return bytes.size() >= length + k_record_end &&
           get_u32(bytes.substr(length)) == journal_checksum(bytes.substr(0, length));
}

std::size_t channels_of(const JournalHeader& header, std::size_t image) {
    return image == 0 ? 3 : header.channels_of_layer(image - 1);
}

}  // namespace

Result<Journal> parse_journal(std::string_view bytes, const std::function<void(std::size_t)>& passed) {
    return result_of([&]() -> Result<Journal> {
        Result<ParsedHeader> parsed = parse_header(bytes);
        if (!parsed) return Status(parsed);
        Journal journal;
        journal.header = std::move(parsed->header);
        journal.size = parsed->size;
        JournalTile tile;
        while (read_record(bytes.substr(journal.size), journal.header, tile)) {
            journal.tiles.push_back(tile);
            journal.size += k_record_start + tile.floats.size() + k_record_end;
            if (passed) passed(journal.size);
        }
        journal.damaged = journal.size < bytes.size();
        return journal;
    });
}

std::optional<JournalTile> parse_unchecked_record(std::string_view bytes, const JournalHeader& header) {
    JournalTile tile;
    if (!read_unchecked(bytes, header, tile)) return std::nullopt;
    const std::size_t more = bytes.size() - k_record_start - tile.floats.size();
    if (more != 0 && more != k_record_end) return std::nullopt;
    return tile;
}

std::string unchecked_record_bytes(const FinishedTile& tile) {
    std::string bytes;
    put_u32(bytes, k_tag);
    put_u32(bytes, tile.number);
    for (const std::uint64_t count :
         {tile.rays.camera, tile.rays.shadow, tile.rays.mirror, tile.rays.transmitted, tile.rays.cut})
        put_u64(bytes, count);
    std::size_t floats = 3;
    for (const TileLayer& layer : tile.layers) floats += static_cast<std::size_t>(layer.channels);
    const auto width = static_cast<std::size_t>(tile.area.width);
    const std::size_t length = 4 * floats * width * static_cast<std::size_t>(tile.area.height);
    bytes.reserve(k_record_start + length + k_record_end);
    put_u32(bytes, static_cast<std::uint32_t>(length));
    const auto put_rows = [&](const float* values, std::size_t channels, std::size_t row_floats) {
        for (std::int32_t y = 0; y < tile.area.height; ++y)
            put_floats(bytes, {values + static_cast<std::size_t>(y) * row_floats, channels * width});
    };
    put_rows(tile.rgb, 3, tile.row_floats);
    for (const TileLayer& layer : tile.layers)
        put_rows(layer.values, static_cast<std::size_t>(layer.channels), layer.row_floats);
    return bytes;
}

std::string record_bytes(const FinishedTile& tile) {
    std::string bytes = unchecked_record_bytes(tile);
    put_u32(bytes, journal_checksum(bytes));
    return bytes;
}

void copy_tile(const JournalTile& tile, const JournalHeader& header, std::size_t image, const Crop& target,
               float* values) {
    const Crop area = tile_area(header.picture, tile.number);
    const auto width = static_cast<std::size_t>(area.width);
    const std::size_t pixels = width * static_cast<std::size_t>(area.height);
    std::string_view rest = tile.floats;
    for (std::size_t before = 0; before < image; ++before)
        rest.remove_prefix(4 * pixels * channels_of(header, before));
    const std::size_t channels = channels_of(header, image);
    for (std::int32_t y = area.y - target.y; y < area.y - target.y + area.height; ++y) {
        const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(target.width) +
                                  static_cast<std::size_t>(area.x - target.x);
        get_floats(rest, {values + channels * first, channels * width});
        rest.remove_prefix(4 * channels * width);
    }
}

void copy_tile(const JournalTile& tile, const JournalHeader& header, Rendering& rendering) {
    copy_tile(tile, header, 0, header.picture, rendering.image.rgb.data());
    for (std::size_t i = 0; i < rendering.layers.size(); ++i)
        copy_tile(tile, header, i + 1, header.picture, rendering.layers[i].values.data());
}

std::vector<std::uint32_t> tiles_of_part(const JournalHeader& header) {
    std::vector<std::uint32_t> tiles;
    for (std::size_t tile = header.part - 1; tile < count_tiles(header.picture); tile += header.parts)
        tiles.push_back(static_cast<std::uint32_t>(tile));
    return tiles;
}

}  // namespace glint
