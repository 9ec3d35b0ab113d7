// SPDX-License-Identifier: Apache-2.0
// A pixel's color, and its bytes.
#include <algorithm>

#include "diagnose/ray_model.h"
#include "math/elementary.h"

namespace glint {

Maybe logged_of_pixel(const LogModel& model, std::uint32_t pixel, Quantity quantity) {
    const LoggedValue* value = model.log.pixels[pixel].find(quantity);
    if (value == nullptr) return std::nullopt;
    const Vec3 v = value->value.value();
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return std::nullopt;
    return value->value * Approx(1 / model.rules.white[static_cast<std::size_t>(quantity)]);
}

namespace {

// Of a byte rule that is a mistake; c is clamped.
double mistaken_byte(double c, TracerMistake mistake, int variant) {
    const double inside = std::clamp(c, 0.0, 1.0);
    switch (mistake) {
        case TracerMistake::bytes_truncated:
            return std::floor(255 * inside);
        case TracerMistake::bytes_times_256:
            return variant == 0 ? std::min(255.0, std::floor(256 * inside)) : std::floor(255.99 * inside);
        case TracerMistake::bytes_rounded_up:
            return std::ceil(255 * inside);
        case TracerMistake::bytes_wrapped: {
            const double all =
                std::floor((variant < 2 ? 255 : 256) * std::max(c, 0.0) + (variant == 1 ? 0.5 : 0));
            return all - 256 * std::floor(all / 256);
        }
        case TracerMistake::bytes_gamma:
            return std::floor(255 * (variant == 0 ? pow(inside, 1 / 2.2) : std::sqrt(inside)) + 0.5);
        case TracerMistake::bytes_srgb:
            return std::floor(
                255 * (inside <= 0.0031308 ? 12.92 * inside : 1.055 * pow(inside, 1 / 2.4) - 0.055) + 0.5);
        case TracerMistake::bytes_signed: {
            const double byte = std::floor(255 * inside + 0.5);
            return byte > 127 ? 0 : byte;
        }
        default:
            return inside >= 1 ? 255 : 0;  // bytes_integer_division
    }
}

Maybe bytes_of(const ApproxVec& color, const ByteRule& rule, Trial trial) {
    const bool is_mistaken =
        trial.mistake != TracerMistake::none && info_of(trial.mistake).at == Quantity::bytes;
    const auto one = [&](Approx c) {
        const auto byte = [&](double v) {
            return is_mistaken && trial.mistake != TracerMistake::bytes_swapped
                       ? mistaken_byte(v, trial.mistake, trial.variant)
                       : static_cast<double>(to_byte(static_cast<float>(v), rule));
        };
        const double v = byte(c.v);
        return Approx(v, std::max(std::fabs(byte(c.v + c.e) - v), std::fabs(byte(c.v - c.e) - v)));
    };
    if (trial.mistake == TracerMistake::bytes_swapped)
        return ApproxVec(one(color.z), one(color.y), one(color.x));
    return ApproxVec(one(color.x), one(color.y), one(color.z));
}

}  // namespace

Maybe expected_of_pixel(const LogModel& model, std::uint32_t index, Quantity quantity, Trial trial) {
    const LoggedPixel& pixel = model.log.pixels[index];
    const auto value = [&](Quantity of) {
        const Maybe own = logged_of_pixel(model, index, of);
        return own ? own : expected_of_pixel(model, index, of, trial);
    };
    switch (quantity) {
        case Quantity::pixel_color: {
            if (model.scene.settings.samples > 1) return std::nullopt;
            for (std::size_t i = 0; i < pixel.rays.size(); ++i) {
                if (pixel.rays[i].parent >= 0) continue;
                const Maybe color =
                    RayModel(model, index, static_cast<std::int32_t>(i), trial).value(Quantity::color);
                if (color || !pixel.rays[i].list.empty()) return color;
            }
            const std::optional<Explanation>& e = model.references[index].explanation;
            if (!e || trial.mistake != TracerMistake::none) return std::nullopt;
            ApproxVec all(Color{e->value[0], e->value[1], e->value[2]});
            all.x.e = all.y.e = all.z.e = 1e-4;
            return all;
        }
        case Quantity::clamped: {
            const Maybe color = value(Quantity::pixel_color);
            if (!color) return std::nullopt;
            if (trial.mistake == TracerMistake::clamp_missing) return color;
            if (trial.mistake == TracerMistake::clamp_scaled) {
                const Approx most = max(max(color->x, color->y), color->z);
                if (most.v > 1) return *color / most;
            }
            if (trial.mistake == TracerMistake::clamp_toned) {
                const auto toned = [&](Approx c) {
                    const auto curve = [&](double v) {
                        return trial.variant == 0 ? v / (1 + v) : 1 - exp(-v);
                    };
                    const double v = std::max(c.v, 0.0);
                    return Approx(curve(v), c.e);  // no slope is above 1
                };
                return ApproxVec(toned(color->x), toned(color->y), toned(color->z));
            }
            return clamped(*color);
        }
        case Quantity::bytes: {
            // A mistake of the conversion begins with the color before the clamp.
            const Maybe color = trial.mistake == TracerMistake::bytes_wrapped ? value(Quantity::pixel_color)
                                                                              : value(Quantity::clamped);
            if (!color) return std::nullopt;
            return bytes_of(*color, model.scene.conventions.byte_rule(), trial);
        }
        default:
            return std::nullopt;
    }
}

}  // namespace glint
