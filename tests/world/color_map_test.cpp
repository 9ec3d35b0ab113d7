// SPDX-License-Identifier: Apache-2.0
// Maps of colors and patterns (Texture::color_map), to the bit, against docs/lighting.md.
#include <cmath>
#include <complex>

#include "formats/load_text.h"
#include "glint/explain.h"
#include "glint/write.h"
#include "math/elementary.h"
#include "math/srgb.h"
#include "scene/validate_texture.h"
#include "world/appearance/texture.h"
#include "world/same_pictures.h"

namespace glint::test {
namespace {

Texture color_texture(std::vector<TextureColor> colors, TextureFilter filter = TextureFilter::bilinear) {
    Texture texture;
    texture.color_map = std::move(colors);
    texture.filter = filter;
    texture.wrap_u = TextureWrap::clamp;
    return texture;
}

Texture with_mapping(TextureMapping mapping) {
    Texture texture;
    texture.mapping = mapping;
    return texture;
}

TextureSample color_at(const Texture& texture, double u) {
    return sample_texture(prepare_textures({&texture, 1}).front(), {u, 0.3}).value();
}

const std::vector<TextureColor> k_map_colors{
    {0.25, {0.1, 0.2, 0.3}}, {0.5, {0.9, 0.7, 0.1}, 0.5}, {0.5, {0, 1, 0}}, {1, {0.3, 0.3, 0.3}, 0}};

TEST(ColorMaps, MixTheColorsBesideU) {
    const Texture t = color_texture(k_map_colors);
    const TextureSample s = color_at(t, 0.3);
    const double second = (0.3 - 0.25) / (0.5 - 0.25);
    EXPECT_EQ(s.color,
              (Color{0.1 + (0.9 - 0.1) * second, 0.2 + (0.7 - 0.2) * second, 0.3 + (0.1 - 0.3) * second}));
    EXPECT_EQ(s.alpha, 1 + (0.5 - 1) * second);
    EXPECT_EQ(s.columns, (std::array<std::int32_t, 2>{0, 1}));
    EXPECT_EQ(s.right, second);
}

TEST(ColorMaps, HaveTheEndsOfTheMapBeyondIt) {
    const Texture t = color_texture(k_map_colors);
    EXPECT_EQ(color_at(t, 0.1).color, k_map_colors[0].color);
    EXPECT_EQ(color_at(t, 0.25).color, k_map_colors[0].color);
    EXPECT_EQ(color_at(t, 7).color, k_map_colors[3].color);
    EXPECT_EQ(color_at(t, 7).columns[1], 3);
}

TEST(ColorMaps, StepWhereTwoColorsHaveOnePlace) {
    const Texture t = color_texture(k_map_colors);
    EXPECT_EQ(color_at(t, 0.5).color, k_map_colors[2].color);
    EXPECT_NEAR(color_at(t, std::nextafter(0.5, 0)).color.r, 0.9, 1e-12);
}

TEST(ColorMaps, NearestIsTheColorBefore) {
    const Texture t = color_texture(k_map_colors, TextureFilter::nearest);
    EXPECT_EQ(color_at(t, 0.49).color, k_map_colors[0].color);
    EXPECT_EQ(color_at(t, 0.5).color, k_map_colors[2].color);
    EXPECT_EQ(color_at(t, 0.99).color, k_map_colors[2].color);
    EXPECT_EQ(color_at(t, 0.99).columns[1], 2);
}

TEST(ColorMaps, AreDecodedBeforeTheyAreMixed) {
    Texture t = color_texture({{0, {0.5, 0, 1}}, {1, {0, 0.5, 0}}});
    t.encoding = TextureEncoding::srgb;
    EXPECT_EQ(color_at(t, 0).color.r, srgb_decode(0.5));
    EXPECT_EQ(color_at(t, 0.5).color.g, srgb_decode(0.5) * 0.5);
}

TEST(ColorMaps, WrapUAsPicturesDo) {
    Texture t = color_texture({{0, {0, 0, 0}}, {1, {1, 1, 1}}});
    t.wrap_u = TextureWrap::repeat;
    EXPECT_EQ(color_at(t, -0.25).color.r, 0.75);
    t.wrap_u = TextureWrap::mirror;
    EXPECT_EQ(color_at(t, 1.25).color.r, 0.75);
    t.wrap_u = TextureWrap::clip;
    EXPECT_TRUE(t.has_alpha());
    EXPECT_EQ(color_at(t, 1.25).alpha, 0);
}

TEST(Patterns, HaveTheirNumberAtAPoint) {
    const Vec3 p{1.25, -2.5, 3.75};
    EXPECT_EQ(place_on(with_mapping(TextureMapping::onion), p).u,
              std::sqrt(1.25 * 1.25 + 2.5 * 2.5 + 3.75 * 3.75));
    EXPECT_EQ(place_on(with_mapping(TextureMapping::rings), p).u, std::sqrt(1.25 * 1.25 + 3.75 * 3.75));
    EXPECT_EQ(place_on(with_mapping(TextureMapping::boxes), p).u, 3.75);
    EXPECT_EQ(place_on(with_mapping(TextureMapping::boxes), {1, -2.5, 2}).u, 2.5);
    EXPECT_EQ(place_on(with_mapping(TextureMapping::slabs), {-1.25, 5, 5}).u, 1.25);
    const double mean = (sin(1.25) + sin(-2.5) + sin(3.75)) / 3;
    EXPECT_EQ(place_on(with_mapping(TextureMapping::leopard), p).u, mean * mean);
}

TEST(Patterns, BricksAreInMortar) {
    Texture bricks = with_mapping(TextureMapping::bricks);
    bricks.mortar = {0.1, 0.2, 0.3};
    const auto u = [&](double x, double y, double z) { return place_on(bricks, {x, y, z}).u; };
    for (const double shift : {-4.0, 0.0, 2.0}) {
        // An even layer, and an odd one.
        EXPECT_EQ(u(shift + 0.89, shift + 0.79, shift + 0.19), 0.5);
        EXPECT_EQ(u(shift + 0.91, shift + 0.79, shift + 0.19), 0);
        EXPECT_EQ(u(shift + 0.89, shift + 0.81, shift + 0.19), 0);
        EXPECT_EQ(u(shift + 0.89, shift + 0.79, shift + 0.21), 0);
        EXPECT_EQ(u(shift + 0.89, shift + 0.79, shift + 0.51), 0.5);
        EXPECT_EQ(u(shift + 0.39, shift + 1.79, shift + 0.69), 0.5);
        EXPECT_EQ(u(shift + 0.41, shift + 1.79, shift + 0.69), 0);
        EXPECT_EQ(u(shift + 0.39, shift + 1.79, shift + 0.71), 0);
    }
}

TEST(Patterns, HexagonsDifferFromTheirNeighbours) {
    const double height = std::sqrt(3);
    const auto u = [](double x, double z) {
        return place_on(with_mapping(TextureMapping::hexagons), {x, 5, z}).u;
    };
    for (int i = -4; i <= 4; ++i) {
        for (int j = -4; j <= 4; ++j) {
            const double x = 1.5 * i, z = height * (j + i * 0.5), expected = ((j + 2 * i) % 3 + 3) % 3 / 4.0;
            // Just within its corners and sides; just beyond a side is another one.
            for (int k = 0; k < 6; ++k) {
                const double corner = k * M_PI / 3, side = corner + M_PI / 6;
                EXPECT_EQ(u(x + 0.99 * std::cos(corner), z + 0.99 * std::sin(corner)), expected);
                EXPECT_EQ(u(x + 0.86 * std::cos(side), z + 0.86 * std::sin(side)), expected);
                EXPECT_NE(u(x + 0.87 * std::cos(side), z + 0.87 * std::sin(side)), expected);
            }
        }
    }
}

TEST(Patterns, SpiralsHaveTheAngleAsV) {
    const Texture spiral = with_mapping(TextureMapping::spiral);
    const Vec3 p{3, 0.25, -4};
    EXPECT_EQ(place_on(spiral, p).u, 5.25);
    EXPECT_EQ(place_on(spiral, p).v, place_on(with_mapping(TextureMapping::cylindrical), p).u);
    EXPECT_EQ(place_on(spiral, {0, -2, 0}).u, -2);
}

TEST(Patterns, MandelbrotsSetCountsSteps) {
    Texture set = with_mapping(TextureMapping::mandelbrot);
    const auto u = [&](double x, double y, double iterations) {
        set.iterations = iterations;
        const TexturePlace place = place_on(set, {x, y, 7});
        EXPECT_EQ(place.v, 0);
        return place.u;
    };
    const auto steps = [](std::complex<double> c, int most) {
        std::complex<double> z = c;
        for (int n = 0; n < most; ++n) {
            z = {z.real() * z.real() - z.imag() * z.imag() + c.real(), 2 * z.real() * z.imag() + c.imag()};
            if (std::norm(z) > 4) return n;
        }
        return most;
    };
    bool seen[41] = {};
    for (int i = 0; i < 60; ++i)
        for (int j = 0; j < 30; ++j) {
            const double x = -2.3 + 0.05 * i, y = 0.05 * j;
            const int n = steps({x, y}, 40);
            seen[n] = true;
            EXPECT_EQ(u(x, y, 40.9), n / 40.0) << x << " " << y;
        }
    EXPECT_TRUE(seen[0] && seen[1] && seen[12] && seen[40]);
    EXPECT_EQ(u(-2, 0, 100), 1) << "at the end of the set";
    EXPECT_EQ(u(0.3, 0.5, 1e6), 1);
    EXPECT_EQ(u(0.26, 0, 1), 1);
    EXPECT_EQ(u(1e300, -1e300, 100), 0);
    EXPECT_EQ(u(std::nan(""), 0, 100), 0);
}

TEST(Patterns, CheckersAlternate) {
    for (int x = -3; x < 3; ++x)
        for (int y = -3; y < 3; ++y)
            for (int z = -3; z < 3; ++z)
                EXPECT_EQ(place_on(with_mapping(TextureMapping::checker), {x + 0.5, y + 0.01, z + 0.99}).u,
                          (x + y + z) % 2 == 0 ? 0 : 0.5);
}

TEST(Patterns, ASurfaceOnABorderOfACheckerHasOneColor) {
    for (const double y : {2.0, std::nextafter(2.0, 0), 2 - 0x1p-40, 2 + 0x1p-40})
        EXPECT_EQ(place_on(with_mapping(TextureMapping::checker), {0.5, y, 0.5}).u, 0) << y;
    EXPECT_EQ(place_on(with_mapping(TextureMapping::checker), {0.5, 2 - 1e-9, 0.5}).u, 0.5);
}

constexpr std::string_view k_color_scene = R"(camera { position = (0, 2, 5)  look_at = (0, 0, 0) }
light { position = (3, 9, 5) }
texture board { color_map = ((0, (1, 1, 1)), (0.5, (0, 0, 0)))  mapping = checker  filter = nearest }
texture bands { color_map = ((0, "#ff0000"), (0.25, (0, 0, 1), 0.5), (1, (1, 1, 1)))  mapping = onion
                uv_map = ((2, 0, 0.5), (0, 1, 0))  translate = (0, 1, 0) }
plane { point = (0, 0, 0)  normal = (0, 1, 0)  color = (0.8, 0.7, 0.6)  texture = board }
sphere { center = (0, 1, 0)  radius = 1  color = (1, 1, 1)  texture = bands }
)";

TEST(ColorMaps, AreReadAndWritten) {
    const Scene scene = quiet_scene(k_color_scene, "a.glint");
    ASSERT_EQ(scene.textures.size(), 2u);
    const std::vector<TextureColor>& bands = scene.textures[1].color_map;
    EXPECT_EQ(bands, (std::vector<TextureColor>{{0, {1, 0, 0}}, {0.25, {0, 0, 1}, 0.5}, {1, {1, 1, 1}}}));
    const Scene again = quiet_scene(write_glint(scene).value(), "b.glint");
    EXPECT_EQ(again.textures, scene.textures);
    const Scene wall = quiet_scene(std::string(k_color_scene) +
                                       "texture wall { color_map = ((0, (1, 1, 1)), (0.5, (1, 0, 0)))  "
                                       "mapping = bricks  filter = nearest  mortar = (0.05, 0.2, 0.1) }\n",
                                   "a.glint");
    EXPECT_EQ(wall.textures.back().mortar, (Vec3{0.05, 0.2, 0.1}));
    EXPECT_EQ(quiet_scene(write_glint(wall).value(), "b.glint").textures, wall.textures);
    const Scene set = quiet_scene(std::string(k_color_scene) +
                                      "texture set { color_map = ((0, (1, 1, 1)), (1, (1, 0, 0)))  "
                                      "mapping = mandelbrot  iterations = 250 }\n",
                                  "a.glint");
    EXPECT_EQ(set.textures.back().iterations, 250);
    EXPECT_EQ(quiet_scene(write_glint(set).value(), "b.glint").textures, set.textures);
}

TEST(ColorMaps, ThePixelIsTheSumOfItsTerms) {
    Scene scene = quiet_scene(k_color_scene, "a.glint");
    scene.settings.width = 48, scene.settings.height = 36;
    const World world = prepare(scene).value();
    const Rendering picture = render(world).value();
    bool seen[2] = {};
    for (int i = 0; i < 48 * 36; i += 7) {
        const Explanation e = explain(scene, world, i % 48, i / 48).value();
        const float* const rgb = picture.image.rgb.data() + 3 * i;
        for (int c = 0; c < 3; ++c) EXPECT_EQ(e.value[c], rgb[c]);
        if (e.rays[0].hit && e.rays[0].hit->texture) seen[e.rays[0].hit->texture->texture] = true;
    }
    EXPECT_TRUE(seen[0] && seen[1]);
}

TEST(ColorMaps, Mistakes) {
    const auto mistake = [](std::vector<TextureColor> colors) {
        return mistake_in(color_texture(std::move(colors)));
    };
    EXPECT_EQ(mistake(k_map_colors), "");
    EXPECT_EQ(mistake({}), "expected an image or a color_map, found neither");
    EXPECT_EQ(mistake({{0.5, {}}, {0.4, {}}}),
              "color_map: expected places in ascending order, found 0.4 after 0.5");
    EXPECT_EQ(mistake({{1.5, {}}}),
              "color_map: the place of color 1: expected a number from 0 to 1, found 1.5");
    EXPECT_EQ(mistake({{0, {}, -1}}),
              "color_map: the alpha of color 1: expected a number from 0 to 1, found -1");
    EXPECT_EQ(mistake({{0, {}}, {1, {0, 2e6, 0}}}),
              "color_map: color 2: expected a number from -1e6 to 1e6, found 2000000");
    EXPECT_EQ(mistake(std::vector<TextureColor>(257)), "color_map: expected at most 256 colors, found 257");
    Texture both = color_texture(k_map_colors);
    both.image = std::make_shared<const TextureImage>();
    EXPECT_EQ(mistake_in(both), "expected an image or a color_map, found both");
}

TEST(ColorMaps, OfTheBackground) {
    const std::string text = R"(camera { position = (0, 0, 0)  look_at = (0, 0, -1)  fov_x = 90 }
background_gradient { bottom = -0.5  top = 0.5  color_map = ((0, (1, 0, 0)), (0.5, (0, 1, 0)), (0.5, (0, 0, 1)), (1, (1, 1, 1))) }
sphere { center = (0, 0, 9)  radius = 1 }
light { type = ambient }
)";
    Scene scene = quiet_scene(text, "a.glint");
    EXPECT_EQ(quiet_scene(write_glint(scene).value(), "b.glint").gradient, scene.gradient);
    scene.settings.width = scene.settings.height = 16;
    const World world = prepare(scene).value();
    const Image image = render(world).value().image;
    for (int y = 0; y < 16; ++y) {
        const Explanation e = explain(scene, world, 5, y).value();
        const Vec3 d = e.rays[0].direction;
        const double v = std::min(std::max(d.y / length(d) + 0.5, 0.0), 1.0);
        const float* const rgb = image.rgb.data() + 3 * (16 * y + 5);
        const Color expected = v < 0.5 ? Color{1 - 2 * v, 2 * v, 0} : Color{2 * v - 1, 2 * v - 1, 1};
        EXPECT_NEAR(rgb[0], expected.r, 1e-6);
        EXPECT_NEAR(rgb[1], expected.g, 1e-6);
        EXPECT_NEAR(rgb[2], expected.b, 1e-6);
        for (int c = 0; c < 3; ++c) EXPECT_EQ(e.value[c], rgb[c]);
    }
    scene.gradient->color_map[1].alpha = 0.5;
    EXPECT_FALSE(prepare(scene));
}

}  // namespace
}  // namespace glint::test
