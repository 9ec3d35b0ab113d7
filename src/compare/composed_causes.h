// SPDX-License-Identifier: Apache-2.0
#pragma once
// Causes whose picture is computed from several pictures of the scene.
#include <vector>

#include "compare/scene_causes.h"

namespace glint {

using Compose = decltype(SceneCause::compose);
/// Composes what is seen directly, and then what each mirror ray adds: of one ray, it is known what is in
/// shadow, and what it adds alone.
Compose by_levels(Compose compose);
/// The most levels of reflection for which that is tried: each takes pictures of its own.
inline constexpr int k_max_composed_levels = 4;

/// Faults of N.L that no setting makes: |N.L|, and -N.L.
void add_turned_cosines(const Scene& scene, std::vector<SceneCause>& causes);
/// Only the diffuse term is of vectors that are not normalised.
void add_raw_diffuse(const Scene& scene, std::vector<SceneCause>& causes);
/// Surfaces show their normals, and the rest of the picture is right.
void add_shown_normals(const Scene& scene, std::vector<SceneCause>& causes);
/// What mirrors show lacks something that surfaces have.
void add_faults_in_mirrors(const Scene& scene, std::vector<SceneCause>& causes);
/// A tone curve of the whole picture; scenes have none.
void add_tone_curves(std::vector<SceneCause>& causes);

/// Colors are clamped before they are mixed in mirrors.
void add_clamped_parts(const Scene& scene, std::vector<SceneCause>& causes);

// shadow_causes.cpp:
/// Surfaces are black where lights do not reach them, without the ambient term.
void add_black_shadows(const Scene& scene, std::vector<SceneCause>& causes);
/// The greatest of the lights in place of their sum.
void add_greatest_light(const Scene& scene, std::vector<SceneCause>& causes);
/// The result of one light's shadow rays counts for others.
void add_shadows_of_other_lights(const Scene& scene, std::vector<SceneCause>& causes);

/// 1 where a ray hits a surface, else 0.
std::optional<Image> surfaces_of(Scene scene, const RenderScene& render);

}  // namespace glint
