// SPDX-License-Identifier: Apache-2.0
#include "formats/povray/image_gamma.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include "math/elementary.h"
#include "math/srgb.h"

namespace glint::povray {
namespace {

double to_power(double x, double power) { return x > 0 ? pow(x, power) : 0; }
double light_of(const ImageCurve& curve, double x) {
    return curve.is_srgb ? srgb_decode(x) : to_power(x, curve.power);
}
double number_of(const ImageCurve& curve, double light) {
    return curve.is_srgb ? srgb_encode(light) : to_power(light, 1 / curve.power);
}

std::uint32_t big_endian(std::string_view bytes) {
    std::uint32_t value = 0;
    for (const char c : bytes.substr(0, 4)) value = value << 8 | static_cast<std::uint8_t>(c);
    return value;
}

}  // namespace

TextureImage with_curve(const TextureImage& image, const ImageCurve& of_file, const ImageCurve& of_scene) {
    constexpr double most = 65535;
    TextureImage made{image.width, image.height, image.has_alpha, std::vector<std::uint16_t>{}};
    auto& to = std::get<1>(made.words);
    std::visit(
        [&](const auto& words) {
            const std::size_t count = sizeof(words[0]) == 1 ? 256 : 65536;
            std::vector<std::uint16_t> table(count);
            for (std::size_t i = 0; i < count; ++i) {
                const double x = static_cast<double>(i) / static_cast<double>(count - 1);
                table[i] = static_cast<std::uint16_t>(
                    std::floor(number_of(of_scene, light_of(of_file, x)) * most + 0.5));
            }
            to.reserve(words.size());
            for (std::size_t i = 0; i < words.size(); ++i) {
                const bool is_alpha = image.has_alpha && i % 4 == 3;
                to.push_back(is_alpha ? static_cast<std::uint16_t>(words[i] * (65535 / (count - 1)))
                                      : table[words[i]]);
            }
        },
        image.words);
    return made;
}

std::optional<ImageCurve> png_curve(std::string_view file) {
    constexpr std::string_view signature = "\x89PNG\r\n\x1a\n";
    if (!file.starts_with(signature)) return std::nullopt;
    file.remove_prefix(signature.size());
    while (file.size() >= 12) {
        const std::size_t size = big_endian(file);
        const std::string_view type = file.substr(4, 4);
        if (type == "IDAT" || size > file.size() - 12) break;
        if (type == "gAMA" && size == 4) {
            const std::uint32_t value = big_endian(file.substr(8));
            if (value == 0) break;
            return ImageCurve{false, 1e5 / value};
        }
        file.remove_prefix(size + 12);
    }
    return std::nullopt;
}

}  // namespace glint::povray
