// SPDX-License-Identifier: Apache-2.0
#pragma once
// The curves that the pictures of `image_map` are encoded by, and those of the scene's numbers.
#include <memory>
#include <optional>
#include <string_view>

#include "glint/texture.h"

namespace glint::povray {

/// light = number^power, or the curve of sRGB.
struct ImageCurve {
    bool is_srgb = false;
    double power = 1;
    friend bool operator==(const ImageCurve&, const ImageCurve&) = default;
};

/// An image, and the one that with_curve() has made of it.
struct GradedImage {
    std::shared_ptr<const TextureImage> from, to;
    ImageCurve of_file, of_scene;
};

/// The image with the scene's numbers as 16-bit words, for curves that no TextureEncoding has. Throws
/// std::bad_alloc.
TextureImage with_curve(const TextureImage& image, const ImageCurve& of_file, const ImageCurve& of_scene);

/// What the chunk gAMA of a PNG says: its number is 1/power. Nothing without one.
std::optional<ImageCurve> png_curve(std::string_view file);

}  // namespace glint::povray
