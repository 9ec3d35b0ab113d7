// SPDX-License-Identifier: Apache-2.0
#pragma once
// The numbers of the patterns of textures (TextureMapping), at a point in the texture's coordinates.
#include "glint/vec.h"

namespace glint {

/// 0 and 0.5 in turn.
double checker(Vec3 p);
double leopard(Vec3 p);
/// 0 in the mortar, else 0.5.
double bricks(Vec3 p, Vec3 mortar);
double hexagons(Vec3 p);
/// iterations: at least 1.
double mandelbrot(Vec3 p, double iterations);

}  // namespace glint
