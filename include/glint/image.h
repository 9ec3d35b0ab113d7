// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures: linear float RGB, and their encodings.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "glint/export.h"
#include "glint/result.h"
#include "glint/vec.h"

namespace glint {

/// A rectangle of pixels: (x, y) is its top-left pixel, counted from the picture's top-left.
struct Crop {
    std::int32_t width = 0, height = 0, x = 0, y = 0;
};

/// width x height pixels of linear RGB, row by row from the top: r, g, b of pixel (x, y) at 3 (y width + x).
/// Values are not clamped, and finite but in what decode() reads.
struct Image {
    std::int32_t width = 0, height = 0;
    std::vector<float> rgb;

    /// The pixel (x, y), counted from the top left. Black where the picture has no such pixel, or its numbers
    /// do not reach so far.
    Color pixel(std::int32_t x, std::int32_t y) const {
        if (x < 0 || y < 0 || x >= width || y >= height) return {};
        const std::size_t first =
            3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
        if (rgb.size() < 3 || first > rgb.size() - 3) return {};
        return {rgb[first], rgb[first + 1], rgb[first + 2]};
    }
};

enum class FileFormat : std::uint8_t { png, ppm, exr };

/// none: the numbers as they are. srgb: the sRGB curve, for pictures that will be mixed with photographs.
enum class Transfer : std::uint8_t { none, srgb };

struct EncodeOptions {
    FileFormat format = FileFormat::png;
    int bits = 8;                        ///< 8 or 16 a channel; EXR is always 32-bit float
    Transfer transfer = Transfer::none;  ///< EXR is always linear
    int threads = 0;
};

/// The bytes of the file. Clamps to [0, 1], scales by 255 (65535) and rounds half to even
/// (docs/conventions.md); EXR keeps floats. The bytes do not depend on threads. An error if the image has not
/// 1 to k_max_size pixels a side or its numbers do not fit its size, or the options name no format, number of
/// bits or transfer that there is. Never throws.
GLINT_API Result<std::vector<std::uint8_t>> encode(const Image& image, const EncodeOptions& options = {});

/// The number that `encode` writes for a channel value: 0 to 255 with 8 bits, to 65535 with 16 (which any
/// other number of bits counts as). 0 for NaN.
GLINT_API std::uint32_t to_number(float value, int bits, Transfer transfer = Transfer::none);

/// The byte that `encode` writes for a channel value with 8 bits.
GLINT_API std::uint8_t to_byte(float value, Transfer transfer = Transfer::none);

struct DecodeOptions {
    /// A picture of more pixels is refused before memory is taken for it: a small file can claim any size.
    std::int64_t max_pixels = std::int64_t{1} << 26;
};

struct DecodedImage {
    Image image;
    int bits = 8;      ///< of a channel in the file: 1 to 16, or 32 for floats (OpenEXR, also of 16 bits)
    std::string note;  ///< what the numbers leave out, "its transparency is left out"; empty if nothing
};

/// The picture of a PNG, PPM or PGM (P2, P3, P5, P6), OpenEXR or JPEG file, told apart by its first bytes.
/// Whole numbers v of a file become v / 255 (by 8 bits; or what the file's own maximum is), as they are: no
/// gamma is decoded, and transparency is left out. So encode() makes the same bytes of what was read. Floats
/// stay as they are, infinite ones and NaN, too (`note` says that there are some). Never throws; the memory
/// is bounded by max_pixels.
GLINT_API Result<DecodedImage> decode(std::span<const std::uint8_t> bytes, const DecodeOptions& options = {});

}  // namespace glint
