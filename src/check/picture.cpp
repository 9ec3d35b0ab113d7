// SPDX-License-Identifier: Apache-2.0
// Findings from a small picture: black, one color, changed by another epsilon or one more reflection.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "check/checks.h"
#include "math/number.h"
#include "math/transform.h"

namespace glint {
namespace {

constexpr std::int32_t k_small_picture = 160;
constexpr double k_visible = 8.0 / 255;  // differences in a channel that count
constexpr double k_usual_brightest = 0.8;
// Shares of the picture. In the gallery's scenes the sources' epsilons change up to 0.0006, and another
// reflection changes up to 0.005.
constexpr double k_max_acne = 0.005, k_max_changed = 0.0075;
constexpr std::int32_t k_max_more = 64;  // reflections that are tried
// Surfaces that a ray passes before it shows what is behind glass, and behind glass that is hollow.
constexpr std::int32_t k_walls = 2, k_hollow_walls = 4;

double clamped(float x) { return x < 0 ? 0.0 : x > 1 ? 1.0 : static_cast<double>(x); }

// The share of pixels in which two pictures differ by more than `least` in a channel, as they are shown.
double share_that_differs(const Image& a, const Image& b, double least) {
    return share_of_pixels(a, [&](std::size_t i) {
        for (std::size_t c = i; c < i + 3; ++c)
            if (number::abs(clamped(a.rgb[c]) - clamped(b.rgb[c])) > least) return true;
        return false;
    });
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
                           "spot-aimed-elsewhere", "spot-angle-in-radians", "spot-too-tight"})
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
            fmt::format("epsilon = {:.3g} is too small for this scene: {} of the picture is in shadow "
                        "acne, where rays intersect the surface that they leave",
                        epsilon, percent_text(differs)),
            remedy);
    } else {
        context.report(
            "epsilon-too-large", place,
            fmt::format(
                "epsilon = {:.3g} is too large for this scene: {} of the picture differs from that with "
                "epsilon = {:.2g}, because rays start beyond nearby objects",
                epsilon, percent_text(differs), trusted),
            remedy + "; or make the scene larger");
    }
}

bool sees_glass(const WorldParts& world, const VisibleHits& visible) {
    return std::any_of(visible.seen().begin(), visible.seen().end(), [&](const SurfaceHit& h) {
        return world.material(h.material)[k_transmission] > 0 || world.is_transparent(h.material);
    });
}

void check_reflections(CheckContext& context, const VisibleHits& visible, const Image& picture) {
    const Scene& scene = context.scene();
    const std::int32_t now = scene.settings.reflections;
    const auto render_with = [&](std::int32_t reflections) {
        RenderSettings settings = scene.settings;
        settings.reflections = reflections;
        return context.render_small(with_rules(context.prepared(), scene.conventions, settings),
                                    k_small_picture);
    };
    if (now >= k_max_reflections) return;
    std::int32_t first = 1;  // the fewest further ones that are found to change something
    double changed = share_that_differs(picture, render_with(now + first), k_visible);
    // Glass may show nothing until rays have left it.
    if (now < k_walls && changed < k_max_changed && sees_glass(context.world(), visible)) {
        while (changed < k_max_changed && first < k_hollow_walls) {
            first *= 2;
            changed = share_that_differs(picture, render_with(now + first), k_visible);
        }
    }
    if (changed < k_max_changed) return;
    std::int32_t enough = now + first;
    for (std::int32_t more = first; more <= k_max_more && now + 2 * more < k_max_reflections; more *= 2) {
        enough = now + more;
        if (share_that_differs(render_with(enough), render_with(enough + 1), k_visible) < k_max_changed)
            break;
    }
    const bool one = first == 1;
    context.report(
        "reflections-too-few", context.at_setting("reflections"),
        fmt::format("{} more than {} {} {} of the picture by more than 8 of 255: {}",
                    one ? "one reflection" : fmt::format("{} reflections", first), now,
                    one ? "changes" : "change", percent_text(changed),
                    now == 0 ? "mirrors and glass are switched off"
                    : one    ? "mirrors or glass are seen in each other past the limit"
                             : "rays enter glass, but do not leave it"),
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
    check_reflections(context, visible, picture);
}

}  // namespace glint
