// SPDX-License-Identifier: Apache-2.0
// Unused materials, and numbers of materials that are probably mistakes.
#include <fmt/format.h>

#include <algorithm>

#include "check/checks.h"
#include "world/geometry/primitives.h"

namespace glint {
namespace {

constexpr double k_max_color = 20;  // 1 is the maximum; a surface that glows may have several times as much
constexpr double k_max_glow = 100, k_max_byte = 255;  // emission
constexpr double k_min_glass = 0.01;                  // transmission
// Exporters write exponents up to 100,000 for small highlights. A highlight of a few pixels is a dot.
constexpr double k_max_shininess = 1e5, k_usual_shininess = 60;
constexpr std::size_t k_dot = 5, k_max_looks = 8;
constexpr std::int32_t k_highlight_picture = 480;  // longest side, pixels
constexpr double k_min_color = 1.5 / 255;          // a color from 0 to 1 where the format uses 0 to 255

void check_material_color(CheckContext& context, std::uint32_t index) {
    const Material& m = context.scene().materials[index];
    const FindingPlace place = context.at_material(index);
    const double most =
        number::max(brightest(m.color), number::max(brightest(m.ambient), brightest(m.diffuse)));
    // Exporters give lamps an emission of 10 or 50, and formats of modelling programs that of renderers in
    // which it lights other surfaces.
    const std::string_view end = context.extension_of(place.place);
    const double glow = end == ".gltf" || end == ".glb" || end == ".mtl" ? 0 : brightest(m.emission);
    if (least(m.color) < 0 || least(m.ambient) < 0 || least(m.diffuse) < 0 || least(m.specular) < 0) {
        context.report("material-negative", place,
                       fmt::format("{} has a color or a coefficient below 0: light makes it darker",
                                   context.material(index)),
                       "give it colors from 0 to 1");
    }
    if (most > k_max_color || (glow > k_max_glow && glow <= k_max_byte)) {
        const auto [term, value] =
            brightest(m.color) > k_max_color     ? std::pair("color", brightest(m.color))
            : brightest(m.ambient) > k_max_color ? std::pair("k_a", brightest(m.ambient))
            : brightest(m.diffuse) > k_max_color ? std::pair("k_d", brightest(m.diffuse))
                                                 : std::pair("emission", glow);
        context.report("material-color-255", place,
                       fmt::format("{} has a channel of {:.4g} in its {}, where 1 is the maximum: are these "
                                   "bytes from 0 to 255?",
                                   context.material(index), value, term),
                       "divide it by 255");
    } else if (most > 0 && most <= k_min_color) {
        context.report(
            "material-almost-black", place,
            fmt::format("{} has a color of at most {:.2g}, which is no more than 1 of 255: it looks black",
                        context.material(index), most),
            "give the color on the format's scale: where 255 is the maximum, 1 is almost black");
    }
}

// A highlight of a material: its color and its exponent, which .glint calls `key`.
struct Highlight {
    Color Material::*color;
    double Material::*shininess;
    std::string_view key;
};

// A highlight's exponent, as the file has it.
struct ExponentWords {
    std::string given, range;  // "shininess 0.5", "a shininess from 1 (wide) to 1000 (small)"
    std::string_view unlike;   // a sentence about numbers from 0 to 1
};

ExponentWords exponent_words(const CheckContext& context, std::uint32_t index, const Highlight& highlight) {
    const double n = context.scene().materials[index].*highlight.shininess;
    const std::string_view end = context.extension_of(context.at_material(index).place);
    const bool is_pov = end == ".pov" || end == ".inc", is_second = highlight.color == &Material::phong;
    if (is_pov && !is_second) {
        const bool is_csc473 = context.scene().profile == "csc473";
        const double roughness = is_csc473 ? number::sqrt(2 / (n + 2)) : 1 / n;
        return {fmt::format("roughness {:.3g}, an exponent of {:.6g}", roughness, n),
                is_csc473 ? "a roughness from 0.05 (small) to 0.8 (wide)"
                          : "a roughness from 0.001 (small) to 1 (wide)",
                ""};
    }
    const std::string_view key = is_pov           ? "phong_size"
                                 : end == ".cgfs" ? "specular"
                                 : end == ".mtl"  ? "Ns"
                                                  : highlight.key;
    return {fmt::format("{} {:.6g}", key, n), fmt::format("a {} from 1 (wide) to 1000 (small)", key),
            ". It is an exponent, not a number from 0 to 1"};
}

// The number of pixels in which a material's highlight is visible, with this exponent.
std::size_t highlight_pixels(CheckContext& context, std::uint32_t index, Highlight highlight,
                             double shininess) {
    Material m = context.scene().materials[index];
    m.*highlight.shininess = shininess;
    const Image with = context.render_small(with_material(context.prepared(), index, m), k_highlight_picture);
    m.*highlight.color = {0, 0, 0};
    const Image without =
        context.render_small(with_material(context.prepared(), index, m), k_highlight_picture);
    return count_differing(with, without, k_half_byte);
}

// Exponents with which a highlight covers everything, or nothing. looks: highlights that may still be
// rendered.
void check_shininess(CheckContext& context, std::uint32_t index, std::size_t& looks) {
    const Material& m = context.scene().materials[index];
    const FindingPlace place = context.at_material(index);
    for (const Highlight highlight :
         {Highlight{&Material::specular, &Material::shininess, "shininess"},
          Highlight{&Material::phong, &Material::phong_shininess, "phong_shininess"}}) {
        const double shininess = m.*highlight.shininess;
        if (!(brightest(m.*highlight.color) > 0)) continue;
        const auto [given, range, unlike] = exponent_words(context, index, highlight);
        if (shininess == 0) {
            return context.report(
                "shininess-zero", place,
                fmt::format("{} has a highlight of {}: S^0 is 1 wherever the light is, not a highlight",
                            context.material(index), given),
                fmt::format("give it {}, or no highlight", range));
        }
        if (shininess < 1) {
            return context.report(
                "shininess-too-small", place,
                fmt::format("{} has the {}: the highlight, (R.V)^{:.3g} or (N.H)^{:.3g}, covers almost all "
                            "that the light reaches{}",
                            context.material(index), given, shininess, shininess, unlike),
                fmt::format("give it {}", range));
        }
        if (shininess <= k_max_shininess || looks == 0) continue;
        --looks;
        const std::size_t now = highlight_pixels(context, index, highlight, shininess);
        const std::size_t most = k_dot * std::max<std::size_t>(context.world().lights->size(), 1);
        if (now > most || highlight_pixels(context, index, highlight, k_usual_shininess) <= 4 * most)
            continue;
        return context.report("shininess-too-large", place,
                              fmt::format("{} has the {}: its highlights are smaller than a pixel, and {}",
                                          context.material(index), given,
                                          now == 0 ? "none is visible" : "at most a dot is visible"),
                              fmt::format("give it {}", range));
    }
}

// Transparent materials that show nothing, and glass that does not refract. solid: a closed shape has it.
void check_transparency(CheckContext& context, std::uint32_t index, bool solid) {
    const Scene& scene = context.scene();
    const Material& m = scene.materials[index];
    const FindingPlace place = context.at_material(index);
    // In other formats, `transmission` is all the transparency that there is.
    if (scene.profile == "glint" && solid && m.transmission > k_min_glass && m.ior == 1) {
        context.report(
            "glass-without-refraction", place,
            fmt::format("{} has the transmission {:.3g} and an ior of 1, which is that of air: rays go "
                        "straight through it, as if it were not glass",
                        context.material(index), m.transmission),
            "give it an ior, 1.33 for water or 1.5 for glass; for transparency without refraction, "
            "write `transmit` or `filter` instead of `transmission`");
    }
    // Opacity by the angle hides what is behind the edges.
    if (!m.is_transparent() || m.hollow || m.refracts || m.angled_opacity || m.fade_distance > 0 ||
        m.caustics > 0 || scene.conventions.transparency == Transparency::add)
        return;
    const double kept = m.transmit + m.filter * number::min(1.0, least(m.color));
    const bool shines = brightest(m.specular) > 0 || brightest(m.phong) > 0;
    if (kept < 1 - k_half_byte || brightest(m.emission) > 0 || m.mirror > 0 || m.mirror_min > 0 ||
        (shines && scene.conventions.transparency == Transparency::highlights))
        return;
    context.report(
        "material-invisible", place,
        fmt::format("{} lets all light through ({} = {:.3g}) and has no highlight and no mirror: what "
                    "has it is invisible",
                    context.material(index), m.transmit > 0 ? "transmit" : "filter",
                    m.transmit > 0 ? m.transmit : m.filter),
        "lower it to 0.9 or less, give it a highlight, or remove the shape");
}

// Fields that change a term which the material does not have.
void check_finish(CheckContext& context, std::uint32_t index) {
    const Material& m = context.scene().materials[index];
    const Material usual;
    const bool shines = brightest(m.specular) > 0 || brightest(m.phong) > 0;
    const bool mirrors = m.mirror > 0 || (m.has_angled_mirror() && m.mirror_min > 0);
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
    const std::pair<bool, std::string_view> of_mirrors[] = {{m.mirror_falloff > 0, "`mirror_falloff`"},
                                                            {m.mirror_fresnel, "`mirror_fresnel`"},
                                                            {m.conserve_energy, "`conserve_energy`"},
                                                            {m.mirror_metallic > 0, "`mirror_metallic`"}};
    for (const auto& [is_set, key] : of_mirrors)
        if (is_set && !mirrors) report(key, "it is no mirror", "give it a mirror");
    if (mirrors && brightest(m.mirror_tint) <= 0) {
        context.report("finish-unused", context.at_material(index),
                       fmt::format("{} is a mirror, but the mirror's color is black: it reflects nothing",
                                   context.material(index)),
                       "give the mirror a color, white to reflect all, or leave the mirror out");
    }
    if (m.mirror_falloff > 0 && m.mirror_fresnel)
        report("`mirror_falloff`", "mirror_fresnel is true", "leave one of them out");
    if (m.mirror_fresnel && mirrors && m.ior == 1)
        report("`mirror_fresnel`", "its ior is 1, that of air", "give it an ior, such as 1.5");
    if (m.conserve_energy && mirrors && !m.is_transparent() && m.texture == k_none)
        report("`conserve_energy`", "it lets no light through", "give it a transmit, such as 0.5");
    if (m.outline > 0 && brightest(m.diffuse) == 0)
        report("an outline", "no diffuse light", "give it a diffuse coefficient");
    if (m.outline_width > 0 && m.outline == 0)
        report("`outline_width`", "outline is 0", "give it an outline, such as 0.8");
    if (m.angled_opacity && m.transmit == 0)
        report("`angled_opacity`", "transmit is 0", "give it a transmit, such as 0.5");
    if (!(m.fade_color == usual.fade_color && m.fade_power == usual.fade_power) && m.fade_distance == 0)
        report(m.fade_power == usual.fade_power ? "`fade_color`" : "`fade_power`", "fade_distance is 0",
               "give it a fade_distance, such as 1");
    // Other programs' interiors are also those of opaque objects.
    if (m.fade_distance > 0 && context.scene().profile == "glint" && !m.is_transparent() &&
        m.texture == k_none)
        report("`fade_distance`", "neither filter nor transmit", "give it a transmit, such as 0.9");
    if (m.caustics > 0 && context.scene().profile == "glint" && !m.is_transparent() && m.texture == k_none)
        report("`caustics`", "neither filter nor transmit", "give it a transmit, such as 0.9");
    if (m.mirror_min > 0 && !m.has_angled_mirror())
        report("`mirror_min`", "mirror_falloff is 0", "give it a mirror_falloff, such as 1");
}

}  // namespace

void check_materials(CheckContext& context, bool sees) {
    const Scene& scene = context.scene();
    std::vector<bool> used(scene.materials.size()), solid(scene.materials.size());
    std::vector<bool> base(scene.materials.size());
    for (const std::uint32_t material : scene.base_materials)
        if (material < base.size()) base[material] = true;
    for (std::uint32_t i = 0; i < scene.shapes.size(); ++i) {
        for (const Shape& operand : operands_of(scene, scene.shapes[i]))
            if (operand.material != k_none) used[operand.material] = true;
        const std::uint32_t material = scene.shapes[i].material;
        if (material == k_none) continue;
        used[material] = true;
        if (scene.materials[material].transmission > 0 && is_closed(scene, i)) solid[material] = true;
    }
    std::size_t looks = sees ? k_max_looks : 0;
    const Shading shading = scene.settings.shading;
    const bool highlights = shading == Shading::phong || shading == Shading::blinn_phong;
    for (std::uint32_t i = 0; i < scene.materials.size(); ++i) {
        const FindingPlace place = context.at_material(i);
        if (!used[i] && base[i]) continue;
        if (!used[i]) {
            context.report("material-unused", place, fmt::format("no shape uses {}", context.material(i)),
                           "assign it to a shape, or remove it",
                           context.is_model() ? Severity::note : Severity::warning);
            continue;
        }
        if (highlights) check_shininess(context, i, looks);
        check_transparency(context, i, solid[i]);
        check_material_color(context, i);
        check_finish(context, i);
    }
}

}  // namespace glint
