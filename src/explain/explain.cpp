// SPDX-License-Identifier: Apache-2.0
// Renders one pixel with the kernels of render() and records what they compute.
#include "glint/explain.h"

#include <algorithm>
#include <memory>

#include "base/fp_environment.h"
#include "base/status.h"
#include "explain/holes.h"
#include "explain/references.h"
#include "explain/solid_crossings.h"
#include "lighting/light.h"
#include "math/transform.h"
#include "trace/kernels.h"
#include "trace/ray_list.h"
#include "trace/record.h"

namespace glint {
namespace {

// The shape that blocks a shadow ray: the one nearest to the shaded point.
// terms: LightTerms or a ShadowSample.
template <class Terms>
std::optional<Blocker> find_blocker(const WorldParts& world, const Terms& terms, Vec3 shaded,
                                    bool from_light) {
    const auto nearest = [&](Vec3 origin, Vec3 direction, double t_min,
                             double t_max) -> std::optional<Blocker> {
        RayList ray;
        ray.add(origin, direction, t_min, t_max);
        const HitList hit = nearest_occluders(world, ray, 1);
        if (!hit.surface[0].exists()) return std::nullopt;
        const Vec3 at = origin + direction * hit.t[0];
        return Blocker{world.geometry->shape_of(hit.surface[0]), length(at - shaded), at};
    };
    std::optional<Blocker> blocker;
    // The same line in the opposite direction.
    if (from_light) {
        blocker = nearest(terms.origin + terms.direction, -terms.direction, 1 - terms.t_max, 1 - terms.t_min);
    }
    // The shadow ray itself: if the reversed ray misses because of rounding, this one hits the shape that
    // blocks the light.
    return blocker ? blocker : nearest(terms.origin, terms.direction, terms.t_min, terms.t_max);
}

// Converts the World's index of the default material to the Scene's, and finds the blockers.
void complete(const Scene& scene, const WorldParts& world, Explanation& e) {
    for (ExplainedRay& ray : e.rays) {
        if (!ray.hit) continue;
        if (ray.hit->material >= scene.materials.size()) ray.hit->material = k_none;
        for (LightTerms& terms : ray.hit->lights) {
            const bool from_light = comes_from_light(scene.lights[terms.light], world.conventions);
            if (terms.blocked && terms.has_ray)
                terms.blocker = find_blocker(world, terms, ray.hit->point, from_light);
            for (ShadowSample& sample : terms.samples) {
                if (sample.blocked) sample.blocker = find_blocker(world, sample, ray.hit->point, from_light);
            }
            if (terms.blocked && !terms.samples.empty()) terms.blocker = terms.samples[0].blocker;
        }
    }
}

// Counts the shapes that block the occlusion samples of the hits.
void find_sky_occluders(const WorldParts& world, std::span<const TileRecord::SkyRay> blocked,
                        Explanation& e) {
    RayList rays;
    for (const TileRecord::SkyRay& ray : blocked) rays.add(ray.origin, ray.direction, ray.t_min, ray.t_max);
    const HitList hits = nearest_occluders(world, rays, 1);
    for (std::size_t i = 0; i < blocked.size(); ++i) {
        if (!hits.surface[i].exists()) continue;
        ExplainedHit& hit = *e.rays[blocked[i].ray].hit;
        auto& list = hit.occlusion->occluders;
        const std::uint32_t shape = world.geometry->shape_of(hits.surface[i]);
        auto at = std::find_if(list.begin(), list.end(), [&](const auto& o) { return o.shape == shape; });
        if (at == list.end()) at = list.insert(list.end(), {shape, 0, 0});
        ++at->samples;
        const bool is_fixed = world.occlusion->method == OcclusionMethod::fixed;
        const double cosine = is_fixed ? 2 * dot(hit.normal, normalize(blocked[i].direction)) : 1;
        at->weight += cosine / world.occlusion->samples;
    }
    for (ExplainedRay& ray : e.rays) {
        if (!ray.hit || !ray.hit->occlusion) continue;
        auto& list = ray.hit->occlusion->occluders;
        std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) {
            return a.samples != b.samples ? a.samples > b.samples : a.shape < b.shape;
        });
    }
}

Status render_pixel(const WorldParts& world, const Kernels& kernels, int sample, Explanation& e) {
    TileRecord record;
    record.only = sample;
    // Clearing a new one takes longer than rendering a pixel.
    thread_local const auto scratch = std::make_unique<TileScratch>();
    scratch->record = &record;
    scratch->counts = {};
    TileJob job;
    job.x = e.x;
    job.y = e.y;
    job.width = job.height = job.row_pixels = 1;
    job.rgb = e.value;
    LayerTargets layers;
    for (std::size_t l = 0; l < k_light_layers; ++l) layers.data[l] = e.layers[l];
    layers.data[static_cast<std::size_t>(Layer::alpha)] = &e.alpha;
    job.layers = &layers;
    kernels.render_tile(world, job, *scratch);
    if (record.is_full)
        return invalid_argument("the pixel has more than " + std::to_string(k_max_explained_rays) +
                                " rays: ask for one of its samples");
    e.rays = std::move(record.rays);
    if (!record.blocked_sky.empty()) find_sky_occluders(world, record.blocked_sky, e);
    e.adaptive = record.difference;
    if (e.adaptive && !record.refined) e.samples = 1;
    e.counts = scratch->counts;
    return {};
}

}  // namespace

Result<Explanation> explain(const Scene& scene, const World& explained, std::int32_t x, std::int32_t y,
                            const ExplainOptions& options) {
    return result_of([&]() -> Result<Explanation> {
        const DefaultFpEnvironment environment;
        const WorldParts& world = explained.parts();
        Explanation e;
        e.x = x;
        e.y = y;
        e.samples = world.settings.samples;
        const Kernels* kernels = find_kernels(options.isa);
        if (kernels == nullptr) return invalid_argument(no_kernels_error(options.isa));
        if (x < 0 || y < 0 || x >= world.settings.width || y >= world.settings.height)
            return invalid_argument("pixel " + std::to_string(x) + "," + std::to_string(y) +
                                    " is not within the picture of " + std::to_string(world.settings.width) +
                                    "x" + std::to_string(world.settings.height));
        if (options.sample < -1 || options.sample >= e.samples * e.samples)
            return invalid_argument("a pixel has " + std::to_string(e.samples * e.samples) + " samples");
        if (std::string fault = world_fault(scene, world); !fault.empty())
            return invalid_argument(std::move(fault));
        Status status = render_pixel(world, *kernels, options.sample, e);
        if (!status.ok()) return status;
        complete(scene, world, e);
        find_holes(world, e);
        find_solid_crossings(scene, world, *kernels, e);
        return e;
    });
}

Result<std::vector<Color>> sample_values(const Explanation& explanation) {
    return result_of([&]() -> Result<std::vector<Color>> {
        const int n = explanation.samples;
        if (n < 1 || n > k_max_samples) return invalid_argument("a pixel has no such number of samples");
        std::vector<Color> values(static_cast<std::size_t>(n) * static_cast<std::size_t>(n));
        for (const ExplainedRay& ray : explanation.rays) {
            if (static_cast<std::size_t>(ray.sample) >= values.size())
                return invalid_argument("a ray is of a sample that the pixel has not");
            Color& value = values[static_cast<std::size_t>(ray.sample)];
            value = value + (ray.hit ? ray.hit->own_light() : ray.background) + ray.fog;
        }
        return values;
    });
}

std::optional<Layer> layer_of(const Explanation& explanation, std::size_t ray) {
    const std::vector<ExplainedRay>& rays = explanation.rays;
    if (ray >= rays.size() || rays[ray].parent < 0) return std::nullopt;
    while (rays[ray].generation > 1) {
        const auto parent = static_cast<std::size_t>(rays[ray].parent);
        if (parent >= ray) return std::nullopt;  // a parent comes before its rays
        ray = parent;
    }
    return rays[ray].transmitted ? Layer::transmission : Layer::reflection;
}

}  // namespace glint
