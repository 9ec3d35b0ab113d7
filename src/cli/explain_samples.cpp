// SPDX-License-Identifier: Apache-2.0
// Lists the samples of a pixel, one per line.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "cli/explain_text.h"

namespace glint::cli {

std::string samples_text(const Explanation& e, const Scene& scene, const ExplainStyle& style) {
    const std::vector<Color> values = sample_values(e).value();
    std::vector<std::string> colors;
    std::size_t widest = 0;
    for (const Color& c : values) {
        colors.push_back(color_text(c));
        widest = std::max(widest, colors.back().size());
    }
    std::string text = "its samples, column and row\n";
    for (std::size_t i = 0; i < values.size(); ++i) {
        const int sample = static_cast<int>(i);
        const ExplainedRay& ray = e.rays[camera_ray(e, sample)];
        text += fmt::format("  {:>5}  {:{}}{}  {}{}\n",
                            fmt::format("{},{}", sample % e.samples, sample / e.samples), colors[i], widest,
                            swatch(style, values[i]),
                            ray.hit ? shape_text(scene, ray.hit->shape) : "hits nothing",
                            sample == style.sample ? "; shown above" : "");
    }
    return text;
}

}  // namespace glint::cli
