// SPDX-License-Identifier: Apache-2.0
#pragma once
// clipped_by: whether it cuts something, and whether that is seen.
#include <memory>

#include "formats/povray/object.h"

namespace glint::povray {

/// The box of an object with its map; false for planes and groups.
bool bounds_of(const Object& object, Vec3& lo, Vec3& hi);

/// Whether a clipping object holds a whole object, so that it cuts nothing.
bool holds(const Object& clip, const Object& object);

/// Cuts a mesh; false if it cannot be cut by this object.
bool clip_mesh(const Object& clip, Object& object);

/// The half spaces that cut a shape, for clips that are boxes or planes. missing: the message if it is seen.
std::shared_ptr<const Clip> clip_of(const Object& clip, const Object& object, const Missing& missing);

/// Whether the camera of the scene sees directly what is cut.
bool is_seen(const Clip& clip, const Scene& scene);

}  // namespace glint::povray
