// SPDX-License-Identifier: Apache-2.0
// Unused materials, and numbers of materials that are probably mistakes.
#include <fmt/format.h>

#include "check/checks.h"

namespace glint {
namespace {

constexpr double k_max_color = 20;  // 1 is the maximum; a surface that glows may have several times as much
constexpr double k_min_color = 1.5 / 255;  // a colour from 0 to 1 where the format uses 0 to 255

void check_color(CheckContext& context, std::uint32_t index) {
    const Material& m = context.scene().materials[index];
    const FindingPlace place = context.at_material(index);
    const double most =
        number::max(brightest(m.color), number::max(brightest(m.ambient), brightest(m.diffuse)));
    if (least(m.color) < 0 || least(m.ambient) < 0 || least(m.diffuse) < 0 || least(m.specular) < 0) {
        context.report("material-negative", place,
                       fmt::format("{} has a colour or a coefficient below 0: light makes it darker",
                                   context.material(index)),
                       "give it colours from 0 to 1");
    }
    if (most > k_max_color) {
        context.report(
            "material-color-255", place,
            fmt::format("{} has a colour of {:.4g}, where 1 is the maximum: are these bytes from 0 to 255?",
                        context.material(index), most),
            "divide the colour by 255");
    } else if (most > 0 && most <= k_min_color) {
        context.report(
            "material-almost-black", place,
            fmt::format("{} has a colour of at most {:.2g}, which is no more than 1 of 255: it looks black",
                        context.material(index), most),
            "give the colour on the format's scale: where 255 is the maximum, 1 is almost black");
    }
}

}  // namespace

void check_materials(CheckContext& context) {
    const Scene& scene = context.scene();
    std::vector<bool> used(scene.materials.size());
    for (const Shape& shape : scene.shapes)
        if (shape.material != k_none) used[shape.material] = true;
    const Shading shading = scene.settings.shading;
    const bool highlights = shading == Shading::phong || shading == Shading::blinn_phong;
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
        const FindingPlace place = context.at_material(i);
        if (!used[i]) {
            context.report("material-unused", place, fmt::format("no shape uses {}", context.material(i)),
                           "assign it to a shape, or remove it");
            continue;
        }
        const Material& m = scene.materials[i];
        if (highlights && m.shininess == 0 && brightest(m.specular) > 0) {
            context.report(
                "shininess-zero", place,
                fmt::format(
                    "{} has a highlight of shininess 0: S^0 is 1 wherever the light is, not a highlight",
                    context.material(i)),
                "give it a shininess from 1 (wide) to 1000 (small), or no specular coefficient");
        }
        check_color(context, i);
    }
}

}  // namespace glint
