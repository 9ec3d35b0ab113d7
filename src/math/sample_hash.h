// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sampled numbers come from a hash of what they are for, never from a stream, so that no order of pixels,
// tiles or threads can change them. The words are chained in this order: seed; x and y of the pixel in the
// whole picture; sample of the pixel; path of the ray; purpose and its index; then what the purpose needs
// (the number of the sample, 0 or 1 for the first or second coordinate).
#include <cstdint>

#include "math/number.h"

#define GLINT_NUMBER_NAMESPACE words
#include "math/sample_hash_templates-inl.h"

namespace glint {

using words::hash_with;
using words::lowbias32;

/// What sampled numbers are for. Values are part of the pictures: they never change.
enum class SamplePurpose : std::uint32_t {
    pixel = 1,      ///< the position in a pixel
    light = 2,      ///< a point of a light; the index is the light's in Scene::lights
    occlusion = 3,  ///< a direction of ambient occlusion
    lens = 4,       ///< a point of the lens
};

/// The path of a camera ray.
inline constexpr std::uint32_t k_camera_path = 1;

/// The path of the mirror ray, or the transmitted ray, of a ray's surface.
inline std::uint32_t child_path(std::uint32_t path, bool transmitted) {
    return lowbias32(2 * path + (transmitted ? 1u : 0u));
}

/// The first word of every chain: that of the setting `seed`.
inline std::uint32_t seed_hash(std::uint32_t seed) { return lowbias32(seed + 0x9e3779b9u); }

/// The hash of a ray: of all words up to the path.
inline std::uint32_t ray_hash(std::uint32_t seed, std::uint32_t x, std::uint32_t y, std::uint32_t sample,
                              std::uint32_t path) {
    return hash_with(hash_with(hash_with(hash_with(seed_hash(seed), x), y), sample), path);
}

/// The word of a purpose. index < 2^28.
inline std::uint32_t purpose_word(SamplePurpose purpose, std::uint32_t index) {
    return static_cast<std::uint32_t>(purpose) << 28 | index;
}

/// A number u from 0 to 1, 0 <= u < 1: the hash's first 24 bits, times 2^-24.
inline double unit_number(std::uint32_t hash) { return static_cast<double>(hash >> 8) * 0x1p-24; }

}  // namespace glint
