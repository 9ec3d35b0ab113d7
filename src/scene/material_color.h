// SPDX-License-Identifier: Apache-2.0
#pragma once
// A material's coefficients as multiples of its color.
#include <array>
#include <optional>

#include "glint/scene.h"

namespace glint {

inline constexpr int k_color_factors = 3;

/// For materials whose colors are those of a mesh's vertices: white and gray coefficients, as of highlights,
/// are no multiples of it, so that they stay as they are (with_color()).
inline constexpr Color k_color_of_vertices{1, 0.75, 0.5};

/// The c from 0 to 1 with c * color == k, bit for bit, that has the fewest decimals.
std::optional<double> find_coefficient(Color color, Color k);

/// The factors by which the ambient, diffuse and specular coefficients are multiples of the color, in this
/// order; NaN for one that is not. Of a black color, black coefficients have the usual factors.
std::array<double, k_color_factors> find_color_factors(
    Color color, const std::array<Color, k_color_factors>& coefficients);

/// What a texture shows at a place.
struct ShownTexture {
    Color color;
    Color ambient, diffuse;  ///< the color in k_a and k_d (Texture::ambient)
    double alpha = 1;
};
/// The material where a texture shows this.
Material with_texture(const Material& material, const Texture& texture, const ShownTexture& shown);

/// Material::transmit where the part `opacity` of the surface's opacity is left; `filter` is multiplied by
/// it.
constexpr double faded_transmit(double transmit, double opacity) { return 1 - opacity * (1 - transmit); }

}  // namespace glint
