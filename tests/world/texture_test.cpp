// SPDX-License-Identifier: Apache-2.0
// The colors of textures, to the bit, against docs/lighting.md.
#include <cmath>
#include <limits>

#include "formats/load_text.h"
#include "glint/explain.h"
#include "glint/write.h"
#include "math/srgb.h"
#include "scene/validate_texture.h"
#include "world/appearance/texture.h"
#include "world/same_pictures.h"

namespace glint::test {
namespace {

// 2 x 3 texels of one channel value each, whose red words are 0, 51, ... from the upper left.
Texture small_texture() {
    TextureImage image{2, 3, false, std::vector<std::uint8_t>{}};
    for (int i = 0; i < 6; ++i)
        for (const int word : {51 * i, 255 - 51 * i, 7})
            std::get<0>(image.words).push_back(static_cast<std::uint8_t>(word));
    Texture texture;
    texture.image = std::make_shared<const TextureImage>(std::move(image));
    texture.encoding = TextureEncoding::linear;
    texture.filter = TextureFilter::nearest;
    return texture;
}

PreparedTexture prepared(const Texture& texture) { return prepare_textures({&texture, 1}).front(); }

std::optional<TextureSample> sampled(const Texture& texture, double u, double v) {
    return sample_texture(prepared(texture), {u, v});
}

// The texel's number, from the upper left.
int texel(const Texture& texture, double u, double v) {
    const auto sample = sampled(texture, u, v);
    return sample ? static_cast<int>(std::lround(sample->color.r * 5)) : -1;
}

TEST(Textures, HaveTheirFirstRowAtTheTop) {
    const Texture t = small_texture();
    EXPECT_EQ(texel(t, 0.25, 0.9), 0);
    EXPECT_EQ(texel(t, 0.75, 0.9), 1);
    EXPECT_EQ(texel(t, 0.25, 0.5), 2);
    EXPECT_EQ(texel(t, 0.75, 0.1), 5);
}

TEST(Textures, AreBlackAndTransparentBesideAClippedPicture) {
    Texture t = small_texture();
    EXPECT_FALSE(t.has_alpha());
    t.wrap_u = TextureWrap::clip;
    EXPECT_TRUE(t.has_alpha());
    EXPECT_EQ(texel(t, 0.25, 1.9), 0);  // v is repeated
    for (const double u : {-0.01, 1.01}) {
        const auto sample = sampled(t, u, 0.5);
        ASSERT_TRUE(sample);
        EXPECT_EQ(sample->color, (Color{0, 0, 0}));
        EXPECT_EQ(sample->alpha, 0);
        EXPECT_EQ(sample->columns[0], -1);
    }
    EXPECT_EQ(sampled(t, 1, 0.5)->alpha, 1);
    t.wrap_v = TextureWrap::once;
    EXPECT_FALSE(sampled(t, 2, 2));
}

TEST(Textures, WrapInFourWays) {
    Texture t = small_texture();
    t.wrap_u = t.wrap_v = TextureWrap::repeat;
    EXPECT_EQ(texel(t, 1.25, 0.9), 0);
    EXPECT_EQ(texel(t, -0.25, 0.9), 1);
    EXPECT_EQ(texel(t, 0.25, -0.1), 0);
    EXPECT_EQ(texel(t, -7.75, 12.1), 4);
    t.wrap_u = t.wrap_v = TextureWrap::mirror;
    EXPECT_EQ(texel(t, 1.25, 0.9), 1);
    EXPECT_EQ(texel(t, -0.25, 0.9), 0);
    EXPECT_EQ(texel(t, 0.25, -0.1), 4);
    EXPECT_EQ(texel(t, 2.25, 2.9), 0);
    t.wrap_u = t.wrap_v = TextureWrap::clamp;
    EXPECT_EQ(texel(t, 9, 0.9), 1);
    EXPECT_EQ(texel(t, -9, -9), 4);
    t.wrap_u = t.wrap_v = TextureWrap::once;
    EXPECT_EQ(texel(t, 0.75, 0.9), 1);
    EXPECT_EQ(texel(t, 1.25, 0.9), -1);
    EXPECT_EQ(texel(t, 0.25, -0.1), -1);
    EXPECT_EQ(texel(t, 0, 0), 4);
    EXPECT_EQ(texel(t, 1, 1), 1);
}

TEST(Textures, TakeEveryNumber) {
    for (const TextureFilter filter :
         {TextureFilter::nearest, TextureFilter::bilinear, TextureFilter::distance}) {
        for (const TextureWrap wrap : {TextureWrap::repeat, TextureWrap::mirror, TextureWrap::clamp}) {
            Texture t = small_texture();
            t.filter = filter;
            t.wrap_u = t.wrap_v = wrap;
            const auto at_zero = sampled(t, 0, 0);
            constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = HUGE_VAL;
            for (const double wild : {nan, inf, -inf, 0x1p52, -0x1p52, 1e300}) {
                const auto s = sampled(t, wild, wild);
                ASSERT_TRUE(s);
                EXPECT_EQ(s->color, at_zero->color) << wild;
            }
            for (const double edge : {-0.0, -1e-300, -1e-20, 1 - 0x1p-53, 1.0, 2.0, -1.0, 4503599627370495.5,
                                      -4503599627370495.5, 0x1p31, -0x1p31, 0x1p32 + 0.75}) {
                const auto s = sampled(t, edge, edge);
                ASSERT_TRUE(s);
                for (const int i : {0, 1}) {
                    EXPECT_TRUE(s->columns[i] >= 0 && s->columns[i] < 2) << edge;
                    EXPECT_TRUE(s->rows[i] >= 0 && s->rows[i] < 3) << edge;
                }
                EXPECT_TRUE(s->right >= 0 && s->right <= 1 && s->lower >= 0 && s->lower <= 1) << edge;
            }
        }
    }
}

TEST(Textures, AreMixedInTheDocumentedOrder) {
    Texture t = small_texture();
    t.filter = TextureFilter::bilinear;
    const double u = 0.6, v = 0.45;
    const auto s = sampled(t, u, v);
    ASSERT_TRUE(s);
    const double x = u * 2 - 0.5, y = (1 - v) * 3 - 0.5, right = x - 0, lower = y - 1;
    EXPECT_EQ(s->right, right);
    EXPECT_EQ(s->lower, lower);
    const auto c = [](int i) { return 51 * i / 255.0; };
    const double top = c(2) + (c(3) - c(2)) * right, bottom = c(4) + (c(5) - c(4)) * right;
    EXPECT_EQ(s->color.r, top + (bottom - top) * lower);
    EXPECT_EQ(s->color.b, 7 / 255.0);  // the same in all texels
}

TEST(Textures, AreMixedByTheSquareOfTheDistance) {
    Texture t = small_texture();
    t.filter = TextureFilter::distance;
    for (double x = 0; x < 1; x += 0.0625)
        for (double y = 0; y < 1; y += 0.0625) {
            const auto s = sampled(t, (x + 0.5) / 2, 1 - (y + 1.5) / 3);
            ASSERT_TRUE(s);
            double sum = 0, weights = 0;
            for (int i = 0; i < 4; ++i) {
                const double dx = i % 2 - x, dy = i / 2 - y, d = std::max(dx * dx + dy * dy, 1e-18);
                sum += 51 * (2 + i) / 255.0 / d;
                weights += 1 / d;
            }
            EXPECT_NEAR(s->color.r, sum / weights, 1e-12) << x << " " << y;
            EXPECT_NEAR(s->right, x, 1e-12) << "where it is between the texels";
        }
    EXPECT_EQ(sampled(t, 0.25, 0.5)->color.r, 51 * 2 / 255.0) << "at the middle of a texel";
}

TEST(Textures, MixAcrossTheirBorders) {
    Texture t = small_texture();
    t.filter = TextureFilter::bilinear;
    const auto columns_at = [&](TextureWrap wrap, double u) {
        t.wrap_u = t.wrap_v = wrap;
        return sampled(t, u, 0.5)->columns;
    };
    using Columns = std::array<std::int32_t, 2>;
    EXPECT_EQ(columns_at(TextureWrap::repeat, 0.1), (Columns{1, 0}));
    EXPECT_EQ(columns_at(TextureWrap::repeat, 0.9), (Columns{1, 0}));
    EXPECT_EQ(columns_at(TextureWrap::mirror, 0.1), (Columns{0, 0}));
    EXPECT_EQ(columns_at(TextureWrap::clamp, 0.9), (Columns{1, 1}));
    EXPECT_EQ(columns_at(TextureWrap::once, 0.9), (Columns{1, 1}));
    EXPECT_EQ(columns_at(TextureWrap::clip, 0.9), (Columns{1, 1}));
}

TEST(Textures, OfOneTexelAreOneColor) {
    for (const auto& [width, height] : {std::pair{1u, 1u}, {1u, 7u}, {7u, 1u}}) {
        Texture t = small_texture();
        TextureImage image{width, height, false, std::vector<std::uint8_t>(3 * width * height, 100)};
        t.image = std::make_shared<const TextureImage>(std::move(image));
        for (const TextureFilter filter : {TextureFilter::bilinear, TextureFilter::distance}) {
            t.filter = filter;
            for (double at = -3; at < 3; at += 0.173)
                EXPECT_EQ(sampled(t, at, at * 1.7)->color.g, 100 / 255.0);
        }
    }
}

TEST(Textures, DecodeWordsOfEightAndSixteenBits) {
    Texture t = small_texture();
    t.encoding = TextureEncoding::srgb;
    for (const int word : {0, 1, 10, 11, 128, 255}) {
        TextureImage image{1, 1, true, std::vector<std::uint8_t>(4, static_cast<std::uint8_t>(word))};
        t.image = std::make_shared<const TextureImage>(std::move(image));
        const double e = word / 255.0;
        const auto s = sampled(t, 0.5, 0.5);
        EXPECT_EQ(s->color.r, srgb_decode(e));
        EXPECT_NEAR(s->color.r, e <= 0.04045 ? e / 12.92 : std::pow((e + 0.055) / 1.055, 2.4), 1e-15);
        EXPECT_EQ(s->alpha, e) << "alpha is linear";
    }
    TextureImage image{1, 1, false, std::vector<std::uint16_t>{65535, 32768, 1}};
    t.image = std::make_shared<const TextureImage>(std::move(image));
    EXPECT_EQ(sampled(t, 0, 0)->color, (Color{1, srgb_decode(32768 / 65535.0), srgb_decode(1 / 65535.0)}));
    EXPECT_EQ(sampled(t, 0, 0)->alpha, 1);
}

constexpr std::string_view k_scene =
    "camera { position = (0, 1, 5)  look_at = (0, 0.5, 0)  fov_x = 50 }\n"
    "light { type = ambient  intensity = 0.3 }\n"
    "light { position = (2, 4, 3) }\n"
    "render { size = 40 x 30 }\n";
constexpr std::string_view k_mesh =
    "mesh { vertices = ((-1, 0, 0), (1, 0, 0), (1, 1, 0), (-1, 1, 0))  triangles = ((0, 1, 2), (0, 2, 3))  "
    "texture_coordinates = ((0, 0), (1, 0), (1, 1), (0, 1))  ";

Scene scene_of(std::string_view rest) {
    return quiet_scene(std::string(k_scene) + std::string(rest), "a.glint");
}
Image picture_of(const Scene& scene) { return render(prepare(scene).value()).value().image; }
void expect_same_picture(const Scene& a, const Scene& b) {
    EXPECT_TRUE(same_bits(picture_of(a).rgb, picture_of(b).rgb));
}

TEST(Textures, OfOneColorAreThatColor) {
    const std::string mesh(k_mesh);
    const Scene plain = scene_of(mesh + "color = rgb255(51, 102, 204)  specular_color = (1, 1, 1) }");
    const std::string texture = "texture t { texels = (\"3366cc\")  encoding = linear ";
    expect_same_picture(plain, scene_of(texture + "}" + mesh +
                                        "color = (1, 1, 1)  specular_color = (1, 1, 1)  texture = t }"));
    // A highlight that is a multiple of the color changes with it, if it is replaced.
    const Scene tinted = scene_of(mesh + "color = rgb255(51, 102, 204)  specular = 0.5 }");
    expect_same_picture(tinted, scene_of(texture + " mix = replace }" + mesh +
                                         "color = (0.5, 0.25, 1)  specular = 0.5  texture = t }"));
}

TEST(Textures, LeaveSurfacesWithoutCoordinates) {
    const std::string texture = "texture t { texels = (\"3366cc\") }";
    const std::string ball = "sphere { center = (0, 0, 0)  radius = 1 ";
    expect_same_picture(scene_of(ball + "}"), scene_of(texture + ball + "texture = t }"));
    const std::string once =
        "texture t { texels = (\"3366cc\")  wrap_u = once  uv_map = ((1, 0, 2), (0, 1, 0)) }";
    expect_same_picture(scene_of(std::string(k_mesh) + "}"),
                        scene_of(once + std::string(k_mesh) + "texture = t }"));
}

// u = (x + 1) / 2 and v = y: the pattern of u and v is one of space.
TEST(Textures, MayBePatternsOfUAndV) {
    const std::string mesh = std::string(k_mesh) + "texture = t  color = (1, 1, 1) }",
                      colors = "  color_map = ((0, (1, 0, 0)), (1, (0, 0.25, 1)))  ";
    for (const std::string mapping : {"onion", "rings", "planar", "checker", "leopard"}) {
        const std::string text = "texture t { mapping = " + mapping + colors;
        const Image of_uv =
            picture_of(scene_of(text + "from_uv = true  scale = 0.3  rotate = (0, 0, 20) }" + mesh));
        const Image of_space =
            picture_of(scene_of(text +
                                "scale = 0.3  rotate = (0, 0, 20)  scale = (2, 1, 1)  translate = "
                                "(-1, 0, 0) }" +
                                mesh));
        double most = 0, least = 1, apart = 0;
        for (std::size_t i = 0; i < of_uv.rgb.size(); ++i) {
            most = std::max<double>(most, of_uv.rgb[i]);
            least = std::min<double>(least, of_uv.rgb[i]);
            apart = std::max<double>(apart, std::abs(of_uv.rgb[i] - of_space.rgb[i]));
        }
        EXPECT_GT(most - least, 0.3) << mapping;
        EXPECT_LT(apart, 1e-5) << mapping;
    }
    // Shapes without u and v have no texture.
    const std::string ball = "sphere { center = (0, 0, 0)  radius = 1  ",
                      onion = "texture t { mapping = onion  from_uv = true" + colors + "}";
    const Scene scene = scene_of(onion + ball + "texture = t }");
    expect_same_picture(scene_of(ball + "}"), scene);
    EXPECT_NE(write_glint(scene).value().find("from_uv = true"), std::string::npos);
}

TEST(Textures, OfUAndVArePatterns) {
    Texture texture;
    texture.from_uv = true;
    texture.color_map = {{0, {1, 0, 0}}};
    EXPECT_EQ(mistake_in(texture), "from_uv: expected a mapping other than uv, found uv");
    texture.mapping = TextureMapping::onion;
    EXPECT_EQ(mistake_in(texture), "");
    texture.color_map.clear();
    texture.image = small_texture().image;
    EXPECT_EQ(mistake_in(texture), "from_uv: expected a color_map, found an image");
}

TEST(Textures, AreWrittenAndReadBack) {
    const Scene scene = scene_of(
        "texture \"a b\" { texels = (\"00112233 ff8000ff\")  mapping = cylindrical  wrap_u = mirror  "
        "wrap_v = once  filter = nearest  mix = replace  encoding = srgb  "
        "uv_map = ((2, 0, 0.5), (0, -1, 1))  rotate = (30, 0, 0)  translate = (0, 0.1, 0) }\n"
        "texture deep { texels = (\"000100020003\", \"fffffffefffd\") }\n"
        "cylinder { from = (0, 0, 0)  to = (0, 1, 0)  radius = 0.5  texture = \"a b\" }\n" +
        std::string(k_mesh) + "texture = deep }\n");
    const std::string text = write_glint(scene).value();
    const Scene again = quiet_scene(text, "a.glint");
    ASSERT_EQ(again.textures.size(), 2u) << text;
    for (const int i : {0, 1}) {
        EXPECT_EQ(*again.textures[i].image, *scene.textures[i].image);
        Texture a = again.textures[i], b = scene.textures[i];
        a.image = b.image;
        EXPECT_EQ(a, b) << text;
    }
    EXPECT_EQ(write_glint(again).value(), text);
    expect_same_picture(scene, again);
}

TEST(Textures, AreExplained) {
    const Scene scene =
        scene_of("texture t { texels = (\"ff0000 00ff00\", \"0000ff ffffff\")  encoding = srgb }" +
                 std::string(k_mesh) + "color = (0.5, 1, 1)  texture = t }");
    const World world = prepare(scene).value();
    int textured = 0;
    for (const int x : {13, 16, 22, 26}) {
        const Explanation e = explain(scene, world, x, 15).value();
        ASSERT_TRUE(e.rays.front().hit);
        const ExplainedHit& hit = *e.rays.front().hit;
        if (!hit.texture) continue;
        ++textured;
        const ExplainedTexture& t = *hit.texture;
        EXPECT_EQ(t.texture, 0u);
        const auto channel = [&](int column, int row, int c) {
            const auto& words = std::get<0>(scene.textures[0].image->words);
            return srgb_decode(words[static_cast<std::size_t>(3 * (2 * row + column) + c)] / 255.0);
        };
        const double found[3] = {t.color.r, t.color.g, t.color.b};
        for (int c = 0; c < 3; ++c) {
            const auto in_row = [&](int row) {
                const double a = channel(t.column, row, c), b = channel(t.next_column, row, c);
                return a + (b - a) * t.next_column_weight;
            };
            EXPECT_EQ(found[c], in_row(t.row) + (in_row(t.next_row) - in_row(t.row)) * t.next_row_weight);
        }
        const Material m = material_of(hit, scene);
        EXPECT_EQ(m.diffuse, (scene.materials[0].diffuse * t.color));
        EXPECT_EQ(hit.ambient, (m.ambient * Color{0.3, 0.3, 0.3}));
    }
    EXPECT_GE(textured, 3);
}

TEST(Textures, OfLayersAreTheirSum) {
    const Scene scene = scene_of(
        "texture top { mapping = planar  color_map = ((0, (1, 0, 0), 0.25))  over = middle }\n"
        "texture middle { mapping = checker  color_map = ((0, (0, 1, 0), 0.5))  over = low }\n"
        "texture low { mapping = planar  color_map = ((0, (0, 0, 1)))  mix = replace }" +
        std::string(k_mesh) + "color = (0.5, 1, 1)  texture = top }");
    const World world = prepare(scene).value();
    const ExplainedHit hit = explain(scene, world, 16, 15).value().rays.front().hit.value();
    const ExplainedTexture& t = hit.texture.value();
    EXPECT_EQ(t.texture, scene.materials[0].texture);
    EXPECT_EQ(t.color, (Color{0.25, 0.375, 0.375}));
    EXPECT_EQ(t.alpha, 1);
    ASSERT_EQ(t.layers.size(), 3u);
    EXPECT_EQ(t.layers[0].texture, t.texture);
    const double weights[] = {0.25, 0.375, 0.375};
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(t.layers[i].weight, weights[i]);
    EXPECT_EQ(hit.ambient, (scene.materials[0].ambient * t.color * Color{0.3, 0.3, 0.3}));
}

// Without texture, the mesh of k_mesh and what is around it.
constexpr std::string_view k_around =
    "sphere { center = (0.3, 0.5, -2)  radius = 1  color = (0.2, 0.9, 0.4) }\n"
    "plane { point = (0, -1, 0)  normal = (0, 1, 0) }\n";

TEST(Textures, WithFullAlphaAreOpaque) {
    const std::string mesh = std::string(k_mesh) + "color = (1, 1, 1)  texture = t }", around(k_around);
    const Scene opaque = scene_of("texture t { texels = (\"3366cc\") }" + mesh + around);
    for (const char* alpha : {"blend", "mask", "ignore"}) {
        expect_same_picture(opaque, scene_of("texture t { texels = (\"3366ccff\")  alpha = " +
                                             std::string(alpha) + " }" + mesh + around));
    }
    expect_same_picture(opaque,
                        scene_of("texture t { texels = (\"3366cc00\")  alpha = ignore }" + mesh + around));
    expect_same_picture(opaque,
                        scene_of("texture t { texels = (\"3366cc80\")  alpha = mask }" + mesh + around));
}

TEST(Textures, WithoutAlphaAreHoles) {
    const std::string mesh = std::string(k_mesh) + "specular_color = (1, 1, 1)  texture = t }",
                      around(k_around);
    const Scene without = scene_of(around);
    expect_same_picture(without,
                        scene_of("texture t { texels = (\"3366cc7f\")  alpha = mask }" + mesh + around));
    expect_same_picture(without, scene_of("texture t { texels = (\"3366cc80\")  alpha = mask  "
                                          "alpha_cutoff = 0.51 }" +
                                          mesh + around));
}

TEST(Textures, BlendByTheirAlpha) {
    const std::string mesh(k_mesh), around(k_around);
    // 51 / 255 = 0.2 is left of the opacity, so 0.8 is transmitted.
    const Scene transmits = scene_of(mesh + "color = (1, 1, 1)  transmit = 0.8 }" + around);
    const Scene blends = scene_of("texture t { texels = (\"ffffff33\") }" + mesh +
                                  "color = (1, 1, 1)  texture = t }" + around);
    expect_same_picture(transmits, blends);
    const Scene both = scene_of("texture t { texels = (\"ffffff33\") }" + mesh +
                                "color = (1, 1, 1)  filter = 0.5  texture = t }" + around);
    expect_same_picture(scene_of(mesh + "color = (1, 1, 1)  filter = 0.1  transmit = 0.8 }" + around), both);
}

TEST(Textures, MasksAreSeenAndCastShadowsThroughAHundredLayers) {
    // A column of texels is there, the other one is not: in the shadow of the layers, too.
    std::string layers;
    for (int i = 0; i < 100; ++i)
        layers +=
            "mesh { vertices = ((-1, 0, 0), (1, 0, 0), (1, 2, 0), (-1, 2, 0))  triangles = ((0, 1, 2), "
            "(0, 2, 3))  texture_coordinates = ((0, 0), (1, 0), (1, 1), (0, 1))  texture = t  "
            "translate = (0, 0, " +
            std::to_string(-0.01 * i) + ") }\n";
    const std::string ground = "plane { point = (0, 0, -4)  normal = (0, 0, 1)  color = (1, 1, 1) }\n";
    const Scene scene = scene_of(
        "texture t { texels = (\"ff000000 ff0000ff\")  filter = nearest  alpha = mask }\n" + layers + ground);
    const Image image = picture_of(scene);
    const Image empty = picture_of(scene_of(ground));
    std::size_t through = 0, red = 0, same = 0;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
        const bool is_red = image.rgb[i] > 0 && image.rgb[i + 1] == 0;
        red += is_red;
        same += image.rgb[i] == empty.rgb[i] && image.rgb[i + 1] == empty.rgb[i + 1];
        through += !is_red;
    }
    EXPECT_GT(red, 50u);
    EXPECT_GT(same, through / 2) << "the ground is seen where the layers have their holes";
    EXPECT_LT(same, through) << "and it has their shadow";
}

TEST(Textures, AreCheckedInWorlds) {
    const Scene scene = scene_of("sphere { center = (0, 0, 0)  radius = 1  color = (1, 0, 0) }");
    const World world = prepare(scene).value();
    Material material;
    material.texture = 0;
    EXPECT_EQ(with_material(world, 0, material).code, ErrorCode::invalid_argument);
    EXPECT_EQ(with_materials(world, std::vector<Material>{material}).code, ErrorCode::invalid_argument);
    Scene wrong = scene;
    wrong.materials[0].texture = 3;
    EXPECT_EQ(prepare(wrong).code, ErrorCode::invalid_scene);
    wrong.materials[0].texture = 0;
    wrong.textures.emplace_back();
    EXPECT_EQ(prepare(wrong).code, ErrorCode::invalid_scene);
    wrong.textures[0] = small_texture();
    EXPECT_TRUE(prepare(wrong));
    auto image = std::make_shared<TextureImage>(*wrong.textures[0].image);
    std::get<0>(image->words).pop_back();
    wrong.textures[0].image = image;
    EXPECT_EQ(prepare(wrong).code, ErrorCode::invalid_scene);
}

}  // namespace
}  // namespace glint::test
