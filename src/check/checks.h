// SPDX-License-Identifier: Apache-2.0
#pragma once
// The checks, one a kind of mistake. Each reports to the context what it finds.
#include "check/context.h"
#include "check/visible_hits.h"
#include "math/number.h"

namespace glint {

/// A colour's greatest and its least channel.
inline double brightest(Color c) { return number::max(c.r, number::max(c.g, c.b)); }
inline double least(Color c) { return number::min(c.r, number::min(c.g, c.b)); }

/// Whether the camera is where it sees something. False if it sees no bounded shape although there are some:
/// then nothing else of the picture is worth a word.
bool check_camera(CheckContext& context, const VisibleHits& visible);
/// Lights that add nothing, and colours of lights that are none.
void check_lights(CheckContext& context, const VisibleHits& visible);
/// Surfaces in the same place, and shapes written twice. Returns which shapes are named so, by index.
std::vector<bool> check_coincident_shapes(CheckContext& context);
/// Shapes that nobody sees, but for those whose reason is known.
void check_shapes(CheckContext& context, const VisibleHits& visible, const std::vector<bool>& explained);
/// Surfaces that turn their backs on the viewer, and vertex normals against their triangle's.
void check_normals(CheckContext& context, const VisibleHits& visible);
/// Vectors that their source takes as unit vectors.
void check_vectors(CheckContext& context);
/// Materials that nothing has, and their numbers.
void check_materials(CheckContext& context);
/// What a small picture shows: black, one colour, clamped, epsilon, reflections.
void check_picture(CheckContext& context, const VisibleHits& visible);

}  // namespace glint
