// SPDX-License-Identifier: Apache-2.0
#include "cli/explain_sum.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "cli/explain_numbers.h"

namespace glint::cli {
namespace {

// The rays of the explained sample that add light to a layer.
std::string rays_text(const Explanation& e, Layer layer) {
    std::string text;
    int told = 0;
    for (std::size_t i = 0; i < e.rays.size(); ++i) {
        if (layer_of(e, i) != layer) continue;
        const ExplainedRay& ray = e.rays[i];
        const Color adds = (ray.hit ? ray.hit->own_light() : ray.background) + ray.fog;
        if (adds == Color{}) continue;
        if (++told > 12) return text + " + ...";
        text += fmt::format("{}ray {}: {}", told == 1 ? "   " : " + ", i, color(adds));
    }
    return text;
}

}  // namespace

std::string sum_text(const Explanation& e, const Scene& scene, const ExplainStyle& style) {
    std::string text;
    auto out = std::back_inserter(text);
    if (e.samples > 1)
        fmt::format_to(out, "the pixel: the mean of {0} x {0} samples\n", e.samples);
    else
        text += "the pixel\n";
    for (int l = 0; l < k_light_layers; ++l) {
        const float(&part)[3] = e.layers[l];
        if (part[0] == 0 && part[1] == 0 && part[2] == 0) continue;
        const auto layer = static_cast<Layer>(l);
        fmt::format_to(out, "  + {:13}{}{}{}\n", layer_infos()[static_cast<std::size_t>(l)].name, color(part),
                       swatch(style, part[0], part[1], part[2]), e.samples == 1 ? rays_text(e, layer) : "");
    }
    fmt::format_to(out, "  = {:13}{}\n", "value", color(e.value));
    if (scene.settings.alpha) fmt::format_to(out, "    {:13}{}\n", "alpha", e.alpha);
    const bool clamps = std::any_of(e.value, e.value + 3, [](float v) { return v < 0 || v > 1; });
    const auto written = [&](float v) { return to_number(v, style.file.bits, style.file.rule()); };
    std::string name = style.file.bits == 8 ? "bytes" : "words";
    if (style.file.gamma != 1) name += fmt::format(", to the power {}", style.file.gamma);
    if (style.file.transfer == Transfer::srgb) name += ", sRGB";
    if (style.file.rounding == Rounding::down) name += ", rounded down";
    if (style.file.rounding == Rounding::half_up) name += ", halves up";
    fmt::format_to(out, "    {:12} {} {} {}{}{}\n", name, written(e.value[0]), written(e.value[1]),
                   written(e.value[2]), clamps ? "  (clamped to 0 ... 1)" : "",
                   swatch(style, e.value[0], e.value[1], e.value[2]));
    return text;
}

std::string adaptive_text(const Explanation& e, const Scene& scene, const ExplainStyle& style) {
    const SampleDifference& d = *e.adaptive;
    if (d.x < 0) return "adaptive sampling: one sample, the pixel has no neighbour\n";
    return fmt::format(
        "adaptive sampling: {}, one sample {} differs by {} from that of pixel {},{}, {}; the threshold is "
        "{}\n",
        e.samples > 1 ? fmt::format("{0} x {0} samples", e.samples) : std::string("one sample"), color(d.own),
        number(d.difference), d.x, style.from_below ? scene.settings.height - 1 - d.y : d.y,
        color(d.neighbor), number(scene.settings.aa_threshold.value_or(0)));
}

}  // namespace glint::cli
