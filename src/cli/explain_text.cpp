// SPDX-License-Identifier: Apache-2.0
#include "cli/explain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <span>

#include "cli/text.h"
#include "glint/image.h"
#include "math/elementary.h"
#include "math/transform.h"
#include "scene/material_fields.h"

namespace glint::cli {
namespace {

std::string number(double x) { return fmt::format("{:.6g}", x == 0 ? 0.0 : x); }
std::string vec(Vec3 v) { return fmt::format("({}, {}, {})", number(v.x), number(v.y), number(v.z)); }
std::string color(Color c) {
    return c.r == c.g && c.g == c.b ? number(c.r)
                                    : fmt::format("({}, {}, {})", number(c.r), number(c.g), number(c.b));
}
// The shortest decimal form that gives the same floats.
std::string color(const float (&c)[3]) {
    return c[0] == c[1] && c[1] == c[2] ? fmt::format("{}", c[0])
                                        : fmt::format("({}, {}, {})", c[0], c[1], c[2]);
}

std::string value_text(double x) { return number(x); }
std::string value_text(bool b) { return b ? "true" : "false"; }
std::string value_text(Color c) { return color(c); }

std::string item_text(const Scene& scene, const ItemTexts& texts, std::uint32_t index, std::string kind) {
    const auto name = texts.name(index);
    kind += name.empty() ? fmt::format(" {}", index + 1) : fmt::format(" '{}'", name);
    const SourcePlace place = texts.place(index);
    if (place.line != 0 && place.file < scene.files.size())
        kind += fmt::format(" ({}:{}:{})", scene.files[place.file], place.line, place.column);
    return kind;
}

// The extended fields that differ from their defaults.
std::string extended_text(const Material& m) {
    std::string text;
    for (const ItemField<Material>& field : k_extended_fields) {
        if (same_bits(field, m, Material{})) continue;
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

// The factor of what is seen through a transparent surface.
Color through_of(const Material& m) {
    return {m.transmit + m.filter * m.color.r, m.transmit + m.filter * m.color.g,
            m.transmit + m.filter * m.color.b};
}

// A coloured block to print after the numbers of a colour.
std::string swatch(const ExplainStyle& style, double r, double g, double b) {
    if (!style.colors) return {};
    return fmt::format("  \x1b[48;2;{};{};{}m    \x1b[0m", to_byte(static_cast<float>(r)),
                       to_byte(static_cast<float>(g)), to_byte(static_cast<float>(b)));
}
double mean(Color c) { return (c.r + c.g + c.b) / 3; }
std::string_view cosine_name(const Scene& scene) {
    return scene.settings.shading == Shading::phong ? "R·V" : "N·H";
}

// The angle between the axis of a spot and the direction from it to P.
double degrees_off_axis(const Light& light, const LightTerms& terms) {
    return acos(dot(normalize(light.axis), terms.to_light) / -terms.distance) * (180 / std::numbers::pi);
}

// The reason why a light adds nothing; empty if it adds something.
std::string nothing_text(const Scene& scene, const ExplainedHit& hit, const LightTerms& terms) {
    switch (reason(terms)) {
        case LightReason::adds:
            return {};
        case LightReason::blocked:
            if (!terms.blocker && !terms.filters.empty())
                return fmt::format("blocked by {} transparent surfaces, which leave {} of it",
                                   terms.filters.size(), color(terms.filter));
            if (!terms.blocker) return "blocked";
            return fmt::format("blocked by {}, {} from P at {}", shape_text(scene, terms.blocker->shape),
                               number(terms.blocker->distance), vec(terms.blocker->point));
        case LightReason::behind:
            return fmt::format("behind the surface: N·L = {}", number(terms.n_l));
        case LightReason::no_color:
            return highlight_reason(terms, hit, scene) == HighlightReason::turned_away
                       ? "k_d is black here, and the highlight points away from the eye"
                       : "the light's colour times the surface's is black";
        case LightReason::faded:
            return "too far: its attenuation is 0";
        case LightReason::in_surface:
            return "the light is at P itself and has no direction";
        case LightReason::faint:
            return fmt::format("too faint: N·L{} = {}, and light_threshold is {}",
                               terms.attenuation * terms.spot != 1 ? " times attenuation and spot" : "",
                               number(terms.n_l * (terms.attenuation * terms.spot)), number(terms.threshold));
        case LightReason::outside_cone:
            return fmt::format("outside its cone: {} degrees off its axis, the outer angle is {}",
                               number(degrees_off_axis(scene.lights[terms.light], terms)),
                               number(scene.lights[terms.light].outer_angle));
        case LightReason::back_of_light:
            return "behind the light, which gives light on one side only";
    }
    return {};
}

// The numbers of an area light's samples, by the shape that blocks or colors them; k_none: by an unknown one.
using SamplesByShape = std::map<std::uint32_t, std::vector<std::int32_t>>;

// "blocked by box 2: 0, 1, 4; by sphere 1: 8"
std::string samples_text(const Scene& scene, std::string_view what, const SamplesByShape& list) {
    std::string text;
    for (const auto& [shape, samples] : list) {
        const bool first = text.empty();
        text += fmt::format("{}{}: {}", first ? what : std::string_view("; "),
                            shape == k_none ? "" : (first ? " by " : "by ") + shape_text(scene, shape),
                            fmt::join(samples, ", "));
    }
    return text;
}

// "12 of 16 samples visible; blocked by box 2: 0, 1, 4; by sphere 1: 8"
std::string visible_samples_text(const Scene& scene, std::size_t visible, std::size_t all,
                                 const SamplesByShape& blocked) {
    std::string text = fmt::format("{} of {} samples visible", visible, all);
    if (!blocked.empty()) text += "; " + samples_text(scene, "blocked", blocked);
    return text;
}

std::string first_highlight_text(const Scene& scene, const ExplainedHit& hit, const LightTerms& terms) {
    switch (highlight_reason(terms, hit, scene)) {
        case HighlightReason::adds:
            return fmt::format("{} = {}, to the power {} = {}", cosine_name(scene), number(terms.s),
                               number(material_of(hit, scene).shininess), number(terms.power));
        case HighlightReason::none:
            return "no highlight: k_s or the light's specular colour is black";
        case HighlightReason::unshaded:
            return "this shading has no highlights";
        case HighlightReason::behind:
            return "no highlight: N·L <= 0";
        case HighlightReason::turned_away:
            return fmt::format("no highlight: {} = {}, pointing away from the eye", cosine_name(scene),
                               number(terms.s));
    }
    return {};
}

// The highlights, and what changes them.
std::string highlight_text(const Scene& scene, const ExplainedHit& hit, const LightTerms& terms) {
    const Material& m = material_of(hit, scene);
    std::string text = first_highlight_text(scene, hit, terms);
    if (!(m.phong == Color{}) && scene.settings.shading != Shading::diffuse) {
        text += terms.phong_power > 0
                    ? fmt::format("; second highlight: R·V = {}, to the power {} = {}", number(terms.phong_s),
                                  number(m.phong_shininess), number(terms.phong_power))
                    : std::string("; no second highlight");
    }
    if (!(terms.highlight_tint == Color{1, 1, 1})) text += "; metallic: tint " + color(terms.highlight_tint);
    return text;
}

class Tree {
  public:
    Tree(const Explanation& e, const Scene& scene, const ExplainStyle& style)
        : e_(e), scene_(scene), style_(style) {}

    void add_ray(std::size_t ray, int depth) {
        const ExplainedRay& r = e_.rays[ray];
        const std::string_view kind = r.parent < 0    ? "camera ray"
                                      : r.straight    ? "ray straight through"
                                      : r.transmitted ? "ray through glass"
                                                      : "mirror ray";
        line(depth, fmt::format("{} {} from {} towards {}{}", kind, ray, vec(r.origin), vec(r.direction),
                                r.parent < 0 ? "" : ", weight " + color(r.weight)));
        if (!r.hit) {
            if (r.beyond_limit)
                line(depth + 1, fmt::format("the limit of {} reflections is reached: it sees the background",
                                            scene_.settings.reflections));
            add_fog(r, depth + 1);
            const bool black = r.background.r == 0 && r.background.g == 0 && r.background.b == 0;
            if (r.transparent && scene_.settings.alpha)
                return line(depth + 1, fmt::format("hits nothing: alpha loses {}", number(mean(r.weight))));
            line(depth + 1, black ? "hits nothing: adds nothing"
                                  : fmt::format("hits nothing: adds the background {}{}", color(r.background),
                                                swatch(style_, r.background)));
            return;
        }
        add_hit(r, depth + 1);
        add_secondary_ray(r.hit->reflected, "mirror", depth + 1);
        add_secondary_ray(r.hit->transmitted, r.hit->transparent ? "straight through" : "glass", depth + 1);
    }

    std::string text;

  private:
    void line(int depth, const std::string& content) {
        text.append(2 * static_cast<std::size_t>(std::min(depth, 40)), ' ');
        text += content;
        text += '\n';
    }

    void add_hit(const ExplainedRay& r, int depth) {
        const ExplainedHit& hit = *r.hit;
        line(depth,
             fmt::format("hits {} at t = {}, from its {}{}", shape_text(scene_, hit.shape), number(r.t),
                         hit.behind ? "back" : "front", hit.turned ? ": N flipped towards the ray" : ""));
        line(depth + 1, fmt::format("P {}  N {}  V {}", vec(hit.point), vec(hit.normal), vec(hit.to_eye)));
        line(depth + 1, material_text(scene_, hit));
        const Shading shading = scene_.settings.shading;
        if (shading == Shading::color || shading == Shading::normals) {
            line(depth + 1, fmt::format("shown: {}{}", color(hit.ambient), swatch(style_, hit.ambient)));
            return;
        }
        line(depth + 1,
             fmt::format("ambient k_a I_a = {}{}", color(hit.ambient), swatch(style_, hit.ambient)));
        for (std::size_t i = 0; i < hit.lights.size();) {
            if (hit.lights[i].sample < 0) {
                add_light(hit, hit.lights[i++], depth + 1);
            } else {
                const std::size_t first = i;
                while (i < hit.lights.size() && hit.lights[i].light == hit.lights[first].light) ++i;
                add_samples(hit, std::span(hit.lights).subspan(first, i - first), depth + 1);
            }
        }
        if (material_of(hit, scene_).mirror_falloff > 0)
            line(depth + 1, fmt::format("mirror: {} at this angle", number(hit.mirror)));
        if (material_of(hit, scene_).transmission > 0)
            line(depth + 1, fmt::format("glass: reflects F = {}, tint {}", number(hit.fresnel),
                                        color(material_of(hit, scene_).transmission_tint)));
        const bool emits = !(hit.emission == Color{});
        if (emits)
            line(depth + 1,
                 fmt::format("emission k_e = {}{}", color(hit.emission), swatch(style_, hit.emission)));
        if (hit.occlusion) add_occlusion(*hit.occlusion, depth + 1);
        if (hit.outline != 1)
            line(depth + 1, fmt::format("outline: diffuse light{} times {} at this angle",
                                        hit.occlusion ? " and sky" : "", number(hit.outline)));
        const Color sum = hit.ambient + hit.diffuse + hit.specular + hit.emission;
        line(depth + 1, fmt::format("sum: ambient {} + diffuse {} + specular {}{} = {}{}", color(hit.ambient),
                                    color(hit.diffuse), color(hit.specular),
                                    emits ? " + emission " + color(hit.emission) : std::string(), color(sum),
                                    swatch(style_, sum)));
        if (scene_.occlusion && scene_.occlusion->direct != 1)
            line(depth + 1,
                 fmt::format("diffuse and specular include the factor `direct` of the occlusion: {}",
                             number(scene_.occlusion->direct)));
        add_fog(r, depth + 1);
        if (!(hit.weight == r.weight))
            line(depth + 1, fmt::format("weight after absorption in {}: {}",
                                        !scene_.fog                   ? "the glass"
                                        : scene_.conventions.beer > 0 ? "glass and fog"
                                                                      : "the fog",
                                        color(hit.weight)));
        if (hit.transparent)
            line(depth + 1, fmt::format("transparent: opacity {}, what is behind times {}",
                                        number(hit.opacity), color(through_of(material_of(hit, scene_)))));
        if (hit.local_share != 1 || r.parent >= 0) {
            const Color part = hit.own_light();
            line(depth + 1, fmt::format("own light: {} x {}{} (the rest is mirror and glass): {}{}",
                                        color(hit.weight), number(hit.local_share),
                                        hit.highlight_share == hit.local_share
                                            ? std::string()
                                            : fmt::format(", highlights x {}", number(hit.highlight_share)),
                                        color(part), swatch(style_, part)));
        }
    }

    void add_occlusion(const ExplainedOcclusion& o, int depth) {
        const bool colored = !(o.factors == Color{o.factor, o.factor, o.factor});
        line(depth, fmt::format("sky: {} of {} samples are blocked, f = {}: k_d color f = {}{}", o.blocked,
                                o.samples, colored ? color(o.factors) : number(o.factor), color(o.light),
                                swatch(style_, o.light)));
        constexpr std::size_t most = 4;
        std::string list;
        for (std::size_t i = 0; i < std::min(o.occluders.size(), most); ++i)
            list += fmt::format("{}{} of them by {}", i == 0 ? "" : ", ", o.occluders[i].samples,
                                shape_text(scene_, o.occluders[i].shape));
        if (o.occluders.size() > most) list += fmt::format(", and {} more shapes", o.occluders.size() - most);
        if (!list.empty()) line(depth + 1, list);
    }

    void add_fog(const ExplainedRay& r, int depth) {
        if (r.visibility == 1) return;
        line(depth, fmt::format("fog: {} of the light is seen, and the fog adds {}{}", number(r.visibility),
                                color(r.fog), swatch(style_, r.fog)));
    }

    void add_light(const ExplainedHit& hit, const LightTerms& terms, int depth) {
        const std::string name = light_text(scene_, terms.light);
        const std::string nothing = nothing_text(scene_, hit, terms);
        const Light& light = scene_.lights[terms.light];
        if (!nothing.empty()) {
            line(depth, fmt::format("{}: {}", name, nothing));
        } else {
            line(depth, fmt::format("{}: diffuse {} + specular {}{}", name, color(terms.diffuse),
                                    color(terms.specular), swatch(style_, terms.diffuse + terms.specular)));
        }
        if (!(terms.distance > 0)) return;
        std::string how = fmt::format("L {}", vec(terms.to_light * (1 / terms.distance)));
        if (light.has_position()) how += fmt::format(", distance {}", number(terms.distance));
        if (terms.attenuation != 1) how += fmt::format(", attenuation {}", number(terms.attenuation));
        if (light.is_spot() && reason(terms) != LightReason::outside_cone)
            how += fmt::format(", spot {} at {} degrees off its axis", number(terms.spot),
                               number(degrees_off_axis(light, terms)));
        if (terms.emitter != 1) how += fmt::format(", emitter's cosine {}", number(terms.emitter));
        how += fmt::format("; N·L = {}", number(terms.n_l));
        const double brilliance = material_of(hit, scene_).brilliance;
        if (brilliance != 1 && terms.n_l > 0)
            how += fmt::format(", to the power {} = {}", number(brilliance), number(terms.diffuse_factor));
        line(depth + 1, fmt::format("{}; {}", how, highlight_text(scene_, hit, terms)));
        constexpr std::size_t most = 12;
        for (std::size_t i = 0; i < std::min(most, terms.filters.size()); ++i) {
            const ShadowFilter& filter = terms.filters[i];
            line(depth + 1,
                 fmt::format("passes {}, {} from P: times {}{}", shape_text(scene_, filter.shape),
                             number(filter.distance), color(filter.factor), swatch(style_, filter.factor)));
        }
        if (terms.filters.size() > most)
            line(depth + 1, fmt::format("and {} more", terms.filters.size() - most));
        if (terms.filters.size() > 1) line(depth + 1, fmt::format("together: times {}", color(terms.filter)));
        if (!terms.samples.empty()) add_shadow_samples(terms, depth + 1);
    }

    // The samples of an area light that shines from its centre.
    void add_shadow_samples(const LightTerms& terms, int depth) {
        SamplesByShape blocked, colored;
        std::size_t visible = 0;
        for (const ShadowSample& sample : terms.samples) {
            if (sample.blocked) {
                blocked[sample.blocker ? sample.blocker->shape : k_none].push_back(sample.sample);
                continue;
            }
            ++visible;
            std::uint32_t before = k_none;  // a sphere has two surfaces
            for (const ShadowFilter& filter : sample.filters) {
                if (filter.shape != before) colored[filter.shape].push_back(sample.sample);
                before = filter.shape;
            }
        }
        line(depth, fmt::format("visible part {}: {}", number(terms.visible),
                                visible_samples_text(scene_, visible, terms.samples.size(), blocked)));
        if (colored.empty()) return;
        line(depth, fmt::format("{}; together: times {}{}", samples_text(scene_, "colored", colored),
                                color(terms.filter), swatch(style_, terms.filter)));
    }

    // The samples of an area light, each of which is a light of its own.
    void add_samples(const ExplainedHit& hit, std::span<const LightTerms> samples, int depth) {
        Color diffuse, specular;
        SamplesByShape blocked;
        std::size_t visible = 0;
        for (const LightTerms& terms : samples) {
            diffuse = diffuse + terms.diffuse;
            specular = specular + terms.specular;
            if (terms.blocked)
                blocked[terms.blocker ? terms.blocker->shape : k_none].push_back(terms.sample);
            else
                visible += terms.may_add ? 1 : 0;
        }
        const std::string name = light_text(scene_, samples[0].light);
        if (visible == 0 && blocked.empty())
            return line(depth, fmt::format("{}: {}", name, nothing_text(scene_, hit, samples[0])));
        line(depth, fmt::format("{}: diffuse {} + specular {}{}", name, color(diffuse), color(specular),
                                swatch(style_, diffuse + specular)));
        line(depth + 1, visible_samples_text(scene_, visible, samples.size(), blocked));
    }

    void add_secondary_ray(const ExplainedSecondaryRay& ray, std::string_view what, int depth) {
        switch (ray.state) {
            case SecondaryRayState::none:
                return;
            case SecondaryRayState::traced:
                return add_ray(static_cast<std::size_t>(ray.ray), depth);
            case SecondaryRayState::limit:
                return line(depth, fmt::format("{}: not traced, the limit of {} reflections is reached", what,
                                               scene_.settings.reflections));
            case SecondaryRayState::faint:
                return line(depth, fmt::format("{}: not traced, its weight {} is {}", what, color(ray.weight),
                                               scene_.conventions.min_weight > 0
                                                   ? fmt::format("below min_weight {}",
                                                                 number(scene_.conventions.min_weight))
                                                   : std::string("0")));
            case SecondaryRayState::cut:
                return line(depth, fmt::format("{}: not traced, a sample has at most {} rays", what,
                                               k_max_sample_rays));
        }
    }

    const Explanation& e_;
    const Scene& scene_;
    const ExplainStyle& style_;
};

// The likely fault of the scene if a light adds nothing.
std::string hint(const LightTerms& terms, const ExplainedHit& hit, const Scene& scene) {
    if (reason(terms) == LightReason::behind && hit.behind && !hit.turned)
        return "the ray sees the back of the surface, whose normal is not flipped: see the convention "
               "'facing'\n";
    if (!terms.blocker) return {};
    const Blocker& blocker = *terms.blocker;
    if (blocker.shape == hit.shape && blocker.distance < 1e-3 * terms.distance)
        return "the surface shadows itself right at P: see the convention 'epsilon'\n";
    if (scene.lights[terms.light].has_position() && blocker.distance > terms.distance)
        return fmt::format(
            "that is beyond the light, {} from P: see the convention 'shadow_stops_at_light'\n",
            number(terms.distance));
    return {};
}

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

// The layers that are not black, and their sum.
void add_sum(const Explanation& e, const Scene& scene, const ExplainStyle& style, std::string& text) {
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
}

// Why adaptive sampling gives the pixel several samples, or one.
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
    text += tree.text;
    add_sum(e, scene, style, text);
    return text;
}

std::string why_not_text(const Explanation& e, const Scene& scene, std::uint32_t light,
                         const ExplainStyle& style) {
    const ExplainedRay& ray = e.rays[camera_ray(e, style.sample)];
    const std::string name = light_text(scene, light);
    if (!ray.hit)
        return fmt::format("{} has nothing to light: the camera ray of pixel {},{} hits nothing\n", name, e.x,
                           e.y);
    if (scene.settings.shading == Shading::color || scene.settings.shading == Shading::normals)
        return fmt::format("{} was not asked: this shading has no lights\n", name);
    if (scene.lights[light].is_ambient()) {
        const Material m = material_of(*ray.hit, scene);
        const Color part = m.ambient * scene.lights[light].color;
        return fmt::format("{} is ambient: it reaches everything, and adds k_a {} times {}: {}\n", name,
                           color(m.ambient), color(scene.lights[light].color), color(part));
    }
    std::size_t blocked = 0, samples = 0;
    Color added;
    const LightTerms* shown = nullptr;
    for (const LightTerms& terms : ray.hit->lights) {
        if (terms.light != light) continue;
        ++samples;
        blocked += terms.blocked ? 1 : 0;
        added = added + terms.diffuse + terms.specular;
        // Of an area light's samples: one that adds light, or is blocked.
        const auto worth = [](const LightTerms& t) {
            return reason(t) == LightReason::adds ? 2 : t.blocked ? 1 : 0;
        };
        if (shown == nullptr || worth(terms) > worth(*shown)) shown = &terms;
    }
    if (shown != nullptr) {
        const LightTerms& terms = *shown;
        std::string text =
            fmt::format("at P {} on {}\n", vec(ray.hit->point), shape_text(scene, ray.hit->shape));
        const std::string nothing = nothing_text(scene, *ray.hit, terms);
        if (nothing.empty() && samples > 1) {
            return text + fmt::format("{} adds light: {}, by {} samples of which {} are blocked\n", name,
                                      color(added), samples, blocked);
        }
        if (nothing.empty()) {
            return text + fmt::format("{} adds light: diffuse {} + specular {} ({})\n", name,
                                      color(terms.diffuse), color(terms.specular),
                                      highlight_text(scene, *ray.hit, terms));
        }
        text += fmt::format("{} adds nothing: {}\n", name, nothing);
        return text + hint(terms, *ray.hit, scene);
    }
    return fmt::format("{} is not evaluated: this shading uses no lights\n", name);
}

}  // namespace glint::cli
