// SPDX-License-Identifier: Apache-2.0
#pragma once
// Pictures: linear float RGB, and their encodings.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "glint/bytes.h"
#include "glint/export.h"
#include "glint/result.h"
#include "glint/vec.h"

namespace glint {

/// A rectangle of pixels: (x, y) is its top-left pixel, counted from the picture's top-left.
struct Crop {
    std::int32_t width = 0, height = 0, x = 0, y = 0;
    friend bool operator==(const Crop&, const Crop&) = default;
};

/// width x height pixels of linear RGB, row by row from the top: r, g, b of pixel (x, y) at 3 (y width + x).
/// Values are not clamped. They are finite, except in pictures from decode().
struct Image {
    std::int32_t width = 0, height = 0;
    std::vector<float> rgb;

    /// The pixel (x, y), counted from the top left. Black if the picture has no such pixel or too few
    /// numbers.
    Color pixel(std::int32_t x, std::int32_t y) const {
        if (x < 0 || y < 0 || x >= width || y >= height) return {};
        const std::size_t first =
            3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
        if (rgb.size() < 3 || first > rgb.size() - 3) return {};
        return {rgb[first], rgb[first + 1], rgb[first + 2]};
    }
};

enum class FileFormat : std::uint8_t { png, ppm, exr, tga, bmp, jpeg };

struct EncodeOptions {
    FileFormat format = FileFormat::png;
    int bits = 8;  ///< 8 or 16 per channel; EXR is always 32-bit float; TGA, BMP and JPEG have 8
    Transfer transfer = Transfer::none;  ///< EXR is always linear
    int threads = 0;
    double gamma = 1;  ///< see ByteRule
    Rounding rounding = Rounding::half_even;
    int jpeg_quality = 95;  ///< 1 to 100; JPEG changes colors a little at any quality

    constexpr ByteRule rule() const { return {transfer, gamma, rounding}; }
    /// Takes the rule of a scene: options.set_rule(scene.conventions.byte_rule()).
    constexpr void set_rule(const ByteRule& r) {
        transfer = r.transfer, gamma = r.gamma, rounding = r.rounding;
    }
};

/// The bytes of the file. Clamps to [0, 1], applies gamma and transfer, scales by 255 (65535) and rounds
/// (ByteRule; docs/conventions.md); EXR keeps floats. The bytes do not depend on threads. An error if a side
/// of the image is not 1 to k_max_size pixels, if its numbers do not match its size, or if the options have
/// an invalid format, number of bits, transfer, gamma, rounding or quality. Never throws.
GLINT_API Result<std::vector<std::uint8_t>> encode(const Image& image, const EncodeOptions& options = {});

/// The same with an alpha channel, for pictures that were rendered with RenderSettings::alpha. alpha: width *
/// height numbers, those of Layer::alpha. The picture's numbers are already multiplied by alpha: OpenEXR
/// keeps them so; PNG has them divided by alpha, before the transfer curve. An error if `alpha` does not
/// match the picture's size, and for PPM, TGA, BMP
/// and JPEG, which are written without alpha. Never throws.
GLINT_API Result<std::vector<std::uint8_t>> encode(const Image& image, std::span<const float> alpha,
                                                   const EncodeOptions& options = {});

/// The number that `encode` writes for a channel value: 0 to 255 with 8 bits, 0 to 65535 with 16 (and with
/// any other number of bits). 0 for NaN.
GLINT_API std::uint32_t to_number(float value, int bits, Transfer transfer = Transfer::none);
GLINT_API std::uint32_t to_number(float value, int bits, const ByteRule& rule);

/// The byte that `encode` writes for a channel value with 8 bits.
GLINT_API std::uint8_t to_byte(float value, Transfer transfer = Transfer::none);
GLINT_API std::uint8_t to_byte(float value, const ByteRule& rule);

struct DecodeOptions {
    /// Larger pictures are rejected before memory is allocated, because a small file can claim any size.
    std::int64_t max_pixels = std::int64_t{1} << 26;
    /// Bytes that decode() may take, with the picture and without the file's bytes. 0: 512 MiB, and 24 bytes
    /// for each pixel. The picture needs 12 bytes a pixel; interlaced PNG needs 4 to 8 more, progressive JPEG
    /// up to 6, and OpenEXR the blocks or a row of tiles with all channels of the file.
    std::uint64_t max_memory = 0;
};

struct DecodedImage {
    Image image;
    int bits = 8;      ///< per channel of the file: 1 to 16, or 32 for floats (OpenEXR, half floats too)
    std::string note;  ///< what was ignored, "its transparency is left out"; empty if nothing
};

/// Decodes a PNG, PPM or PGM (P2, P3, P5, P6), OpenEXR or JPEG file; the first bytes decide the format.
/// Integers v become v / 255 (8 bits; otherwise the file's own maximum) without decoding gamma; transparency
/// is ignored. So encode() writes the same bytes again. Floats are unchanged, including infinities and NaN
/// (`note` mentions them). An error if max_pixels or max_memory is exceeded. Never throws.
GLINT_API Result<DecodedImage> decode(std::span<const std::uint8_t> bytes, const DecodeOptions& options = {});

}  // namespace glint
