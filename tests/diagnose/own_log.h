// SPDX-License-Identifier: Apache-2.0
#pragma once
// Logs that are written from glint's own explanations, with or without a mistake.
#include <fmt/format.h>

#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "glint/diagnose.h"
#include "glint/explain.h"
#include "glint/load.h"

namespace glint::test {

struct OwnScene {
    Scene scene;
    World world;
};

/// The scene of a text in memory. width: of the picture, with its aspect ratio.
inline OwnScene own_scene(std::string text, const std::string& name, int width = 64, int height = 48) {
    LoadOptions options;
    options.settings = {{"size", fmt::format("{}x{}", width, height)}};
    const SceneText one{name, text};
    OwnScene own{load({&one, 1}, options).value(), {}};
    own.world = prepare(own.scene).value();
    return own;
}

/// How a log is written; each function may change what is logged.
struct OwnLog {
    std::function<Vec3(Vec3)> direction = [](Vec3 v) { return v; };
    std::function<Vec3(Vec3)> normal = [](Vec3 v) { return v; };
    std::function<Vec3(Vec3)> to_light = [](Vec3 v) { return v; };
    std::function<Color(Color)> color = [](Color c) { return c; };
    bool is_json = false, has_n_l = true, has_ends = true;
    int decimals = 17;

    std::string number(double v) const {
        return decimals == 17 ? fmt::format("{}", v) : fmt::format("{:.{}f}", v, decimals);
    }
    void add_numbers(std::string& text, std::string_view key, const std::vector<double>& values) const {
        std::string list;
        for (const double v : values) list += (list.empty() ? "" : is_json ? "," : " ") + number(v);
        if (is_json) {
            fmt::format_to(std::back_inserter(text), "{{\"{}\": [{}]}}\n", key, list);
        } else {
            fmt::format_to(std::back_inserter(text), "{} {}\n", key, list);
        }
    }
    void add(std::string& text, std::string_view key, Vec3 v) const {
        add_numbers(text, key, {v.x, v.y, v.z});
    }
    void add(std::string& text, std::string_view key, Color c) const {
        const Color changed = color(c);
        add_numbers(text, key, {changed.r, changed.g, changed.b});
    }

    void add_ray(std::string& text, const Explanation& e, std::size_t index) const {
        const ExplainedRay& ray = e.rays[index];
        text += ray.generation == 0 ? "ray camera\n" : ray.transmitted ? "ray glass\n" : "ray mirror\n";
        add(text, "origin", ray.origin);
        add(text, "direction", direction(ray.direction));
        if (!ray.hit) {
            text += "miss\n";
        } else {
            const ExplainedHit& hit = *ray.hit;
            text += fmt::format("shape {}\n", hit.shape);
            add_numbers(text, "t", {ray.t});
            add(text, "P", hit.point);
            add(text, "N", normal(hit.normal));
            add(text, "V", hit.to_eye);
            for (const LightTerms& light : hit.lights) {
                if (light.sample >= 0) continue;  // of an area light
                text += fmt::format("light {}\n", light.light + 1);
                add(text, "L", to_light(light.to_light));
                if (has_n_l) add_numbers(text, "N.L", {light.n_l});
                text += fmt::format("blocked {}\n", light.blocked ? 1 : 0);
                add(text, "diffuse", light.diffuse);
                add(text, "specular", light.specular);
            }
            add(text, "ambient", hit.ambient);
            for (const ExplainedSecondaryRay& next : {hit.reflected, hit.transmitted})
                if (next.ray >= 0) add_ray(text, e, static_cast<std::size_t>(next.ray));
        }
        if (has_ends) text += "end\n";
    }

    /// Every step-th pixel in both directions.
    std::string write(const OwnScene& own, int step = 7) const {
        std::string text;
        for (int y = 1; y < own.scene.settings.height; y += step) {
            for (int x = 1; x < own.scene.settings.width; x += step) {
                text += fmt::format("pixel {} {}\n", x, y);
                const Explanation e = explain(own.scene, own.world, x, y).value();
                add_ray(text, e, 0);
                add(text, "color", Color{e.value[0], e.value[1], e.value[2]});
            }
        }
        return text;
    }
};

/// "L: light-reversed" for a sure cause, "L: a or b", "L: unknown"; empty: nothing differs. Of the first
/// finding.
inline std::string first_finding(const OwnScene& own, const std::string& log) {
    const Result<Diagnosis> result = diagnose(own.scene, own.world, log);
    if (!result) return "error: " + result.message;
    if (result->judged == 0) return "nothing judged";
    if (result->findings.empty()) return "";
    const DiagnosisFinding& finding = result->findings.front();
    std::string causes;
    for (const DiagnosedCause& cause : finding.causes)
        causes += (causes.empty() ? "" : " or ") + std::string(cause.id);
    if (causes.empty()) causes = "unknown";
    return fmt::format("{}: {}{}{}", finding.quantity, causes,
                       finding.is_sure || finding.causes.empty() ? "" : " (likely)",
                       finding.only.empty() ? "" : " only " + finding.only);
}

}  // namespace glint::test
