#pragma once
// Pictures: linear float RGB, and their encodings.
#include <cstdint>
#include <string>
#include <vector>

namespace glint {

/// A rectangle of pixels: (x, y) is its top-left pixel, counted from the picture's top-left.
struct Crop {
    std::int32_t width = 0, height = 0, x = 0, y = 0;
};

/// width x height pixels of linear RGB, row by row from the top: r, g, b of pixel (x, y) at 3 (y width + x).
/// Values are finite and not clamped.
struct Image {
    std::int32_t width = 0, height = 0;
    std::vector<float> rgb;
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

struct EncodeResult {
    std::vector<std::uint8_t> bytes;  ///< empty if there was an error
    std::string error;
};

/// Clamps to [0, 1], scales by 255 (65535) and rounds half to even (CONVENTIONS: every source does); EXR
/// keeps floats. The bytes do not depend on threads. Never throws.
EncodeResult encode(const Image& image, const EncodeOptions& options = {});

/// The byte that `encode` writes for a channel value with 8 bits.
std::uint8_t to_byte(float value, Transfer transfer = Transfer::none);

}  // namespace glint
