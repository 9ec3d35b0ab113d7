// SPDX-License-Identifier: Apache-2.0
// Statements of a scene, global_settings and the background.
#include <fmt/format.h>

#include <algorithm>

#include "base/text.h"
#include "formats/povray/reader.h"
#include "formats/povray_keywords.h"

namespace glint::povray {

void Reader::read_statement() {
    const Token item = peek();
    if (item.is(';') || item.is(',')) {
        take();
        return;
    }
    if (begins_object(item)) {
        if (!begins_declared(item)) return place(read_object());
        const ObjectPart object = read_part();
        if (object) place(*object);
        return;
    }
    switch (item.word()) {
        case Word::k_camera:
            take();
            camera_ = read_camera(item);
            return;
        case Word::k_background:
            take();
            return read_background(item);
        case Word::k_global_settings:
            take();
            return read_global_settings();
        case Word::k_fog:
            take();
            return read_fog(item);
        case Word::k_default:  // without `#`
            take();
            return read_default();
        case Word::k_declare:
            take();
            return read_declare(false);
        case Word::k_sky_sphere:
            take();
            return read_sky(item);
        case Word::k_rainbow:
            take();
            skip_block();
            return report(missing(item, to_string(item.word())));
        default:
            break;
    }
    if (item.kind == TokenKind::word && !Names::is_reserved(item.name)) {
        const std::string_view name = names_.name(item.name);
        if (find_value(item.name) == nullptr && !povray_meaning(name).empty()) {
            take();
            skip_block();
            return report(missing(item, name));
        }
    }
    expected("an object, `camera`, `light_source`, `background` or a directive");
}

void Reader::read_background(const Token& at) {
    if (!expect('{')) return;
    const std::array<double, 5> c = color(true);
    expect('}');
    if (failed_) return;
    // The transmit of a background counts from version 3.7 on.
    background_ = c;
    scene_.background_place = place_of(at);
    reading_.background_given = true;
}

// fog { items }: of constant density.
void Reader::read_fog(const Token& at) {
    Fog fog;
    fog.color = {0, 0, 0};
    fog.density = 0;
    if (!expect('{')) return;
    std::optional<Affine> map;
    while (!failed_ && !accept('}')) {
        if (accept(',') || read_transform_item(map)) continue;
        const Token item = peek();
        // POV-Ray takes `color` twice here, and only here; color() takes the second one.
        const bool has_word = accept(Word::k_color) || accept(Word::k_colour);
        if (has_word || begins_color(item) || (begins_number(item) && item.kind == TokenKind::word)) {
            const std::array<double, 5> c = color(true);
            fog.color = {c[0], c[1], c[2]};
            fog.transmit = std::clamp(c[4], 0.0, 1.0);
            if (c[3] != 0) report({"filter", "of a fog", at});
            continue;
        }
        take();
        if (item.word() == Word::k_distance) {
            const double distance = number();
            fog.density = distance > 0 ? 1 / distance : 0;
        } else if (item.word() == Word::k_fog_type) {
            if (number() != 1) report({"fog_type 2", "fog on the ground", item});
        } else if (item.kind == TokenKind::word && !Names::is_reserved(item.name) && begins_number(peek())) {
            report({"turbulence", "of a fog", item});
            expression();
        } else {
            error(item, fmt::format("expected `distance`, a color, `fog_type` or `}}`, found {}{}",
                                    describe(item), what_is(item)));
        }
    }
    if (failed_ || fog.density == 0) return;
    if (scene_.fog) report({"fog", "a second one", at});
    scene_.fog = fog;
    scene_.fog_place = place_of(at);
}

void Reader::read_global_settings() {
    if (!expect('{')) return;
    while (!failed_ && !accept('}')) {
        const Token item = take();
        switch (item.word()) {
            case Word::k_assumed_gamma:
                if (accept(Word::k_srgb)) {
                    is_gamma_srgb_ = true;
                    gamma_ = 2.2;
                } else {
                    gamma_ = number();
                    is_gamma_srgb_ = false;
                }
                gamma_place_ = item;
                break;
            case Word::k_max_trace_level:
                // The camera ray is level 1.
                set("reflections", item,
                    fmt::format("{}",
                                static_cast<int>(std::clamp(number() - 1, 0.0, 1.0 * k_max_reflections))));
                break;
            case Word::k_adc_bailout:
                if (const double least = std::clamp(number(), 0.0, 1.0); !failed_) {
                    set("min_weight", item, fmt::format("{}", least));
                    high_bailout_ = least > 1.01 / 255 ? std::optional(item) : std::nullopt;
                }
                break;
            case Word::k_ambient_light: {
                const std::array<double, 5> c = color(true);
                ambient_light_ = {c[0], c[1], c[2]};
                break;
            }
            case Word::k_irid_wavelength:
                color(true);
                break;
            case Word::k_hf_gray_16:
                flag();
                break;
            case Word::k_charset:
                take();
                break;
            case Word::k_max_intersections:
            case Word::k_mm_per_unit:
            case Word::k_noise_generator:
            case Word::k_number_of_waves:
                number();
                break;
            case Word::k_radiosity:
            case Word::k_photons:
                skip_block();
                report(missing(item, to_string(item.word())));
                break;
            default:
                if (item.kind == TokenKind::word && names_.name(item.name) == "subsurface") {
                    skip_block();
                } else if (!item.is(',')) {
                    error(item, fmt::format("expected a global setting or `}}`, found {}{}", describe(item),
                                            what_is(item)));
                }
        }
    }
}

// POV-Ray's bytes are the picture's numbers if neither assumed_gamma nor a version from 3.7 on is given, else
// sRGB's curve of them to the power of assumed_gamma.
void Reader::use_gamma() {
    const bool is_new = version_.value_or(0) >= 3.7;
    if ((!gamma_ && !is_new) || is_gamma_srgb_) return;
    const Token at = gamma_ ? gamma_place_ : version_place_;
    const double gamma = gamma_.value_or(1);
    if (!(gamma > 0 && gamma <= 100)) return error(at, "expected a gamma above 0 and at most 100");
    if (set("transfer", at, "srgb") && set("gamma", at, fmt::format("{}", gamma))) return;
    report({gamma_ ? "assumed_gamma" : "#version 3.7", "the encoding of the picture's bytes", at});
}

// Sets a convention or setting that the text gives; false if there is none of this name.
bool Reader::set(std::string_view name, const Token& at, std::string_view value) {
    const auto key = find_setting(name);
    return !failed_ && key &&
           set_setting(scene_, *key, value, {SettingOrigin::Kind::file, place_of(at)}).ok();
}

// What the whole text decides.
// `no_reflection` matters only where something reflects.
void Reader::check_no_reflection() {
    const auto reflects = [](const Material& m) {
        return m.mirror > 0 || m.mirror_min > 0 || m.transmission > 0;
    };
    if (no_reflection_ && std::any_of(scene_.materials.begin(), scene_.materials.end(), reflects))
        report({"no_reflection", "", *no_reflection_});
}

void Reader::finish_settings() {
    if (failed_) return;
    const bool has_camera = camera_ || camera_default_;
    // A text of objects for another scene need not have a camera.
    if (has_camera || !text_.is_included) {
        use_camera(camera_.value_or(camera_default_.value_or(CameraItems())));
    }
    if (!has_camera) scene_.camera_place = {};
    if (!(ambient_light_ == Color{0, 0, 0})) {
        Light ambient;
        ambient.kind = LightKind::ambient;
        ambient.color = ambient_light_;
        scene_.light_texts.places.resize(scene_.lights.size());
        scene_.light_texts.places.emplace_back();
        scene_.lights.push_back(ambient);
    }
    check_parallel_lights();
    check_no_reflection();
    check_glass();
    check_clips();
    check_size();
    check_bailout();
    use_interiors();
    use_gamma();
    const bool is_new = version_.value_or(0) >= 3.7;
    if (!is_new) set("opacity", version_place_, "brightest");
    set("rounding", version_place_, "half_up");
    const double transmit = is_new ? std::clamp(background_[4], 0.0, 1.0) : 0;
    scene_.background = Color{background_[0], background_[1], background_[2]} * (1 - transmit);
}

}  // namespace glint::povray
