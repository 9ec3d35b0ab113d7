// SPDX-License-Identifier: Apache-2.0
#pragma once
// The checks, one per kind of mistake. Each reports its findings to the context.
#include <numbers>

#include "check/context.h"
#include "check/visible_hits.h"
#include "math/number.h"

namespace glint {

/// For angles that may be meant in radians.
inline constexpr double k_degrees_per_radian = 180 / std::numbers::pi;

/// The largest and the smallest channel of a color.
inline double brightest(Color c) { return number::max(c.r, number::max(c.g, c.b)); }
inline double least(Color c) { return number::min(c.r, number::min(c.g, c.b)); }

/// Whether the camera sees anything. False if it sees no bounded shape although there are some: the other
/// findings about the picture would then be useless.
bool check_camera(CheckContext& context, const VisibleHits& visible);
/// The camera's angle of view. False if it is in radians: the other findings about the picture would then be
/// useless.
bool check_view_angle(CheckContext& context);
/// Lights that add nothing, and unusual colors of lights.
void check_lights(CheckContext& context, const VisibleHits& visible);
/// Surfaces in the same place, and duplicate shapes. Returns the reported shapes, by index.
std::vector<bool> check_coincident_shapes(CheckContext& context);
/// Shapes without an area, which are marked in `explained`, and flat cylinders.
void check_flat_shapes(CheckContext& context, const VisibleHits& visible, std::vector<bool>& explained);
/// Shapes that no ray hits, except those whose reason is reported already.
void check_shapes(CheckContext& context, const VisibleHits& visible, const std::vector<bool>& explained);
/// Solids that are empty, which are marked in `explained`, and operands that cut nothing.
void check_solids(CheckContext& context, const VisibleHits& visible, std::vector<bool>& explained);
/// Faces of a solid's operands in the same place.
void check_coincident_operands(CheckContext& context, const VisibleHits& visible);
/// Surfaces whose back faces the viewer, and vertex normals on the wrong side of their triangle.
void check_normals(CheckContext& context, const VisibleHits& visible);
/// Triangles of meshes that contradict their neighbours, their normals, or each other.
void check_meshes(CheckContext& context);
/// Vectors that their source requires to be unit vectors.
void check_vectors(CheckContext& context);
/// Unused materials, and unusual values of materials. sees: the camera sees shapes.
void check_materials(CheckContext& context, bool sees);
/// Textures that nothing uses or shows, and those that are so fine that they are noise. sees: the camera sees
/// shapes.
void check_textures(CheckContext& context, const VisibleHits& visible, bool sees);
/// The textures that are so fine that they are noise.
void check_texture_fineness(CheckContext& context, const VisibleHits& visible);
/// Shapes of which the camera sees nothing but backs or holes of their textures, unless check_textures() has
/// said why.
void check_holes(CheckContext& context, const VisibleHits& visible);
/// Fog that hides everything, and fog that is not visible. False if it hides everything: the other findings
/// about the picture would then be useless.
bool check_fog(CheckContext& context);
/// Ambient light without any other.
void check_only_ambient(CheckContext& context, const VisibleHits& visible);
/// Ambient light that is as bright as that of the lights.
void check_ambient_light(CheckContext& context, const VisibleHits& visible);
/// Shapes in the color of the background.
void check_background_shapes(CheckContext& context);
/// Occlusion that darkens nothing.
void check_occlusion(CheckContext& context);
/// Much of a small picture of the scene that is brighter than 1.
void check_clamped(CheckContext& context, const VisibleHits& visible, const Image& picture);
/// Findings from a small picture: black, one color, clamped, epsilon, reflections.
void check_picture(CheckContext& context, const VisibleHits& visible);

}  // namespace glint
