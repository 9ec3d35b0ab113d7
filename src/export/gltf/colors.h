// SPDX-License-Identifier: Apache-2.0
#pragma once
// Colors of a scene as glTF has them: linear, for pictures that are seen as sRGB.
#include "glint/bytes.h"
#include "glint/scene.h"

namespace glint::gltf_export {

/// In a scene with Transfer::none, a surface in full light shows the numbers of its color as they are, so
/// they are decoded by the sRGB curve; those of a scene with Transfer::srgb stay.
class ColorRule {
  public:
    explicit ColorRule(const Conventions& conventions) : rule_(conventions.byte_rule()) {}

    bool keeps_colors() const { return rule_.transfer == Transfer::srgb && rule_.gamma == 1; }
    /// Whether colors are only decoded.
    bool is_plain() const { return rule_.transfer == Transfer::none && rule_.gamma == 1; }
    /// A channel from 0 to 1.
    double linear(double channel) const;
    /// The greatest channel may be above 1; the color has the same tint then.
    Color linear(Color color) const;
    Material linear(Material material) const;

  private:
    ByteRule rule_;
};

double greatest(Color color);

}  // namespace glint::gltf_export
