// SPDX-License-Identifier: Apache-2.0
#include "world/appearance/noise.h"

#include <cmath>

#include "math/number.h"
#include "math/sample_hash.h"

namespace glint {
namespace {

constexpr double k_far = 0x1p31;

// The numbers of a direction around a point: the fraction, and the weight of the next corner.
struct Fraction {
    std::uint32_t cell = 0;
    double at = 0, weight = 0;
    explicit Fraction(double x) {
        const double below = std::floor(x);
        cell = static_cast<std::uint32_t>(static_cast<std::int64_t>(below));
        at = x - below;
        weight = at * at * at * (at * (at * 6 - 15) + 10);
    }
};

// The product with one of the twelve directions to a cube's edges.
double along_edge(std::uint32_t hash, double x, double y, double z) {
    const std::uint32_t edge = hash % 12, sign = hash >> 16;
    const double first = edge < 8 ? x : y, second = edge < 4 ? y : z;
    return ((sign & 1) != 0 ? -first : first) + ((sign & 2) != 0 ? -second : second);
}

double between(double a, double b, double weight) { return a + (b - a) * weight; }

// Below 1, where a texture that repeats begins again.
double from_0_to_1(double x) {
    constexpr double k_most = 0x1.fffffffffffffp-1;
    return x < 0 ? 0 : x > k_most ? k_most : x;
}

}  // namespace

double gradient_noise(Vec3 p, std::uint32_t series) {
    if (!(number::abs(p.x) < k_far && number::abs(p.y) < k_far && number::abs(p.z) < k_far)) return 0;
    const Fraction x(p.x), y(p.y), z(p.z);
    const auto corner = [&](std::uint32_t i, std::uint32_t j, std::uint32_t k) {
        const std::uint32_t hash =
            hash_with(hash_with(hash_with(lowbias32(series + 1), x.cell + i), y.cell + j), z.cell + k);
        return along_edge(hash, x.at - i, y.at - j, z.at - k);
    };
    const auto row = [&](std::uint32_t j, std::uint32_t k) {
        return between(corner(0, j, k), corner(1, j, k), x.weight);
    };
    const auto face = [&](std::uint32_t k) { return between(row(0, k), row(1, k), y.weight); };
    return between(face(0), face(1), z.weight);
}

Vec3 noise_displacement(const Texture& texture, Vec3 p) {
    Vec3 sum;
    double size = 1, scale = 1;
    for (double rest = texture.octaves; rest > 0; rest -= 1) {
        const double part = size * number::min(rest, 1.0);
        const Vec3 at = p * scale;
        sum = sum + Vec3{gradient_noise(at, 1), gradient_noise(at, 2), gradient_noise(at, 3)} * part;
        size *= texture.gain;
        scale *= texture.lacunarity;
    }
    return sum;
}

double noise_pattern(Vec3 p) { return from_0_to_1(0.5 + 0.5 * gradient_noise(p)); }

double granite(Vec3 p) {
    double sum = 0;
    for (double scale = 1; scale <= 32; scale *= 2)
        sum += number::abs(gradient_noise(p * (4 * scale))) / scale;
    return from_0_to_1(sum);
}

double wrinkles(Vec3 p) {
    double sum = 0;
    for (double scale = 1; scale <= 512; scale *= 2) sum += noise_pattern(p * scale) / scale;
    return from_0_to_1(sum / 2);
}

}  // namespace glint
