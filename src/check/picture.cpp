// SPDX-License-Identifier: Apache-2.0
// Findings from a small picture: black, one color, clamped, changed by another epsilon or one more
// reflection.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "check/checks.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint {
namespace {

constexpr std::int32_t k_small_picture = 160;
constexpr double k_over = 1 + k_half_byte;
constexpr double k_visible = 8.0 / 255;  // differences in a channel that count
constexpr double k_usual_brightest = 0.8;
// Shares of the picture. In the gallery's scenes up to 0.1 is clamped, the sources' epsilons change up to
// 0.0006, and another reflection changes up to 0.005.
constexpr double k_max_clamped = 0.125, k_max_acne = 0.005, k_max_changed = 0.0075;
constexpr double k_min_shape = 0.002;    // of the picture: smaller shapes are not examined one by one
constexpr std::int32_t k_max_more = 64;  // reflections that are tried

// The share of pixels for which test(index of the first channel) is true.
template <class Test> double share(const Image& image, Test test) {
    if (image.rgb.empty()) return 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) count += test(i) ? 1 : 0;
    return 3 * static_cast<double>(count) / static_cast<double>(image.rgb.size());
}

double clamped(float x) { return x < 0 ? 0.0 : x > 1 ? 1.0 : static_cast<double>(x); }

// The share of pixels in which two pictures differ by more than `least` in a channel, as they are shown.
double share_that_differs(const Image& a, const Image& b, double least) {
    return share(a, [&](std::size_t i) {
        for (std::size_t c = i; c < i + 3; ++c)
            if (number::abs(clamped(a.rgb[c]) - clamped(b.rgb[c])) > least) return true;
        return false;
    });
}

bool is_over(const Image& image, std::size_t i) {
    return image.rgb[i] > k_over || image.rgb[i + 1] > k_over || image.rgb[i + 2] > k_over;
}

// "300" of 267.
std::string one_digit(double v) {
    std::size_t zeros = 0;
    for (; v >= 9.5; v /= 10) ++zeros;
    return fmt::format("{:.0f}", v) + std::string(zeros, '0');
}

// A picture that is not black, but looks so. Whether it is.
bool check_dark(CheckContext& context, const Image& picture) {
    const double most = clamped(*std::max_element(picture.rgb.begin(), picture.rgb.end()));
    if (most > k_visible) return false;
    // The lights that light nothing are the reason.
    for (const char* id : {"light-inside-shape", "light-behind-everything", "light-behind-plane",
                           "light-blocked", "light-on-surface", "light-too-weak", "light-attenuated-away",
                           "spot-aimed-elsewhere", "spot-angle-in-radians"})
        if (context.is_reported(id)) return true;
    context.report(
        "picture-dark", {}, fmt::format("nothing in the picture is brighter than {:.2g} of 255", 255 * most),
        fmt::format("raise the intensities of the lights about {} times, or the coefficients of the "
                    "materials",
                    one_digit(k_usual_brightest / most)));
    return true;
}

// True if the picture is black, or has one color: then no other finding about it is useful.
bool check_one_color(CheckContext& context, const Image& picture) {
    float least[3] = {picture.rgb[0], picture.rgb[1], picture.rgb[2]},
          most[3] = {least[0], least[1], least[2]};
    for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
        least[i % 3] = std::min(least[i % 3], picture.rgb[i]);
        most[i % 3] = std::max(most[i % 3], picture.rgb[i]);
    }
    for (int c = 0; c < 3; ++c)
        if (clamped(most[c]) - clamped(least[c]) > k_half_byte) return false;
    if (clamped(most[0]) < k_half_byte && clamped(most[1]) < k_half_byte && clamped(most[2]) < k_half_byte) {
        context.report("picture-black", {}, "the whole picture is black, although shapes are in it",
                       "check that a light reaches them, and that their colors and coefficients are above 0");
    } else {
        context.report(
            "picture-one-color", {},
            fmt::format("the whole picture has one color, ({:.3g}, {:.3g}, {:.3g}), although shapes are in "
                        "it",
                        most[0], most[1], most[2]),
            "check that the shapes differ from the background, and that the light is not so strong that all "
            "of the picture is white");
    }
    return true;
}

// A color of the second table; black if there is none.
template <auto Member> Color extended_color(const WorldParts& world, std::uint32_t material) {
    if (!world.uses<Member>()) return {0, 0, 0};
    const double* k = world.extended_row(material) + k_extended_value<Member>;
    return {k[0], k[1], k[2]};
}

// The maximum of a shape's material: k_a I_a + k_e + the sum over the lights of k_d I_d + (k_s + k_p) I_s.
double bound_of(const WorldParts& world, SurfaceId id) {
    const std::uint32_t material = material_row(world, id);
    const auto m = surface_values(world, id);
    const Color ambient{m[k_ambient], m[k_ambient + 1], m[k_ambient + 2]};
    const Color diffuse{m[k_diffuse], m[k_diffuse + 1], m[k_diffuse + 2]};
    const Color specular = Color{m[k_specular], m[k_specular + 1], m[k_specular + 2]} +
                           extended_color<&Material::phong>(world, material);
    Color sum = ambient * world.ambient + extended_color<&Material::emission>(world, material);
    for (const Light& light : *world.lights)
        sum = sum + (diffuse * light.color + specular * light.specular_color) * world.direct;
    if (world.occlusion) sum = sum + diffuse * world.occlusion->color;
    return number::max(sum.r, number::max(sum.g, sum.b));
}

// True if a shape glows on purpose: its ambient term and its emission alone are above 1.
bool glows(const WorldParts& world, SurfaceId id) {
    const std::uint32_t material = material_row(world, id);
    const auto m = surface_values(world, id);
    const Color glow = Color{m[k_ambient], m[k_ambient + 1], m[k_ambient + 2]} * world.ambient +
                       extended_color<&Material::emission>(world, material);
    return number::max(glow.r, number::max(glow.g, glow.b)) > k_over;
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
        double bound = 0;
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
        clamped.bound = number::max(clamped.bound, bound_of(context.world(), count.surface));
    }
    for (const auto& [material, clamped] : materials) {
        // What is reflected makes it bright, not the lights.
        if (clamped.bound <= k_over) continue;
        const bool single = clamped.shapes.size() == 1;
        context.report(
            "picture-clamped", context.at_shape(clamped.shapes.front()),
            fmt::format(
                "{} {} brighter than 1 and {} clamped on {:.2g}% of what is visible of {}: the k_a I_a + "
                "the sum over the lights of k_d I_d + k_s I_s of {} can come to {:.3g}",
                single ? context.shape(clamped.shapes.front()) : context.some_shapes(clamped.shapes),
                single ? "is" : "are", single ? "is" : "are",
                100 * static_cast<double>(clamped.over) / static_cast<double>(clamped.all),
                single ? "it" : "them", context.material(material), clamped.bound),
            "lower the lights' intensities or the material's coefficients until their sum is about 1");
    }
}

void check_clamped(CheckContext& context, const VisibleHits& visible, const Image& picture) {
    const double over = share(picture, [&](std::size_t i) { return is_over(picture, i); });
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
        fmt::format("{:.2g}% of the picture is brighter than 1 and is clamped", 100 * over);
    if (background > pixels[most]) {
        context.report("picture-clamped", context.at_background(), what + ", most of it background",
                       "darken the background");
        return;
    }
    // The bound is that of unit vectors.
    if (is_explained(context, most) || context.is_reported("direction-not-unit")) return;
    double bound = 0;
    SurfaceId last;
    for (const SurfaceHit& h : visible.seen()) {
        if (h.material != most || h.surface == last || !over_at(h.ray)) continue;
        last = h.surface;
        bound = number::max(bound, bound_of(context.world(), h.surface));
    }
    if (bound <= k_over) {
        context.report(
            "picture-clamped", context.at_material(most),
            fmt::format(
                "{}, {} most of all: its own light comes to {:.3g} at most, and what it reflects or lets "
                "through is added",
                what, context.material(most), bound),
            "lower the material's mirror, or what the mirror shows");
        return;
    }
    context.report(
        "picture-clamped", context.at_material(most),
        fmt::format("{}, {} most of all: its k_a I_a + the sum over the lights of k_d I_d + k_s I_s can come "
                    "to {:.3g}",
                    what, context.material(most), bound),
        "lower the lights' intensities or the material's coefficients until their sum is about 1");
}

// An epsilon that is far below the scene's size and far above rounding errors, in the offset's unit.
double trusted_epsilon(const CheckContext& context, const VisibleHits& visible) {
    const Conventions& rules = context.scene().conventions;
    if (rules.offset == Offset::scale) return 1e-9;
    double magnitude = length(context.world().camera.position);
    std::vector<double> lengths;
    for (const SurfaceHit& h : visible.seen()) lengths.push_back(length(h.point));
    if (!lengths.empty()) {
        // Of nine tenths of the hits: a plane ends at a horizon as far away as rounding puts it.
        const auto far = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() * 9 / 10);
        std::nth_element(lengths.begin(), far, lengths.end());
        magnitude = number::max(magnitude, *far);
    }
    // t of a shadow ray counts in distances of the light.
    return rules.offset == Offset::ray ? number::min(1e-8 * magnitude, 1e-4) : 1e-8 * magnitude;
}

void check_epsilon(CheckContext& context, const VisibleHits& visible, const Image& picture) {
    const Scene& scene = context.scene();
    const double epsilon = scene.conventions.epsilon, trusted = trusted_epsilon(context, visible);
    if (epsilon == trusted) return;
    const auto render_with = [&](double by) {
        Conventions conventions = scene.conventions;
        conventions.epsilon = by;
        return context.render_small(with_rules(context.prepared(), conventions, scene.settings),
                                    k_small_picture);
    };
    const Image other = render_with(trusted);
    const double differs = share_that_differs(picture, other, k_visible);
    if (differs < k_max_acne) return;
    // Where mirrors amplify any small change, no epsilon is better than another.
    if (epsilon > trusted && share_that_differs(other, render_with(trusted / 8), k_visible) >= k_max_acne)
        return;
    const FindingPlace place = context.at_setting("epsilon");
    const std::string remedy =
        scene.conventions.offset == Offset::scale
            ? fmt::format("set epsilon to {:.2g}", trusted)
            : fmt::format("set epsilon to about {:.2g}, or offset = scale and epsilon = 1e-9", trusted);
    if (epsilon < trusted) {
        context.report(
            "epsilon-too-small", place,
            fmt::format("epsilon = {:.3g} is too small for this scene: {:.2g}% of the picture is in shadow "
                        "acne, where rays intersect the surface that they leave",
                        epsilon, 100 * differs),
            remedy);
    } else {
        context.report(
            "epsilon-too-large", place,
            fmt::format(
                "epsilon = {:.3g} is too large for this scene: {:.2g}% of the picture differs from that with "
                "epsilon = {:.2g}, because rays start beyond nearby objects",
                epsilon, 100 * differs, trusted),
            remedy + "; or make the scene larger");
    }
}

void check_reflections(CheckContext& context, const Image& picture) {
    const Scene& scene = context.scene();
    const std::int32_t now = scene.settings.reflections;
    const auto render_with = [&](std::int32_t reflections) {
        RenderSettings settings = scene.settings;
        settings.reflections = reflections;
        return context.render_small(with_rules(context.prepared(), scene.conventions, settings),
                                    k_small_picture);
    };
    if (now >= k_max_reflections) return;
    const double changed = share_that_differs(picture, render_with(now + 1), k_visible);
    if (changed < k_max_changed) return;
    std::int32_t enough = now + 1;
    for (std::int32_t more = 1; more <= k_max_more && now + 2 * more < k_max_reflections; more *= 2) {
        enough = now + more;
        if (share_that_differs(render_with(enough), render_with(enough + 1), k_visible) < k_max_changed)
            break;
    }
    context.report(
        "reflections-too-few", context.at_setting("reflections"),
        fmt::format("one reflection more than {} changes {:.2g}% of the picture by more than 8 of 255: {}",
                    now, 100 * changed,
                    now == 0 ? "mirrors and glass are switched off"
                             : "mirrors or glass are seen in each other past the limit"),
        fmt::format("set reflections to {}, or let the mirrors reflect, or the glass transmit, less",
                    enough));
}

}  // namespace

void check_picture(CheckContext& context, const VisibleHits& visible) {
    const Image picture = context.render_small(k_small_picture);
    if (picture.rgb.empty()) return;
    if (check_one_color(context, picture)) {
        if (!context.is_reported("picture-black")) check_ambient_light(context, visible);
        return;
    }
    if (check_dark(context, picture)) return;
    check_clamped(context, visible, picture);
    if (!context.is_reported("picture-clamped")) check_ambient_light(context, visible);
    check_background_shapes(context);
    check_occlusion(context);
    check_epsilon(context, visible, picture);
    check_reflections(context, picture);
}

}  // namespace glint
