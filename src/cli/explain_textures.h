// SPDX-License-Identifier: Apache-2.0
#pragma once
// What an explanation says of textures.
#include <string>
#include <vector>

#include "glint/explain.h"

namespace glint::cli {

/// "texture 'wood' (a.glint:3:1) at u 0.25, v 0.5: texels in columns 3 (0.75) and 4 (0.25), ..."; of a
/// texture that is over others, also a line for each layer.
std::vector<std::string> texture_lines(const Scene& scene, const ExplainedTexture& texture);

/// A line for each hole of a texture that the ray passes, and one for those that are not listed.
std::vector<std::string> hole_lines(const Scene& scene, const ExplainedRay& ray);

}  // namespace glint::cli
