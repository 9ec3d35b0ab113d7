// SPDX-License-Identifier: Apache-2.0
#pragma once
// Noise for the patterns of textures: numbers that change smoothly from place to place without a visible
// order.
#include "glint/texture.h"
#include "glint/vec.h"

namespace glint {

/// Gradient noise (Perlin, Improving Noise, 2002), with gradients by a hash of the cell's corner instead of a
/// table: -1 to 1, and 0 at points of whole coordinates. series: each has other gradients. 0 where a
/// coordinate is 2^31 or more, or NaN.
double gradient_noise(Vec3 p, std::uint32_t series = 0);

/// Three sums of noise of Texture::octaves, each of its own series, for Texture::turbulence.
Vec3 noise_displacement(const Texture& texture, Vec3 p);

/// The patterns' u, from 0 to below 1 (TextureMapping).
double noise_pattern(Vec3 p);
double granite(Vec3 p);
double wrinkles(Vec3 p);

}  // namespace glint
