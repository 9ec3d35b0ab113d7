// SPDX-License-Identifier: Apache-2.0
#include "compare/composed_causes.h"

#include <algorithm>

#include "compare/scene_faults.h"
#include "math/elementary.h"

namespace glint {
namespace {

bool has_diffuse_light(const Scene& scene) {
    return is_lit(scene) && any_material(scene, [](const Material& m) { return !is_zero(m.diffuse); });
}

// The diffuse term of lights behind surfaces, with |N.L|: the picture with max(0, N.L) minus the one with
// N.L.
std::optional<Image> diffuse_from_behind(Scene scene, const RenderScene& render) {
    std::erase_if(scene.lights, is_ambient);
    for_each_material(scene, [](Material& m) { m.specular = {0, 0, 0}; });
    scene.background = {0, 0, 0};
    scene.conventions.clamp_cosines = true;
    std::optional<Image> clamped = render(scene);
    scene.conventions.clamp_cosines = false;
    const std::optional<Image> signed_sum = render(scene);
    if (!clamped || !signed_sum) return std::nullopt;
    for (std::size_t i = 0; i < clamped->rgb.size(); ++i) clamped->rgb[i] -= signed_sum->rgb[i];
    return clamped;
}

}  // namespace

// Light is a sum, so the pictures of these faults are sums, too.
void add_turned_cosines(const Scene& scene, std::vector<SceneCause>& causes) {
    if (!has_diffuse_light(scene) || !scene.conventions.clamp_cosines) return;
    const auto add = [&](const char* name, const char* explanation, bool lit) {
        SceneCause cause{name, explanation, {}};
        cause.compose = [lit](const Scene& s, const RenderScene& render) -> std::optional<Image> {
            Scene base = s;
            if (!lit) std::erase_if(base.lights, [](const Light& l) { return !is_ambient(l); });
            std::optional<Image> sum = render(base);
            const std::optional<Image> behind = diffuse_from_behind(s, render);
            if (!sum || !behind) return std::nullopt;
            for (std::size_t i = 0; i < sum->rgb.size(); ++i) sum->rgb[i] += behind->rgb[i];
            return sum;
        };
        causes.push_back(std::move(cause));
    };
    add("abs-cosine",
        "Light from behind a surface is added as if it came from the front: |N.L| is used instead of "
        "max(0, N.L).",
        true);
    add("normals-reversed",
        "Surfaces are lit from behind and dark in front: N is reversed (a sphere's N is P - C, not C - P), "
        "or L is reversed.",
        false);
}

// What else there is, and that term.
void add_raw_diffuse(const Scene& scene, std::vector<SceneCause>& causes) {
    if (!has_diffuse_light(scene) || !scene.conventions.normalize || !has_highlights(scene)) return;
    SceneCause cause{
        "not-normalized", "L is not of unit length in the diffuse term: normalise it before taking N.L.", {}};
    cause.compose = [](const Scene& s, const RenderScene& render) -> std::optional<Image> {
        Scene others = s, diffuse = s;
        for_each_material(others, [](Material& m) { m.diffuse = {0, 0, 0}; });
        for_each_material(diffuse, [](Material& m) { m.specular = m.phong = {0, 0, 0}; });
        for (Light& light : diffuse.lights) {
            if (is_ambient(light)) switch_off(light);
        }
        // What does not depend on normals is in the other picture.
        for_each_material(diffuse, [](Material& m) { m.emission = {0, 0, 0}; });
        if (diffuse.fog) diffuse.fog->color = {0, 0, 0};
        diffuse.background = {0, 0, 0};
        diffuse.gradient.reset();
        diffuse.conventions.normalize = false;
        std::optional<Image> sum = render(others);
        const std::optional<Image> part = render(diffuse);
        if (!sum || !part) return std::nullopt;
        for (std::size_t i = 0; i < sum->rgb.size(); ++i) sum->rgb[i] += part->rgb[i];
        return sum;
    };
    causes.push_back(std::move(cause));
}

std::optional<Image> surfaces_of(Scene scene, const RenderScene& render) {
    for_each_material(scene, [](Material& m) { m.color = {1, 1, 1}; });
    scene.settings.shading = Shading::color;
    scene.settings.reflections = 0;
    scene.background = {0, 0, 0};
    scene.gradient.reset();
    scene.fog.reset();
    return render(scene);
}

// Without the color that stands for "no shape" then.
void add_shown_normals(const Scene& scene, std::vector<SceneCause>& causes) {
    if (!is_lit(scene)) return;
    SceneCause cause{
        "normals-shown", "Surfaces show their normals as colors, 0.5 (N + 1): a picture for debugging.", {}};
    cause.compose = [](const Scene& s, const RenderScene& render) -> std::optional<Image> {
        Scene shown = s;
        shown.settings.shading = Shading::normals;
        std::optional<Image> made = render(shown);
        const std::optional<Image> surfaces = surfaces_of(s, render), plain = render(s);
        if (!made || !surfaces || !plain) return std::nullopt;
        for (std::size_t i = 0; i < made->rgb.size(); i += 3) {
            const float* surface = &surfaces->rgb[i];
            if (std::all_of(surface, surface + 3, [](float v) { return v == 0; }))
                std::copy_n(&plain->rgb[i], 3, &made->rgb[i]);
        }
        return made;
    };
    causes.push_back(std::move(cause));
}

namespace {

using Put = void (*)(Scene&);

// Of mirrors: takes the factor 1 - a out of a part of the surface's own color.
void keep_whole(Scene& s, Color Material::*part) {
    for_each_material(s, [=](Material& m) {
        if (m.mirror > 0 && m.mirror < 1) m.*part = m.*part * (1 / (1 - m.mirror));
    });
}
// What is seen without the last mirror rays: surfaces where the recursion ends are not mixed.
Scene without_last_level(Scene s) {
    s.conventions.limit = LimitRule::drop;
    if (--s.settings.reflections > 0) return s;
    s.settings.reflections = 1;
    for_each_material(s, [](Material& m) { m.mirror_tint = {0, 0, 0}; });
    return s;
}
Scene without_reflected(Scene s) {
    for_each_material(s, [](Material& m) { m.mirror_tint = {0, 0, 0}; });
    return s;
}

}  // namespace

// Of mirrors of which a part is right, the picture is a sum: right + faulty - what is in both.
void add_faults_in_mirrors(const Scene& scene, std::vector<SceneCause>& causes) {
    if (!has_mirrors(scene) || !is_lit(scene)) return;
    const auto add = [&](const char* name, const char* explanation, Put put, bool in_mirrors) {
        SceneCause cause{name, explanation, {}};
        cause.compose = [=](const Scene& s, const RenderScene& render) -> std::optional<Image> {
            Scene faulty = s;
            put(faulty);
            std::optional<Image> sum = render(in_mirrors ? without_reflected(s) : s);
            const std::optional<Image> more = render(in_mirrors ? faulty : without_last_level(faulty)),
                                       less = render(in_mirrors ? without_reflected(faulty)
                                                                : without_last_level(s));
            if (!sum || !more || !less) return std::nullopt;
            for (std::size_t i = 0; i < sum->rgb.size(); ++i) sum->rgb[i] += more->rgb[i] - less->rgb[i];
            return sum;
        };
        causes.push_back(std::move(cause));
    };
    const char *const own = "mirror-part-not-mixed", *const shown = "mirrors-show-less";
    if (scene.conventions.mirror == MirrorRule::blend) {
        add(
            own, "Highlights of mirrors are not multiplied by 1 - a: they belong to the local color.",
            [](Scene& s) { keep_whole(s, &Material::specular); }, false);
        add(
            own, "The ambient term of mirrors is not multiplied by 1 - a: it belongs to the local color.",
            [](Scene& s) { keep_whole(s, &Material::ambient); }, false);
    }
    add(
        shown, "What mirrors show has no shadows: light it as what the camera sees.",
        [](Scene& s) { s.settings.shadows = false; }, true);
    add(
        shown, "What mirrors show has no highlights: light it as what the camera sees.",
        [](Scene& s) { for_each_material(s, [](Material& m) {
                           m.specular = m.phong = {0, 0, 0};
                       }); }, true);
    add(
        shown,
        "What mirrors show has no light, but its plain diffuse color: light it as what the camera sees.",
        [](Scene& s) {
            std::for_each(s.lights.begin(), s.lights.end(), switch_off);
            for_each_material(s, [](Material& m) { m.emission = m.diffuse; });
        },
        true);
}

Compose by_levels(Compose compose) {
    return [compose = std::move(compose)](const Scene& s, const RenderScene& render) -> std::optional<Image> {
        if (!has_mirrors(s)) return compose(s, render);
        const int last = s.settings.reflections;
        std::optional<Image> sum;
        std::vector<Image> so_far;  // up to the level before, by the number of the picture
        for (int level = 0; level <= last; ++level) {
            std::size_t number = 0;
            const auto render_level = [&](Scene scene) {
                if (level < last) scene.conventions.limit = LimitRule::drop;
                scene.settings.reflections = std::max(level, 1);
                if (level == 0) for_each_material(scene, [](Material& m) { m.mirror_tint = {0, 0, 0}; });
                std::optional<Image> made = render(scene);
                if (!made) return made;
                if (level == 0) {
                    so_far.push_back(*made);
                    return made;
                }
                Image& before = so_far[number++];
                const Image all = *made;
                for (std::size_t i = 0; i < all.rgb.size(); ++i) made->rgb[i] -= before.rgb[i];
                before = all;
                return made;
            };
            const std::optional<Image> part = compose(s, render_level);
            if (!part) return std::nullopt;
            if (!sum) {
                sum = part;
                continue;
            }
            for (std::size_t i = 0; i < part->rgb.size(); ++i) sum->rgb[i] += part->rgb[i];
        }
        return sum;
    };
}

// What a ray adds is at most its weight, which is what white surfaces add that need no light.
void add_clamped_parts(const Scene& scene, std::vector<SceneCause>& causes) {
    if (!has_mirrors(scene) || !is_lit(scene) || scene.settings.reflections > k_max_composed_levels ||
        !scene.textures.empty())
        return;
    SceneCause cause{
        "local-color-clamped",
        "The color of each surface is limited to 1 before mirrors mix it: limit only the color of "
        "the pixel.",
        {}};
    cause.compose = by_levels([](const Scene& s, const RenderScene& render) -> std::optional<Image> {
        Scene white = s;
        std::for_each(white.lights.begin(), white.lights.end(), switch_off);
        white.background = {1, 1, 1};
        white.gradient.reset();
        for_each_material(white, [](Material& m) { m.emission = {1, 1, 1}; });
        std::optional<Image> part = render(s);
        const std::optional<Image> weight = render(white);
        if (!part || !weight) return std::nullopt;
        for (std::size_t i = 0; i < part->rgb.size(); ++i)
            part->rgb[i] = std::min(part->rgb[i], weight->rgb[i]);
        return part;
    });
    causes.push_back(std::move(cause));
}

void add_tone_curves(std::vector<SceneCause>& causes) {
    // curve(channel, the largest channel of the pixel)
    const auto add = [&](const char* explanation, double (*curve)(double, double)) {
        SceneCause cause{"tone-curve", explanation, {}};
        cause.compose = [curve](const Scene& s, const RenderScene& render) -> std::optional<Image> {
            std::optional<Image> made = render(s);
            if (!made) return std::nullopt;
            for (std::size_t i = 0; i < made->rgb.size(); i += 3) {
                const auto most =
                    static_cast<double>(std::max({made->rgb[i], made->rgb[i + 1], made->rgb[i + 2]}));
                for (std::size_t c = i; c < i + 3; ++c)
                    made->rgb[c] = static_cast<float>(curve(static_cast<double>(made->rgb[c]), most));
            }
            return made;
        };
        causes.push_back(std::move(cause));
    };
    add("Colors go through a tone curve, c / (1 + c): the scene has none.",
        [](double c, double) { return c / (1 + c); });
    add("Colors go through a tone curve, 1 - exp(-c): the scene has none.",
        [](double c, double) { return 1 - exp(-c); });
    add("Colors above 1 are divided by their largest channel, which keeps their hue: clamp each channel.",
        [](double c, double most) { return c / std::max(most, 1.0); });
}

}  // namespace glint
