// SPDX-License-Identifier: Apache-2.0
#pragma once
// One encoder per file format, for a picture and options that encode() has checked. They throw bad_alloc and
// exceptions of their libraries; encode() catches them.
#include "glint/image.h"
#include "glint/layers.h"
#include "image/strip_encoder.h"

namespace glint {

std::unique_ptr<StripEncoder> make_png_encoder(std::int32_t width, std::int32_t height,
                                               const EncodeOptions& options, ByteFile& file, bool alpha);
/// A PNG of sRGB words with 8 bits: r, g, b, and with alpha a, of each pixel, in rows from the top.
std::vector<std::uint8_t> encode_png_words(std::uint32_t width, std::uint32_t height, bool alpha,
                                           std::span<const std::uint8_t> words);
std::unique_ptr<StripEncoder> make_ppm_encoder(std::int32_t width, std::int32_t height,
                                               const EncodeOptions& options, ByteFile& file);
std::unique_ptr<StripEncoder> make_tga_encoder(std::int32_t width, std::int32_t height,
                                               const EncodeOptions& options, ByteFile& file);
std::unique_ptr<StripEncoder> make_bmp_encoder(std::int32_t width, std::int32_t height,
                                               const EncodeOptions& options, ByteFile& file);
std::unique_ptr<StripEncoder> make_jpeg_encoder(std::int32_t width, std::int32_t height,
                                                const EncodeOptions& options, ByteFile& file);
std::unique_ptr<StripEncoder> make_exr_encoder(std::int32_t width, std::int32_t height, ByteFile& file,
                                               bool alpha);

/// alpha: empty, or of the picture's size.
std::vector<std::uint8_t> encode_exr(const Image& image, std::span<const float> alpha);
/// A file of several parts. The layers have the picture's size.
std::vector<std::uint8_t> encode_exr_layers(const Image& picture, std::span<const LayerImage> layers,
                                            std::span<const float> alpha);

}  // namespace glint
