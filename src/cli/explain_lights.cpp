// SPDX-License-Identifier: Apache-2.0
#include "cli/explain_lights.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <span>

#include "explain/terms.h"
#include "math/elementary.h"
#include "math/transform.h"

namespace glint::cli {
namespace {

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
                       : "the light's color times the surface's is black";
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
                                 const SamplesByShape& blocked, std::string_view weights = {}) {
    std::string text = fmt::format("{} of {} samples visible{}", visible, all, weights);
    if (!blocked.empty()) text += "; " + samples_text(scene, "blocked", blocked);
    return text;
}

std::string first_highlight_text(const Scene& scene, const ExplainedHit& hit, const LightTerms& terms) {
    switch (highlight_reason(terms, hit, scene)) {
        case HighlightReason::adds:
            return fmt::format("{} = {}, to the power {} = {}", cosine_name(scene), number(terms.s),
                               number(material_of(hit, scene).shininess), number(terms.power));
        case HighlightReason::none:
            return "no highlight: k_s or the light's specular color is black";
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

// ", with weights from 0.0156 to 0.25"; empty if all are equal.
std::string weights_text(std::span<const ShadowSample> samples) {
    const auto [least, most] = std::minmax_element(
        samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.weight < b.weight; });
    if (least->weight == most->weight) return {};
    return fmt::format(", with weights from {} to {}", number(least->weight), number(most->weight));
}

// The samples of an area light that shines from its centre.
void add_shadow_samples(IndentedText& text, const Scene& scene, const ExplainStyle& style,
                        const LightTerms& terms, int depth) {
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
    text.line(depth, fmt::format("visible part {}: {}", number(terms.visible),
                                 visible_samples_text(scene, visible, terms.samples.size(), blocked,
                                                      weights_text(terms.samples))));
    if (colored.empty()) return;
    text.line(depth, fmt::format("{}; together: times {}{}", samples_text(scene, "colored", colored),
                                 color(terms.filter), swatch(style, terms.filter)));
}

// "L (0, 1, 0), distance 3; N·L = 0.7; R·V = 0.9, to the power 20 = 0.12"
std::string vectors_text(const Scene& scene, const ExplainedHit& hit, const LightTerms& terms) {
    const Light& light = scene.lights[terms.light];
    std::string how = fmt::format("L {}", vec(terms.to_light * (1 / terms.distance)));
    if (light.has_position()) how += fmt::format(", distance {}", number(terms.distance));
    for_listed_terms(k_light_terms, terms, [&](std::string_view label, double value) {
        how += fmt::format(", {} {}", label, number(value));
    });
    if (light.is_spot() && reason(terms) != LightReason::outside_cone)
        how += fmt::format(", spot {} at {} degrees off its axis", number(terms.spot),
                           number(degrees_off_axis(light, terms)));
    how += fmt::format("; N·L = {}", number(terms.n_l));
    const double brilliance = material_of(hit, scene).brilliance;
    if (brilliance != 1 && terms.n_l > 0)
        how += fmt::format(", to the power {} = {}", number(brilliance), number(terms.diffuse_factor));
    return fmt::format("{}; {}", how, highlight_text(scene, hit, terms));
}

void add_light(IndentedText& text, const Scene& scene, const ExplainStyle& style, const ExplainedHit& hit,
               const LightTerms& terms, int depth) {
    const std::string name = light_text(scene, terms.light);
    const std::string nothing = nothing_text(scene, hit, terms);
    if (!nothing.empty()) {
        text.line(depth, fmt::format("{}: {}", name, nothing));
    } else {
        text.line(depth, fmt::format("{}: diffuse {} + specular {}{}", name, color(terms.diffuse),
                                     color(terms.specular), swatch(style, terms.diffuse + terms.specular)));
    }
    if (!(terms.distance > 0)) return;
    text.line(depth + 1, vectors_text(scene, hit, terms));
    constexpr std::size_t most = 12;
    for (std::size_t i = 0; i < std::min(most, terms.filters.size()); ++i) {
        const ShadowFilter& filter = terms.filters[i];
        text.line(depth + 1,
                  fmt::format("passes {}, {} from P: times {}{}{}", shape_text(scene, filter.shape),
                              number(filter.distance), color(filter.factor), swatch(style, filter.factor),
                              filter.fade == Color{1, 1, 1} ? std::string()
                                                            : ", fades: times " + color(filter.fade)));
    }
    if (terms.filters.size() > most)
        text.line(depth + 1, fmt::format("and {} more", terms.filters.size() - most));
    if (terms.filters.size() > 1)
        text.line(depth + 1, fmt::format("together: times {}", color(terms.filter)));
    if (!terms.samples.empty()) add_shadow_samples(text, scene, style, terms, depth + 1);
}

double sum_of(const LightTerms& terms) {
    const Color c = terms.diffuse + terms.specular;
    return c.r + c.g + c.b;
}

// The samples of an area light, each of which is a light of its own.
void add_samples(IndentedText& text, const Scene& scene, const ExplainStyle& style, const ExplainedHit& hit,
                 std::span<const LightTerms> samples, int depth) {
    Color diffuse, specular;
    SamplesByShape blocked;
    std::size_t visible = 0;
    const LightTerms* brightest = &samples[0];
    for (const LightTerms& terms : samples) {
        if (sum_of(terms) > sum_of(*brightest)) brightest = &terms;
        diffuse = diffuse + terms.diffuse;
        specular = specular + terms.specular;
        if (terms.blocked)
            blocked[terms.blocker ? terms.blocker->shape : k_none].push_back(terms.sample);
        else
            visible += terms.may_add ? 1 : 0;
    }
    const std::string name = light_text(scene, samples[0].light);
    if (visible == 0 && blocked.empty())
        return text.line(depth, fmt::format("{}: {}", name, nothing_text(scene, hit, samples[0])));
    text.line(depth, fmt::format("{}: diffuse {} + specular {}{}", name, color(diffuse), color(specular),
                                 swatch(style, diffuse + specular)));
    text.line(depth + 1, visible_samples_text(scene, visible, samples.size(), blocked));
    const auto [least, most] = std::minmax_element(
        samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.n_l < b.n_l; });
    text.line(depth + 1, fmt::format("each sample has 1/{} of the light; N·L = {} to {}", samples.size(),
                                     number(least->n_l), number(most->n_l)));
    if (brightest->distance > 0)
        text.line(depth + 1, fmt::format("sample {}, which adds most: {}", brightest->sample,
                                         vectors_text(scene, hit, *brightest)));
}

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

}  // namespace

void add_lights(IndentedText& text, const Scene& scene, const ExplainStyle& style, const ExplainedHit& hit,
                int depth) {
    for (std::size_t i = 0; i < hit.lights.size();) {
        if (hit.lights[i].sample < 0) {
            add_light(text, scene, style, hit, hit.lights[i++], depth);
        } else {
            const std::size_t first = i;
            while (i < hit.lights.size() && hit.lights[i].light == hit.lights[first].light) ++i;
            add_samples(text, scene, style, hit, std::span(hit.lights).subspan(first, i - first), depth);
        }
    }
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
