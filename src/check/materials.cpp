// SPDX-License-Identifier: Apache-2.0
// Unused materials, and numbers of materials that are probably mistakes.
#include <fmt/format.h>

#include "check/checks.h"

namespace glint {
namespace {

constexpr double k_max_color = 20;  // 1 is the maximum; a surface that glows may have several times as much
constexpr double k_min_color = 1.5 / 255;  // a colour from 0 to 1 where the format uses 0 to 255

void check_material_color(CheckContext& context, std::uint32_t index) {
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

// Fields that change a term which the material does not have.
void check_finish(CheckContext& context, std::uint32_t index) {
    const Material& m = context.scene().materials[index];
    const Material usual;
    const bool shines = brightest(m.specular) > 0 || brightest(m.phong) > 0;
    const bool mirrors = m.mirror > 0 || (m.mirror_falloff > 0 && m.mirror_min > 0);
    const auto report = [&](std::string_view key, std::string_view what, std::string_view cure) {
        context.report(
            "finish-unused", context.at_material(index),
            fmt::format("{} has {}, but {}: it changes nothing", context.material(index), key, what),
            std::string(cure));
    };
    if (m.metallic > 0 && !shines)
        report("`metallic`", "no highlight", "give it a specular_color or a phong_color");
    if (m.brilliance != usual.brilliance && brightest(m.diffuse) == 0)
        report("a brilliance", "no diffuse light", "give it a diffuse coefficient");
    if ((m.mirror_falloff > 0 || m.mirror_metallic > 0) && !mirrors)
        report(m.mirror_falloff > 0 ? "`mirror_falloff`" : "`mirror_metallic`", "it is no mirror",
               "give it a mirror");
    if (m.outline > 0 && brightest(m.diffuse) == 0)
        report("an outline", "no diffuse light", "give it a diffuse coefficient");
    if (m.outline_width > 0 && m.outline == 0)
        report("`outline_width`", "outline is 0", "give it an outline, such as 0.8");
    if (m.mirror_min > 0 && !(m.mirror_falloff > 0))
        report("`mirror_min`", "mirror_falloff is 0", "give it a mirror_falloff, such as 1");
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
        check_material_color(context, i);
        check_finish(context, i);
    }
}

}  // namespace glint
