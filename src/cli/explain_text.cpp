// SPDX-License-Identifier: Apache-2.0
#include "cli/explain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/text.h"
#include "cli/explain_lights.h"
#include "cli/explain_numbers.h"
#include "cli/explain_rays.h"
#include "cli/explain_sum.h"
#include "cli/explain_textures.h"
#include "explain/terms.h"
#include "scene/material_fields.h"

namespace glint::cli {
namespace {

std::string value_text(double x) { return number(x); }
std::string value_text(std::int32_t n) { return fmt::format("{}", n); }
std::string value_text(std::uint32_t n) { return fmt::format("{}", n); }
std::string value_text(bool b) { return b ? "true" : "false"; }
std::string value_text(Color c) { return color(c); }

std::string item_text(const Scene& scene, const ItemTexts& texts, std::uint32_t index, std::string kind) {
    const auto name = texts.name(index);
    kind += name.empty() ? fmt::format(" {}", index + 1) : fmt::format(" '{}'", printable(name));
    const SourcePlace place = texts.place(index);
    if (place.line != 0 && place.file < scene.files.size())
        kind += fmt::format(" ({}:{}:{})", printable(scene.files[place.file]), place.line, place.column);
    return kind;
}

// The extended fields that differ from their defaults.
std::string extended_text(const Material& m) {
    std::string text;
    for (const ItemField<Material>& field : k_extended_fields) {
        if (same_bits(field, m, Material{}) || is_field_of(field, &Material::texture)) continue;
        visit_field(field, m, [&](const auto&, const auto& value) {
            text += fmt::format(", {} {}", field.label, value_text(value));
        });
    }
    return text;
}

std::string material_text(const Scene& scene, const ExplainedHit& hit) {
    const Material m = material_of(hit, scene);
    std::string text = hit.material == k_none
                           ? "the default material"
                           : item_text(scene, scene.material_texts, hit.material, "material");
    if (hit.color) text += " in the shape's own color " + color(*hit.color);
    text += fmt::format(": k_a {}, k_d {}, k_s {}, n {}", color(m.ambient), color(m.diffuse),
                        color(m.specular), number(m.shininess));
    if (m.mirror > 0) text += fmt::format(", mirror {}", number(m.mirror));
    if (m.mirror > 0 && !(m.mirror_tint == Color{1, 1, 1})) text += " tinted " + color(m.mirror_tint);
    if (m.transmission > 0)
        text += fmt::format(", transmission {}, ior {}", number(m.transmission), number(m.ior));
    if (m.is_transparent()) text += ", color " + color(m.color);
    return text + extended_text(m);
}

double mean(Color c) { return (c.r + c.g + c.b) / 3; }

class Tree {
  public:
    Tree(const Explanation& e, const Scene& scene, const ExplainStyle& style)
        : e_(e),
          scene_(scene),
          style_(style),
          alpha_loss_(scene.settings.alpha ? 1 - scene.conventions.background_alpha : 0),
          subtrees_(subtrees_of(e, alpha_loss_)) {}

    void add_ray(std::size_t ray, int depth) {
        const ExplainedRay& r = e_.rays[ray];
        text_.line(depth, fmt::format("{} {} from {} towards {}{}", kind_of(r), ray, vec(r.origin),
                                      vec(r.direction), r.parent < 0 ? "" : ", weight " + color(r.weight)));
        if (r.parent >= 0) {
            const std::string start = start_text(r, e_.rays[static_cast<std::size_t>(r.parent)], scene_);
            if (!start.empty()) text_.line(depth + 1, start);
        }
        for (const std::string& line : hole_lines(scene_, r)) text_.line(depth + 1, line);
        if (!r.hit) {
            if (r.beyond_limit)
                text_.line(depth + 1,
                           fmt::format("the limit of {} reflections is reached: it sees the background",
                                       scene_.settings.reflections));
            add_fog(r, depth + 1);
            const bool black = r.background.r == 0 && r.background.g == 0 && r.background.b == 0;
            if (r.transparent && alpha_loss_ > 0) {
                text_.line(depth + 1,
                           fmt::format("hits nothing: alpha loses {}", number(mean(r.weight) * alpha_loss_)));
                if (black) return;
            }
            text_.line(depth + 1, black ? "hits nothing: adds nothing"
                                        : fmt::format("hits nothing: adds the background {}{}",
                                                      color(r.background), swatch(style_, r.background)));
            return;
        }
        add_hit(r, depth + 1);
        add_secondary_ray(r.hit->reflected, "mirror", depth + 1);
        const bool is_straight = r.hit->transparent && !material_of(*r.hit, scene_).refracts;
        add_secondary_ray(r.hit->transmitted, is_straight ? "straight through" : "glass", depth + 1);
    }

    // The rays, and how many of them are not shown.
    std::string text() const {
        if (folded_.rays == 0) return text_.text;
        return text_.text + fmt::format("rays not shown: {}, which add {} in all (--all shows them)\n",
                                        folded_.rays, color(folded_.light));
    }

  private:
    // Of the line of a ray with the shapes of a solid.
    void add_crossings(const ExplainedHit& hit, int depth) {
        const auto operands = operands_of(scene_, scene_.shapes[hit.shape]);
        for (const ExplainedCrossing& c : hit.crossings) {
            const auto operand = static_cast<std::size_t>(c.operand);
            text_.line(depth,
                       fmt::format("t = {}: {} {}, a {}{}{}", number(c.t), c.enters ? "into" : "out of",
                                   operand + 1, to_string(operands[operand].kind),
                                   c.surface ? ": a surface of the solid" : "", c.hit ? ", the hit" : ""));
        }
    }

    void add_hit(const ExplainedRay& r, int depth) {
        const ExplainedHit& hit = *r.hit;
        text_.line(depth, fmt::format("hits {} at t = {}, from its {}{}", shape_text(scene_, hit.shape),
                                      number(r.t), hit.behind ? "back" : "front",
                                      hit.turned ? ": N flipped towards the ray" : ""));
        text_.line(depth + 1,
                   fmt::format("P {}  N {}  V {}", vec(hit.point), vec(hit.normal), vec(hit.to_eye)));
        if (hit.triangle >= 0) {
            text_.line(depth + 1, fmt::format("triangle {} of the mesh, weights of its corners {}{}",
                                              hit.triangle, vec(hit.corner_weights),
                                              hit.mesh_point == hit.point
                                                  ? std::string()
                                                  : "; P in the mesh's coordinates " + vec(hit.mesh_point)));
        }
        const auto operands = operands_of(scene_, scene_.shapes[hit.shape]);
        if (hit.element < operands.size())
            text_.line(depth + 1, fmt::format("the surface of its operand {} of {}, a {}", hit.element + 1,
                                              operands.size(), to_string(operands[hit.element].kind)));
        add_crossings(hit, depth + 2);
        if (hit.texture) {
            for (const std::string& line : texture_lines(scene_, *hit.texture)) text_.line(depth + 1, line);
        }
        text_.line(depth + 1, material_text(scene_, hit));
        const Shading shading = scene_.settings.shading;
        if (shading == Shading::color || shading == Shading::normals) {
            text_.line(depth + 1,
                       fmt::format("shown: {}{}", color(hit.ambient), swatch(style_, hit.ambient)));
            return;
        }
        text_.line(depth + 1,
                   fmt::format("ambient k_a I_a = {}{}", color(hit.ambient), swatch(style_, hit.ambient)));
        for_listed_terms(k_hit_terms, hit, [&](std::string_view label, double value) {
            text_.line(depth + 1, fmt::format("{} {}", label, number(value)));
        });
        add_lights(text_, scene_, style_, hit, depth + 1);
        if (material_of(hit, scene_).has_angled_mirror())
            text_.line(depth + 1, fmt::format("mirror: {} at this angle", number(hit.mirror)));
        if (material_of(hit, scene_).transmission > 0)
            text_.line(depth + 1, fmt::format("glass: reflects F = {}, tint {}", number(hit.fresnel),
                                              color(material_of(hit, scene_).transmission_tint)));
        const bool emits = !(hit.emission == Color{});
        if (emits)
            text_.line(depth + 1,
                       fmt::format("emission k_e = {}{}", color(hit.emission), swatch(style_, hit.emission)));
        if (hit.occlusion) add_occlusion(*hit.occlusion, depth + 1);
        if (hit.outline != 1)
            text_.line(depth + 1, fmt::format("outline: diffuse light{} times {} at this angle",
                                              hit.occlusion ? " and sky" : "", number(hit.outline)));
        const Color sky = hit.occlusion ? hit.occlusion->light * hit.outline : Color{};
        const Color sum = hit.ambient + hit.diffuse + hit.specular + hit.emission + sky;
        text_.line(depth + 1, fmt::format("sum: ambient {} + diffuse {} + specular {}{}{} = {}{}",
                                          color(hit.ambient), color(hit.diffuse), color(hit.specular),
                                          emits ? " + emission " + color(hit.emission) : std::string(),
                                          hit.occlusion ? " + sky " + color(sky) : std::string(), color(sum),
                                          swatch(style_, sum)));
        if (scene_.occlusion && scene_.occlusion->direct != 1)
            text_.line(depth + 1,
                       fmt::format("diffuse and specular include the factor `direct` of the occlusion: {}",
                                   number(scene_.occlusion->direct)));
        add_fog(r, depth + 1);
        if (!(hit.weight == r.weight))
            text_.line(depth + 1, fmt::format("weight after absorption in {}: {}",
                                              !scene_.fog                   ? "the glass"
                                              : scene_.conventions.beer > 0 ? "glass and fog"
                                                                            : "the fog",
                                              color(hit.weight)));
        if (hit.transparent)
            text_.line(depth + 1,
                       fmt::format("transparent: opacity {}, what is behind times {}{}", number(hit.opacity),
                                   color(hit.through),
                                   material_of(hit, scene_).angled_opacity ? ", at this angle" : ""));
        if (!(hit.fade == Color{1, 1, 1}))
            text_.line(depth + 1,
                       "what leaves the object here times " + color(hit.fade) + " (fade_distance)");
        if (hit.transparent && hit.fresnel == 1)
            text_.line(depth + 1, "total internal reflection: all of the light is that of the mirror ray");
        if (hit.local_share != 1 || r.parent >= 0) {
            const Color part = hit.own_light();
            std::string factors;
            if (r.parent >= 0 || !(hit.weight == Color{1, 1, 1})) factors += " x weight " + color(hit.weight);
            if (hit.local_share != 1)
                factors += fmt::format(" x {} (the rest is what it reflects or lets through)",
                                       number(hit.local_share));
            if (hit.highlight_share != hit.local_share)
                factors += fmt::format(", specular x {} instead", number(hit.highlight_share));
            text_.line(depth + 1, fmt::format("added to the pixel: sum{} = {}{}", factors, color(part),
                                              swatch(style_, part)));
        }
    }

    void add_occlusion(const ExplainedOcclusion& o, int depth) {
        const bool colored = !(o.factors == Color{o.factor, o.factor, o.factor});
        text_.line(depth, fmt::format("sky: {} of {} samples are blocked, f = {}: k_d color f = {}{}",
                                      o.blocked, o.samples, colored ? color(o.factors) : number(o.factor),
                                      color(o.light), swatch(style_, o.light)));
        constexpr std::size_t most = 4;
        std::string list;
        for (std::size_t i = 0; i < std::min(o.occluders.size(), most); ++i)
            list += fmt::format("{}{} of them by {}", i == 0 ? "" : ", ", o.occluders[i].samples,
                                shape_text(scene_, o.occluders[i].shape));
        if (o.occluders.size() > most) list += fmt::format(", and {} more shapes", o.occluders.size() - most);
        if (!list.empty()) text_.line(depth + 1, list);
    }

    void add_fog(const ExplainedRay& r, int depth) {
        if (r.inside_object) text_.line(depth, "no fog: the ray is inside an object");
        if (r.visibility == 1) return;
        const bool tints = scene_.fog && scene_.fog->filter > 0;
        text_.line(depth, fmt::format("fog: {} of the light is seen{}, and the fog adds {}{}",
                                      number(r.visibility), tints ? ", tinted by the fog's filter" : "",
                                      color(r.fog), swatch(style_, r.fog)));
    }

    void add_subtree(std::size_t ray, int depth) {
        const Subtree& subtree = subtrees_[ray];
        if (!(255 * subtree.most < style_.fold)) return add_ray(ray, depth);
        const ExplainedRay& r = e_.rays[ray];
        const std::string what =
            fmt::format("{} {} towards {}, weight {}: hits {}", kind_of(r), ray, vec(r.direction),
                        color(r.weight), r.hit ? shape_text(scene_, r.hit->shape) : "nothing");
        if (subtree.rays == 1 && subtree.most == 0 && !r.hit)
            return text_.line(depth, what + ", adds nothing");
        folded_.rays += subtree.rays;
        folded_.light = folded_.light + subtree.light;
        const std::string who =
            subtree.rays == 1 ? "adds" : fmt::format("adds with the {} rays after it", subtree.rays - 1);
        text_.line(depth, fmt::format("{}, {} {}: less than {} of 255", what, who, color(subtree.light),
                                      number(style_.fold)));
    }

    void add_secondary_ray(const ExplainedSecondaryRay& ray, std::string_view what, int depth) {
        switch (ray.state) {
            case SecondaryRayState::none:
                return;
            case SecondaryRayState::traced:
                return add_subtree(static_cast<std::size_t>(ray.ray), depth);
            case SecondaryRayState::limit:
                return text_.line(depth, fmt::format("{}: not traced, the limit of {} reflections is reached",
                                                     what, scene_.settings.reflections));
            case SecondaryRayState::faint:
                return text_.line(
                    depth, fmt::format(
                               "{}: not traced, its weight {} is {}", what, color(ray.weight),
                               scene_.conventions.min_weight > 0
                                   ? fmt::format("below min_weight {}", number(scene_.conventions.min_weight))
                                   : std::string("0")));
            case SecondaryRayState::cut:
                return text_.line(depth, fmt::format("{}: not traced, a sample has at most {} rays", what,
                                                     k_max_sample_rays));
        }
    }

    const Explanation& e_;
    const Scene& scene_;
    const ExplainStyle& style_;
    const double alpha_loss_;
    const std::vector<Subtree> subtrees_;
    Subtree folded_{{}, 0, 0};
    IndentedText text_;
};

}  // namespace

std::size_t camera_ray(const Explanation& e, int sample) {
    for (std::size_t i = 0; i < e.rays.size(); ++i) {
        if (e.rays[i].sample == sample && e.rays[i].parent < 0) return i;
    }
    return 0;
}

std::string color_text(Color c) { return color(c); }

std::string swatch(const ExplainStyle& style, Color c) { return swatch(style, c.r, c.g, c.b); }

std::string shape_text(const Scene& scene, std::uint32_t shape) {
    return item_text(scene, scene.shape_texts, shape, std::string(to_string(scene.shapes[shape].kind)));
}

std::string light_text(const Scene& scene, std::uint32_t light) {
    return item_text(scene, scene.light_texts, light,
                     fmt::format("{} light", to_string(scene.lights[light].kind)));
}

std::string texture_item_text(const Scene& scene, std::uint32_t texture) {
    return item_text(scene, scene.texture_texts, texture, "texture");
}

std::string explanation_text(const Explanation& e, const Scene& scene, const ExplainStyle& style) {
    const int height = scene.settings.height;
    std::string text =
        fmt::format("pixel {},{} of {}x{}{}", e.x, style.from_below ? height - 1 - e.y : e.y,
                    scene.settings.width, height, style.from_below ? ", rows counted from the bottom" : "");
    if (e.samples > 1)
        text += fmt::format(", sample {},{} of {}x{}", style.sample % e.samples, style.sample / e.samples,
                            e.samples, e.samples);
    text += '\n';
    if (e.adaptive) text += adaptive_text(e, scene, style);
    Tree tree(e, scene, style);
    tree.add_ray(camera_ray(e, style.sample), 0);
    return text + tree.text() + sum_text(e, scene, style);
}

}  // namespace glint::cli
