// SPDX-License-Identifier: Apache-2.0
#pragma once
// Rendering in tests, and comparing the results.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>

#include "glint/explain.h"
#include "trace/worlds.h"

namespace glint::test {

inline Image render_world(const World& world, const RenderOptions& options = {}) {
    Result<Rendering> result = render(world, options);
    EXPECT_EQ(result.message, "");
    EXPECT_TRUE(result.has_value());
    return result ? std::move(result->image) : Image{};
}
inline Image render_scene(const Scene& scene) {
    const std::optional<World> world = make_world(scene);
    return world ? render_world(*world) : Image{};
}

/// Random crops are the same pixels as in the whole picture, with every instruction set in turn and 1 to 3
/// threads.
inline void expect_same_crops(const World& world, int crops, std::uint32_t seed = 3) {
    const Image whole = render_world(world);
    const auto isas = isa_names();
    Random random(seed);
    for (int i = 0; i < crops; ++i) {
        RenderOptions options;
        Crop crop{1 + below(random, whole.width * 5 / 7), 1 + below(random, whole.height * 4 / 5), 0, 0};
        crop.x = below(random, whole.width - crop.width + 1);
        crop.y = below(random, whole.height - crop.height + 1);
        options.crop = crop;
        options.isa = isas[static_cast<std::size_t>(i) % isas.size()];
        options.threads = 1 + below(random, 3);
        const Image part = render_world(world, options);
        for (int y = 0; y < crop.height; ++y)
            for (int x = 0; x < crop.width; ++x)
                ASSERT_EQ(part.pixel(x, y), whole.pixel(crop.x + x, crop.y + y))
                    << options.isa << ", crop " << i << ", pixel " << x << ' ' << y;
    }
}

inline Color pixel(const Image& image, int x, int y) { return image.pixel(x, y); }

/// The distance of two floats in ulp; large if one is NaN.
inline std::int64_t floats_apart(float a, float b) {
    if (std::isnan(a) || std::isnan(b)) return 1 << 30;
    const auto order = [](float f) {
        const auto bits = static_cast<std::int64_t>(std::bit_cast<std::uint32_t>(f));
        return bits < 0x80000000 ? bits : 0x80000000 - bits;
    };
    const std::int64_t difference = order(a) - order(b);
    return difference < 0 ? -difference : difference;
}

/// The layers of a pixel in the order of summation, each rounded to float.
struct Layers {
    Color background{0, 0, 0}, ambient{0, 0, 0}, diffuse{0, 0, 0}, specular{0, 0, 0}, reflected{0, 0, 0};
    float channel(double Color::*c) const {
        float sum = static_cast<float>(background.*c);
        for (const Color& part : {ambient, diffuse, specular, reflected}) sum += static_cast<float>(part.*c);
        return sum;
    }
};

/// Every pixel is within `allowed` floats of expected(x, y).
inline void expect_picture(const Image& image, const std::function<Layers(int, int)>& expected,
                           int allowed = 1) {
    int wrong = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Layers layers = expected(x, y);
            const Color got = pixel(image, x, y);
            for (double Color::*c : {&Color::r, &Color::g, &Color::b}) {
                const float want = layers.channel(c), have = static_cast<float>(got.*c);
                if (floats_apart(want, have) <= allowed || ++wrong > 3) continue;
                ADD_FAILURE() << "pixel (" << x << ", " << y << "): expected " << want << ", got " << have;
            }
        }
    }
    EXPECT_EQ(wrong, 0) << "channels of " << 3 * image.width * image.height;
}

inline void expect_same_picture(const Image& a, const Image& b) {
    ASSERT_EQ(a.width, b.width);
    ASSERT_EQ(a.height, b.height);
    std::size_t wrong = 0, first = 0;
    for (std::size_t i = 0; i < a.rgb.size(); ++i) {
        if (std::bit_cast<std::uint32_t>(a.rgb[i]) == std::bit_cast<std::uint32_t>(b.rgb[i])) continue;
        if (wrong++ == 0) first = i;
    }
    EXPECT_EQ(wrong, 0u) << "of " << a.rgb.size() << " channels; first in pixel "
                         << first / 3 % static_cast<std::size_t>(a.width) << ", "
                         << first / 3 / static_cast<std::size_t>(a.width);
}

inline Light point_light(Vec3 position, Color color = {1, 1, 1}) {
    Light light;
    light.position = position;
    light.color = light.specular_color = color;
    return light;
}
inline Light directional_light(Vec3 to_light, Color color = {1, 1, 1}) {
    Light light = point_light({}, color);
    light.kind = LightKind::directional;
    light.to_light = to_light;
    return light;
}
inline Light ambient_light(Color color) {
    Light light;
    light.kind = LightKind::ambient;
    light.color = color;
    return light;
}

/// Of some pixels, in steps, the explanation's value is that of the picture. Calls check(explanation, x, y)
/// for each.
template <class Check>
void expect_explained_as_drawn(const Scene& scene, int step_x, int step_y, Check&& check) {
    const std::optional<World> world = make_world(scene);
    const Image whole = render_world(*world);
    for (int y = 0; y < whole.height; y += step_y) {
        for (int x = 0; x < whole.width; x += step_x) {
            const Explanation e = explain(scene, *world, x, y).value();
            ASSERT_EQ((Color{e.value[0], e.value[1], e.value[2]}), whole.pixel(x, y)) << x << ',' << y;
            check(e, x, y);
            if (testing::Test::HasFatalFailure()) return;
        }
    }
}

/// 48 x 36 pixels that look along -z at the origin, with ambient light alone and no shapes.
inline Scene ambient_view(Color background) {
    Scene scene;
    set_size(scene, 48, 36);
    scene.background = background;
    scene.camera.position = {0, 0, 12};
    scene.camera.look_at = {0, 0, 0};
    scene.lights = {ambient_light({1, 1, 1})};
    return scene;
}

}  // namespace glint::test
