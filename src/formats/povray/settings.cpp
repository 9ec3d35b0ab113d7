// SPDX-License-Identifier: Apache-2.0
// global_settings, and what the text sets otherwise.
#include <fmt/format.h>

#include <algorithm>

#include "formats/povray/reader.h"

namespace glint::povray {

void Reader::read_global_settings() {
    if (!expect('{')) return;
    while (!failed() && !accept('}')) {
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
                if (const double least = std::clamp(number(), 0.0, 1.0); !failed()) {
                    set("min_weight", item, fmt::format("{}", least));
                    builder_.set_high_bailout(least > 1.01 / 255 ? std::optional(item) : std::nullopt);
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
            case Word::k_charset: {
                const Token charset = take();
                is_utf8_ = charset.kind == TokenKind::word && text_of(charset) == "utf8";
                break;
            }
            case Word::k_max_intersections:
            case Word::k_mm_per_unit:
            case Word::k_noise_generator:
            case Word::k_number_of_waves:
                number();
                break;
            case Word::k_radiosity:
            case Word::k_photons:
                skip_block();
                builder_.report(missing(item, to_string(item.word())));
                break;
            default:
                if (item.kind == TokenKind::word && name_of(item.name) == "subsurface") {
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
    builder_.report({gamma_ ? "assumed_gamma" : "#version 3.7", "the encoding of the picture's bytes", at});
}

// Sets a convention or setting that the text gives; false if there is none of this name.
bool Reader::set(std::string_view name, const Token& at, std::string_view value) {
    const auto key = find_setting(name);
    return !failed() && key &&
           set_setting(scene_, *key, value, {SettingOrigin::Kind::file, place_of(at)}).ok();
}

}  // namespace glint::povray
