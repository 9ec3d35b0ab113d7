// SPDX-License-Identifier: Apache-2.0
// Faces of two operands of a solid that coincide where the camera sees it.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/sort_stably.h"
#include "check/checks.h"
#include "check/solid_faces.h"
#include "math/transform.h"
#include "scene/solid_steps.h"
#include "trace/kernels.h"

namespace glint {
namespace {

constexpr std::uint64_t k_most_lines = 1'000'000;    // of a ray and an operand, of all solids: a second
constexpr std::uint64_t k_most_steps = 200'000'000;  // to compare crossings, of all solids: a second
constexpr std::uint64_t k_mesh_lines = 20;           // a mesh takes the time of so many other operands
constexpr std::uint64_t k_box_lines = 20;            // so many rays and a box take the time of one of these
constexpr std::size_t k_most_rays = 20'000;          // of a solid
constexpr std::size_t k_least_rays = 1000;           // fewer can miss a face that is worth a finding
constexpr std::size_t k_least_found = 3;             // rays that meet a pair
constexpr double k_least_share = 1e-4;               // of the picture, as for the faces of whole shapes
constexpr std::size_t k_max_pairs = 3;               // reported of a solid

// The camera's rays, also those that hit nothing, and the secondary ones.
std::vector<SightLine> sight_lines(const CheckContext& context, const VisibleHits& visible) {
    std::vector<SightLine> lines;
    const RayList camera = camera_rays(context.world(), visible.size);
    for (std::size_t i = 0; i < camera.size(); ++i)
        lines.push_back({camera.origin(i), normalize(camera.direction(i)), camera.t_max(i), k_none});
    for (std::size_t generation = 0; generation < visible.generations.size(); ++generation) {
        for (const SurfaceHit& h : visible.generations[generation]) {
            const SightLine line{h.origin, normalize(h.incoming), length(h.point - h.origin), h.shape};
            if (generation == 0) {
                lines[h.ray] = line;
            } else {
                lines.push_back(line);
            }
        }
    }
    return lines;
}

// A lathe in a solid is a merge of cones that touch each other, and of differences of two with the same ends,
// which its author cannot change. By operand the number of the lathe, or 0. Cones that are written in this
// way are not told apart from it.
std::vector<std::uint32_t> lathes_of(const Scene& scene, const SolidTree& tree) {
    const SolidSteps steps(tree);
    std::vector<std::uint32_t> lathe(tree.operands.size());
    using Ends = std::pair<Vec3, Vec3>;
    const auto ends_of = [&](std::size_t step) -> std::optional<Ends> {
        if (!steps.is_operand(step)) return {};
        const Shape& operand = tree.operands[steps.operand(step)];
        const auto of = [](const auto& shape) { return Ends{shape.from, shape.to}; };
        if (operand.kind == ShapeKind::cone) return of(scene.get<Cone>()[operand.index]);
        if (operand.kind == ShapeKind::cylinder) return of(scene.get<Cylinder>()[operand.index]);
        return {};
    };
    const auto is_cone = [&](std::size_t step) { return ends_of(step).has_value(); };
    const auto is_bored = [&](std::size_t step) {
        if (steps.operation(step) != SolidOperation::difference) return false;
        const std::vector<std::size_t> parts = steps.parts(step);
        return parts.size() == 2 && is_cone(parts[0]) && ends_of(parts[0]) == ends_of(parts[1]);
    };
    for (std::size_t step = 0; step < tree.steps.size(); ++step) {
        if (steps.operation(step) != SolidOperation::merge) continue;
        const std::vector<std::size_t> parts = steps.parts(step);
        if (!std::all_of(parts.begin(), parts.end(),
                         [&](std::size_t part) { return is_cone(part) || is_bored(part); }))
            continue;
        for (const std::size_t part : parts) {
            const std::vector<std::size_t> cones = is_cone(part) ? std::vector{part} : steps.parts(part);
            for (const std::size_t of : cones)
                lathe[steps.operand(of)] = static_cast<std::uint32_t>(step + 1);
        }
    }
    return lathe;
}

void report_faces(CheckContext& context, const SolidFaces& faces, std::uint32_t shape, double share_of_ray) {
    const Scene& scene = context.scene();
    const Shape& solid = scene.shapes[shape];
    const auto lathes = lathes_of(scene, scene.solids[scene.get<Solid>()[solid.index].solid]);
    std::vector<std::pair<OperandPair, FacesFound>> list;
    for (const auto& [pair, found] : faces.found()) {
        if (lathes[pair.earlier] != 0 && lathes[pair.earlier] == lathes[pair.later]) continue;
        if (found.lines >= k_least_found && static_cast<double>(found.lines) * share_of_ray > k_least_share)
            list.emplace_back(pair, found);
    }
    sort_stably(list, [](const auto& a, const auto& b) { return a.second.lines > b.second.lines; });
    const auto operands = operands_of(scene, solid);
    const std::size_t named = std::min(list.size(), context.is_model() ? std::size_t{1} : k_max_pairs);
    for (std::size_t i = 0; i < named; ++i) {
        const auto& [pair, found] = list[i];
        const std::size_t more = i + 1 == named ? list.size() - named : 0;
        context.report(
            "faces-coincide", context.at_shape(shape),
            fmt::format("shapes {} and {} of {}, a {} and a {}, have faces that coincide, visible in {} "
                        "of the picture: rounding decides {} there, and other programs may show spots{}",
                        pair.earlier + 1, pair.later + 1, context.shape(shape),
                        to_string(operands[pair.earlier].kind), to_string(operands[pair.later].kind),
                        percent_text(static_cast<double>(found.lines) * share_of_ray),
                        found.changes_surface ? "whether a surface is" : "whose material is",
                        more == 0 ? ""
                                  : fmt::format("; so do {} more {} of its shapes", more,
                                                more == 1 ? "pair" : "pairs")),
            fmt::format("make shape {} reach further than shape {} there, or less far, by more than a "
                        "millionth of its coordinates",
                        pair.later + 1, pair.earlier + 1));
    }
}

}  // namespace

void check_coincident_operands(CheckContext& context, const VisibleHits& visible) {
    const Kernels* const kernels = find_kernels("");
    if (context.scene().solids.empty() || kernels == nullptr) return;
    const PackedGeometry& geometry = *context.world().geometry;
    const std::vector<SightLine> lines = sight_lines(context, visible);
    const std::uint64_t of_box = lines.size() / k_box_lines;
    std::uint64_t left = k_most_lines, steps_left = k_most_steps;
    for (std::uint32_t slot = 0; slot < geometry.bounded && left >= of_box; ++slot) {
        if (geometry.class_of(slot).kind != ShapeKind::solid) continue;
        const std::uint32_t shape = geometry.shape_index[slot];
        const auto operands = operands_of(context.scene(), context.scene().shapes[shape]);
        if (operands.size() < 2) continue;
        left -= of_box;
        SolidFaces faces(context.world(), *kernels, slot);
        std::vector<const SightLine*> met;
        for (const SightLine& line : lines)
            if (meets(faces.box(), line.origin, line.direction, line.end)) met.push_back(&line);
        const auto meshes = static_cast<std::uint64_t>(std::count_if(
            operands.begin(), operands.end(), [](const Shape& s) { return s.kind == ShapeKind::mesh; }));
        const std::uint64_t of_ray = operands.size() + k_mesh_lines * meshes;
        const auto most = static_cast<std::size_t>(std::min<std::uint64_t>(k_most_rays, left / of_ray));
        if (met.empty() || (met.size() > most && most < k_least_rays)) continue;
        const std::size_t step = (met.size() - 1) / most + 1;
        for (std::size_t i = 0; i < met.size() && faces.steps() <= steps_left; i += step)
            faces.look_along(*met[i]);
        left -= of_ray * ((met.size() - 1) / step + 1);
        if (faces.steps() > steps_left) return;
        steps_left -= faces.steps();
        report_faces(context, faces, shape, static_cast<double>(step) / static_cast<double>(visible.rays()));
    }
}

}  // namespace glint
