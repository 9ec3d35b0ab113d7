// SPDX-License-Identifier: Apache-2.0
#pragma once
// A PNG decoder for tests: RGB or RGBA of 8 or 16 bits, every checksum verified.
#include <zlib.h>

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace glint::test {

/// width x height x channels samples of 8 or 16 bits. Without samples, `error` is the reason.
struct Picture {
    int width = 0, height = 0, bits = 8;
    std::vector<std::uint16_t> samples;
    std::string error;
    int channels = 3;
};

inline std::vector<std::uint8_t> read_bytes(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

inline std::uint8_t paeth(int a, int b, int c) {
    const int p = a + b - c, pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
    return static_cast<std::uint8_t>(pa <= pb && pa <= pc ? a : pb <= pc ? b : c);
}

inline Picture decode_png(const std::vector<std::uint8_t>& file) {
    const auto failure = [](std::string why) { return Picture{0, 0, 8, {}, std::move(why), 3}; };
    const auto get32 = [&](std::size_t at) {
        return std::uint32_t{file[at]} << 24 | file[at + 1] << 16 | file[at + 2] << 8 | file[at + 3];
    };
    const std::string signature = "\x89PNG\r\n\x1a\n";
    if (file.size() < 8 || std::string(file.begin(), file.begin() + 8) != signature)
        return failure("no PNG signature");
    Picture picture;
    std::vector<std::uint8_t> packed;
    bool ended = false;
    for (std::size_t at = 8; at < file.size();) {
        if (ended) return failure("bytes after IEND");
        if (file.size() - at < 12) return failure("a chunk is cut");
        const std::size_t length = get32(at);
        if (length > file.size() - at - 12) return failure("a chunk is cut");
        const std::string type(file.begin() + static_cast<long>(at) + 4,
                               file.begin() + static_cast<long>(at) + 8);
        if (crc32(0, &file[at + 4], static_cast<uInt>(length + 4)) != get32(at + 8 + length)) {
            return failure("wrong checksum of " + type);
        }
        if (type == "IHDR") {
            picture.width = static_cast<int>(get32(at + 8));
            picture.height = static_cast<int>(get32(at + 12));
            picture.bits = file[at + 16];
            if (file[at + 17] != 2 && file[at + 17] != 6) return failure("not RGB or RGBA");
            picture.channels = file[at + 17] == 6 ? 4 : 3;
            if (picture.bits != 8 && picture.bits != 16) return failure("not 8 or 16 bits");
        } else if (type == "IDAT") {
            packed.insert(packed.end(), file.begin() + static_cast<long>(at) + 8,
                          file.begin() + static_cast<long>(at + 8 + length));
        } else if (type == "IEND") {
            ended = true;
        }
        at += 12 + length;
    }
    if (!ended) return failure("no IEND");
    const std::size_t channels = static_cast<std::size_t>(picture.channels),
                      pixel = picture.bits == 8 ? channels : 2 * channels, row = pixel * picture.width;
    std::vector<std::uint8_t> rows((row + 1) * picture.height);
    uLongf size = rows.size();
    uLong used = packed.size();
    if (const int code = uncompress2(rows.data(), &size, packed.data(), &used);
        code != Z_OK || size != rows.size()) {
        return failure("zlib: " + std::to_string(code));
    }
    if (used != packed.size()) return failure("bytes after the zlib stream");
    std::vector<std::uint8_t> above(row);
    for (int y = 0; y < picture.height; ++y) {
        const std::uint8_t* in = &rows[y * (row + 1)];
        const int filter = *in++;
        std::vector<std::uint8_t> line(row);
        for (std::size_t i = 0; i < row; ++i) {
            const int a = i >= pixel ? line[i - pixel] : 0, b = above[i],
                      c = i >= pixel ? above[i - pixel] : 0;
            const int guess = filter == 0   ? 0
                              : filter == 1 ? a
                              : filter == 2 ? b
                              : filter == 3 ? (a + b) / 2
                                            : paeth(a, b, c);
            line[i] = static_cast<std::uint8_t>(in[i] + guess);
        }
        for (std::size_t i = 0; i < row; i += pixel / channels) {
            picture.samples.push_back(
                picture.bits == 8 ? line[i] : static_cast<std::uint16_t>(line[i] << 8 | line[i + 1]));
        }
        above = std::move(line);
    }
    return picture;
}

inline Picture read_png(const std::string& path) { return decode_png(read_bytes(path)); }

}  // namespace glint::test
