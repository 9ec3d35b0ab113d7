// SPDX-License-Identifier: Apache-2.0
#pragma once
// Renders a scene, for the modules that compare pictures.
#include <atomic>

#include "glint/render.h"
#include "world/tracer_fault.h"

namespace glint {

/// prepare() and render().
Result<Rendering> render_scene(const Scene& scene, int threads, CancelFlag cancel = {});

/// The same of a World with the scene's lights, materials, background, camera, conventions and settings in
/// place of its own; the scene's shapes are not looked at. With a fault, other kernels render it.
Result<Rendering> render_scene(const World& world, const Scene& shading, TracerFault fault, int threads,
                               CancelFlag cancel = {});

}  // namespace glint
