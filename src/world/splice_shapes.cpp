// SPDX-License-Identifier: Apache-2.0
// Takes shapes out of a World and puts others in.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "base/fp_environment.h"
#include "base/status.h"
#include "scene/mistakes.h"
#include "world/appearance/interiors.h"
#include "world/appearance/shading.h"
#include "world/geometry/pack_shapes.h"
#include "world/geometry/splice_geometry.h"
#include "world/world.h"

namespace glint {
namespace {

// If more than 1 / k_few of all shapes change, building takes about as long and gives a better hierarchy.
constexpr std::size_t k_few = 8;

using Indices = std::vector<std::uint32_t>;

Indices sorted(std::span<const std::uint32_t> shapes) {
    Indices indices(shapes.begin(), shapes.end());
    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());
    return indices;
}

class ShapeSplicer {
  public:
    ShapeSplicer(World& world, const Scene& scene, Indices removed, Indices added,
                 const PrepareOptions& options)
        : world_(world),
          scene_(scene),
          removed_(std::move(removed)),
          added_(std::move(added)),
          options_(options) {}

    Status run(ShapeEdit& edit) {
        const WorldParts& now = world_.parts();
        const std::size_t before = now.geometry->scene_shapes, after = scene_.shapes.size();
        if (!removed_.empty() && removed_.back() >= before)
            return invalid_argument(
                fmt::format("there is no shape {}: the World has {}", removed_.back(), before));
        if (before - removed_.size() + added_.size() != after)
            return invalid_argument(fmt::format("of {} shapes {} are removed and {} added; the scene has {}",
                                                before, removed_.size(), added_.size(), after));
        std::vector<Mistake> mistakes =
            find_mistakes(scene_, added_, now.scene_materials(), options_.threads);
        if (!mistakes.empty()) return invalid_scene(to_diagnostics(std::move(mistakes), scene_));
        if (removed_.empty() && added_.empty()) return {};
        if ((removed_.size() + added_.size()) * k_few > before) return rebuild(edit);
        std::optional<SplicedGeometry> spliced =
            splice_geometry(*now.geometry, scene_, now.conventions.cones, removed_, added_);
        if (!spliced) return rebuild(edit);
        const PackedGeometry& geometry = spliced->geometry;
        if (geometry.cost.expected() > k_max_refit_cost * geometry.built_cost) return rebuild(edit);
        put(std::move(*spliced));
        edit = ShapeEdit::spliced;
        if (options_.progress) options_.progress(1);
        return {};
    }

  private:
    void put(SplicedGeometry spliced) {
        WorldParts parts = world_.parts();
        const std::uint32_t slots = spliced.geometry.count;
        Indices rows = spliced.move_slots(*parts.slot_material, slots);
        const bool has_colors = !parts.slot_color->empty();
        std::vector<float> colors;
        if (has_colors) colors = spliced.move_slots(*parts.slot_color, slots, 3);
        bool is_colored = false;
        for (const std::uint32_t slot : spliced.added) {
            const std::uint32_t shape = spliced.geometry.shape_index[slot];
            const std::uint32_t material = scene_.shapes[shape].material;
            rows[slot] = material == k_none ? parts.scene_materials() : material;
            const ShapeColor color =
                shape < scene_.shape_colors.size() ? scene_.shape_colors[shape] : ShapeColor{};
            is_colored = is_colored || color.is_set();
            if (!has_colors) continue;
            float* const to = colors.data() + 3 * std::size_t{slot};
            to[0] = color.r, to[1] = color.g, to[2] = color.b;
        }
        parts.slot_material = std::move(rows);
        parts.geometry = std::move(spliced.geometry);
        if (has_colors) {
            parts.slot_color = std::move(colors);
        } else if (is_colored) {
            set_colors(parts, scene_.shape_colors, options_.threads);
        }
        replace(std::move(parts));
    }

    Status rebuild(ShapeEdit& edit) {
        Indices all(scene_.shapes.size());
        std::iota(all.begin(), all.end(), 0u);
        WorldParts parts = world_.parts();
        std::vector<Mistake> mistakes = find_mistakes(scene_, all, parts.scene_materials(), options_.threads);
        if (!mistakes.empty()) return invalid_scene(to_diagnostics(std::move(mistakes), scene_));
        auto built = pack_shapes(scene_, parts.conventions.cones, options_);
        if (!built) return cancelled();
        parts.slot_material = find_slot_materials(scene_, *built, parts.scene_materials(), options_.threads);
        parts.geometry = std::move(*built);
        set_colors(parts, scene_.shape_colors, options_.threads);
        replace(std::move(parts));
        edit = ShapeEdit::rebuilt;
        return {};
    }

    // Until then the World is unchanged, whatever fails.
    void replace(WorldParts parts) {
        set_interiors(parts);
        world_ = WorldAccess::make(std::move(parts));
    }

    World& world_;
    const Scene& scene_;
    const Indices removed_, added_;
    const PrepareOptions& options_;
};

}  // namespace

Result<ShapeEdit> splice_shapes(World& world, const Scene& scene, std::span<const std::uint32_t> removed,
                                std::span<const std::uint32_t> added, const PrepareOptions& options) {
    ShapeEdit edit = ShapeEdit::none;
    const auto body = [&] {
        const DefaultFpEnvironment environment;
        return ShapeSplicer(world, scene, sorted(removed), sorted(added), options).run(edit);
    };
    const Status status = result_of(body, " while putting shapes in a scene");
    if (!status.ok()) return status;
    return edit;
}

}  // namespace glint
