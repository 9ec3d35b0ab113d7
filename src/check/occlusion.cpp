// SPDX-License-Identifier: Apache-2.0
// Occlusion whose reach is so short that nothing is within it.
#include <fmt/format.h>

#include "check/checks.h"

namespace glint {
namespace {

constexpr std::int32_t k_occlusion_picture = 120;  // longest side, pixels
constexpr double k_darker = 8.0 / 255;             // differences in a channel that count
constexpr double k_min_darkened = 0.005;           // of the picture

double share_beyond(const Image& a, const Image& b, double least) {
    return 3 * static_cast<double>(count_differing(a, b, least)) / static_cast<double>(a.rgb.size());
}

}  // namespace

void check_occlusion(CheckContext& context) {
    const Scene& scene = context.scene();
    const Shading shading = scene.settings.shading;
    if (!scene.occlusion || !(scene.occlusion->reach < number::k_infinity) || shading == Shading::color ||
        shading == Shading::normals)
        return;
    const auto render_with = [&](double reach) {
        Occlusion other = *scene.occlusion;
        other.reach = reach;
        return context.render_small(with_occlusion(context.prepared(), other), k_occlusion_picture);
    };
    const double reach = scene.occlusion->reach;
    const Image now = render_with(reach);
    if (now.rgb.empty() || share_beyond(now, render_with(reach / 1000), k_half_byte) > 0) return;
    const double unlimited = share_beyond(now, render_with(number::k_infinity), k_darker);
    if (unlimited < k_min_darkened) return;
    context.report(
        "occlusion-reach-too-short", {scene.occlusion_place, SceneItem::background},
        fmt::format(
            "the reach of the occlusion is {:.3g}, and no shape is that near to a visible surface: nothing "
            "is darkened; without a limit {} of the picture would be darker",
            reach, percent_text(unlimited)),
        "raise `reach` to about the distance between neighbouring shapes, or leave it out");
}

}  // namespace glint
