// SPDX-License-Identifier: Apache-2.0
#include "scene/material_color.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "math/number.h"
#include "scene/material_fields.h"

namespace glint {
namespace {

double largest(Color c) {
    return number::max(number::abs(c.r), number::max(number::abs(c.g), number::abs(c.b)));
}

double find_factor(Color color, Color k, double usual) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const double sum = color.r + color.g + color.b;
    if (!(sum > 0)) return k == Color{} ? usual : none;
    double factor = (k.r + k.g + k.b) / sum;
    if (number::abs(factor - usual) <= 1e-12) {
        factor = usual;
    } else if (const auto exact = find_coefficient(color, k)) {
        return *exact;
    }
    const Color multiple = factor * color;
    const double off = largest({multiple.r - k.r, multiple.g - k.g, multiple.b - k.b});
    return off <= 1e-9 * number::max(1.0, largest(k)) ? factor : none;
}

}  // namespace

std::optional<double> find_coefficient(Color color, Color k) {
    const auto gives_k = [&](double c) { return c >= 0 && c <= 1 && same_bits(color * c, k); };
    if (gives_k(0)) return 0;
    const double quotient = color.r != 0 ? k.r / color.r : color.g != 0 ? k.g / color.g : k.b / color.b;
    if (!(quotient > 0 && quotient < 2)) return std::nullopt;
    double power = 1;
    for (int decimals = 0; decimals <= 15; ++decimals, power *= 10) {
        // A whole number below 2^53 over a power of ten is the double nearest to that decimal.
        const double c = std::round(quotient * power) / power;
        if (gives_k(c)) return c;
    }
    const auto bits = std::bit_cast<std::uint64_t>(quotient);
    for (const std::uint64_t near : {bits, bits - 1, bits + 1, bits - 2, bits + 2}) {
        if (gives_k(std::bit_cast<double>(near))) return std::bit_cast<double>(near);
    }
    return std::nullopt;
}

std::array<double, k_color_factors> find_color_factors(
    Color color, const std::array<Color, k_color_factors>& coefficients) {
    static_assert(std::size(k_material_coefficients) >= k_color_factors);
    std::array<double, k_color_factors> factors{};
    for (std::size_t i = 0; i < factors.size(); ++i)
        factors[i] = find_factor(color, coefficients[i], k_material_coefficients[i].usual);
    return factors;
}

Material with_color(const Material& material, Color color) {
    Material changed = material;
    changed.color = color;
    for (const MaterialCoefficient& c : std::span(k_material_coefficients).first(k_color_factors)) {
        const double factor = find_factor(material.color, material.*c.field, c.usual);
        if (factor == factor) changed.*c.field = factor * color;
    }
    return changed;
}

Material with_texture(const Material& material, const Texture& texture, const ShownTexture& shown) {
    Material changed = material;
    if (texture.mix == TextureMix::replace) {
        changed = with_color(material, shown.color);
        changed.ambient = with_color(material, shown.ambient).ambient;
        changed.diffuse = with_color(material, shown.diffuse).diffuse;
    } else {
        changed.color = material.color * shown.color;
        changed.ambient = material.ambient * shown.ambient;
        changed.diffuse = material.diffuse * shown.diffuse;
        if (texture.mix == TextureMix::multiply_all) changed.emission = material.emission * shown.color;
    }
    const double opacity = texture.opacity(shown.alpha);
    if (opacity == 1) return changed;
    changed.filter = opacity * material.filter;
    changed.transmit = faded_transmit(material.transmit, opacity);
    return changed;
}

}  // namespace glint
