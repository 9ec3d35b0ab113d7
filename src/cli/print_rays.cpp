// SPDX-License-Identifier: Apache-2.0
// The rays of a pixel in the layout of CSC 473.
#include <fmt/format.h>

#include <iterator>
#include <vector>

#include "cli/explain_text.h"

namespace glint::cli {

std::string print_rays(const Explanation& e, const Scene& scene, int y, const ExplainStyle& style) {
    const auto written = [&](float v) { return to_number(v, style.file.bits, style.file.rule()); };
    std::string text = fmt::format("Pixel: [{}, {}] Color: ({}, {}, {})\n", e.x, y, written(e.value[0]),
                                   written(e.value[1]), written(e.value[2]));
    auto out = std::back_inserter(text);
    const auto braces = [](double a, double b, double c, std::string_view separator) {
        return fmt::format("{{{:.4f}{}{:.4f}{}{:.4f}}}", a, separator, b, separator, c);
    };
    const auto triple = [&](Vec3 v) { return braces(v.x, v.y, v.z, " "); };
    const auto rgb = [&](Color c) { return braces(c.r, c.g, c.b, ", "); };
    std::vector<std::size_t> waiting{camera_ray(e, style.sample)};
    while (!waiting.empty()) {
        const ExplainedRay& ray = e.rays[waiting.back()];
        waiting.pop_back();
        const auto row = [&](std::string_view label, const std::string& value) {
            fmt::format_to(out, "{:>20}: {}\n", label, value);
        };
        text += "----\n";
        row("Iteration type", ray.parent < 0 ? "Primary" : ray.transmitted ? "Refraction" : "Reflection");
        row("Ray", triple(ray.origin) + " -> " + triple(ray.direction));
        if (!ray.hit) {
            text += "  No intersection.\n";
            continue;
        }
        const ExplainedHit& hit = *ray.hit;
        std::string kind(to_string(scene.shapes[hit.shape].kind));
        kind.front() = static_cast<char>(kind.front() - 'a' + 'A');
        row("Hit Object", fmt::format("(ID #{} - {})", hit.shape + 1, kind));
        row("Intersection", fmt::format("{} at T = {:.4f}", triple(hit.point), ray.t));
        row("Normal", triple(hit.normal));
        row("Ambient", rgb(hit.ambient));
        row("Diffuse", rgb(hit.diffuse));
        row("Specular", rgb(hit.specular));
        if (material_of(hit, scene).transmission > 0)
            row("Extra Info", hit.behind ? "into-air" : "into-object");
        // A stack: the last ray is printed first, so glass comes before the mirror.
        for (const ExplainedSecondaryRay* secondary : {&hit.reflected, &hit.transmitted}) {
            if (secondary->ray >= 0) waiting.push_back(static_cast<std::size_t>(secondary->ray));
        }
    }
    return text;
}

}  // namespace glint::cli
