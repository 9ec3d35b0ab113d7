// SPDX-License-Identifier: Apache-2.0
#include "diagnose/log_model.h"

#include <algorithm>
#include <limits>

#include "base/parallel_for.h"

namespace glint {
namespace {

// The ray of the explanation that a logged ray is, from those of the rays before.
std::int32_t paired_ray(const LoggedPixel& pixel, const LoggedRay& ray, const PixelReference& reference) {
    const std::vector<ExplainedRay>& rays = reference.explanation->rays;
    if (ray.kind == LoggedRayKind::camera || (ray.parent < 0 && !pixel.rays.empty())) {
        if (ray.kind != LoggedRayKind::camera) return -1;
        const int wanted = pixel.sample;
        std::int32_t best = -1;
        double least = std::numeric_limits<double>::infinity();
        const auto logged = ray.vector(Quantity::direction);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (rays[i].generation != 0 || rays[i].straight || (wanted >= 0 && rays[i].sample != wanted))
                continue;
            const bool is_usable = logged && is_finite(*logged);
            const Vec3 away =
                is_usable ? unit(*logged).value() - unit(ApproxVec(rays[i].direction)).value() : Vec3{};
            if (dot(away, away) < least) least = dot(away, away), best = static_cast<std::int32_t>(i);
        }
        return best;
    }
    const std::int32_t parent = reference.ray[static_cast<std::size_t>(ray.parent)];
    if (parent < 0 || !rays[static_cast<std::size_t>(parent)].hit) return -1;
    const ExplainedHit& hit = *rays[static_cast<std::size_t>(parent)].hit;
    return (ray.kind == LoggedRayKind::mirror ? hit.reflected : hit.transmitted).ray;
}

}  // namespace

ShapeWorlds::ShapeWorlds(const Scene& scene) {
    if (scene.shapes.size() > k_max_shapes) return;
    for (const Shape& shape : scene.shapes) {
        const bool is_mesh = shape.kind == ShapeKind::mesh;
        Scene one = scene;
        one.shapes = {shape};
        one.shape_colors.clear();
        Result<World> world = prepare(one, {.threads = 1});
        if (is_mesh || !world) {
            worlds_.clear();
            return;
        }
        worlds_.push_back(*std::move(world));
    }
}

std::vector<double> ShapeWorlds::hits(std::size_t shape, Vec3 origin, Vec3 direction, double t_min) const {
    std::vector<double> found;
    for (int i = 0; i < 8; ++i) {
        const Ray ray{origin, direction, t_min};
        const Result<std::vector<RayHit>> hit = nearest_hits(worlds_[shape], {&ray, 1}, 1);
        if (!hit || (*hit)[0].shape == k_none) break;
        found.push_back((*hit)[0].t);
        t_min = (*hit)[0].t + 1e-9 * std::max(1.0, std::fabs((*hit)[0].t));
    }
    return found;
}

LogModel::LogModel(const Scene& of_scene, const World& of_world, const TraceLog& of_log, int threads)
    : scene(of_scene), world(of_world), log(of_log) {
    is_simple = !scene.fog && !scene.occlusion && scene.settings.shading != Shading::color &&
                scene.settings.shading != Shading::normals;
    if (log.is_printrays) rules.rows_from_bottom = true;
    if (log.rows_from_bottom) rules.rows_from_bottom = *log.rows_from_bottom;
    explain_pixels(threads);
}

void LogModel::explain_pixels(int threads) {
    references.assign(log.pixels.size(), {});
    parallel_for(log.pixels.size(), threads, [&](std::size_t i) {
        const LoggedPixel& pixel = log.pixels[i];
        PixelReference& reference = references[i];
        Result<Explanation> explanation = explain(scene, world, pixel.x, row(pixel));
        if (!explanation) return;
        reference.explanation = *std::move(explanation);
        for (const LoggedRay& ray : pixel.rays) reference.ray.push_back(paired_ray(pixel, ray, reference));
    });
}

RayHit LogModel::nearest(Vec3 origin, Vec3 direction, double t_min, double t_max) const {
    const Ray ray{origin, direction, t_min, t_max};
    const Result<std::vector<RayHit>> hits = nearest_hits(world, {&ray, 1}, 1);
    return hits ? (*hits)[0] : RayHit{};
}

bool LogModel::is_occluded(Vec3 origin, Vec3 direction, double t_min, double t_max) const {
    const Ray ray{origin, direction, t_min, t_max};
    const Result<std::vector<std::uint8_t>> blocked = occluded(world, {&ray, 1}, 1);
    return blocked && (*blocked)[0] != 0;
}

const ShapeWorlds& LogModel::shape_worlds() const {
    if (!shape_worlds_) shape_worlds_ = std::make_unique<ShapeWorlds>(scene);
    return *shape_worlds_;
}

}  // namespace glint
