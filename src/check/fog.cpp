// SPDX-License-Identifier: Apache-2.0
// Fog that hides everything, and fog that is not visible.
#include <fmt/format.h>

#include "check/checks.h"

namespace glint {
namespace {

constexpr std::int32_t k_fog_picture = 160;

double brightest(const Image& image) {
    double most = 0;
    for (const float v : image.rgb) most = number::max(most, static_cast<double>(v));
    return most;
}

double greatest_difference(const Image& a, const Image& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.rgb.size() && i < b.rgb.size(); ++i)
        most = number::max(most, number::abs(static_cast<double>(a.rgb[i]) - static_cast<double>(b.rgb[i])));
    return most;
}

// The picture of the shapes alone: the background and the fog give no light.
Image shapes_alone(CheckContext& context, std::optional<Fog> fog) {
    if (fog) fog->color = {0, 0, 0};
    Result<World> world = with_fog(context.prepared(), fog);
    if (world) world = with_background(*world, {0, 0, 0});
    if (world) world = with_gradient(*world, std::nullopt);
    return context.render_small(world, k_fog_picture);
}

}  // namespace

bool check_fog(CheckContext& context) {
    const Scene& scene = context.scene();
    if (!scene.fog || scene.settings.shading == Shading::color || scene.settings.shading == Shading::normals)
        return true;
    const Fog& fog = *scene.fog;
    const FindingPlace place{scene.fog_place, SceneItem::fog};
    const double seen = brightest(shapes_alone(context, fog));
    if (seen < k_half_byte && brightest(shapes_alone(context, std::nullopt)) >= k_half_byte) {
        context.report(
            "fog-hides-everything", place,
            fmt::format("the fog hides all shapes: at most {:.2g} of 255 of their light arrives", 255 * seen),
            fog.has_end() ? "raise `end`" : "lower the density");
        return false;
    }
    const double change =
        greatest_difference(context.render_small(k_fog_picture),
                            context.render_small(with_fog(context.prepared(), std::nullopt), k_fog_picture));
    if (change >= k_half_byte) return true;
    context.report("fog-not-visible", place,
                   fmt::format("the fog changes no pixel by more than {:.2g} of 255", 255 * change),
                   fog.has_end() ? "lower `start` and `end`, or remove the fog"
                                 : "raise the density, lower `start`, or remove the fog");
    return true;
}

}  // namespace glint
