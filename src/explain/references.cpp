// SPDX-License-Identifier: Apache-2.0
#include "explain/references.h"

#include <fmt/format.h>

#include <algorithm>

namespace glint {
namespace {

constexpr std::string_view k_edited = "the scene is not the one that the world was prepared from";

std::string hole_fault(const ExplainedRay& ray, const Scene& scene) {
    for (const ExplainedHole& hole : ray.holes) {
        if (hole.shape >= scene.shapes.size())
            return fmt::format("shape {} of {}", hole.shape, scene.shapes.size());
        if (hole.texture && hole.texture->texture >= scene.textures.size())
            return fmt::format("texture {} of {}", hole.texture->texture, scene.textures.size());
    }
    return {};
}

std::string hit_fault(const ExplainedHit& hit, const Scene& scene) {
    const auto beyond = [](std::string_view what, std::uint32_t index, std::size_t count) {
        return fmt::format("{} {} of {}", what, index, count);
    };
    if (hit.shape >= scene.shapes.size()) return beyond("shape", hit.shape, scene.shapes.size());
    if (hit.material != k_none && hit.material >= scene.materials.size())
        return beyond("material", hit.material, scene.materials.size());
    if (hit.texture && hit.texture->texture >= scene.textures.size())
        return beyond("texture", hit.texture->texture, scene.textures.size());
    for (const LightTerms& terms : hit.lights) {
        if (terms.light >= scene.lights.size()) return beyond("light", terms.light, scene.lights.size());
        if (terms.blocker && terms.blocker->shape >= scene.shapes.size())
            return beyond("shape", terms.blocker->shape, scene.shapes.size());
        for (const ShadowFilter& filter : terms.filters) {
            if (filter.shape >= scene.shapes.size())
                return beyond("shape", filter.shape, scene.shapes.size());
        }
        for (const ShadowSample& sample : terms.samples) {
            if (sample.blocker && sample.blocker->shape >= scene.shapes.size())
                return beyond("shape", sample.blocker->shape, scene.shapes.size());
        }
    }
    return {};
}

}  // namespace

std::string world_fault(const Scene& scene, const WorldParts& world) {
    const auto differ = [](std::string_view what, std::size_t in_scene, std::size_t in_world) {
        return fmt::format("{}: {} {}, the world's {}", k_edited, in_scene, what, in_world);
    };
    if (scene.shapes.size() != world.geometry->scene_shapes)
        return differ("shapes", scene.shapes.size(), world.geometry->scene_shapes);
    if (scene.materials.size() != world.scene_materials())
        return differ("materials", scene.materials.size(), world.scene_materials());
    std::vector<LightKind> kinds;
    for (const Light& light : scene.lights) {
        if (!light.is_ambient()) kinds.push_back(light.kind);
    }
    if (kinds.size() != world.lights->size())
        return differ("lights that are not ambient", kinds.size(), world.lights->size());
    if (!std::equal(kinds.begin(), kinds.end(), world.lights->begin(),
                    [](LightKind kind, const Light& light) { return kind == light.kind; }))
        return fmt::format("{}: its lights are of other kinds", k_edited);
    return {};
}

std::string explanation_fault(const Explanation& explanation, const Scene& scene) {
    if (explanation.samples < 1 || explanation.samples > k_max_samples)
        return fmt::format("an explanation of {} x {} samples", explanation.samples, explanation.samples);
    for (std::size_t i = 0; i < explanation.rays.size(); ++i) {
        const ExplainedRay& ray = explanation.rays[i];
        if (ray.sample < 0 || ray.sample >= explanation.samples * explanation.samples)
            return fmt::format("ray {} is of sample {}, which the pixel has not", i, ray.sample);
        if (ray.parent >= 0 && static_cast<std::size_t>(ray.parent) >= i)
            return fmt::format("ray {} comes from ray {}, which is not before it", i, ray.parent);
        std::string missing = hole_fault(ray, scene);
        if (missing.empty() && ray.hit) missing = hit_fault(*ray.hit, scene);
        if (!missing.empty())
            return fmt::format("the explanation is not of this scene: ray {} names {}", i, missing);
    }
    return {};
}

}  // namespace glint
