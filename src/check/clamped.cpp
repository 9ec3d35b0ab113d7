// SPDX-License-Identifier: Apache-2.0
// Much of the picture, or a whole shape, that is brighter than 1.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "check/checks.h"
#include "math/number.h"

namespace glint {
namespace {

constexpr double k_over = 1 + k_half_byte;
// Shares of the picture: up to 0.1 is clamped in the gallery's scenes; smaller shapes than the second are not
// examined one by one.
constexpr double k_max_clamped = 0.125, k_min_shape = 0.002;
// Without any other light, half of white.
constexpr double k_much_ambient_light = 0.5;

bool is_over(const Image& image, std::size_t i) {
    return image.rgb[i] > k_over || image.rgb[i + 1] > k_over || image.rgb[i + 2] > k_over;
}

// A color of the second table; black if there is none.
template <auto Member> Color extended_color(const WorldParts& world, std::uint32_t material) {
    if (!world.uses<Member>()) return {0, 0, 0};
    const double* k = world.extended_row(material) + k_extended_value<Member>;
    return {k[0], k[1], k[2]};
}

// The maximum of a shape's material: k_a I_a + k_e + the sum over the lights of k_d I_d + (k_s + k_p) I_s;
// and k_a I_a alone.
struct Bound {
    double all = 0, ambient = 0;
    bool is_much_ambient() const { return ambient >= k_much_ambient_light; }
    /// Follows "can come to ".
    std::string text() const {
        return fmt::format("{:.3g}", all) +
               (is_much_ambient() ? fmt::format(", of which k_a I_a alone is {:.2g}", ambient) : "");
    }
    std::string remedy() const {
        if (!is_much_ambient())
            return "lower the lights' intensities or the material's coefficients until their sum is about 1";
        return std::string(
                   "lower k_a, or the ambient light: their product is usually 0.05 to 0.3 of the "
                   "material's color") +
               (all - ambient > k_over ? "; and lower the other lights' intensities" : "");
    }
};
Bound bound_of(const WorldParts& world, SurfaceId id) {
    const std::uint32_t material = material_row(world, id);
    const auto m = surface_values(world, id);
    const Color ambient{m[k_ambient], m[k_ambient + 1], m[k_ambient + 2]};
    const Color diffuse{m[k_diffuse], m[k_diffuse + 1], m[k_diffuse + 2]};
    const Color specular = Color{m[k_specular], m[k_specular + 1], m[k_specular + 2]} +
                           extended_color<&Material::phong>(world, material);
    const Color own = ambient * world.ambient;
    Color sum = own + extended_color<&Material::emission>(world, material);
    for (const Light& light : *world.lights)
        sum = sum + (diffuse * light.color + specular * light.specular_color) * world.direct;
    if (world.occlusion) sum = sum + diffuse * world.occlusion->color;
    return {brightest(sum), brightest(own)};
}

void take_larger(Bound& to, const Bound& bound) {
    if (bound.all > to.all) to = bound;
}

// True if a shape glows on purpose: its ambient term and its emission alone are above 1.
bool glows(const WorldParts& world, SurfaceId id) {
    const std::uint32_t material = material_row(world, id);
    const auto m = surface_values(world, id);
    const Color glow = Color{m[k_ambient], m[k_ambient + 1], m[k_ambient + 2]} * world.ambient +
                       extended_color<&Material::emission>(world, material);
    return brightest(glow) > k_over;
}

// Whether a finding about the material's own numbers says why it is clamped.
bool is_explained(const CheckContext& context, std::uint32_t material) {
    return context.is_reported("material-color-255", SceneItem::material, material) ||
           context.is_reported("shininess-zero", SceneItem::material, material) ||
           context.is_reported("shininess-too-small", SceneItem::material, material);
}

// Shapes that are clamped on most of their pixels; one finding for those of one material. over_at: by the
// number of a camera ray.
template <class Test>
void check_clamped_shapes(CheckContext& context, const VisibleHits& visible, Test over_at) {
    struct Count {
        std::size_t all = 0, over = 0;
        std::uint32_t material = 0;
        SurfaceId surface;
    };
    std::map<std::uint32_t, Count> counts;
    for (const SurfaceHit& h : visible.seen()) {
        Count& count = counts[h.shape];
        count.material = h.material;
        count.surface = h.surface;
        ++count.all;
        count.over += over_at(h.ray) ? 1 : 0;
    }
    struct Clamped {
        std::vector<std::uint32_t> shapes;
        std::size_t all = 0, over = 0;
        Bound bound;
    };
    std::map<std::uint32_t, Clamped> materials;
    for (const auto& [shape, count] : counts) {
        if (static_cast<double>(count.all) < k_min_shape * static_cast<double>(visible.rays())) continue;
        if (2 * count.over <= count.all || glows(context.world(), count.surface) ||
            is_explained(context, count.material))
            continue;
        Clamped& clamped = materials[count.material];
        clamped.shapes.push_back(shape);
        clamped.all += count.all;
        clamped.over += count.over;
        take_larger(clamped.bound, bound_of(context.world(), count.surface));
    }
    for (const auto& [material, clamped] : materials) {
        // What is reflected makes it bright, not the lights.
        if (clamped.bound.all <= k_over) continue;
        const bool single = clamped.shapes.size() == 1;
        context.report(
            "picture-clamped", context.at_shape(clamped.shapes.front()),
            fmt::format("{} {} brighter than 1 and {} clamped on {} of what is visible of {}: the k_a I_a + "
                        "the sum over the lights of k_d I_d + k_s I_s of {} can come to {}",
                        single ? context.shape(clamped.shapes.front()) : context.some_shapes(clamped.shapes),
                        single ? "is" : "are", single ? "is" : "are",
                        percent_text(static_cast<double>(clamped.over) / static_cast<double>(clamped.all)),
                        single ? "it" : "them", context.material(material), clamped.bound.text()),
            clamped.bound.remedy());
    }
}

}  // namespace

void check_clamped(CheckContext& context, const VisibleHits& visible, const Image& picture) {
    const double over = share_of_pixels(picture, [&](std::size_t i) { return is_over(picture, i); });
    if (over == 0 || context.is_reported("light-color-255") || context.is_reported("light-written-twice"))
        return;
    const Scene& scene = context.scene();
    const auto columns = static_cast<std::size_t>(visible.size.width),
               rows = static_cast<std::size_t>(visible.size.height);
    const auto width = static_cast<std::size_t>(picture.width),
               height = static_cast<std::size_t>(picture.height);
    const auto over_at = [&](std::size_t ray) {
        return is_over(picture,
                       3 * (ray / columns * height / rows * width + ray % columns * width / columns));
    };
    if (over < k_max_clamped) return check_clamped_shapes(context, visible, over_at);
    std::vector<std::size_t> pixels(scene.materials.size() + 1);
    std::size_t background = 0;
    for (std::size_t ray = 0; ray < visible.rays(); ++ray) background += over_at(ray) ? 1 : 0;
    for (const SurfaceHit& h : visible.seen()) {
        if (!over_at(h.ray)) continue;
        ++pixels[h.material];
        --background;
    }
    const auto most =
        static_cast<std::uint32_t>(std::max_element(pixels.begin(), pixels.end()) - pixels.begin());
    const std::string what =
        fmt::format("{} of the picture is brighter than 1 and is clamped", percent_text(over));
    if (background > pixels[most]) {
        context.report("picture-clamped", context.at_background(), what + ", most of it background",
                       "darken the background");
        return;
    }
    // The bound is that of unit vectors.
    if (is_explained(context, most) || context.is_reported("direction-not-unit")) return;
    Bound bound;
    SurfaceId last;
    for (const SurfaceHit& h : visible.seen()) {
        if (h.material != most || h.surface == last || !over_at(h.ray)) continue;
        last = h.surface;
        take_larger(bound, bound_of(context.world(), h.surface));
    }
    if (bound.all <= k_over) {
        context.report(
            "picture-clamped", context.at_material(most),
            fmt::format(
                "{}, {} most of all: its own light comes to {:.3g} at most, and what it reflects or lets "
                "through is added",
                what, context.material(most), bound.all),
            "lower the material's mirror, or what the mirror shows");
        return;
    }
    context.report(
        "picture-clamped", context.at_material(most),
        fmt::format("{}, {} most of all: its k_a I_a + the sum over the lights of k_d I_d + k_s I_s can come "
                    "to {}",
                    what, context.material(most), bound.text()),
        bound.remedy());
}

}  // namespace glint
