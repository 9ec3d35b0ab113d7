// SPDX-License-Identifier: Apache-2.0
// Scene to World: the light from all directions, and the background gradient.
#include "world/appearance/prepare_sky.h"

#include <cstdint>

#include "math/number.h"
#include "math/transform.h"

namespace glint {
namespace {

// Marsaglia's generator KISS of 1993: a congruential generator, a shift register and a multiply-with-carry.
class Kiss93 {
  public:
    std::uint32_t next() {
        x_ = x_ * 69069 + 1;
        y_ ^= y_ << 13;
        y_ ^= y_ >> 17;
        y_ ^= y_ << 5;
        const std::uint32_t carry = (z_ >> 2) + (w_ >> 3) + (c_ >> 2), sum = w_ + w_ + z_ + c_;
        z_ = w_;
        w_ = sum;
        c_ = carry >> 30;
        return x_ + y_ + w_;
    }
    float next_fraction() { return static_cast<float>(next() / 4294967296.0); }

  private:
    std::uint32_t x_ = 1, y_ = 2, z_ = 4, w_ = 8, c_ = 0;
};

Vec3 next_direction(Kiss93& random) {
    float x = 0, y = 0, z = 0, square = 0;
    do {
        x = random.next_fraction() - 0.5f;
        y = random.next_fraction() - 0.5f;
        z = random.next_fraction() - 0.5f;
        square = x * x + y * y + z * z;
    } while (square > 0.25f);
    const auto inverse = static_cast<float>(1.0 / number::sqrt(static_cast<double>(square)));
    return {x * inverse, y * inverse, z * inverse};
}

}  // namespace

std::vector<Vec3> fixed_directions(std::size_t count) {
    Kiss93 random;
    std::vector<Vec3> directions(count);
    for (Vec3& direction : directions) direction = next_direction(random);
    return directions;
}

void set_fog(WorldParts& parts, const std::optional<Fog>& fog) {
    parts.fog = fog;
    parts.fog_tint = {1, 1, 1};
    if (fog) parts.fog_tint = parts.fog_tint * (1 - fog->filter) + fog->color * fog->filter;
}

void set_gradient(const std::optional<BackgroundGradient>& gradient, WorldParts& parts) {
    parts.gradient = gradient;
    if (gradient) parts.gradient->up = normalize(gradient->up);
}

void set_occlusion(const std::optional<Occlusion>& occlusion, WorldParts& parts) {
    parts.occlusion = occlusion;
    parts.direct = occlusion ? occlusion->direct : 1;
    const bool fixed = occlusion && occlusion->method == OcclusionMethod::fixed;
    parts.occlusion_directions =
        fixed
            ? fixed_directions(std::size_t{k_occlusion_blocks} * static_cast<std::size_t>(occlusion->samples))
            : std::vector<Vec3>();
}

}  // namespace glint
