// SPDX-License-Identifier: Apache-2.0
#include "export/gltf/reflection.h"

#include <algorithm>
#include <cstddef>

#include "export/gltf/colors.h"
#include "math/number.h"

namespace glint::gltf_export {
namespace {

constexpr double k_max_shininess = 10000;  // of what glTF's materials are read as
constexpr double k_least_alpha = 0.0142;   // about that of the greatest exponent
constexpr double k_close = 1e-9;

bool is_close(Color a, Color b, double within) {
    const auto differs = [&](double x, double y) {
        return !(number::abs(x - y) <= within * number::max(1.0, number::abs(x)));
    };
    return !differs(a.r, b.r) && !differs(a.g, b.g) && !differs(a.b, b.b);
}

Color at_least_zero(Color c) { return {number::max(c.r, 0.0), number::max(c.g, 0.0), number::max(c.b, 0.0)}; }

double alpha_of(double shininess) {
    // No roughness has a greater exponent; that of 0 has one too, of which 10000 is drawn.
    return shininess >= k_max_shininess ? 0 : number::sqrt(2 / (shininess + 2));
}

// The dielectric part of f0, divided by `reflected`, for a metal of this share. Nothing if there is none.
std::optional<Color> dielectric_tint(const Material& m, Color base, double alpha, double metallic,
                                     double reflected) {
    const double n = number::min(m.shininess, k_max_shininess);
    const double height = (1 - alpha) * (n + 2) / 8;
    const Color white{1, 1, 1};
    // With the usual one, the reader limits the greatest channel to 1.
    const Color usual = white * (reflected * (1 - metallic)) + base * metallic;
    const Color highlight = usual * height;
    const double brightest = greatest(highlight);
    if (is_close(brightest > 1 ? highlight * (1 / brightest) : highlight, m.specular, k_close)) return white;
    if (!(height > 0)) return std::nullopt;
    const double share = reflected * (1 - metallic);
    if (!(share > 0)) return std::nullopt;
    const Color tint = (m.specular * (1 / height) + base * -metallic) * (1 / share);
    const double least = number::min(tint.r, number::min(tint.g, tint.b));
    if (!(least >= -k_close) || greatest(m.specular) > 1) return std::nullopt;
    return at_least_zero(tint);
}

// Of several channels of a highlight, the metallic factor that gives them; nothing if all are the same.
std::optional<double> metallic_of_tint(const Material& m, double reflected) {
    const double c[3] = {m.color.r, m.color.g, m.color.b};
    const double k[3] = {m.specular.r, m.specular.g, m.specular.b};
    const auto most = static_cast<std::size_t>(std::max_element(k, k + 3) - k);
    const auto least = static_cast<std::size_t>(std::min_element(k, k + 3) - k);
    if (!(k[most] > 0)) return std::nullopt;
    const double ratio = k[least] / k[most];
    const double slope = ratio * (c[most] - reflected) - (c[least] - reflected);
    if (!(1 - ratio > k_close) || !(slope > 0)) return std::nullopt;
    return reflected * (1 - ratio) / slope;
}

// The metal of this color, if its alpha and its metallic factor give the highlight.
std::optional<MetalRoughness> metal_of(const Material& m, double alpha, double metallic, double reflected) {
    if (!(metallic > k_close && metallic < 1 + k_close)) return std::nullopt;
    if (metallic > 1 - k_close) metallic = 1;
    const std::optional<Color> tint = dielectric_tint(m, m.color, alpha, metallic, reflected);
    if (!tint) return std::nullopt;
    MetalRoughness found{m.color, metallic, number::sqrt(alpha), {}, true};
    if (*tint != Color{1, 1, 1}) found.specular = tint;
    return found;
}

// A metal's diffuse light is a share of its color, from which its metallic factor follows.
std::optional<MetalRoughness> as_metal(const Material& m, double reflected) {
    const double alpha = alpha_of(m.shininess);
    const double sum = m.color.r + m.color.g + m.color.b;
    if (!(sum > 0) || !(alpha < 1) || greatest(m.color) > 1 + k_close) return std::nullopt;
    const double share = (m.diffuse.r + m.diffuse.g + m.diffuse.b) / sum;
    if (!(share < 1) || !is_close(m.color * share, m.diffuse, k_close)) return std::nullopt;
    if (m.shininess < k_max_shininess) return metal_of(m, alpha, 2 * (1 - share) / (1 - alpha), reflected);
    // Several alphas are read as the greatest exponent: the tint of the highlight gives the metal.
    if (const std::optional<double> metallic = metallic_of_tint(m, reflected)) {
        const double found = 1 - 2 * (1 - share) / *metallic;
        if (found > -k_close && found < k_least_alpha)
            return metal_of(m, number::max(found, 0.0), *metallic, reflected);
    }
    return metal_of(m, 0, 2 * (1 - share), reflected);
}

}  // namespace

double roughness_of(double shininess) { return number::sqrt(alpha_of(shininess)); }

MetalRoughness metal_roughness(const Material& m, double reflected) {
    if (const std::optional<MetalRoughness> metal = as_metal(m, reflected)) return *metal;
    MetalRoughness found{m.diffuse, 0, 1, {}, true};
    if (m.specular == Color{}) return found;  // as a roughness of 1 is read
    found.roughness = roughness_of(m.shininess);
    const std::optional<Color> tint = dielectric_tint(m, found.base, alpha_of(m.shininess), 0, reflected);
    found.is_exact = tint && m.shininess <= k_max_shininess;
    if (tint && *tint != Color{1, 1, 1}) found.specular = tint;
    return found;
}

}  // namespace glint::gltf_export
