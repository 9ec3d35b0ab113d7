// SPDX-License-Identifier: Apache-2.0
// The fields of Conventions and RenderSettings as text: one row per key.
#include "glint/conventions.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/status.h"
#include "base/text.h"
#include "glint/scene.h"
#include "scene/ranges.h"

namespace glint {
namespace {

constexpr std::string_view k_pixel_samples[] = {"center", "corner", "whole", "top_right"};
constexpr std::string_view k_ray_directions[] = {"unit", "viewport"};
constexpr std::string_view k_offsets[] = {"ray", "normal", "facing", "direction", "scale"};
constexpr std::string_view k_mirrors[] = {"blend", "add"};
constexpr std::string_view k_limits[] = {"keep", "drop", "background"};
constexpr std::string_view k_misses[] = {"background", "black"};
constexpr std::string_view k_fresnels[] = {"none", "schlick"};
constexpr std::string_view k_glass_shadows[] = {"opaque", "none"};
constexpr std::string_view k_transparencies[] = {"highlights", "blend", "add"};
constexpr std::string_view k_opacities[] = {"whole", "brightest"};
constexpr std::string_view k_transparent_shadows[] = {"opaque", "none", "colored"};
constexpr std::string_view k_facings[] = {"none", "open", "all", "winding"};
constexpr std::string_view k_spot_falloffs[] = {"cubic", "linear"};
constexpr std::string_view k_fog_distances[] = {"ray", "depth"};
constexpr std::string_view k_fog_extents[] = {"everywhere", "outside_objects"};
constexpr std::string_view k_area_shadings[] = {"samples", "center"};
constexpr std::string_view k_transfers[] = {"none", "srgb"};
constexpr std::string_view k_roundings[] = {"half_even", "half_up", "down"};
constexpr std::string_view k_shadings[] = {"phong", "blinn-phong", "diffuse", "color", "normals"};

std::string found(std::string_view expected, std::string_view text) {
    return fmt::format("expected {}, found {}", expected, quoted(text));
}

bool parse_number(std::string_view text, double& value) {
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    const auto [end, error] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size();
}

bool parse_whole(std::string_view text, std::int32_t& value) {
    if (text.empty() || text.size() > 9) return false;
    std::int32_t n = 0;
    for (const char c : text) {
        if (c < '0' || c > '9') return false;
        n = n * 10 + (c - '0');
    }
    value = n;
    return true;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

// A parser returns an error message or an empty string; a printer returns text that the parser accepts.
using Parse = std::string (*)(Conventions&, RenderSettings&, const SettingKey&, std::string_view);
using Print = std::string (*)(const Conventions&, const RenderSettings&);

struct Row {
    SettingKey key;
    Parse parse;
    Print print;
};

// The field, in Conventions or RenderSettings.
template <auto Member, class C, class S> auto& field(C& conventions, S& settings) {
    if constexpr (requires { conventions.*Member; }) {
        return conventions.*Member;
    } else {
        return settings.*Member;
    }
}

// "center | corner | whole"
template <const auto& Words> struct JoinedWords {
    static constexpr std::string_view separator = " | ";
    static constexpr auto letters = [] {
        constexpr std::size_t size = [] {
            std::size_t sum = (std::size(Words) - 1) * separator.size();
            for (const std::string_view word : Words) sum += word.size();
            return sum;
        }();
        std::array<char, size> all{};
        char* to = all.data();
        for (const std::string_view& word : Words) {
            if (&word != std::data(Words)) to = std::copy(separator.begin(), separator.end(), to);
            to = std::copy(word.begin(), word.end(), to);
        }
        return all;
    }();
    static constexpr std::string_view text{letters.data(), letters.size()};
};

template <auto Member, const auto& Words>
constexpr Row word_row(std::string_view name, std::string_view description, bool convention) {
    return {
        {name, JoinedWords<Words>::text, description, convention},
        [](Conventions& c, RenderSettings& s, const SettingKey& key, std::string_view text) -> std::string {
            auto& value = field<Member>(c, s);
            const auto* at = std::find(std::begin(Words), std::end(Words), text);
            if (at == std::end(Words)) return found(key.values, text) + did_you_mean(text, Words);
            value = static_cast<std::remove_reference_t<decltype(value)>>(at - std::begin(Words));
            return {};
        },
        [](const Conventions& c, const RenderSettings& s) {
            const auto i = static_cast<std::size_t>(field<Member>(c, s));
            return std::string(i < std::size(Words) ? Words[i] : "?");  // code can put any number there
        }};
}

constexpr std::string_view k_truth_words[] = {"true", "false"};

template <auto Member>
constexpr Row bool_row(std::string_view name, std::string_view description, bool convention) {
    return {{name, "true | false", description, convention},
            [](Conventions& c, RenderSettings& s, const SettingKey&, std::string_view text) -> std::string {
                if (text != "true" && text != "false")
                    return found("true or false", text) + did_you_mean(text, k_truth_words);
                field<Member>(c, s) = text == "true";
                return {};
            },
            [](const Conventions& c, const RenderSettings& s) {
                return std::string(field<Member>(c, s) ? "true" : "false");
            }};
}

template <auto Member, const Range& Allowed>
constexpr Row number_row(std::string_view name, std::string_view description) {
    return {{name, Allowed.text, description, true},
            [](Conventions& c, RenderSettings&, const SettingKey& key, std::string_view text) -> std::string {
                double value = 0;
                if (!parse_number(text, value) || !Allowed.contains(value)) return found(key.values, text);
                c.*Member = value;
                return {};
            },
            [](const Conventions& c, const RenderSettings&) { return fmt::format("{}", c.*Member); }};
}

template <auto Member, std::int32_t Min, std::int32_t Max>
constexpr Row whole_row(std::string_view name, std::string_view values, std::string_view description,
                        bool convention) {
    return {
        {name, values, description, convention},
        [](Conventions& c, RenderSettings& s, const SettingKey& key, std::string_view text) -> std::string {
            std::int32_t value = 0;
            if (!parse_whole(text, value) || value < Min || value > Max) return found(key.values, text);
            field<Member>(c, s) = value;
            return {};
        },
        [](const Conventions& c, const RenderSettings& s) { return fmt::format("{}", field<Member>(c, s)); }};
}

std::string parse_size(Conventions&, RenderSettings& s, const SettingKey& key, std::string_view text) {
    const std::size_t x = text.find('x');
    std::int32_t width = 0, height = 0;
    const bool ok = x != std::string_view::npos && parse_whole(trimmed(text.substr(0, x)), width) &&
                    parse_whole(trimmed(text.substr(x + 1)), height);
    if (!ok || width < 1 || height < 1 || width > k_max_size || height > k_max_size)
        return found(key.values, text);
    s.width = width;
    s.height = height;
    return {};
}

std::string print_size(const Conventions&, const RenderSettings& s) {
    return fmt::format("{}x{}", s.width, s.height);
}

// "N", "adaptive:N" or "adaptive:N:T"; each may end in ":jitter".
std::string parse_aa(Conventions&, RenderSettings& s, const SettingKey& key, std::string_view text) {
    constexpr std::string_view adaptive = "adaptive:", jitter = ":jitter";
    std::string_view number = text;
    const bool has_jitter = number.ends_with(jitter);
    if (has_jitter) number.remove_suffix(jitter.size());
    std::optional<double> threshold;
    if (number.starts_with(adaptive)) {
        number.remove_prefix(adaptive.size());
        const std::size_t colon = number.find(':');
        double value = k_default_aa_threshold;
        if (colon != std::string_view::npos &&
            (!parse_number(number.substr(colon + 1), value) || !k_threshold.contains(value)))
            return found(key.values, text);
        threshold = value;
        number = number.substr(0, colon);
    }
    std::int32_t samples = 0;
    if (!parse_whole(number, samples) || samples < 1 || samples > k_max_samples)
        return found(key.values, text);
    s.samples = samples;
    s.aa_threshold = threshold;
    s.jitter = has_jitter;
    return {};
}

std::string print_aa(const Conventions&, const RenderSettings& s) {
    return (s.aa_threshold ? fmt::format("adaptive:{}:{}", s.samples, *s.aa_threshold)
                           : fmt::format("{}", s.samples)) +
           (s.jitter ? ":jitter" : "");
}

std::string parse_seed(Conventions&, RenderSettings& s, const SettingKey& key, std::string_view text) {
    std::uint64_t value = 0;
    if (text.empty() || text.size() > 10) return found(key.values, text);
    for (const char c : text) {
        if (c < '0' || c > '9') return found(key.values, text);
        value = value * 10 + static_cast<std::uint64_t>(c - '0');
    }
    if (value > 0xffffffffu) return found(key.values, text);
    s.seed = static_cast<std::uint32_t>(value);
    return {};
}

std::string print_seed(const Conventions&, const RenderSettings& s) { return fmt::format("{}", s.seed); }

using C = Conventions;
using S = RenderSettings;

constexpr Row k_rows[] = {
    word_row<&C::pixel_sample, k_pixel_samples>("pixel_sample",
                                                "where in its pixel a camera ray passes; whole: at integer "
                                                "coordinates, counted from the picture's centre",
                                                true),
    word_row<&C::ray_direction, k_ray_directions>(
        "ray_direction", "the length of a camera ray's direction, which scales its t", true),
    number_row<&C::camera_t_min, k_not_negative>("camera_t_min",
                                                 "camera rays have hits only at t above this"),
    bool_row<&C::specular_gate>("specular_gate", "the highlight needs N.L > 0", true),
    bool_row<&C::clamp_cosines>(
        "clamp_cosines", "negative cosines add nothing; false: a classic fault, and LIGHT's own code", true),
    bool_row<&C::normalize>("normalize", "L, V, R and H are normalised; false: a classic fault", true),
    word_row<&C::offset, k_offsets>(
        "offset",
        "what epsilon means for a ray that starts on a surface: its least t, or how its origin is moved",
        true),
    number_row<&C::epsilon, k_not_negative>("epsilon", "the size of the offset; 0: a classic fault"),
    bool_row<&C::shadow_stops_at_light>(
        "shadow_stops_at_light",
        "only occluders between the point and the light cast shadows; false: a classic fault", true),
    word_row<&C::mirror, k_mirrors>("mirror", "blend: (1-a) local + a reflected; add: local + a reflected",
                                    true),
    word_row<&C::limit, k_limits>(
        "limit",
        "the last permitted surface shows its local color completely, or as if its mirror saw black, or "
        "with the background added for each ray",
        true),
    word_row<&C::mirror_miss, k_misses>("mirror_miss",
                                        "what a mirror or glass ray that leaves the scene sees", true),
    word_row<&C::fresnel, k_fresnels>(
        "fresnel",
        "how much of the light that glass would transmit is reflected; schlick: depends on the angle", true),
    number_row<&C::beer, k_not_negative>(
        "beer",
        "0: glass tints once, where a ray enters; else by Beer's law, exp(-beer (1 - tint) distance)"),
    word_row<&C::glass_shadow, k_glass_shadows>("glass_shadow", "whether glass casts shadows", true),
    word_row<&C::transparency, k_transparencies>(
        "transparency",
        "how filter and transmit reduce a surface's own light; highlights: all but its highlights, blend: "
        "all, add: nothing",
        true),
    word_row<&C::opacity, k_opacities>(
        "opacity",
        "whole: 1 - filter - transmit; brightest: 1 - transmit - filter times the color's greatest channel",
        true),
    word_row<&C::transparent_shadow, k_transparent_shadows>(
        "transparent_shadow",
        "the shadows of surfaces with filter or transmit; colored: each surface on the way colors the light",
        true),
    bool_row<&C::transparency_counts>(
        "transparency_counts",
        "a ray straight through a transparent surface is of the next generation, like one through glass",
        true),
    whole_row<&C::transparent_surfaces, 0, k_max_sample_rays>(
        "transparent_surfaces", "a whole number from 0 to 4096",
        "the transparent surfaces that are shaded along a path; further ones are passed as if absent", true),
    number_row<&C::transparent_epsilon, k_not_negative>(
        "transparent_epsilon",
        "surfaces within this distance behind a transparent one are not met by a ray straight through it"),
    number_row<&C::transparent_shadow_epsilon, k_not_negative>(
        "transparent_shadow_epsilon",
        "shadow rays that transparent surfaces color: transparent surfaces within this distance behind one "
        "that counts, or of the point that is lit, do not count"),
    number_row<&C::min_weight, k_fraction>("min_weight", "a ray with a smaller weight is not traced"),
    word_row<&C::facing, k_facings>(
        "facing",
        "which normals are turned to the incoming ray; open: those of surfaces that enclose no volume; "
        "winding: all, those of smooth triangles by the order of their vertices",
        true),
    bool_row<&C::cones>(
        "cones", "cones are rendered; CSC 473's own program reads them and does not render them", true),
    word_row<&C::spot_falloff, k_spot_falloffs>("spot_falloff",
                                                "how a spot's light decreases from its inner to its outer "
                                                "angle; cubic: in the cosine, linear: in the "
                                                "angle",
                                                true),
    bool_row<&C::clamp_attenuation>(
        "clamp_attenuation", "1/(c0 + c1 d + c2 d^2) is at most 1; false: it exceeds 1 near the light", true),
    bool_row<&C::attenuate_highlights>(
        "attenuate_highlights",
        "attenuation and a spot's factor apply to highlights; false: to the diffuse term only", true),
    number_row<&C::light_threshold, k_not_negative>(
        "light_threshold", "a light adds nothing where N.L times attenuation and spot is not above this"),
    word_row<&C::area_shading, k_area_shadings>(
        "area_shading",
        "samples: each sample of an area light is a light; center: only its shadow is sampled (POV-Ray)",
        true),
    word_row<&C::fog_distance, k_fog_distances>(
        "fog_distance",
        "what fog depends on: the distance along the ray, or of camera rays the depth along the view", true),
    bool_row<&C::fog_background>("fog_background", "the background is in the fog, at an infinite distance",
                                 true),
    word_row<&C::fog_extent, k_fog_extents>(
        "fog_extent",
        "where the fog is; outside_objects: not along rays that are inside an object that is not hollow",
        true),
    number_row<&C::background_alpha, k_fraction>(
        "background_alpha",
        "the alpha of the background in a picture with alpha; 0: the background is left out of it"),
    word_row<&C::transfer, k_transfers>(
        "transfer", "the curve from numbers to bytes: none, or sRGB's; OpenEXR is always linear", true),
    number_row<&C::gamma, k_gamma>(
        "gamma", "numbers are raised to this power before the transfer curve: POV-Ray's assumed_gamma"),
    word_row<&C::rounding, k_roundings>(
        "rounding",
        "how 255 v becomes a byte: the nearest, halves to the even one or up; or "
        "down, without what is behind the point",
        true),
    {{"size", "WIDTHxHEIGHT, each from 1 to 65536", "the size of the picture in pixels", false},
     parse_size,
     print_size},
    word_row<&S::shading, k_shadings>("shading", "the lighting equation, or part of it", false),
    bool_row<&S::shadows>("shadows", "whether objects cast shadows", false),
    whole_row<&S::reflections, 0, k_max_reflections>("reflections", "a whole number from 0 to 1000",
                                                     "the greatest generation of mirror and glass rays",
                                                     false),
    {{"aa", "a whole number from 1 to 64, or adaptive:N:T; :jitter may follow",
      "N: N x N samples for each pixel; adaptive: only where one sample differs by more than T from that of "
      "a "
      "neighbour; jitter: at sampled places",
      false},
     parse_aa,
     print_aa},
    bool_row<&S::alpha>("alpha", "the background is transparent: the picture has an alpha channel", false),
    {{"seed", "a whole number from 0 to 4294967295", "another one samples other places", false},
     parse_seed,
     print_seed},
};
constexpr std::size_t k_count = std::size(k_rows);

constexpr auto k_keys = [] {
    std::array<SettingKey, k_count> keys{};
    for (std::size_t i = 0; i < k_count; ++i) keys[i] = k_rows[i].key;
    return keys;
}();

}  // namespace

std::span<const SettingKey> setting_keys() { return k_keys; }

std::optional<std::size_t> find_setting(std::string_view name) {
    for (std::size_t i = 0; i < k_count; ++i) {
        if (k_keys[i].name == name) return i;
    }
    return std::nullopt;
}

Status set_setting(Scene& scene, std::size_t key, std::string_view value, SettingOrigin origin) {
    return result_of([&]() -> Status {
        if (key >= k_count) return invalid_argument("no such setting");
        const Row& row = k_rows[key];
        std::string wrong = row.parse(scene.conventions, scene.settings, row.key, trimmed(value));
        if (!wrong.empty()) return invalid_argument(std::move(wrong));
        scene.origins.resize(k_count);
        scene.origins[key] = origin;
        return {};
    });
}

std::string get_setting(const Scene& scene, std::size_t key) {
    return key < k_count ? k_rows[key].print(scene.conventions, scene.settings) : std::string();
}

}  // namespace glint
