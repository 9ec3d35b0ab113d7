// SPDX-License-Identifier: Apache-2.0
#pragma once
// One function per file format, for a picture and options that encode() has checked. They throw bad_alloc
// and exceptions of their libraries; encode() catches them.
#include "glint/conventions.h"
#include "glint/image.h"
#include "glint/layers.h"

namespace glint {

std::vector<std::uint8_t> encode_png(const Image& image, const EncodeOptions& options);
std::vector<std::uint8_t> encode_ppm(const Image& image, const EncodeOptions& options);
std::vector<std::uint8_t> encode_exr(const Image& image);
/// Of several parts; the layers have the picture's size.
std::vector<std::uint8_t> encode_exr_layers(const Image& picture, std::span<const LayerImage> layers);

}  // namespace glint
