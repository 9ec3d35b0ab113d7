// SPDX-License-Identifier: Apache-2.0
#pragma once
// Lists of rays for checks and explanations, traced with the renderer's kernels.
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "bvh/rays.h"
#include "glint/vec.h"
#include "world/world.h"

namespace glint {

/// Rays as columns, with the padding that the kernels require.
class RayList {  // NOLINT(bugprone-reserved-identifier): the compiler's own, in copying columns_
  public:
    RayList() {
        for (auto& c : columns_) c.resize(k_ray_padding);
    }
    void add(Vec3 origin, Vec3 direction, double t_min, double t_max = k_far);
    std::size_t size() const { return columns_[0].size() - k_ray_padding; }
    Vec3 origin(std::size_t i) const { return {columns_[0][i], columns_[1][i], columns_[2][i]}; }
    Vec3 direction(std::size_t i) const { return {columns_[3][i], columns_[4][i], columns_[5][i]}; }
    double t_max(std::size_t i) const { return columns_[7][i]; }
    RaySpan from(std::size_t i) const;

    static constexpr double k_far = std::numeric_limits<double>::infinity();

  private:
    std::vector<double> columns_[8];
};

/// The nearest hit of each ray. For a miss, t is the ray's t_max.
struct HitList {
    std::vector<double> t;
    std::vector<SurfaceId> surface;
};
HitList nearest_hits(const WorldParts& world, const RayList& rays, int threads);
/// The nearest hit among shapes that cast shadows.
HitList nearest_occluders(const WorldParts& world, const RayList& rays, int threads);

/// The nearest hit that is not in a hole. visit: called for each hole that a ray passes, in the ray's order.
using VisitHole = std::function<void(std::size_t ray, SurfaceId surface, double t)>;
HitList nearest_surfaces(const WorldParts& world, const RayList& rays, int threads,
                         const VisitHole& visit = {});

}  // namespace glint
