// One pixel drawn by render()'s kernels, with a record of what they do.
#include "glint/explain.h"

#include <memory>

#include "base/fp_environment.h"
#include "base/guard.h"
#include "math/number.h"
#include "math/transform.h"
#include "trace/kernels.h"
#include "trace/record.h"

namespace glint {
namespace {

// A single ray as the kernels take rays.
class OneRay {
  public:
    OneRay(Vec3 origin, Vec3 direction, double t_min, double t_max)
        : columns_{{origin.x},    {origin.y},    {origin.z}, {direction.x},
                   {direction.y}, {direction.z}, {t_min},    {t_max}} {}

    // The nearest hit on it, beyond surfaces that cast no shadow; false if there is none.
    bool nearest_occluder(const Kernels& kernels, const World& world, double& t, std::uint32_t& slot) {
        for (;;) {
            const RaySpan rays{columns_[0], columns_[1], columns_[2], columns_[3],
                               columns_[4], columns_[5], columns_[6], columns_[7]};
            double found[1 + k_ray_padding];
            std::uint32_t slots[1 + k_ray_padding];
            kernels.nearest_hit(world, rays, 1, 1, found, slots);
            t = found[0];
            slot = slots[0];
            if (slot == k_none) return false;
            if ((world.material[slot] & k_no_shadow) == 0) return true;
            columns_[6][0] = t;
        }
    }

  private:
    double columns_[8][1 + k_ray_padding];
};

// What is in the way of a shadow ray: the nearest to the point that is shaded.
std::optional<Blocker> find_blocker(const World& world, const Kernels& kernels, const LightTerms& terms,
                                    Vec3 shaded, bool from_light) {
    double t = 0;
    std::uint32_t slot = k_none;
    const auto blocker = [&](Vec3 at) { return Blocker{world.shape_index[slot], length(at - shaded), at}; };
    if (from_light) {
        // The same way from its other end.
        const Vec3 start = terms.origin + terms.direction;
        OneRay back(start, -terms.direction, 1 - terms.t_max, 1 - terms.t_min);
        if (back.nearest_occluder(kernels, world, t, slot)) return blocker(start - terms.direction * t);
    }
    // The shadow ray itself. Where the way back misses by its rounding, what this finds is in the way for
    // certain.
    OneRay ray(terms.origin, terms.direction, terms.t_min, terms.t_max);
    if (!ray.nearest_occluder(kernels, world, t, slot)) return std::nullopt;
    return blocker(terms.origin + terms.direction * t);
}

std::vector<std::uint32_t> scene_lights(const Scene& scene) {
    std::vector<std::uint32_t> numbers;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (scene.lights[i].kind != LightKind::ambient) numbers.push_back(static_cast<std::uint32_t>(i));
    }
    return numbers;
}

// From the World's numbers to the Scene's, and who blocks which light.
void complete(const Scene& scene, const World& world, const Kernels& kernels, Explanation& e) {
    const std::vector<std::uint32_t> lights = scene_lights(scene);
    for (ExplainedRay& ray : e.rays) {
        if (!ray.hit) continue;
        if (ray.hit->material >= scene.materials.size()) ray.hit->material = k_none;
        for (LightTerms& terms : ray.hit->lights) {
            terms.light = lights[terms.light];
            const bool from_light =
                scene.lights[terms.light].kind == LightKind::point && world.conventions.shadow_stops_at_light;
            if (terms.blocked)
                terms.blocker = find_blocker(world, kernels, terms, ray.hit->point, from_light);
        }
    }
}

void draw(const World& world, const Kernels& kernels, int sample, Explanation& e) {
    TileRecord record;
    record.only = sample;
    const auto scratch = std::make_unique<TileScratch>();
    scratch->record = &record;
    TileJob job;
    job.x = e.x;
    job.y = e.y;
    job.width = job.height = job.row_pixels = 1;
    job.rgb = e.value;
    LayerTargets layers;
    for (std::size_t l = 0; l < k_light_layers; ++l) layers.data[l] = e.layers[l];
    job.layers = &layers;
    kernels.render_tile(world, job, *scratch);
    if (record.is_full) {
        e.error = "the pixel has more than " + std::to_string(k_most_explained_rays) +
                  " rays: ask for one of its samples";
        return;
    }
    e.rays = std::move(record.rays);
    e.counts = scratch->counts;
}

}  // namespace

Explanation explain(const Scene& scene, const World& world, std::int32_t x, std::int32_t y,
                    const ExplainOptions& options) {
    Explanation e;
    e.x = x;
    e.y = y;
    e.samples = world.settings.samples;
    const Kernels* kernels = find_kernels(options.isa);
    if (kernels == nullptr) {
        e.error = no_kernels_error(options.isa);
    } else if (x < 0 || y < 0 || x >= world.settings.width || y >= world.settings.height) {
        e.error = "pixel " + std::to_string(x) + "," + std::to_string(y) + " is not within the picture of " +
                  std::to_string(world.settings.width) + "x" + std::to_string(world.settings.height);
    } else if (options.sample >= e.samples * e.samples) {
        e.error = "a pixel has " + std::to_string(e.samples * e.samples) + " samples";
    } else {
        const std::string failure = guard([&] {
            const DefaultFpEnvironment environment;
            draw(world, *kernels, options.sample, e);
            complete(scene, world, *kernels, e);
        });
        if (!failure.empty()) e.error = failure;
    }
    return e;
}

std::optional<Layer> layer_of(const Explanation& explanation, std::size_t ray) {
    const ExplainedRay* at = &explanation.rays[ray];
    if (at->parent < 0) return std::nullopt;
    while (at->generation > 1) at = &explanation.rays[static_cast<std::size_t>(at->parent)];
    return at->transmitted ? Layer::transmission : Layer::reflection;
}

}  // namespace glint
