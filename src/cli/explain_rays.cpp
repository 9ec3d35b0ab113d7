// SPDX-License-Identifier: Apache-2.0
#include "cli/explain_rays.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/explain_numbers.h"
#include "math/transform.h"

namespace glint::cli {
namespace {

double largest(Color c) { return std::max({std::abs(c.r), std::abs(c.g), std::abs(c.b)}); }

}  // namespace

std::vector<Subtree> subtrees_of(const Explanation& e, double alpha_loss) {
    std::vector<Subtree> subtrees(e.rays.size());
    for (std::size_t i = e.rays.size(); i-- > 0;) {
        const ExplainedRay& ray = e.rays[i];
        const Color light = (ray.hit ? ray.hit->own_light() : ray.background) + ray.fog;
        subtrees[i].light = subtrees[i].light + light;
        subtrees[i].most += largest(light);
        if (ray.transparent) subtrees[i].most += largest(ray.weight) * alpha_loss;
        if (ray.parent < 0 || static_cast<std::size_t>(ray.parent) >= i) continue;
        Subtree& parent = subtrees[static_cast<std::size_t>(ray.parent)];
        parent.light = parent.light + subtrees[i].light;
        parent.most += subtrees[i].most;
        parent.rays += subtrees[i].rays;
    }
    return subtrees;
}

std::string_view kind_of(const ExplainedRay& r) {
    return r.parent < 0    ? "camera ray"
           : r.straight    ? "ray straight through"
           : r.transmitted ? "ray through glass"
                           : "mirror ray";
}

std::string start_text(const ExplainedRay& r, const ExplainedRay& before, const Scene& scene) {
    if (r.straight || !before.hit) return {};
    const Vec3 step = r.origin - before.hit->point;
    const double distance = length(step);
    if (distance == 0)
        return fmt::format("starts at P; a surface nearer than t = {} does not count", number(r.t_min));
    const double along_n = dot(step, before.hit->normal) / distance;
    const double along_ray = dot(step, r.direction) / (distance * length(r.direction));
    const std::string_view way = along_n > 0.999999     ? " along N"
                                 : along_n < -0.999999  ? " against N"
                                 : along_ray > 0.999999 ? " along its own direction"
                                                        : "";
    return fmt::format(
        "starts {} from P{}, so that it does not hit the surface at P again (offset {}, epsilon {})",
        number(distance), way, get_setting(scene, *find_setting("offset")),
        number(scene.conventions.epsilon));
}

}  // namespace glint::cli
