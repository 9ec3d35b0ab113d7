// SPDX-License-Identifier: Apache-2.0
#pragma once
// A small scene whose lights, materials and spheres have names and lines.
#include <string>

#include "compare/planted_faults.h"

namespace glint::test {

inline const std::string k_scene = R"(
background = (0.2, 0.3, 0.5)
camera { position = (0.5, 2, 7)  look_at = (0, 0.8, 0)  fov_x = 48 }
light { type = ambient  intensity = 0.9 }
light "lamp" { type = point  position = (3, 5, 4)  intensity = 0.6 }
light { type = point  position = (-4, 4, 5)  intensity = 0.4 }
material red { color = (0.9, 0.2, 0.2)  ambient = 0.2  specular = 0.4  shininess = 20 }
material steel { color = (0.5, 0.6, 0.7)  ambient = 0.2  specular = 0.6  shininess = 40  mirror = 0.4 }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.6, 0.6, 0.5)  ambient = 0.2 }
sphere "ball" { center = (-1.1, 1, 0)  radius = 1  material = red }
sphere { center = (1.2, 0.8, 0.5)  radius = 0.8  material = steel }
render { size = 60 x 45  shading = phong  reflections = 2 }
)";

}  // namespace glint::test
