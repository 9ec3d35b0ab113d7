// SPDX-License-Identifier: Apache-2.0
#pragma once
// The checks, one a subject. Each reports to the subject what it finds.
#include "inspect/check_sight.h"
#include "inspect/check_subject.h"
#include "math/number.h"

namespace glint {

/// A colour's greatest and its least channel.
inline double brightest(Color c) { return number::max(c.r, number::max(c.g, c.b)); }
inline double least(Color c) { return number::min(c.r, number::min(c.g, c.b)); }

/// Whether the camera is where it sees something. False if it sees no bounded shape although there are some:
/// then nothing else of the picture is worth a word.
bool check_camera(Subject& subject, const Sight& sight);
/// Lights that add nothing, and colours of lights that are none.
void check_lights(Subject& subject, const Sight& sight);
/// Surfaces in the same place, and shapes written twice. Returns which shapes are named so, by index.
std::vector<bool> check_faces(Subject& subject);
/// Shapes that nobody sees, but for those whose reason is known.
void check_shapes(Subject& subject, const Sight& sight, const std::vector<bool>& explained);
/// Surfaces that turn their backs on the viewer, and vertex normals against their triangle's.
void check_normals(Subject& subject, const Sight& sight);
/// Vectors that their source takes as unit vectors.
void check_vectors(Subject& subject);
/// Materials that nothing has, and their numbers.
void check_materials(Subject& subject);
/// What a small picture shows: black, one colour, clamped, epsilon, reflections.
void check_picture(Subject& subject, const Sight& sight);

}  // namespace glint
