// SPDX-License-Identifier: Apache-2.0
#pragma once
// The camera and the lights of a scene as nodes of glTF. Both look along -z of their node.
#include "export/gltf/file.h"
#include "export/gltf/losses.h"
#include "export/gltf/shapes.h"
#include "glint/scene.h"
#include "math/extent.h"

namespace glint::gltf_export {

/// Whether the camera's right, up and forward are left-handed. glTF's are right-handed: the scene is then
/// reflected, so that its picture is not.
bool is_left_handed(const Camera& camera);

void add_camera(File& file, const Scene& scene, const Affine& file_from_world, const Extent& box,
                Losses& losses);

/// Lights without the fall-off of glTF are as bright as they were at the usual distance of the shapes.
void add_lights(File& file, const Scene& scene, const Affine& file_from_world, const ShapeMeshes& shapes,
                Losses& losses);

}  // namespace glint::gltf_export
