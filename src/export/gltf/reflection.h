// SPDX-License-Identifier: Apache-2.0
#pragma once
// Phong's coefficients as a base color, metal and roughness: the inverse of formats/gltf/materials.h.
#include <optional>

#include "glint/scene.h"

namespace glint::gltf_export {

struct MetalRoughness {
    Color base;
    double metallic = 0, roughness = 1;
    /// KHR_materials_specular's specularColorFactor, if it is not white.
    std::optional<Color> specular;
    bool is_exact = true;  ///< false: the highlight is another one
};

/// reflected: what a surface that is no metal reflects at a right angle, 0.04 without an index of refraction.
MetalRoughness metal_roughness(const Material& material, double reflected);

/// The roughness whose highlights have this exponent.
double roughness_of(double shininess);

}  // namespace glint::gltf_export
