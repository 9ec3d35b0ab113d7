// SPDX-License-Identifier: Apache-2.0
// Tachyon's patterns of colors as textures. All numbers were measured in its pictures; Rotate and Scale have
// no effect there, and Center has none on grit and marble.
#include "formats/tachyon.h"
#include "math/number.h"
#include "math/transform.h"
#include "scene/ranges.h"

namespace glint {
namespace {

constexpr double k_third = 0x1.5555555555555p-2, k_two_thirds = 2 * k_third;

constexpr Color bytes(double r, double g, double b) { return {r / 255, g / 255, b / 255}; }

// Cubes of side 1/3, one of them around the center. A point on a border is in the cube that is further from
// the center; in glint it is in the upper one, so that the cubes are a little smaller.
void set_checker(Texture& t, Vec3 center) {
    constexpr double k_side = k_third * (1 - 1e-9), k_half = k_side / 2;
    t.mapping = TextureMapping::checker;
    t.filter = TextureFilter::nearest;
    // The corner of a cube around the furthest center is none that a transform may have.
    const auto corner = [](double c) { return number::max(c - k_half, k_coordinate.min); };
    t.world_from_texture = compose(translation({corner(center.x), corner(center.y), corner(center.z)}),
                                   scaling({k_side, k_side, k_side}));
    t.color_map = {{0, {0, 0.2, 1}}, {0.5, {1, 0.2, 0}}};
}

// White noise: the color times a random number from 0.8 to 1 for each ray. Cells far below a pixel's size, in
// no order with the pixels; the places are the quantiles of the noise, so that all factors are as frequent.
void set_grit(Texture& t, Color tint) {
    constexpr double k_cell = 1e-4;
    constexpr struct {
        double at, part;
    } k_quantiles[] = {{0.17, 0},    {0.276, 0.05}, {0.322, 0.1}, {0.379, 0.2}, {0.424, 0.3},  {0.464, 0.4},
                       {0.536, 0.6}, {0.576, 0.7},  {0.621, 0.8}, {0.678, 0.9}, {0.724, 0.95}, {0.83, 1}};
    t.mapping = TextureMapping::noise;
    t.wrap_u = TextureWrap::clamp;
    t.world_from_texture =
        compose(rotation_x(23.7), compose(rotation_y(41.3), scaling({k_cell, k_cell, k_cell})));
    for (const auto& [at, part] : k_quantiles) t.color_map.push_back({at, tint * (0.8 + 0.2 * part)});
}

// A ramp from violet to green that begins again some seven times in a unit, as it does in Tachyon between 5
// and 20 units from the origin; the first color is more frequent than the others.
void set_marble(Texture& t) {
    constexpr double k_ramps = 24, k_first = 0.035, k_red = 127.5, k_last_red = 52;
    constexpr double k_ramp[][3] = {{k_red, 58.3, 181},       {120.5, 73.4, 150.9}, {112.5, 93, 112.5},
                                    {104.5, 113.5, 75},       {98.5, 129.5, 49.5},  {92.5, 145.5, 28},
                                    {86.5, 161.3, 12.3},      {81.5, 174.3, 3.7},   {76.5, 187, 0.1},
                                    {71.5, 199.5, 2},         {66.5, 211, 9.5},     {60.5, 223.7, 25.8},
                                    {k_last_red, 238.5, 60.5}};
    t.mapping = TextureMapping::noise;
    t.uv_map.m[0][0] = k_ramps;
    for (const auto& [r, g, b] : k_ramp) {
        const double along = (k_red - r) / (k_red - k_last_red);
        t.color_map.push_back({k_first + (1 - k_first) * along, bytes(r, g, b)});
    }
}

// Rings around the axis through the center along y, 60 wide, of which 20 are black. Without Tachyon's waves
// of the radius, 3 sin(20 angle + y / 150), which no mapping has.
void set_wood(Texture& t, Vec3 center) {
    constexpr double k_width = 60;
    t.mapping = TextureMapping::rings;
    t.filter = TextureFilter::nearest;
    t.world_from_texture = translation(center);
    t.uv_map.m[0][0] = 1 / k_width;
    t.uv_map.m[0][2] = 0.5 / k_width;
    t.color_map = {{0, {0.8, 1, 0.2}}, {k_two_thirds, {0, 0, 0}}};
}

}  // namespace

Texture tachyon_pattern(TachyonFunction function, Vec3 center, Color tint, TextureMix mix) {
    Texture t;
    t.mix = mix;
    switch (function) {
        case TachyonFunction::checker:
            set_checker(t, center);
            break;
        case TachyonFunction::grit:
            set_grit(t, tint);
            break;
        case TachyonFunction::marble:
            set_marble(t);
            break;
        case TachyonFunction::wood:
            set_wood(t, center);
            break;
        case TachyonFunction::none:
            break;
    }
    return t;
}

}  // namespace glint
