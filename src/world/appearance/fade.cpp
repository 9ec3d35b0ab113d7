// SPDX-License-Identifier: Apache-2.0
#include "world/appearance/fade.h"

#include "math/elementary.h"
#include "math/number.h"
#include "math/transform.h"
#include "world/appearance/appearance.h"

namespace glint {
namespace {

// From this power on, T falls exponentially (POV-Ray, measured).
constexpr double k_exponential_power = 1000;

}  // namespace

Color fade_at(const WorldParts& world, SurfaceId id, Vec3 point, Vec3 direction, double distance) {
    constexpr Color all{1, 1, 1};
    const double* const values = world.extended_row(material_row(world, id));
    const double half = values[k_extended_value<&Material::fade_distance>],
                 power = values[k_extended_value<&Material::fade_power>];
    if (!(half > 0) || !(dot(surface_normals(*world.geometry, id, point).face, direction) > 0)) return all;
    const double x = distance / half;
    const bool is_exponential = power >= k_exponential_power;
    const double left = is_exponential ? 0 : 1 / (1 + pow(x, power));
    const double* const color = values + k_extended_value<&Material::fade_color>;
    const auto channel = [&](double c) {
        return is_exponential ? exp(-((1 - c) * x)) : 1 - (1 - c) * (1 - left);
    };
    return {channel(color[0]), channel(color[1]), channel(color[2])};
}

double caustics_at(const WorldParts& world, SurfaceId id, Vec3 point, Vec3 direction) {
    const double power = world.extended_row(material_row(world, id))[k_extended_value<&Material::caustics>];
    if (!(power > 0)) return 1;
    const Vec3 normal = surface_normals(*world.geometry, id, point).shading;
    const double cosine = number::abs(dot(normal, direction)) / length(direction);
    return 1 + pow(number::min(cosine, 1.0), power);
}

}  // namespace glint
